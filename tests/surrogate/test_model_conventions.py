"""Signs, units and alignment of the shipped model against LALSimulation and TEOBResumS, called directly."""

from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import UniformGrid
from bnserve_surrogate import EvaluationOptions, Model, ParametersWithExtrinsic
from tests.surrogate.one_mode import OneMode
from tests.surrogate.other_codes import strain_of_lal, strain_of_teobresums

BINARIES = {
    "like GW170817": ParametersWithExtrinsic.gw170817(),
    "unequal, spinning": ParametersWithExtrinsic(
        mass_ratio=2.1, lambda_1=150.0, lambda_2=2500.0, chi_1=0.3, chi_2=-0.2,
        distance_mpc=120.0, inclination=0.7, total_mass=3.1,
    ),
}  # fmt: skip
MERGER = EvaluationOptions(alignment="merger")
binaries = pytest.mark.parametrize("one", BINARIES.values(), ids=list(BINARIES))


@pytest.fixture(scope="module")
def model():
    return OneMode(Model.default())


def left_after_a_line(frequencies, phase):
    """The largest modulus of an unwrapped phase less its best constant and slope."""
    unwrapped = np.unwrap(phase)
    return np.abs(unwrapped - np.polynomial.Polynomial.fit(frequencies, unwrapped, 1)(frequencies)).max()


@binaries
def test_the_phase_has_lals_sign(model, one):
    f = np.linspace(8.0, 40.0, 20_000)
    theirs, _ = strain_of_lal(f, one, "TaylorF2")
    ours = model.predict(f, one).plus
    assert left_after_a_line(f, np.angle(ours / theirs)) < 0.05
    assert left_after_a_line(f, np.angle(ours.conj() / theirs)) > 1000.0


@binaries
@pytest.mark.parametrize(
    ("approximant", "band", "tolerance"),
    [("TaylorF2", (8.0, 20.0), 1e-2), ("IMRPhenomD_NRTidalv2", (8.0, 300.0), 2e-3)],
)
def test_the_amplitude_is_lals_in_physical_units(model, one, approximant, band, tolerance):
    """Mass, distance and inclination: TaylorF2's amplitude is the leading order alone."""
    f = np.geomspace(*band, 300)
    for ours, theirs in zip(model.predict(f, one), strain_of_lal(f, one, approximant), strict=True):
        np.testing.assert_allclose(np.abs(ours), np.abs(theirs), rtol=tolerance)


@binaries
def test_the_polarizations_are_related_as_lals(model, one):
    f = np.geomspace(8.0, 1000.0, 300)
    plus, cross = model.predict(f, one)
    their_plus, their_cross = strain_of_lal(f, one, "TaylorF2")
    np.testing.assert_allclose(cross / plus, their_cross / their_plus, rtol=1e-12, atol=1e-14)
    cosine = np.cos(one.inclination)
    np.testing.assert_allclose(cross / plus, -2j * cosine / (1.0 + cosine**2), rtol=1e-12, atol=1e-14)


def test_an_orbital_phase_of_lal_is_half_a_reference_phase(model):
    f, one = np.geomspace(20.0, 100.0, 50), BINARIES["like GW170817"]
    theirs = strain_of_lal(f, one, "TaylorF2", orbital_phase=0.3)[0] / strain_of_lal(f, one, "TaylorF2")[0]
    ours = model.predict(f, replace(one, reference_phase=0.6)).plus / model.predict(f, one).plus
    np.testing.assert_allclose(ours, theirs, rtol=1e-9)
    np.testing.assert_allclose(ours, np.exp(0.6j), rtol=1e-9)


def test_distance_time_shift_and_phase_do_what_the_documentation_says(model):
    f, one = np.geomspace(6.0, 2000.0, 200), BINARIES["unequal, spinning"]
    shifted = replace(one, distance_mpc=2.0 * one.distance_mpc, time_shift=0.01, reference_phase=-1.0)
    expected = 0.5 * np.exp(1j * (2.0 * np.pi * f * 0.01 - 1.0))
    np.testing.assert_allclose(model.predict(f, shifted).plus / model.predict(f, one).plus, expected, rtol=1e-8)


def peak_time(model, one, **options):
    """Seconds at which the strain is largest, from its inverse Fourier transform."""
    grid = UniformGrid(16.0, 2048.0, 1.0 / 16.0)
    spectrum = np.zeros(2 * 2048 * 16, complex)
    spectrum[16 * 16 : 16 * 16 + len(grid)] = model.predict(grid, one, options=EvaluationOptions(**options)).plus
    peak = np.argmax(np.abs(np.fft.ifft(spectrum)))
    return (peak / len(spectrum) + 0.5) % 1.0 * 16.0 - 8.0


def test_the_merger_is_at_the_origin_of_time_if_asked_for(model):
    one = BINARIES["unequal, spinning"]
    assert abs(peak_time(model, one, alignment="merger")) < 5e-4
    earlier = replace(one, time_shift=0.25)
    assert peak_time(model, earlier, alignment="merger") == pytest.approx(-0.25, abs=5e-4)
    assert abs(peak_time(model, one, alignment="post_newtonian")) > 1e-3


