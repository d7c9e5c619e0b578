"""What users give for numbers, precisions and options: taken, converted or refused alike by every model."""

import astropy.units as u
import numpy as np
import pandas as pd
import pytest

from bnserve_protocol import (
    InvalidFrequencies,
    InvalidParameters,
    InvalidRequest,
    ParametersWithExtrinsic,
    TooLarge,
    UniformGrid,
)
from tests.contract.test_waveform_model import METHODS, ONE, SHORT, TYPICAL, binaries, bits, failure

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")


@pytest.mark.parametrize("dtype", [np.complex64, np.dtype("complex64"), np.dtype(">c8"), "c8"], ids=str)
@pytest.mark.parametrize("method", ["predict", "predict_batch", "predict_factored"])
def test_a_precision_is_given_as_numpy_takes_it(model, local, method, dtype):
    there = getattr(model, method)(SHORT, ONE, dtype=dtype)
    assert bits(there) == bits(getattr(local, method)(SHORT, ONE, dtype="complex64"))
    assert there[0].dtype == np.complex64


@pytest.mark.parametrize("dtype", [complex, np.complex128, np.dtype(complex)], ids=str)
def test_double_precision_is_given_as_numpy_takes_it(model, local, dtype):
    assert bits(model.predict(SHORT, ONE, dtype=dtype)) == bits(local.predict(SHORT, ONE))


@pytest.mark.parametrize("options", [None, {}, {"alignment": "merger"}, "merger"], ids=str)
@pytest.mark.parametrize("method", ["predict", *METHODS])
def test_options_that_are_none_are_the_same_error(model, local, method, options):
    there = failure(lambda: getattr(model, method)(SHORT, ONE, options=options))
    assert there == failure(lambda: getattr(local, method)(SHORT, ONE, options=options))
    assert there[0] is InvalidRequest
    assert "'options' must be EvaluationOptions; got " in there[2]


@pytest.mark.parametrize("dtype", ["complex32", None, float, ["complex64"]], ids=str)
@pytest.mark.parametrize("method", ["predict", "predict_batch", "predict_factored"])
def test_a_precision_that_is_none_is_the_same_error(model, local, method, dtype):
    there = failure(lambda: getattr(model, method)(SHORT, ONE, dtype=dtype))
    assert there == failure(lambda: getattr(local, method)(SHORT, ONE, dtype=dtype))
    assert there[0] is InvalidRequest


KILOHERTZ = SHORT / 1000.0 * u.kHz
KILOGRAMS = np.array([2.5, 2.8]) * u.M_sun.to(u.kg) * u.kg
MILLISECONDS = 4 * u.ms
UNIFORM = UniformGrid(20.0, 500.0, 0.5)
HERTZ = KILOHERTZ.to_value("Hz")


def with_(**values):
    return TYPICAL | values


CONVERTED = {
    "a grid in kHz": (KILOHERTZ, TYPICAL, HERTZ, TYPICAL),
    "a list of quantities": ([*KILOHERTZ], TYPICAL, HERTZ, TYPICAL),
    "a uniform grid in kHz": (UniformGrid(0.02 * u.kHz, 0.5 * u.kHz, 500 * u.mHz), TYPICAL, UNIFORM, TYPICAL),
    "integers of numpy": (UniformGrid(20, np.int64(500), np.float32(0.5)), TYPICAL, UNIFORM, TYPICAL),
    "a distance in kpc": (SHORT, with_(distance_mpc=40e3 * u.kpc), SHORT, with_(distance_mpc=40.0)),
    "an angle in degrees": (SHORT, with_(inclination=180 * u.deg), SHORT, with_(inclination=np.pi)),
    "masses in kg": (SHORT, with_(total_mass=KILOGRAMS), SHORT, with_(total_mass=KILOGRAMS.to_value("Msun"))),
    "a shift in ms": (SHORT, with_(time_shift=MILLISECONDS), SHORT, with_(time_shift=MILLISECONDS.to_value("s"))),
    "pandas": (pd.Series(SHORT), with_(chi_1=pd.Series([0.1, 0.2])), SHORT, with_(chi_1=[0.1, 0.2])),
    "a table": (SHORT, pd.DataFrame([TYPICAL, with_(chi_1=0.2)]), SHORT, with_(chi_1=[TYPICAL["chi_1"], 0.2])),
    "objects": (SHORT.astype(object), with_(chi_1=np.array([0, 0.25], object)), SHORT, with_(chi_1=[0, 0.25])),
    "a mask that hides nothing": (np.ma.array(SHORT), with_(chi_1=np.ma.array([0.1])), SHORT, with_(chi_1=[0.1])),
}


