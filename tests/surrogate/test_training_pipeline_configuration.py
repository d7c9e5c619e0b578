"""A configuration that is wrong is refused before any waveform is computed, in a sentence that says what to change."""

import sys

import pytest

from bnserve_protocol import BnserveError
from bnserve_surrogate.training.config import (
    ConfigurationInvalid,
    parse_configuration,
    read_configuration,
)
from bnserve_surrogate.training.data.generators import _teobresums
from bnserve_surrogate.training.pipeline import check_plausible
from bnserve_surrogate.training.publication import check_publishable
from tests.surrogate import smooth_waveforms
from tests.surrogate.training_runs import (
    QUICK,
    ROOT,
    SMOOTH,
    arguments,
    in_a_process,
    merged,
    train_here,
    written,
)


def refused(*changes):
    with pytest.raises(BnserveError) as raised:
        check_plausible(parse_configuration(merged(SMOOTH, *changes)))
    return raised.value.detail


@pytest.mark.parametrize("name", ["default", "fast", "paper", "wide"])
def test_the_configurations_that_come_with_bnserve_are_valid(name):
    configuration = read_configuration(ROOT / "configs" / f"{name}.toml")
    check_plausible(configuration)
    assert configuration.name == name


def test_a_file_means_what_it_says(tmp_path):
    configuration = read_configuration(written(tmp_path, {"ranges": {"chi": [-0.4, 0.3]}}))
    assert configuration.ranges.chi == (-0.4, 0.3)
    assert configuration.ranges.mass_ratio == (1.0, 3.0)
    assert configuration.regressor.polynomial.degree == 4


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"verion": "1"}, "unknown key 'verion'; did you mean 'version'?"),
        ({"dataset": {"coutn": 3}}, "unknown key 'coutn' in [dataset]; did you mean 'count'?"),
        (
            {"regressor": {"polynomial": {"degre": 3}}},
            "unknown key 'degre' in [regressor.polynomial]; did you mean 'degree'?",
        ),
        ({"validation": {"xyz": 3}}, "unknown key 'xyz' in [validation]; known keys: count, edge_count, seed"),
        ({"regresor": {"kind": "network"}}, "did you mean 'regressor'?"),
    ],
)
def test_a_misspelt_key_suggests_the_nearest(change, says):
    assert says in refused(change)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"dataset": {"count": "many"}}, "Expected `int`, got `str` - at `$.dataset.count`"),
        ({"dataset": {"count": 10.5}}, "Expected `int`, got `float`"),
        ({"name": 3}, "Expected `str`, got `int` - at `$.name`"),
        ({"labels": "stable"}, "at `$.labels`"),
        ({"ranges": {"chi": [0.5]}}, "length 2"),
        ({"ranges": {"chi": ["a", "b"]}}, "Expected `float`"),
        ({"dataset": 5}, "at `$.dataset`"),
        ({"regressor": {"kind": "forest"}}, "'forest' - at `$.regressor.kind`"),
        ({"nodes": {"kind": "uniform"}}, "'uniform' - at `$.nodes.kind`"),
    ],
)
def test_values_of_a_wrong_type_are_named(change, says):
    assert says in refused(change)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"ranges": {"chi": [0.5, -0.5]}}, "range of chi"),
        ({"ranges": {"mass_ratio": [0.5, 2.0]}}, "range of mass_ratio"),
        ({"ranges": {"frequency_band": [100.0, 5.0]}}, "'frequency_band' in [ranges] must be two increasing"),
        ({"ranges": {"frequency_band": [-5.0, 100.0]}}, "frequency_band"),
        ({"ranges": {"frequency_band": [1e-6, 100.0]}}, "Hz"),
        ({"ranges": {"frequency_band": [100.0, 100.5]}}, "'frequency_band' in [ranges] must be two increasing numbers"),
        ({"ranges": {"total_mass": [2.0, float("inf")]}}, "'ranges.total_mass' is inf"),
        ({"ranges": {"chi": [float("nan"), 0.5]}}, "'ranges.chi' is nan"),
        ({"ranges": {"total_mass": [4.0, 2.0]}}, "'total_mass' in [ranges] must be two increasing"),
        ({"ranges": {"reference_mass": 8.0}}, "must lie in total_mass"),
        ({"ranges": {"reference_mass": 0.0}}, "reference_mass"),
        ({"dataset": {"count": 0}}, "dataset.count"),
        ({"dataset": {"arcsine_fraction": 2.0}}, "arcsine_fraction"),
        ({"dataset": {"max_failed_fraction": -0.1}}, "max_failed_fraction"),
        ({"nodes": {"count": 3}}, "nodes.count"),
        ({"nodes": {"count": 10**9}}, "nodes.count"),
        ({"nodes": {"count": 3000}}, "3000 nodes of the amplitude are too many"),
        ({"nodes": {"tolerance": 0.0}}, "nodes.tolerance"),
        ({"nodes": {"waveforms": 0}}, "nodes.waveforms"),
        ({"reduction": {"components": 0}}, "reduction.components"),
        ({"reduction": {"components": 119}, "dataset": {"count": 100}}, "lower 'components' in [reduction] or raise"),
        ({"reduction": {"components": 121}}, "numbers at the nodes"),
        ({"reduction": {"components": 199}, "nodes": {"count": 160}}, "in 200 waveforms, of which 2 may fail"),
        ({"reduction": {"eigenvalue_exponent": 300.0}}, "reduction.eigenvalue_exponent"),
        ({"reduction": {"eigenvalue_exponent": float("nan")}}, "reduction.eigenvalue_exponent"),
        ({"reduction": {"noise": "ETD"}}, "Unknown noise curve 'ETD'"),
        ({"regressor": {"polynomial": {"degree": 9}}}, "1097 terms of the polynomial cannot be determined by 200"),
        ({"dataset": {"edge_count": -1}}, "dataset.edge_count"),
        (
            {"dataset": {"count": 7}, "regressor": {"kind": "network"}},
            "a network cannot be trained on 7 waveforms; raise 'count' in [dataset] to at least 8",
        ),
        (
            {"dataset": {"count": 10}, "regressor": {"kind": "network"}, "reduction": {"components": 4}},
            "'validation_fraction' in [regressor.network], 0.075, sets aside 1 of 10 waveforms;",
        ),
        (
            {"regressor": {"kind": "network", "network": {"validation_fraction": 0.999}}},
            "sets aside 198 of 200 waveforms, of which 2 may fail;",
        ),
        ({"regressor": {"polynomial": {"degree": 50}}}, "terms of the polynomial cannot be determined by 200"),
        ({"regressor": {"polynomial": {"terms": 0}}}, "terms"),
        ({"regressor": {"polynomial": {"weights": [1.0, 1.0, 0.0, 1.0, 1.0]}}}, "positive weights"),
        ({"regressor": {"network": {"hidden_layer_sizes": [0]}}}, "hidden_layer_sizes"),
        ({"regressor": {"network": {"hidden_layer_sizes": []}}}, "hidden_layer_sizes"),
        ({"regressor": {"network": {"hidden_layer_sizes": [5000]}}}, "<= 1024"),
        ({"regressor": {"network": {"validation_fraction": 1.0}}}, "validation_fraction"),
        ({"regressor": {"network": {"alpha": -1.0}}}, "alpha"),
        ({"regressor": {"network": {"alpha": float("inf")}}}, "alpha"),
        ({"regressor": {"network": {"seed": 2**32}}}, "regressor.network.seed"),
        ({"validation": {"count": 0, "edge_count": 0}}, "'count' and 'edge_count' in [validation] are both 0"),
    ],
    ids=str,
)
def test_values_that_make_no_sense_are_named(change, says):
    assert says in refused(change)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"name": "../evil"}, "cannot be the name of a model"),
        ({"version": "latest"}, "is not a version"),
        ({"labels": ["1.0.0"]}, "cannot be a label"),
    ],
)
def test_names_that_cannot_be_published_are_found_at_once(tmp_path, change, says):
    with pytest.raises(BnserveError, match=says):
        check_publishable(parse_configuration(merged(SMOOTH, change)), tmp_path / "store")


