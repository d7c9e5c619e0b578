"""Waveforms as a question, and the methods of a waveform model as conversations."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_client._addresses import Address
from bnserve_client._evaluation import Arrays, Evaluator, Question, Upload, check_model
from bnserve_client._forecasts import forecasting, loudness
from bnserve_client._grids import IN_FULL_ONCE, ExplicitGrid, GridMemory, ends_of
from bnserve_client._kept_arrays import BY_MODES, check_arrays, kept
from bnserve_client._messages import Conversation
from bnserve_client._pinned import Pinned
from bnserve_client._session import Session
from bnserve_client._settings import Settings
from bnserve_client._transport_factory import TransportFactory
from bnserve_protocol import (
    DERIVATIVE_NAMES,
    AmplitudePhase,
    BatchLike,
    Derivatives,
    DescribesNetwork,
    DtypeName,
    EvaluationOptions,
    Factored,
    Forbidden,
    Forecast,
    ForecastOptions,
    GridLike,
    GridUnknown,
    LikelihoodBatchLike,
    Limits,
    MergerTimes,
    Mode,
    ModelDescription,
    ModelIdentity,
    Modes,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    SignalToNoise,
    TimeSeries,
    TooLarge,
    UniformGrid,
    as_frequencies,
    check_dtype,
    check_options,
    chosen_modes,
    plain_options,
    the_mode,
    time_domain_steps,
)
from bnserve_protocol.wire import OutputName, WaveformRequest, decode_answer, encode_request

_TRIES = 3
"""With an uploaded grid; then it travels in full."""
_BYTES_PER_NUMBER = 16
"""The most that one number of a sample takes in an answer: complex128."""
_BYTES_PER_ROW = 64
"""Of what belongs to a row, and a mode of it."""
_BYTES_BESIDE = 2**14
"""Names, shapes, the model, and what keeps large arrays at multiples of 64 bytes."""
_OCTETS = "application/octet-stream"
_ANY_SIZE = 2**62


@dataclass(eq=False)
class Waveforms(Question):
    """The waveforms of a batch on a grid; not frozen, which would take 2 us for every waveform."""

    batch: ParameterBatch
    grid: UniformGrid | ExplicitGrid
    result: OutputName
    """What is wanted."""
    output: OutputName
    """What travels, which is shorter where there is one mode."""
    modes: tuple[Mode, ...]
    """Those that count, whether they are returned one by one or not."""
    dtype: DtypeName
    options: EvaluationOptions
    chunk_samples: int

    path = "waveforms"
    unknown = GridUnknown

    @property
    def uploads(self) -> int:  # type: ignore[override]  # read alone
        """Uniform grids need none."""
        return 0 if isinstance(self.grid, UniformGrid) else _TRIES

    def __len__(self) -> int:
        return len(self.batch)

    def rows_per_request(self, limits: Limits) -> int:
        """As :class:`Question`; chunks are small enough to be under way at the same time."""
        samples = len(self.grid) * (_arrays(self) if self.output in BY_MODES else 1)
        return max(1, min(self.chunk_samples // samples, limits.rows_per_request(samples)))

    def encode(self, start: int, stop: int, address: Address | None) -> bytes:
        """As :class:`Question`, with the grid in the shortest form that the service understands."""
        grid: Any = self.grid
        if isinstance(grid, ExplicitGrid) and address is not None:
            grid = grid.on_the_wire(address)
        elif isinstance(grid, ExplicitGrid):
            grid.in_full = grid.in_full or len(grid) <= IN_FULL_ONCE  # short enough not to try again each time
            grid = grid.frequencies
        part = self.batch.rows(slice(start, stop))
        request = WaveformRequest(batch=part, grid=grid, output=self.output, dtype=self.dtype, options=self.options)
        return encode_request(request)

    def max_bytes(self, rows: int) -> int:
        """As :class:`Question`."""
        count = max(2, _arrays(self)) if self.output in BY_MODES else 2
        beside = _BYTES_BESIDE * (2 if self.output == "derivatives" else 1)  # 84 arrays of seven modes have names
        return rows * count * (len(self.grid) * _BYTES_PER_NUMBER + _BYTES_PER_ROW) + beside

    def decode(self, body: bytes | memoryview, rows: int, where: str, model: ModelIdentity) -> Arrays:
        """As :class:`Question`."""
        answer = decode_answer(body)
        check_model(answer.model, where, model)
        check_arrays(answer.arrays, self.output, self.modes, self.dtype, rows, len(self.grid))
        return kept(answer.arrays, self.result, self.modes)

    def upload(self, limits: Limits) -> Upload:
        """As :class:`Question`: the frequencies."""
        assert isinstance(self.grid, ExplicitGrid)  # others are never unknown
        return Upload(f"/v1/grids/{self.grid.sha256}", _OCTETS, self.grid.content)

    def upload_refused(self, error: Forbidden | TooLarge) -> None:
        """As :class:`Question`: the grid travels in full from now on."""
        assert isinstance(self.grid, ExplicitGrid)
        self.grid.in_full = True

    def check(self) -> Question | None:
        """As :class:`Question`: all rows at the ends of the grid, on which the checks of a batch depend."""
        if self.options.out_of_domain != "error":
            return None
        return replace(self, grid=ends_of(self.grid), chunk_samples=_ANY_SIZE)

    def smaller_may_pass(self, limits: Limits) -> bool:
        """As :class:`Question`."""
        return len(self.grid) <= limits.max_frequencies


def _arrays(question: Waveforms) -> int:
    """Of samples: one of each mode, and with derivatives six more."""
    return len(question.modes) * (1 + len(DERIVATIVE_NAMES) if question.output == "derivatives" else 1)


class RemoteModel:
    """Conversations about one pinned model; every argument is that of :class:`bnserve_protocol.WaveformModel`."""

    def __init__(self, settings: Settings, pinned: Pinned) -> None:
        self.settings = settings
        self.pinned = pinned
        self._grids = GridMemory()
        self.evaluator = Evaluator(Session(settings), pinned)

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
        question = self._question(frequencies, batch, "polarizations", options, dtype)
        arrays = yield from self.evaluator.evaluate(question)
        return Polarizations(**arrays)

    def predict_modes(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Modes]:
        """N waveforms by their modes."""
        question = self._question(frequencies, batch, "modes", options, dtype)
        arrays = yield from self.evaluator.evaluate(question)
        return Modes(modes=question.modes, **arrays)

    def predict_derivatives(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
    ) -> Conversation[Derivatives]:
        """N waveforms by their modes, with the derivatives of these."""
        question = self._question(frequencies, batch, "derivatives", options, "complex128")
        arrays = yield from self.evaluator.evaluate(question)
        grid = question.grid
        f = grid.frequencies if isinstance(grid, ExplicitGrid) else as_frequencies(grid)
        return Derivatives(
            modes=question.modes, frequencies=f, distances=question.batch["distance_mpc"].copy(), **arrays
        )

    def predict_factored(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Factored]:
        """N waveforms before the polarisations are multiplied out."""
        question = self._question(frequencies, batch, "factored", options, dtype)
        arrays = yield from self.evaluator.evaluate(question)
        return Factored(**arrays)

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
    ) -> Conversation[AmplitudePhase]:
        """Amplitude and phase."""
        question = self._question(frequencies, batch, "amplitude_phase", options, "complex128")
        arrays = yield from self.evaluator.evaluate(question)
        if isinstance(batch, ParametersWithExtrinsic):
            arrays = {**arrays, "amplitude": arrays["amplitude"][0], "phase": arrays["phase"][0]}
        return AmplitudePhase(**arrays)

    def time_until_merger(
        self, frequency: GridLike, parameters: BatchLike
    ) -> Conversation[float | NDArray[np.float64]]:
        """Seconds from frequencies to the merger."""
        times = MergerTimes(self.pinned.description, frequency, parameters)
        answer = yield from self.predict_amplitude_phase(times.grid, times.batch, times.options)
        seconds = times.seconds(answer.phase)
        return seconds if seconds.ndim else float(seconds)

    def predict_time_domain(self, parameters: BatchLike, **how: Any) -> Conversation[TimeSeries]:
        """Signals in time; ``how`` are the keywords of :func:`bnserve_protocol.predict_time_domain`."""
        steps = time_domain_steps(self.pinned.description, parameters, limits=self.pinned.limits, **how)
        answer: AmplitudePhase | Modes | None = None
        while True:
            try:
                asked = steps.send(answer)
            except StopIteration as finished:
                series: TimeSeries = finished.value
                return series
            if asked.method == "predict_modes":
                answer = yield from self.predict_modes(asked.frequencies, asked.batch, asked.options, "complex128")
            else:
                answer = yield from self.predict_amplitude_phase(asked.frequencies, asked.batch, asked.options)

    def forecast(
        self, network: DescribesNetwork, samples: LikelihoodBatchLike, options: ForecastOptions
    ) -> Conversation[Forecast]:
        """What a network would measure of N binaries."""
        return forecasting(self.evaluator, self.pinned.description, network, samples, options)

    def signal_to_noise(
        self, network: DescribesNetwork, samples: LikelihoodBatchLike, options: ForecastOptions
    ) -> Conversation[SignalToNoise]:
        """Their signal-to-noise ratios alone."""
        return loudness(self.evaluator, self.pinned.description, network, samples, options)

    def _question(
        self, frequencies: GridLike, batch: BatchLike, result: OutputName, options: EvaluationOptions, dtype: DTypeLike
    ) -> Waveforms:
        check_options(options)
        known = self.pinned.description.modes
        options = plain_options(options, known)
        modes = chosen_modes(options, known)
        if result in ("factored", "amplitude_phase"):
            the_mode(options, known)
        binaries = ParameterBatch.coerce(batch)
        # Half the bytes. The polarisations of another mode than (2, 2) are not to the bit its strain times the factors,
        # and those of a binary that precesses have none.
        halved = len(modes) == 1 and result == "modes"
        if result == "polarizations":
            halved = modes == ((2, 2),) and binaries.in_plane is None
        output: OutputName = "factored" if halved else result
        precision = check_dtype(dtype)
        grid = self._grids.recall(frequencies)
        chunk = self.settings.chunk_samples
        return Waveforms(binaries, grid, result, output, modes, precision, options, chunk)


class ConnectedModel:
    """What the two models have in common: everything but who holds the conversations."""

    def __init__(self, settings: Settings, pinned: Pinned, factory: TransportFactory | None) -> None:
        self._remote = RemoteModel(settings, pinned)
        self._factory = factory

    @property
    def description(self) -> ModelDescription:
        """Name, version, digest, ranges, band, accuracy."""
        return self._remote.pinned.description

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._remote.settings, self._remote.pinned, self._factory)

    def __repr__(self) -> str:
        where = ", ".join(address.text for address in self._remote.settings.addresses)
        return f"<bnserve_client.{type(self).__name__} {self.description.name} {self.description.version} at {where}>"
