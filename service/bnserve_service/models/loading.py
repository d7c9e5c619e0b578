"""Load new, swap, drop old: how the registry follows the stores."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

from bnserve_protocol import ArtifactCorrupted, BnserveError, ModelIdentity, ModelUnknown
from bnserve_service.models.registry import Catalogue, LoadedModel, ModelFactory, ModelSource, Registry
from bnserve_service.settings import Settings

logger = logging.getLogger("bnserve.models")

RETRY_SECONDS = 30.0
"""A version that was refused is looked at again after this long, or when its manifest changes."""


@dataclass(frozen=True, slots=True)
class Selection:
    """Which models are served: ``name`` or ``name@version``; nothing selects everything."""

    entries: tuple[str, ...] = ()

    def names(self, available: Sequence[str]) -> list[str]:
        """The selected names; those that are not available stay in, so that their absence is reported."""
        chosen = list(dict.fromkeys(entry.partition("@")[0] for entry in self.entries))
        return chosen or list(available)

    def versions(self, name: str, available: Sequence[str]) -> list[str]:
        """The selected versions of a selected model."""
        wanted = self.wanted(name)
        return (
            list(available) if not wanted or "" in wanted else [version for version in available if version in wanted]
        )

    def wanted(self, name: str) -> set[str]:
        """What the entries of a model say of its versions; "" for all of them."""
        return {entry.partition("@")[2] for entry in self.entries if entry.partition("@")[0] == name}


@dataclass(slots=True)
class RefreshReport:
    """What one look at the stores found."""

    loaded: list[ModelIdentity] = field(default_factory=list)
    dropped: list[ModelIdentity] = field(default_factory=list)
    failures: dict[str, str] = field(default_factory=dict)
    """``name version`` to the reason it was refused."""
    changed: bool = False


class Loader:
    """Keeps a registry in step with a source of models.

    A version is verified, built, warmed up and checked before it is served; one that fails is left out, and what was
    served before goes on being served: also a version of the same name whose files were damaged since, and all
    versions while the source cannot be read. What was removed from a readable source is dropped, unless a label has
    moved from it to what is not served yet.

    Parameters
    ----------
    registry
        Where the models are served from.
    source, factory
        Where they come from and how they are built.
    selection
        Which of them.
    """

    def __init__(
        self, registry: Registry, source: ModelSource, factory: ModelFactory, selection: Selection | None = None
    ) -> None:
        self._registry = registry
        self._source = source
        self._factory = factory
        self._selection = selection or Selection()
        self._refused: dict[tuple[str, str], tuple[str, float, str]] = {}
        self._lock = threading.Lock()

    def list_source(self) -> list[str]:
        """The selected names; raises ``StoreUnknown`` when the source cannot be listed, ``ModelUnknown`` for a name or
        a version that is not there.
        """
        names = self._selection.names(self._source.names())
        for name in names:
            versions = self._source.versions(name)
            for wanted in self._selection.wanted(name) - {"", *versions}:
                raise ModelUnknown(
                    f"Model '{name}' has no version '{wanted[:80]}' to serve; there are {', '.join(versions)}. A label "
                    f"is no version: it moves. '{name}' alone serves all versions and labels."
                )
        return names

    def refresh(self, force: bool = False) -> RefreshReport:
        """Look at the source once and swap in what changed. ``force`` looks again at what was refused before."""
        with self._lock:
            if force:
                self._refused.clear()
            report = RefreshReport()
            new = old = self._registry.catalogue
            try:
                new = self._build(old, report)
            except BnserveError as error:
                report.failures["store"] = error.detail
            except OSError as error:
                report.failures["store"] = f"The store cannot be read: {error.strerror or error}."
            report.loaded = [m.identity for key, m in new.models.items() if old.models.get(key) is not m]
            report.dropped = [m.identity for key, m in old.models.items() if key not in new.models]
            report.changed = bool(report.loaded or report.dropped) or dict(old.labels) != dict(new.labels)
            if report.changed or not self._registry.loaded:
                self._registry.swap(new)
            return report

    def _build(self, old: Catalogue, report: RefreshReport) -> Catalogue:
        models: dict[tuple[str, str], LoadedModel] = {}
        labels: dict[str, dict[str, str]] = {}
        for name in self._selection.names(self._source.names()):
            try:
                served, labels[name] = self._look_at(name, old, report)
            except (BnserveError, OSError) as error:
                report.failures[name] = getattr(error, "detail", str(error))
                served = {version: model for (served_as, version), model in old.models.items() if served_as == name}
                labels[name] = dict(old.labels.get(name, {}))
            models |= {(name, version): model for version, model in served.items()}
        return Catalogue(
            MappingProxyType(models), MappingProxyType({name: MappingProxyType(own) for name, own in labels.items()})
        )

    def _look_at(
        self, name: str, old: Catalogue, report: RefreshReport
    ) -> tuple[dict[str, LoadedModel], dict[str, str]]:
        """The versions of a model that are served from now on, and its labels."""
        served: dict[str, LoadedModel] = {}
        for version in self._selection.versions(name, self._source.versions(name)):
            model = self._version(name, version, old.models.get((name, version)), report)
            if model is not None:
                served[version] = model
        before = old.labels.get(name, {})
        own: dict[str, str] = {}
        for label, version in self._source.labels(name).items():
            target = version if version in served else before.get(label)
            kept = old.models.get((name, target or ""))
            if target not in served and target != version and kept is not None:  # or nobody would have an answer
                served = {kept.identity.version: kept} | served
            if target in served:
                own[label] = target
        return served, own

    def _version(
        self, name: str, version: str, current: LoadedModel | None, report: RefreshReport
    ) -> LoadedModel | None:
        digest = "unknown"
        try:
            digest = self._source.manifest(name, version).digest
            if current is not None and current.identity.digest == digest:
                return current
            refused = self._refused.get((name, version))
            if refused is not None and refused[0] == digest and time.monotonic() - refused[1] < RETRY_SECONDS:
                report.failures[f"{name} {version}"] = refused[2]
                return current
            loaded = self._load(name, version, digest)
        except Exception as error:
            reason = error.detail if isinstance(error, BnserveError) else f"{type(error).__name__} while loading."
            if not isinstance(error, BnserveError):
                logger.exception("loading %s %s failed", name, version)
            self._refused[name, version] = (digest, time.monotonic(), reason)
            report.failures[f"{name} {version}"] = reason
            return current
        self._refused.pop((name, version), None)
        return loaded

    def _load(self, name: str, version: str, digest: str) -> LoadedModel:
        model = self._factory(self._source.load(name, version))
        model.warm_up()
        if not model.self_check():
            raise ArtifactCorrupted(
                f"Version {version} of '{name}' does not reproduce the answer stored with it; it is not served."
            )
        return LoadedModel(ModelIdentity(name=name, version=version, digest=digest), model)


def loader_of(
    settings: Settings, registry: Registry, source: ModelSource | None = None, factory: ModelFactory | None = None
) -> Loader:
    """What loads the models of the settings into a registry; ``source`` and ``factory`` as for
    :func:`bnserve_service.create_app`.
    """
    return Loader(registry, source or _stores(settings), factory or _surrogate, Selection(settings.models))


def _stores(settings: Settings) -> ModelSource:
    from bnserve_store import ModelStore

    return ModelStore.default(settings.stores)


def _surrogate(artifact: Any) -> Any:
    from bnserve_surrogate import Model  # here, because it compiles: a custom factory need not pay for it

    return Model.from_artifact(artifact)
