"""NUTS with our gradients: of the density that it follows, and of what it makes of a known one."""

from pathlib import Path

import jax
import numpy as np
import pytest

from benchmarks.gradient_samplers import __main__ as command
from benchmarks.gradient_samplers.density import Density
from benchmarks.gradient_samplers.nuts import Nuts, Settings, effective
from bnserve_posterior.events import changed_event, read_event
from bnserve_posterior.running import Folder, prepare
from bnserve_surrogate import Model

SMALL = Path(__file__).parents[1] / "posterior" / "small.toml"


@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    event = changed_event(read_event(SMALL), folder=tmp_path_factory.mktemp("small"))
    with Folder(event.output) as folder:
        return event, prepare(event, Model.default(), folder)


def test_the_gradient_is_that_of_the_density(prepared):
    event, of_event = prepared
    density = Density(of_event)
    place = density.coordinates(command.injected(of_event, event))[0]
    random = np.random.default_rng(1)
    points = place + 1e-3 * density.spread() * random.normal(size=(5, density.dimensions))
    value, gradient = density(points)
    assert np.isfinite(value).all()
    for column, width in enumerate(density.spread()):
        step = np.zeros(density.dimensions)
        step[column] = 1e-6 * width
        slope = (density(points + step).value - density(points - step).value) / (2.0 * step[column])
        np.testing.assert_allclose(gradient[:, column], slope, rtol=1e-3, atol=1e-3 * np.abs(gradient).max() * 1e-3)


def test_coordinates_and_the_way_back(prepared):
    event, of_event = prepared
    density = Density(of_event)
    cube = command.injected(of_event, event)
    np.testing.assert_allclose(density.points(density.coordinates(cube))[0], cube, rtol=1e-9, atol=1e-12)


def test_where_there_is_no_binary_the_density_is_0(prepared):
    event, of_event = prepared
    density = Density(of_event)
    place = density.coordinates(command.injected(of_event, event))
    value, gradient = density(np.concatenate([place, np.full_like(place, np.nan)]))
    assert np.isfinite(value[0])
    assert value[1] == -np.inf
    assert (gradient[1] == 0.0).all()


@pytest.fixture
def double():
    """All of this process, as callbacks have threads of their own."""
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.mark.slow
@pytest.mark.usefixtures("double")
def test_nuts_finds_a_known_density():
    """A normal distribution of unequal widths, and a column that comes round to its beginning."""
    widths = np.array([1.0, 0.02])

    def density(y):
        turns = 2.0 * np.pi * y[:, 2]
        value = -0.5 * np.sum((y[:, :2] / widths) ** 2, axis=1) + np.cos(turns)
        return value, np.column_stack([-y[:, :2] / widths**2, -2.0 * np.pi * np.sin(turns)])

    run = Nuts(density, np.zeros(3), np.ones(3), (2,), Settings(chains=16, rounds=3, steps=30, draws=60))
    run.warm_up()
    chains = run.sample()
    many = [effective(chains.draws[..., column]) for column in range(2)]
    assert chains.divergent == 0
    assert min(many) > 100
    np.testing.assert_allclose(chains.draws[..., :2].std(axis=(0, 1)), widths, rtol=0.2)
    assert np.abs(np.exp(2j * np.pi * chains.draws[..., 2]).mean()) == pytest.approx(0.446, abs=0.15)  # I1(1) / I0(1)