def test_a_greedy_choice_of_too_few_nodes_is_found_before_the_training_set(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    loose = {
        "nodes": {"kind": "greedy", "waveforms": 2, "tolerance": 10.0},
        "ranges": {"frequency_band": [200.0, 900.0]},
    }
    assert train_here(tmp_path, written(tmp_path, QUICK, loose)) == 2
    assert "a spline needs 4; lower 'tolerance' in [nodes]" in capsys.readouterr().err
    assert (tmp_path / "marks").stat().st_size == 2


def test_a_store_that_is_a_file_is_found_at_once(tmp_path):
    (tmp_path / "store").write_text("")
    with pytest.raises(BnserveError, match="is a file"):
        check_publishable(parse_configuration(SMOOTH), tmp_path / "store")


TOML = {
    "misspelt": ({"dataset": {"coutn": 3}}, "did you mean 'count'?"),
    "unknown generator": ({"generator": {"name": "teobresum"}}, "Did you mean 'teobresums'?"),
    "unknown option": ({"generator": {"name": "teobresums", "options": {"dr": 1}}}, "It takes: postadiabatic_dr"),
    "no such function": (
        {"generator": {"options": {"path": "tests.no_such:f"}}},
        "'tests.no_such:f' cannot be imported",
    ),
    "no path": ({"generator": {"options": {}}}, "It takes: path"),
    "wrong type of an option": (
        {"generator": {"name": "teobresums", "options": {"postadiabatic_dr": "small"}}},
        "The generator 'teobresums' cannot be made with",
    ),
    "black holes": (
        {"generator": {"name": "teobresums", "options": {}}, "ranges": {"tidal_deformability": [0.5, 5000.0]}},
        "no waveforms for a Lambda of 1 or less",
    ),
    "a start within the band": (
        {"generator": {"name": "teobresums", "options": {"first_mf": 0.001}}},
        "The generator begins at first_mf = 0.001, above the band",
    ),
    "more than the disk holds": ({"dataset": {"count": 10**13}}, "No room left to write the data set"),
    "no sense": ({"reduction": {"components": 1000}}, "lower 'components'"),
    "bad version": ({"version": "one"}, "is not a version"),
}


@pytest.mark.parametrize(("change", "says"), TOML.values(), ids=TOML)
def test_the_command_says_what_to_change_and_does_no_work(tmp_path, capsys, monkeypatch, change, says):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    assert train_here(tmp_path, written(tmp_path, change)) == 2
    error = capsys.readouterr().err
    assert error.startswith("bnserve: ")
    assert error.count("\n") == 1
    assert says in error
    assert not (tmp_path / "marks").exists()
    assert not (tmp_path / "store").exists()


@pytest.mark.parametrize(
    ("more", "says"),
    [
        (["--jobs", "0"], "0 processes at once"),
        (["--backend", "nonsense"], "Invalid backend: nonsense"),
        (["--store", "s3://bucket/models"], "s3://bucket/models"),
        (["--store", "/proc/store"], "Publishing smooth 1.0.0 failed"),
        (["--work", "/proc/work"], "The data set cannot be written in /proc/work"),
    ],
    ids=str,
)
def test_workers_and_places_that_cannot_be_used_are_found_before_any_waveform(
    tmp_path, capsys, monkeypatch, more, says
):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    assert train_here(tmp_path, written(tmp_path, QUICK), *more) == 2
    assert says in capsys.readouterr().err
    assert not (tmp_path / "marks").exists()
    assert not (tmp_path / "store").exists()


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (None, "Cannot read the configuration"),
        (b"name = ", "not valid TOML"),
        (b"\xff\xfe", "not valid TOML"),
        (b"", "name"),
    ],
)
def test_a_file_that_cannot_be_read_is_refused(tmp_path, capsys, content, says):
    path = tmp_path / "config.toml"
    if content is not None:
        path.write_bytes(content)
    assert train_here(tmp_path, path) == 2
    assert says in capsys.readouterr().err


