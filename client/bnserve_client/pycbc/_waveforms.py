"""A bnserve model as PyCBC's approximant, in each of the forms in which PyCBC asks for waveforms."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import check_reference, is_single, modes_of, phase_of_the_orbit, read_mode_array
from bnserve_client.pycbc._binary import read_binary, read_model
from bnserve_protocol import (
    IN_PLANE_NAMES,
    EvaluationOptions,
    InvalidFrequencies,
    OutOfDomain,
    ParametersWithExtrinsic,
    Polarizations,
    UniformGrid,
    WaveformModel,
)

Grid = UniformGrid | NDArray[np.float64]

OPTIONS = EvaluationOptions(alignment="merger")
_ROUNDING = 1e-6
"""Of a step: what may be missing of a whole number of them, as in :class:`.UniformGrid`."""


def frequency_series(**parameters: Any) -> tuple[Any, Any]:
    """What ``pycbc.waveform.get_fd_waveform(approximant="bnserve", ...)`` answers.

    Parameters
    ----------
    mass1, mass2
        Solar masses, in the detector frame, in any order.
    spin1z, spin2z, lambda1, lambda2
        Of the first and of the second star. There is no default for the tides: PyCBC's is a black hole.
    spin1x, spin1y, spin2x, spin2y
        Where z is the orbital angular momentum at the reference frequency, and x points from star 2 to star 1.
    distance, inclination
        Mpc, radians.
    coa_phase, f_ref
        The orbital phase at the reference frequency, in radians and Hz; 0 Hz stands for ``f_lower``, as in LAL's
        IMRPhenom models.
    mode_array
        ``[(l, m), ...]``; None for all that the model has.
    delta_f, f_lower, f_final
        The step, and the first and the last frequency that are not zero, in Hz; an ``f_final`` of 0 is the top of the
        model's band, :func:`end_frequency`.
    bnserve_url, bnserve_model, bnserve_version, bnserve_digest, bnserve_timeout
        The model. Without an address, that of the environment variable ``BNSERVE_URL``, and without both a model of
        this process; the name of the model (``"default"``) may stand in ``BNSERVE_MODEL``, the token in
        ``BNSERVE_TOKEN``. The version is ``"stable"``; an outage may last 300 s.

    Returns
    -------
    tuple
        h+ and hx as ``pycbc.types.FrequencySeries``, complex128, 1/Hz, from 0 Hz on. The merger is at zero time, the
        epoch 1 / ``delta_f`` before it.

    Raises
    ------
    InvalidParameters
        A tide is missing, or a parameter is set that the model does not have.
    OutOfDomain
        The binary is outside the model's range. It is a ``NoWaveformError`` of PyCBC, too, whose likelihoods are -inf
        there.
    InvalidRequest
        A mode that the model lacks, spins in the orbital plane where it has no precession, an unknown keyword that
        begins with ``bnserve_``, a value that is no number.
    InvalidFrequencies
        No frequency is left between the first and the last.
    PackageMissing, ConnectionFailed, ModelUnknown, Unauthorized, ...
        As :func:`bnserve_client.Model.connect`, and without an address where no models are installed.
    """
    from pycbc.types import FrequencySeries

    model = read_model(parameters)
    step, lowest = float(parameters["delta_f"]), float(parameters["f_lower"])
    highest = float(parameters.get("f_final") or 0.0) or end_frequency(**parameters)
    first, last = max(1, math.ceil(lowest / step - _ROUNDING)), int(highest / step + _ROUNDING)
    if last < first:
        raise InvalidFrequencies(
            f"No multiple of 'delta_f' ({step:g} Hz) is between 'f_lower' ({lowest:g} Hz) and 'f_final' "
            f"({highest:g} Hz): lower the first or raise the last."
        )
    series = []
    for part in _polarizations(model, _multiples(first, last, step), parameters, lowest):
        whole = np.zeros(last + 1, dtype=np.complex128)
        whole[first:] = part
        series.append(FrequencySeries(whole, delta_f=step, epoch=-1.0 / step, copy=False))
    return series[0], series[1]


def samples(**parameters: Any) -> tuple[Any, Any]:
    """What ``pycbc.waveform.get_fd_waveform_sequence(approximant="bnserve", sample_points=..., ...)`` answers.

    Parameters
    ----------
    sample_points
        Frequencies in Hz, increasing, ``(M,)``; where they are not positive, the waveform is zero.
    f_ref
        As in :func:`frequency_series`; 0 Hz stands for the first positive one of the frequencies.
    mass1, mass2, ...
        As in :func:`frequency_series`, which raises the same.

    Returns
    -------
    tuple
        h+ and hx as ``pycbc.types.Array``, complex128, ``(M,)``, 1/Hz.
    """
    from pycbc.types import Array

    model = read_model(parameters)
    points = np.asarray(parameters["sample_points"].numpy(), dtype=np.float64)
    first = int(np.searchsorted(points, 0.0, side="right"))
    plus, cross = np.zeros((2, len(points)), dtype=np.complex128)
    if first < len(points):
        plus[first:], cross[first:] = _polarizations(model, points[first:], parameters, float(points[first]))
    return Array(plus), Array(cross)


def length(**parameters: Any) -> float:
    """Seconds from the moment at which the signal passes ``f_lower`` to the merger, for PyCBC to make room for it.

    Parameters and errors are those of :func:`frequency_series`.
    """
    model = read_model(parameters)
    with _out_of_domain_is_no_waveform():
        return model.time_until_merger(float(parameters["f_lower"]), read_binary(parameters, model))


def end_frequency(**parameters: Any) -> float:
    """The top of the model's band for this binary's total mass, in Hz, above which there is nothing.

    Parameters and errors are those of :func:`frequency_series`; masses alone matter.
    """
    description = read_model(parameters).description
    total_mass = float(parameters["mass1"]) + float(parameters["mass2"])
    return description.training_band[1] * description.reference_mass / total_mass


for _function in (frequency_series, samples):
    _function.required = ("mass1", "mass2", "f_lower", "delta_f")  # type: ignore[attr-defined]  # what PyCBC looks for


def _polarizations(model: WaveformModel, grid: Grid, parameters: dict[str, Any], lowest: float) -> Polarizations:
    binary = read_binary(parameters, model)
    reference = float(parameters.get("f_ref") or 0.0) or lowest
    phase, options = 2.0 * float(parameters.get("coa_phase", 0.0)), OPTIONS
    chosen = read_mode_array(parameters.get("mode_array"))
    modes = modes_of(model.description, chosen)
    with _out_of_domain_is_no_waveform():
        if _knows_references(model) or any(getattr(binary, name) for name in IN_PLANE_NAMES):  # which is younger
            check_reference(model.description, binary.total_mass, reference, "f_ref")
            options = EvaluationOptions(
                alignment="merger", reference_frequency=reference, modes=None if chosen is None else modes
            )
        else:
            face_on = dataclasses.replace(binary, distance_mpc=1.0, inclination=0.0)
            phase += _phase_of_the_orbit(model, face_on, reference)  # type: ignore[arg-type]  # one model equals itself
        return model.predict(grid, dataclasses.replace(binary, reference_phase=phase), options=options)


def _knows_references(model: WaveformModel) -> bool:
    """Whether ``reference_frequency`` is understood: not by older servers, which do not say whose band theirs is."""
    return model.description.frequency_band_masses is not None or not is_single(model.description)


@functools.lru_cache(maxsize=64)
def _phase_of_the_orbit(model: WaveformModel, binary: ParametersWithExtrinsic, reference: float) -> float:
    """Of an older server's model. Kept, because many waveforms of one binary are asked for: in time, orientation and
    phase they are the same."""
    strain = model.predict_factored([reference], binary, options=OPTIONS).h
    return float(phase_of_the_orbit(strain[0], reference, "f_ref")[0])


@functools.lru_cache(maxsize=4)
def _multiples(first: int, last: int, step: float) -> Grid:
    """Whole multiples of the step, with the bits of PyCBC's; those of a power of two travel as a uniform grid."""
    if math.frexp(step)[0] == 0.5:
        return UniformGrid(first * step, last * step, step)
    return np.arange(first, last + 1, dtype=np.float64) * step


@contextmanager
def _out_of_domain_is_no_waveform() -> Iterator[None]:
    try:
        yield
    except OutOfDomain as error:
        from bnserve_client.pycbc._no_waveform import NoWaveform

        outside = "; ".join(f"{found.parameter} = {found.value} is {found.reason}" for found in error.errors)
        raise NoWaveform(
            f"The model has no waveform of this binary ({outside}); PyCBC's likelihoods are -inf there. Narrow the "
            "prior to leave it out.",
            errors=error.errors,
            request_id=error.request_id,
        ) from error
