"""Source of the fused kernel: from parameters to strain, one row at a time. Compiled ahead by :mod:`.build`.

A row is evaluated by the same sequence of operations wherever it stands in a batch, whatever its neighbours and
whichever thread runs it, so its bits depend on the row, the grid and the model alone. Plain loops over flat arrays,
no allocation: that is what the compiler turns into vector instructions and what needs no Python to run.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import (
    AMPLITUDE_POWERS,
    FREEZING_END,
    FREEZING_START,
    FROZEN_AMPLITUDE,
    amplitude_coefficients,
    amplitude_prefactor,
    mass_scale,
    phase_coefficients,
)
from bnserve_surrogate.kernel._layout import BLOCK, MAX_DEGREE, MAX_WIDTH, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS, exponential, sincos
from bnserve_surrogate.kernel._regression import regress

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_MASS_RATIO, _LAMBDA_1, _LAMBDA_2, _CHI_1, _CHI_2, _DISTANCE, _, _TOTAL_MASS, _REFERENCE_PHASE, _TIME_SHIFT = range(10)
_COLUMNS = 10

_EDGE = 1e-9
"""Relative width by which a frequency may miss the band's edge through rounding and still be inside."""
_LOG_PI_THIRD = float(np.log(np.pi) / 3.0)
_STRAIN = SOLAR_MASS_SECONDS**2 / MEGAPARSEC_SECONDS
"""(G Msun / c^3)^2 over one Mpc / c: strain in 1/Hz of a face-on source with nu A = 1 at one solar mass and one Mpc."""

# The places of the table of contents as plain integers: what the compiler takes for constants.
_OUTPUTS, _AMPLITUDE_NODES, _PHASE_NODES = int(Entry.OUTPUTS), int(Entry.AMPLITUDE_NODES), int(Entry.PHASE_NODES)
_SYNTHESIS_AT, _BAND_AT = int(Entry.SYNTHESIS_AT), int(Entry.BAND_AT)
_AMPLITUDE_KNOTS_AT, _PHASE_KNOTS_AT = int(Entry.AMPLITUDE_KNOTS_AT), int(Entry.PHASE_KNOTS_AT)
_REGRESSION_SCRATCH = 5 * (MAX_DEGREE + 2) + 2 * MAX_WIDTH


@njit(**JIT_OPTIONS)
def first_above(values: Floats, start: int, stop: int, bound: float) -> int:
    """First index in [start, stop) whose value is above ``bound``, or ``stop``; galloping, as it is usually near."""
    step = 1
    low = start
    high = start
    while high < stop and values[high] <= bound:
        low = high + 1
        high += step
        step *= 2
    if high > stop:
        high = stop
    while low < high:
        middle = (low + high) // 2
        if values[middle] <= bound:
            low = middle + 1
        else:
            high = middle
    return low


@njit(**JIT_OPTIONS)
def _synthesize(outputs: Floats, synthesis: Floats, result: Floats) -> None:
    """Everything that is linear in the regressor's outputs: the mean plus each output times its row."""
    width = result.shape[0]
    for j in range(width):
        result[j] = synthesis[j]
    for k in range(outputs.shape[0]):
        row = synthesis[(k + 1) * width : (k + 2) * width]
        y = outputs[k]
        for j in range(width):
            result[j] += y * row[j]


@njit(**JIT_OPTIONS)
def _spline(log_f: Floats, shift: float, knots: Floats, values: Floats, curvatures: Floats, out: Floats) -> None:
    """Cubic spline in log(M f) at ``log_f + shift``, cell by cell; the end cells extend outwards."""
    cells = knots.shape[0] - 1
    stop = log_f.shape[0]
    start = 0
    for cell in range(cells):
        if start == stop:
            break
        if cell < cells - 1:
            if log_f[start] > knots[cell + 1] - shift:
                continue
            end = first_above(log_f, start, stop, knots[cell + 1] - shift)
        else:
            end = stop
        width = knots[cell + 1] - knots[cell]
        c0 = values[cell]
        c1 = (values[cell + 1] - c0) / width - width * (2.0 * curvatures[cell] + curvatures[cell + 1]) / 6.0
        c2 = 0.5 * curvatures[cell]
        c3 = (curvatures[cell + 1] - curvatures[cell]) / (6.0 * width)
        offset = shift - knots[cell]
        x = log_f[start:end]
        y = out[start:end]
        for j in range(y.shape[0]):
            t = x[j] + offset
            y[j] = c0 + t * (c1 + t * (c2 + t * c3))
        start = end