@binaries
def test_aligned_at_the_merger_it_is_the_conjugate_of_teobresums(model, one):
    """The phase of TEOBResumS starts from zero at the first frequency, so it is asked for the model's first as well."""
    first = model.description.training_band[0] * model.description.reference_mass / one.total_mass
    f = np.concatenate([[first], np.geomspace(20.0, 2000.0, 400)])
    both = zip(model.predict(f, one, options=MERGER), strain_of_teobresums(f, one), strict=True)
    for ours, theirs in both:
        assert np.linalg.norm(ours - theirs) < 2e-3 * np.linalg.norm(theirs)
        np.testing.assert_allclose(np.abs(ours), np.abs(theirs), rtol=0.01)  # jitter of its interpolation above 1 kHz
        phase = np.angle(ours / theirs)  # no more than the model's error of the merger time
        np.testing.assert_allclose(phase, 0.0, atol=1e-3 + 2.0 * np.pi * 2000.0 * 1e-5)
        assert left_after_a_line(f, phase) < 0.01


def test_the_time_until_merger_is_that_of_teobresums(model):
    """From the slope of its phase at 50 Hz, where the baseline knows nothing of it."""
    one = BINARIES["like GW170817"]
    first = model.description.training_band[0] * model.description.reference_mass / one.total_mass
    f = np.array([first, 49.99, 50.01])
    phase = np.angle(strain_of_teobresums(f, one)[0])
    step = np.angle(np.exp(1j * (phase[2] - phase[1])))
    turns = np.round((model.time_until_merger(50.0, one) * 0.02) - step / (2.0 * np.pi))
    seconds = (step / (2.0 * np.pi) + turns) / 0.02
    assert model.time_until_merger(50.0, one) == pytest.approx(seconds, abs=1e-3)


def slope_from_one_side(model, frequency, one, side):
    """Time to the merger in seconds, from a polynomial through the phase on one side of a frequency."""
    f = frequency * (1.0 + 2e-3 * side * (1.0 - np.cos(np.linspace(0.0, np.pi, 65))))
    phase = model.predict_amplitude_phase(np.sort(f), one, options=MERGER).phase
    line = np.polynomial.Chebyshev.fit(np.sort(f), phase, 5)
    return line.deriv()(frequency) / (2.0 * np.pi)


SPREAD = {
    **BINARIES,
    "soft": replace(BINARIES["like GW170817"], lambda_1=4800.0, lambda_2=5000.0),
    "stiff": replace(BINARIES["unequal, spinning"], lambda_1=10.0, lambda_2=5.0, chi_1=-0.5),
}


@pytest.mark.parametrize("one", SPREAD.values(), ids=list(SPREAD))
@pytest.mark.parametrize("name", ["default", "fast", "paper", "wide"])
def test_the_time_until_merger_is_the_slope_of_the_phase_up_to_the_edges_of_the_band(name, one):
    shipped = OneMode(Model.load(name))
    low, top = (edge * shipped.description.reference_mass for edge in shipped.description.training_band)
    for mass in (2.0, 2.7, 3.3, 4.0):
        binary = replace(one, total_mass=mass)
        for fraction in (0.9, 0.997, 0.998, 0.9985, 0.9995, 1.0):
            f = fraction * top / mass
            from_below = slope_from_one_side(shipped, f, binary, -1.0)
            assert shipped.time_until_merger(f, binary) == pytest.approx(from_below, rel=1e-3, abs=1e-8)
        for fraction in (0.5, 0.998, 0.9995, 1.0, 1.0005, 1.002, 1.1):
            f = fraction * low / mass
            for side in (-1.0, 1.0):  # where the surrogate joins the baseline, the phase and its slope are continuous
                expected = slope_from_one_side(shipped, f, binary, side)
                assert shipped.time_until_merger(f, binary) == pytest.approx(expected, rel=1e-8)


@binaries
@pytest.mark.parametrize("alignment", ["merger", "post_newtonian"])
def test_above_the_band_the_phase_is_a_line_whatever_the_grid(model, one, alignment):
    """With value and slope of the top; what stands at a frequency does not depend on the others, nor on other rows."""
    options = EvaluationOptions(alignment=alignment)
    shifted = replace(one, time_shift=0.2, reference_phase=1.5, total_mass=3.7)
    top = model.description.training_band[1] * model.description.reference_mass / 3.7
    f = np.concatenate([top * (1.0 + 1e-6 * np.arange(-20.0, 1.0)), np.geomspace(1.0001 * top, 2.0 * top, 50)])
    amplitude, phase = model.predict_amplitude_phase(f, shifted, options=options)
    np.testing.assert_array_equal(amplitude > 0.0, f <= top)
    slope = np.polynomial.Polynomial.fit(f[:21], phase[:21], 1).deriv()(top)
    np.testing.assert_allclose(phase[21:], phase[20] + slope * (f[21:] - top), atol=1e-4 + 1e-5 * top)
    np.testing.assert_allclose(np.diff(phase[21:]) / np.diff(f[21:]), slope, rtol=1e-4)
    sparse = model.predict_amplitude_phase(f[::7], shifted, options=options)
    np.testing.assert_array_equal(sparse.phase, phase[::7])
    batch = model.predict_amplitude_phase(f, [one, shifted, replace(shifted, total_mass=2.0)], options=options)
    np.testing.assert_array_equal(batch.phase[1], phase)


def test_rows_that_are_flagged_stay_nan_above_the_band(model):
    f = np.array([100.0, 5000.0])
    options = EvaluationOptions(out_of_domain="flag")
    one = BINARIES["like GW170817"]
    answer = model.predict_amplitude_phase(f, [one, replace(one, mass_ratio=0.5)], options=options)
    assert np.isfinite(answer.phase[0]).all()
    assert np.isnan(answer.phase[1]).all()
