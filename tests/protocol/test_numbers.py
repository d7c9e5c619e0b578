"""What counts as numbers: units are converted, and nothing is dropped without a word."""

import decimal
import fractions
import math

import astropy.units as u
import numpy as np
import pandas as pd
import pytest
from astropy.table import Column
from astropy.utils.masked import Masked

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    InvalidFrequencies,
    InvalidParameters,
    LikelihoodBatch,
    LikelihoodParameters,
    NotNumbers,
    ParameterBatch,
    ParametersWithExtrinsic,
    TimeGrid,
    TimeMarginalisation,
    UniformGrid,
    as_frequencies,
    as_numbers,
    as_real_number,
    as_real_numbers,
)

TAKEN = {
    "a float": (1.5, 1.5),
    "an integer": (2, 2.0),
    "numpy's scalars": (np.float32(1.5), 1.5),
    "numpy's integer": (np.int64(2), 2.0),
    "an array without dimensions": (np.array(2.0), 2.0),
    "a list": ([1, 2.5], [1.0, 2.5]),
    "a list of arrays without dimensions": ([np.array(1.0), np.float16(2.5)], [1.0, 2.5]),
    "a tuple of lists": (([1, 2], [3, 4]), [[1.0, 2.0], [3.0, 4.0]]),
    "single precision, big-endian": (np.array([1.0, 2.5], ">f4"), [1.0, 2.5]),
    "unsigned integers": (np.array([1, 2], np.uint8), [1.0, 2.0]),
    "an array of objects": (np.array([1, 2.5], object), [1.0, 2.5]),
    "pandas": (pd.Series([1, 2]), [1.0, 2.0]),
    "pandas with objects": (pd.Series([1, 2.5], dtype=object), [1.0, 2.5]),
    "pandas of its own type": (pd.Series([1.0, 2.5], dtype="Float64"), [1.0, 2.5]),
    "other kinds of numbers": ([decimal.Decimal("1.5"), fractions.Fraction(1, 2)], [1.5, 0.5]),
    "a range": (range(2), [0.0, 1.0]),
    "a mask that hides nothing": (np.ma.array([1.0, 2.0], mask=[False, False]), [1.0, 2.0]),
    "astropy's mask that hides nothing": (Masked([1.0, 2.0], mask=[False, False]), [1.0, 2.0]),
    "a column without a unit": (Column([1.0, 2.0]), [1.0, 2.0]),
    "nothing": ([], []),
}


@pytest.mark.parametrize(("value", "numbers"), TAKEN.values(), ids=TAKEN)
def test_numbers_of_every_kind_are_taken(value, numbers):
    taken = as_real_numbers(value, "1")
    assert (type(taken), taken.dtype, taken.shape) == (np.ndarray, np.float64, np.shape(numbers))
    np.testing.assert_array_equal(taken, numbers)


def test_an_array_of_doubles_is_taken_as_it_is():
    array = np.array([1.0, 2.0])
    assert as_real_numbers(array, "Hz") is array


UNITS = {
    "a scalar": (40e3 * u.kpc, "Mpc", 40.0),
    "a vector": (np.array([1.0, 2.0]) * u.kHz, "Hz", [1000.0, 2000.0]),
    "integers": (np.array([1, 2]) * u.kHz, "Hz", [1000.0, 2000.0]),
    "a list of different units": ([1.0 * u.kHz, 5.0 * u.Hz], "Hz", [1000.0, 5.0]),
    "an array of objects": (np.array([1.0 * u.kHz, 5.0 * u.Hz], object), "Hz", [1000.0, 5.0]),
    "an angle": (180.0 * u.deg, "rad", math.pi),
    "a mass": (1.0 * u.M_sun, "Msun", 1.0),
    "a pure number": (50.0 * u.percent, "1", 0.5),
    "the unit itself": (3.0 * u.dimensionless_unscaled, "1", 3.0),
    "a strain": ([2.0] * (1 / u.kHz), "1/Hz", [2e-3]),
    "an amplitude spectral density": (2.0 / u.kHz**0.5, "1/Hz^(1/2)", 2.0 / 1000.0**0.5),
    "numpy's mask over a unit": (np.ma.array([1.0, 2.0] * u.kHz), "Hz", [1000.0, 2000.0]),
    "astropy's mask over a unit": (Masked([1.0, 2.0] * u.kHz, mask=[False, False]), "Hz", [1000.0, 2000.0]),
}


@pytest.mark.parametrize(("value", "unit", "numbers"), UNITS.values(), ids=UNITS)
def test_units_are_converted(value, unit, numbers):
    taken = as_real_numbers(value, unit)
    assert (type(taken), taken.dtype) == (np.ndarray, np.float64)
    np.testing.assert_allclose(taken, numbers, rtol=1e-15)  # a conversion rounds once


