"""Uploaded grids, analyses and networks, by owner and digest; one process's, or known to all workers."""

from __future__ import annotations

import hashlib
import threading
from abc import ABC, abstractmethod
from collections import OrderedDict
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, ClassVar, Generic, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Analysis,
    AnalysisInvalid,
    AnalysisUnknown,
    BnserveError,
    DetectorNetwork,
    GridUnknown,
    InvalidFrequencies,
    Likelihood,
    NetworkUnknown,
    NotFound,
    TooLarge,
    UndecodableBody,
    WaveformModel,
    as_frequencies,
    decode_network,
    grid_digest,
    integrated_names,
)
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import Settings
from bnserve_service.uploads.blobs import BlobStore, no_room
from bnserve_service.uploads.bounds import Blob, Bounds, size_of

LikelihoodFactory: TypeAlias = Callable[[WaveformModel, Analysis], Likelihood]
"""Makes the likelihood of an analysis with a model; ``bnserve_inference.likelihood`` is one."""

NetworkFactory: TypeAlias = Callable[[DetectorNetwork], Any]
"""Makes of a description what forecasts are made with; ``bnserve_inference.fisher.Network.of`` is one."""

_MODELS_OF_ONE = 4
"""So many models keep what they prepared for one analysis; nearly all analyses meet one."""

T = TypeVar("T")


class _Held(NamedTuple, Generic[T]):
    blob: Blob
    value: T


