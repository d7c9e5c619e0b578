"""What a generator must keep to is found on two waveforms; a constant modulo 2 pi is replaced, not learnt."""

import os

import numpy as np
import pytest

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.generation import Generation, configured_generator
from bnserve_surrogate.training.data.generators import CallableGenerator
from bnserve_surrogate.training.data.sampling import mf_band, training_band
from bnserve_surrogate.training.errors import GeneratorDependsOnGrid, GeneratorUnknown, TooManyFailures
from bnserve_surrogate.training.pipeline import train
from bnserve_surrogate.training.reduction.nodes import configured_nodes
from tests.surrogate import smooth_waveforms
from tests.surrogate.training_runs import SMOOTH, merged

QUIETLY = {"n_jobs": 1, "backend": "sequential", "progress": False, "say": lambda line: None}
NARROW = {"ranges": {"mass_ratio": [1.0, 1.1], "chi": [0.0, 0.05]}, "regressor": {"polynomial": {"degree": 3}}}


def configured(function, *changes, **generator):
    section = {"options": {"path": f"{smooth_waveforms.PATH}:{function}"}, **generator}
    return parse_configuration(merged(SMOOTH, NARROW, {"generator": section}, *changes))


@pytest.mark.parametrize("function", ["timed_by_the_grid", "louder_where_dense", "modulo_two_pi"])
def test_a_generator_that_looks_at_the_grid_is_refused_before_the_many_waveforms(tmp_path, monkeypatch, function):
    monkeypatch.setenv(smooth_waveforms.MARK, str(tmp_path / "marks"))
    with pytest.raises(GeneratorDependsOnGrid, match="at the same frequencies"):
        train(configured(function), tmp_path, **QUIETLY)
    assert (tmp_path / "marks").stat().st_size == 4


def test_a_generator_without_waveforms_is_left_to_the_count_of_failures(tmp_path):
    with pytest.raises(TooManyFailures, match="there is none"):
        train(configured("failing"), tmp_path, **QUIETLY)


def test_a_constant_modulo_two_pi_is_replaced_by_that_of_the_baseline(tmp_path):
    trained = train(configured("modulo_two_pi", phase_constant="baseline"), tmp_path, **QUIETLY)
    for validation in trained.validations.values():
        assert np.abs(validation.merger_phase).max() < 1e-3
        assert np.abs(validation.merger_time).max() < 1e-6
        assert validation.mismatch.max() < 1e-9


def test_the_baselines_constant_does_not_hide_another_time(tmp_path):
    with pytest.raises(GeneratorDependsOnGrid):
        train(configured("timed_by_the_grid", phase_constant="baseline"), tmp_path, **QUIETLY)


def test_a_users_generator_may_say_where_its_phase_is_zero_and_what_boxes_it_has(tmp_path):
    """Its signal's phase is zero at 30 Hz; by this the constant varies by thousands of radians, and it is learnt."""
    trained = train(configured("zero_at_30_hz"), tmp_path, **QUIETLY)
    start = trained.metadata.modes["22"].merger_start_mf
    assert start == pytest.approx(30.0 * 2.8 * SOLAR_MASS_SECONDS)
    for validation in trained.validations.values():
        assert np.abs(validation.merger_phase).max() < 1e-2
    with pytest.raises(GeneratorUnknown, match="no spins"):
        configured_generator(configured("zero_at_30_hz", {"ranges": {"chi": [0.0, 0.5]}}))


def test_teobresums_starts_where_the_band_begins_unless_told_otherwise():
    pytest.importorskip("EOBRun_module")
    band = {"ranges": {"frequency_band": [15.0, 2048.0], "total_mass": [2.0, 4.0]}}
    teobresums = merged(SMOOTH, {"generator": {"name": "teobresums", "options": {}}}, band)
    configuration = parse_configuration(teobresums)
    assert training_band(configuration) == pytest.approx((15.0 * 2.0 / 2.8, 2048.0 * 4.0 / 2.8))
    assert mf_band(configuration)[0] == pytest.approx(30.0 * SOLAR_MASS_SECONDS)
    assert configured_generator(configuration).first_mf == mf_band(configuration)[0]
    own = merged(teobresums, {"generator": {"options": {"first_mf": 1e-4}}})
    assert configured_generator(parse_configuration(own)).first_mf == 1e-4


def test_greedy_nodes_are_chosen_on_waveforms_of_the_backend_that_the_training_has(tmp_path):
    here = []

    def waveform(theta, mf):
        here.append(os.getpid())
        return smooth_waveforms.waveform(theta, mf)

    configuration = configured("waveform", {"nodes": {"kind": "greedy", "waveforms": 2, "tolerance": 1e-3}})
    configured_nodes(Generation(configuration, CallableGenerator(waveform), tmp_path, 2, "sequential", False))
    assert here == [os.getpid()] * 2
