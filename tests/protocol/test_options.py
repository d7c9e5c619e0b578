"""Options and precision are closed sets, also for who builds them in Python."""

import msgspec
import numpy as np
import pytest
from astropy import units as u

from bnserve_protocol import DEFAULT_OPTIONS, EvaluationOptions, InvalidRequest, check_dtype, chosen_modes, the_mode


def test_the_defaults_extend_below_and_zero_above():
    assert EvaluationOptions() == DEFAULT_OPTIONS
    assert msgspec.structs.asdict(DEFAULT_OPTIONS) == {
        "out_of_domain": "error",
        "below_band": "extend",
        "above_band": "zero",
        "alignment": "post_newtonian",
        "modes": None,
        "reference_frequency": None,
    }


@pytest.mark.parametrize("name", ["out_of_domain", "below_band", "above_band", "alignment"])
@pytest.mark.parametrize("value", ["maybe", "", None, 1, ["error"]])
def test_another_value_is_refused_with_those_that_exist(name, value):
    with pytest.raises(InvalidRequest, match=f"^{name} must be one of "):
        EvaluationOptions(**{name: value})


def test_another_option_is_refused():
    with pytest.raises(TypeError, match="beyond_band"):
        EvaluationOptions(beyond_band="zero")


@pytest.mark.parametrize(
    "given", [[[2, 2], [3, 3]], ((2, 2), (3, 3)), np.array([[2, 2], [3, 3]]), iter([(2, 2), (3, 3)])]
)
def test_modes_are_pairs_in_their_order(given):
    options = EvaluationOptions(modes=given)
    assert options.modes == ((2, 2), (3, 3))
    assert options == EvaluationOptions(modes=[(2, 2), (3, 3)]) != EvaluationOptions(modes=[(3, 3), (2, 2)])
    assert {options: "found"}[EvaluationOptions(modes=((2, 2), (3, 3)))] == "found"


BAD_MODES = {
    "none": ([], "got none"),
    "one that is no pair": ([(2, 2), 3], "one of them is 3"),
    "a triple": ([(2, 2, 2)], r"one of them is \(2, 2, 2\)"),
    "fractions": ([(2.0, 2.0)], "one of them is"),
    "a pair alone": ((2, 2), "one of them is 2"),
    "text": ("22", "got '22'"),
    "a number": (22, "got 22"),
    "one twice": ([(2, 2), (3, 3), [2, 2]], r"got \(2, 2\) twice"),
    "very many": ([(i, i) for i in range(100)], "more than 64"),
}


@pytest.mark.parametrize(("given", "says"), BAD_MODES.values(), ids=BAD_MODES)
def test_what_are_no_modes_is_refused(given, says):
    with pytest.raises(InvalidRequest, match=rf"^'modes' are pairs \(l, m\) such as .*{says}"):
        EvaluationOptions(modes=given)


KNOWN = [(2, 2), (2, 1), (3, 3)]


def test_all_modes_are_chosen_unless_some_are():
    assert chosen_modes(DEFAULT_OPTIONS, KNOWN) == tuple(KNOWN)
    assert chosen_modes(EvaluationOptions(modes=[(3, 3), (2, 2)]), KNOWN) == ((3, 3), (2, 2))
    with pytest.raises(InvalidRequest, match=r"no mode \(5, 5\); it has \(2, 2\), \(2, 1\), \(3, 3\)\.$"):
        chosen_modes(EvaluationOptions(modes=[(2, 2), (5, 5)]), KNOWN)
    with pytest.raises(InvalidRequest, match=r"no mode \(3, -3\); .*\. \(3, 3\) stands for it, too\."):
        chosen_modes(EvaluationOptions(modes=[(3, -3)]), KNOWN)


def test_what_belongs_to_one_mode_needs_one():
    assert the_mode(DEFAULT_OPTIONS, [(2, 2)]) == (2, 2)
    assert the_mode(EvaluationOptions(modes=[(3, 3)]), KNOWN) == (3, 3)
    for options, says in ((DEFAULT_OPTIONS, "this model has 3"), (EvaluationOptions(modes=KNOWN[:2]), "you chose 2")):
        with pytest.raises(
            InvalidRequest, match=rf"belongs to one mode, and {says}: choose one with modes=\[\(2, 2\)\]"
        ):
            the_mode(options, KNOWN)


def test_a_reference_frequency_is_a_frequency():
    assert EvaluationOptions(reference_frequency=20).reference_frequency == 20.0
    assert EvaluationOptions(reference_frequency=0.02 * u.kHz).reference_frequency == 20.0
    for value in (0.0, -20.0, np.nan, np.inf, "20", [20.0, 30.0], True, 20.0 * u.s):
        with pytest.raises(
            InvalidRequest, match="'reference_frequency' must be a positive, finite number of Hz, or None"
        ):
            EvaluationOptions(reference_frequency=value)


def test_a_precision_is_one_of_two():
    check_dtype("complex128")
    check_dtype("complex64")
    with pytest.raises(InvalidRequest, match="complex128, complex64; got 'complex256'"):
        check_dtype("complex256")
