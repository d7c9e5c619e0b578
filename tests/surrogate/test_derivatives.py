"""Derivatives of modes are those of the model, to rounding; judged by the model in complex numbers, in plain numpy."""

import numpy as np
import pytest

from bnserve_protocol import (
    COORDINATES,
    DERIVATIVE_NAMES,
    PARAMETER_NAMES,
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    InvalidRequest,
    OutOfDomain,
    ParameterBatch,
    RowStatus,
    coordinate_jacobian,
)
from bnserve_surrogate import Model
from bnserve_surrogate.kernel._loader import DIGEST_PREFIX
from bnserve_surrogate.kernel.build import source_digest
from bnserve_surrogate.tangents._call import ASSEMBLY
from bnserve_surrogate.tangents.build import sources
from tests.surrogate.complex_model import ComplexModel, binaries
from tests.surrogate.networks import ACTIVATIONS, network_model

FREQUENCIES = np.geomspace(6.0, 1900.0, 300)
MERGER = EvaluationOptions(alignment="merger")
TOLERANCE = 1e-9
"""Of the largest logarithmic derivative of a row; the phase is 1e5 rad, and its rounding in h 1e-11."""
FACES = {
    "inside": {},
    "equal masses": {"mass_ratio": 1.0},
    "equal stars": {"mass_ratio": 1.0, "lambda_1": 400.0, "lambda_2": 400.0, "chi_1": 0.1, "chi_2": 0.1},
    "largest mass ratio": {"mass_ratio": 3.0},
    "weak tides": {"lambda_1": 2.0, "lambda_2": 3.0},
    "no tides": {"lambda_1": 0.0, "lambda_2": 0.0},
    "strong tides": {"lambda_1": 5000.0, "lambda_2": 5000.0},
    "fast spins": {"chi_1": 0.5, "chi_2": -0.5},
    "light": {"total_mass": 2.2},
    "shifted": {"reference_phase": 5.0, "time_shift": 0.02},
}
BINARY = {
    "mass_ratio": 1.4, "lambda_1": 350.0, "lambda_2": 900.0, "chi_1": 0.12, "chi_2": -0.07, "distance_mpc": 40.0,
    "inclination": 0.7, "total_mass": 2.9,
}  # fmt: skip


@pytest.fixture(scope="module")
def model():
    return Model.load("default", "2.0.0")


@pytest.fixture(scope="module")
def judge():
    return ComplexModel("default", "2.0.0")


def batch_of(**changed):
    return ParameterBatch.coerce({name: [value] for name, value in (BINARY | changed).items()})


@pytest.mark.parametrize("changed", FACES.values(), ids=FACES)
def test_they_are_the_models(model, judge, changed):
    batch = batch_of(**changed)
    found = model.predict_derivatives(FREQUENCIES, batch, options=MERGER)
    carrier = np.abs(found.h[0, found.modes.index((2, 2))])
    for place, (degree, order) in enumerate(found.modes):
        # Beyond half the band the phase of m = 1 is a line, which the judge does not know.
        inside = FREQUENCIES * batch["total_mass"][0] < order * 2000.0 * 2.0
        for p, name in enumerate(DERIVATIVE_NAMES):
            h, expected = judge.derivative(FREQUENCIES, binaries(batch)[0], name, f"{degree}{order}")
            ours, own = found.derivatives[0, place, p], found.h[0, place]
            if (np.abs(h) > 1e-12 * carrier).all():
                ours, expected = (ours / own)[inside], (expected / h)[inside]
            else:  # of equal stars modes of odd m vanish, and their derivatives do not
                ours, expected = (ours / carrier)[inside], (expected / carrier)[inside]
            scale = max(np.abs(expected).max(), 1e-6)
            assert np.abs(ours - expected).max() <= TOLERANCE * scale, (degree, order, name)


def test_the_modes_are_those_of_predict_modes(model):
    batch = batch_of()
    found, plain = (ask(FREQUENCIES, batch) for ask in (model.predict_derivatives, model.predict_modes))
    for name in ("h", "plus", "cross", "status"):
        assert getattr(found, name).tobytes() == getattr(plain, name).tobytes()
    h, derivatives = found
    assert h is found.h
    assert derivatives.shape == (1, 7, 6, len(FREQUENCIES))


