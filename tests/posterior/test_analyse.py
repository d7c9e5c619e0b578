"""``bnserve analyse``: from a configuration to a result that bilby reads and a page, also after it was killed."""

import contextlib
import importlib.metadata
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import tomllib

import bilby
import numpy as np
import pytest
from packaging.requirements import Requirement

from bnserve_posterior.events import OutputSection
from bnserve_posterior.running import Folder
from bnserve_service.cli import main
from tests.architecture.rooms import ROOT, run_python
from tests.posterior.networks import TOML

pytestmark = pytest.mark.filterwarnings("ignore:.*Global meta data:UserWarning")


@pytest.fixture
def event(tmp_path):
    path = tmp_path / "event.toml"
    path.write_text(TOML.replace('"run"', json.dumps(str(tmp_path / "run"))))
    return path


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """The folder of a run, and what it printed."""
    folder = tmp_path_factory.mktemp("analyse")
    path = folder / "event.toml"
    path.write_text(TOML)
    printed = subprocess.run(
        [sys.executable, "-m", "bnserve_service", "analyse", str(path), "--output", str(folder / "run"), "--json"],
        check=True, capture_output=True, text=True, timeout=300,
    )  # fmt: skip
    return folder / "run", json.loads(printed.stdout), path, printed.stderr


def read(folder):
    return bilby.gw.result.CBCResult.from_json(str(next(folder.glob("*_result.json"))))


def test_the_signal_is_found_where_it_was_put(finished):
    result = read(finished[0])
    for name, value in result.injection_parameters.items():
        if (
            name in result.posterior
            and np.ptp(result.posterior[name]) > 0.0
            and name not in ("reference_phase", "phase", "psi")
        ):
            low, high = np.quantile(result.posterior[name], [0.001, 0.999])
            assert low <= value <= high, name
    snr = result.posterior["network_optimal_snr"]
    assert snr.mean() == pytest.approx(15.0, abs=3.0)


def test_bilby_reads_the_result(finished):
    folder, printed, _, _ = finished
    result = read(folder)
    assert result.sampler == "bnserve"
    assert result.search_parameter_keys == ["chirp_mass", "mass_ratio", "theta_jn", "psi", "geocent_time"]
    assert result.log_bayes_factor == printed["log_evidence"]
    assert result.log_evidence - result.log_noise_evidence == pytest.approx(result.log_bayes_factor)
    assert len(result.posterior) == printed["effective_samples"] >= 500
    assert result.interferometers == ["H1", "L1"]
    assert isinstance(result.priors["luminosity_distance"], bilby.core.prior.PowerLaw)
    assert {"luminosity_distance", "reference_phase", "phase", "mass_1", "H1_matched_filter_snr"} <= {*result.posterior}
    assert result.meta_data["bnserve"]["digests"]["model"].startswith("sha256:")
    assert np.isfinite(result.posterior["log_prior"]).all()


def test_the_evidence_is_that_of_a_sum_over_the_prior(finished):
    """bilby's own sampler of the same likelihood would take an hour; the mean over draws of the prior is as exact."""
    printed = finished[1]
    assert printed["log_evidence_error"] < 0.1
    for value, error in zip(printed["log_evidences"], printed["log_evidence_errors"], strict=True):
        assert abs(printed["log_evidence"] - value) < 4.0 * error


def test_the_likelihood_was_held_against_the_full_grid(finished):
    check = finished[1]["check"]
    assert check["samples"] == 50
    assert check["largest"] < 0.05
    assert check["efficiency"] > 0.99


def test_the_page_is_one_file_with_everything(finished):
    (page,) = finished[0].glob("*.html")
    text = page.read_text()
    assert text.count("data:image/png;base64,") == 3
    for words in ("ln of the evidence ratio", "k-hat", "What was done", "sha256:", "luminosity_distance"):
        assert words in text
    assert not re.search(r'(src|href)="http', text)


def test_progress_is_said(finished):
    assert re.search(r"power", finished[3])


def test_a_folder_with_a_run_is_not_written_to_unasked(finished, capsys):
    folder, _, path, _ = finished
    before = {file.name: file.read_bytes() for file in folder.iterdir()}
    assert main(["analyse", str(path), "--output", str(folder)]) == 2
    assert "holds a finished run: go on with it with --resume" in capsys.readouterr().err
    assert main(["analyse", str(path), "--output", str(folder), "--resume", "--seed", "5"]) == 2
    assert "holds a run of another configuration" in capsys.readouterr().err
    assert {file.name: file.read_bytes() for file in folder.iterdir()} == before
    assert main(["analyse", str(path), "--output", str(folder), "--resume", "--force"]) == 2
    assert "leave out one of the two" in capsys.readouterr().err


def test_check_reads_the_data_and_tries_the_likelihood_alone(event, capsys):
    assert main(["analyse", str(event), "--check", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["possible"] == found["draws"] == 1000
    assert any("signal-to-noise ratio 15.0" in fact for fact in found["facts"])


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("f_min = 64.0", "f_mim = 64.0", r"did you mean 'f_min'\?"),
        ("chi_1 = 0.0\nchi_2 = 0.0\nlambda_1 = 300.0\nlambda_2 = 500.0\nra", "chi_1 = 0.0\nra", "chi_2"),
        ("mass_ratio = [0.6, 1.0]", 'mass_ratio = "Gausian(mu=1, sigma=2)"', r"did you mean Gaussian\?"),
        ("aLIGO_O4_high_asd.txt", "none.txt", "There is no file none.txt"),
        ("[sampler]", '[model]\nname = "none"\n[sampler]', "none"),
    ],
)
def test_what_is_wrong_is_one_sentence(event, capsys, old, new, sentence):
    event.write_text(event.read_text().replace(old, new))
    assert main(["analyse", str(event)]) == 2
    printed = capsys.readouterr().err
    assert re.search(sentence, printed)
    assert printed.count("\n") == 1


