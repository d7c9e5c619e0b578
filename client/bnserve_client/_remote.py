"""The methods of a waveform model as conversations: what the synchronous and the asynchronous model have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from numpy.typing import DTypeLike

from bnserve_client._addresses import parse_addresses
from bnserve_client._evaluation import Evaluator, Question
from bnserve_client._grids import GridMemory
from bnserve_client._likelihoods import RemoteLikelihood
from bnserve_client._messages import Conversation
from bnserve_client._progress import require_tqdm
from bnserve_client._results import multiply_out, own
from bnserve_client._session import Pinned, Session
from bnserve_client._settings import Settings
from bnserve_protocol import (
    AmplitudePhase,
    Analysis,
    BatchLike,
    EvaluationOptions,
    Factored,
    GridLike,
    MergerStencil,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    RunManifest,
    check_dtype,
    check_options,
)
from bnserve_protocol.wire import OutputName

_CONNECT_RETRIES = 3
"""At the first contact a wrong address is likelier than an outage, so it is reported soon."""


def settings_from(address: str | Sequence[str], progress: bool, **chosen: Any) -> Settings:
    """Settings from the arguments of ``connect``.

    Raises
    ------
    InvalidRequest
    """
    if progress:
        require_tqdm()
    return Settings(addresses=parse_addresses(address), progress=progress, **chosen)


def connecting(settings: Settings, name: str, version: str, digest: str | None) -> Conversation[Pinned]:
    """The first contact: see :meth:`.Session.connect`."""
    retries = _CONNECT_RETRIES if settings.retries is None else settings.retries
    return Session(settings.with_retries(retries)).connect(name, version, digest)


class RemoteModel:
    """Conversations about one pinned model; every argument is that of :class:`bnserve_protocol.WaveformModel`."""

    def __init__(self, settings: Settings, pinned: Pinned) -> None:
        self.settings = settings
        self.pinned = pinned
        self._grids = GridMemory()
        self._session = Session(settings)
        self._evaluator = Evaluator(self._session, pinned)
        self._strain: OutputName = "factored" if len(pinned.description.modes) == 1 else "polarizations"

    def manifest(self) -> Conversation[RunManifest]:
        """The manifest of the replica that answers."""
        return self._session.get("/v1/manifest", RunManifest, self._session.patience())

    def predict(
        self, frequencies: GridLike, parameters: ParametersWithExtrinsic, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Polarizations]:
        """One waveform."""
        batch = yield from self.predict_batch(frequencies, ParameterBatch.one(parameters), options, dtype)
        return Polarizations(
            plus=batch.plus[0],
            cross=batch.cross[0],
            status=batch.status,
            estimated_mismatch=batch.estimated_mismatch,
        )

    def predict_batch(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Polarizations]:
        """N waveforms."""
        question = self._question(frequencies, batch, self._strain, options, dtype)
        arrays = yield from self._evaluator.evaluate(question, multiply_out)
        return Polarizations(**arrays)

    def predict_factored(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Factored]:
        """N waveforms before the polarisations are multiplied out."""
        question = self._question(frequencies, batch, "factored", options, dtype)
        arrays = yield from self._evaluator.evaluate(question, own)
        return Factored(**arrays)

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
    ) -> Conversation[AmplitudePhase]:
        """Amplitude and phase."""
        question = self._question(frequencies, batch, "amplitude_phase", options, "complex128")
        arrays = yield from self._evaluator.evaluate(question, own)
        if isinstance(batch, ParametersWithExtrinsic):
            arrays = {**arrays, "amplitude": arrays["amplitude"][0], "phase": arrays["phase"][0]}
        return AmplitudePhase(**arrays)

    def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> Conversation[float]:
        """Seconds from ``frequency`` to the merger."""
        stencil = MergerStencil.within(self.pinned.description, frequency, parameters)
        answer = yield from self.predict_amplitude_phase(
            stencil.frequencies, stencil.unshifted(parameters), stencil.options
        )
        return stencil.seconds(answer.phase)

    def likelihood(self, analysis: Analysis) -> RemoteLikelihood:
        """Conversations about the likelihood of an analysis."""
        return RemoteLikelihood(self._session, self.pinned, analysis)

    def _question(
        self, frequencies: GridLike, batch: BatchLike, output: OutputName, options: EvaluationOptions, dtype: DTypeLike
    ) -> Question:
        check_options(options)
        precision = check_dtype(dtype)
        grid = self._grids.recall(frequencies)
        return Question(ParameterBatch.coerce(batch), grid, output, precision, options)
