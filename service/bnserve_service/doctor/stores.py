"""Whether the model stores can be read, and what is in them can be used."""

from __future__ import annotations

from bnserve_protocol import ArtifactError, BnserveError, ModelUnknown
from bnserve_service.doctor.findings import Findings, fault, ok
from bnserve_service.models.loading import loader_of
from bnserve_service.models.registry import Registry
from bnserve_service.settings import Settings
from bnserve_store import SHIPPED_MODELS, ModelStore


def stores(settings: Settings) -> Findings:
    """Each store, each version in it with its stored answer, each label, and the models that are to be served."""
    readable = []
    for root in ModelStore.default(settings.stores).roots:
        try:
            names = ModelStore([root]).names()
        except (BnserveError, OSError) as error:
            yield fault("store", getattr(error, "detail", str(error)), "correct --store, or the setting stores")
            continue
        readable.append(root)
        where = "that comes with bnserve" if root == str(SHIPPED_MODELS) else root
        yield ok("store", f"{where}: {len(names)} model{'s' if len(names) != 1 else ''}")
    store = ModelStore(readable)
    for name in store.names():
        yield from _model(store, name)
    try:
        loader_of(settings, Registry()).list_source()
    except ModelUnknown as error:
        yield fault("models", error.detail, "correct the setting models, or --model")


def _model(store: ModelStore, name: str) -> Findings:
    damaged = False
    for version in store.versions(name):
        reason = what_is_wrong(store, name, version)
        if reason is not None:
            damaged = True
            yield fault(f"model {name}", f"{version}: {reason}", "remove this version, or publish it again")
    labels = store.labels(name)
    for label in labels:
        try:
            store.resolve(name, label)
        except ModelUnknown as error:
            damaged = True
            yield fault(f"model {name}", error.detail)
    if not damaged:
        shown = ", ".join(f"{label} is {version}" for label, version in labels.items()) or "no labels"
        yield ok(f"model {name}", f"intact, gives the answers stored with it; {shown}")


def what_is_wrong(store: ModelStore, name: str, version: str) -> str | None:
    """Why a version must not be used, or None."""
    from bnserve_surrogate import Model

    try:
        model = Model.from_artifact(store.load(name, version))
    except ArtifactError as error:
        return error.detail
    return None if model.self_check() else "does not reproduce the answer stored with it; do not use it"
