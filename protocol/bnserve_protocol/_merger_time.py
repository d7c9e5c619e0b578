"""The time between frequencies and the merger, from the phase of any waveform model."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol._batches import BatchLike, ParameterBatch
from bnserve_protocol._errors import FieldError, OutOfBand
from bnserve_protocol._grids import GridLike, any_frequencies
from bnserve_protocol._options import EvaluationOptions
from bnserve_protocol._parameters import PARAMETER_NAMES, ParametersWithExtrinsic

if TYPE_CHECKING:
    from bnserve_protocol._model import ModelDescription, WaveformModel

_STEP = 1e-3
"""Relative spacing of the stencil: truncation below 1e-9, rounding below a nanosecond above 1 Hz."""
_AROUND = ((-2.0, -1.0, 1.0, 2.0), (1.0, -8.0, 8.0, -1.0))
_UP_TO = ((-4.0, -3.0, -2.0, -1.0, 0.0), (3.0, -16.0, 36.0, -48.0, 25.0))
"""Places in units of the spacing, and weights of twelve derivatives of fourth order: central, and from below."""
_EDGE = 1e-9
"""So far above the band, relative, a frequency is still at its top: it may have been computed from it."""
_SHIFTS = [PARAMETER_NAMES.index("reference_phase"), PARAMETER_NAMES.index("time_shift")]


@dataclasses.dataclass(frozen=True, slots=True)
class MergerStencil:
    """Where to ask for a phase, and how to read its derivative at ``frequency`` (Hz), one or an array, from the answer.

    The five-point central difference; with ``from_below``, the five-point difference of ``frequency`` and four below
    it, because a model's phase ends at the top of its band.

    Raises
    ------
    InvalidFrequencies
        A frequency is not positive and finite.
    """

    frequency: ArrayLike
    from_below: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "frequency", any_frequencies(self.frequency))

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """The n frequencies of each stencil in Hz, (..., n): four around the one given, or five up to it."""
        given: NDArray[np.float64] = np.asarray(self.frequency)
        return given[..., None] * (1.0 + _STEP * np.array(self._rule[0]))

    def slope(self, phase: NDArray[np.float64]) -> NDArray[np.float64]:
        """d phase / d f in radians per Hz, shape (...,), from the phase (radians) on the stencil, (..., n)."""
        given: NDArray[np.float64] = np.asarray(self.frequency)
        weighted = [weight * phase[..., place] for place, weight in enumerate(self._rule[1])]
        return np.asarray(sum(weighted) / (12.0 * _STEP * given))

    @property
    def _rule(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        return _UP_TO if self.from_below else _AROUND


class MergerTimes:
    """The question to a model, and how to read its answer, for the times from frequencies (Hz) to the merger.

    In the stationary-phase approximation the (2, 2) mode passes f at t(f) = -(1/2 pi) d phase / d f; aligned at the
    merger, the merger is at t = 0. Whoever cannot call :func:`time_until_merger` (an asynchronous model) evaluates the
    phase of :attr:`batch` on :attr:`grid` with :attr:`options`, once, and hands it to :meth:`seconds`.

    Parameters
    ----------
    description
        Of the model: its band.
    frequencies
        One, or M in any order.
    parameters
        One ``ParametersWithExtrinsic``, or a batch of N. Their shifts of time and phase do not matter.

    Raises
    ------
    InvalidFrequencies
        A frequency is not positive and finite, or there is none.
    InvalidParameters
        No binaries.
    OutOfBand
        A frequency is above the model's band at the mass of a binary.
    """

    options = EvaluationOptions(alignment="merger", modes=((2, 2),))

    def __init__(self, description: ModelDescription, frequencies: GridLike, parameters: BatchLike) -> None:
        given = any_frequencies(frequencies)
        batch = ParameterBatch.coerce(parameters)
        rows = () if isinstance(parameters, ParametersWithExtrinsic) else (len(batch),)
        self._shape = (*rows, *given.shape)
        f, mass = given.reshape(-1), batch["total_mass"][:, None]
        top = description.training_band[1] * description.reference_mass
        _refuse_above(f, mass, top)
        self._around, self._up_to = MergerStencil(f), MergerStencil(f, from_below=True)
        self._reaches_over = self._around.frequencies[:, -1] * mass > top
        """Whether the stencil around a frequency does, (N, M)."""
        over = self._reaches_over.any(axis=0)
        around = ~over | ~self._reaches_over.all(axis=0)
        asked = (self._around.frequencies[around], self._up_to.frequencies[over])
        self.grid: NDArray[np.float64] = np.unique(np.concatenate([part.ravel() for part in asked]))
        """Hz, increasing, (K,)."""
        values = batch.values.copy()
        values[:, _SHIFTS] = 0.0  # they would only cost digits
        self.batch = ParameterBatch.unchecked(values)
        """The binaries, (N,), without their shifts; as their modes in the frame of the orbit, if it precesses."""

    def seconds(self, phase: NDArray[np.float64]) -> NDArray[np.float64]:
        """The times in seconds from the phase (radians) of the batch on the grid, (N, K): the shape of the parameters
        and that of the frequencies, ``()``, ``(M,)``, ``(N,)`` or ``(N, M)``."""
        slopes = [
            stencil.slope(phase[:, np.minimum(np.searchsorted(self.grid, stencil.frequencies), len(self.grid) - 1)])
            for stencil in (self._around, self._up_to)
        ]
        return np.asarray(np.where(self._reaches_over, slopes[1], slopes[0]) / (2.0 * np.pi)).reshape(self._shape)


def _refuse_above(f: NDArray[np.float64], mass: NDArray[np.float64], top: float) -> None:
    above = f * mass > top * (1.0 + _EDGE)
    if above.any():
        row, place = (int(found[0]) for found in np.nonzero(above))
        raise OutOfBand(
            f"Row {row}: {f[place]:.6g} Hz is above the model's band, which ends at {top / mass[row, 0]:.6g} Hz at "
            f"total mass {mass[row, 0]:g} Msun: there is no time from there to the merger.",
            errors=[FieldError(reason="above the band", parameter="frequencies", row=row, value=float(f[place]))],
        )


@overload
def time_until_merger(model: WaveformModel, frequency: float, parameters: ParametersWithExtrinsic) -> float: ...
@overload
def time_until_merger(
    model: WaveformModel, frequency: GridLike, parameters: BatchLike
) -> float | NDArray[np.float64]: ...
def time_until_merger(model: WaveformModel, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]:
    """Seconds from the moments that the signal passes frequencies (Hz) to the merger; see :class:`MergerTimes`.

    One question to the model, whatever the sizes: a number, ``(M,)``, ``(N,)`` or ``(N, M)``.

    Raises
    ------
    OutOfBand
        A frequency is above the model's band.
    """
    times = MergerTimes(model.description, frequency, parameters)
    answer = model.predict_amplitude_phase(times.grid, times.batch, options=times.options)
    seconds = times.seconds(answer.phase)
    return seconds if seconds.ndim else float(seconds)
