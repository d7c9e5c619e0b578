"""``bnserve models``: look into model stores, check them, publish and label versions."""

from __future__ import annotations

import argparse
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bnserve_service.cli.places import name_and_version, print_json

if TYPE_CHECKING:
    from bnserve_store import Manifest, ModelStore

ABOUT = "Look into model stores, check them, publish and label versions."


def add_parser(subparsers: Any) -> None:
    """Add the subcommand and its actions."""
    parser = subparsers.add_parser("models", help="list, show, verify, publish and label models", description=ABOUT)
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    _action(actions, "list", list_models, "all models, versions and labels")
    show = _action(actions, "show", show_model, "the manifest of one version, as JSON")
    _add_model(show)
    _action(
        actions, "manifest", show_run, "what a paper's appendix needs: model, programs, processor, as JSON"
    ).add_argument("model", nargs="?", default="default", metavar="NAME[@VERSION]", help="a version or label (default)")
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
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=run)
    return parser


def _add_model(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("model", metavar="NAME[@VERSION]", help="a version or label; by default stable")


def _open(options: argparse.Namespace) -> ModelStore:
    from bnserve_store import ModelStore

    return ModelStore.default(options.store or ())


def _labels_of(store: ModelStore, name: str) -> dict[str, list[str]]:
    """By version, the labels that stand for it."""
    labels: dict[str, list[str]] = {}
    for label, version in store.labels(name).items():
        labels.setdefault(version, []).append(label)
    return labels


def list_models(options: argparse.Namespace) -> int:
    """Print one line per version."""
    store = _open(options)
    found = [
        {"name": name, "version": version, "labels": labels.get(version, [])}
        for name in store.names()
        for labels in [_labels_of(store, name)]
        for version in store.versions(name)
    ]
    if options.json:
        print_json(found)
    elif not found:
        print("No models. Name a store with --store, or publish a model there.")
    else:
        for each in found:
            print(_named(each["name"], each["version"], each["labels"]))
    return 0


def _named(name: Any, version: Any, labels: Any) -> str:
    return f"{name} {version}" + (f" ({', '.join(labels)})" if labels else "")


def show_model(options: argparse.Namespace) -> int:
    """Print a manifest."""
    import msgspec

    manifest = _open(options).manifest(*name_and_version(options.model))
    print_json({"digest": manifest.digest} | msgspec.to_builtins(manifest))
    return 0


def show_run(options: argparse.Namespace) -> int:
    """Print the manifest of a run with a model."""
    import msgspec

    from bnserve_surrogate import Model

    name, version = name_and_version(options.model)
    print_json(msgspec.to_builtins(Model.load(name, version, store=_open(options)).manifest()))
    return 0


def verify_models(options: argparse.Namespace) -> int:
    """Check versions; exit code 1 when one must not be used."""
    from bnserve_service.doctor.stores import what_is_wrong

    store = _open(options)
    chosen = [(name, store.resolve(name, version)) for name, version in map(name_and_version, options.model)] or [
        (name, version) for name in store.names() for version in store.versions(name)
    ]
    found = []
    for name, version in chosen:
        reason = what_is_wrong(store, name, version)
        labels = _labels_of(store, name).get(version, [])
        found.append({"name": name, "version": version, "labels": labels, "fine": reason is None, "reason": reason})
        if not options.json:
            print(f"{_named(name, version, labels)}: {reason or FINE}")
    if options.json:
        print_json(found)
    elif not chosen:
        print("Nothing to verify: the stores hold no models.")
    return 0 if all(each["fine"] for each in found) else 1


FINE = "fine (digest and shapes are right, and it gives the answer stored with it)"


def publish_model(options: argparse.Namespace) -> int:
    """Copy a version between stores, verified on the way."""
    from bnserve_protocol import InvalidRequest
    from bnserve_store import ModelStore

    if not options.store:
        raise InvalidRequest("Say where to publish to with --store DIR.")
    artifact = ModelStore([options.origin]).load(*name_and_version(options.model))
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
    if options.json:
        known = {"name": published.name, "version": published.version, "digest": published.digest}
        print_json(known | {"labels": [*labels], "store": str(options.store[0])})
    else:
        print(
            f"Published {published.name} {published.version} ({published.digest}) to {options.store[0]}, "
            + (f"where {' and '.join(labels)} stands for it now" if labels else "without a label")
        )
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
    from bnserve_protocol import InvalidRequest

    if not options.store:
        raise InvalidRequest("Say in which store to write the label with --store DIR; the shipped models keep theirs.")
    name, version = name_and_version(options.model)
    store = _open(options)
    before = store.labels(name).get(options.label)
    store.set_label(name, options.label, version)
    now = store.labels(name)[options.label]
    if options.json:
        print_json({"name": name, "label": options.label, "version": now, "before": before})
    else:
        was = "it is new" if before is None else "as before" if before == now else f"before, it was {before}"
        print(f"{name}: {options.label} is version {now} now ({was}), in {store.roots[0]}")
    return 0
