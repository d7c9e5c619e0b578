"""Configurations: closed, typed, and helpful when they are wrong."""

from pathlib import Path

import pytest

from bnserve_inference.roq import RoqConfigurationInvalid, parse_roq_configuration, read_roq_configuration
from tests.inference.roq.tiny import TINY, changed, tiny, toml

CONFIGS = Path(__file__).parents[3] / "configs"


@pytest.mark.parametrize(
    ("entries", "message"),
    [
        ({"nam": "x"}, "unknown key 'nam'; did you mean 'name'"),
        ({"band__fmin": 3.0}, r"unknown key 'fmin' in \[band\]; did you mean 'f_min'"),
        ({"linear__preselection__elemnts": 3}, r"'elemnts' in \[linear.preselection\]; did you mean 'elements'"),
        ({"cycles": [{"sizes": 3}]}, r"'sizes' in \[cycles\]; did you mean 'size'"),
        ({"prior__lamda_1": [1.0, 2.0]}, r"'lamda_1' in \[prior\]; did you mean 'lambda_1'"),
        ({"prior__total_mass": [2.0, 3.0]}, "either chirp_mass or total_mass"),
        ({"prior__chirp_mass": None}, "either chirp_mass or total_mass"),
        ({"prior__chi_1": [0.5, -0.5]}, r"chi_1 must be \[lowest, highest\]"),
        ({"prior__chi_1": [0.0, float("nan")]}, r"chi_1 must be \[lowest, highest\]"),
        ({"prior__mass_ratio": [0.5, 1.0]}, "at least 1"),
        ({"band__f_max": 50.0}, "must be above f_min"),
        ({"band__f_min": 60.1}, "f_min .* must be a multiple of 1 / duration"),
        ({"band__alignment": "peak"}, "alignment"),
        ({"linear__tolerance": 0.0}, "tolerance"),
        ({"linear__preselection__elements": 1}, "elements"),
        ({"linear__most_elements": 5}, "most_elements is below"),
        ({"cycles": []}, "cycles"),
        ({"elements": "fourier"}, "elements"),
        ({"arcsine_fraction": 1.5}, "arcsine_fraction"),
        ({"validation__count": 0}, "count"),
    ],
)
def test_what_is_wrong_is_said(entries, message):
    with pytest.raises(RoqConfigurationInvalid, match=message):
        parse_roq_configuration(changed(**entries))


def test_a_file_is_read(tmp_path):
    path = tmp_path / "tiny.toml"
    path.write_text(toml(TINY))
    assert read_roq_configuration(path) == tiny()


@pytest.mark.parametrize("content", ["name = ", b"\xff\xfe"])
def test_a_file_that_is_not_toml_is_refused(tmp_path, content):
    path = tmp_path / "bad.toml"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(RoqConfigurationInvalid, match="not valid TOML"):
        read_roq_configuration(path)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(RoqConfigurationInvalid, match=r"nowhere\.toml"):
        read_roq_configuration(tmp_path / "nowhere.toml")


@pytest.mark.parametrize("path", sorted(CONFIGS.glob("roq_*.toml")), ids=lambda path: path.name)
def test_the_configurations_of_the_repository_are_valid(path):
    assert read_roq_configuration(path).band.f_min > 0.0


def test_the_gw170817_configuration_is_the_papers():
    configuration = read_roq_configuration(CONFIGS / "roq_gw170817.toml")
    assert (configuration.band.f_min, configuration.band.f_max, configuration.band.duration) == (23.0, 2000.0, 128.0)
    assert configuration.prior.ranges == {
        "chirp_mass": (1.1968, 1.1988),
        "mass_ratio": (1.0, 3.0),
        "chi_1": (-0.5, 0.5),
        "chi_2": (-0.5, 0.5),
        "lambda_1": (5.0, 5000.0),
        "lambda_2": (5.0, 5000.0),
    }
    assert (configuration.linear.tolerance, configuration.quadratic.tolerance) == (1e-4, 1e-6)
    steps = [
        (term.preselection.elements, term.preselection.step) for term in (configuration.linear, configuration.quadratic)
    ]
    assert steps == [(200, 1000), (10, 1000)]
    cycles = [(cycle.size, cycle.outliers, cycle.relative_tolerance) for cycle in configuration.cycles]
    assert cycles == [(10_000, 0, 0.1), (100_000, 0, 1.0), (100_000, 0, 1.0)]
    assert (configuration.validation.count, configuration.validation.limit) == (500_000, 1e-3)


def test_everything_that_decides_the_result_is_in_the_digest():
    digests = {
        tiny().digest("sha256:1"),
        tiny().digest("sha256:2"),
        tiny(seed=2).digest("sha256:1"),
        tiny(elements="waveforms").digest("sha256:1"),
        tiny(prior__chi_1=[-0.05, 0.06]).digest("sha256:1"),
    }
    assert len(digests) == 5