@njit(**JIT_OPTIONS)
def _zeta(x: float) -> float:
    """Smooth step of the paper (section "High frequency bound"): 0 at x = 0, 1 at x = 1, flat at both."""
    return 0.5 * (1.0 - sincos(np.pi * x)[1])


@njit(**JIT_OPTIONS)
def _scale_amplitude(f: Floats, cbrt_f: Floats, mass: float, series: Floats, scale: float, values: Floats) -> None:
    """Turn residual log-amplitudes into amplitudes over the baseline, frozen from M f = 0.01 to 0.02."""
    velocity_scale = (np.pi * mass) ** (1.0 / 3.0)
    n = values.shape[0]
    freezing = first_above(f, 0, n, FREEZING_START / mass)
    frozen = first_above(f, freezing, n, FREEZING_END / mass)
    # Local variables: the loops must not depend on memory that their own stores might overlap.
    c0, c1, c2, c3 = scale * series[0], scale * series[1], scale * series[2], scale * series[3]
    c4, c5, c6, c7 = scale * series[4], scale * series[5], scale * series[6], scale * series[7]
    constant = scale * FROZEN_AMPLITUDE
    for j in range(freezing):
        v = cbrt_f[j] * velocity_scale
        inverse = 1.0 / v
        bare = c0 + v * (c1 + v * (c2 + v * (c3 + v * (c4 + v * (c5 + v * (c6 + v * c7))))))
        values[j] = exponential(values[j]) * (bare * (inverse * inverse * inverse * np.sqrt(inverse)))
    for j in range(freezing, frozen):
        v = cbrt_f[j] * velocity_scale
        inverse = 1.0 / v
        bare = c0 + v * (c1 + v * (c2 + v * (c3 + v * (c4 + v * (c5 + v * (c6 + v * c7))))))
        bare *= inverse * inverse * inverse * np.sqrt(inverse)
        zeta = _zeta((f[j] * mass - FREEZING_START) / (FREEZING_END - FREEZING_START))
        values[j] = exponential(values[j]) * (bare + zeta * (constant - bare))
    for j in range(frozen, n):
        values[j] = exponential(values[j]) * constant


@njit(**JIT_OPTIONS)
def _finish_phase(
    f: Floats, log_f: Floats, cbrt_f: Floats, mass: float, series: Any, constant: float, slope: float, values: Floats
) -> None:
    """Turn residual phases into phi = constant + slope * f - (TaylorF2 phase + residual)."""
    velocity_scale = (np.pi * mass) ** (1.0 / 3.0)
    log_shift = np.log(mass) / 3.0 + _LOG_PI_THIRD
    # Local variables: the loop must not depend on memory that its own stores might overlap.
    c0, c1, c2, c3 = series[0, 0], series[0, 1], series[0, 2], series[0, 3]
    c4, c5, c6, c7 = series[0, 4], series[0, 5], series[0, 6], series[0, 7]
    c8, c9, c10, c11 = series[0, 8], series[0, 9], series[0, 10], series[0, 11]
    c12, c13, c14, c15 = series[0, 12], series[0, 13], series[0, 14], series[0, 15]
    d5, d6, d7, d8 = series[1, 5], series[1, 6], series[1, 7], series[1, 8]
    d9, d10, d11 = series[1, 9], series[1, 10], series[1, 11]
    e8 = series[2, 8]
    for j in range(values.shape[0]):
        v = cbrt_f[j] * velocity_scale
        log_v = log_f[j] * (1.0 / 3.0) + log_shift
        high = c8 + v * (c9 + v * (c10 + v * (c11 + v * (c12 + v * (c13 + v * (c14 + v * c15))))))
        low = c0 + v * (c1 + v * (c2 + v * (c3 + v * (c4 + v * (c5 + v * (c6 + v * c7))))))
        logarithmic = d5 + v * (d6 + v * (d7 + v * (d8 + v * (d9 + v * (d10 + v * d11)))))
        cube = v * v * v
        inverse = 1.0 / v
        square = inverse * inverse
        baseline = low * (square * square * inverse) + high * cube + log_v * (logarithmic + log_v * (e8 * cube))
        values[j] = (constant + slope * f[j]) - (baseline + values[j])


