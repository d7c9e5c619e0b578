"""What the likelihood integrates over, of what the prior leaves open."""

from __future__ import annotations

import contextlib
import math
from typing import Any

from bnserve_inference import tabulated_distance_prior
from bnserve_posterior.events import EventInvalid, LikelihoodSection
from bnserve_posterior.priors import PriorCube
from bnserve_protocol import AnalysisInvalid, DistanceMarginalisation, TimeMarginalisation


def integrated_names(section: LikelihoodSection, priors: Any) -> tuple[str, ...]:
    """Names of the prior that are integrated over, and so not sampled.

    Raises
    ------
    EventInvalid
        No prior of the distance, or a phase or time that is to be integrated over and has another prior than a uniform
        one.
    """
    from bilby.core.prior import Uniform

    found = []
    if "luminosity_distance" not in priors:
        raise EventInvalid("The distance is not known: give a prior of luminosity_distance, in Mpc.")
    if section.phase_marginalisation:
        prior = priors["phase"]
        if type(prior) is not Uniform or not math.isclose(prior.maximum - prior.minimum, 2.0 * math.pi):
            raise EventInvalid(
                "The likelihood integrates over the phase, whose prior must then be uniform over 2 pi: leave it out, "
                "or set phase_marginalisation = false and give one of reference_phase."
            )
        found.append("phase")
    if section.distance_marginalisation and marginalised_distance(priors) is not None:
        found.append("luminosity_distance")
    if section.time_marginalisation:
        if type(priors["geocent_time"]) is not Uniform:
            raise EventInvalid(
                "The likelihood is to integrate over the time, whose prior must then be uniform: leave out "
                "time_marginalisation, or give the two ends of geocent_time."
            )
        found.append("geocent_time")
    return tuple(found)


def marginalised_time(cube: PriorCube) -> TimeMarginalisation:
    """The prior of the time as the likelihood takes it."""
    prior = cube.priors["coalescence_time"]
    return TimeMarginalisation(minimum=float(prior.minimum), maximum=float(prior.maximum))


def marginalised_distance(priors: Any) -> DistanceMarginalisation | None:
    """The prior of the distance as the likelihood takes it; None where it must be sampled, or is one number."""
    from bilby.core.prior import DeltaFunction, PowerLaw, Uniform

    prior = priors.get("luminosity_distance")
    if prior is None or type(prior) is DeltaFunction or not 0.0 < prior.minimum < prior.maximum < math.inf:
        return None
    if type(prior) is Uniform:
        return DistanceMarginalisation(minimum=prior.minimum, maximum=prior.maximum, power=0.0)
    if type(prior) is PowerLaw:
        return DistanceMarginalisation(minimum=prior.minimum, maximum=prior.maximum, power=float(prior.alpha))
    with contextlib.suppress(AnalysisInvalid):  # too uneven for a table: it is sampled
        return tabulated_distance_prior(prior.prob, minimum=prior.minimum, maximum=prior.maximum)
    return None
