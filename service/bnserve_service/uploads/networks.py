"""Uploaded networks of detectors, and what evaluates forecasts in them."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any, NamedTuple

from bnserve_protocol import AnalysisInvalid, DetectorNetwork, NetworkUnknown, NotFound, TooLarge, decode_network
from bnserve_service.http.body import OFF_LOOP
from bnserve_service.settings import Settings
from bnserve_service.uploads.bounds import Bounds
from bnserve_service.uploads.stores import UploadStore


class StoredNetwork(NamedTuple):
    """One network, checked: its name, which is the digest of its bytes, what travels, and what evaluates it, a
    ``bnserve_inference.fisher.Network``."""

    sha256: str
    description: DetectorNetwork
    network: Any
    nbytes: int


class NetworkStore(UploadStore[StoredNetwork]):
    """Networks of detectors; each belongs to those who uploaded it, and is unknown to everybody else.

    Parameters
    ----------
    settings
        The limits.
    shared
        The folder that the workers of one server share; None for a server of one process.
    """

    kind = "network"
    further_work = OFF_LOOP  # what evaluates it takes longer to make than to read

    def __init__(self, settings: Settings, shared: Path | None = None) -> None:
        most = settings.max_networks_bytes
        bounds = Bounds(settings.max_networks, most // 2, most)
        super().__init__(bounds, None if shared is None else shared / "networks")
        self._max_bytes = settings.max_network_bytes

    def _decode(self, body: bytes | memoryview, sha256: str) -> StoredNetwork:
        if len(body) > self._max_bytes:
            raise TooLarge(f"A network has at most {self._max_bytes} bytes here; this is larger.")
        actual = hashlib.sha256(body).hexdigest()
        if actual != sha256:
            raise AnalysisInvalid(f"The SHA-256 of the body is {actual}, not the digest in the path; send it again.")
        description = decode_network(body)
        return StoredNetwork(sha256, description, _built(description), len(body))

    def _unknown(self) -> NotFound:
        return NetworkUnknown(
            "No network that you uploaded has that digest here (they are dropped when the server restarts or needs the "
            "memory); upload it with PUT /v1/networks/{sha256} and repeat the request."
        )


def _built(description: DetectorNetwork) -> Any:
    from bnserve_inference.fisher import Network  # here, because a server that only serves waveforms need not load it

    return Network.of(description)
