"""What must hold between the settings and the arrays of an analysis."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import AnalysisInvalid, FieldError, InvalidFrequencies
from bnserve_protocol._parameters import PARAMETER_NAMES

if TYPE_CHECKING:
    from bnserve_protocol._analyses import AnalysisSettings, TimeMarginalisation

PRIOR_NAMES = (*(name for name in PARAMETER_NAMES if name != "time_shift"), "chirp_mass", "coalescence_time")
"""The parameters whose range an analysis may state."""

_MOST_DETECTORS = 16
_MOST_CALIBRATION_NODES = 64
_MOST_TIMES = 2**22
"""More would let a small body ask for any amount of work; no network or analysis comes near."""


def check_settings(settings: AnalysisSettings) -> None:
    """Refuse settings that contradict each other.

    Raises
    ------
    AnalysisInvalid
    """
    _check_detectors(settings.detectors)
    for name in ("f_min", "f_max", "duration"):
        value = getattr(settings, name)
        _require(math.isfinite(value) and value > 0.0, name, value, "must be positive and finite")
    for name in ("trigger_time", "sidereal_time", "sidereal_rate", "noise_log_likelihood"):
        _require(math.isfinite(getattr(settings, name)), name, getattr(settings, name), "must be finite")
    try:
        settings.grid  # noqa: B018  (made for its checks)
    except InvalidFrequencies as error:
        raise AnalysisInvalid(f"The band of the analysis is not a grid: {error.detail}", errors=error.errors) from error
    _check_prior(settings.prior)
    _check_times(settings)
    _check_marginalisations(settings)


def _check_detectors(detectors: tuple[str, ...]) -> None:
    if not 1 <= len(detectors) <= _MOST_DETECTORS:
        raise AnalysisInvalid(f"An analysis has 1 to {_MOST_DETECTORS} detectors; got {len(detectors)}.")
    for name in detectors:
        plain = name.isascii() and name.replace("-", "").replace("_", "").isalnum() and len(name) <= 32
        if not plain or detectors.count(name) > 1:
            raise AnalysisInvalid("Detectors have distinct names of at most 32 letters, digits, '-' and '_'.")


def _check_prior(prior: Mapping[str, tuple[float, float]]) -> None:
    for name, (low, high) in prior.items():
        if name not in PRIOR_NAMES:
            raise AnalysisInvalid(
                f"Unknown parameter '{name[:80]}' in the prior ranges of the analysis. "
                f"Known names: {', '.join(PRIOR_NAMES)}.",
                errors=[FieldError(reason="unknown", parameter=name[:80])],
            )
        if not (math.isfinite(low) and math.isfinite(high) and low <= high):
            raise AnalysisInvalid(
                f"The prior range of '{name}' is [{low}, {high}]; it must be finite and increasing.",
                errors=[FieldError(reason="not a range", parameter=name)],
            )


def _check_times(settings: AnalysisSettings) -> None:
    grid, times = settings.time_grid, settings.prior.get("coalescence_time")
    if grid is not None:
        _require(math.isfinite(grid.start), "time_grid.start", grid.start, "must be finite")
        _require(math.isfinite(grid.step) and grid.step > 0.0, "time_grid.step", grid.step, "must be positive")
        if times is None:
            raise AnalysisInvalid("With a time grid, 'prior' must state the range of 'coalescence_time'.")
    elif settings.kind == "roq":
        raise AnalysisInvalid("An analysis of kind 'roq' needs a time grid: its weights depend on the time of arrival.")


def _check_marginalisations(settings: AnalysisSettings) -> None:
    times = settings.time_marginalisation
    if times is not None:
        _check_sum_over_times(times, settings)
    distances = settings.distance_marginalisation
    if distances is not None:
        low, high = distances.minimum, distances.maximum
        _require(0.0 < low < high < math.inf, "distance_marginalisation", low, "must have 0 < minimum < maximum")
        _require(abs(distances.power) <= 10.0, "distance_marginalisation.power", distances.power, "is at most 10")
    calibration = settings.calibration
    if calibration is not None:
        enough = 4 <= calibration.nodes <= _MOST_CALIBRATION_NODES
        _require(enough, "calibration.nodes", calibration.nodes, f"is 4 to {_MOST_CALIBRATION_NODES}")
        low, high = calibration.f_min, calibration.f_max
        _require(0.0 < low < high < math.inf, "calibration.f_min", low, "must be positive and below calibration.f_max")
        for name in ("amplitude_width", "phase_width"):
            width = getattr(calibration, name)
            _require(0.0 <= width <= 1.0, f"calibration.{name}", width, "is 0 to 1")
    bound = settings.error_bound
    if not isinstance(bound, msgspec.UnsetType):
        _require(0.0 < bound < math.inf, "error_bound", bound, "must be positive and finite")


def _check_sum_over_times(times: TimeMarginalisation, settings: AnalysisSettings) -> None:
    low, high, step = times.minimum, times.maximum, times.step
    finite = all(map(math.isfinite, (low, high, step)))
    _require(finite and low < high and step > 0.0, "time_marginalisation", low, "must have minimum < maximum, step > 0")
    count = (high - low) / step
    _require(count <= _MOST_TIMES, "time_marginalisation.step", step, f"gives more than {_MOST_TIMES} times")
    inside = settings.prior.get("coalescence_time", (-0.5 * settings.duration, 0.5 * settings.duration))
    _require(
        inside[0] <= low and high <= inside[1],
        "time_marginalisation",
        low,
        f"must lie within [{inside[0]}, {inside[1]}] s, where the analysis is made for",
    )


def _require(condition: bool, name: str, value: float, reason: str) -> None:
    if not condition:
        raise AnalysisInvalid(
            f"'{name}' of the analysis {reason}; got {value!r}.",
            errors=[FieldError(reason=reason, parameter=name, value=str(value))],
        )


def check_arrays(settings: AnalysisSettings, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Refuse arrays that are missing, unknown, of a wrong shape or dtype, or that hold impossible values.

    Raises
    ------
    AnalysisInvalid
    """
    expected = set(_expected(settings))
    if problems := expected ^ set(arrays):
        name = min(problems)
        reason = "is missing" if name in expected else "is unknown"
        raise AnalysisInvalid(
            f"Array '{name[:80]}' of the analysis {reason}. A '{settings.kind}' analysis of "
            f"{', '.join(settings.detectors)} has exactly: {', '.join(sorted(expected))}.",
            errors=[FieldError(reason=reason, parameter=name[:80])],
        )
    linear, quadratic = _node_counts(settings, arrays)
    for name, array in arrays.items():
        shape: tuple[int | None, ...]
        kind = name.split("/")[0]
        if kind == "linear_weights":
            shape = (None, linear)
        elif kind == "quadratic_weights":
            shape = (quadratic,)
        else:
            shape = {"response": (3, 3), "location": (3,)}.get(kind, array.shape)
        _check_array(name, array, shape, "c" if kind == "linear_weights" else "f")
    for name in settings.detectors:
        _check_knots(settings, len(arrays[f"linear_weights/{name}"]))


