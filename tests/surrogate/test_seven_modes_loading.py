"""The artifact of a model with higher modes: what it says of itself, and what is refused."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest

from bnserve_protocol import (
    ArtifactCorrupted,
    ArtifactIncomplete,
    EvaluationOptions,
    OutOfDomain,
    ParametersWithExtrinsic,
)
from bnserve_surrogate import SelfCheck, SurrogateMetadata
from bnserve_surrogate._artifact import MODES
from bnserve_surrogate._tensors import read_modes
from tests.surrogate.plain_reference import PlainModel
from tests.surrogate.seven_modes import POWERS, seven_mode_metadata, seven_mode_model, seven_mode_tensors

ALONE = EvaluationOptions(modes=[(2, 2)])


@pytest.fixture(scope="module")
def metadata():
    return seven_mode_metadata()


@pytest.fixture(scope="module")
def tensors():
    return seven_mode_tensors()


def test_metadata_is_what_was_written(metadata):
    assert SurrogateMetadata.read(metadata.write()) == metadata


def test_the_description_names_the_modes_in_one_order(metadata):
    assert metadata.describe("seven", "1", "sha256:7").modes == list(MODES.values())


def test_the_lighter_star_may_have_a_range_of_its_own():
    wide = seven_mode_metadata(lambda_2=(0.0, 12_000.0))
    ranges = {entry.name: (entry.minimum, entry.maximum) for entry in wide.parameters()}
    assert (ranges["lambda_1"], ranges["lambda_2"]) == ((0.0, 5000.0), (0.0, 12_000.0))
    model = seven_mode_model(wide)
    typical = ParametersWithExtrinsic.gw170817()
    light = replace(typical, lambda_2=11_000.0)
    assert np.isfinite(model.predict([20.0, 100.0], light).plus).all()
    with pytest.raises(OutOfDomain, match="lambda_1"):
        model.predict([20.0, 100.0], replace(typical, lambda_1=11_000.0))


@pytest.mark.parametrize("name", ["nodes", "mean", "basis", "polynomial_exponents", "polynomial_coefficients"])
def test_a_missing_tensor_of_a_mode_is_named(metadata, tensors, name):
    without = {key: tensor for key, tensor in tensors.items() if key != f"33/{name}"}
    with pytest.raises(ArtifactIncomplete, match=f"Mode 33 of the model lacks the tensors: {name}"):
        read_modes(metadata, without)


MISFITS = {
    "nodes out of order": ("33/nodes", lambda t: t[::-1].copy()),
    "nodes from zero": ("33/nodes", lambda t: t - t[0]),
    "a node less": ("33/nodes", lambda t: t[1:]),
    "a mean of real parts": ("33/mean", lambda t: t[: len(t) // 2]),
    "a basis with a row more": ("33/basis", lambda t: np.vstack([t, t[:1]])),
    "a basis of whole numbers": ("33/basis", lambda t: t.astype(np.int64)),
    "exponents of four coordinates": ("33/polynomial_exponents", lambda t: t[:, :4]),
    "coefficients of other terms": ("33/polynomial_coefficients", lambda t: t[1:]),
    "other nodes for amplitude than for phase": ("22/amplitude_nodes", lambda t: np.geomspace(t[0], t[-1], len(t))),
}


@pytest.mark.parametrize(("name", "spoil"), MISFITS.values(), ids=list(MISFITS))
def test_tensors_of_a_mode_that_do_not_fit_together_are_refused(metadata, tensors, name, spoil):
    with pytest.raises(ArtifactCorrupted, match=r"does not fit the others; publish the model again"):
        read_modes(metadata, {**tensors, name: spoil(tensors[name])})


def test_a_power_is_one_that_post_newtonian_modes_have(metadata):
    for power in (-1, 0, 9):
        written = metadata.write()
        written["modes"]["33"]["ratio_power"] = power
        with pytest.raises(ArtifactCorrupted, match="ratio_power"):
            SurrogateMetadata.read(written)
    assert {name: mode.ratio_power for name, mode in metadata.ratios.items()} == POWERS


@pytest.mark.parametrize("name", ["22/mean", "33/basis", "21/polynomial_coefficients", "44/mean"])
def test_the_self_check_finds_a_changed_weight_of_any_mode(metadata, tensors, name):
    f, binary = np.geomspace(10.0, 1000.0, 5), ParametersWithExtrinsic.gw170817()
    model = seven_mode_model(metadata, tensors)
    amplitude, phase = model.predict_amplitude_phase(f, binary, options=ALONE)
    each = {key: EvaluationOptions(modes=[MODES[key]]) for key in POWERS}
    others = {key: abs(model.predict_factored(f, binary, options=each[key]).h[0]).tolist() for key in POWERS}
    check = SelfCheck(
        parameters={field: getattr(binary, field) for field in binary.__slots__},
        frequencies=f.tolist(),
        amplitude=amplitude.tolist(),
        phase=phase.tolist(),
        amplitudes=others,
    )
    recorded = msgspec.structs.replace(metadata, self_check=check)
    assert seven_mode_model(recorded, tensors).self_check()
    changed = tensors[name].copy()
    changed.flat[0] += 1e-3
    assert not seven_mode_model(recorded, {**tensors, name: changed}).self_check()


def test_below_the_least_trained_tide_the_regressor_sees_that_and_the_baseline_the_true_one(metadata, tensors):
    model, plain = seven_mode_model(metadata, tensors), PlainModel(tensors, metadata.carrier)
    f = np.geomspace(20.0, 1000.0, 50)
    weak = {"mass_ratio": 1.4, "chi_1": 0.1, "chi_2": -0.2, "lambda_1": 0.3, "lambda_2": 1.2}
    columns = {name: np.array([value]) for name, value in weak.items()}
    rest = {"total_mass": 2.8, "distance_mpc": 40.0, "reference_phase": 0.0, "time_shift": 0.0}
    columns |= {name: np.array([value]) for name, value in rest.items()}
    least = np.array([[1.4, 0.1, -0.2, 1.5, 1.5]])
    outputs = plain.regressor(least)
    plain.regressor = lambda theta: outputs
    weak |= {"distance_mpc": 40.0, "inclination": 0.0, "total_mass": 2.8}
    ours = model.predict_amplitude_phase(f, ParametersWithExtrinsic(**weak), options=ALONE)
    expected = plain.strain(columns, f)
    np.testing.assert_allclose(ours.amplitude, np.abs(expected), rtol=1e-12)
    np.testing.assert_allclose(np.exp(1j * ours.phase), expected / np.abs(expected), atol=1e-9)


def test_the_splines_are_used_from_their_first_node_on_which_may_be_below_the_band(metadata, tensors):
    model, plain = seven_mode_model(metadata, tensors), PlainModel(tensors, metadata.carrier)
    names = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2", "total_mass", "distance_mpc")
    columns = {name: np.array([value]) for name, value in zip(names, (1.5, 0.1, 0.2, 400, 600, 2.0, 40), strict=True)}
    columns |= {name: np.zeros(1) for name in ("reference_phase", "time_shift", "inclination")}
    f = np.linspace(5.0, 20.0, 40)
    assert metadata.frequency_band[0] == 10.0
    h = model.predict_factored(f, columns, options=ALONE).h[0]
    expected = plain.strain(columns, f)
    np.testing.assert_allclose(h, expected, atol=1e-9 * np.abs(expected).max())
