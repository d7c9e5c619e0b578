"""The fused evaluation: from parameters to strain, one row at a time, without Python in between.

A row is evaluated by the same sequence of operations wherever it stands in a batch, whatever its neighbours and
whichever thread runs it, so its bits depend on the row, the grid and the model alone. The kernel releases the GIL.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate._kernel_model import KernelModel
from bnserve_surrogate._math import JIT_OPTIONS, exponential, sincos
from bnserve_surrogate._regression import SCRATCH as _REGRESSION_SCRATCH
from bnserve_surrogate._regression import regress
from bnserve_surrogate.baseline import (
    AMPLITUDE_POWERS,
    FREEZING_END,
    FREEZING_START,
    FROZEN_AMPLITUDE,
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    amplitude_coefficients,
    amplitude_prefactor,
    mass_scale,
    phase_coefficients,
)

Floats = NDArray[np.float64]

BLOCK = 1024
"""Frequencies evaluated together: the scratch of a block stays in the first-level cache."""

MASS_RATIO, LAMBDA_1, LAMBDA_2, CHI_1, CHI_2, DISTANCE, INCLINATION, TOTAL_MASS, REFERENCE_PHASE, TIME_SHIFT = range(10)
"""Columns of a parameter batch."""

_EDGE = 1e-9
"""Relative width by which a frequency may miss the band's edge through rounding and still be inside."""
_LOG_PI_THIRD = float(np.log(np.pi) / 3.0)
_STRAIN = SOLAR_MASS_SECONDS**2 / MEGAPARSEC_SECONDS
"""(G Msun / c^3)^2 over one Mpc / c: strain in 1/Hz of a face-on source with nu A = 1 at one solar mass and one Mpc."""


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


@njit(inline="always")
def _zeta(x: float) -> float:
    """Smooth step of the paper (section "High frequency bound"): 0 at x = 0, 1 at x = 1, flat at both."""
    return 0.5 * (1.0 - sincos(np.pi * x)[1])


@njit(inline="always")
def _inspiral_amplitude(v: float, series: Floats) -> float:
    """The bare 3.5PN amplitude, ``v**(-7/2)`` times its series."""
    polynomial = series[AMPLITUDE_POWERS - 1]
    for k in range(AMPLITUDE_POWERS - 2, -1, -1):
        polynomial = polynomial * v + series[k]
    inverse = 1.0 / v
    return polynomial * (inverse * inverse * inverse * np.sqrt(inverse))


@njit(**JIT_OPTIONS)
def _scale_amplitude(f: Floats, cbrt_f: Floats, mass: float, series: Floats, scale: float, values: Floats) -> None:
    """Turn residual log-amplitudes into amplitudes over the baseline, frozen from M f = 0.01 to 0.02."""
    velocity_scale = np.cbrt(np.pi * mass)
    n = values.shape[0]
    freezing = first_above(f, 0, n, FREEZING_START / mass)
    frozen = first_above(f, freezing, n, FREEZING_END / mass)
    for j in range(freezing):
        values[j] = exponential(values[j]) * (scale * _inspiral_amplitude(cbrt_f[j] * velocity_scale, series))
    for j in range(freezing, frozen):
        inspiral = _inspiral_amplitude(cbrt_f[j] * velocity_scale, series)
        zeta = _zeta((f[j] * mass - FREEZING_START) / (FREEZING_END - FREEZING_START))
        values[j] = exponential(values[j]) * (scale * (inspiral + zeta * (FROZEN_AMPLITUDE - inspiral)))
    for j in range(frozen, n):
        values[j] = exponential(values[j]) * (scale * FROZEN_AMPLITUDE)


