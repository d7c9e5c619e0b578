"""``bnserve train`` and ``bnserve validate``: what they publish, print and write, and what stops them."""

import json
import re
import resource
import sys
import threading
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import OutOfDomain, VersionExists
from bnserve_service.cli import main
from bnserve_store import ModelStore
from bnserve_surrogate import Model, ParametersWithExtrinsic
from bnserve_surrogate.training.config import read_configuration
from bnserve_surrogate.training.pipeline import train
from bnserve_surrogate.training.publication import publish
from tests.surrogate import smooth_waveforms
from tests.surrogate.training_runs import QUICK, digests, train_here, written

ONE = ParametersWithExtrinsic.gw170817()
OWN = ["--generator", f"{smooth_waveforms.PATH}:waveform"]
"""Leave to import the function that the models here were trained on."""


def test_the_model_is_published_loads_and_knows_itself(published):
    model = Model.load("smooth", store=published / "store")
    assert model.description.version == "1.0.0"
    assert model.description.frequency_band == (5.0, 2048.0)
    assert model.description.accuracy["uniform"]["count"] == 12
    assert model.description.accuracy["edges"]["count"] == 6
    assert model.description.provenance["waveforms"] == 200
    assert model.description.provenance["generator"]["name"] == f"{smooth_waveforms.PATH}:waveform"
    assert model.self_check()
    assert np.isfinite(model.predict(np.geomspace(5.0, 2000.0, 50), ONE).plus).all()
    assert ModelStore([published / "store"]).labels("smooth") == {"stable": "1.0.0"}


def test_the_report_is_one_page_with_plots_and_nothing_from_elsewhere(published):
    page = (published / "store" / "smooth" / "1.0.0" / "report.html").read_text()
    manifest = ModelStore([published / "store"]).manifest("smooth")
    assert manifest.digest in page
    assert "12 waveforms: mismatch" in page
    assert len(re.findall(r'<img src="data:image/png;base64,[A-Za-z0-9+/=]{10000,}"', page)) == 3
    assert re.findall(r"(?:src|href)=[\"'](?!data:)", page) == []
    assert not re.search(r"https?:|//[a-z]|url\(|@import|<script", re.sub(r"base64,[^\"]*", "", page))


def test_validating_the_published_model_prints_and_saves_the_mismatch(published, tmp_path, capsys):
    output = tmp_path / "figures.json"
    command = ["validate", "smooth", *OWN, "--store", str(published / "store"), "--work", str(published / "work")]
    assert main([*command, "--count", "8", "--edges", "4", "--jobs", "1", "--output", str(output)]) == 0
    printed = capsys.readouterr().out
    assert "uniform, 8 waveforms: mismatch" in printed
    assert "edges, 4 waveforms: mismatch" in printed
    saved = json.loads(output.read_text())
    assert saved["digest"] == ModelStore([published / "store"]).manifest("smooth").digest
    assert len(saved["uniform"]["mismatches"]) == len(saved["uniform"]["theta"]) == 8
    assert saved["uniform"]["mismatch"]["max"] == pytest.approx(max(saved["uniform"]["mismatches"]), rel=0.01)
    assert saved["edges"]["mismatch"]["max"] < 1e-10
    assert saved["edges"]["baseline_mismatch"]["max"] > 1e-4


def test_a_function_that_a_model_names_is_imported_for_those_alone_who_name_it_too(published, tmp_path, capsys):
    command = ["validate", "smooth", "--store", str(published / "store"), "--work", str(tmp_path / "work")]
    for other in ([], ["--generator", "os:getcwd"]):
        assert main([*command, *other, "--count", "8", "--jobs", "1"]) == 2
        assert f"name it: --generator {smooth_waveforms.PATH}:waveform" in capsys.readouterr().err
    assert not (tmp_path / "work").exists()


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["smoth"], "Did you mean 'smooth'?"),
        (["smooth@7.0"], "no version or label '7.0'"),
        (["smooth", "--noise", "ETD"], "Unknown noise curve 'ETD'"),
        (["smooth", "--total-mass", "900"], "total mass of 900 Msun is outside the model's range, 0.2 to 100"),
        (["smooth", "--f-min", "5000"], "f_min = 5000 Hz is outside the model's band, 3.57143 to 2925.71 Hz"),
        (["smooth", "--f-min", "nan"], "f_min = nan Hz is outside"),
        (["smooth", "--count", "0"], "nothing to validate with"),
    ],
)
def test_a_validation_that_cannot_be_done_says_why_before_any_work(published, tmp_path, capsys, arguments, says):
    command = ["validate", *arguments, *OWN, "--store", str(published / "store"), "--work", str(tmp_path / "work")]
    assert main([*command, "--jobs", "1"]) == 2
    assert says in capsys.readouterr().err
    assert not (tmp_path / "work").exists()


