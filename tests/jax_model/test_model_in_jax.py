"""The model in JAX is the model of the kernel, differentiable, on any device."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import bnserve_jax
from bnserve_protocol import (
    PARAMETER_NAMES,
    EvaluationOptions,
    InvalidFrequencies,
    InvalidParameters,
    InvalidRequest,
    ParametersWithExtrinsic,
)
from bnserve_surrogate import Model

FREQUENCIES = np.geomspace(5.0, 4000.0, 300)
"""From the band of ``default`` at any mass to above it."""


def binaries(description, count=12, seed=1):
    """Anywhere in a model's box, the first with equal stars, with shifts of phase and time."""
    random = np.random.default_rng(seed)
    ranges = {entry.name: (entry.minimum, entry.maximum) for entry in description.parameters}
    ranges |= {
        "distance_mpc": (40.0, 400.0), "inclination": (0.0, 3.0), "total_mass": (2.2, 4.0),
        "reference_phase": (0.0, 6.0), "time_shift": (-0.1, 0.1),
    }  # fmt: skip
    found = {name: random.uniform(*ranges[name], count) for name in PARAMETER_NAMES}
    found["mass_ratio"][0] = 1.0
    found["chi_2"][0], found["lambda_2"][0] = found["chi_1"][0], found["lambda_1"][0]
    return found


def worst(one, other):
    """The largest difference, of the largest value of its row; where all of that is zero, so must be the other."""
    one, other = np.asarray(one), np.asarray(other)
    return float((np.abs(one - other).max(axis=-1) / np.maximum(np.abs(other).max(axis=-1), 1e-300)).max())


def devices():
    found = [jax.devices("cpu")[0]]
    for platform in ("gpu", "tpu"):
        try:
            found += jax.devices(platform)[:1]
        except RuntimeError:
            continue
    return found


@pytest.fixture(params=["cpu", "gpu"])
def device(request):
    there = {"gpu" if device.platform in ("cuda", "rocm") else device.platform: device for device in devices()}
    if request.param not in there:
        pytest.skip(f"no {request.param} here")
    with jax.default_device(there[request.param]):
        yield there[request.param]


@pytest.mark.parametrize("name", ["default", "fast", "wide"])
def test_it_is_the_kernels_model(name, device):
    local, model = Model.load(name), bnserve_jax.Model.load(name)
    given, f = binaries(model.description), np.geomspace(local.description.frequency_band[0], 4000.0, 300)
    expected = local.predict_batch(f, given, options=EvaluationOptions(alignment="merger"))
    plus, cross = model.predict(f, given, alignment="merger")
    assert plus.devices() == {device}
    assert worst(plus, expected.plus) < 1e-9
    assert worst(cross, expected.cross) < 1e-9
    assert np.array_equal(np.asarray(plus) == 0.0, expected.plus == 0.0)  # above the band


def test_every_mode_is_the_kernels(local, model):
    given, modes = binaries(model.description), model.description.modes
    options = {"alignment": "post_newtonian", "reference_frequency": 20.0}
    found = jax.jit(lambda p: [model.predict_mode(FREQUENCIES, p, mode, **options) for mode in modes])(given)
    for mode, strain in zip(modes, found, strict=True):
        own = EvaluationOptions(modes=(mode,), **options)
        factored = local.predict_factored(FREQUENCIES, given, options=own)
        assert worst(strain, factored.h) < 1e-9, mode
    assert len(modes) == 7


@pytest.mark.parametrize(("name", "version"), [("default", "1.0.0"), ("paper", "1.0.0")])
def test_other_regressors_and_splines_on_knots_of_their_own_count_as_well(name, version):
    local, model = Model.load(name, version), bnserve_jax.Model.load(name, version)
    given, f = binaries(model.description), np.geomspace(5.0, 3000.0, 100)
    amplitude, phase = model.predict_amplitude_phase(f, given)
    expected = local.predict_amplitude_phase(f, given)
    inside = expected.amplitude > 0.0
    assert worst(amplitude, expected.amplitude) < 1e-9
    assert np.abs(np.where(inside, phase - expected.phase, 0.0)).max() < 1e-9


