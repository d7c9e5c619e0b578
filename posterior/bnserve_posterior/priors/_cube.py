"""The unit cube of a prior: its points are binaries, as probable as the prior says."""

from __future__ import annotations

import math
from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.events import EventInvalid
from bnserve_posterior.priors._parameters import derived_parameters, likelihood_batch
from bnserve_protocol import LikelihoodBatch

Floats = NDArray[np.float64]

_QUARTER = 0.5 * math.pi
_RADIANS = {"dec": (-_QUARTER, _QUARTER, "Cosine()"), "theta_jn": (0.0, math.pi, "Sine()")}
"""Where angles from pole to pole are, and the isotropic prior: the likelihood goes on beyond them, or has nothing."""
_SLACK = 1e-9
_DRAWS, _SEED = 200_000, 12
"""For the part of the cube that constraints leave: known to a thousandth."""


class PriorCube:
    """A prior over the unit cube.

    Parameters
    ----------
    priors
        bilby's, by name.
    trigger_time
        GPS seconds.
    integrated
        bilby's names of what the likelihood integrates over; they are no columns.
    quadrupole
        Whether the signal is of modes of order 2 alone and its phase is integrated over: another quarter of a turn of
        ``psi`` turns the sign of such a signal, which is a phase, so that half of the range is sampled.

    Attributes
    ----------
    priors
        By name, with ``coalescence_time``, seconds from the trigger, in place of ``geocent_time``: GPS seconds are
        known to a quarter of a microsecond alone.
    names, fixed
        Of the columns; and the values of what does not vary.
    constraints
        bilby's, of what follows from these.

    Raises
    ------
    EventInvalid
        Priors that depend on each other, of angles beyond a pole, or none that varies.
    """

    def __init__(
        self, priors: Any, trigger_time: float, integrated: Collection[str] = (), quadrupole: bool = False
    ) -> None:
        from bilby.core.prior import Constraint, DeltaFunction, Prior

        self.trigger_time, self.priors = trigger_time, _from_trigger(priors, trigger_time)
        priors = self.priors
        self.constraints = {name: prior for name, prior in priors.items() if isinstance(prior, Constraint)}
        self.fixed = {name: float(prior.peak) for name, prior in priors.items() if isinstance(prior, DeltaFunction)}
        varied = [name for name in priors if name not in self.constraints and name not in self.fixed]
        for name in varied:
            if type(priors[name]).rescale is Prior.rescale or hasattr(priors[name], "condition_func"):
                raise EventInvalid(f"The prior of '{name}' depends on others; give one that stands for itself.")
            if not (math.isfinite(priors[name].minimum) and math.isfinite(priors[name].maximum)):
                raise EventInvalid(f"The prior of '{name}' has no ends; give one with a minimum and a maximum.")
        _check_angles({name: priors[name] for name in (*varied, *self.fixed)})
        gone = {"coalescence_time" if name == "geocent_time" else name for name in integrated}
        self.names = tuple(name for name in varied if name not in gone)
        for name in gone:
            self.fixed.pop(name, None)
        if not self.names:
            raise EventInvalid("Every parameter is fixed: there is nothing to sample. Give a prior to one at least.")
        self.folded = quadrupole and self._psi_is_even()

    def __len__(self) -> int:
        return len(self.names)

    def __call__(self, u: Floats) -> dict[str, Floats]:
        """The parameters at points ``(N, D)``, by bilby's names and in its units, ``(N,)`` each; fixed ones, too."""
        found = {
            name: np.asarray(self.rescaled(name, column), dtype=np.float64)
            for name, column in zip(self.names, u.T, strict=True)
        }
        return {**found, **{name: np.full(len(u), value) for name, value in self.fixed.items()}}

    def rescaled(self, name: str, u: Floats) -> Floats:
        """The values ``(N,)`` of one parameter where its probability reaches ``u`` ``(N,)``, in its unit."""
        if name == "psi" and self.folded:
            return np.asarray(self.priors[name].minimum + _QUARTER * u)
        return np.asarray(self.priors[name].rescale(u))

    def batch(self, values: dict[str, Floats]) -> LikelihoodBatch:
        """What the likelihood takes: N rows of parameters by bilby's names, ``(N,)`` each.

        Raises
        ------
        InvalidParameters
            Too few to know the binary, or a name that is unknown.
        """
        return likelihood_batch(values, self.trigger_time)

    def allowed(self, values: dict[str, Floats]) -> NDArray[np.bool_]:
        """Which binaries, ``(N,)``, the constraints allow.

        Raises
        ------
        EventInvalid
            A constraint of what does not follow from the parameters.
        """
        count = len(next(iter(values.values())))
        good = np.ones(count, dtype=bool)
        if self.constraints:
            derived = derived_parameters(values)
            for name, prior in self.constraints.items():
                if name not in derived:
                    raise EventInvalid(
                        f"There is no '{name}' to be constrained; there are {', '.join(sorted(derived))}."
                    )
                good &= (derived[name] >= prior.minimum) & (derived[name] <= prior.maximum)
        return good

    def log_allowed(self) -> float:
        """ln of the part of the cube that the constraints allow, by which the evidence is larger than over the cube.

        Raises
        ------
        EventInvalid
            They allow nothing.
        """
        if not self.constraints:
            return 0.0
        draws = self(np.random.default_rng(_SEED).random((_DRAWS, len(self))))
        part = float(self.allowed(draws).mean())
        if part == 0.0:
            raise EventInvalid(f"Of {_DRAWS} draws from the prior none meets the constraints: widen one or the other.")
        return math.log(part)

    def unfolded(self, values: dict[str, Floats], random: np.random.Generator) -> dict[str, Floats]:
        """Samples ``(N,)`` each over the whole of the prior, where half of the range of ``psi`` was sampled."""
        if not self.folded:
            return values
        turned = values["psi"] + _QUARTER * random.integers(2, size=len(values["psi"]))
        return {**values, "psi": turned}

    def periodic(self) -> tuple[int, ...]:
        """Columns whose ends are the same: ``psi`` and the phase over all of their range.

        The right ascension is none: proposals take it together with the declination.
        """
        whole = {"psi": 0.5 * math.pi if self.folded else math.pi, "reference_phase": 4.0 * math.pi}
        found = []
        for name, period in whole.items():
            if name in self.names:
                low, high = self.rescaled(name, np.array([0.0, 1.0]))
                if type(self.priors[name]).__name__ == "Uniform" and math.isclose(high - low, period):
                    found.append(self.names.index(name))
        return tuple(found)

    def _psi_is_even(self) -> bool:
        from bilby.core.prior import Uniform

        if "psi" not in self.names:
            return False
        prior = self.priors["psi"]
        return type(prior) is Uniform and math.isclose(prior.maximum - prior.minimum, math.pi)


def _check_angles(priors: dict[str, Any]) -> None:
    for name in _RADIANS.keys() & priors.keys():
        least, most, isotropic = _RADIANS[name]
        low, high = priors[name].minimum, priors[name].maximum
        if low < least - _SLACK or high > most + _SLACK:
            raise EventInvalid(
                f"The prior of '{name}' is from {low:g} to {high:g}; it is an angle in radians, from {least:.4g} to "
                f"{most:.4g}, and isotropic as {isotropic}."
            )


def _from_trigger(priors: Any, trigger_time: float) -> dict[str, Any]:
    from bilby.core.prior import DeltaFunction, Uniform

    found = dict(priors)
    time = found.pop("geocent_time")
    if type(time) is DeltaFunction:
        found["coalescence_time"] = DeltaFunction(time.peak - trigger_time, name="coalescence_time")
    elif type(time) is Uniform:
        ends = time.minimum - trigger_time, time.maximum - trigger_time
        found["coalescence_time"] = Uniform(*ends, name="coalescence_time")
    else:
        raise EventInvalid(
            "The prior of geocent_time must be uniform, or one number: give its two ends in GPS seconds."
        )
    return found
