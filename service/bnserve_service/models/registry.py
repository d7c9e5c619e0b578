"""The models being served: immutable, and replaced all at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol

import msgspec

from bnserve_protocol import (
    DigestUnknown,
    InvalidRequest,
    ModelIdentity,
    ModelLoading,
    ModelUnknown,
    WaveformModel,
    nearest_name,
)
from bnserve_service.shared.folder import models_file

DEFAULT_LABEL = "stable"
DIGEST_PREFIX = "sha256:"


class ServedModel(WaveformModel, Protocol):
    """A waveform model that can prepare and test itself; ``bnserve_surrogate.Model`` is one."""

    def warm_up(self) -> None:
        """Do now what would otherwise slow the first request down."""

    def self_check(self) -> bool:
        """Whether a tiny real evaluation gives the answer that was stored with the model."""


def quick_work(model: ServedModel) -> int:
    """Rows times (frequencies + 1000) up to which a model promises to answer in 100 us: its ``quick_work``, or 0.

    Only what is promised is evaluated on the event loop; any other model is evaluated in worker threads.
    """
    return int(getattr(model, "quick_work", 0))


class ManifestLike(Protocol):
    """What is read of a manifest."""

    @property
    def digest(self) -> str:
        """The digest of everything in the artifact."""


class ModelSource(Protocol):
    """Where models come from; ``bnserve_store.ModelStore`` is one."""

    def names(self) -> list[str]:
        """The models."""

    def versions(self, name: str) -> list[str]:
        """The versions of a model, oldest first."""

    def labels(self, name: str) -> Mapping[str, str]:
        """The labels of a model and the versions they point to."""

    def manifest(self, name: str, version: str) -> ManifestLike:
        """The manifest of one version."""

    def load(self, name: str, version: str) -> Any:
        """One version, verified; what :data:`ModelFactory` takes."""


ModelFactory = Callable[[Any], ServedModel]
"""Builds a model from what a :class:`ModelSource` loads."""


@dataclass(frozen=True, slots=True, eq=False)
class LoadedModel:
    """One version of one model, ready to evaluate."""

    identity: ModelIdentity
    model: ServedModel

    @property
    def has_derivatives(self) -> bool:
        """Whether gradients and forecasts can be made of it."""
        return hasattr(self.model, "predict_derivatives")

    def check_derivatives(self, advice: str) -> None:
        """Refuse a model without them: InvalidRequest, with what to do."""
        if not self.has_derivatives:
            raise InvalidRequest(f"The model '{self.identity.name}' does not say that it has derivatives: {advice}.")


@dataclass(frozen=True, slots=True)
class Catalogue:
    """Everything that is served at one moment."""

    models: Mapping[tuple[str, str], LoadedModel] = field(default_factory=lambda: MappingProxyType({}))
    """By (name, version)."""
    labels: Mapping[str, Mapping[str, str]] = field(default_factory=lambda: MappingProxyType({}))
    """By name: label to version; only to versions that are served."""
    pins: Mapping[tuple[str, str], LoadedModel] = field(init=False)
    """By (name, digest)."""

    def __post_init__(self) -> None:
        pins = {(model.identity.name, model.identity.digest): model for model in self.models.values()}
        object.__setattr__(self, "pins", MappingProxyType(pins))

    def names(self) -> list[str]:
        """The served models, sorted."""
        return sorted({name for name, _ in self.models})

    def versions(self, name: str) -> list[str]:
        """The served versions of a model, in the order of the store."""
        return [version for served, version in self.models if served == name]

    def defaults(self) -> Iterator[LoadedModel]:
        """The model behind each name's default label."""
        for name in self.names():
            version = self.labels.get(name, {}).get(DEFAULT_LABEL)
            if version is not None:
                yield self.models[name, version]


class _Offer(msgspec.Struct):
    models: list[tuple[str, str, str]]
    """Name, version and digest."""
    labels: dict[str, list[str]]


