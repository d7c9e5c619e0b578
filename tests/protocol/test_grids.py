"""Frequency grids: three forms, one meaning; the bad ones are refused with the place of the fault."""

import hashlib
import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_protocol import InvalidFrequencies, TooLarge, UniformGrid, as_frequencies, grid_digest


def refused(grid):
    with pytest.raises(InvalidFrequencies) as raised:
        as_frequencies(grid)
    return raised.value


@pytest.mark.parametrize("grid", [[20, 30.5], (20, 30.5), np.array([20, 30.5]), np.array([20, 30.5], ">f4")])
def test_every_vector_of_numbers_is_a_grid(grid):
    frequencies = as_frequencies(grid)
    assert frequencies.dtype == np.float64
    assert frequencies.flags.c_contiguous
    np.testing.assert_array_equal(frequencies, [20.0, 30.5])


def test_a_strided_view_is_a_grid():
    np.testing.assert_array_equal(as_frequencies(np.arange(1.0, 9.0)[::3]), [1.0, 4.0, 7.0])


@pytest.mark.parametrize(
    ("grid", "says", "row"),
    [
        ([20.0, math.nan, 30.0], "number 1 (nan Hz) is not finite", 1),
        ([20.0, math.inf], "number 1 (inf Hz) is not finite", 1),
        ([-math.inf, 1.0], "number 0 (-inf Hz) is not finite", 0),
        ([0.0, 1.0], "number 0 (0.0 Hz) is not positive; leave out the zero-frequency bin", 0),
        ([-1.0, 1.0], "number 0 (-1.0 Hz) is not positive", 0),
        ([1.0, 2.0, 2.0], "number 2 (2.0 Hz) is repeated", 2),
        ([1.0, 3.0, 2.0], "number 2 (2.0 Hz) is out of order; sort the frequencies", 2),
        ([3.0, 2.0, 1.0], "number 1 (2.0 Hz) is out of order", 1),
    ],
)
def test_the_first_bad_frequency_is_named(grid, says, row):
    error = refused(grid)
    assert says in error.detail
    assert (error.errors[0].parameter, error.errors[0].row) == ("frequencies", row)


@pytest.mark.parametrize(
    ("grid", "says"),
    [
        ([], "empty"),
        (np.zeros((0,)), "empty"),
        (20.0, r"shape ()"),
        ([[1.0, 2.0]], "shape (1, 2)"),
        (np.ones((1, 1)), "shape (1, 1)"),
        (["a", "b"], "vector of numbers"),
        ([[1.0], [1.0, 2.0]], "vector of numbers"),
        ({"f": 1}, "vector of numbers"),
        (None, "vector of numbers"),
    ],
    ids=str,
)
def test_what_is_no_vector_of_numbers_is_refused(grid, says):
    assert says in refused(grid).detail


@given(st.lists(st.floats(), max_size=8))
def test_what_is_accepted_is_positive_finite_and_increasing(values):
    try:
        frequencies = as_frequencies(values)
    except InvalidFrequencies:
        good = values and all(math.isfinite(f) and f > 0 for f in values)
        assert not (good and all(a < b for a, b in itertools.pairwise(values)))
    else:
        assert np.isfinite(frequencies).all()
        assert frequencies[0] > 0
        assert (np.diff(frequencies) > 0).all()


@given(st.integers(0, 5000), st.floats(1e-3, 100.0), st.floats(1e-4, 10.0))
def test_a_uniform_grid_ends_at_f_max_if_that_is_on_it(steps, f_min, delta_f):
    grid = UniformGrid(f_min, f_min + steps * delta_f, delta_f)
    frequencies = grid.frequencies()
    assert len(grid) == len(frequencies) == steps + 1
    assert frequencies[0] == f_min
    assert frequencies[-1] == pytest.approx(grid.f_max, rel=1e-12)
    np.testing.assert_array_equal(as_frequencies(grid), frequencies)


@pytest.mark.parametrize(("f_max", "last"), [(10.9, 10.5), (11.0, 11.0), (10.4999, 10.0), (10.0, 10.0), (10.1, 10.0)])
def test_a_uniform_grid_never_passes_f_max(f_max, last):
    assert UniformGrid(10.0, f_max, 0.5).frequencies()[-1] == last


def test_uniform_frequencies_are_not_accumulated():
    grid = UniformGrid(20.0, 2048.0, 1.0 / 128.0)
    np.testing.assert_array_equal(grid.frequencies(), 20.0 + np.arange(len(grid)) / 128.0)


@pytest.mark.parametrize("name", ["f_min", "f_max", "delta_f"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf, "20", None])
def test_a_bad_number_of_a_uniform_grid_is_named(name, value):
    with pytest.raises(InvalidFrequencies, match=f"'{name}' of a uniform grid must be a positive") as raised:
        UniformGrid(**({"f_min": 20.0, "f_max": 100.0, "delta_f": 0.5} | {name: value}))
    assert raised.value.errors[0].parameter == name


@pytest.mark.parametrize(
    ("f_min", "f_max", "delta_f", "says"),
    [(20.0, 10.0, 1.0, "is below 'f_min'"), (20.0, 30.0, 1e-18, "too small"), (1.0, 1e308, 1e-10, "too small")],
)
def test_a_uniform_grid_that_makes_no_sense_is_refused(f_min, f_max, delta_f, says):
    with pytest.raises(InvalidFrequencies, match=says):
        UniformGrid(f_min, f_max, delta_f)


def test_the_digest_is_the_sha256_of_little_endian_float64():
    frequencies = np.array([20.0, 20.5, 21.0])
    expected = hashlib.sha256(b"".join(np.float64(f).astype("<f8").tobytes() for f in frequencies)).hexdigest()
    assert grid_digest(frequencies) == expected
    assert grid_digest(frequencies.astype(">f8")) == expected
    assert grid_digest(np.repeat(frequencies, 2)[::2]) == expected
    assert grid_digest(np.nextafter(frequencies, 1.0)) != expected


def test_a_grid_that_no_memory_holds_is_an_error_that_says_so():
    grid = UniformGrid(20.0, 2048.0, 1e-12)
    with pytest.raises(TooLarge, match=r"no memory for the 20280000000000[0-9]* frequencies of this grid.*'delta_f'"):
        grid.frequencies()
    np.testing.assert_array_equal(grid.at(np.array([0, len(grid) - 1])), [20.0, 2048.0])
