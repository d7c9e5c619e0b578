"""From a configuration to a served model with real waveforms, 200 of TEOBResumSPA from 20 Hz: one mode, and four."""

import json

import numpy as np
import pytest

from bnserve_protocol import MEGAPARSEC_SECONDS
from bnserve_service.cli import main
from bnserve_store import ModelStore
from bnserve_surrogate import EvaluationOptions, Model, ParametersWithExtrinsic
from bnserve_surrogate.training.data.generators import TEOBResumSPA, mass_seconds
from tests.surrogate.training_runs import arguments, in_a_process, merged, written

pytestmark = pytest.mark.slow
pytest.importorskip("EOBRun_module")

TEOBRESUMS = {
    "name": "small",
    "version": "0.1.0",
    "ranges": {"mass_ratio": [1.0, 1.5], "chi": [-0.1, 0.1], "tidal_deformability": [200.0, 1500.0],
               "frequency_band": [20.0, 2048.0]},
    "nodes": {"count": 60},
    "dataset": {"count": 200},
    "reduction": {"components": 10},
    "regressor": {"polynomial": {"degree": 3.5}},
    "validation": {"count": 24, "edge_count": 0},
}  # fmt: skip


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    """Of a finished ``bnserve train`` in a process of its own, over all cores."""
    directory = tmp_path_factory.mktemp("teobresums")
    process = in_a_process(arguments(directory, written(directory, base=merged(TEOBRESUMS)), "--no-report"))
    output, error = process.communicate(timeout=600)
    assert process.returncode == 0, error
    assert "Published small 0.1.0" in output
    return directory


@pytest.fixture(scope="module")
def model(directory):
    return Model.load("small", store=directory / "store")


def test_the_model_is_far_better_than_the_baseline(model):
    measured = model.description.accuracy["uniform"]
    assert measured["count"] == 24
    assert measured["mismatch"]["median"] < 1e-6
    assert measured["mismatch"]["max"] < 1e-4
    assert measured["baseline_mismatch"]["median"] > 1e-3
    assert measured["merger_time_error_seconds"]["max"] < 1e-3
    assert model.self_check()


def test_it_agrees_with_the_shipped_model_which_never_saw_its_waveforms(model):
    """Up to a line: the phase of TEOBResumS starts from zero at the first frequency, which is another one."""
    one = ParametersWithExtrinsic.gw170817()
    f = np.geomspace(20.0, 1000.0, 200)
    options = EvaluationOptions(alignment="merger", modes=[(2, 2)])
    ours, shipped = (m.predict_amplitude_phase(f, one, options=options) for m in (model, Model.default()))
    np.testing.assert_allclose(ours.amplitude, shipped.amplitude, rtol=3e-3)
    difference = ours.phase - shipped.phase
    slope, constant = np.polyfit(f, difference, 1)
    np.testing.assert_allclose(difference, slope * f + constant, atol=0.02)
    assert abs(slope) / (2.0 * np.pi) < 1e-3  # seconds between the two mergers


def test_fresh_waveforms_give_the_accuracy_it_claims(directory, model, capsys):
    output = directory / "figures.json"
    command = ["validate", "small@0.1.0", "--store", str(directory / "store"), "--work", str(directory / "work")]
    assert main([*command, "--count", "16", "--jobs", "1", "--output", str(output)]) == 0
    assert "uniform, 16 waveforms: mismatch" in capsys.readouterr().out
    saved = json.loads(output.read_text())
    assert saved["digest"] == ModelStore([directory / "store"]).manifest("small").digest
    claimed = model.description.accuracy["uniform"]["mismatch"]["median"]
    assert saved["uniform"]["mismatch"]["median"] < 5.0 * claimed


MODES = {
    "name": "modes",
    "nodes": {"modes": 32},
    "regressor": {"coordinates": "symmetric"},
    "modes": {name: {"components": 4, "degree": 3.0} for name in ("33", "21", "44")},
}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """Of the same box, with four modes."""
    directory = tmp_path_factory.mktemp("modes")
    process = in_a_process(arguments(directory, written(directory, base=merged(TEOBRESUMS, MODES)), "--no-report"))
    output, error = process.communicate(timeout=600)
    assert process.returncode == 0, error
    assert "Published modes 0.1.0" in output
    return Model.load("modes", store=directory / "store")


def test_a_model_learns_the_modes_that_its_configuration_names(whole):
    assert whole.description.modes == [(2, 2), (2, 1), (3, 3), (4, 4)]
    measured = whole.description.accuracy["uniform"]
    assert measured["mismatch"]["median"] < 1e-6
    assert set(measured["modes"]) == {"33", "21", "44"}
    assert all(errors["max"] < 1e-7 for errors in measured["modes"].values())
    assert measured["merger_phase_error_radians"]["max"] < 0.1
    assert whole.self_check()


def test_its_modes_are_those_of_the_generator_at_one_time_and_phase(whole):
    """None of them in the training set; nothing is fitted: the merger is at t = 0, and the phase its own."""
    theta, mass = np.array([1.3, 0.05, -0.05, 400.0, 900.0]), mass_seconds(2.8)
    first = 20.0 * 2.0 / 2.8 * mass
    generator = TEOBResumSPA(first_mf=0.5 * first, zero_mf=first)
    f = np.geomspace(30.0, 800.0, 60)
    one = ParametersWithExtrinsic(1.3, 400.0, 900.0, 0.05, -0.05, 1.0, 0.0, total_mass=2.8)
    ours = whole.predict_modes(f, one, options=EvaluationOptions(alignment="merger"))
    theirs = generator.modes(theta, dict.fromkeys(ours.modes, f * mass))
    unit = 1.3 / 2.3**2 * mass**2 / MEGAPARSEC_SECONDS
    for mode, strain in zip(ours.modes, ours.h[0], strict=True):
        amplitude, psi = theirs[mode]
        expected = unit * amplitude * np.exp(-1j * psi)
        np.testing.assert_allclose(strain, expected, atol=0.02 * np.abs(expected).max(), err_msg=str(mode))