def test_below_the_band_goes_on_as_the_kernel_does(local, model):
    given, f = binaries(model.description), np.geomspace(1.0, 4.0, 300)
    amplitude, phase = model.predict_amplitude_phase(f, given)
    expected = local.predict_amplitude_phase(f, given, options=EvaluationOptions(modes=((2, 2),)))
    assert worst(amplitude, expected.amplitude) < 1e-12
    assert worst(phase, expected.phase) < 1e-14


def test_what_the_model_does_not_know_is_nan_and_the_others_are_not(model):
    given = binaries(model.description, 5)
    given["mass_ratio"][0], given["lambda_1"][1] = 0.9, -1.0
    given["distance_mpc"][2], given["chi_1"][3] = 0.0, np.nan
    strain = np.asarray(model.predict_mode(FREQUENCIES[:100], given))
    assert np.isnan(strain[:4]).all()
    assert np.isfinite(strain[4]).all()
    far = model.predict_mode(FREQUENCIES[:100], given | {"time_shift": 1e13})
    assert np.isnan(np.asarray(far)).all()


def test_derivatives_are_the_kernels_exact_ones_at_equal_masses_too(local, model):
    names = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "total_mass")
    given, f = binaries(model.description, 4), FREQUENCIES[:150]
    expected = local.predict_derivatives(f, given, options=EvaluationOptions(modes=((2, 2), (3, 3))))
    slopes = jax.jit(lambda p: [model.predict_derivatives(f, p, names, mode) for mode in ((2, 2), (3, 3))])(given)
    for own, (strain, derivatives) in enumerate(slopes):
        assert worst(strain, expected.h[:, own]) < 1e-9
        for k, name in enumerate(names):
            assert worst(derivatives[:, k], expected.derivatives[:, own, k]) < 1e-8, name
    with pytest.raises(InvalidParameters, match="mass_ratio"):
        model.predict_derivatives(f, given, ["mass_rato"])


def test_gradients_go_backwards_too(model):
    given, f = ParametersWithExtrinsic.gw170817(), FREQUENCIES[:50]
    start = {name: float(getattr(given, name)) for name in PARAMETER_NAMES}

    def power(binary):
        plus, _ = model.predict(f, binary, modes=[(2, 2)])
        return jnp.sum(jnp.abs(plus * 1e22) ** 2)

    value, gradient = jax.jit(jax.value_and_grad(power))(start)
    assert float(gradient["distance_mpc"]) == pytest.approx(-2.0 * float(value) / 40.0)
    _, slopes = model.predict_derivatives(f, start, ["lambda_1"])
    even, odd = 0.5 * (1.0 + np.cos(start["inclination"]) ** 2), model.predict_mode(f, start)
    expected = 2.0 * jnp.sum((jnp.conj(odd) * slopes[0]).real) * even**2 * 1e44
    assert float(gradient["lambda_1"]) == pytest.approx(float(expected), rel=1e-7)


def test_derivatives_have_derivatives_in_any_order(model):
    given, f = ParametersWithExtrinsic.gw170817(), FREQUENCIES[::60]
    start = {name: float(getattr(given, name)) for name in PARAMETER_NAMES}
    names = ("mass_ratio", "chi_1")

    def strain(values):
        return model.predict_mode(f, start | dict(zip(names, values, strict=True)))

    def slopes(values):
        return model.predict_derivatives(f, start | dict(zip(names, values, strict=True)), names)[1]

    at = jnp.asarray([start[name] for name in names])
    once, twice = jax.jit(lambda v: (jax.jacfwd(strain)(v), jax.jacfwd(slopes)(v)))(at)
    assert worst(once.T, slopes(at)) < 1e-8
    assert worst(twice[0, :, 1], twice[1, :, 0]) < 1e-8
    backwards = jax.jit(jax.hessian(lambda v: jnp.sum(jnp.abs(strain(v) * 1e22) ** 2)))(at)
    whole = 2.0 * jnp.real(jnp.conj(once.T[:, None]) * once.T[None] + jnp.conj(strain(at)) * twice.transpose(0, 2, 1))
    assert worst(backwards, whole.sum(-1) * 1e44) < 1e-4  # phases cancel, whose slopes are 1e5 radians