class UploadStore(ABC, Generic[T]):
    """A bounded map from owner and digest to what was uploaded; safe to use from several threads.

    Nothing has a name but its digest, so that no two uploads can have the same one. Owners of the same bytes share
    their memory, and neither notices. What is beyond the bounds is dropped as they say.

    Parameters
    ----------
    bounds
        How much is kept.
    folder
        Where all workers of one server keep it; None for a server of one process.
    """

    is_common: ClassVar[bool] = False
    """Whether what one owner uploads belongs to everybody: whoever knows the digest knows the content."""

    def __init__(self, bounds: Bounds, folder: Path | None) -> None:
        self._bounds = bounds
        self._blobs = None if folder is None else BlobStore(folder, bounds)
        self._held: OrderedDict[tuple[str, str], _Held[T]] = OrderedDict()
        """In the order in which they were used."""
        self._lock = threading.Lock()

    @abstractmethod
    def _decode(self, body: bytes | memoryview, sha256: str) -> T:
        """What was uploaded; refused if it is not right, or its digest is another."""

    @abstractmethod
    def _unknown(self) -> NotFound:
        """The error for what is not here."""

    def __len__(self) -> int:
        return self._usage()[0]

    @property
    def stored_bytes(self) -> int:
        """Memory of what is held now."""
        return self._usage()[1]

    def _usage(self) -> tuple[int, int]:
        if self._blobs is not None:
            return self._blobs.usage()
        with self._lock:
            blobs = [held.blob for held in self._held.values()]
        return len({blob.name for blob in blobs}), size_of(blobs)

    def get(self, owner: str, sha256: str) -> T:
        """What this owner, or, if it is common, anybody has uploaded.

        Raises
        ------
        GridUnknown, AnalysisUnknown, NetworkUnknown
            Never uploaded, or dropped since.
        Unavailable
            What the workers share is gone, and no worker can know.
        """
        key = self._key(owner, sha256)
        if self._blobs is not None and not self._blobs.use(*key):
            self._forget(key)
        with self._lock:
            found = self._held.get(key)
            if found is not None:
                self._held.move_to_end(key)
                return found.value
        return self._read(key)

    def all_of(self, owner: str) -> list[T]:
        """What this owner has uploaded, in the order of the digests; that it was listed does not count as use."""
        with self._lock:
            held = {key: held.value for key, held in self._held.items()}
        if self._blobs is None:
            return [held[key] for key in sorted(held) if key == self._key(owner, key[1])]
        found = []
        for key in [self._key(owner, sha256) for sha256 in self._blobs.names(self._key(owner, "")[0])]:
            with suppress(NotFound):  # dropped a moment ago
                found.append(held[key] if key in held else self._read(key))
        return found

    def _read(self, key: tuple[str, str]) -> T:
        """What another worker received."""
        content = None if self._blobs is None else self._blobs.read(*key)
        if content is None:
            raise self._unknown()
        try:
            value = self._decode(content, key[1])  # checked as if it had just arrived
        except BnserveError:
            self.discard(*key)
            raise self._unknown() from None
        return self._keep(key, value, len(content))[0]

    def put(self, owner: str, sha256: str, body: bytes) -> tuple[T, bool]:
        """Keep an upload, after checking that it is what it should be and that its digest is ``sha256``.

        Returns
        -------
        What it is, and whether it was not there before.

        Raises
        ------
        UndecodableBody, TooLarge, InvalidFrequencies, AnalysisInvalid
            It is no such upload, too large, or not what its digest says.
        Overloaded
            There is no room for it in the memory that workers share.
        """
        key = self._key(owner, sha256)
        value = self._decode(body, sha256)
        if self._blobs is None:
            return self._keep(key, value, len(body))
        is_new = not self._blobs.use(*key)
        if is_new and not self._blobs.put(*key, body):
            raise no_room()
        return self.get(owner, sha256), is_new

    def drop(self, owner: str, sha256: str) -> None:
        """Forget an upload.

        Raises
        ------
        GridUnknown, AnalysisUnknown, NetworkUnknown
            It is not here.
        """
        if not self.discard(owner, sha256):
            raise self._unknown()

    def discard(self, owner: str, sha256: str) -> bool:
        """Forget an upload; whether it was here."""
        key = self._key(owner, sha256)
        was_here = self._forget(key)
        return was_here if self._blobs is None else self._blobs.drop(*key)

    def has(self, owner: str, sha256: str) -> bool:
        """Whether an upload is here; that it was asked for does not count as use."""
        key = self._key(owner, sha256)
        return key in self._held if self._blobs is None else self._blobs.has(*key)

    def bytes_to_read(self, owner: str, sha256: str) -> int:
        """How much :meth:`get` has to read and check: what another worker received, when it is first used here."""
        key = self._key(owner, sha256)
        return 0 if self._blobs is None or key in self._held else self._blobs.size(*key) or 0

    def all_bytes_to_read(self, owner: str) -> int:
        """How much :meth:`all_of` has to read and check."""
        names = [] if self._blobs is None else self._blobs.names(self._key(owner, "")[0])
        return sum(self.bytes_to_read(owner, sha256) for sha256 in names)

    def tidy(self) -> None:
        """Give back the memory of what another worker has dropped."""
        if self._blobs is not None:
            for key in list(self._held):
                if not self._blobs.has(*key):
                    self._forget(key)

    def _key(self, owner: str, sha256: str) -> tuple[str, str]:
        return "" if self.is_common else owner, sha256

    def _keep(self, key: tuple[str, str], value: T, nbytes: int) -> tuple[T, bool]:
        with self._lock:
            found = self._held.get(key)  # another thread may have been faster
            if found is not None:
                self._held.move_to_end(key)
                return found.value, False
            others = list(self._held.values())
            value = next((held.value for held in others if held.blob.name == key[1]), value)
            fresh = Blob(*key, nbytes)
            self._held[key] = _Held(fresh, value)
            for blob in self._bounds.surplus(fresh, [held.blob for held in others]):
                del self._held[blob.owner, blob.name]
        return value, True

    def _forget(self, key: tuple[str, str]) -> bool:
        with self._lock:
            return self._held.pop(key, None) is not None


class GridStore(UploadStore[NDArray[np.float64]]):
    """Frequencies in Hz, read-only ``(M,)``, by :func:`bnserve_protocol.grid_digest`.

    Parameters
    ----------
    settings
        The limits.
    shared
        The folder that the workers of one server share; None for a server of one process.
    """

    is_common = True

    def __init__(self, settings: Settings, shared: Path | None = None) -> None:
        bounds = Bounds(settings.max_grids, settings.max_grid_bytes, settings.max_grid_bytes)
        super().__init__(bounds, None if shared is None else shared / "grids")
        self._max_frequencies = settings.max_frequencies

    def _decode(self, body: bytes | memoryview, sha256: str) -> NDArray[np.float64]:
        if len(body) % 8:
            raise UndecodableBody(
                f"A grid travels as raw little-endian float64, 8 bytes each; {len(body)} bytes do not divide by 8."
            )
        if len(body) // 8 > self._max_frequencies:
            raise TooLarge(f"A grid has at most {self._max_frequencies} frequencies; this one has {len(body) // 8}.")
        frequencies = np.frombuffer(body, dtype="<f8").astype(np.float64, copy=False)
        frequencies.flags.writeable = False
        actual = grid_digest(frequencies)
        if actual != sha256:
            raise InvalidFrequencies(f"The SHA-256 of the body is {actual}, not the digest in the path; send it again.")
        as_frequencies(frequencies)
        return frequencies

    def _unknown(self) -> NotFound:
        return GridUnknown(
            "No uploaded grid has that digest; upload it with PUT /v1/grids/{sha256} and repeat the request."
        )