@pytest.mark.parametrize("unit", sorted(set(PARAMETER_UNITS.values())))
def test_every_unit_of_a_parameter_is_one_of_astropy(unit):
    assert as_real_number(2.0 * u.Unit(unit), unit) == 2.0


class Foreign:
    """A vector of a library of units that cannot be asked to convert, as pint's."""

    units = "megaparsec"

    def __array__(self, dtype=None, copy=None):
        return np.array([1.0], dtype)


REFUSED = {
    "another unit": (3.0 * u.s, "has the unit 's', which is not one of 'Mpc'"),
    "a pure number with a unit": (3.0 * u.dimensionless_unscaled, "has the unit '', which is not one of 'Mpc'"),
    "a list with one of another": ([1.0 * u.Mpc, 1.0 * u.s], "has the unit 's'"),
    "a unit that cannot be asked": (Foreign(), "carries a unit (megaparsec)"),
    "a column with a unit": (Column([1.0], unit="kpc"), "carries a unit (kpc), which is not converted here"),
    "text": ("40", "holds text"),
    "bytes": (b"40", "holds text"),
    "text in a list": ([1.0, "2"], "holds text"),
    "text in an array": (np.array(["1"]), "holds text"),
    "text among objects": (np.array([1.0, "2"], object), "holds text"),
    "text of pandas": (pd.Series(["1"]), "holds text"),
    "a truth value": (True, "holds truth values"),
    "numpy's truth value": (np.True_, "holds truth values"),
    "truth values in a list": ([True, 2.0], "holds truth values"),
    "truth values": (np.array([True]), "holds truth values"),
    "nothing": (None, "holds NoneType"),
    "nothing in a list": ([1.0, None], "holds NoneType"),
    "a complex number": (1j, "is complex"),
    "complex numbers in a list": ([1.0, 1j], "is complex"),
    "complex numbers that are real": (np.array([1.0 + 0j]), "is complex"),
    "a mask": (np.ma.array([1.0, 2.0], mask=[False, True]), "has masked entries"),
    "masked": (np.ma.masked, "has masked entries"),
    "masked in a list": ([1.0, np.ma.masked], "has masked entries"),
    "astropy's mask": (Masked([1.0, 2.0] * u.Mpc, mask=[False, True]), "has masked entries"),
    "a missing value of pandas": (pd.Series([1.0, None], dtype=object), "holds NoneType"),
    "a duration": (np.timedelta64(5, "s"), "holds timedelta64"),
    "a date": (np.datetime64("2017-08-17"), "holds datetime64"),
    "a ragged list": ([[1.0], [1.0, 2.0]], "entries of different lengths"),
    "a mapping": ({"a": 1}, "holds dict"),
    "a generator": ((x for x in [1.0]), "holds generator"),
    "an integer beyond doubles": (10**400, "beyond double precision"),
    "one in a list": ([10**400], "beyond double precision"),
    "a record": (np.array([(1, 2.0)], dtype="i4,f8"), "holds void"),
}


@pytest.mark.parametrize(("value", "says"), REFUSED.values(), ids=REFUSED)
def test_the_rest_is_refused(value, says):
    with pytest.raises(NotNumbers) as raised:
        as_real_numbers(value, "Mpc")
    assert says in str(raised.value)


def test_a_list_without_end_is_refused():
    endless = []
    endless.append(endless)
    with pytest.raises(NotNumbers, match="nested too deeply"):
        as_real_numbers(endless, "1")


def test_what_has_no_unit_takes_none():
    with pytest.raises(NotNumbers, match="carries a unit"):
        as_real_numbers(np.zeros((1, 10)) * u.Mpc, None)


def test_complex_numbers_are_taken_where_they_belong():
    assert as_numbers([1.0, 2j], "1").tolist() == [1.0, 2j]
    assert as_numbers([1.0, 2j] / u.kHz, "1/Hz").tolist() == [1e-3, 2e-3j]
    assert as_numbers([1, 2], "1").dtype == np.float64
    assert as_numbers(np.array([1j], np.complex64), "1").dtype == np.complex128
    with pytest.raises(NotNumbers, match="masked"):
        as_numbers(np.ma.array([1j], mask=[True]), "1")


@pytest.mark.parametrize("value", [[400.0], np.array([400.0]), pd.Series([400.0]), []])
def test_one_number_is_no_vector_of_one(value):
    with pytest.raises(NotNumbers, match="not one number"):
        as_real_number(value, "1")


GW170817 = {name: getattr(ParametersWithExtrinsic.gw170817(), name) for name in PARAMETER_NAMES}
SOURCE = dict.fromkeys(LIKELIHOOD_NAMES, 0.5) | {"mass_ratio": 1.2, "total_mass": 2.8, "distance_mpc": 40.0}
ODD_UNITS = {"Mpc": u.kpc, "rad": u.deg, "Msun": u.kg, "s": u.ms, "1": u.percent, "Hz": u.kHz}


