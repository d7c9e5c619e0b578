"""The names of mlgw_bns with bnserve behind them: what programs that import it get, from a service and without one."""

import dataclasses
import pickle

import numpy as np
import pytest

from bnserve_client import _chosen
from bnserve_client.compat import mlgw_bns
from bnserve_client.compat.mlgw_bns import Model, ParametersWithExtrinsic
from bnserve_protocol import EvaluationOptions, InvalidRequest, ModelUnknown, OutOfBand, OutOfDomain, PackageMissing
from tests.architecture.rooms import run_python

GRID = np.arange(20.0, 1024.0, 0.25)
BINARY = ParametersWithExtrinsic(1.3, 500.0, 800.0, 0.1, -0.2, 40.0, 0.7, 2.7)
LOWEST = 5.0 * 2.0 / 2.7
"""Hz: the model was trained from 5 Hz on at the lowest of its masses, 2."""


@pytest.fixture
def model(bnserve_server, monkeypatch) -> Model:
    """The model of a running service."""
    monkeypatch.setenv(_chosen.URL_VARIABLE, bnserve_server.address)
    return Model.default()


def changed(**values) -> ParametersWithExtrinsic:
    return dataclasses.replace(BINARY, **values)


# What register() does

PROGRAM = """
import bnserve_client.compat
bnserve_client.compat.register()
bnserve_client.compat.register()
import mlgw_bns.model
from mlgw_bns import Model, ParametersWithExtrinsic
from mlgw_bns.model import FrequencyTooHighError, FrequencyTooLowError
print(Model.__module__, mlgw_bns.model.Model is Model, mlgw_bns.__version__.split("+")[0])
"""


def test_programs_that_import_mlgw_bns_get_it_after_one_call():
    assert run_python(PROGRAM).split() == ["bnserve_client.compat.mlgw_bns", "True", "0.12.1"]


def test_an_mlgw_bns_that_is_there_is_not_hidden_unasked(tmp_path):
    (tmp_path / "mlgw_bns").mkdir()
    (tmp_path / "mlgw_bns" / "__init__.py").write_text("from mlgw_bns.model import Model\n")
    (tmp_path / "mlgw_bns" / "model.py").write_text("class Model: pass\n")
    code = f"""
import sys; sys.path.insert(0, {str(tmp_path)!r})
import bnserve_client.compat as compat
try:
    compat.register()
except ValueError as error:
    print(error)
from mlgw_bns.model import Model
print(Model.__module__)
compat.register(replace=True)
from mlgw_bns.model import Model
print(Model.__module__)
"""
    refusal, before, after = run_python(code).splitlines()
    assert f"There is an mlgw_bns here ({tmp_path}" in refusal
    assert "register(replace=True)" in refusal
    assert (before, after) == ("mlgw_bns.model", "bnserve_client.compat.mlgw_bns")


def test_a_file_that_takes_the_names_is_enough_for_programs_that_start_others(tmp_path):
    (tmp_path / "mlgw_bns.py").write_text("from bnserve_client.compat.mlgw_bns import *\n")
    code = f"""
import sys; sys.path.insert(0, {str(tmp_path)!r})
from mlgw_bns import FrequencyTooHighError, FrequencyTooLowError, Model, ParametersWithExtrinsic
print(Model.__module__)
"""
    assert run_python(code).strip() == "bnserve_client.compat.mlgw_bns"


# Which model it is


def test_the_model_is_the_one_of_the_service_and_without_one_that_of_this_process_with_its_bits(model, monkeypatch):
    remote = model.predict(GRID, BINARY)
    monkeypatch.delenv(_chosen.URL_VARIABLE)
    local = Model.default().predict(GRID, BINARY)
    assert type(remote) is tuple
    assert all(np.array_equal(one, other) for one, other in zip(remote, local, strict=True))


def test_its_name_is_given_or_in_the_environment(model, monkeypatch):
    fast = Model.default("fast").predict(GRID, BINARY)[0]
    assert not np.array_equal(fast, model.predict(GRID, BINARY)[0])
    monkeypatch.setenv(_chosen.MODEL_VARIABLE, "fast")
    assert np.array_equal(fast, Model.default().predict(GRID, BINARY)[0])
    with pytest.raises(ModelUnknown):
        Model.default("fst")


def test_where_no_models_are_installed_the_error_says_what_to_install(monkeypatch):
    monkeypatch.delenv(_chosen.URL_VARIABLE, raising=False)
    monkeypatch.setattr(_chosen, "GROUP", "bnserve.nothing")
    _chosen.local_part.cache_clear()
    _chosen._kept.cache_clear()
    with pytest.raises(PackageMissing, match=r"BNSERVE_URL.*pip install \./"):
        Model.default()


def test_it_can_be_pickled(model):
    again = pickle.loads(pickle.dumps(model))
    assert np.array_equal(again.predict(GRID, BINARY)[1], model.predict(GRID, BINARY)[1])


