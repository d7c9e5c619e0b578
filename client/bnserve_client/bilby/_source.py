"""A bnserve model as bilby's source model of a binary neutron star."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import QUADRUPOLE, by_modes, is_single, modes_of, polarisation_factors, turned
from bnserve_client.bilby._arguments import Choice, read_choice, stated
from bnserve_client.bilby._zero_points import ZeroPoints
from bnserve_protocol import convert

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Strain = dict[str, Any]

_INTRINSIC = ("mass_1", "mass_2", "a_1", "tilt_1", "a_2", "tilt_2", "lambda_1", "lambda_2")
_GRIDS_KEPT = 4


def binary_neutron_star(
    frequency_array: Floats,
    mass_1: float,
    mass_2: float,
    luminosity_distance: float,
    a_1: float,
    tilt_1: float,
    phi_12: float,
    a_2: float,
    tilt_2: float,
    phi_jl: float,
    theta_jn: float,
    phase: float,
    lambda_1: float,
    lambda_2: float,
    **waveform_arguments: Any,
) -> Strain | None:
    """A binary neutron star by a model of bnserve: what ``bilby.gw.source.lal_binary_neutron_star`` is with LAL's.

    For bilby's ``WaveformGenerator(frequency_domain_source_model=...)``, or by its dotted name in bilby_pipe. It takes
    the place of ``binary_neutron_star_roq``, ``binary_neutron_star_frequency_sequence`` and
    ``lal_binary_neutron_star_relative_binning``, too. The waveform of the last binary is kept: another distance,
    orientation or phase of it costs no evaluation.

    Parameters
    ----------
    frequency_array
        Hz, increasing, ``(M,)``.
    mass_1, mass_2, luminosity_distance, a_1, tilt_1, a_2, tilt_2, theta_jn, phase, lambda_1, lambda_2
        As in bilby: solar masses in the detector frame, Mpc, radians. Spins are aligned: tilts are 0 or pi.
    phi_12, phi_jl
        Angles of spins that are not aligned; they have no meaning here.
    waveform_arguments
        ``bnserve_url`` (or the environment variable ``BNSERVE_URL``; without both, a model of this process),
        ``bnserve_model`` (or ``BNSERVE_MODEL``; ``"default"``), ``bnserve_version`` (``"stable"``),
        ``bnserve_digest``, ``bnserve_timeout`` (seconds that an outage may last). The token is that of
        ``BNSERVE_TOKEN``.
        ``mode_array`` (all that the model has), such as ``[[2, 2], [3, 3]]``.
        ``minimum_frequency`` (20 Hz), ``maximum_frequency`` (the last one), ``reference_frequency`` (50 Hz);
        ``waveform_approximant``: the model of LAL that says what ``phase`` and ``geocent_time`` mean; without it, or
        as ``"bnserve"``, they have the meaning that LAL documents: see ``docs/guides/samplers.md``.
        ``frequencies``; ``frequency_nodes_linear`` and ``frequency_nodes_quadratic``; ``fiducial`` and
        ``frequency_bin_edges``: as bilby's likelihoods set them.

    Returns
    -------
    dict or None
        ``{"plus": ..., "cross": ...}``, complex ``(M,)`` in 1/Hz, zero outside the band; with nodes of a quadrature
        ``{"linear": {...}, "quadratic": {...}}``. None outside the model's range, where bilby's likelihoods are -inf.

    Raises
    ------
    InvalidParameters
        A spin that is not aligned.
    InvalidRequest
        A waveform argument that is none, or a mode that the model lacks.
    PackageMissing, ConnectionFailed, ModelUnknown, Unauthorized, ...
        As :func:`bnserve_client.Model.connect`, and without an address where no models are installed.
    """
    given = locals()
    binary = tuple(float(given[name]) for name in _INTRINSIC)
    source = _source(read_choice(waveform_arguments))
    factors = polarisation_factors(source.modes, theta_jn, phase)
    for factor in factors.values():
        factor /= luminosity_distance
    if _has_nodes(waveform_arguments):
        return _at_nodes(source, binary, factors, waveform_arguments)
    edges = "frequency_bin_edges" in waveform_arguments and waveform_arguments.get("fiducial") != 1
    if edges or "frequencies" in waveform_arguments:
        frequencies = waveform_arguments["frequency_bin_edges" if edges else "frequencies"]
        strain = source.strain(np.asarray(frequencies, dtype=np.float64), binary)
        return None if strain is None else {name: factor @ strain for name, factor in factors.items()}
    return _on_the_grid(source, binary, factors, np.asarray(frequency_array, dtype=np.float64), waveform_arguments)


def binaries(theirs: Mapping[str, Any]) -> dict[str, Floats]:
    """Mass ratio, total mass, spins and tides, each ``(N,)``, of N binaries by the names of bilby's source models.

    Where ``mass_1 < mass_2`` the stars change places, as in LAL. What is no binary, a negative mass or NaN, is left to
    the model to refuse.

    Raises
    ------
    InvalidParameters
        A spin with a component in the orbital plane.
    """
    ours = convert({name: theirs[name] for name in _INTRINSIC})
    return dict(zip(ours, np.broadcast_arrays(*map(np.atleast_1d, ours.values())), strict=True))


def _on_the_grid(
    source: _Source, binary: tuple[float, ...], factors: dict[str, Any], frequencies: Floats, arguments: dict[str, Any]
) -> Strain | None:
    start = np.searchsorted(frequencies, stated(arguments, "minimum_frequency", 20.0))
    start = max(start, np.searchsorted(frequencies, 0.0, side="right"))  # there is no waveform at zero
    stop = np.searchsorted(frequencies, stated(arguments, "maximum_frequency", frequencies[-1]), side="right")
    band = slice(int(start), int(max(start, stop)))
    found = {name: np.zeros(len(frequencies), dtype=np.complex128) for name in factors}
    if band.stop == band.start:
        return found
    strain = source.strain(frequencies[band], binary)
    if strain is None:
        return None
    for name, factor in factors.items():
        np.matmul(factor, strain, out=found[name][band])
    return found


def _has_nodes(arguments: dict[str, Any]) -> bool:
    return "frequency_nodes" in arguments or "frequency_nodes_linear" in arguments


def _at_nodes(
    source: _Source, binary: tuple[float, ...], factors: dict[str, Any], arguments: dict[str, Any]
) -> Strain | None:
    """At the nodes of a reduced-order quadrature, which bilby states in two ways."""
    if "frequency_nodes" in arguments:
        nodes, places = arguments["frequency_nodes"], [arguments["linear_indices"], arguments["quadratic_indices"]]
    else:
        both = arguments["frequency_nodes_linear"], arguments["frequency_nodes_quadratic"]
        nodes, back = np.unique(np.concatenate(both), return_inverse=True)
        places = [back[: len(both[0])], back[len(both[0]) :]]
    strain = source.strain(np.asarray(nodes, dtype=np.float64), binary)
    if strain is None:
        return None
    return {
        kind: {name: factor @ strain[:, place] for name, factor in factors.items()}
        for kind, place in zip(("linear", "quadratic"), places, strict=True)
    }


class _Grid:
    """Frequencies that are asked for together with those of the zero points, and where each are in the answer."""

    def __init__(self, frequencies: Floats, zero_points: ZeroPoints) -> None:
        self.frequencies, self.top = frequencies.copy(), float(frequencies[-1])
        of_zero_points = zero_points.frequencies(self.top)
        self.all = np.union1d(frequencies, of_zero_points)
        self.places = np.searchsorted(self.all, frequencies)
        self.zero_points = np.searchsorted(self.all, of_zero_points)


class _Source:
    """A model whose waveforms have the zero points that were chosen; it keeps the last one."""

    def __init__(self, choice: Choice) -> None:
        self._model = choice.find()
        self.modes = modes_of(self._model.description, choice.modes)
        self._zero_points = choice.zero_points
        self._grids: tuple[_Grid, ...] = ()
        self._last: tuple[_Grid, tuple[float, ...], Complex | None] | None = None

    def strain(self, frequencies: Floats, binary: tuple[float, ...]) -> Complex | None:
        """h ``(L, M)`` of the modes at 1 Mpc, at phase zero; None outside the model's range."""
        grid, last = self._grid(frequencies), self._last
        if last is None or last[0] is not grid or last[1] != binary:
            last = grid, binary, self._evaluated(grid, dict(zip(_INTRINSIC, binary, strict=True)))
            self._last = last  # all in one step: threads share it
        return last[2]

    def _grid(self, frequencies: Floats) -> _Grid:
        for known in self._grids:
            if np.array_equal(known.frequencies, frequencies):
                return known
        new = _Grid(frequencies, self._zero_points)
        self._grids = (new, *self._grids[: _GRIDS_KEPT - 1])
        return new

    def _evaluated(self, grid: _Grid, binary: dict[str, float]) -> Complex | None:
        columns = binaries(binary)
        asked = tuple(dict.fromkeys([*self.modes, *QUADRUPOLE]))  # whose phase is looked at
        reference = self._zero_points.reference_frequency
        found = by_modes(self._model, grid.all, columns, asked, reference, "reference_frequency")
        if found.status[0] != 0:
            return None
        own = None if is_single(self._model.description) else np.zeros(1)
        of_22 = found.h[:, found.modes.index(QUADRUPOLE[0]), grid.zero_points]
        phase, time = self._zero_points.shifts(of_22, columns, grid.top, own)
        if not np.isfinite(phase[0]):
            return None
        h = found.h[0, : len(self.modes)][:, grid.places]
        return turned(h, self.modes, phase[0], time[0], grid.frequencies)


@functools.lru_cache(maxsize=16)
def _source(choice: Choice) -> _Source:
    return _Source(choice)