@njit(**JIT_OPTIONS)
def _legendre(mf: float, series: Any) -> float:
    """Psi - f dPsi/df of the baseline: what a phase that starts from zero at ``mf`` has for a constant.

    In the stationary-phase approximation Psi(f) = 2 pi f t(f) - phi(t(f)), where 2 pi t(f) = dPsi/df, so the
    signal's phase phi is f dPsi/df - Psi.
    """
    v = (np.pi * mf) ** (1.0 / 3.0)
    log_v = np.log(v)
    result = 0.0
    power = v**-5
    for k in range(16):
        plain = series[0, k] + log_v * (series[1, k] + log_v * series[2, k])
        slope = (k - 5) * plain + series[1, k] + 2.0 * log_v * series[2, k]
        result += power * (plain - slope / 3.0)
        power *= v
    return result


@njit(**JIT_OPTIONS)
def _extend_below(
    f: Floats, mass: float, mf_min: float, edge_amplitude: float, edge_phase: float, slope: float, a: Floats, p: Floats
) -> None:
    """Residuals below the trained band: the amplitude's fades out over an octave, the phase's goes on linearly."""
    for j in range(a.shape[0]):
        mf = f[j] * mass
        ratio = 2.0 * mf / mf_min - 1.0
        a[j] = edge_amplitude * _zeta(ratio) if ratio > 0.0 else 0.0
        p[j] = edge_phase + slope * (mf - mf_min)


@njit(**JIT_OPTIONS)
def _block(
    f: Floats,
    log_f: Floats,
    cbrt_f: Floats,
    row: Floats,
    contents: Integers,
    weights: Floats,
    alignment: int,
    linear: Floats,
    phase_series: Any,
    amplitude_series: Floats,
    amplitude: Floats,
    phase: Floats,
) -> None:
    """Amplitude and phase of one prepared row on one block of frequencies; zero above the band."""
    stop = f.shape[0]
    mass = row[_TOTAL_MASS] * SOLAR_MASS_SECONDS
    mf_min, mf_max = weights[contents[_BAND_AT]], weights[contents[_BAND_AT] + 1]
    band_start = first_above(f, 0, stop, mf_min * (1.0 - _EDGE) / mass)
    band_stop = first_above(f, band_start, stop, mf_max * (1.0 + _EDGE) / mass)
    n_a, n_p = contents[_AMPLITUDE_NODES], contents[_PHASE_NODES]
    gauge = linear[2 * (n_a + n_p) :]
    phase_values = linear[2 * n_a : 2 * n_a + n_p]
    if band_start > 0:
        a, p = amplitude[:band_start], phase[:band_start]
        _extend_below(f[:band_start], mass, mf_min, linear[0], phase_values[0], -gauge[1], a, p)
    if band_start < band_stop:
        x = log_f[band_start:band_stop]
        shift = np.log(mass)
        knots = weights[contents[_AMPLITUDE_KNOTS_AT] : contents[_AMPLITUDE_KNOTS_AT] + n_a]
        _spline(x, shift, knots, linear[:n_a], linear[n_a : 2 * n_a], amplitude[band_start:band_stop])
        knots = weights[contents[_PHASE_KNOTS_AT] : contents[_PHASE_KNOTS_AT] + n_p]
        curvatures = linear[2 * n_a + n_p : 2 * (n_a + n_p)]
        _spline(x, shift, knots, phase_values, curvatures, phase[band_start:band_stop])
    scale = _STRAIN * mass_scale(row[_MASS_RATIO]) * (row[_TOTAL_MASS] * row[_TOTAL_MASS]) / row[_DISTANCE]
    _scale_amplitude(f, cbrt_f, mass, amplitude_series, scale, amplitude[:band_stop])
    constant = row[_REFERENCE_PHASE] - gauge[2 * alignment]
    start_mf = weights[contents[_BAND_AT] + 2]
    if alignment == 1 and start_mf > 0.0:
        constant += _legendre(start_mf, phase_series)
    slope = 2.0 * np.pi * row[_TIME_SHIFT] - gauge[2 * alignment + 1] * mass
    _finish_phase(f, log_f, cbrt_f, mass, phase_series, constant, slope, phase[:band_stop])
    for j in range(band_stop, stop):
        amplitude[j] = 0.0
        phase[j] = 0.0