def test_what_belongs_to_training_is_an_error_that_says_so():
    with pytest.raises(InvalidRequest, match="bnserve train"):
        Model("my_trained_model")
    with pytest.raises(InvalidRequest, match="'pca_components_number' is no setting"):
        Model.default(pca_components_number=30)


# What a waveform is


def test_the_waveform_is_the_models_but_for_a_constant_phase(model, local):
    """Of each mode; all of them are in test_adapters_with_modes."""
    theirs = local.predict(GRID, mlgw_bns._binary(BINARY), options=EvaluationOptions(modes=[(2, 2)]))
    model.modes = [(2, 2)]
    turns = [one / other for one, other in zip(model.predict(GRID, BINARY), theirs, strict=True)]
    assert np.allclose(turns, turns[0][0], rtol=1e-8)
    assert abs(turns[0][0]) == pytest.approx(1.0, rel=1e-12)


def test_reference_phase_is_the_phase_at_the_lowest_frequency_of_training(model):
    grid = np.array([LOWEST, 20.0, 30.0])
    amplitude, phase = model.predict_amplitude_phase(grid, changed(reference_phase=0.7))
    plus, cross = model.predict(grid, changed(reference_phase=0.7, inclination=0.0))
    assert phase[0] == pytest.approx(0.7, abs=1e-6)
    assert np.allclose(plus, amplitude * np.exp(1j * phase), rtol=1e-8)
    assert np.allclose(cross, -1j * plus, rtol=1e-12)


def test_on_a_grid_that_begins_lower_it_is_the_phase_of_the_first_point(model):
    grid = np.array([1.0, 20.0])
    assert model.predict_amplitude_phase(grid, changed(reference_phase=0.7))[1][0] == pytest.approx(0.7, abs=1e-6)


def test_time_shift_is_2_pi_f_of_it_in_the_phase_and_seconds_more_until_the_merger(model):
    later = changed(time_shift=0.01)
    phases = [model.predict_amplitude_phase(GRID, binary)[1] for binary in (BINARY, later)]
    assert np.allclose(phases[1] - phases[0], 2.0 * np.pi * GRID * 0.01, atol=1e-6)
    times = [model.time_until_merger(25.0, binary) for binary in (BINARY, later)]
    assert times[1] - times[0] == pytest.approx(0.01, abs=1e-6)


def test_time_until_merger_is_that_of_the_model_to_the_baselines_time(model, local):
    assert model.time_until_merger(25.0, BINARY) == pytest.approx(
        local.time_until_merger(25.0, mlgw_bns._binary(BINARY)), abs=0.05
    )


def test_its_gw170817_is_that_of_mlgw_bns_and_can_be_changed():
    binary = ParametersWithExtrinsic.gw170817()
    assert (binary.mass_ratio, binary.lambda_1, binary.chi_1, binary.total_mass) == (1.0, 400.0, 0.0, 2.8)
    binary.distance_mpc = 80.0
    assert binary.distance_mpc == 80.0


def test_the_ranges_have_the_names_of_mlgw_bns(model):
    assert model.parameter_ranges.q_range == (1.0, 3.0)
    assert model.parameter_ranges.lambda2_range == (0.0, 5000.0)


# What is refused


@pytest.mark.parametrize(
    ("attribute", "grid", "error"),
    [
        ("extend_with_post_newtonian", [1.0, 20.0], mlgw_bns.FrequencyTooLowError),
        ("extend_with_zeros_at_high_frequency", [20.0, 3500.0], mlgw_bns.FrequencyTooHighError),
        ("extend_with_zeros_at_high_frequency", [1.0, 3500.0], mlgw_bns.FrequencyTooHighError),
    ],
)
def test_outside_the_band_the_errors_are_those_of_mlgw_bns_where_it_is_not_extended(model, attribute, grid, error):
    model.predict(np.array(grid), BINARY)
    setattr(model, attribute, False)
    for ask in (model.predict, model.predict_amplitude_phase):
        with pytest.raises(error, match=attribute):
            ask(np.array(grid), BINARY)


@pytest.mark.parametrize("values", [{"lambda_1": -1.0}, {"total_mass": 0.0}, {"mass_ratio": 5.0}, {"chi_1": np.nan}])
def test_outside_the_range_the_error_is_a_value_error_that_names_the_parameter(model, values):
    with pytest.raises(ValueError, match=next(iter(values))):
        model.predict(GRID, changed(**values))


def test_parameters_outside_are_out_of_domain_and_a_frequency_of_zero_is_out_of_band(model):
    with pytest.raises(OutOfDomain):
        model.predict(GRID, changed(lambda_1=-1.0))
    with pytest.raises(OutOfBand):
        model.predict(np.array([1e-9, 20.0]), BINARY)