@njit(**JIT_OPTIONS)
def _finish_phase(
    f: Floats, log_f: Floats, cbrt_f: Floats, mass: float, series: Floats, constant: float, slope: float, values: Floats
) -> None:
    """Turn residual phases into phi = constant + slope * f - (TaylorF2 phase + residual)."""
    velocity_scale = np.cbrt(np.pi * mass)
    log_shift = np.log(mass) / 3.0 + _LOG_PI_THIRD
    log_series = series[PHASE_POWERS : 2 * PHASE_POWERS]
    log_squared = series[2 * PHASE_POWERS + 8]
    for j in range(values.shape[0]):
        v = cbrt_f[j] * velocity_scale
        log_v = log_f[j] * (1.0 / 3.0) + log_shift
        plain = series[15]
        for k in range(14, -1, -1):
            plain = plain * v + series[k]
        logarithmic = log_series[11]
        for k in range(10, 4, -1):
            logarithmic = logarithmic * v + log_series[k]
        inverse = 1.0 / v
        square = inverse * inverse
        baseline = plain * (square * square * inverse) + log_v * (logarithmic + log_v * (log_squared * (v * v * v)))
        values[j] = (constant + slope * f[j]) - (baseline + values[j])


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
    model: KernelModel,
    alignment: int,
    linear: Floats,
    phase_series: Floats,
    amplitude_series: Floats,
    amplitude: Floats,
    phase: Floats,
) -> None:
    """Amplitude and phase of one prepared row on one block of frequencies; zero above the band."""
    stop = f.shape[0]
    mass = row[TOTAL_MASS] * SOLAR_MASS_SECONDS
    band_start = first_above(f, 0, stop, model.mf_min * (1.0 - _EDGE) / mass)
    band_stop = first_above(f, band_start, stop, model.mf_max * (1.0 + _EDGE) / mass)
    n_a, n_p = model.amplitude_knots.shape[0], model.phase_knots.shape[0]
    gauge = linear[2 * (n_a + n_p) :]
    phase_values = linear[2 * n_a : 2 * n_a + n_p]
    if band_start > 0:
        _extend_below(
            f[:band_start],
            mass,
            model.mf_min,
            linear[0],
            phase_values[0],
            -gauge[1],
            amplitude[:band_start],
            phase[:band_start],
        )
    if band_start < band_stop:
        inside = log_f[band_start:band_stop]
        shift = np.log(mass)
        _spline(
            inside, shift, model.amplitude_knots, linear[:n_a], linear[n_a : 2 * n_a], amplitude[band_start:band_stop]
        )
        curvatures = linear[2 * n_a + n_p : 2 * (n_a + n_p)]
        _spline(inside, shift, model.phase_knots, phase_values, curvatures, phase[band_start:band_stop])
    scale = _STRAIN * mass_scale(row[MASS_RATIO]) * (row[TOTAL_MASS] * row[TOTAL_MASS]) / row[DISTANCE]
    _scale_amplitude(f, cbrt_f, mass, amplitude_series, scale, amplitude[:band_stop])
    constant = row[REFERENCE_PHASE] - gauge[2 * alignment]
    slope = 2.0 * np.pi * row[TIME_SHIFT] - gauge[2 * alignment + 1] * mass
    _finish_phase(f, log_f, cbrt_f, mass, phase_series, constant, slope, phase[:band_stop])
    for j in range(band_stop, stop):
        amplitude[j] = 0.0
        phase[j] = 0.0


@njit(**JIT_OPTIONS)
def _prepare(row: Floats, model: KernelModel, scratch: Floats, linear: Floats, phase: Any, amplitude: Floats) -> None:
    """What depends on the binary alone: linear synthesis and the baseline's coefficients."""
    q, chi_1, chi_2, lambda_1, lambda_2 = row[MASS_RATIO], row[CHI_1], row[CHI_2], row[LAMBDA_1], row[LAMBDA_2]
    outputs = scratch[: model.outputs]
    regress(q, chi_1, chi_2, lambda_1, lambda_2, model, scratch[model.outputs :], outputs)
    _synthesize(outputs, model.synthesis, linear)
    phase_coefficients(q, chi_1, chi_2, lambda_1, lambda_2, phase)
    amplitude_coefficients(q, chi_1, chi_2, amplitude)
    prefactor = amplitude_prefactor(q)
    for k in range(AMPLITUDE_POWERS):
        amplitude[k] *= prefactor


