"""A bnserve model as bilby's source model of a binary neutron star."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import polarisation_factors
from bnserve_client._lal_precession import precesses
from bnserve_client.bilby._arguments import read_choice, stated
from bnserve_client.bilby._waveforms import INTRINSIC, ORIENTATION, Waveforms, waveforms_of

Floats = NDArray[np.float64]
Strain = dict[str, Any]


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
    orientation or phase of it costs no evaluation; of one that precesses, another distance.

    Parameters
    ----------
    frequency_array
        Hz, increasing, ``(M,)``.
    mass_1, mass_2, luminosity_distance, a_1, tilt_1, phi_12, a_2, tilt_2, phi_jl, theta_jn, phase, lambda_1, lambda_2
        As in bilby: solar masses in the detector frame, Mpc, radians, at the reference frequency. A spin with less than
        1e-5 in the orbital plane counts as aligned.
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
    InvalidRequest
        A waveform argument that is none, a mode that the model lacks, or a spin in the orbital plane where it has no
        precession.
    OutOfBand
        More turns of precession between the reference frequency and the grid than are followed.
    PackageMissing, ConnectionFailed, ModelUnknown, Unauthorized, ...
        As :func:`bnserve_client.Model.connect`, and without an address where no models are installed.
    """
    given = locals()
    whole = {name: float(given[name]) for name in (*INTRINSIC, *ORIENTATION)}
    source = waveforms_of(read_choice(waveform_arguments))
    if precesses(whole):
        binary, factors = tuple(whole.values()), {"plus": np.array([1.0, 0.0]), "cross": np.array([0.0, 1.0])}
    else:
        binary = tuple(whole[name] for name in INTRINSIC)
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


def _on_the_grid(
    source: Waveforms,
    binary: tuple[float, ...],
    factors: dict[str, Any],
    frequencies: Floats,
    arguments: dict[str, Any],
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
    source: Waveforms, binary: tuple[float, ...], factors: dict[str, Any], arguments: dict[str, Any]
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