@pytest.mark.parametrize(("grid", "batch", "plain_grid", "plain"), CONVERTED.values(), ids=CONVERTED)
@pytest.mark.parametrize("method", METHODS)
def test_what_carries_a_unit_is_converted(model, local, method, grid, batch, plain_grid, plain):
    assert bits(getattr(model, method)(grid, batch)) == bits(getattr(local, method)(plain_grid, plain))


def test_a_binary_in_other_units_is_that_binary(model, local):
    away = ParametersWithExtrinsic(**TYPICAL | {"distance_mpc": 40e3 * u.kpc, "inclination": 143.0 * u.deg})
    there = model.predict(KILOHERTZ, away)
    plain = ParametersWithExtrinsic(**TYPICAL | {"distance_mpc": 40.0, "inclination": (143.0 * u.deg).to_value("rad")})
    assert bits(there) == bits(local.predict(KILOHERTZ.to_value("Hz"), plain))
    assert model.time_until_merger(0.04 * u.kHz, away) == local.time_until_merger(40.0, plain)


def test_the_same_numbers_in_another_unit_are_another_grid(model, local):
    """Grids are remembered by their numbers."""
    there = [model.predict_factored(grid, ONE) for grid in (SHORT, SHORT * u.mHz * 1500, SHORT)]
    here = [local.predict_factored(grid, ONE) for grid in (SHORT, (SHORT * u.mHz * 1500).to_value("Hz"), SHORT)]
    assert [bits(answer) for answer in there] == [bits(answer) for answer in here]


NO_NUMBERS = {
    "a grid in seconds": (SHORT * u.s, TYPICAL, InvalidFrequencies, "has the unit 's'"),
    "a masked grid": (np.ma.array(SHORT, mask=SHORT > 1000.0), TYPICAL, InvalidFrequencies, "masked"),
    "a complex grid": (SHORT + 0j, TYPICAL, InvalidFrequencies, "complex"),
    "a grid of text": (["20", "30"], TYPICAL, InvalidFrequencies, "text"),
    "a distance in seconds": (SHORT, TYPICAL | {"distance_mpc": 3.0 * u.s}, InvalidParameters, "has the unit 's'"),
    "masked spins": (SHORT, TYPICAL | {"chi_1": np.ma.array([0.1, 0.2], mask=[0, 1])}, InvalidParameters, "masked"),
    "complex spins": (SHORT, TYPICAL | {"chi_1": np.array([0.1 + 0.1j])}, InvalidParameters, "complex"),
    "a spin as text": (SHORT, TYPICAL | {"chi_1": "0.1"}, InvalidParameters, "'chi_1' must be a number"),
    "a spin that is true": (SHORT, TYPICAL | {"chi_1": True}, InvalidParameters, "truth values"),
    "no spin": (SHORT, TYPICAL | {"chi_1": None}, InvalidParameters, "NoneType"),
}


@pytest.mark.parametrize(("grid", "batch", "kind", "says"), NO_NUMBERS.values(), ids=NO_NUMBERS)
@pytest.mark.parametrize("method", ["predict", *METHODS])
def test_what_counts_as_no_numbers_is_the_same_error(model, local, method, grid, batch, kind, says):
    there = failure(lambda: getattr(model, method)(grid, batch))
    assert there == failure(lambda: getattr(local, method)(grid, batch))
    assert there[0] is kind
    assert says in there[2]


@pytest.mark.parametrize("rows", [1, 3])
@pytest.mark.parametrize("method", METHODS)
def test_a_grid_that_nothing_can_hold_is_too_large(model, method, rows):
    with pytest.raises(TooLarge, match="frequencies"):
        getattr(model, method)(UniformGrid(20.0, 2048.0, 1e-10), binaries(rows))