def command(path, folder, *options):
    return [
        sys.executable, "-m", "bnserve_service", "analyse", str(path), "--output", str(folder), "--no-report", *options
    ]  # fmt: skip


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_a_run_that_was_ended_goes_on_to_the_same_posterior(finished, tmp_path, capsys, number):
    folder, _, path, _ = finished
    with subprocess.Popen(
        command(path, tmp_path / "run"), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    ) as process:
        while not (tmp_path / "run" / "checkpoint.npz").exists():
            assert process.poll() is None, process.stderr.read()
            time.sleep(0.01)
        process.send_signal(number)
        said = process.communicate(timeout=60)[1]
    if number == signal.SIGTERM:
        assert process.returncode == 128 + signal.SIGTERM
        assert "--resume` goes on" in said
    assert main(command(path, tmp_path / "run")[3:]) == 2
    assert "holds a run that has not finished" in capsys.readouterr().err
    assert main(command(path, tmp_path / "run", "--resume")[3:]) == 0
    assert read(tmp_path / "run").posterior.equals(read(folder).posterior)


def test_a_folder_that_cannot_be_written_is_said_before_the_work(event, capsys, tmp_path):
    (tmp_path / "file").write_text("")
    assert main(["analyse", str(event), "--output", str(tmp_path / "file" / "run")]) == 2
    assert "Cannot write to" in capsys.readouterr().err


def test_a_disk_that_is_full_is_said_and_what_was_finished_is_kept(finished, tmp_path):
    folder, _, path, _ = finished

    def little_room():
        resource.setrlimit(resource.RLIMIT_FSIZE, (150_000, 150_000))  # bytes: less than what draws take

    full = subprocess.run(
        command(path, tmp_path / "run"), capture_output=True, text=True, preexec_fn=little_room, check=False
    )
    assert full.returncode == 2
    assert full.stderr.splitlines()[-1].startswith("bnserve: Cannot write to")
    assert "go on with --resume" in full.stderr
    assert main(command(path, tmp_path / "run", "--resume")[3:]) == 0
    assert read(tmp_path / "run").posterior.equals(read(folder).posterior)


def test_two_processes_do_not_work_in_one_folder(event, capsys, tmp_path):
    with Folder(OutputSection(folder=str(tmp_path / "run"))):
        assert main(["analyse", str(event), "--check", "--resume"]) == 2
    assert "Another process is at work" in capsys.readouterr().err


def test_hdf5_is_read_as_json_is(finished, event, tmp_path):
    event.write_text(event.read_text().replace("checks = 50", 'checks = 0\nformat = "hdf5"'))
    assert main(["analyse", str(event), "--output", str(tmp_path / "run"), "--no-report", "--no-progress"]) == 0
    (written,) = (tmp_path / "run").glob("*_result.hdf5")
    there, here = bilby.gw.result.CBCResult.from_hdf5(str(written)), read(finished[0])
    assert there.search_parameter_keys == here.search_parameter_keys
    assert there.log_bayes_factor == here.log_bayes_factor
    assert (there.posterior["chirp_mass"].to_numpy() == here.posterior["chirp_mass"].to_numpy()).all()


def test_a_run_needs_nothing_that_the_extra_does_not_bring(finished, tmp_path):
    """bilby imports some of what it needs late, astropy among it, and does not bring it."""
    folder, _, path, _ = finished
    shutil.copytree(folder, tmp_path / "run")
    brought = declared("protocol", "model_store", "surrogate", "inference", "posterior", "service")
    installed = importlib.metadata.packages_distributions()
    hidden = [name for name, of in installed.items() if not {canonical(one) for one in of} & brought]
    assert {"lal", "pytest"} <= {*hidden}
    assert not {"astropy", "bilby", "numpy"} & {*hidden}
    arguments = "analyse", str(path), "--output", str(tmp_path / "run"), "--resume", "--no-progress"
    code = HIDDEN.format(hidden=hidden, arguments=arguments)
    assert "Written: " in run_python(code, env=os.environ)


HIDDEN = """
import sys

class Without:
    def __init__(self, finder):
        self.finder = finder

    def __getattr__(self, name):
        return getattr(self.finder, name)

    def find_spec(self, name, *arguments):
        return None if name.partition(".")[0] in {hidden} else self.finder.find_spec(name, *arguments)

sys.meta_path[:] = map(Without, sys.meta_path)
from bnserve_service.cli import main
sys.exit(main({arguments}))
"""
"""A command in an interpreter where these modules are not to be found."""


def canonical(name):
    return re.sub("[-_.]+", "-", name).lower()


def declared(*rooms):
    """Distributions that installing rooms brings, without extras, as far as they are installed here."""
    waiting = []
    for room in rooms:
        waiting += tomllib.loads((ROOT / room / "pyproject.toml").read_text())["project"]["dependencies"]
    found = set()
    while waiting:
        one = Requirement(waiting.pop())
        if canonical(one.name) in found or (one.marker and not one.marker.evaluate({"extra": ""})):
            continue
        found.add(canonical(one.name))
        with contextlib.suppress(importlib.metadata.PackageNotFoundError):
            waiting += importlib.metadata.requires(one.name) or []
    return found


def test_an_extra_that_is_missing_is_one_sentence(event, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "bilby", None)
    assert main(["analyse", str(event)]) == 2
    assert "needs the package 'bilby'" in capsys.readouterr().err
