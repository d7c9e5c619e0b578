"""The examples run as their first lines say, and print what the model says."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from bnserve_store import ModelStore
from bnserve_surrogate import ParametersWithExtrinsic
from tests.architecture.rooms import ROOMS
from tests.integration.conftest import COMMAND

EXAMPLES = Path(__file__).parents[2] / "examples"

WITHOUT_BNSERVE = f"""
import runpy, sys
sys.modules.update(dict.fromkeys({sorted(ROOMS.values())}))  # their import fails
runpy.run_path(sys.argv[1])
"""


def printed(*arguments: str, **options) -> str:
    command = [sys.executable, "-W", "error", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_one_waveform(local):
    output = printed(EXAMPLES / "local_waveform.py")
    plus, cross = local.predict([20.0], ParametersWithExtrinsic.gw170817())
    left = local.time_until_merger(20.0, ParametersWithExtrinsic.gw170817())
    rows = [line.split() for line in output.splitlines()]
    assert ["20.0", f"{abs(plus[0]):.2e}", f"{abs(cross[0]):.2e}", f"{left:.6f}"] in rows


def test_a_batch_from_a_server(bnserve_server):
    output = printed(EXAMPLES / "remote_batch.py", bnserve_server.address)
    assert "1000 waveforms on 277 frequencies in" in output
    inside, flagged = map(int, re.search(r"(\d+) of them inside the trained ranges, (\d+) flagged", output).groups())
    assert inside + flagged == 1000
    assert flagged > 0
    assert re.search(r"median \|h\+\| at 20 Hz: [\d.]+e-2\d / Hz", output)


def test_decoding_without_any_library_of_ours(bnserve_server, local):
    example = [EXAMPLES / "decode_without_bnserve.py", bnserve_server.address]
    code = WITHOUT_BNSERVE.replace("sys.argv[1])", "sys.argv.pop(1))")
    output = printed("-c", code, *example)
    description = local.description
    assert f"model {description.name} {description.version}\n" in output
    assert "h_plus: 3 waveforms of 8113 numbers, complex128\n" in output
    changed = {"mass_ratio": [1.0, 1.2, 1.4], "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0,
               "distance_mpc": 40.0, "inclination": 2.5, "total_mass": 2.76}  # fmt: skip
    assert f"|h+| at 20 Hz: {np.abs(local.predict_batch([20.0], changed).plus[:, 0])} / Hz" in output


def test_a_likelihood_in_the_service(bnserve_server):
    output = printed(EXAMPLES / "likelihood_in_the_service.py", bnserve_server.address)
    of_the_signal = float(re.search(r"ln L of the signal: ([\d.]+)", output).group(1))
    best = float(re.search(r"1000 samples in \d+ ms; best ln L ([\d.]+)", output).group(1))
    assert of_the_signal > 1000.0
    assert abs(best - of_the_signal) < 0.2 * of_the_signal
    assert "rows=1001" in output


@pytest.mark.slow
def test_training_on_a_function_of_ones_own(tmp_path):
    path = os.pathsep.join([str(EXAMPLES), os.environ.get("PYTHONPATH", "")])
    command = [*COMMAND[1:], "train", EXAMPLES / "own_generator.toml", "--store", tmp_path / "my-models", "--jobs", "1"]
    subprocess_options = {"cwd": tmp_path, "env": os.environ | {"PYTHONPATH": path}}
    output = printed(*command, "--no-progress", **subprocess_options)
    assert "own_generator:resonant_tides" in output
    uniform = ModelStore([tmp_path / "my-models"]).manifest("resonant-tides").metadata["accuracy"]["uniform"]
    assert uniform["mismatch"]["max"] < 1e-8
    assert uniform["baseline_mismatch"]["median"] > 1e-5  # there was something to learn


def test_every_example_is_run_here():
    tested = {
        "local_waveform.py",
        "remote_batch.py",
        "decode_without_bnserve.py",
        "own_generator.py",
        "likelihood_in_the_service.py",
    }
    assert {path.name for path in EXAMPLES.glob("*.py")} == tested
