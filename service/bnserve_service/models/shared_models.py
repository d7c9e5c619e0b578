"""Which models the workers of one server have: while they follow a store, some are a moment ahead of the others."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import msgspec

from bnserve_service.models.registry import Catalogue
from bnserve_service.shared.folder import models_file


class _Offer(msgspec.Struct):
    models: list[tuple[str, str, str]]
    """Name, version and digest."""
    labels: dict[str, list[str]]


_encode = msgspec.json.Encoder().encode
_decode = msgspec.json.Decoder(_Offer).decode


class SharedModels:
    """What this worker has, for the others, and what they have.

    Parameters
    ----------
    shared:
        The folder of the server.
    place:
        Of this worker.
    """

    def __init__(self, shared: Path, place: int) -> None:
        self._folder = shared
        self._file = models_file(shared, place)

    def announce(self, catalogue: Catalogue) -> None:
        """Tell the others, before a caller can hear of it."""
        models = [(name, version, loaded.identity.digest) for (name, version), loaded in catalogue.models.items()]
        offer = _Offer(models, {name: list(labels) for name, labels in catalogue.labels.items()})
        fresh = self._file.with_suffix(".new")
        with suppress(OSError):  # no room: then callers are told that there is no such model, for a moment
            fresh.write_bytes(_encode(offer))
            fresh.replace(self._file)

    def have(self, name: str, wanted: str) -> bool:
        """Whether another worker has a version, label or digest of a model."""
        for path in self._folder.glob("models-*.json"):
            if path != self._file:
                with suppress(OSError, msgspec.MsgspecError):
                    offer = _decode(path.read_bytes())
                    known = [(version, digest) for model, version, digest in offer.models if model == name]
                    if wanted in offer.labels.get(name, []) or any(wanted in versions for versions in known):
                        return True
        return False
