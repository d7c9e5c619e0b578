"""From a configuration to a served model with real waveforms: 200 of TEOBResumSPA from 20 Hz."""

import json

import numpy as np
import pytest

from bnserve_service.cli import main
from bnserve_store import ModelStore
from bnserve_surrogate import EvaluationOptions, Model, ParametersWithExtrinsic
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
    options = EvaluationOptions(alignment="merger")
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
