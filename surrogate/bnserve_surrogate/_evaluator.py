"""From what a caller gives to what the kernel reads, and back.

Phases go on above the trained band, where the strain is zero: as straight lines, so that no difference sees an edge.
"""

from __future__ import annotations

import math
import operator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_protocol import (
    PARAMETER_NAMES,
    SOLAR_MASS_SECONDS,
    BatchLike,
    EvaluationOptions,
    GridLike,
    InvalidRequest,
    MergerStencil,
    Mode,
    ParameterBatch,
    ParameterDescription,
    ParametersWithExtrinsic,
    Polarizations,
    RowStatus,
    TooLarge,
    check_options,
    chosen_modes,
    the_mode,
    turn_to_reference,
)
from bnserve_protocol.wire import address_of, result_memory
from bnserve_surrogate._domain import NEAR, refuse_overflow, refuse_reference_above, refuse_rows
from bnserve_surrogate._mode_phases import ModePhases
from bnserve_surrogate._one_row import FEW, OneRow
from bnserve_surrogate.kernel import (
    EDGE,
    LEAST_MF,
    KernelModel,
    KernelModes,
    ModePlan,
    Output,
    Outputs,
    Policy,
    evaluate,
    plan_modes,
)
from bnserve_surrogate.kernel._evaluate import GridCache, PreparedGrid, is_list

_ALIGNMENTS = {"post_newtonian": 0, "merger": 1}
_KINDS = {"complex128": Output.POLARIZATIONS, "complex64": Output.POLARIZATIONS_SINGLE}
_DTYPES = {
    Output.STRAIN: "complex128",
    Output.STRAIN_SINGLE: "complex64",
    Output.POLARIZATIONS: "complex128",
    Output.POLARIZATIONS_SINGLE: "complex64",
    Output.AMPLITUDE_PHASE: "float64",
}
_TILE = 8
"""Rows that the kernel takes together; so many complex numbers fill whole cache lines."""
_WORTH_A_THREAD = 20_000
"""Values below which a batch is not divided among threads."""
_PIECES = 4
"""Into so many pieces for each thread a batch is divided."""
_CARRIER: tuple[Mode, ...] = ((2, 2),)
_MOST_PLANS = 64
"""Different choices of modes that are remembered; there are thousands."""
_DISTANCE = PARAMETER_NAMES.index("distance_mpc")
_values_of = operator.attrgetter(*PARAMETER_NAMES)
_TOTAL_MASS, _PHASE, _TIME = (PARAMETER_NAMES.index(name) for name in ("total_mass", "reference_phase", "time_shift"))
Floats = NDArray[np.float64]


class Answer(NamedTuple):
    """What the kernel wrote for N rows on M frequencies."""

    first: NDArray[Any]
    second: Any
    plus: Floats
    cross: NDArray[np.complex128]
    status: NDArray[np.uint8]
    estimates: Floats | None


class Asked(NamedTuple):
    """What the compiled derivatives of modes are told, forwards and backwards, before what was evaluated."""

    mode: KernelModel
    grid: PreparedGrid
    values: Floats
    alignment: int
    plan: ModePlan | None


class _NotYet:
    """No plan, where None is one."""


_NOT_YET = _NotYet()