@pytest.mark.parametrize("name", PARAMETER_NAMES)
def test_every_parameter_of_a_binary_is_converted_to_its_unit(name):
    value = (GW170817[name] * u.Unit(PARAMETER_UNITS[name])).to(ODD_UNITS[PARAMETER_UNITS[name]])
    one = ParametersWithExtrinsic(**GW170817 | {name: value})
    assert type(getattr(one, name)) is float
    assert getattr(one, name) == pytest.approx(GW170817[name], rel=1e-12, abs=1e-300)
    batch = ParameterBatch.coerce(GW170817 | {name: np.full(3, value.value) * value.unit})
    np.testing.assert_array_equal(batch[name], [getattr(one, name)] * 3)


@pytest.mark.parametrize("name", LIKELIHOOD_NAMES)
def test_every_parameter_of_a_signal_is_converted_to_its_unit(name):
    value = (SOURCE[name] * u.Unit(PARAMETER_UNITS[name])).to(ODD_UNITS[PARAMETER_UNITS[name]])
    one = LikelihoodParameters(**SOURCE | {name: value})
    assert type(getattr(one, name)) is float
    assert getattr(one, name) == pytest.approx(SOURCE[name], rel=1e-12)
    batch = LikelihoodBatch.coerce(SOURCE | {name: np.full(3, value.value) * value.unit})
    np.testing.assert_array_equal(batch[name], [getattr(one, name)] * 3)


def test_calibration_errors_are_converted():
    errors = {"calibration_amplitude": {"H1": [5.0] * 4 * u.percent}, "calibration_phase": {"H1": [180.0] * 4 * u.deg}}
    for batch in (
        LikelihoodBatch.coerce(SOURCE | errors),
        LikelihoodBatch.coerce(LikelihoodParameters(**SOURCE | errors)),
    ):
        np.testing.assert_allclose(batch.calibration_amplitude["H1"], [[0.05] * 4], rtol=1e-15)
        np.testing.assert_allclose(batch.calibration_phase["H1"], [[np.pi] * 4], rtol=1e-15)


@pytest.mark.parametrize("value", [[400.0], np.array([400.0]), "400", True, None, 400j, 4.0 * u.kg])
@pytest.mark.parametrize(("kind", "fields"), [(ParametersWithExtrinsic, GW170817), (LikelihoodParameters, SOURCE)])
def test_what_is_no_number_is_refused_under_its_own_name(kind, fields, value):
    with pytest.raises(InvalidParameters, match="'lambda_1' of one binary must be a number; it") as raised:
        kind(**fields | {"lambda_1": value})
    assert raised.value.errors[0].parameter == "lambda_1"


def test_a_table_of_parameters_has_no_one_unit():
    with pytest.raises(InvalidParameters, match="carries a unit"):
        ParameterBatch(np.ones((2, 10)) * u.Mpc)


def test_frequencies_are_converted():
    np.testing.assert_array_equal(as_frequencies([0.02, 0.03] * u.kHz), [20.0, 30.0])
    assert UniformGrid(0.02 * u.kHz, np.float32(2048), np.int64(1)) == UniformGrid(20.0, 2048.0, 1.0)


@pytest.mark.parametrize("grid", [[20.0, 30.0] * u.s, np.ma.array([20.0, 30.0], mask=[0, 1]), [20j, 30j], ["20", "30"]])
def test_frequencies_that_are_none_are_refused(grid):
    with pytest.raises(InvalidFrequencies, match="must be a vector of numbers in Hz"):
        as_frequencies(grid)


@pytest.mark.parametrize("value", ["20", True, np.True_, None, 20j, [20.0], 20.0 * u.s, np.ma.masked])
def test_a_uniform_grid_is_made_of_numbers(value):
    for place in range(3):
        numbers = [20.0, 30.0, 0.5]
        numbers[place] = value
        with pytest.raises(InvalidFrequencies, match="must be a positive, finite number of Hz; got"):
            UniformGrid(*numbers)


def test_settings_of_an_analysis_are_converted():
    assert DistanceMarginalisation(minimum=1.0 * u.kpc, maximum=np.array(10)).minimum == 1e-3
    assert TimeMarginalisation(minimum=-50 * u.ms, maximum=0.05, step=1 * u.ms).minimum == -0.05
    assert TimeGrid(start=np.float32(1), step=1 * u.ms) == TimeGrid(start=1.0, step=1e-3)
    assert Calibration(nodes=5, f_min=0.02 * u.kHz, f_max=1024).f_min == 20.0
    with pytest.raises(AnalysisInvalid, match="'minimum' of DistanceMarginalisation must be a number in Mpc; it has"):
        DistanceMarginalisation(minimum=1.0 * u.s, maximum=10.0)
