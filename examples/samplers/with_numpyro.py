"""NumPyro's no-U-turn sampler through a running server, whose likelihood is a function in JAX.

pip install numpyro ./protocol ./model_store ./surrogate ./inference ./client ./jax_model
python examples/samplers/with_numpyro.py http://127.0.0.1:8000

``bnserve_jax.log_likelihood_function`` is a likelihood without its weights: the server evaluates it, with its gradient.
A model of NumPyro has it as a factor, and gives the potential. Its chains are a ``vmap``: what all of them ask at once
is one request.
"""

import time
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import numpyro
from jax.flatten_util import ravel_pytree
from numpy.typing import NDArray
from numpyro import distributions
from numpyro.diagnostics import effective_sample_size
from numpyro.infer import MCMC, NUTS, init_to_value
from numpyro.infer.util import initialize_model
from problem import FIXED, PRIOR, SAMPLED, SIGNAL, Problem, arguments, report

from bnserve_client import Likelihood, Model
from bnserve_jax import log_likelihood_function
from bnserve_protocol import LikelihoodGradients

Floats = NDArray[np.float64]

jax.config.update("jax_enable_x64", True)  # of numbers with 7 digits no phase is left


class Counted:
    """A likelihood, and how often it was asked for how many."""

    def __init__(self, likelihood: Likelihood) -> None:
        self.likelihood, self.likelihoods, self.requests = likelihood, 0, 0

    def log_likelihood(self, samples: Any) -> Floats:
        """Values alone."""
        return self.gradients(samples).log_likelihood

    def gradients(self, samples: Any) -> LikelihoodGradients:
        """Values and gradients."""
        found = self.likelihood.gradients(samples)
        self.requests += 1
        self.likelihoods += len(found.log_likelihood)
        return found


def model_of(counted: Counted) -> Any:
    """The posterior as a model of NumPyro."""
    log_likelihood = log_likelihood_function(counted)

    def model() -> None:
        at = {name: numpyro.sample(name, distributions.Uniform(*PRIOR[name])) for name in SAMPLED}
        chirp_mass, q = at.pop("chirp_mass"), at["mass_ratio"]
        total_mass = chirp_mass * ((1.0 + q) ** 2 / q) ** 0.6
        numpyro.factor("volume", 2.0 * jnp.log(at["distance_mpc"]))  # uniform in it
        numpyro.factor("likelihood", log_likelihood(FIXED | at | {"total_mass": total_mass}))

    return model


def sample(counted: Counted, chains: int, warm_up: int, draws: int, seed: int = 1) -> tuple[Floats, int]:
    """Draws ``(chains, draws, 4)``, and how many diverged; the metric is the curvature where the chains begin."""
    first, second, third = jax.random.split(jax.random.key(seed), 3)
    start = init_to_value(values={name: SIGNAL[name] for name in SAMPLED})  # of a trigger
    known = initialize_model(first, model_of(counted), init_strategy=start)
    center, named = ravel_pytree(known.param_info.z)
    potential = known.potential_fn
    step = 1e-3 * jnp.eye(len(SAMPLED))
    around = jax.vmap(jax.grad(lambda flat: potential(named(flat))))(jnp.concatenate([center + step, center - step]))
    curvature = (around[: len(SAMPLED)] - around[len(SAMPLED) :]) / 2e-3
    metric = jnp.linalg.inv(0.5 * (curvature + curvature.T) + jnp.eye(len(SAMPLED)))
    places = jax.random.multivariate_normal(second, center, metric, (chains,))
    nuts = NUTS(
        potential_fn=potential,
        inverse_mass_matrix=metric,
        dense_mass=True,
        adapt_mass_matrix=False,
        target_accept_prob=0.9,
        max_tree_depth=(5, 6),  # all chains wait for the longest trajectory
    )
    run = MCMC(
        nuts, num_warmup=warm_up, num_samples=draws, num_chains=chains, chain_method="vectorized", progress_bar=False
    )
    run.run(third, init_params=jax.vmap(named)(places), extra_fields=("diverging",))
    found = jax.vmap(jax.vmap(known.postprocess_fn))(run.get_samples(group_by_chain=True))
    values = np.stack([np.asarray(found[name]) for name in SAMPLED], axis=2)
    return values, int(run.get_extra_fields()["diverging"].sum())


def main() -> None:
    """Sample, and report."""
    chosen = arguments(__doc__)
    chains, warm_up, draws = (16, 40, 40) if chosen.short else (64, 300, 500)
    with Model.connect(chosen.address) as model:
        counted = Counted(Problem.pose(model, chosen.asd).likelihood)
        started = time.perf_counter()
        found, divergent = sample(counted, chains, warm_up, draws)
        seconds = time.perf_counter() - started
    effective = min(float(effective_sample_size(each)) for each in np.moveaxis(found, 2, 0))
    print(f"{effective:.0f} effective of {chains * draws} draws, {divergent} divergent")
    counts = f"NumPyro: {counted.likelihoods} likelihoods in {counted.requests} requests"
    report(found.reshape(-1, len(SAMPLED)), None, seconds, counts)


if __name__ == "__main__":
    main()
