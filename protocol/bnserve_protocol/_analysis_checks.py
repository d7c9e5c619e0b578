"""What must hold between the settings and the arrays of an analysis."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_settings import AnalysisSettings, Calibration
from bnserve_protocol._errors import AnalysisInvalid, FieldError, InvalidFrequencies
from bnserve_protocol._prior_checks import check_integrals, check_prior, require

_MOST_DETECTORS = 16
_MOST_CALIBRATION_NODES = 64
_LARGEST_DEGREE = 64
_LIMITS = {"f_max": 1e6, "duration": 1e7, "sidereal_time": 1e6, "sidereal_rate": 1.0}
"""Hz, seconds, radians and radians a second: far beyond any analysis, and phases of their products have digits left."""
_REFERENCES = 0.01, 1e6
"""Hz; lower, double precision leaves nothing of a phase."""


def check_settings(settings: AnalysisSettings) -> None:
    """Refuse settings that contradict each other.

    Raises
    ------
    AnalysisInvalid
        One of them is out of its range, or two contradict each other.
    """
    _check_detectors(settings.detectors)
    for name in ("f_min", "f_max", "duration"):
        value = getattr(settings, name)
        require(math.isfinite(value) and value > 0.0, name, value, "must be positive and finite")
    for name in ("trigger_time", "sidereal_time", "sidereal_rate", "noise_log_likelihood"):
        require(math.isfinite(getattr(settings, name)), name, getattr(settings, name), "must be finite")
    for name, most in _LIMITS.items():
        require(abs(getattr(settings, name)) <= most, name, getattr(settings, name), f"is at most {most:g}")
    try:
        settings.grid  # noqa: B018  (made for its checks)
    except InvalidFrequencies as error:
        raise AnalysisInvalid(f"The band of the analysis is not a grid: {error.detail}", errors=error.errors) from error
    check_prior(settings.prior)
    _check_time_grid(settings)
    check_integrals(settings)
    if settings.calibration is not None:
        _check_calibration(settings.calibration)
    _check_modes(settings)
    if settings.moves and settings.kind == "roq":
        raise AnalysisInvalid(
            "A reduced-order quadrature gives waveforms, and not what detectors that move make of them: take relative "
            "binning or the full analysis for response='moving', or response='static'.",
            errors=[FieldError(reason="not with a quadrature", parameter="response")],
        )
    reference = settings.reference_frequency
    if not isinstance(reference, msgspec.UnsetType):
        least, most = _REFERENCES
        require(least <= reference <= most, "reference_frequency", reference, f"is {least:g} to {most:g} Hz")
    bound = settings.error_bound
    if not isinstance(bound, msgspec.UnsetType):
        require(0.0 < bound < math.inf, "error_bound", bound, "must be positive and finite")


def _check_modes(settings: AnalysisSettings) -> None:
    if isinstance(settings.modes, msgspec.UnsetType):
        return
    if not settings.modes or len(set(settings.modes)) != len(settings.modes):
        raise AnalysisInvalid(
            "The modes of an analysis are distinct pairs (l, m), at least one; leave them out for all."
        )
    for degree, order in settings.modes:
        if not 1 <= order <= degree <= _LARGEST_DEGREE or degree < 2:
            raise AnalysisInvalid(
                f"The modes of an analysis have 2 <= l <= {_LARGEST_DEGREE} and 1 <= m <= l; got ({degree}, {order}).",
                errors=[FieldError(reason="no mode", parameter="modes", value=f"({degree}, {order})")],
            )
    if settings.kind == "roq":
        raise AnalysisInvalid(
            "A reduced-order quadrature holds the (2, 2) mode alone: leave the modes of its analysis out, or take "
            "relative binning or the full analysis.",
            errors=[FieldError(reason="not (2, 2) alone", parameter="modes")],
        )


def _check_detectors(detectors: tuple[str, ...]) -> None:
    if not 1 <= len(detectors) <= _MOST_DETECTORS:
        raise AnalysisInvalid(f"An analysis has 1 to {_MOST_DETECTORS} detectors; got {len(detectors)}.")
    check_detector_names(detectors)


def check_detector_names(names: Sequence[str]) -> None:
    """Refuse a detector that is there twice, which would count twice, and names that no file or address could have.

    Two of different names may be at one place: so are H1 and H2.

    Raises
    ------
    AnalysisInvalid
        A name is there twice, or is none.
    """
    for name in names:
        plain = name.isascii() and name.replace("-", "").replace("_", "").isalnum() and len(name) <= 32
        twice = plain and names.count(name) > 1
        if twice or not plain:
            raise AnalysisInvalid(
                "Detectors have distinct names of at most 32 letters, digits, '-' and '_'; got "
                + (f"'{name}' {names.count(name)} times." if twice else f"'{name[:32]}'."),
                errors=[
                    FieldError(reason="not distinct" if twice else "no name", parameter="detectors", value=name[:32])
                ],
            )


def _check_time_grid(settings: AnalysisSettings) -> None:
    grid, times = settings.time_grid, settings.prior.get("coalescence_time")
    if grid is not None:
        require(math.isfinite(grid.start), "time_grid.start", grid.start, "must be finite")
        require(math.isfinite(grid.step) and grid.step > 0.0, "time_grid.step", grid.step, "must be positive")
        if times is None:
            raise AnalysisInvalid("With a time grid, 'prior' must state the range of 'coalescence_time'.")
    elif settings.kind == "roq":
        raise AnalysisInvalid("An analysis of kind 'roq' needs a time grid: its weights depend on the time of arrival.")


def _check_calibration(calibration: Calibration) -> None:
    enough = 4 <= calibration.nodes <= _MOST_CALIBRATION_NODES
    require(enough, "calibration.nodes", calibration.nodes, f"is 4 to {_MOST_CALIBRATION_NODES}")
    low, high = calibration.f_min, calibration.f_max
    require(0.0 < low < high < math.inf, "calibration.f_min", low, "must be positive and below calibration.f_max")
    for name in ("amplitude_width", "phase_width"):
        width = getattr(calibration, name)
        require(0.0 <= width <= 1.0, f"calibration.{name}", width, "is 0 to 1")


def check_arrays(settings: AnalysisSettings, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Refuse arrays that are missing, unknown, of a wrong shape or dtype, or hold what cannot be: AnalysisInvalid."""
    expected = set(_expected(settings)) | (set(_optional(settings)) & set(arrays))
    if problems := expected ^ set(arrays):
        name = min(problems)
        reason = "is missing" if name in expected else "is unknown"
        raise AnalysisInvalid(
            f"Array '{name[:80]}' of the analysis {reason}. A '{settings.kind}' analysis of "
            f"{', '.join(settings.detectors)} has exactly: {', '.join(sorted(expected))}.",
            errors=[FieldError(reason=reason, parameter=name[:80])],
        )
    linear, quadratic = _node_counts(settings, arrays)
    groups = _groups(settings)
    for name, array in arrays.items():
        shape: tuple[int | None, ...]
        kind = name.split("/")[0]
        dtype = "f"
        if kind == "linear_weights":
            shape, dtype = (None, groups * linear), "c"
        elif kind == "quadratic_weights" and groups > 1:
            shape, dtype = (groups * (groups + 1) // 2, quadratic), "c"
        elif kind == "quadratic_weights":
            shape = (quadratic,)
        elif kind in ("reference_phases", "reference_times"):
            shape = (groups, linear)
        else:
            shape = {"response": (3, 3), "location": (3,), "arms": (2, 3)}.get(kind, array.shape)
        _check_array(name, array, shape, dtype)
    for name in settings.detectors:
        check_location(name, arrays[f"location/{name}"])
        _check_knots(settings, len(arrays[f"linear_weights/{name}"]))
        if f"arms/{name}" in arrays:
            check_arms(name, arrays[f"arms/{name}"], arrays[f"response/{name}"])
    if settings.moves or any(f"arms/{name}" in arrays for name in settings.detectors):
        _check_one_kind_of_nodes(settings, arrays)


def _groups(settings: AnalysisSettings) -> int:
    """How many weights a node has: modes of one order m have the same ones, and on the full grid all modes have."""
    if settings.kind == "full" or isinstance(settings.modes, msgspec.UnsetType):
        return 1
    return len({order for _, order in settings.modes})


def _expected(settings: AnalysisSettings) -> Iterator[str]:
    if settings.kind != "full":
        yield "linear_nodes"
        yield "quadratic_nodes"
        if settings.moves:
            yield "reference_phases"
            yield "reference_times"
    for detector in settings.detectors:
        for name in ("response", "location", "linear_weights", "quadratic_weights"):
            yield f"{name}/{detector}"


def _optional(settings: AnalysisSettings) -> Iterator[str]:
    """Of detectors whose arms are not taken to be short."""
    if settings.kind != "roq":
        yield from (f"arms/{detector}" for detector in settings.detectors)


def _node_counts(settings: AnalysisSettings, arrays: Mapping[str, NDArray[Any]]) -> tuple[int, int]:
    if settings.kind == "full":
        return len(settings.grid), len(settings.grid)
    for name in ("linear_nodes", "quadratic_nodes"):
        nodes = arrays[name]
        slack = 1e-6 / settings.duration
        good = nodes.ndim == 1 and len(nodes) > 0 and nodes.dtype.kind == "f" and np.isfinite(nodes).all()
        good = good and (np.diff(nodes) > 0.0).all()
        if not good or nodes[0] < settings.f_min - slack or nodes[-1] > settings.f_max + slack:
            raise AnalysisInvalid(
                f"'{name}' must be a vector of increasing frequencies between f_min ({settings.f_min} Hz) and "
                f"f_max ({settings.f_max} Hz).",
                errors=[FieldError(reason="not increasing within the band", parameter=name)],
            )
    several = not isinstance(settings.modes, msgspec.UnsetType) and len(settings.modes) > 1
    if several:
        _check_one_kind_of_nodes(settings, arrays)
    return len(arrays["linear_nodes"]), len(arrays["quadratic_nodes"])


def _check_one_kind_of_nodes(settings: AnalysisSettings, arrays: Mapping[str, NDArray[Any]]) -> None:
    if settings.kind != "full" and not np.array_equal(arrays["linear_nodes"], arrays["quadratic_nodes"]):
        raise AnalysisInvalid(
            "With several modes, a response that moves, or arms that are not short, 'linear_nodes' and "
            "'quadratic_nodes' of an analysis are the same."
        )


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
_LARGEST_RADIUS = _EARTH_CROSSING * 299792458.0
_KILOMETRES = 6.3e3, 6.4e3
"""Distances from the centre of the Earth that are in kilometres."""


def check_location(name: str, location: NDArray[np.float64]) -> None:
    """Refuse a detector that is not on Earth, or whose place is in kilometres.

    Raises
    ------
    AnalysisInvalid
        It is one of the two.
    """
    radius = math.hypot(*location.tolist())
    far = not radius <= _LARGEST_RADIUS
    if far or _KILOMETRES[0] <= radius <= _KILOMETRES[1]:
        said = "beyond the surface of the Earth" if far else "the radius of the Earth in kilometres"
        raise AnalysisInvalid(
            f"The detector {name} is {radius:.7g} m from the centre of the Earth, {said}; give its location in metres.",
            errors=[FieldError(reason="not on Earth", parameter=f"location/{name}", value=radius)],
        )


_SINGLE_PRECISION = 1e-5
"""Of responses that come from LAL, and some more."""
_LONGEST_ARM = 1e5
"""Metres; the longest that is planned has 40 km."""


def check_arms(name: str, arms: NDArray[np.float64], response: NDArray[np.float64]) -> None:
    """Refuse arms, ``(2, 3)`` in metres, that are none, or not those of the ``response`` ``(3, 3)``.

    Raises
    ------
    AnalysisInvalid
        They have no length, one that none has on Earth, or make another response.
    """
    lengths = [math.hypot(*arm) for arm in arms.tolist()]
    if not 0.0 < min(lengths) <= max(lengths) <= _LONGEST_ARM:
        raise AnalysisInvalid(
            f"The arms of {name} are {lengths[0]:.7g} and {lengths[1]:.7g} m long; give vectors of at most "
            f"{_LONGEST_ARM:g} m, or leave them out for a detector whose arms count as short.",
            errors=[FieldError(reason="no arms", parameter=f"arms/{name}", value=max(lengths))],
        )
    x, y = arms / np.array(lengths)[:, None]
    if not np.abs(0.5 * (np.outer(x, x) - np.outer(y, y)) - response).max() <= _SINGLE_PRECISION:
        raise AnalysisInvalid(
            f"The response of {name} is not that of its arms, half of the difference of the products of their unit "
            "vectors with themselves: give the arms in the Earth-fixed frame, or leave them out.",
            errors=[FieldError(reason="not those of the response", parameter=f"arms/{name}")],
        )


def _check_knots(settings: AnalysisSettings, rows: int) -> None:
    grid = settings.time_grid
    if grid is None:
        require(rows == 1, "linear_weights", rows, "have one row without a time grid")
        return
    low, high = settings.prior["coalescence_time"]
    first, last = grid.start + 2.0 * grid.step, grid.start + (rows - 3) * grid.step
    if rows < 6 or first > low - _EARTH_CROSSING or last < high + _EARTH_CROSSING:
        raise AnalysisInvalid(
            f"The time grid of the analysis covers arrivals from {first} to {last} s; the coalescence times of its "
            f"prior, [{low}, {high}] s, and the {_EARTH_CROSSING} s to the detectors need more."
        )
