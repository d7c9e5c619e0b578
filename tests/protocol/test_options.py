"""Options and precision are closed sets, also for who builds them in Python."""

import msgspec
import pytest

from bnserve_protocol import DEFAULT_OPTIONS, EvaluationOptions, InvalidRequest, check_dtype


def test_the_defaults_extend_below_and_zero_above():
    assert EvaluationOptions() == DEFAULT_OPTIONS
    assert msgspec.structs.asdict(DEFAULT_OPTIONS) == {
        "out_of_domain": "error",
        "below_band": "extend",
        "above_band": "zero",
        "alignment": "post_newtonian",
    }


@pytest.mark.parametrize("name", ["out_of_domain", "below_band", "above_band", "alignment"])
@pytest.mark.parametrize("value", ["maybe", "", None, 1, ["error"]])
def test_another_value_is_refused_with_those_that_exist(name, value):
    with pytest.raises(InvalidRequest, match=f"^{name} must be one of "):
        EvaluationOptions(**{name: value})


def test_another_option_is_refused():
    with pytest.raises(TypeError, match="beyond_band"):
        EvaluationOptions(beyond_band="zero")


def test_a_precision_is_one_of_two():
    check_dtype("complex128")
    check_dtype("complex64")
    with pytest.raises(InvalidRequest, match="complex128, complex64; got 'complex256'"):
        check_dtype("complex256")
