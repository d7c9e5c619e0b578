"""A binary by the names of other programs: converted where that is exact, else refused with the formula."""

import numpy as np
import pytest
from bilby.gw import conversion

from bnserve_protocol import InvalidParameters, ParameterBatch, ParametersWithExtrinsic, convert

REST = {"chi_1": 0.01, "chi_2": 0.0, "distance_mpc": 40.0, "inclination": 2.5}
TIDES = {"lambda_1": 400.0, "lambda_2": 600.0}
MASSES = [
    {"mass_1": 1.5, "mass_2": 1.25},
    {"chirp_mass": conversion.component_masses_to_chirp_mass(1.5, 1.25), "mass_ratio": 1.25 / 1.5},
    {"chirp_mass": conversion.component_masses_to_chirp_mass(1.5, 1.25), "mass_ratio": 1.2},
    {"chirp_mass": conversion.component_masses_to_chirp_mass(1.5, 1.25), "symmetric_mass_ratio": 1.875 / 2.75**2},
    {"total_mass": 2.75, "eta": 1.875 / 2.75**2},
]


@pytest.mark.parametrize("masses", MASSES, ids=lambda masses: "+".join(masses))
def test_masses(masses):
    ours = convert(masses | REST | TIDES)
    assert ours["mass_ratio"] == pytest.approx(1.2, rel=1e-12)
    assert ours["total_mass"] == pytest.approx(2.75, rel=1e-12)
    assert len(ParameterBatch.coerce(ours)) == 1


def test_stars_change_places_with_their_spins_and_tides():
    ours = convert({"mass_1": [1.5, 1.25], "mass_2": [1.25, 1.5], "spin_1z": [0.1, 0.2], "spin2z": [0.3, 0.4],
                    "lambda_1": 400.0, "lambda2": 600.0})  # fmt: skip
    assert ours["chi_1"].tolist() == [0.1, 0.4]
    assert ours["chi_2"].tolist() == [0.3, 0.2]
    assert ours["lambda_1"].tolist() == [400.0, 600.0]
    assert ours["mass_ratio"].tolist() == [1.2, 1.2]


def test_spins_in_the_orbital_plane_change_places_as_they_are():
    """As in LAL's models of the frequency domain, which turn nothing."""
    given = {"mass_1": [1.5, 1.25], "mass_2": [1.25, 1.5], "spin1x": 0.1, "spin1y": [0.2, 0.3], "iota": 0.4}
    ours = convert(given)
    assert ours["chi_1x"].tolist() == [0.1, 0.0]
    assert ours["chi_2x"].tolist() == [0.0, 0.1]
    assert ours["chi_1y"].tolist() == [0.2, 0.0]
    assert ours["chi_2y"].tolist() == [0.0, 0.3]
    assert ours["inclination"] == 0.4


def test_tides_are_bilbys():
    mass_1, mass_2 = np.array([1.4, 1.6]), np.array([1.4, 1.2])
    expected = conversion.lambda_tilde_delta_lambda_tilde_to_lambda_1_lambda_2(500.0, 30.0, mass_1, mass_2)
    named = {"mass_1": mass_1, "mass_2": mass_2, "lambda_tilde": 500.0, "delta_lambda_tilde": 30.0}
    ours = convert(named | REST)
    np.testing.assert_allclose([ours["lambda_1"], ours["lambda_2"]], expected, rtol=1e-10)


def test_tides_of_a_lighter_first_star_are_bilbys_too():
    """Who takes the formulas as they stand: star 1 keeps the formulas' lambda_1 and becomes our star 2."""
    expected = conversion.lambda_tilde_delta_lambda_tilde_to_lambda_1_lambda_2(500.0, 30.0, 1.2, 1.6)
    ours = convert({"mass_1": 1.2, "mass_2": 1.6, "lambda_tilde": 500.0, "delta_lambda_tilde": 30.0} | REST)
    np.testing.assert_allclose([ours["lambda_2"], ours["lambda_1"]], expected, rtol=1e-10)
    back = conversion.lambda_1_lambda_2_to_lambda_tilde(ours["lambda_1"], ours["lambda_2"], 1.6, 1.2)
    assert back != pytest.approx(500.0, rel=0.05), "so the pair is not that of the binary"


def test_names_of_the_same_quantity_and_aligned_spins():
    ours = convert({"luminosity_distance": 40.0, "theta_jn": 2.5, "ra": 1.0, "a_1": 0.1, "tilt_1": np.pi})
    assert ours == {
        "distance_mpc": 40.0, "inclination": 2.5, "right_ascension": 1.0, "chi_1": pytest.approx(-0.1)
    }  # fmt: skip


def test_no_spin_has_no_direction():
    """bilby converts an aligned spin of zero to a tilt that is NaN."""
    ours = convert({"a_1": [0.0, 0.1], "tilt_1": [np.nan, 0.0], "a_2": 0.0, "cos_tilt_2": np.nan})
    assert ours["chi_1"].tolist() == [0.0, 0.1]
    assert ours["chi_2"] == 0.0


REFUSED = {
    "another angle": ({"theta_jn": 0.4, "spin1x": 0.1}, "inclination is the angle of the orbital angular momentum"),
    "a spin in the plane": ({"a_1": 0.1, "tilt_1": 0.5}, "chi_1x, chi_1y are what is in the orbital plane"),
    "a spin without a sign": ({"a_1": 0.1}, "Give chi_1 itself"),
    "half of the tides": ({"lambda_tilde": 500.0, "mass_ratio": 1.2}, "together .* which convert.. solves"),
    "one mass": ({"mass_1": 1.4}, "mass_ratio = mass_1 / mass_2"),
    "masses twice": ({"mass_1": 1.4, "mass_2": 1.3, "total_mass": 2.7}, "stated twice"),
    "a name twice": ({"theta_jn": 1.0, "inclination": 1.0}, "two names of one quantity"),
    "a time": ({"geocent_time": 1e9}, "in seconds from its trigger"),
    "a misspelt name": ({"mass_rato": 1.2}, "Did you mean 'mass_ratio'"),
    "text": ({"mass_1": "heavy", "mass_2": 1.0}, "'mass_1' holds text"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_not_exact_is_refused_with_what_to_give(case):
    given, reason = REFUSED[case]
    with pytest.raises(InvalidParameters, match=reason):
        convert(given)


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("mass_1", "mass_ratio = mass_1 / mass_2"), ("chirp_mass", "total_mass = chirp_mass"),
        ("luminosity_distance", "'distance_mpc' is the same"), ("theta_jn", "'inclination' is the same"),
        ("tilt_1", "chi_1 = a_1"), ("lambda_tilde", "delta_lambda_tilde together"), ("phase", "reference_phase"),
    ],
)  # fmt: skip
def test_names_of_others_are_refused_with_the_formula_where_ours_are_asked_for(name, hint):
    with pytest.raises(InvalidParameters, match=hint):
        ParameterBatch.coerce({name: 1.0})
    with pytest.raises(InvalidParameters, match=hint):
        ParametersWithExtrinsic(**{name: 1.0})
