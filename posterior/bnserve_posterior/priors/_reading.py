"""The prior of an event: a file of bilby's, what the configuration adds, and what goes without saying."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from bnserve_posterior.events import EventInvalid
from bnserve_posterior.events._sections import PriorValue
from bnserve_posterior.priors._syntax import parse_prior, read_prior_file

_ISOTROPIC = {
    "ra": f"Uniform(minimum=0, maximum={2.0 * math.pi!r}, boundary='periodic')",
    "dec": "Cosine()",
    "theta_jn": "Sine()",
    "psi": f"Uniform(minimum=0, maximum={math.pi!r}, boundary='periodic')",
}
"""What holds for a source about whose place and orientation nothing is known."""
_PHASES = {
    "phase": f"Uniform(minimum=0, maximum={2.0 * math.pi!r}, boundary='periodic')",
    "reference_phase": f"Uniform(minimum=0, maximum={4.0 * math.pi!r}, boundary='periodic')",
}
"""Of the orbit, and twice as much, of its wave."""
_HALF_TIME = 0.1
"""Seconds to either side of the trigger, as bilby_pipe takes them."""


def priors_of(given: Mapping[str, PriorValue], trigger_time: float, phase: str = "phase") -> tuple[Any, list[str]]:
    """A ``PriorDict`` of bilby's, and a sentence for each prior that nobody stated.

    Parameters
    ----------
    given
        The section ``[prior]``: ``file``, and priors by name, which have precedence.
    trigger_time
        GPS seconds.
    phase
        ``"phase"``, which is integrated over, or ``"reference_phase"``.

    Raises
    ------
    EventInvalid
        A name or a prior that bilby or the likelihood does not know.
    """
    from bilby.core.prior import Constraint, PriorDict, Uniform

    found: dict[str, Any] = {}
    if (file := given.get("file")) is not None:
        found.update(read_prior_file(str(file)))
    found.update({name: _prior(name, value) for name, value in given.items() if name != "file"})
    stated = {name for name, prior in found.items() if not isinstance(prior, Constraint)}
    remarks = []
    for name, text in (*_ISOTROPIC.items(), (phase, _PHASES[phase])):
        if name not in stated:
            found[name] = parse_prior(name, text)
            remarks.append(f"The prior of {name} is {text.partition('(')[0]}: isotropic, because none was stated.")
    if "geocent_time" not in stated:
        ends = trigger_time - _HALF_TIME, trigger_time + _HALF_TIME
        found["geocent_time"] = Uniform(*ends, name="geocent_time")
        remarks.append(f"The prior of geocent_time is {_HALF_TIME:g} s to either side of the trigger: none was stated.")
    return PriorDict(found), remarks


def _prior(name: str, value: PriorValue) -> Any:
    from bilby.core.prior import DeltaFunction, Uniform

    if isinstance(value, str):
        return parse_prior(name, value)
    if isinstance(value, tuple):
        low, high = value
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise EventInvalid(f"A uniform prior is two increasing numbers; that of '{name}' is {low:g}, {high:g}.")
        return Uniform(low, high, name=name)
    return DeltaFunction(float(value), name=name)