class StoredAnalysis:
    """One analysis, checked, with the memory it takes and the likelihoods it has become.

    Parameters
    ----------
    analysis
        The analysis.
    nbytes
        Its size as uploaded; its arrays are views of those bytes.
    """

    def __init__(self, analysis: Analysis, nbytes: int) -> None:
        self.analysis = analysis
        self.nbytes = nbytes
        self._likelihoods: dict[LoadedModel, Likelihood] = {}

    @property
    def parameters(self) -> list[str]:
        """What a sample says, in the order of ``LIKELIHOOD_NAMES``: all but what is integrated over."""
        integrated = integrated_names(self.analysis.settings)
        return [name for name in LIKELIHOOD_NAMES if name not in integrated]

    @property
    def sha256(self) -> str:
        """Its name: the digest of its canonical form, in hexadecimal."""
        return self.analysis.digest.removeprefix("sha256:")

    def likelihood(self, model: LoadedModel, bind: LikelihoodFactory) -> Likelihood:
        """The likelihood of this analysis with a model; made when it is first asked for, in a worker thread."""
        found = self._likelihoods.get(model)
        if found is None:
            while len(self._likelihoods) >= _MODELS_OF_ONE:
                self._likelihoods.pop(next(iter(self._likelihoods)), None)
            found = self._likelihoods[model] = bind(model.model, self.analysis)
        return found


class AnalysisStore(UploadStore[StoredAnalysis]):
    """Analyses; each belongs to those who uploaded it, and is unknown to everybody else.

    Parameters
    ----------
    settings
        The limits.
    decode
        Turns a body into an analysis, or refuses it.
    shared
        The folder that the workers of one server share; None for a server of one process.
    """

    def __init__(
        self, settings: Settings, decode: Callable[[bytes | memoryview], Analysis], shared: Path | None = None
    ) -> None:
        bounds = Bounds(settings.max_analyses, settings.max_owner_analyses_bytes, settings.max_analyses_bytes)
        super().__init__(bounds, None if shared is None else shared / "analyses")
        self._max_bytes = settings.max_analysis_bytes
        self._decode_analysis = decode

    def _decode(self, body: bytes | memoryview, sha256: str) -> StoredAnalysis:
        if len(body) > self._max_bytes:
            raise TooLarge(f"An analysis has at most {self._max_bytes} bytes here; this is larger.")
        analysis = self._decode_analysis(body)
        if analysis.digest != f"sha256:{sha256}":
            raise AnalysisInvalid(
                f"The analysis in the body has the digest {analysis.digest}, not the one in the path; if it arrived as "
                "you meant it, PUT it under that one."
            )
        return StoredAnalysis(analysis, len(body))

    def _unknown(self) -> NotFound:
        return AnalysisUnknown(
            "No analysis that you uploaded has that digest here (they are dropped when the server restarts or needs "
            "the memory); upload it with PUT /v1/analyses/{sha256} and repeat the request."
        )


class StoredNetwork(NamedTuple):
    """One network, checked: its name, which is the digest of its bytes, what travels, and what evaluates it."""

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
    build
        Makes what forecasts are made with, or refuses it.
    shared
        The folder that the workers of one server share; None for a server of one process.
    """

    def __init__(self, settings: Settings, build: NetworkFactory, shared: Path | None = None) -> None:
        most = settings.max_networks_bytes
        bounds = Bounds(settings.max_networks, most // 2, most)
        super().__init__(bounds, None if shared is None else shared / "networks")
        self._max_bytes = settings.max_network_bytes
        self._build = build

    def _decode(self, body: bytes | memoryview, sha256: str) -> StoredNetwork:
        if len(body) > self._max_bytes:
            raise TooLarge(f"A network has at most {self._max_bytes} bytes here; this is larger.")
        actual = hashlib.sha256(body).hexdigest()
        if actual != sha256:
            raise AnalysisInvalid(f"The SHA-256 of the body is {actual}, not the digest in the path; send it again.")
        description = decode_network(body)
        return StoredNetwork(sha256, description, self._build(description), len(body))

    def _unknown(self) -> NotFound:
        return NetworkUnknown(
            "No network that you uploaded has that digest here (they are dropped when the server restarts or needs the "
            "memory); upload it with PUT /v1/networks/{sha256} and repeat the request."
        )
