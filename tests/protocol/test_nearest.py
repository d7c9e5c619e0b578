"""What an unknown name may have meant."""

import pytest

from bnserve_protocol import (
    COORDINATES,
    FORECAST_COORDINATES,
    LIKELIHOOD_NAMES,
    PARAMETER_NAMES,
    InvalidParameters,
    LikelihoodBatch,
    ParameterBatch,
    convert,
    nearest_name,
)
from bnserve_protocol._foreign import FORMULAS, SAME
from bnserve_protocol._parameters import IN_PLANE_NAMES

NAMES = sorted(
    {*PARAMETER_NAMES, *IN_PLANE_NAMES, *LIKELIHOOD_NAMES, *SAME, *FORMULAS, *COORDINATES, *FORECAST_COORDINATES}
)


def slips(name):
    """All names that are one slip of a finger, or of a habit, from this one."""
    for i in range(len(name)):
        yield name[:i] + name[i + 1 :]
        yield name[: i + 1] + name[i:]
        yield name[:i] + name[i : i + 2][::-1] + name[i + 2 :]
    yield from (name.upper(), name.title().replace("_", ""), name.replace("_", "-"), name.replace("_", " "))


def plain(name):
    return name.casefold().translate(str.maketrans("", "", "_- "))


def without_a_letter(name):
    return {name, *(name[:i] + name[i + 1 :] for i in range(len(name)))}


@pytest.mark.parametrize("name", NAMES)
def test_a_slip_is_found_in_all_accepted_names(name):
    """It is the name itself, or another that is as near: of ``chi_`` it is either spin."""
    for misspelt in set(slips(name)) - {*NAMES, ""}:
        found = nearest_name(misspelt, NAMES)
        assert found is not None
        as_near = without_a_letter(plain(found)) & without_a_letter(plain(misspelt))
        assert plain(found) == plain(name) or as_near, misspelt


@pytest.mark.parametrize(
    ("misspelt", "meant"),
    [
        ("chirp_mas", "chirp_mass"),
        ("chrip_mass", "chirp_mass"),
        ("Mass_1", "mass_1"),
        ("luminosity_distanc", "luminosity_distance"),
        ("thetajn", "theta_jn"),
        ("lambda_tild", "lambda_tilde"),
        ("RA", "ra"),
        ("geocenttime", "geocent_time"),
        ("declinaton", "declination"),
        ("chi_", "chi_1"),
        ("CHI_2", "chi_2"),
    ],
)
def test_names_of_other_programs_are_suggested_with_what_to_give(misspelt, meant):
    binary = dict.fromkeys(LIKELIHOOD_NAMES, 1.0)
    with pytest.raises(InvalidParameters, match=f"Unknown parameter '{misspelt}'. Did you mean '{meant}'") as caught:
        LikelihoodBatch.coerce(binary | {misspelt: 1.0})
    assert ("Here, " in caught.value.detail or "same" in caught.value.detail) == (meant not in LIKELIHOOD_NAMES)
    with pytest.raises(InvalidParameters, match=f"Did you mean '{meant}'"):
        convert({misspelt: 1.0, "mass_ratio": 1.2})


def test_what_is_like_nothing_gets_the_list():
    with pytest.raises(InvalidParameters, match="Known names: mass_ratio, "):
        ParameterBatch.coerce(dict.fromkeys(PARAMETER_NAMES, 1.0) | {"xyzzy": 1.0})
    assert nearest_name("anything", []) is None
    assert nearest_name(3, ["mode_3"]) is None
    assert nearest_name("x" * 10**7, NAMES) is None


def test_a_few_of_many_unknown_names_are_explained():
    """A small body has room for a hundred thousand, which would take minutes."""
    many = {f"chirp_mas{number}": 1.0 for number in range(100_000)}
    with pytest.raises(InvalidParameters, match="And 99992 more such names") as caught:
        ParameterBatch.coerce(dict.fromkeys(PARAMETER_NAMES, 1.0) | many)
    assert len(caught.value.errors) == 8
