"""jim with our waveform on an event of ``bnserve analyse``: its relative binning, its sampler flowMC, the same priors.

jim is used as it is: what is made here are its own objects, detectors with our data, and a prior from a table. The
phase is integrated over by jim, and the distance is sampled, which its relative binning does not integrate over.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import ripplegw
from jimgw.core.jim import Jim
from jimgw.core.prior import CombinePrior, Prior
from jimgw.core.single_event.data import Data, PowerSpectrum
from jimgw.core.single_event.detector import get_detector_preset
from jimgw.core.single_event.likelihood import HeterodynedTransientLikelihoodFD
from jimgw.core.single_event.transforms import MassRatioToSymmetricMassRatioTransform
from jimgw.core.transforms import BoundToUnbound
from jimgw.samplers.config import FlowMCConfig, MALAConfig
from numpy.typing import NDArray

import bnserve_jax.ripple
from bnserve_inference import DetectorData
from bnserve_posterior.events import Event
from bnserve_posterior.running import Prepared

Floats = NDArray[np.float64]

NAMES = {
    "chirp_mass": "M_c", "mass_ratio": "q", "chi_1": "s1_z", "chi_2": "s2_z", "lambda_1": "lambda_1",
    "lambda_2": "lambda_2", "luminosity_distance": "d_L", "theta_jn": "iota", "ra": "ra", "dec": "dec", "psi": "psi",
    "coalescence_time": "t_c",
}  # fmt: skip
"""Ours, and jim's."""
_TABLE = 4001
_EPSILON = 0.3
"""Radians of phase in a bin of jim's."""


@dataclass(frozen=True)
class Settings:
    """flowMC's: chains, steps of each kind in a loop, loops, and how much its flow learns in a loop."""

    chains: int = 50
    local_steps: int = 40
    global_steps: int = 100
    training_loops: int = 6
    production_loops: int = 5
    epochs: int = 6
    step: float = 0.05
    seed: int = 1


class Sampled(NamedTuple):
    """By our names, ``(chains, draws)``; what was evaluated, and shares of accepted steps of each kind."""

    columns: dict[str, Floats]
    likelihoods: int
    gradients: int
    local: float
    of_flow: float
    warm_up: float
    """The training loops' share of all."""


class Tabulated(Prior):
    """A prior of one parameter by a table of its density, between which ln p is linear."""

    values: jax.Array
    log_density: jax.Array
    distribution: jax.Array

    def __init__(self, name: str, values: Floats, density: Floats) -> None:
        super().__init__([name])
        positive = np.maximum(density, 1e-12 * density.max())
        steps = 0.5 * (positive[1:] + positive[:-1]) * np.diff(values)
        whole = np.concatenate([[0.0], np.cumsum(steps)])
        self.values, self.log_density = jnp.asarray(values), jnp.asarray(np.log(positive / whole[-1]))
        self.distribution = jnp.asarray(whole / whole[-1])

    def log_prob(self, z: dict[str, Any]) -> Any:
        """ln p."""
        return jnp.interp(z[self.parameter_names[0]], self.values, self.log_density)

    def sample(self, rng_key: Any, n_samples: int) -> dict[str, Any]:
        """Draws."""
        u = jax.random.uniform(rng_key, (n_samples,))
        return {self.parameter_names[0]: jnp.interp(u, self.distribution, self.values)}


def priors_of(prepared: Prepared) -> dict[str, Tabulated]:
    """The event's, by our names; of the polarisation the half that is sampled."""
    found = {}
    for name, known_as in NAMES.items():
        prior = prepared.cube.priors[name]
        low, high = float(prior.minimum), float(prior.maximum)
        if name == "psi" and prepared.cube.folded:
            high = low + 0.5 * np.pi
        values = np.linspace(low, high, _TABLE)
        found[name] = Tabulated(known_as, values, np.asarray(prior.prob(values)))
    return found


def detector_of(one: DetectorData) -> Any:
    """jim's detector with our data."""
    frequencies = jnp.arange(len(one.strain)) / one.duration
    found: Any = get_detector_preset()[one.name]
    found.set_data(Data.from_fd(jnp.asarray(one.strain), frequencies, one.start_time, one.name))
    density = np.where(np.isfinite(one.asd) & (one.asd > 0.0), one.asd, 1.0) ** 2  # of where there is no data
    found.set_psd(PowerSpectrum(jnp.asarray(density), frequencies))
    return found