def test_a_place_that_cannot_be_saved_to_is_found_before_any_work(published, tmp_path, capsys):
    command = ["validate", "smooth", *OWN, "--store", str(published / "store"), "--work", str(tmp_path / "work")]
    for output in (tmp_path, tmp_path / "figures.json" / "within"):
        (tmp_path / "figures.json").write_text("")
        assert main([*command, "--count", "8", "--jobs", "1", "--output", str(output)]) == 2
        printed = capsys.readouterr()
        assert "Cannot write" in printed.err
        assert printed.out == ""
    assert not (tmp_path / "work").exists()


def test_figures_that_cannot_be_saved_in_the_end_are_printed_all_the_same(published, tmp_path, capsys):
    command = ["validate", "smooth", *OWN, "--store", str(published / "store"), "--work", str(published / "work")]
    arguments = [*command, "--count", "8", "--jobs", "1", "--output", str(tmp_path / "figures.json")]
    assert main(arguments[:-2]) == 0
    with no_file_larger_than(1_000):
        assert main(arguments) == 2
    printed = capsys.readouterr()
    assert "uniform, 8 waveforms: mismatch" in printed.out
    assert "Cannot write" in printed.err


def test_an_existing_version_is_refused_before_any_work(published, tmp_path, capsys, monkeypatch):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    configuration = written(tmp_path)
    store = ["--store", str(published / "store")]
    assert train_here(tmp_path, configuration, *store) == 2
    assert "already published" in capsys.readouterr().err
    assert not (tmp_path / "marks").exists()
    assert not (tmp_path / "work").exists()


def test_another_version_is_trained_from_the_same_waveforms(published, tmp_path, monkeypatch):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    assert train_here(published, written(tmp_path), "--version", "1.1.0") == 0
    assert not (tmp_path / "marks").exists()
    store = ModelStore([published / "store"])
    assert store.versions("smooth") == ["1.0.0", "1.1.0"]
    assert digests(store.manifest("smooth", "1.1.0")) == digests(store.manifest("smooth", "1.0.0"))


def test_the_uniform_half_of_the_validation_may_be_left_out(tmp_path):
    validation = {"validation": {"count": 0, "edge_count": 4}}
    assert train_here(tmp_path, written(tmp_path, QUICK, validation), report=True) == 0
    assert "edges, 4 waveforms" in (tmp_path / "store" / "smooth" / "1.0.0" / "report.html").read_text()


