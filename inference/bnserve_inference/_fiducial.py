"""The basis of relative binning: a fiducial waveform times splines through the edges of bins.

Zackay, Dai, Venumadhav (2018) and Cornish (2010). What they interpolate linearly is interpolated by cubic splines here,
in a coordinate in which the bins are uniform, and the squared modulus by itself; h at the edges is then all that is
needed, and the whole is a quadrature with one weight per edge, like a reduced-order one.

A signal of several modes is interpolated mode by mode, because sums of modes beat: the strain of order m, relative to
h0_m(f) = abs(h0(x)) exp(i m / 2 arg h0(x)), where h0 is the fiducial (2, 2) mode at x = 2 f / m, which it passes at the
same instant. That, unlike the fiducial mode, vanishes nowhere: amplitudes of odd modes change sign.

The squared moduli serve a basis of waveforms under calibration errors, too: they are so alike that a handful of nodes
tells them apart, far too few to sample the errors.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._band import Grid
from bnserve_inference._modes import QUADRUPOLE, quadrupole_options
from bnserve_inference._splines import cardinal_spline, cardinal_values, in_cells
from bnserve_protocol import AnalysisInvalid, EvaluationOptions, FieldError, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]
PHASE_POWERS = (-5.0 / 3.0, -2.0 / 3.0, 1.0, 5.0 / 3.0, 7.0 / 3.0)
"""Of frequency, in the phases by which fitting waveforms differ: masses, spins, time, tides (Zackay et al., eq. 10)."""
_FEWEST_BINS = 8
MOST_BINS = 2048
"""Cardinal splines of so many edges take 0.1 GB while they are made; a reduced-order basis takes far fewer nodes."""
_CHUNK = 8192
_QUADRATIC_TOLERANCE = 1.0
"""Radians of phase to a cell of the splines: some thirty nodes, dense at both ends of the band."""


@dataclass(frozen=True, eq=False)
class FiducialBasis:
    """B_j(f) = h0(f) s_j(x(f)) / h0(F_j), where the spline s_j is one at the edge F_j and zero at the others.

    There are such rows for every order m of the modes, ``orders``, one after the other. ``options`` ask for the (2, 2)
    mode of the fiducial binary.
    """

    linear_nodes: Floats
    grid: Grid
    fiducial: ParameterBatch
    options: EvaluationOptions
    curvatures: Floats
    orders: tuple[int, ...] = (2,)

    @property
    def quadratic_nodes(self) -> Floats:
        """The same edges."""
        return self.linear_nodes

    @property
    def all_nodes(self) -> Floats:
        """The edges, once for each order."""
        return np.tile(self.linear_nodes, len(self.orders))

    @classmethod
    def build(
        cls, grid: Grid, fiducial: ParameterBatch, model: WaveformModel, phase_tolerance: float,
        alignment: str, orders: tuple[int, ...] = (2,),
    ) -> FiducialBasis:  # fmt: skip
        """Bins on the ``grid`` of the data for one binary; see ``relative_binning_analysis``.

        Raises
        ------
        AnalysisInvalid
            A tolerance that is not positive, or a fiducial waveform that vanishes in the band.
        """
        if not (np.isfinite(phase_tolerance) and phase_tolerance > 0.0):
            raise AnalysisInvalid(
                f"The phase tolerance must be a positive number of radians; got {phase_tolerance!r}.",
                errors=[FieldError(reason="not positive", parameter="phase_tolerance")],
            )
        options = quadrupole_options(model, alignment=alignment)
        last = _last(grid, fiducial, model, options)
        if last < 1:
            raise AnalysisInvalid("The fiducial waveform vanishes in the band; choose another one or another band.")
        top = float(grid(slice(last, last + 1))[0])
        nodes = bin_edges(grid.f_min, top, phase_tolerance, most=last + 1)
        return cls(nodes, grid, fiducial, options, cardinal_spline(spread(nodes, nodes[0], top)), orders)

    def through(self, nodes: Floats) -> FiducialBasis:
        """The same with other edges, whose first and last are those of this."""
        curvatures = cardinal_spline(spread(nodes, float(nodes[0]), float(nodes[-1])))
        return replace(self, linear_nodes=nodes, curvatures=curvatures)

    def quadratic_chunks(self, model: WaveformModel) -> Iterator[tuple[slice, Floats]]:
        """Rows of abs(h)**2 on the grid, piece by piece, of a single order."""
        (order,) = self.orders
        at_nodes = self.reference(model, order, self.linear_nodes)
        first, top = float(self.linear_nodes[0]), float(self.linear_nodes[-1])
        x_nodes = spread(self.linear_nodes, first, top)
        for place in self.grid.pieces(_CHUNK):
            f = self.grid(place)
            f = f[f <= top]
            if len(f) == 0:
                return
            splines = cardinal_values(x_nodes, self.curvatures, spread(f, first, top))
            rows = splines * np.abs(self.reference(model, order, f)) ** 2 / np.abs(at_nodes[:, None]) ** 2
            yield slice(place.start, place.start + len(f)), rows

    def shares(self, f: Floats) -> tuple[NDArray[np.int64], Floats]:
        """The bin of every frequency ``(n,)``, and the functions of :func:`._splines.in_cells` there, ``(4, n)``."""
        first, top = float(self.linear_nodes[0]), float(self.linear_nodes[-1])
        return in_cells(spread(self.linear_nodes, first, top), spread(f, first, top))

    def reference(self, model: WaveformModel, order: int, f: Floats) -> NDArray[np.complex128]:
        """h0_m at frequencies, ``(M,)``; nowhere zero up to the end of the fiducial waveform."""
        if order == QUADRUPOLE[1]:
            return np.asarray(model.predict_factored(f, self.fiducial, options=self.options).h[0], np.complex128)
        amplitude, phase = self.polar(model, order, f)
        return np.asarray(amplitude * np.exp(1j * phase))

    def polar(self, model: WaveformModel, order: int, f: Floats) -> tuple[Floats, Floats]:
        """Amplitude and phase of :meth:`reference`, ``(M,)`` each; beyond the end of the fiducial waveform they go on
        as large as it was."""
        last = self.linear_nodes[-1:]
        polar = model.predict_amplitude_phase(2.0 / order * f, self.fiducial, options=self.options)
        end = model.predict_amplitude_phase(last, self.fiducial, options=self.options).amplitude[0]
        return np.where(polar.amplitude[0] > 0.0, polar.amplitude[0], end), 0.5 * order * polar.phase[0]


def _last(grid: Grid, fiducial: ParameterBatch, model: WaveformModel, options: EvaluationOptions) -> int:
    """The place of the last frequency that the fiducial waveform reaches, or -1."""
    for stop in range(grid.count, 0, -_CHUNK):
        place = slice(max(0, stop - _CHUNK), stop)
        present = np.flatnonzero(model.predict_factored(grid(place), fiducial, options=options).h[0])
        if len(present):
            return place.start + int(present[-1])
    return -1


def spread(f: Floats, f_min: float, f_max: float) -> Floats:
    """Largest phase, in radians, by which waveforms that fit may have parted at ``f``: zero at ``f_min``, increasing.

    Every power of :data:`PHASE_POWERS` may turn by 2 pi at the end of the band where it is largest.
    """
    total = np.zeros_like(f)
    for power in PHASE_POWERS:
        end = f_max if power > 0.0 else f_min
        total += np.sign(power) * ((f / end) ** power - (f_min / end) ** power)
    return 2.0 * np.pi * total


def bin_edges(f_min: float, f_max: float, phase_tolerance: float, most: int) -> Floats:
    """Edges of bins across which :func:`spread` grows by ``phase_tolerance`` at most, in Hz, ends included.

    Raises
    ------
    AnalysisInvalid
        As :func:`refuse_too_many`, where the data have ``most`` frequencies.
    """
    f = np.geomspace(f_min, f_max, 20001)
    x = spread(f, f_min, f_max)
    bins = max(_FEWEST_BINS, int(np.ceil(min(float(x[-1]) / phase_tolerance, 1e9))))
    refuse_too_many(bins, most, f"A phase tolerance of {phase_tolerance:.3g} radians", "Use a larger one")
    edges = np.interp(np.linspace(0.0, x[-1], bins + 1), x, f)
    edges[0], edges[-1] = f_min, f_max
    return edges


def refuse_too_many(bins: int, frequencies: int, what: str, cure: str) -> None:
    """Refuse more bins than :data:`MOST_BINS`, or than half of the ``frequencies`` of the data.

    Raises
    ------
    AnalysisInvalid
        Beginning with ``what`` asks for them, and with the ``cure``.
    """
    most = max(_FEWEST_BINS, min(MOST_BINS, frequencies // 2))
    if bins > most:
        raise AnalysisInvalid(
            f"{what} takes {bins} bins, where {most} are the most for data of {frequencies} frequencies. {cure}, or "
            "take the full analysis, which needs no bins.",
            errors=[FieldError(reason="too many bins", parameter="phase_tolerance", value=bins)],
        )


@dataclass(frozen=True, eq=False)
class CalibratedBasis:
    """The linear rows of a basis, and splines of squared moduli around one binary of it for the quadratic ones."""

    basis: Any
    smooth: FiducialBasis

    @classmethod
    def around(cls, basis: Any, reference: ParameterBatch, grid: Grid, model: WaveformModel) -> CalibratedBasis:
        """With splines on the ``grid`` of the data, around the binary ``reference``."""
        smooth = FiducialBasis.build(grid, reference, model, _QUADRATIC_TOLERANCE, basis.alignment)
        return cls(basis, smooth)

    @property
    def linear_nodes(self) -> NDArray[np.float64]:
        """Those of the basis."""
        nodes: NDArray[np.float64] = self.basis.linear_nodes
        return nodes

    @property
    def quadratic_nodes(self) -> NDArray[np.float64]:
        """Those of the splines."""
        return self.smooth.quadratic_nodes

    def linear_chunks(self, model: WaveformModel) -> Iterator[tuple[slice, NDArray[np.complex128]]]:
        """Those of the basis."""
        yield from self.basis.linear_chunks(model)

    def quadratic_chunks(self, model: WaveformModel) -> Iterator[tuple[slice, NDArray[np.float64]]]:
        """Those of the splines."""
        yield from self.smooth.quadratic_chunks(model)
