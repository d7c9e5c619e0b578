"""What the kernel writes where: forms of output, rows that are refused, memory, threads."""

import gc

import numpy as np
import pytest

from bnserve_protocol import (
    MEGAPARSEC_SECONDS,
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    InvalidParameters,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    RowStatus,
)
from bnserve_surrogate import Model
from bnserve_surrogate.baseline import taylorf2_amplitude
from bnserve_surrogate.kernel._layout import DENSE, STREAMED
from tests.surrogate.conftest import random_batch
from tests.surrogate.networks import ACTIVATIONS, network_model
from tests.surrogate.one_mode import OneMode

FLAG = EvaluationOptions(out_of_domain="flag")


@pytest.fixture(scope="module")
def shipped():
    return OneMode(Model.default())


def typical(rows, seed=0):
    """Binaries inside the range of the shipped models."""
    values = random_batch(rows, seed=seed)
    values[:, 7] = np.random.default_rng(seed).uniform(2.0, 4.0, rows)
    return ParameterBatch(values)


@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
@pytest.mark.parametrize("points", [1, 7, 9, 1000, DENSE - 1, DENSE, 5003])
def test_polarizations_in_one_pass_have_the_bits_of_factors_multiplied_out(shipped, points, dtype):
    f = np.linspace(3.0, 2700.0, points) if points > 1 else np.array([100.0])
    batch = typical(11)
    at_once = shipped.predict_batch(f, batch, dtype=dtype)
    multiplied = shipped.predict_factored(f, batch, dtype=dtype).polarizations()
    assert at_once.plus.tobytes() == multiplied.plus.tobytes()
    assert at_once.cross.tobytes() == multiplied.cross.tobytes()


@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
@pytest.mark.parametrize("points", [40_000, 40_001, 40_003])
def test_a_result_written_past_the_caches_has_the_bits_of_its_rows_alone(shipped, points, dtype):
    f = np.linspace(5.0, 2500.0, points)
    batch = typical(9)
    together = shipped.predict_batch(f, batch, dtype=dtype)
    assert together.plus.nbytes + together.cross.nbytes > STREAMED
    for i in range(9):
        alone = shipped.predict_factored(f, batch.row(i), dtype=dtype).polarizations()
        assert alone.plus[0].nbytes < STREAMED
        assert together.plus[i].tobytes() == alone.plus[0].tobytes()
        assert together.cross[i].tobytes() == alone.cross[0].tobytes()


@pytest.mark.parametrize("points", [1, 300, 4097, 300_001])
def test_one_waveform_has_the_bits_of_a_batch_of_one(shipped, points):
    f = np.geomspace(5.0, 2048.0, points)
    batch = typical(1)
    first = shipped.predict(f, batch.row(0))
    again = shipped.predict(f, batch.row(0))  # the grid is prepared now: the short way
    expected = shipped.predict_batch(f, batch)
    for answer in (first, again):
        np.testing.assert_array_equal(answer.plus, expected.plus[0])
        np.testing.assert_array_equal(answer.cross, expected.cross[0])
        np.testing.assert_array_equal(answer.status, expected.status)
        np.testing.assert_array_equal(answer.estimated_mismatch, expected.estimated_mismatch)


def test_an_array_that_was_changed_in_place_is_a_different_grid(shipped):
    f = np.geomspace(5.0, 2048.0, 300)
    parameters = typical(1).row(0)
    shipped.predict(f, parameters)
    f[7] *= 1.0 + 1e-12
    np.testing.assert_array_equal(shipped.predict(f, parameters).plus, shipped.predict(f.copy(), parameters).plus)
    f[7] = f[8]
    with pytest.raises(ValueError, match="repeated"):
        shipped.predict(f, parameters)


def test_threads_share_a_batch_without_changing_a_bit(shipped):
    f = np.linspace(5.0, 2048.0, 3000)
    batch = typical(75)
    shared = OneMode(Model.default(threads=3)).predict_batch(f, batch)
    np.testing.assert_array_equal(shared.plus, shipped.predict_batch(f, batch).plus)