def likelihood_of(prepared: Prepared, event: Event, binary: dict[str, float]) -> Any:
    """jim's relative binning about a binary, by our names."""
    section = event.data
    q = binary["mass_ratio"]
    reference = {known_as: binary[name] for name, known_as in NAMES.items() if name != "mass_ratio"}
    waveform = ripplegw.waveform(
        "bnserve", f_ref=section.f_min, model=bnserve_jax.Model.default(), modes=event.likelihood.modes
    )
    return HeterodynedTransientLikelihoodFD(
        [detector_of(one) for one in prepared.data.detectors], waveform, f_min=section.f_min, f_max=section.f_max,
        trigger_time=section.trigger_time, epsilon=_EPSILON, phase_marginalization=True,
        reference_parameters=reference | {"eta": q / (1.0 + q) ** 2, "phase_c": 0.0},
    )  # fmt: skip


def sampled(prepared: Prepared, event: Event, start: dict[str, Floats], settings: Settings) -> Sampled:
    """The posterior by flowMC.

    Parameters
    ----------
    prepared, event
        The event, with an injection.
    start
        Where the chains begin, by our names but for the distance.
    settings
        How long.
    """
    injected = prepared.data.injection
    assert injected is not None, "an event with an injection"
    priors = priors_of(prepared)
    binary = {name: float(injected.get(name, 0.0)) for name in NAMES}
    unbounded = [
        BoundToUnbound(([prior.parameter_names[0]], [f"{prior.parameter_names[0]}_unbounded"]), *_ends(prior))
        for name, prior in priors.items()
        if name != "psi"
    ]
    jim = Jim(
        likelihood_of(prepared, event, binary),
        CombinePrior(list(priors.values())),
        FlowMCConfig(
            n_chains=settings.chains,
            n_local_steps=settings.local_steps,
            n_global_steps=settings.global_steps,
            n_training_loops=settings.training_loops,
            n_production_loops=settings.production_loops,
            n_epochs=settings.epochs,
            local_kernel=MALAConfig(step_size=settings.step),
            rq_spline_hidden_units=[64, 64],
            rq_spline_n_layers=6,
            n_max_examples=10000,
            batch_size=2500,
            global_thinning=1,
            early_stopping=False,
        ),
        sample_transforms=unbounded,
        likelihood_transforms=[MassRatioToSymmetricMassRatioTransform],
        periodic={"psi": _ends(priors["psi"])},
        seed=settings.seed,
    )
    jim.sample(_start(jim, unbounded, start, binary["luminosity_distance"], settings))
    sampler: Any = jim.sampler
    resources = sampler._flowmc_sampler.resources
    positions = np.asarray(resources["positions_production"].data)
    flat = jax.vmap(jim.add_name)(jnp.asarray(positions.reshape(-1, positions.shape[2])))
    for transform in reversed(unbounded):
        flat = jax.vmap(transform.backward)(flat)
    low, high = _ends(priors["psi"])
    flat["psi"] = low + (flat["psi"] - low) % (high - low)  # proposals of the flow go round
    told = jim.get_diagnostics()
    loops = settings.training_loops + settings.production_loops
    return Sampled(
        {name: np.asarray(flat[known_as]).reshape(positions.shape[:2]) for name, known_as in NAMES.items()},
        settings.chains * (settings.local_steps + settings.global_steps) * loops,
        settings.chains * settings.local_steps * loops,
        _share(told["acceptance_production_local"]),
        _share(told["acceptance_production_global"]),
        settings.training_loops / loops,
    )


def _ends(prior: Tabulated) -> tuple[float, float]:
    return float(prior.values[0]), float(prior.values[-1])


def _share(accepted: Floats) -> float:
    """Of the steps of one kind; those of the other are -inf there."""
    return float(accepted[np.isfinite(accepted)].mean())


def _start(jim: Any, unbounded: list[Any], start: dict[str, Floats], distance: float, settings: Settings) -> Any:
    """In jim's coordinates; distances are a tenth about that of the binary."""
    count = settings.chains
    far = distance * (1.0 + 0.1 * np.random.default_rng(settings.seed).normal(size=count).clip(-2.0, 2.0))
    named = {NAMES[name]: jnp.asarray(column) for name, column in (start | {"luminosity_distance": far}).items()}
    for transform in unbounded:
        named = jax.vmap(transform.forward)(named)
    return jnp.stack([named[name] for name in jim.sampling_parameter_names], axis=1)
