"""The configuration of an event: a closed schema, read with what it names beside it."""

import copy

import pytest

from bnserve_posterior.events import EventInvalid, parse_event, read_event

EVENT = {
    "data": {"trigger_time": 1187008882.43, "duration": 128.0, "f_min": 23.0, "f_max": 2000.0},
    "detectors": {"H1": {"strain": "h.hdf5"}, "L1": {"strain": "l.hdf5", "asd": "l.txt"}},
    "prior": {"chirp_mass": [1.19, 1.2], "chi_1": 0.0, "mass_ratio": "Uniform(minimum=0.5, maximum=1)"},
    "output": {"folder": "runs/x"},
}

SITE = {"latitude": 0.7, "longitude": 0.2, "x_azimuth": 0.0, "y_azimuth": 1.5}


def with_values(**changes):
    table = copy.deepcopy(EVENT)
    for path, value in changes.items():
        *sections, key = path.split("__")
        place = table
        for section in sections:
            place = place.setdefault(section, {})
        place[key] = value
    return table


def test_what_is_left_out_has_a_default():
    event = parse_event(EVENT)
    assert event.model.name == "default"
    assert event.likelihood.kind == "auto"
    assert event.sampler.effective == 10_000
    assert event.prior["chirp_mass"] == (1.19, 1.2)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"data__f_mix": 20.0}, r"unknown key 'f_mix' in \[data\]; did you mean 'f_min'\?"),
        ({"detectors__H1__strian": "x"}, r"unknown key 'strian' in \[detectors\]; did you mean 'strain'\?"),
        ({"data__injection__parameters": {}, "data__injection__sed": 1}, "did you mean 'seed'"),
        ({"samplers": {}}, "unknown key 'samplers'; did you mean 'sampler'"),
        ({"likelihood__kind": "fast"}, "Invalid enum value 'fast'"),
        ({"data__f_max": 10.0}, "must be above f_min"),
        ({"data__f_min": 23.001}, "must be a multiple of 1 / duration"),
        ({"data__duration": float("nan")}, "duration"),
        ({"data__trigger_time": float("inf")}, "must be a finite number"),
        ({"data__start_time": 1187008900.0}, "must lie inside the segment"),
        ({"detectors__H1": {}}, r"\[detectors.H1\] needs 'strain'"),
        ({"detectors__L1__psd": "p.txt"}, "both asd and psd"),
        ({"detectors__H1__psd_start": 1.0}, "belong together"),
        ({"detectors__H1__notches": [[60.0, 59.0]]}, "pairs of increasing frequencies"),
        ({"data__injection": {"parameters": {}}}, "leave out one of the two"),
        ({"detectors": {}}, "length >= 1"),
        ({"data__duration": 2.0**20}, "more points than"),
        ({"output__label": "../x"}, "beginning of a file's name"),
        ({"output__folder": ""}, "length >= 1"),
        ({"sampler__effective": 0}, ">= 1"),
        ({"detectors__H1__calibration": "h.txt"}, r"does not say what it is multiplied with: give correction"),
        ({"calibration": {"correction": "data"}}, "no detector has 'calibration'"),
        ({"calibration": {"correction": "strain"}}, "Invalid enum value 'strain'"),
        ({"calibration": {"correction": "data", "node": 3}}, "did you mean 'nodes'"),
        ({"calibration": {"correction": "data", "nodes": 3}}, ">= 4"),
        (
            {"calibration": {"correction": "data", "f_min": 3000.0}, "detectors__H1__calibration": "h.txt"},
            "the first must be below the second",
        ),
        ({"detectors__H1__site": {"latitude": 0.1}}, "missing required field"),
        ({"detectors__H1__site": {**SITE, "latitud": 0.1}}, "did you mean 'latitude'"),
        ({"detectors__H1__site": SITE, "detectors__H1__finite_arms": True}, "leave out finite_arms"),
        ({"likelihood__time_marginalization": True}, "did you mean 'time_marginalisation'"),
    ],
)
def test_what_makes_no_sense_is_refused_in_a_sentence(changes, sentence):
    with pytest.raises(EventInvalid, match=sentence):
        parse_event(with_values(**changes))


def test_a_simulated_detector_needs_a_noise_curve():
    table = with_values(data__injection={"parameters": {}}, detectors={"H1": {}})
    with pytest.raises(EventInvalid, match="needs a noise curve"):
        parse_event(table)


def test_files_are_looked_for_beside_the_configuration(tmp_path):
    for name in ("h.hdf5", "p.prior", "calibration.txt"):
        (tmp_path / name).write_text("")
    path = tmp_path / "event.toml"
    path.write_text("""
data = {trigger_time = 1187008882.43, duration = 128.0, f_min = 23.0, f_max = 2000.0}
detectors = {H1 = {strain = "h.hdf5", asd = "aLIGO_O4_high_asd.txt", calibration = "calibration.txt"}}
calibration = {correction = "data"}
prior = {file = "p.prior"}
output = {folder = "runs/x"}
""")
    event = read_event(path)
    assert event.detectors["H1"].strain == str(tmp_path / "h.hdf5")
    assert event.detectors["H1"].asd == "aLIGO_O4_high_asd.txt"  # one of bilby's
    assert event.detectors["H1"].calibration == str(tmp_path / "calibration.txt")
    assert event.prior["file"] == str(tmp_path / "p.prior")


def test_a_configuration_that_is_none_is_refused(tmp_path):
    with pytest.raises(EventInvalid, match="Cannot read the configuration"):
        read_event(tmp_path / "none.toml")
    (tmp_path / "a.toml").write_text("data = [")
    with pytest.raises(EventInvalid, match="is not valid TOML"):
        read_event(tmp_path / "a.toml")