class Evaluator:
    """The modes of a model on prepared grids.

    Parameters
    ----------
    modes
        Kernel arrays.
    ranges
        Unit and trained range of every parameter.
    mass
        Solar masses at which phases are continued above the band: at one for all, so that bits do not depend on it.
    threads
        Among how many threads a large batch is divided.
    """

    def __init__(self, modes: KernelModes, ranges: list[ParameterDescription], mass: float, threads: int = 1) -> None:
        self._kernel_modes, self._mode = modes, modes.carrier
        self.modes: tuple[Mode, ...] = (*_CARRIER, *modes.ratios)
        self._plans: dict[tuple[Mode, ...] | None, ModePlan | None] = {}
        self._ranges = ranges
        self._mass = mass
        self._grids = GridCache()
        self._one_row = OneRow(len(self.modes))
        self._threads = threads
        self._pool = ThreadPoolExecutor(threads - 1, "bnserve-evaluation") if threads > 1 else None

    def one(
        self,
        frequencies: NDArray[Any],
        parameters: ParametersWithExtrinsic,
        options: EvaluationOptions,
        dtype: DTypeLike,
    ) -> Polarizations | None:
        """One waveform on a grid that is prepared already, the shortest way; None if anything about it is unusual."""
        name = dtype if isinstance(dtype, str) else ""
        kind = _KINDS.get(name)
        usual = type(options) is EvaluationOptions and options.reference_frequency is None
        if kind is None or not usual or not is_list(frequencies):
            return None
        plan = self._plans.get(options.modes, _NOT_YET)
        if isinstance(plan, _NotYet):
            return None
        points = len(frequencies)
        grid = self._grids.candidate(frequencies)
        if grid is None or not frequencies.flags.c_contiguous:
            return None
        room = self._one_row
        try:
            room.parameters[:] = list(_values_of(parameters))
        except TypeError:
            return None
        if parameters.chi_1x or parameters.chi_1y or parameters.chi_2x or parameters.chi_2y:
            return None
        if room.parameters[_DISTANCE] < NEAR:
            return None
        few = points <= FEW
        if few:
            room.frequencies[:points] = frequencies
            given, results, first = room.frequencies_at, room.results[name], room.results_at
        else:
            given, results = address_of(frequencies), result_memory.empty((2, points + -points % _TILE), name)
            first = address_of(results)
        estimate = room.estimate if (self._mode if plan is None else plan).estimates_mismatch else 0
        outputs = Outputs(kind, first, first + results.strides[0], room.plus, room.cross, room.status, estimate)
        policy = _policy(options) | Policy.STOP_AT_BAD_ROWS
        alignment = _ALIGNMENTS[options.alignment]
        if evaluate(self._mode, grid, 1, room.parameters_at, alignment, policy, outputs, given, plan) != 0:
            return None
        plus, cross = results[:, :points].copy() if few else results[:, :points]
        estimates = np.array((room.rest[0],)) if estimate else None
        return Polarizations(plus, cross, np.zeros(1, np.uint8), estimates)

    def frequencies(self, grid: GridLike) -> NDArray[np.float64]:
        """The frequencies of a grid as they are prepared, in Hz, ``(M,)``; errors as :meth:`batch`."""
        return self._grids.prepare(grid).frequencies

    def batch(self, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions, kind: Output) -> Answer:
        """N waveforms, their modes summed or, of the strain, one by one.

        Raises
        ------
        InvalidParameters, OutOfDomain, InvalidFrequencies, OutOfBand
            As :meth:`~bnserve_surrogate.Model.predict`.
        InvalidRequest
            ``options`` are none, or name a mode that is not there, or several where one has to be.
        TooLarge
            More than there is memory for.
        """
        check_options(options)
        plan = self._plan(options)
        coerced = ParameterBatch.coerce(batch)
        if coerced.in_plane is not None:
            raise InvalidRequest(
                "The modes of a binary with spins in the orbital plane precess: they have no factors of one "
                "inclination, no one amplitude and phase. Ask for predict or predict_batch, or leave out chi_1x, "
                "chi_1y, chi_2x and chi_2y."
            )
        try:
            grid = self._grids.prepare(frequencies)
            if options.reference_frequency is not None:
                coerced = self._referenced(coerced, options)
            if kind is Output.AMPLITUDE_PHASE and plan is not None:
                return self._amplitude_phase(grid, coerced, options, plan)
            return self._batch(grid, coerced, options, kind, plan)
        except MemoryError as error:
            raise TooLarge(
                f"There is no memory for {len(coerced)} waveforms on so many frequencies; evaluate fewer rows at a "
                'time, on fewer frequencies, or with dtype="complex64".'
            ) from error

    def asked(self, frequencies: GridLike, batch: ParameterBatch, options: EvaluationOptions) -> Asked:
        """What derivatives of the modes that :meth:`batch` evaluates are told; errors as there.

        Those of the reference phase are not among them: it is that of the batch, whatever the options say.
        """
        grid, plan = self._grids.prepare(frequencies), self._plan(options)
        if options.reference_frequency is not None:
            batch = self._referenced(batch, options)
        return Asked(self._mode, grid, batch.values, _ALIGNMENTS[options.alignment], plan)

    def _plan(self, options: EvaluationOptions) -> ModePlan | None:
        """How the modes of some options are evaluated; None for the (2, 2) alone."""
        plan = self._plans.get(options.modes, _NOT_YET)
        if isinstance(plan, _NotYet):
            chosen = chosen_modes(options, self.modes)
            plan = None if chosen == _CARRIER else plan_modes(self._kernel_modes, chosen)
            if len(self._plans) >= _MOST_PLANS:
                self._plans.clear()
            self._plans[options.modes] = plan
        return plan

    def _batch(
        self,
        grid: PreparedGrid,
        coerced: ParameterBatch,
        options: EvaluationOptions,
        kind: Output,
        plan: ModePlan | None = None,
    ) -> Answer:
        rows, points, modes = len(coerced), len(grid.frequencies), 1 if plan is None else len(plan.modes)
        two = kind not in (Output.STRAIN, Output.STRAIN_SINGLE)
        shape = (rows, points) if two or plan is None else (rows, modes, points)
        arrays = [result_memory.empty(shape, _DTYPES[kind]) for _ in range(1 + two)]
        second = arrays[1] if two else None
        # One block, because finding out an address takes longer than a copy.
        of_rows, factors = np.empty((2 + 3 * modes) * rows), rows * modes
        plus, cross = of_rows[:factors], of_rows[factors : 3 * factors].view(np.complex128)
        if plan is not None:
            plus, cross = plus.reshape(rows, modes), cross.reshape(rows, modes)
        estimating = (self._mode if plan is None else plan).estimates_mismatch
        estimates = of_rows[3 * factors : 3 * factors + rows] if estimating else None
        status = of_rows[3 * factors + rows :].view(np.uint8)[:rows]
        first_at, second_at, at = (
            address_of(arrays[0]),
            0 if second is None else address_of(second),
            address_of(of_rows),
        )
        after = at + 24 * factors
        estimates_at = 0 if estimates is None else after
        outputs = Outputs(kind, first_at, second_at, at, at + 8 * factors, after + 8 * rows, estimates_at, modes)
        row_bytes = arrays[0].itemsize * math.prod(shape[1:])
        bad = self._run(grid, coerced, options, outputs, row_bytes, plan)
        if bad and options.out_of_domain == "error":
            least = LEAST_MF if plan is None else plan.least_mf
            refuse_rows(coerced, status, grid.frequencies, self._ranges, self._mode.mf_band, least)
        if (coerced.values[:, _DISTANCE] < NEAR).any():
            numbers = [plus, cross] if estimates is None else [plus, cross, estimates]
            refuse_overflow(coerced, arrays, numbers, status, options)
        if kind is Output.AMPLITUDE_PHASE:
            self._continue(arrays[1], grid.frequencies, coerced, options, status == RowStatus.OK)
        return Answer(arrays[0], second, plus, cross, status, estimates)

    def _amplitude_phase(
        self, grid: PreparedGrid, batch: ParameterBatch, options: EvaluationOptions, plan: ModePlan
    ) -> Answer:
        """Amplitude and phase of a mode other than the (2, 2)."""
        if len(plan.modes) > 1:
            the_mode(options, self.modes)  # says so
        answer = self._batch(grid, batch, options, Output.STRAIN, plan)
        kept = EvaluationOptions(out_of_domain="flag", alignment=options.alignment)

        def carrier(f: Floats, rows: ParameterBatch) -> Floats:
            scaled = self._grids.prepare(f * (2.0 / plan.modes[0][1]))
            phase: Floats = self._batch(scaled, rows, kept, Output.AMPLITUDE_PHASE).second
            return phase * (0.5 * plan.modes[0][1])

        def strain(f: Floats, rows: ParameterBatch) -> NDArray[np.complex128]:
            return self._batch(self._grids.prepare(f), rows, kept, Output.STRAIN, plan).first[:, 0]

        band = plan.ratio_band[0], self._mode.mf_band[1]
        h, phases = answer.first[:, 0], ModePhases(carrier, strain, band, self._mass)
        phase = phases.continuous(grid.frequencies, batch, h)
        return answer._replace(first=np.abs(h), second=phase, plus=answer.plus[:, 0], cross=answer.cross[:, 0])

    def _referenced(self, batch: ParameterBatch, options: EvaluationOptions) -> ParameterBatch:
        """The same binaries with a ``reference_phase`` that gives them the one they have at the reference frequency.

        Rows that are not evaluated are left as they are.
        """
        frequency = float(options.reference_frequency or 0.0)
        values = batch.values.copy()
        values[:, [_PHASE, _TIME]] = 0.0
        grid = self._grids.prepare(np.array([frequency]))
        kept = EvaluationOptions(out_of_domain="flag", alignment=options.alignment)
        there = self._batch(grid, ParameterBatch(values), kept, Output.AMPLITUDE_PHASE)
        values[:, [_PHASE, _TIME]] = batch.values[:, [_PHASE, _TIME]]
        found = there.status == RowStatus.OK
        if (there.status == RowStatus.OUT_OF_BAND).any():
            raise InvalidRequest(
                f"At a reference_frequency of {frequency:g} Hz a phase exceeds double precision; use a higher one."
            )
        refuse_reference_above(batch, found, frequency, self._mode.mf_band[1])
        # A period of 4 pi, so that the phases of all modes keep their digits.
        values[found, _PHASE] += np.remainder(turn_to_reference(there.second[found, 0]), 4.0 * np.pi)
        return ParameterBatch(values)

    def _continue(
        self, phase: Floats, f: Floats, batch: ParameterBatch, options: EvaluationOptions, evaluated: NDArray[np.bool_]
    ) -> None:
        """Write into ``phase`` what stands above the band: the line with its value and slope at the top.

        What is written at a frequency does not depend on the other frequencies. The line is found at one mass, at one
        place for all rows, because a phase is a function of total mass times frequency but for its shifts. Rows that
        were not ``evaluated``, (N,), are left as they are.
        """
        mass, values = self._mass, batch.values
        top = self._mode.mf_band[1] / (mass * SOLAR_MASS_SECONDS)
        if f[-1] * values[:, _TOTAL_MASS].max(initial=0.0) <= top * mass:  # nearly always, and quick
            return
        scale = values[:, _TOTAL_MASS] / mass
        rows = np.flatnonzero(evaluated & (f[-1] * scale > top * (1.0 + EDGE)))
        if not len(rows):
            return
        stencil = MergerStencil(top, from_below=True)
        own, unshifted = values[rows], values[rows]
        unshifted[:, _TOTAL_MASS] = mass
        unshifted[:, [_PHASE, _TIME]] = 0.0
        # This ends at the top of the band, and is not continued again.
        grid = self._grids.prepare(stencil.frequencies)
        below = self._batch(grid, ParameterBatch(unshifted), options, Output.AMPLITUDE_PHASE).second
        slope = stencil.slope(below)
        constant = below[:, -1] - slope * top + own[:, _PHASE]
        gradient = slope * scale[rows] + 2.0 * np.pi * own[:, _TIME]
        firsts = np.searchsorted(f, top * (1.0 + EDGE) / scale[rows], side="right")
        for row, first, offset, factor in zip(rows, firsts, constant, gradient, strict=True):
            line = np.multiply(f[first:], factor, out=phase[row, first:])
            line += offset

    def _run(
        self,
        grid: PreparedGrid,
        batch: ParameterBatch,
        options: EvaluationOptions,
        outputs: Outputs,
        row_bytes: int,
        plan: ModePlan | None,
    ) -> int:
        """Evaluate a batch, in pieces if there are threads for them; the number of rows that were not evaluated."""
        policy = _policy(options)
        if options.out_of_domain == "error":
            policy |= Policy.STOP_AT_BAD_ROWS
        alignment = _ALIGNMENTS[options.alignment]
        rows, parameters = len(batch), address_of(batch.values)
        row_parameters = batch.values.strides[0] if rows else 0

        def piece(start: int, stop: int) -> int:
            own = outputs.shifted(start, row_bytes)
            at = parameters + start * row_parameters
            return evaluate(self._mode, grid, stop - start, at, alignment, policy, own, 0, plan)

        if self._pool is None or rows <= _TILE or rows * outputs.modes * len(grid.frequencies) < _WORTH_A_THREAD:
            return piece(0, rows)
        size = -(-rows // (self._threads * _PIECES * _TILE)) * _TILE
        starts = iter(range(0, rows, size))  # taken in turns, so that nobody waits for a thread that is slow to wake

        def pieces() -> int:
            return sum(piece(start, min(start + size, rows)) for start in starts)

        others = [self._pool.submit(pieces) for _ in range(self._threads - 1)]
        bad = pieces()
        return bad + sum(other.result() for other in others if not other.cancel())


def _policy(options: EvaluationOptions) -> int:
    below = Policy.BELOW_BAND_IS_ERROR if options.below_band == "error" else 0
    return below | (Policy.ABOVE_BAND_IS_ERROR if options.above_band == "error" else 0)
