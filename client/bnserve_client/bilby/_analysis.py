"""bilby's interferometers and priors as an analysis of bnserve."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_client._chosen import local_part
from bnserve_client._lal_meaning import is_single, modes_of
from bnserve_client._lal_precession import MOST_IN_PLANE
from bnserve_client.bilby._arguments import Choice, stated
from bnserve_client.bilby._calibration import read_calibration
from bnserve_client.bilby._ranges import distance_prior, ends, prior_ranges, time_name
from bnserve_protocol import InvalidRequest, Likelihood, TimeMarginalisation, WaveformModel

Floats = NDArray[np.float64]


class Marginalised(NamedTuple):
    """What is integrated over."""

    time: bool
    phase: bool
    distance: bool


def build_analysis(
    interferometers: Any,
    priors: Any,
    model: WaveformModel,
    arguments: Mapping[str, Any],
    choice: Choice,
    marginalised: Marginalised,
    *,
    fiducial: dict[str, Floats] | None,
    trigger_time: float | None,
    error_bound: float,
    time_reference: str,
) -> Likelihood:
    """The likelihood of an analysis that :meth:`ServiceLikelihood.from_bilby` describes, which raises the same.

    Parameters
    ----------
    time_reference
        ``"geocenter"``, or the detector whose ``H1_time`` the priors have.
    fiducial
        One binary, as ``binaries`` makes it: by relative binning around it; None for the full grid.
    """
    _refuse_precession(priors)
    parts = local_part("analyses", "Building an analysis of bilby's data")
    modes = modes_of(model.description, choice.modes)
    trigger = _trigger(priors, time_name(time_reference)) if trigger_time is None else float(trigger_time)
    low, high = _band(interferometers, arguments)
    data = [_data(parts, interferometer, low, high) for interferometer in interferometers]
    options = parts.LikelihoodOptions(
        prior=prior_ranges(priors, trigger, time_reference) if fiducial is not None else {},
        phase_marginalisation=marginalised.phase,
        time_marginalisation=_times(priors, trigger, choice.zero_points.approximant) if marginalised.time else None,
        distance_marginalisation=distance_prior(priors["luminosity_distance"], parts.tabulated_distance_prior)
        if marginalised.distance
        else None,
        calibration=read_calibration(interferometers, priors),
        error_bound=error_bound,
        modes=None if is_single(model.description) else modes,
    )
    common = {"trigger_time": trigger, "f_min": low, "f_max": high, "alignment": "merger", "options": options}
    if fiducial is None:
        analysis = parts.full_analysis(data, **common)
    else:
        binary = {**fiducial, "distance_mpc": 100.0, "inclination": 0.0}
        analysis = parts.relative_binning_analysis(data, fiducial=binary, model=model, **common)
    bound: Likelihood = parts.likelihood(model, analysis)
    return bound


def _refuse_precession(priors: Any) -> None:
    for star in (1, 2):
        if ends(priors.get(f"a_{star}")) == (0.0, 0.0):
            continue
        angles = {f"tilt_{star}": (0.0, math.pi), f"cos_tilt_{star}": (-1.0, 1.0), f"chi_{star}_in_plane": (0.0,)}
        for name, aligned in angles.items():
            low, high = ends(priors.get(name, aligned[0])) or (0.0, math.inf)
            if low != high or min(abs(low - one) for one in aligned) > MOST_IN_PLANE:
                raise InvalidRequest(
                    f"The priors have spins in the orbital plane ('{name}'), and likelihoods in the service take "
                    "aligned ones: give priors of chi_1 and chi_2, as in bilby.gw.prior.BNSPriorDict(); or use the "
                    "source model binary_neutron_star in bilby's own likelihood, where binaries precess."
                )


def _trigger(priors: Any, name: str) -> float:
    time = priors.get(name)
    if time is None:
        raise InvalidRequest(
            f"The priors have no '{name}': give it a bilby.core.prior.Uniform, or give 'trigger_time'."
        )
    if isinstance(time, int | float):
        return float(time)
    return 0.5 * (float(time.minimum) + float(time.maximum))


def _times(priors: Any, trigger: float, approximant: str | None) -> TimeMarginalisation:
    prior = priors.get("geocent_time")
    if approximant is not None or type(prior).__name__ != "Uniform":
        raise InvalidRequest(
            "The time of the merger is integrated over a uniform prior: give geocent_time a bilby.core.prior.Uniform, "
            "and leave out 'time_reference' and 'waveform_approximant', whose times are others; or sample in the time."
        )
    return TimeMarginalisation(minimum=prior.minimum - trigger, maximum=prior.maximum - trigger)


def _band(interferometers: Any, arguments: Mapping[str, Any]) -> tuple[float, float]:
    """The frequencies of the data in which there is a waveform and a detector, in Hz."""
    grid = interferometers[0].frequency_array
    used = np.any([interferometer.frequency_mask for interferometer in interferometers], axis=0)
    used &= (grid >= stated(arguments, "minimum_frequency", 20.0)) & (grid > 0.0)
    used &= grid <= stated(arguments, "maximum_frequency", grid[-1])
    if used.sum() < 2:
        raise InvalidRequest(
            "No frequency of the data is in a detector's band and in the waveform's: compare minimum_frequency and "
            "maximum_frequency of the interferometers with those of waveform_arguments."
        )
    duration = interferometers[0].duration
    return tuple(float(round(f * duration) / duration) for f in grid[used][[0, -1]])  # type: ignore[return-value]  # two


def _data(parts: Any, interferometer: Any, low: float, high: float) -> Any:
    """Strain and noise of one detector; where bilby leaves out a frequency, it has no weight."""
    asd = np.sqrt(np.asarray(interferometer.power_spectral_density_array, dtype=np.float64))
    return parts.DetectorData(
        detector=parts.Detector(
            interferometer.name, np.asarray(interferometer.detector_tensor), np.asarray(interferometer.vertex)
        ),
        strain=np.asarray(interferometer.frequency_domain_strain, dtype=np.complex128),
        asd=np.where(interferometer.frequency_mask, asd, np.inf),
        start_time=float(interferometer.strain_data.start_time),
        duration=float(interferometer.duration),
    )