@njit(**JIT_OPTIONS)
def _prepare(
    row: Floats,
    contents: Integers,
    exponents: Integers,
    weights: Floats,
    scratch: Floats,
    linear: Floats,
    phase: Any,
    amplitude: Floats,
) -> None:
    """What depends on the binary alone: linear synthesis and the baseline's coefficients."""
    q, chi_1, chi_2, lambda_1, lambda_2 = row[_MASS_RATIO], row[_CHI_1], row[_CHI_2], row[_LAMBDA_1], row[_LAMBDA_2]
    outputs = scratch[: contents[_OUTPUTS]]
    rest = scratch[contents[_OUTPUTS] :]
    regress(q, chi_1, chi_2, lambda_1, lambda_2, contents, exponents, weights, rest, outputs)
    _synthesize(outputs, weights[contents[_SYNTHESIS_AT] :], linear)
    phase_coefficients(q, chi_1, chi_2, lambda_1, lambda_2, phase)
    amplitude_coefficients(q, chi_1, chi_2, amplitude)
    prefactor = amplitude_prefactor(q)
    for k in range(AMPLITUDE_POWERS):
        amplitude[k] *= prefactor


@njit(**JIT_OPTIONS)
def _to_cartesian(amplitude: Floats, phase: Floats, out: Any) -> None:
    for j in range(out.shape[0]):
        sine, cosine = sincos(phase[j])
        out[j] = complex(amplitude[j] * cosine, amplitude[j] * sine)


@njit(**JIT_OPTIONS)
def evaluate(
    parameters: Floats,
    grid: tuple[Floats, Floats, Floats],
    model: tuple[Integers, Integers, Floats],
    alignment: int,
    scratch: Floats,
    phase_series: Any,
    wide: NDArray[np.complex128],
    narrow: NDArray[np.complex64],
    polar: tuple[Floats, Floats],
    estimates: Floats,
) -> None:
    """Evaluate every row into whichever of ``wide``, ``narrow`` and ``polar`` is not empty.

    Parameters
    ----------
    parameters:
        ``(N * 10,)``, a :class:`ParameterBatch`'s values row by row.
    grid:
        Frequencies in Hz, their logarithms and cube roots, ``(M,)`` each.
    model:
        Contents, exponents and weights of a :class:`KernelModel`.
    alignment:
        0: post-Newtonian, 1: merger.
    scratch:
        As much as ``KernelModel.scratch_size`` says.
    phase_series:
        ``(3, 16)`` of scratch for the baseline's phase.
    wide, narrow:
        ``(N * M,)``: h = A exp(i phi), without inclination.
    polar:
        A and phi, ``(N * M,)`` float64 each.
    estimates:
        ``(N,)`` for the estimated mismatches, or empty.
    """
    f, log_f, cbrt_f = grid
    contents, exponents, weights = model
    points = f.shape[0]
    prepare_end = contents[_OUTPUTS] + _REGRESSION_SCRATCH
    linear_end = prepare_end + 2 * (contents[_AMPLITUDE_NODES] + contents[_PHASE_NODES]) + 4
    series_end = linear_end + AMPLITUDE_POWERS
    linear, amplitude_series = scratch[prepare_end:linear_end], scratch[linear_end:series_end]
    polar_wanted = polar[0].shape[0] > 0
    for i in range(parameters.shape[0] // _COLUMNS):
        row = parameters[i * _COLUMNS : (i + 1) * _COLUMNS]
        _prepare(row, contents, exponents, weights, scratch[:prepare_end], linear, phase_series, amplitude_series)
        if estimates.shape[0] > 0:
            estimates[i] = np.exp(scratch[contents[_OUTPUTS] - 1])
        for start in range(0, points, BLOCK):
            stop = min(start + BLOCK, points)
            size = stop - start
            at = i * points + start
            if polar_wanted:
                a = polar[0][at : at + size]
                p = polar[1][at : at + size]
            else:
                a = scratch[series_end : series_end + size]
                p = scratch[series_end + BLOCK : series_end + BLOCK + size]
            grid_block = (f[start:stop], log_f[start:stop], cbrt_f[start:stop])
            _block(*grid_block, row, contents, weights, alignment, linear, phase_series, amplitude_series, a, p)
            if wide.shape[0] > 0:
                _to_cartesian(a, p, wide[at : at + size])
            if narrow.shape[0] > 0:
                _to_cartesian(a, p, narrow[at : at + size])
