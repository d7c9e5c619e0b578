"""``bnserve analyse`` with calibration envelopes, killed in the middle: the same posterior, with its errors."""

import signal
import subprocess
import sys
import time

import bilby
import pytest

from benchmarks.gw170817.setting import DATA
from tests.posterior.networks import TOML

CALIBRATED = (
    TOML.replace('L1.asd = "aLIGO_O4_high_asd.txt"', 'L1.asd = "aLIGO_O4_high_asd.txt"\n@')
    .replace("@", "\n".join(f"{name}.calibration = '{DATA / f'{name}_CalEnv.txt'}'" for name in ("H1", "L1")))
    .replace("[likelihood]", "[calibration]\ncorrection = 'data'\nnodes = 5\ndraws = 8\n\n[likelihood]")
    .replace("effective = 500\nparticles = 500", "effective = 300\nparticles = 250")
    .replace("checks = 50", "checks = 20")
)
pytestmark = pytest.mark.filterwarnings("ignore:.*Global meta data:UserWarning")


def command(path, folder, *options):
    return [
        sys.executable, "-m", "bnserve_service", "analyse", str(path), "--output", str(folder), "--no-report", *options
    ]  # fmt: skip


def result(folder):
    return bilby.gw.result.CBCResult.from_json(str(next(folder.glob("*_result.json"))))


def killed(path, folder, changes, *options):
    """Run until the checkpoint has been written anew so many times, and kill."""
    checkpoint, seen = folder / "checkpoint.npz", set()
    if checkpoint.exists():
        seen.add(checkpoint.stat().st_mtime_ns)
    wanted = len(seen) + changes
    asked = command(path, folder, *options)
    with subprocess.Popen(asked, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        while len(seen) < wanted:
            assert process.poll() is None, process.stderr.read()
            if checkpoint.exists():
                seen.add(checkpoint.stat().st_mtime_ns)
            time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=60)
    assert process.returncode == -signal.SIGKILL
    assert not list(folder.glob("*_result.json"))


def test_a_run_with_calibration_errors_that_was_killed_again_and_again_ends_with_the_same_posterior(tmp_path):
    path = tmp_path / "event.toml"
    path.write_text(CALIBRATED)
    subprocess.run(command(path, tmp_path / "whole"), check=True, capture_output=True)
    killed(path, tmp_path / "run", 1)
    killed(path, tmp_path / "run", 2, "--resume")
    subprocess.run(command(path, tmp_path / "run", "--resume"), check=True, capture_output=True)
    ours, whole = result(tmp_path / "run"), result(tmp_path / "whole")
    errors = [name for name in whole.posterior if name.startswith("recalib_")]
    assert len(errors) == 2 * 2 * 5
    assert all(whole.posterior[name].std() > 0.0 for name in errors)
    assert ours.posterior.equals(whole.posterior)
    assert ours.log_evidence == whole.log_evidence
    assert ours.log_evidence_err == whole.log_evidence_err