def test_without_a_report_matplotlib_is_not_needed(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert train_here(tmp_path, written(tmp_path, QUICK)) == 0
    assert not list((tmp_path / "work").glob("*.html"))


FAILING = {"generator": {"options": {"path": f"{smooth_waveforms.PATH}:sometimes_failing"}}}


def test_waveforms_that_fail_are_left_out_and_counted(tmp_path, capsys):
    allowed = {"dataset": {"max_failed_fraction": 0.3}, "validation": {"count": 12, "edge_count": 0}}
    assert train_here(tmp_path, written(tmp_path, FAILING, allowed)) == 0
    model = Model.load("smooth", store=tmp_path / "store")
    origin = model.description.provenance
    assert origin["failed_waveforms"] > 2
    assert origin["waveforms"] + origin["failed_waveforms"] == 200
    assert f"{origin['failed_waveforms']} failed and left out" in capsys.readouterr().out
    assert model.description.accuracy["uniform"]["mismatch"]["max"] < 1e-9


def test_too_many_failures_stop_the_training_with_the_reasons(tmp_path, capsys):
    assert train_here(tmp_path, written(tmp_path, FAILING)) == 2
    error = capsys.readouterr().err
    assert re.search(r"\d+ of 200 waveforms failed; 2 are allowed", error)
    assert "did not converge" in error or "not a finite number" in error
    assert "allow more failures" in error
    assert not (tmp_path / "store").exists()


@contextmanager
def no_file_larger_than(size):
    """A limit on the size of files stands for a disk that is full."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def test_a_full_disk_among_the_waveforms_is_said_and_the_same_command_goes_on(tmp_path, capsys, published):
    configuration = written(tmp_path)
    with no_file_larger_than(8_000):
        assert train_here(tmp_path, configuration) == 2
    error = capsys.readouterr().err
    assert "No room left to write the data set" in error
    assert "free some space and start the same command again" in error
    assert not (tmp_path / "store").exists()
    assert train_here(tmp_path, configuration) == 0
    whole = ModelStore([published / "store"]).manifest("smooth", "1.0.0")
    assert digests(ModelStore([tmp_path / "store"]).manifest("smooth")) == digests(whole)


def test_a_full_disk_at_the_end_publishes_nothing_and_the_same_command_goes_on(published, tmp_path, capsys):
    store = tmp_path / "store"
    arguments = [written(tmp_path), "--store", str(store)]
    with no_file_larger_than(4_000):
        assert train_here(published, *arguments) == 2
    error = capsys.readouterr().err
    assert "Publishing smooth 1.0.0 failed, " in error
    assert "What was published before is untouched" in error
    assert not list(store.rglob("manifest.json"))
    assert not list(store.rglob("*.safetensors"))
    assert train_here(published, *arguments) == 0
    assert Model.load("smooth", store=store).self_check()


def test_nothing_is_published_without_its_report(tmp_path, capsys):
    with no_file_larger_than(100_000):
        assert train_here(tmp_path, written(tmp_path, QUICK), report=True) == 2
    printed = capsys.readouterr()
    assert "uniform, 4 waveforms: mismatch" in printed.out
    assert "Published" not in printed.out
    assert "Publishing smooth 1.0.0 failed" in printed.err
    assert [path.name for path in (tmp_path / "store").rglob("*") if path.is_file()] == []
    assert train_here(tmp_path, written(tmp_path, QUICK), report=True) == 0
    assert (tmp_path / "store" / "smooth" / "1.0.0" / "report.html").exists()


def test_a_report_that_cannot_be_made_stops_the_publishing(tmp_path, monkeypatch):
    """Whatever is wrong with it: here, matplotlib has no figures to give."""
    monkeypatch.setattr("matplotlib.figure.Figure", None)
    with pytest.raises(TypeError):
        train_here(tmp_path, written(tmp_path, QUICK), report=True)
    assert not list(tmp_path.glob("store/*/*"))


def of(function):
    return {"generator": {"options": {"path": f"{smooth_waveforms.PATH}:{function}"}}}


@pytest.mark.parametrize("function", ["baseline_itself", "opposed"])
def test_a_model_no_better_than_its_baseline_gets_no_label_unless_forced(tmp_path, capsys, function):
    configuration = written(tmp_path, QUICK, of(function))
    assert train_here(tmp_path, configuration, report=True) == 2
    printed = capsys.readouterr()
    assert "uniform, 4 waveforms: mismatch of the baseline alone" in printed.out
    assert "Nothing was published: the median mismatch (uniform)" in printed.err
    assert "is not 10 times below that of the post-Newtonian baseline alone" in printed.err
    assert "--force" in printed.err
    assert not (tmp_path / "store").exists()
    assert train_here(tmp_path, configuration, "--force", report=True) == 0
    assert ModelStore([tmp_path / "store"]).labels("smooth") == {"stable": "1.0.0"}
    page = (tmp_path / "store" / "smooth" / "1.0.0" / "report.html").read_text()
    assert len(re.findall(r'<img src="data:image/png;base64,[A-Za-z0-9+/=]{10000,}"', page)) == 3


def test_without_a_label_whatever_was_trained_is_published(tmp_path):
    assert train_here(tmp_path, written(tmp_path, QUICK, of("opposed"), {"labels": []})) == 0
    store = ModelStore([tmp_path / "store"])
    assert store.versions("smooth") == ["1.0.0"]
    assert store.labels("smooth") == {}


def test_a_phase_that_was_not_learnt_stands_before_the_label(tmp_path, capsys):
    """Everything else is: the mismatch does not see the constant, which is random here."""
    assert train_here(tmp_path, written(tmp_path, of("turned_at_random"), {"validation": {"count": 64}})) == 2
    error = capsys.readouterr().err
    assert 'the phase with alignment="merger" (uniform) is off by' in error
    assert "mismatch" not in error


BOXES = {
    "without spins": {"ranges": {"chi": [0.0, 0.0]}},
    "of one mass ratio": {"ranges": {"mass_ratio": [1.5, 1.5]}},
    "of raw parameters without spins": {"ranges": {"chi": [0.0, 0.0]}, "regressor": {"coordinates": "raw"}},
    "pruned, without spins": {"ranges": {"chi": [0.0, 0.0]}, "regressor": {"polynomial": {"terms": 10}}},
    "of one binary": {
        "ranges": {"chi": [0.1, 0.1], "mass_ratio": [1.5, 1.5], "tidal_deformability": [400.0, 400.0]},
        "validation": {"count": 120},
    },
    "of one total mass": {"ranges": {"total_mass": [2.8, 2.8]}},
    "in a narrow band": {"ranges": {"frequency_band": [100.0, 110.0], "total_mass": [2.8, 2.8]}},
    "in half an octave": {"ranges": {"frequency_band": [100.0, 150.0]}},
    "with black holes": {"ranges": {"tidal_deformability": [0.0, 5000.0]}},
}


@pytest.mark.parametrize("box", BOXES.values(), ids=list(BOXES))
def test_boxes_without_width_and_narrow_bands_can_be_trained(tmp_path, box):
    assert train_here(tmp_path, written(tmp_path, QUICK, box), report=True) == 0
    model = Model.load("smooth", store=tmp_path / "store")
    assert model.self_check()
    middle = {name: 0.5 * (r.minimum + r.maximum) for r in model.description.parameters[:5] for name in [r.name]}
    mass = model.description.reference_mass
    one = ParametersWithExtrinsic(**middle, total_mass=mass, distance_mpc=40.0, inclination=0.3)
    f = np.geomspace(*model.description.frequency_band, 20)
    assert np.isfinite(model.predict(f, one).plus).all()
    if box["ranges"].get("chi") == [0.0, 0.0]:
        with pytest.raises(OutOfDomain, match="chi_1"):
            model.predict(f, replace(one, chi_1=0.1))


def test_of_two_trainings_that_publish_one_version_at_once_one_wins(tmp_path):
    """And the store holds the winner's tensors, not a mixture."""
    outcomes, barrier = {}, threading.Barrier(2)
    configurations, results = {}, {}
    for name, degree in {"one": 1, "two": 2}.items():
        path = written(
            tmp_path,
            QUICK,
            {"regressor": {"polynomial": {"degree": degree}}},
        )
        configurations[name] = read_configuration(path)
        results[name] = train(
            configurations[name],
            tmp_path / "work",
            n_jobs=1,
            backend="sequential",
            progress=False,
            say=lambda line: None,
        )

    def compete(name):
        barrier.wait()
        try:
            outcomes[name] = publish(configurations[name], results[name], tmp_path / "store", force=True).digest
        except VersionExists as error:
            outcomes[name] = error

    threads = [threading.Thread(target=compete, args=(name,)) for name in results]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    winners = [name for name, outcome in outcomes.items() if isinstance(outcome, str)]
    losers = [outcome for outcome in outcomes.values() if isinstance(outcome, VersionExists)]
    assert len(winners) == len(losers) == 1
    artifact = ModelStore([tmp_path / "store"]).load("smooth")
    assert artifact.manifest.digest == outcomes[winners[0]]
    for name, tensor in results[winners[0]].tensors.items():
        np.testing.assert_array_equal(artifact.tensors[name], tensor)