@pytest.mark.parametrize(
    ("name", "version"), [("fast", "2.0.0"), ("wide", "1.0.0"), ("default", "1.0.0"), ("paper", "1.0.0")]
)
def test_other_models_have_them(name, version):
    """Of the last the regressor is a network, beside a polynomial."""
    model, judge, batch = Model.load(name, version), ComplexModel(name, version), batch_of()
    inside = FREQUENCIES[FREQUENCIES > 25.0]
    found = model.predict_derivatives(inside, batch, options=EvaluationOptions(alignment="merger", modes=((2, 2),)))
    for p, parameter in enumerate(DERIVATIVE_NAMES):
        h, expected = judge.derivative(inside, binaries(batch)[0], parameter)
        error = np.abs(found.derivatives[0, 0, p] / found.h[0, 0] - expected / h)
        assert error.max() <= TOLERANCE * np.abs(expected / h).max(), parameter


def by_differences(ask, batch, name, step):
    """Fourth order, of the logarithm of what ``ask`` gives."""
    total = 0.0
    for times, weight in ((1, 2.0 / 3.0), (2, -1.0 / 12.0)):
        above, below = (ParameterBatch(batch.values.copy()) for _ in range(2))
        above[name][:] += times * step
        below[name][:] -= times * step
        total = total + weight * np.log(ask(above) / ask(below))
    return total / step


@pytest.mark.parametrize("activation", ACTIVATIONS)
def test_every_activation_of_a_network_has_its_slope(metadata, tensors, activation):
    """Of eleven binaries, so that whole vectors of rows are not enough."""
    model, own, _ = network_model(metadata, tensors, activation)
    random, batch = np.random.default_rng(5), ParameterBatch(batch_of().values.repeat(11, axis=0))
    for name, bounds in {"mass_ratio": (1.2, 2.8), "chi_1": (-0.4, 0.4), "chi_2": (-0.4, 0.4)}.items():
        batch[name][:] = random.uniform(*bounds, 11)
    for name in ("lambda_1", "lambda_2"):
        batch[name][:] = random.uniform(100.0, 4000.0, 11)
    f = own["22/amplitude_nodes"][5:40:7] / (batch["total_mass"][0] * SOLAR_MASS_SECONDS)
    found = model.predict_derivatives(f, batch, options=MERGER)
    for name, step in {"mass_ratio": 1e-6, "chi_1": 1e-6, "chi_2": 1e-6, "lambda_1": 1e-2, "lambda_2": 1e-2}.items():
        expected = by_differences(lambda it: model.predict_modes(f, it, options=MERGER).h, batch, name, step)
        ours = found.derivatives[:, :, DERIVATIVE_NAMES.index(name)] / found.h
        scale = np.abs(expected).max(axis=(1, 2), keepdims=True)
        np.testing.assert_allclose(ours / scale, expected / scale, atol=1e-5)


OUTSIDE = {"below": np.linspace(1.5, 4.0, 20), "above half": np.linspace(1400.0, 2500.0, 20)}
STEPS = {"below": (1e-7, 1e-6, 1e-6), "above half": (1e-5, 1e-5, 4e-6)}


@pytest.mark.parametrize("where", OUTSIDE)
@pytest.mark.parametrize("alignment", ["merger", "post_newtonian"])
def test_outside_the_trained_band_too(model, alignment, where):
    """Below it residuals fade, above half of it the phase of m = 1 is a line."""
    f, batch = OUTSIDE[where], batch_of()
    for modes in (((2, 2),), ((2, 1),), ((3, 3),)):
        options = EvaluationOptions(alignment=alignment, modes=modes)
        found = model.predict_derivatives(f, batch, options=options)
        for name, step in zip(("total_mass", "chi_1", "mass_ratio"), STEPS[where], strict=True):
            wanted = by_differences(lambda it, o=options: model.predict_modes(f, it, options=o).h, batch, name, step)
            ours = found.derivatives[:, :, DERIVATIVE_NAMES.index(name)] / found.h
            np.testing.assert_allclose(ours, wanted, rtol=1e-5, atol=2e-5 * np.abs(wanted).max() + 0.05)


def test_above_the_band_there_is_nothing(model):
    found = model.predict_derivatives(np.array([100.0, 5000.0]), batch_of())
    assert np.abs(found.derivatives[..., 1]).max() == 0.0
    assert np.abs(found.derivatives[..., 0]).min() > 0.0


def test_rows_have_their_bits_in_any_batch(model):
    random = np.random.default_rng(3)
    batch = batch_of().values.repeat(11, axis=0)
    batch[:, 0] = random.uniform(1.0, 3.0, 11)
    batch[:, 7] = random.uniform(2.0, 4.0, 11)
    whole = model.predict_derivatives(FREQUENCIES, ParameterBatch(batch)).derivatives
    for i in (0, 4, 10):
        alone = model.predict_derivatives(FREQUENCIES, ParameterBatch(batch[i : i + 1])).derivatives
        assert alone.tobytes() == whole[i : i + 1].tobytes()


