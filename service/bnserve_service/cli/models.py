"""``bnserve models``: look into model stores, check them, publish and label versions."""

from __future__ import annotations

import argparse
import json
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from bnserve_store import Manifest, ModelStore


def add_parser(subparsers: Any) -> None:
    """Add the subcommand and its actions."""
    parser = subparsers.add_parser("models", help="list, show, verify, publish and label models", description=__doc__)
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    _action(actions, "list", list_models, "all models, versions and labels")
    show = _action(actions, "show", show_model, "the manifest of one version, as JSON")
    _add_model(show)
    verify = _action(actions, "verify", verify_models, "check digests, shapes and values, and the stored example")
    verify.add_argument("model", nargs="*", metavar="NAME[@VERSION]", help="by default everything")
    publish = _action(actions, "publish", publish_model, "copy a version from another store into this one")
    _add_model(publish)
    publish.add_argument(
        "--from", dest="origin", type=Path, required=True, metavar="DIR", help="the store to copy from"
    )
    publish.add_argument("--label", action="append", metavar="LABEL", help="labels to set (stable)")
    publish.add_argument("--no-label", action="store_true", help="publish without a label, to try it first")
    label = _action(actions, "label", label_model, "point a label to a version")
    _add_model(label)
    label.add_argument("label", metavar="LABEL")


def _action(actions: Any, name: str, run: Any, text: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = actions.add_parser(name, help=text, description=text)
    parser.add_argument(
        "--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models"
    )
    parser.set_defaults(run=run)
    return parser


def _add_model(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("model", metavar="NAME[@VERSION]", help="a version or label; by default stable")


def _open(options: argparse.Namespace) -> ModelStore:
    from bnserve_store import ModelStore

    return ModelStore.default(options.store or ())


def _split(model: str) -> tuple[str, str]:
    name, _, version = model.partition("@")
    return name, version or "stable"


def list_models(options: argparse.Namespace) -> int:
    """Print one line per version."""
    store = _open(options)
    names = store.names()
    if not names:
        print("No models. Name a store with --store, or publish a model there.")
    for name in names:
        labels: dict[str, list[str]] = {}
        for label, version in store.labels(name).items():
            labels.setdefault(version, []).append(label)
        for version in store.versions(name):
            print(f"{name} {version}" + (f" ({', '.join(labels[version])})" if version in labels else ""))
    return 0


def show_model(options: argparse.Namespace) -> int:
    """Print a manifest."""
    import msgspec

    manifest = _open(options).manifest(*_split(options.model))
    document = {"digest": manifest.digest} | msgspec.to_builtins(manifest)
    json.dump(document, sys.stdout, indent=2, ensure_ascii=False)
    print()
    return 0


def verify_models(options: argparse.Namespace) -> int:
    """Check versions; exit code 1 when one must not be used."""
    store = _open(options)
    chosen = [_split(model) for model in options.model] or [
        (name, version) for name in store.names() for version in store.versions(name)
    ]
    failures = 0
    for name, version in chosen:
        reason = _what_is_wrong(store, name, version)
        print(f"{name} {version}: {reason or 'fine'}")
        failures += reason is not None
    return 1 if failures else 0


def _what_is_wrong(store: ModelStore, name: str, version: str) -> str | None:
    from bnserve_protocol import ArtifactError
    from bnserve_surrogate import Model

    try:
        model = Model.from_artifact(store.load(name, version))
    except ArtifactError as error:
        return error.detail
    return None if model.self_check() else "does not reproduce the answer stored with it; do not use it"


def publish_model(options: argparse.Namespace) -> int:
    """Copy a version between stores, verified on the way."""
    from bnserve_protocol import InvalidRequest
    from bnserve_store import ModelStore

    if not options.store:
        raise InvalidRequest("Say where to publish to with --store DIR.")
    artifact = ModelStore([options.origin]).load(*_split(options.model))
    manifest = artifact.manifest
    labels = () if options.no_label else tuple(options.label or ("stable",))
    target = ModelStore([options.store[0]])
    published = target.publish(
        manifest.name,
        manifest.version,
        artifact.tensors,
        manifest.metadata,
        labels=labels,
        created=manifest.created,  # so that the copy has the same digest
    )
    _copy_report(options.origin, options.store[0], published)
    print(f"Published {published.name} {published.version} ({published.digest})")
    return 0


def _copy_report(origin: Path, target: Path, manifest: Manifest) -> None:
    """Take along the page that ``bnserve train`` has left beside the manifest."""
    version = Path(manifest.name) / manifest.version
    for page in (origin / version).glob("report.html"):
        try:
            shutil.copyfile(page, target / version / page.name)
        except OSError as error:
            print(f"Its report was not copied: {error.strerror}.", file=sys.stderr)


def label_model(options: argparse.Namespace) -> int:
    """Set a label."""
    name, version = _split(options.model)
    store = _open(options)
    store.set_label(name, options.label, version)
    print(f"{name}: {options.label} is now {store.resolve(name, options.label)}")
    return 0
