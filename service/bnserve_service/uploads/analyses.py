"""Uploaded analyses, and the likelihoods that they become with the models they are evaluated with."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Analysis,
    AnalysisInvalid,
    AnalysisUnknown,
    Likelihood,
    NotFound,
    TooLarge,
    WaveformModel,
    decode_analysis,
    integrated_names,
)
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import Settings
from bnserve_service.uploads.bounds import Bounds
from bnserve_service.uploads.stores import UploadStore

LikelihoodFactory: TypeAlias = Callable[[WaveformModel, Analysis], Likelihood]
"""Makes the likelihood of an analysis with a model; ``bnserve_inference.likelihood`` is one."""

_MODELS_OF_ONE = 4
"""So many models keep what they prepared for one analysis; nearly all analyses meet one."""


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
    shared
        The folder that the workers of one server share; None for a server of one process.
    """

    kind = "analysis"

    def __init__(self, settings: Settings, shared: Path | None = None) -> None:
        bounds = Bounds(settings.max_analyses, settings.max_owner_analyses_bytes, settings.max_analyses_bytes)
        super().__init__(bounds, None if shared is None else shared / "analyses")
        self._max_bytes = settings.max_analysis_bytes

    def _decode(self, body: bytes | memoryview, sha256: str) -> StoredAnalysis:
        if len(body) > self._max_bytes:
            raise TooLarge(f"An analysis has at most {self._max_bytes} bytes here; this is larger.")
        analysis = decode_analysis(body)
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