class SharedModels:
    """Which models the workers of one server have: while they follow a store, some are a moment ahead of the others.

    Parameters
    ----------
    shared
        The folder of the server.
    place
        Of this worker.
    """

    def __init__(self, shared: Path, place: int) -> None:
        self._file = models_file(shared, place)

    def announce(self, catalogue: Catalogue) -> None:
        """Tell the others, before a caller can hear of it."""
        models = [(name, version, loaded.identity.digest) for (name, version), loaded in catalogue.models.items()]
        offer = _Offer(models, {name: list(labels) for name, labels in catalogue.labels.items()})
        fresh = self._file.with_suffix(".new")
        with suppress(OSError):  # no room: then callers are told that there is no such model, for a moment
            fresh.write_bytes(msgspec.json.encode(offer))
            fresh.replace(self._file)

    def have(self, name: str, wanted: str) -> bool:
        """Whether another worker has a version, label or digest of a model."""
        for path in self._file.parent.glob("models-*.json"):
            if path != self._file:
                with suppress(OSError, msgspec.MsgspecError):
                    offer = msgspec.json.decode(path.read_bytes(), type=_Offer)
                    known = [(version, digest) for model, version, digest in offer.models if model == name]
                    if wanted in offer.labels.get(name, []) or any(wanted in versions for versions in known):
                        return True
        return False


class Registry:
    """Holds the current :class:`Catalogue`. Reading is one reference; replacing it is one assignment."""

    def __init__(self) -> None:
        self.catalogue = Catalogue()
        """What is served now. It never changes; the next one is another object."""
        self.loaded = False
        """Whether the first look at the stores is over."""
        self._peers: SharedModels | None = None
        self._catch_up: Callable[[], None] = lambda: None

    def swap(self, catalogue: Catalogue) -> None:
        """Serve ``catalogue`` from now on; evaluations under way keep the model they began with."""
        if self._peers is not None:
            self._peers.announce(catalogue)
        self.catalogue = catalogue
        self.loaded = True

    def join(self, peers: SharedModels, catch_up: Callable[[], None]) -> None:
        """Be one of several processes; ``catch_up`` is called when the others have what is missing here."""
        self._peers = peers
        self._catch_up = catch_up
        peers.announce(self.catalogue)

    def find(self, name: str, version: str | None = None) -> LoadedModel:
        """The model of a version, a label (by default ``stable``) or a digest.

        A digest names one artifact: it, or none.

        Raises
        ------
        ModelUnknown
            The nearest name, or the versions that are there, are suggested.
        DigestUnknown
            No version of that model has the digest.
        ModelLoading
            The stores have not been read yet.
        """
        catalogue = self.catalogue
        wanted = version if version is not None else DEFAULT_LABEL
        labels = catalogue.labels.get(name)
        found = catalogue.models.get((name, labels.get(wanted, wanted) if labels else wanted))
        found = found or catalogue.pins.get((name, wanted))
        if found is not None:
            return found
        if not self.loaded:
            raise ModelLoading("The models are being loaded; try again in a moment.", retry_after=1.0)
        if self._peers is not None and self._peers.have(name, wanted):
            self._catch_up()
            raise ModelLoading("This model is being loaded; try again in a moment.", retry_after=0.1)
        raise _unknown(catalogue, name, wanted)


def _unknown(catalogue: Catalogue, name: str, wanted: str) -> ModelUnknown:
    names = catalogue.names()
    if name not in names:
        near = nearest_name(name, names)
        hint = f"Known models: {', '.join(names) or 'none'}." if near is None else f"Did you mean '{near}'?"
        return ModelUnknown(f"This service has no model '{name[:80]}'. {hint}")
    if wanted.startswith(DIGEST_PREFIX):
        there = ", ".join(
            f"{version} ({catalogue.models[name, version].identity.digest})" for version in catalogue.versions(name)
        )
        return DigestUnknown(
            f"No artifact of model '{name}' with the digest {wanted[:80]} is served here; there are: {there}. "
            "Nothing else is given for it."
        )
    known = ", ".join([*catalogue.versions(name), *catalogue.labels.get(name, {})])
    return ModelUnknown(f"Model '{name}' has no version or label '{wanted[:80]}' here; there are: {known}.")