def _expected(settings: AnalysisSettings) -> Iterator[str]:
    if settings.kind != "full":
        yield "linear_nodes"
        yield "quadratic_nodes"
    for detector in settings.detectors:
        for name in ("response", "location", "linear_weights", "quadratic_weights"):
            yield f"{name}/{detector}"


def _node_counts(settings: AnalysisSettings, arrays: Mapping[str, NDArray[Any]]) -> tuple[int, int]:
    if settings.kind == "full":
        return len(settings.grid), len(settings.grid)
    for name in ("linear_nodes", "quadratic_nodes"):
        nodes = arrays[name]
        slack = 1e-6 / settings.duration
        good = nodes.ndim == 1 and len(nodes) > 0 and nodes.dtype.kind == "f" and (np.diff(nodes) > 0.0).all()
        if not good or nodes[0] < settings.f_min - slack or nodes[-1] > settings.f_max + slack:
            raise AnalysisInvalid(
                f"'{name}' must be a vector of increasing frequencies between f_min ({settings.f_min} Hz) and "
                f"f_max ({settings.f_max} Hz).",
                errors=[FieldError(reason="not increasing within the band", parameter=name)],
            )
    return len(arrays["linear_nodes"]), len(arrays["quadratic_nodes"])


def _check_array(name: str, array: NDArray[Any], shape: tuple[int | None, ...], kind: str) -> None:
    fits = array.ndim == len(shape) and all(want in (None, have) for want, have in zip(shape, array.shape, strict=True))
    if not fits or array.dtype.kind != kind:
        described = ", ".join("T" if extent is None else str(extent) for extent in shape)
        dtype = "complex128" if kind == "c" else "float64"
        raise AnalysisInvalid(
            f"Array '{name}' of the analysis must be {dtype} of shape ({described}); got {array.dtype} {array.shape}.",
            errors=[FieldError(reason="wrong shape or dtype", parameter=name)],
        )
    if not np.isfinite(array).all():
        raise AnalysisInvalid(
            f"Array '{name}' of the analysis holds NaN or infinite values; look at its strain and its ASD.",
            errors=[FieldError(reason="not finite", parameter=name)],
        )


_EARTH_CROSSING = 0.0213
"""No detector on Earth is further from its centre, in light seconds (6,378.2 km)."""


def _check_knots(settings: AnalysisSettings, rows: int) -> None:
    grid = settings.time_grid
    if grid is None:
        _require(rows == 1, "linear_weights", rows, "have one row without a time grid")
        return
    low, high = settings.prior["coalescence_time"]
    first, last = grid.start + 2.0 * grid.step, grid.start + (rows - 3) * grid.step
    if rows < 6 or first > low - _EARTH_CROSSING or last < high + _EARTH_CROSSING:
        raise AnalysisInvalid(
            f"The time grid of the analysis covers arrivals from {first} to {last} s; the coalescence times of its "
            f"prior, [{low}, {high}] s, and the {_EARTH_CROSSING} s to the detectors need more."
        )