def test_one_mode_has_the_bits_that_it_has_among_others(model):
    whole = model.predict_derivatives(FREQUENCIES, batch_of())
    one = model.predict_derivatives(FREQUENCIES, batch_of(), options=EvaluationOptions(modes=((3, 3),)))
    assert (
        one.derivatives[:, 0].tobytes()
        == np.ascontiguousarray(whole.derivatives[:, whole.modes.index((3, 3))]).tobytes()
    )


def test_bad_rows_are_flagged_or_refused(model):
    values = batch_of().values.repeat(3, axis=0)
    values[1, 0] = 99.0
    found = model.predict_derivatives(
        FREQUENCIES, ParameterBatch(values), options=EvaluationOptions(out_of_domain="flag")
    )
    assert found.status.tolist() == [RowStatus.OK, RowStatus.OUT_OF_DOMAIN, RowStatus.OK]
    assert np.isnan(found.derivatives[1]).all()
    assert np.isfinite(found.derivatives[[0, 2]]).all()
    with pytest.raises(OutOfDomain, match="mass_ratio"):
        model.predict_derivatives(FREQUENCIES, ParameterBatch(values))


def test_a_reference_frequency_holds_the_phase(model):
    options = EvaluationOptions(reference_frequency=50.0, alignment="merger")
    batch, f = batch_of(), FREQUENCIES[FREQUENCIES < 1000.0]
    found = model.predict_derivatives(f, batch, options=options)
    ask = lambda it: model.predict_modes(f, it, options=options).h  # noqa: E731
    wanted = by_differences(ask, batch, "chi_1", 1e-5)
    ours = found.derivatives[:, :, DERIVATIVE_NAMES.index("chi_1")] / found.h
    np.testing.assert_allclose(ours, wanted, rtol=1e-6, atol=1e-5 * np.abs(wanted).max())


def test_polarisations_have_all_parameters(model):
    batch = batch_of()
    found = model.predict_derivatives(FREQUENCIES, batch, options=MERGER).polarizations()
    steps = dict(zip(PARAMETER_NAMES, (1e-6, 1.0, 1.0, 1e-6, 1e-6, 1e-2, 1e-3, 1e-7, 1e-3, 1e-6), strict=True))
    for which in (0, 1):
        ask = lambda it, k=which: model.predict_batch(FREQUENCIES, it, options=MERGER)[k]  # noqa: E731
        whole = ask(batch)
        for place, name in enumerate(PARAMETER_NAMES):
            wanted = by_differences(ask, batch, name, steps[name])
            ours = found[which][:, place] / whole
            np.testing.assert_allclose(ours, wanted, rtol=1e-5, atol=2e-6 * np.abs(wanted).max(), err_msg=name)


NEW = ("log_chirp_mass", "log_mass_ratio", "lambda_tilde", "delta_lambda_tilde", "chi_eff", "chi_difference",
       "log_distance", "cos_inclination", "reference_phase", "time_shift")  # fmt: skip


def test_the_chain_rule_to_other_coordinates():
    batch = batch_of()
    jacobian = coordinate_jacobian(batch, NEW)
    p = {name: batch[name] for name in PARAMETER_NAMES}
    for column, name in enumerate(NEW):  # going along one coordinate leaves the others
        moved = {key: value + 1e-7 * jacobian[:, row, column] for row, (key, value) in enumerate(p.items())}
        for other in NEW:
            change = (COORDINATES[other](moved) - COORDINATES[other](p)) / 1e-7
            assert change == pytest.approx(
                1.0 if other == name else 0.0, abs=3e-5 * max(1, abs(COORDINATES[other](p)[0]))
            )


def test_coordinates_that_tell_nothing_apart_are_refused():
    singular = ("chirp_mass", "symmetric_mass_ratio", *PARAMETER_NAMES[1:7], *PARAMETER_NAMES[8:])
    assert coordinate_jacobian(batch_of(), singular).shape == (1, 10, 10)
    with pytest.raises(InvalidRequest, match="equal masses"):
        coordinate_jacobian(batch_of(mass_ratio=1.0), singular)
    with pytest.raises(InvalidRequest, match="'chrip_mass' is none of them"):
        coordinate_jacobian(batch_of(), ("chrip_mass", *PARAMETER_NAMES[1:]))
    with pytest.raises(InvalidRequest, match="got 9"):
        coordinate_jacobian(batch_of(), PARAMETER_NAMES[1:])


def test_what_is_shipped_was_built_from_these_sources():
    first = ASSEMBLY.read_text().split("\n", 1)[0]
    assert first == DIGEST_PREFIX + source_digest(sources()), "run: python -m bnserve_surrogate.tangents.build"
