"""A mass is no limit: the waveform is a function of M f, and a mass says which frequencies of it are in the band."""

from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import SOLAR_MASS_SECONDS, EvaluationOptions, ParametersWithExtrinsic
from bnserve_surrogate import Model
from tests.surrogate.other_codes import strain_of_teobresums

MERGER = EvaluationOptions(alignment="merger")
MASSES = [1.0, 2.8, 6.0, 12.0, 30.0]
ONE = ParametersWithExtrinsic(
    mass_ratio=1.6, lambda_1=350.0, lambda_2=1800.0, chi_1=0.2, chi_2=-0.1,
    distance_mpc=300.0, inclination=0.9, total_mass=2.8,
)  # fmt: skip


@pytest.fixture(scope="module", params=["default", "fast"])
def model(request):
    return Model.load(request.param, "1.0.0")


@pytest.mark.parametrize("mass", MASSES)
def test_at_any_mass_it_is_teobresums_at_that_mass(model, mass):
    """Called in solar masses and Hz, from a little below the band to its top."""
    one = replace(ONE, total_mass=mass)
    low, top = (edge / (mass * SOLAR_MASS_SECONDS) for edge in model.description.mf_band)
    f = np.geomspace(low * (1.0 + 1e-9), 0.9 * top, 400)
    for ours, theirs in zip(model.predict(f, one, options=MERGER), strain_of_teobresums(f, one), strict=True):
        assert np.linalg.norm(ours - theirs) < 2e-3 * np.linalg.norm(theirs)
        np.testing.assert_allclose(np.abs(ours), np.abs(theirs), rtol=0.01)
        line = np.polynomial.Polynomial.fit(f, np.angle(ours / theirs), 1)
        assert np.abs(np.angle(ours / theirs) - line(f)).max() < 0.015
        offset, slope = line.convert().coef
        assert abs(offset) < 3e-3
        assert abs(slope) < 2.0 * np.pi * 4e-6 * mass  # seconds, of the merger's time


@pytest.mark.parametrize("mass", [0.2, *MASSES, 100.0])
@pytest.mark.parametrize("alignment", ["merger", "post_newtonian"])
def test_a_waveform_is_that_of_another_mass_at_frequencies_times_the_ratio(model, mass, alignment):
    """h(f; M) = (M / M')^2 h(f M / M'; M'): inside the band, below it and above it, with what is flagged and zero."""
    options = EvaluationOptions(alignment=alignment)
    mf = np.geomspace(0.3 * model.description.mf_band[0], 1.2 * model.description.mf_band[1], 300)
    mine, reference = (
        model.predict(mf / (total * SOLAR_MASS_SECONDS), replace(ONE, total_mass=total), options=options).plus
        for total in (mass, 2.8)
    )
    np.testing.assert_allclose(mine, (mass / 2.8) ** 2 * reference, rtol=1e-8, atol=0.0)


def test_the_description_says_for_which_masses_its_band_is_and_where_it_is_at_others(model):
    described = model.description
    assert described.frequency_band_masses == (2.0, 4.0)
    lowest, highest = described.frequency_band_masses
    ends = described.frequency_band[0] * lowest, described.frequency_band[1] * highest
    assert described.mf_band == pytest.approx([end * SOLAR_MASS_SECONDS for end in ends], rel=1e-12)
    total_mass = next(entry for entry in described.parameters if entry.name == "total_mass")
    assert (total_mass.minimum, total_mass.maximum) == (0.2, 100.0)


def test_the_typical_binary_is_of_a_mass_for_which_the_frequency_band_is(model):
    assert model.typical_binary().total_mass == 3.0


def test_the_time_until_merger_scales_with_the_mass(model):
    at = [model.time_until_merger(40.0 * 2.8 / mass, replace(ONE, total_mass=mass)) / mass for mass in MASSES]
    np.testing.assert_allclose(at, at[0], rtol=1e-6)
