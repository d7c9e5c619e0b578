"""A likelihood that is evaluated outside of JAX is a function with a gradient in it."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from bnserve_inference import DetectorData, LikelihoodOptions, full_analysis, likelihood
from bnserve_jax import log_likelihood_function
from bnserve_protocol import InvalidRequest

START = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0, "distance_mpc": 40.0,
    "inclination": 2.5, "total_mass": 2.76, "reference_phase": 0.3, "right_ascension": 3.45, "declination": -0.41,
    "polarization_angle": 0.3, "coalescence_time": 0.0,
}  # fmt: skip


class Counted:
    """A likelihood that counts what it is asked."""

    def __init__(self, inner):
        self.inner, self.questions = inner, []

    def log_likelihood(self, samples):
        self.questions.append(len(samples["mass_ratio"]))
        return self.inner.log_likelihood(samples)

    def gradients(self, samples):
        self.questions.append(len(samples["mass_ratio"]))
        return self.inner.gradients(samples)


@pytest.fixture(scope="module")
def outside(local):
    noise = np.random.default_rng(1).normal(size=(2, 4097))
    data = DetectorData("H1", 1e-23 * (noise[0] + 1j * noise[1]), np.full(4097, 8e-24), 1187008868.4, 16.0)
    options = LikelihoodOptions(modes=[(2, 2)])
    return likelihood(local, full_analysis([data], trigger_time=1187008882.4, f_min=60.0, f_max=128.0, options=options))


def test_values_and_gradients_are_those_of_the_likelihood(outside):
    counted = Counted(outside)
    value, slopes = jax.jit(jax.value_and_grad(log_likelihood_function(counted)))(START)
    expected = outside.gradients({name: [number] for name, number in START.items()})
    assert counted.questions == [1]
    assert float(value) == expected.log_likelihood[0]
    assert [float(slopes[name]) for name in expected.names] == list(expected.gradient[0])


def test_chains_side_by_side_ask_one_question(outside):
    counted = Counted(outside)
    function = log_likelihood_function(counted)
    ratios = jnp.linspace(1.0, 1.5, 6)
    values = jax.vmap(lambda q: function(START | {"mass_ratio": q}))(ratios)
    assert counted.questions == [6]
    assert np.array_equal(values, outside.log_likelihood(START | {"mass_ratio": np.asarray(ratios)}))
    jax.vmap(jax.grad(lambda q: function(START | {"mass_ratio": q})))(ratios)
    assert counted.questions == [6, 6]


def test_ones_own_parameters_have_derivatives_too(outside):
    function = log_likelihood_function(outside)

    def of_chirp_mass(chirp_mass):
        return function(START | {"total_mass": chirp_mass * (2.2**2 / 1.2) ** 0.6})

    chirp_mass, step = 2.76 / (2.2**2 / 1.2) ** 0.6, 1e-7
    near = [float(of_chirp_mass(chirp_mass + sign * step)) for sign in (1.0, -1.0)]
    assert float(jax.grad(of_chirp_mass)(chirp_mass)) == pytest.approx((near[0] - near[1]) / (2.0 * step), rel=1e-4)


def test_outside_the_models_ranges_it_is_minus_infinity(outside):
    assert float(log_likelihood_function(outside)(START | {"mass_ratio": 9.0})) == -np.inf


def test_what_has_no_derivative_is_named(outside):
    """An angle between spins that are none: accepted, and no parameter of this likelihood."""
    with pytest.raises(Exception, match="no derivative with respect to 'phi_12'"):
        jax.grad(log_likelihood_function(outside))(START | {"phi_12": 0.1})


def test_names_that_samples_may_have_have_derivatives(outside):
    given = {name: number for name, number in START.items() if name != "total_mass"} | {"chirp_mass": 1.2}
    slopes = jax.grad(log_likelihood_function(outside))(given)
    expected = outside.gradients({name: [number] for name, number in given.items()})
    assert {name: float(slope) for name, slope in slopes.items()} == dict(
        zip(expected.names, expected.gradient[0], strict=True)
    )


def test_single_precision_is_refused(outside):
    with jax.enable_x64(False), pytest.raises(InvalidRequest, match="single precision"):
        log_likelihood_function(outside)
