"""Calibration errors of amplitude and phase: cubic splines through logarithmic nodes, and envelopes from files."""

from __future__ import annotations

from pathlib import Path
from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._splines import cardinal_spline, cardinal_values
from bnserve_protocol import AnalysisInvalid, Calibration, FieldError

Floats = NDArray[np.float64]
Correction: TypeAlias = Literal["data", "template"]
_CORRECTIONS = ("data", "template")
_COLUMNS = 7


def calibration_nodes(calibration: Calibration) -> NDArray[np.float64]:
    """The frequencies of the nodes in Hz, ``(nodes,)``: logarithmic, both ends included."""
    return np.geomspace(calibration.f_min, calibration.f_max, calibration.nodes)


def calibration_factors(
    calibration: Calibration,
    amplitude: NDArray[np.float64],
    phase: NDArray[np.float64],
    frequencies: NDArray[np.float64],
) -> NDArray[np.complex128]:
    """What errors at the nodes, each ``(..., nodes)``, multiply a signal by: (1 + dA)(2 + i dphi) / (2 - i dphi).

    Complex ``(..., M)`` for ``frequencies`` in Hz, ``(M,)``.
    """
    splines = calibration_splines(calibration, frequencies)
    turned = phase @ splines
    square = np.square(turned)
    size = (1.0 + amplitude @ splines) / (4.0 + square)
    factors = np.empty(turned.shape, dtype=np.complex128)
    factors.real, factors.imag = size * (4.0 - square), size * 4.0 * turned
    return factors


def calibration_splines(calibration: Calibration, frequencies: NDArray[np.float64]) -> NDArray[np.float64]:
    """The nodes' cardinal functions, ``(nodes, M)``: errors at the nodes times these are errors at ``frequencies``.

    The spline is cubic in log f, without a knot at the second node from either end (LIGO-T2300140, as in bilby's
    ``CubicSpline``); the end cells extend beyond the ends.

    Parameters
    ----------
    calibration
        Number and range of the nodes.
    frequencies
        In Hz, ``(M,)``.
    """
    nodes = calibration.nodes
    log_ends = np.log(calibration.f_min), np.log(calibration.f_max)
    x = (np.log(frequencies) - log_ends[0]) / (log_ends[1] - log_ends[0]) * (nodes - 1)
    cell = np.clip(np.floor(x).astype(np.int64), 0, nodes - 2)
    b = x - cell
    a = 1.0 - b
    curvatures = cardinal_spline(np.arange(nodes, dtype=np.float64))
    unit = np.eye(nodes)
    return np.ascontiguousarray(
        a * unit[:, cell]
        + b * unit[:, cell + 1]
        + (a**3 - a) / 6.0 * curvatures[cell].T
        + (b**3 - b) / 6.0 * curvatures[cell + 1].T
    )


class Envelope(NamedTuple):
    """Means and standard deviations of the errors at the nodes of an analysis, ``(nodes,)`` each.

    They are those of a sample's ``calibration_amplitude`` (relative) and ``calibration_phase`` (radians), which correct
    the template.
    """

    amplitude: Floats
    amplitude_width: Floats
    phase: Floats
    phase_width: Floats


def read_envelope(path: str | Path, calibration: Calibration, *, correction: Correction) -> Envelope:
    """The envelope in a text file, at the nodes of an analysis; the same numbers as bilby's ``from_envelope_file``.

    Parameters
    ----------
    path
        Seven columns: frequency (Hz); median magnitude and phase (radians); both one sigma below; both one above.
    calibration
        The nodes, between which cubic splines in log f interpolate.
    correction
        What the file's numbers are multiplied with. ``"data"``: the data, to make them what the template describes
        (what the LIGO-Virgo-KAGRA collaborations publish, and bilby's default). ``"template"``: the template, to
        make it what is in the data. The first is the inverse of the second, and files do not say which they are.

    Raises
    ------
    AnalysisInvalid
        Another correction, or a file that cannot be read, holds something else, or ends before the nodes do.
    """
    if correction not in _CORRECTIONS:
        raise AnalysisInvalid(
            f"'correction' is 'data' or 'template', what the envelope is to be multiplied with; got {correction!r}.",
            errors=[FieldError(reason="neither 'data' nor 'template'", parameter="correction")],
        )
    f, amplitude, phase, *low_high = _columns(Path(path))
    nodes = calibration_nodes(calibration)
    if nodes[0] < f[0] * (1.0 - 1e-9) or nodes[-1] > f[-1] * (1.0 + 1e-9):
        raise AnalysisInvalid(
            f"{Path(path).name} reaches from {f[0]:g} to {f[-1]:g} Hz, and the nodes from {nodes[0]:g} to "
            f"{nodes[-1]:g} Hz: choose nodes inside.",
            errors=[FieldError(reason="beyond the envelope", parameter="calibration")],
        )
    amplitude_low, phase_low, amplitude_high, phase_high = low_high
    if correction == "data":
        amplitude, phase = 1.0 / amplitude, -phase
        amplitude_low, amplitude_high = 1.0 / amplitude_high, 1.0 / amplitude_low
    columns = (
        amplitude - 1.0, 0.5 * np.abs(amplitude_high - amplitude_low), phase, 0.5 * np.abs(phase_high - phase_low)
    )  # fmt: skip
    x = np.log(f)
    splines = cardinal_values(x, cardinal_spline(x), np.log(nodes))
    return Envelope(*(column @ splines for column in columns))


def _columns(path: Path) -> list[Floats]:
    try:
        table = np.loadtxt(path, ndmin=2)
    except FileNotFoundError as error:
        raise AnalysisInvalid(f"There is no file {path}; look at its name and folder.") from error
    except (OSError, ValueError) as error:
        raise AnalysisInvalid(f"{path.name} is not a text file of {_COLUMNS} columns of numbers: {error}.") from error
    if table.shape[1] != _COLUMNS or len(table) < 4 or not np.isfinite(table).all():
        raise AnalysisInvalid(
            f"{path.name} is no calibration envelope: it has {table.shape[1]} columns of {len(table)} rows, and an "
            f"envelope has {_COLUMNS} of at least 4, all finite."
        )
    columns: list[Floats] = list(np.ascontiguousarray(table.T))
    if not (columns[0][0] > 0.0 and (np.diff(columns[0]) > 0.0).all()):
        raise AnalysisInvalid(f"The frequencies in {path.name} must be positive and increasing.")
    if not all((columns[place] > 0.0).all() for place in (1, 3, 5)):
        raise AnalysisInvalid(f"The magnitudes in {path.name} (columns 2, 4 and 6) must be positive: about 1.")
    return columns