@njit(**JIT_OPTIONS)
def _scratch(model: KernelModel) -> Any:
    width = 2 * (model.amplitude_knots.shape[0] + model.phase_knots.shape[0]) + 4
    return (
        np.empty(model.outputs + _REGRESSION_SCRATCH),
        np.empty(width),
        np.empty((PHASE_LOG_POWERS, PHASE_POWERS)),
        np.empty(AMPLITUDE_POWERS),
    )


@njit(**JIT_OPTIONS)
def evaluate_strain(
    parameters: Floats,
    skip: NDArray[np.bool_],
    f: Floats,
    log_f: Floats,
    cbrt_f: Floats,
    model: KernelModel,
    alignment: int,
    out: Any,
) -> None:
    """The strain h = A exp(i phi) of every row, without inclination.

    Parameters
    ----------
    parameters:
        ``(N, 10)``, a :class:`ParameterBatch`'s values.
    skip:
        ``(N,)``: rows that become NaN.
    f, log_f, cbrt_f:
        ``(M,)``: frequencies in Hz, their logarithms and cube roots.
    model:
        The mode.
    alignment:
        0: post-Newtonian, 1: merger.
    out:
        ``(N, M)`` complex64 or complex128, overwritten.
    """
    scratch, linear, phase_series, amplitude_series = _scratch(model)
    flat_series = phase_series.reshape(PHASE_LOG_POWERS * PHASE_POWERS)
    amplitude, phase = np.empty(BLOCK), np.empty(BLOCK)
    for i in range(parameters.shape[0]):
        row = parameters[i]
        if not skip[i]:
            _prepare(row, model, scratch, linear, phase_series, amplitude_series)
        for start in range(0, f.shape[0], BLOCK):
            stop = min(start + BLOCK, f.shape[0])
            target = out[i, start:stop]
            if skip[i]:
                for j in range(stop - start):
                    target[j] = complex(np.nan, np.nan)
                continue
            block = (f[start:stop], log_f[start:stop], cbrt_f[start:stop])
            a, p = amplitude[: stop - start], phase[: stop - start]
            _block(*block, row, model, alignment, linear, flat_series, amplitude_series, a, p)
            for j in range(stop - start):
                sine, cosine = sincos(p[j])
                target[j] = complex(a[j] * cosine, a[j] * sine)


@njit(**JIT_OPTIONS)
def evaluate_amplitude_phase(
    parameters: Floats,
    skip: NDArray[np.bool_],
    f: Floats,
    log_f: Floats,
    cbrt_f: Floats,
    model: KernelModel,
    alignment: int,
    amplitude: Floats,
    phase: Floats,
) -> None:
    """As :func:`evaluate_strain`, amplitude and continuous phase into two ``(N, M)`` float64 arrays."""
    scratch, linear, phase_series, amplitude_series = _scratch(model)
    flat_series = phase_series.reshape(PHASE_LOG_POWERS * PHASE_POWERS)
    for i in range(parameters.shape[0]):
        row = parameters[i]
        if not skip[i]:
            _prepare(row, model, scratch, linear, phase_series, amplitude_series)
        for start in range(0, f.shape[0], BLOCK):
            stop = min(start + BLOCK, f.shape[0])
            a, p = amplitude[i, start:stop], phase[i, start:stop]
            if skip[i]:
                for j in range(stop - start):
                    a[j] = np.nan
                    p[j] = np.nan
                continue
            block = (f[start:stop], log_f[start:stop], cbrt_f[start:stop])
            _block(*block, row, model, alignment, linear, flat_series, amplitude_series, a, p)
