"""bilby's calibration errors: cubic splines in the logarithm of the frequency, by the names of its priors."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import Calibration, InvalidRequest

Floats = NDArray[np.float64]

_WIDTH, _LEAST_WIDTH = 0.05, 1e-3
"""Of the errors that an approximation has to stand: where there is no prior, and where one is narrower."""


def read_calibration(interferometers: Any, priors: Mapping[str, Any]) -> Calibration | None:
    """The nodes of ``bilby.gw.calibration.CubicSpline``, the same in all detectors; None where there are no errors.

    The widths that an approximate likelihood stands are the largest of the priors at any node.

    Raises
    ------
    InvalidRequest
        Another kind of calibration, or splines that are not the same in all detectors.
    """
    models = {interferometer.name: interferometer.calibration_model for interferometer in interferometers}
    kinds = {type(model).__name__ for model in models.values()}
    if kinds == {"Recalibrate"}:
        return None
    found = {(model.n_points, model.minimum_frequency, model.maximum_frequency) for model in models.values()
             if type(model).__name__ == "CubicSpline"}  # fmt: skip
    if kinds != {"CubicSpline"} or len(found) != 1:
        raise InvalidRequest(
            f"The calibration models of {', '.join(models)} are {', '.join(sorted(kinds))} with {len(found)} sets of "
            "nodes: give every detector a bilby.gw.calibration.CubicSpline with the same frequencies and n_points, or "
            "use the source model binary_neutron_star in bilby's own likelihood."
        )
    nodes, low, high = found.pop()
    names = _names(tuple(models), nodes)
    widths = {
        f"{part}_width": max(map(_width, (priors.get(name) for nodes_of in of.values() for name in nodes_of)))
        for part, of in names.items()
    }
    return Calibration(nodes=int(nodes), f_min=float(low), f_max=float(high), **widths)


def calibration_columns(
    calibration: Calibration, detectors: tuple[str, ...], theirs: Mapping[str, Any]
) -> dict[str, dict[str, Floats]]:
    """``calibration_amplitude`` and ``calibration_phase`` of N samples, by detector, ``(N, nodes)`` or ``(nodes,)``."""
    return {
        f"calibration_{part}": {
            detector: np.stack(np.broadcast_arrays(*(np.asarray(theirs[name], dtype=np.float64) for name in names)), -1)
            for detector, names in of.items()
        }
        for part, of in _names(detectors, calibration.nodes).items()
    }


def _names(detectors: tuple[str, ...], nodes: int) -> dict[str, dict[str, list[str]]]:
    """bilby's, of each part and each detector."""
    return {
        part: {detector: [f"recalib_{detector}_{part}_{node}" for node in range(nodes)] for detector in detectors}
        for part in ("amplitude", "phase")
    }


def _width(prior: Any) -> float:
    """How far from none an error may be: one standard deviation, or all of a prior that has ends."""
    if prior is None:
        return _WIDTH
    middle, sigma = float(getattr(prior, "mu", 0.0)), getattr(prior, "sigma", None)
    ends = [abs(float(getattr(prior, end, prior))) for end in ("minimum", "maximum")]
    wide = abs(middle) + float(sigma) if sigma is not None else max(ends)
    return min(max(wide, _LEAST_WIDTH), 1.0)
