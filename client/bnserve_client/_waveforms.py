"""Waveforms as a question, their grids as they travel, and the methods of a waveform model as conversations.

From the arrays of an answer to those that a user keeps: writable, and of small arrays never holding the answer. Large
arrays are used where they have arrived, when the transport received them into memory of ours.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import msgspec
import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_client._addresses import Address
from bnserve_client._evaluation import Arrays, Evaluator, Question, Upload, check_model
from bnserve_client._messages import Conversation
from bnserve_client._pinned import Pinned
from bnserve_client._session import Session
from bnserve_client._settings import Settings
from bnserve_client._transport_factory import TransportFactory
from bnserve_protocol import (
    AmplitudePhase,
    AnswerCorrupted,
    BatchLike,
    DtypeName,
    EvaluationOptions,
    Factored,
    Forbidden,
    GridLike,
    GridUnknown,
    Limits,
    MergerStencil,
    ModelDescription,
    ModelIdentity,
    Modes,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    TooLarge,
    UniformGrid,
    as_frequencies,
    check_dtype,
    check_options,
    chosen_modes,
    grid_digest,
    plain_grid,
)
from bnserve_protocol.wire import (
    Grid,
    GridDigest,
    OutputName,
    WaveformRequest,
    decode_answer,
    encode_request,
    result_memory,
)

_TRIES = 3
"""With an uploaded grid; then it travels in full."""
_BYTES_PER_SAMPLE = 32
"""The most that one sample takes in an answer: two complex128."""
_BYTES_PER_ROW = 64
_OCTETS = "application/octet-stream"
_ANY_SIZE = 2**62

_SAMPLES: dict[OutputName, tuple[str, ...]] = {
    "polarizations": ("h_plus", "h_cross"),
    "factored": ("h",),
    "amplitude_phase": ("amplitude", "phase"),
}
_FACTORS: dict[str, np.dtype[Any]] = {"plus": np.dtype("<f8"), "cross": np.dtype("<c16")}
_OF_A_ROW: dict[str, np.dtype[Any]] = {"status": np.dtype("|u1"), "estimated_mismatch": np.dtype("<f8")}
"""Arrays of an answer beside its samples; the second only from models that estimate their error."""
_KEPT = {"h", "plus", "cross", "amplitude", "phase", *_OF_A_ROW}


_IN_FULL_ONCE = 512
"""Grids of more points (4 KiB) are uploaded before their first use, smaller ones before their second."""
_IN_FULL_ALWAYS = 16
"""So few points are shorter than a digest with what belongs to it."""

_REMEMBERED = 4


class ExplicitGrid:
    """A checked copy of a user's frequencies, ``(M,)`` in Hz, and its digest."""

    def __init__(self, frequencies: NDArray[np.float64]) -> None:
        self.content = frequencies.tobytes()
        self.frequencies = np.frombuffer(self.content, np.float64)
        self.in_full = len(frequencies) <= _IN_FULL_ALWAYS
        """Whether it always travels in full: because it is tiny, or because the service does not take uploads."""
        self._used_at: set[Address] = set()

    def __len__(self) -> int:
        return len(self.frequencies)

    @cached_property
    def sha256(self) -> str:
        """The name of the grid on the wire."""
        return grid_digest(self.frequencies)

    def on_the_wire(self, address: Address) -> Grid:
        """The grid in a request: in full, or its digest where this replica can be expected to know it."""
        first_use = address not in self._used_at
        self._used_at.add(address)
        if self.in_full or (first_use and len(self) <= _IN_FULL_ONCE):
            return self.frequencies
        return GridDigest(sha256=self.sha256)


class GridMemory:
    """The grids that were checked and digested a moment ago: comparing 2 MB is ten times faster than hashing them.

    The user's array may change between calls, so it is compared with a copy, never recognised by identity.
    """

    def __init__(self) -> None:
        self._recent: tuple[ExplicitGrid, ...] = ()

    def recall(self, grid: GridLike) -> UniformGrid | ExplicitGrid:
        """Check a grid, or recognise it; errors are those of :func:`as_frequencies`."""
        plain = plain_grid(grid)
        if isinstance(plain, UniformGrid):
            return plain
        content = plain.tobytes()  # compared in 0.1 us, where comparing numbers takes 1
        for known in self._recent:
            if known.content == content:
                return known
        checked = ExplicitGrid(as_frequencies(plain))
        self._recent = (checked, *self._recent[: _REMEMBERED - 1])
        return checked


def _ends_of(grid: UniformGrid | ExplicitGrid) -> ExplicitGrid:
    """The first and the last frequency alone, on which the checks of a batch depend."""
    places = [0] if len(grid) == 1 else [0, len(grid) - 1]
    if isinstance(grid, UniformGrid):
        return ExplicitGrid(grid.at(np.array(places)))
    return ExplicitGrid(grid.frequencies[places])