BAD = {
    "mass_ratio": (0.9, RowStatus.OUT_OF_DOMAIN, OutOfDomain),
    "lambda_1": (1e6, RowStatus.OUT_OF_DOMAIN, OutOfDomain),
    "chi_2": (-0.7, RowStatus.OUT_OF_DOMAIN, OutOfDomain),
    "distance_mpc": (0.0, RowStatus.OUT_OF_DOMAIN, InvalidParameters),
    "inclination": (np.nan, RowStatus.NOT_FINITE, InvalidParameters),
    "total_mass": (np.inf, RowStatus.NOT_FINITE, InvalidParameters),
    "reference_phase": (-2e14, RowStatus.OUT_OF_DOMAIN, InvalidParameters),
    "time_shift": (1e12, RowStatus.OUT_OF_DOMAIN, InvalidParameters),
}


@pytest.mark.parametrize("name", BAD)
@pytest.mark.parametrize("rows", [1, 12])
def test_what_is_flagged_is_what_is_refused(shipped, name, rows):
    value, status, error = BAD[name]
    f = np.linspace(20.0, 2000.0, 50)
    batch = typical(rows)
    good = shipped.predict_batch(f, batch)
    batch[name][rows - 1] = value
    flagged = shipped.predict_batch(f, batch, options=FLAG)
    assert flagged.status.tolist() == [0] * (rows - 1) + [status]
    assert np.isnan(flagged.plus[-1]).all()
    assert np.isnan(flagged.cross[-1]).all()
    assert np.isnan(flagged.estimated_mismatch[-1])
    np.testing.assert_array_equal(flagged.plus[:-1], good.plus[:-1])
    with pytest.raises(error, match=name):
        shipped.predict_batch(f, batch)
    if rows == 1:
        with pytest.raises(error, match=name):
            shipped.predict(f, batch.row(0))


@pytest.mark.parametrize(
    ("frequencies", "options"),
    [
        ([3.0, 100.0], {"below_band": "error"}),
        ([100.0, 4000.0], {"above_band": "error"}),
        ([9000.0, 9001.0], {"above_band": "error"}),
        ([1e-6, 100.0], {}),
    ],
)
def test_frequencies_outside_the_band_are_flagged_or_refused(shipped, frequencies, options):
    flagged = shipped.predict_batch(frequencies, typical(3), options=EvaluationOptions(out_of_domain="flag", **options))
    assert (flagged.status == RowStatus.OUT_OF_BAND).all()
    with pytest.raises(OutOfBand, match="band"):
        shipped.predict_batch(frequencies, typical(3), options=EvaluationOptions(**options))


def test_memory_of_a_large_result_is_used_again_when_nobody_refers_to_it(shipped):
    f = np.linspace(5.0, 2048.0, 5000)
    first = shipped.predict_factored(f, typical(4)).h
    address, values, view = first.ctypes.data, first.copy(), first[1:, ::7]
    del first
    assert shipped.predict_factored(f, typical(4, seed=1)).h.ctypes.data != address, "a view still needs it"
    np.testing.assert_array_equal(view, values[1:, ::7])
    del view
    gc.collect()
    later = [shipped.predict_factored(f, typical(4)).h for _ in range(60)]  # other tests have left memory, too
    assert address in {h.ctypes.data for h in later}


@pytest.mark.parametrize("activation", ACTIVATIONS)
def test_every_activation_of_a_network_is_its_definition(metadata, tensors, activation):
    model, own, layers = network_model(metadata, tensors, activation)
    batch = typical(10)
    theta = np.column_stack([batch[name] for name in ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")])
    x = (theta - own["22/coordinate_offset"]) * own["22/coordinate_scale"]
    for weights, biases in layers[:-1]:
        x = ACTIVATIONS[activation](x @ weights + biases)
    outputs = x @ layers[-1][0] + layers[-1][1]
    residual = (own["22/mean"] + outputs @ own["22/basis"])[:, : len(own["22/amplitude_nodes"])]
    for i in range(len(batch)):
        mass = batch["total_mass"][i] * SOLAR_MASS_SECONDS
        f = own["22/amplitude_nodes"][3:9] / mass
        amplitude, _ = model.predict_amplitude_phase(f, batch.row(i))
        nu = batch["mass_ratio"][i] / (1 + batch["mass_ratio"][i]) ** 2
        scale = nu * mass**2 / (batch["distance_mpc"][i] * MEGAPARSEC_SECONDS)
        baseline = taylorf2_amplitude(f * mass, *theta[i : i + 1, :3].T)[0] * scale
        np.testing.assert_allclose(np.log(amplitude / baseline), residual[i, 3:9], atol=1e-11)