def test_a_directory_is_no_configuration(tmp_path):
    with pytest.raises(ConfigurationInvalid, match="Cannot read"):
        read_configuration(tmp_path)


@pytest.mark.parametrize(("command", "package"), [("train", "sklearn"), ("validate", "scipy")])
def test_a_missing_package_names_itself_and_the_way_to_get_it(tmp_path, command, package):
    more = arguments(tmp_path, written(tmp_path)) if command == "train" else ["validate", "default"]
    process = in_a_process(more, script=f"import sys; sys.modules['{package}'] = None")
    output, error = process.communicate(timeout=120)
    assert process.returncode == 2
    assert output == ""
    assert f"Training needs the package '{package}'" in error
    assert "pip install '.[train]'" in error
    assert "Traceback" not in error


@pytest.mark.parametrize(
    ("module", "change"), [("EOBRun_module", {"generator": {"name": "teobresums", "options": {}}}), ("matplotlib", {})]
)
def test_a_missing_package_of_one_part_is_found_before_any_waveform(tmp_path, capsys, monkeypatch, module, change):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    monkeypatch.setitem(sys.modules, module, None)
    _teobresums._code.cache_clear()  # other tests of this process may have asked for it
    assert train_here(tmp_path, written(tmp_path, QUICK, change), report=True) == 2
    error = capsys.readouterr().err
    assert module in error
    assert "pip install" in error
    assert not (tmp_path / "marks").exists()
