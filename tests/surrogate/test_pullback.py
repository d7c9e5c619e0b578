"""What takes derivatives back to the parameters says what the derivatives of the modes say, and holds none of them."""

import tracemalloc

import numpy as np
import pytest

from bnserve_protocol import EvaluationOptions, InvalidRequest, OutOfDomain, ParameterBatch, RowStatus
from bnserve_surrogate import Model
from bnserve_surrogate.adjoint._call import ASSEMBLY
from bnserve_surrogate.adjoint.build import sources
from bnserve_surrogate.kernel._loader import DIGEST_PREFIX
from bnserve_surrogate.kernel.build import source_digest
from tests.surrogate.networks import ACTIVATIONS, network_model
from tests.surrogate.test_derivatives import FACES, FREQUENCIES, batch_of

TOLERANCE = 1e-11
"""Of the sum of all terms without their signs; both are sums of some thousand numbers."""
GRIDS = {
    "usual": FREQUENCIES,
    "below the band": np.linspace(1.5, 4.0, 20),
    "above half of it": np.linspace(1400.0, 2500.0, 20),
    "all of it": np.geomspace(1.5, 2900.0, 700),
    "dense": np.linspace(20.0, 2048.0, 5000),
}
OPTIONS = {
    "all modes": {},
    "(2, 2)": {"modes": ((2, 2),)},
    "another alone": {"modes": ((2, 1),)},
    "not in order": {"modes": ((3, 3), (2, 2))},
    "held phase": {"reference_frequency": 50.0},
    "held phase, (2, 2)": {"reference_frequency": 50.0, "modes": ((2, 2),)},
}


@pytest.fixture(scope="module")
def model():
    return Model.default()


def several():
    """Eleven binaries, so that whole vectors of rows are not enough."""
    random, batch = np.random.default_rng(5), ParameterBatch(batch_of().values.repeat(11, axis=0))
    for name, bounds in {"mass_ratio": (1.0, 2.8), "total_mass": (2.2, 3.2), "chi_1": (-0.4, 0.4)}.items():
        batch[name][:] = random.uniform(*bounds, 11)
    batch["lambda_1"][:] = random.uniform(0.0, 4000.0, 11)
    batch["mass_ratio"][3] = 1.0
    return batch


def bars_of(h):
    """Of a function that hears all frequencies alike."""
    random = np.random.default_rng(2)
    sizes = 1.0 / np.maximum(np.abs(h), 1e-3 * np.abs(h).max())
    return (random.normal(size=h.shape) + 1j * random.normal(size=h.shape)) * sizes


def check(model, f, batch, options):
    forward = model.predict_derivatives(f, batch, options=options)
    back = model.predict_pullback(f, batch, options=options)
    for name in ("modes", "h", "plus", "cross", "plus_slope", "cross_slope", "status", "frequencies"):
        assert np.array_equal(getattr(back, name), getattr(forward, name)), name
    bars = bars_of(forward.h)
    scale = np.abs(bars[:, :, None] * forward.derivatives).sum(axis=(1, 3))
    error = np.abs(back.pull_back(bars) - forward.pull_back(bars)) / scale
    assert error.max() <= TOLERANCE


@pytest.mark.parametrize("alignment", ["merger", "post_newtonian"])
@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
@pytest.mark.parametrize("f", GRIDS.values(), ids=GRIDS)
def test_it_is_what_the_derivatives_say(model, f, options, alignment):
    check(model, f, several(), EvaluationOptions(alignment=alignment, **options))


@pytest.mark.parametrize("changed", FACES.values(), ids=FACES)
def test_on_the_faces_of_the_box(model, changed):
    check(model, FREQUENCIES, batch_of(**changed), EvaluationOptions())


@pytest.mark.parametrize("name", ["fast", "wide", "paper"])
def test_of_other_models(name):
    """Of the last the regressor is a network, beside a polynomial."""
    own = EvaluationOptions(modes=((2, 2),))
    check(Model.load(name), FREQUENCIES[FREQUENCIES > 25.0], batch_of(), own)


@pytest.mark.parametrize("activation", ACTIVATIONS)
def test_of_a_network_alone(metadata, tensors, activation):
    network, _, _ = network_model(metadata, tensors, activation)
    check(network, np.geomspace(30.0, 1000.0, 50), batch_of(), EvaluationOptions())


def test_rows_have_their_bits_in_any_batch(model):
    batch = several()
    whole = model.predict_pullback(FREQUENCIES, batch)
    bars = bars_of(whole.h)
    found = whole.pull_back(bars)
    for rows in (slice(0, 1), slice(4, 7), slice(10, 11)):
        part = model.predict_pullback(FREQUENCIES, ParameterBatch(batch.values[rows]))
        assert part.pull_back(bars[rows]).tobytes() == found[rows].tobytes()


def test_numbers_with_gaps_between_rows_are_taken(model):
    found = model.predict_pullback(FREQUENCIES, several())
    bars = bars_of(found.h)
    held = np.zeros((*bars.shape[:2], bars.shape[2] + 9), dtype=np.complex128)
    held[:, :, : bars.shape[2]] = bars
    expected = found.pull_back(bars).tobytes()
    assert found.pull_back(held[:, :, : bars.shape[2]]).tobytes() == expected
    assert found.pull_back(np.asfortranarray(bars)).tobytes() == expected


def test_bad_rows_are_flagged_or_refused(model):
    batch = several()
    batch["mass_ratio"][1] = 99.0
    found = model.predict_pullback(FREQUENCIES, batch, options=EvaluationOptions(out_of_domain="flag"))
    assert found.status[:3].tolist() == [RowStatus.OK, RowStatus.OUT_OF_DOMAIN, RowStatus.OK]
    gradient = found.pull_back(np.ones_like(found.h))
    assert np.isnan(gradient[1]).all()
    assert np.isfinite(np.delete(gradient, 1, axis=0)).all()
    with pytest.raises(OutOfDomain, match="mass_ratio"):
        model.predict_pullback(FREQUENCIES, batch)


@pytest.mark.parametrize("shape", [(11, 7, 299), (10, 7, 300), (11, 300)])
def test_numbers_of_another_shape_are_refused(model, shape):
    found = model.predict_pullback(FREQUENCIES, several())
    with pytest.raises(InvalidRequest, match=r"one complex number for each of the modes' h, \(11, 7, 300\)"):
        found.pull_back(np.ones(shape, dtype=np.complex128))


def test_no_derivative_of_a_mode_is_held(model):
    found = model.predict_pullback(np.linspace(20.0, 2048.0, 50_000), batch_of())
    bars = np.ones_like(found.h)
    found.pull_back(bars)
    tracemalloc.start()
    found.pull_back(bars)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 0.1 * bars.nbytes


def test_what_is_shipped_was_built_from_these_sources():
    first = ASSEMBLY.read_text().split("\n", 1)[0]
    assert first == DIGEST_PREFIX + source_digest(sources()), "run: python -m bnserve_surrogate.adjoint.build"