@dataclass(eq=False)
class Waveforms(Question):
    """The waveforms of a batch on a grid; not frozen, which would take 2 us for every waveform."""

    batch: ParameterBatch
    grid: UniformGrid | ExplicitGrid
    output: OutputName
    dtype: DtypeName
    options: EvaluationOptions
    finish: Callable[[Arrays], Arrays]
    """Turns the arrays of any number of rows, read-only as they arrive, into those to keep."""
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
        frequencies = len(self.grid)
        return max(1, min(self.chunk_samples // frequencies, limits.rows_per_request(frequencies)))

    def encode(self, start: int, stop: int, address: Address | None) -> bytes:
        """As :class:`Question`, with the grid in the shortest form that the service understands."""
        grid: Any = self.grid
        if isinstance(grid, ExplicitGrid) and address is not None:
            grid = grid.on_the_wire(address)
        elif isinstance(grid, ExplicitGrid):
            grid.in_full = grid.in_full or len(grid) <= _IN_FULL_ONCE  # short enough not to try again each time
            grid = grid.frequencies
        part = self.batch.rows(slice(start, stop))
        request = WaveformRequest(batch=part, grid=grid, output=self.output, dtype=self.dtype, options=self.options)
        return encode_request(request)

    def max_bytes(self, rows: int) -> int:
        """As :class:`Question`."""
        return rows * (len(self.grid) * _BYTES_PER_SAMPLE + _BYTES_PER_ROW)

    def decode(self, body: bytes | memoryview, rows: int, where: str, model: ModelIdentity) -> Arrays:
        """As :class:`Question`."""
        answer = decode_answer(body)
        check_model(answer.model, where, model)
        _check_arrays(answer.arrays, self.output, self.dtype, rows, len(self.grid))
        return self.finish(answer.arrays)

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
        return replace(self, grid=_ends_of(self.grid), chunk_samples=_ANY_SIZE)

    def smaller_may_pass(self, limits: Limits) -> bool:
        """As :class:`Question`."""
        return len(self.grid) <= limits.max_frequencies


class RemoteModel:
    """Conversations about one pinned model; every argument is that of :class:`bnserve_protocol.WaveformModel`."""

    def __init__(self, settings: Settings, pinned: Pinned) -> None:
        self.settings = settings
        self.pinned = pinned
        self._grids = GridMemory()
        self.evaluator = Evaluator(Session(settings), pinned)
        self._strain: OutputName = "factored" if len(pinned.description.modes) == 1 else "polarizations"

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
        question = self._question(frequencies, batch, self._strain, options, dtype, multiply_out)
        arrays = yield from self.evaluator.evaluate(question)
        return Polarizations(**arrays)

    def predict_modes(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Modes]:
        """N waveforms by their modes."""
        one = yield from self.predict_factored(frequencies, batch, options, dtype)
        return Modes.of_one(self.pinned.description.modes[0], one)

    def predict_factored(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, dtype: DTypeLike
    ) -> Conversation[Factored]:
        """N waveforms before the polarisations are multiplied out."""
        question = self._question(frequencies, batch, "factored", options, dtype, own)
        arrays = yield from self.evaluator.evaluate(question)
        return Factored(**arrays)

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
    ) -> Conversation[AmplitudePhase]:
        """Amplitude and phase."""
        question = self._question(frequencies, batch, "amplitude_phase", options, "complex128", own)
        arrays = yield from self.evaluator.evaluate(question)
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

    def _question(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        output: OutputName,
        options: EvaluationOptions,
        dtype: DTypeLike,
        finish: Callable[[Arrays], Arrays],
    ) -> Waveforms:
        check_options(options)
        if options.modes is not None:
            options = self._plain(options)
        precision = check_dtype(dtype)
        grid = self._grids.recall(frequencies)
        chunk = self.settings.chunk_samples
        return Waveforms(ParameterBatch.coerce(batch), grid, output, precision, options, finish, chunk)

    def _plain(self, options: EvaluationOptions) -> EvaluationOptions:
        """Without modes that are all there are, which a service of before need not understand."""
        known = self.pinned.description.modes
        return msgspec.structs.replace(options, modes=None) if chosen_modes(options, known) == tuple(known) else options


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


def _check_arrays(arrays: Arrays, output: OutputName, dtype: DtypeName, rows: int, frequencies: int) -> None:
    """Refuse an answer whose arrays are not those that were asked for."""
    samples = np.dtype(np.float64 if output == "amplitude_phase" else dtype)
    wanted = {**dict.fromkeys(_SAMPLES[output], samples), **_OF_A_ROW, **(_FACTORS if output == "factored" else {})}
    for name, kind in wanted.items():
        array, shape = arrays.get(name), (rows, frequencies) if name in _SAMPLES[output] else (rows,)
        if array is None and name == "estimated_mismatch":
            continue
        if array is None or array.dtype != kind or array.shape != shape:
            raise AnswerCorrupted(f"The answer does not hold '{name}' as {kind.name} of shape {shape}.")


def own(arrays: Arrays) -> Arrays:
    """All arrays that belong to a result, writable; copies of those that are not."""
    return {name: array if array.flags.writeable else _copy(array) for name, array in arrays.items() if name in _KEPT}


def _copy(array: NDArray[Any]) -> NDArray[Any]:
    copy = result_memory.like(array)
    copy[...] = array
    return copy


def multiply_out(arrays: Arrays) -> Arrays:
    """``plus``, ``cross`` and what belongs to a row from a factored answer, or from one that has them already."""
    of_a_row = {name: arrays[name] for name in _OF_A_ROW if name in arrays}
    if "h" not in arrays:
        return own({"plus": arrays["h_plus"], "cross": arrays["h_cross"], **of_a_row})
    h = arrays["h"]
    factored = Factored(h=h, plus=arrays["plus"], cross=arrays["cross"], status=arrays["status"])
    plus = h if h.flags.writeable else result_memory.like(h)
    both = factored.polarizations(plus=plus, cross=result_memory.like(h))
    return {"plus": both.plus, "cross": both.cross, **own(of_a_row)}