def test_batches_of_any_shape_are_what_each_row_is_alone(model):
    given = binaries(model.description, 20)
    table = {name: values.reshape(4, 5) for name, values in given.items()} | {"distance_mpc": 100.0}
    plus, _ = model.predict(FREQUENCIES[:40], table, modes=[(2, 2)])
    assert plus.shape == (4, 5, 40)
    one, _ = model.predict(FREQUENCIES[:40], {name: np.ravel(v)[-1] for name, v in table.items()}, modes=[(2, 2)])
    assert worst(one, plus[3, 4]) < 1e-10


def test_single_precision_is_refused_with_what_to_do(model):
    with jax.enable_x64(False), pytest.raises(InvalidRequest, match=r'"jax_enable_x64", True'):
        model.predict([20.0], ParametersWithExtrinsic.gw170817())
    with jax.enable_x64(False), pytest.raises(InvalidRequest, match="single precision"):
        bnserve_jax.Model.default()


@pytest.mark.parametrize(
    ("change", "error", "said"),
    [
        ({"mass_rato": 1.0}, InvalidParameters, "mass_ratio"),
        ({"chi_1x": 0.1}, InvalidParameters, "precess"),
        ({"modes": [(5, 5)]}, InvalidRequest, "no mode"),
        ({"alignment": "peak"}, InvalidRequest, "alignment"),
        ({"reference_frequency": -1.0}, InvalidRequest, "reference_frequency"),
        ({"frequencies": [[20.0]]}, InvalidFrequencies, "list"),
        ({"frequencies": [0.0, 20.0]}, InvalidFrequencies, "positive"),
    ],
)
def test_what_cannot_be_meant_is_refused_before_anything_is_compiled(model, change, error, said):
    asked = {
        name: change.pop(name)
        for name in ("frequencies", "modes", "alignment", "reference_frequency")
        if name in change
    }
    binary = {name: getattr(ParametersWithExtrinsic.gw170817(), name) for name in PARAMETER_NAMES} | change
    with pytest.raises(error, match=said):
        model.predict(asked.pop("frequencies", [20.0]), binary, **asked)


def test_parameters_with_a_default_may_be_left_out_and_others_not(model):
    given = {name: getattr(ParametersWithExtrinsic.gw170817(), name) for name in PARAMETER_NAMES[:8]}
    assert np.isfinite(np.asarray(model.predict_mode([20.0], given))).all()
    del given["total_mass"]
    with pytest.raises(InvalidParameters, match="total_mass"):
        model.predict_mode([20.0], given)


def test_splines_find_their_cells_in_a_uniform_table():
    from bnserve_jax._splines import Knots

    knots = np.sort(np.random.default_rng(2).uniform(-10.0, -3.0, 50))
    x = np.concatenate([np.random.default_rng(3).uniform(-11.0, -2.0, 2000), knots])
    cell, t = Knots.of(knots).locate(jnp.asarray(x))
    assert np.array_equal(cell, np.clip(np.searchsorted(knots, x, side="right") - 1, 0, 48))
    assert np.array_equal(t, x - knots[np.asarray(cell)])


def test_splines_are_those_of_their_values_and_second_derivatives():
    from bnserve_jax._splines import Knots, cubics, values_and_bends

    random = np.random.default_rng(2)
    cells = np.sort(random.uniform(-10.0, -3.0, 50))
    knots, rows = cells[[0, *range(3, 49, 3), 49]], random.normal(size=(2, 18))
    both = values_and_bends(knots, rows, cells)
    found = np.asarray(Knots.of(cells).cubics(jnp.asarray(both.reshape(4, -1))))
    assert np.abs(found - cubics(knots, rows, cells).reshape(8, -1)).max() < 1e-9 * np.abs(found).max()
