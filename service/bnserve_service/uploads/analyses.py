"""Uploaded analyses, by digest: each belongs to those who uploaded it; the least recently used are dropped first."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeAlias

from bnserve_protocol import (
    Analysis,
    AnalysisInvalid,
    AnalysisUnknown,
    BnserveError,
    Likelihood,
    TooLarge,
    WaveformModel,
)
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import Settings
from bnserve_service.shared.files import BlobStore, no_room

LikelihoodFactory: TypeAlias = Callable[[WaveformModel, Analysis], Likelihood]
"""Makes the likelihood of an analysis with a model; ``bnserve_inference.likelihood`` is one."""

UNKNOWN = (
    "No analysis that you uploaded has that digest here (they are dropped when the server restarts or needs the "
    "memory); upload it with PUT /v1/analyses/{sha256} and repeat the request."
)


_MODELS_OF_ONE = 4
"""So many models keep what they prepared for one analysis; nearly all analyses meet one."""


class StoredAnalysis:
    """One analysis, checked, with the memory it takes and the likelihoods it has become.

    Parameters
    ----------
    analysis:
        The analysis.
    nbytes:
        Its size as uploaded; its arrays are views of those bytes.
    """

    def __init__(self, analysis: Analysis, nbytes: int) -> None:
        self.analysis = analysis
        self.nbytes = nbytes
        self._likelihoods: dict[LoadedModel, Likelihood] = {}

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


@dataclass(slots=True)
class _Belongings:
    """What one owner has, least recently used first."""

    analyses: OrderedDict[str, StoredAnalysis] = field(default_factory=OrderedDict)
    nbytes: int = 0


class AnalysisStore:
    """A bounded map from owner and digest to analysis; safe to use from several threads.

    Whoever uploads an analysis owns it; to everybody else it is unknown. Owners of the same bytes share their memory,
    and neither notices. An owner over ``max_owner_analysis_bytes`` loses the analyses that they used longest ago; when
    all together are over ``max_analyses_bytes``, whoever has most does. Nothing has a name but its digest, so that no
    two analyses can have the same one.

    Parameters
    ----------
    settings:
        The limits.
    decode:
        Turns a body into an analysis, or refuses it.
    blobs:
        Where all workers of one server keep them; None for a server of one process.
    """

    def __init__(
        self, settings: Settings, decode: Callable[[bytes | memoryview], Analysis], blobs: BlobStore | None = None
    ) -> None:
        self._blobs = blobs
        self._settings = settings
        self._decode = decode
        self._owners: dict[str, _Belongings] = {}
        self._holders: dict[str, int] = {}
        self._bytes = 0
        self._lock = threading.Lock()

    def __len__(self) -> int:
        return len(self._holders) if self._blobs is None else self._blobs.usage()[0]

    @property
    def stored_bytes(self) -> int:
        """Memory of the analyses held now."""
        return self._bytes if self._blobs is None else self._blobs.usage()[1]

    def get(self, owner: str, sha256: str) -> StoredAnalysis:
        """An analysis of this owner.

        Raises
        ------
        AnalysisUnknown
            Never uploaded by this owner, or dropped since.
        Unavailable
            What the workers share is gone, and no worker can know.
        """
        if self._blobs is not None and not self._blobs.use(owner, sha256):
            self._blobs.check()
            self._let_go(owner, sha256)
        with self._lock:
            found = self._find(owner, sha256)
        found = found or self._from_blobs(owner, sha256)
        if found is None:
            raise AnalysisUnknown(UNKNOWN)
        return found

    def bytes_to_read(self, owner: str, sha256: str) -> int:
        """How much :meth:`get` has to read and check: what another worker received, when it is first used here."""
        if self._blobs is None or sha256 in self._holders:
            return 0
        return self._blobs.size(owner, sha256) or 0

    def put(self, owner: str, sha256: str, body: bytes) -> tuple[StoredAnalysis, bool]:
        """Keep an uploaded analysis, after checking that it is one and that its digest is ``sha256``.

        Returns
        -------
        The analysis, and whether this owner did not have it before.

        Raises
        ------
        AnalysisInvalid, UndecodableBody, TooLarge
        """
        if len(body) > self._settings.max_analysis_bytes:
            raise TooLarge(f"An analysis has at most {self._settings.max_analysis_bytes} bytes here; this is larger.")
        analysis = self._decode(body)
        if analysis.digest != f"sha256:{sha256}":
            raise AnalysisInvalid(
                f"The analysis in the body has the digest {analysis.digest}, not the one in the path; if it arrived as "
                "you meant it, PUT it under that one."
            )
        if self._blobs is None:
            with self._lock:
                return self._keep(owner, StoredAnalysis(analysis, len(body)))
        is_new = not self._blobs.use(owner, sha256)
        if is_new and not self._blobs.put(owner, sha256, body):
            raise no_room()
        return self.get(owner, sha256), is_new

    def drop(self, owner: str, sha256: str) -> None:
        """Forget an analysis of this owner.

        Raises
        ------
        AnalysisUnknown
        """
        if not self.discard(owner, sha256):
            raise AnalysisUnknown(UNKNOWN)

    def discard(self, owner: str, sha256: str) -> bool:
        """Forget an analysis of this owner; whether it was here."""
        was_here = self._let_go(owner, sha256)
        return was_here if self._blobs is None else self._blobs.drop(owner, sha256)

    def has(self, owner: str, sha256: str) -> bool:
        """Whether an analysis of this owner is here; that it was asked for does not count as use."""
        if self._blobs is not None:
            return self._blobs.has(owner, sha256)
        belongings = self._owners.get(owner)
        return belongings is not None and sha256 in belongings.analyses

    def tidy(self) -> None:
        """Give back the memory of analyses that another worker has dropped."""
        if self._blobs is not None:
            for owner, sha256 in [(owner, name) for owner, has in list(self._owners.items()) for name in has.analyses]:
                if not self._blobs.has(owner, sha256):
                    self._let_go(owner, sha256)

    def _from_blobs(self, owner: str, sha256: str) -> StoredAnalysis | None:
        """What another worker received, checked as if it had just arrived."""
        content = self._blobs.read(owner, sha256) if self._blobs is not None else None
        if content is None or self._blobs is None:
            return None
        try:
            analysis = self._decode(content)
        except BnserveError:
            analysis = None
        if analysis is None or analysis.digest != f"sha256:{sha256}":
            self._blobs.drop(owner, sha256)
            return None
        with self._lock:
            return self._keep(owner, StoredAnalysis(analysis, len(content)))[0]

    def _let_go(self, owner: str, sha256: str) -> bool:
        with self._lock:
            was_here = self._find(owner, sha256) is not None
            if was_here:
                self._forget(owner, sha256)
            return was_here

    def _find(self, owner: str, sha256: str) -> StoredAnalysis | None:
        belongings = self._owners.get(owner)
        if belongings is None or sha256 not in belongings.analyses:
            return None
        belongings.analyses.move_to_end(sha256)
        return belongings.analyses[sha256]

    def _keep(self, owner: str, fresh: StoredAnalysis) -> tuple[StoredAnalysis, bool]:
        found = self._find(owner, fresh.sha256)  # another thread may have been faster
        if found is not None:
            return found, False
        shared = next((b.analyses[fresh.sha256] for b in self._owners.values() if fresh.sha256 in b.analyses), fresh)
        belongings = self._owners.setdefault(owner, _Belongings())
        belongings.analyses[fresh.sha256] = shared
        belongings.nbytes += shared.nbytes
        self._holders[fresh.sha256] = self._holders.get(fresh.sha256, 0) + 1
        self._bytes += shared.nbytes if shared is fresh else 0
        self._shrink(owner, belongings)
        return shared, True

    def _shrink(self, owner: str, own: _Belongings) -> None:
        """Make room for what ``owner`` has just got, which itself stays: no limit is below the size of one analysis."""
        settings = self._settings
        while own.nbytes > settings.max_owner_analyses_bytes or len(own.analyses) > settings.max_analyses:
            self._forget(owner, next(iter(own.analyses)))
        while self._bytes > settings.max_analyses_bytes:
            others = [name for name, has in self._owners.items() if name != owner or len(has.analyses) > 1]
            richest = max(others, key=lambda name: self._owners[name].nbytes)
            self._forget(richest, next(iter(self._owners[richest].analyses)))

    def _forget(self, owner: str, sha256: str) -> None:
        belongings = self._owners[owner]
        dropped = belongings.analyses.pop(sha256)
        belongings.nbytes -= dropped.nbytes
        if not belongings.analyses:
            del self._owners[owner]
        self._holders[sha256] -= 1
        if not self._holders[sha256]:
            del self._holders[sha256]
            self._bytes -= dropped.nbytes
