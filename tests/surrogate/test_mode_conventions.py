"""Signs and phases of all modes against LALSimulation, post-Newtonian modes and TEOBResumS in the time domain."""

import cmath
from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import SOLAR_MASS_SECONDS, EvaluationOptions, ParametersWithExtrinsic, turn_to_reference
from bnserve_surrogate import Model
from tests.surrogate.other_codes import MODES, harmonics, modes_of_teobresums, polarisations, strain_of_lal

lal = pytest.importorskip("lal")
simulation = pytest.importorskip("lalsimulation")

ONE = ParametersWithExtrinsic(
    mass_ratio=1.7, lambda_1=5.0, lambda_2=5.0, chi_1=0.2, chi_2=-0.1,
    distance_mpc=100.0, inclination=1.1, total_mass=2.8,
)  # fmt: skip
IN_LAL = [(2, 2), (2, 1), (3, 3), (4, 4), (3, 2)]
"""Of IMRPhenomXHM."""
DIRECTIONS = [(0.4, 0.3), (1.1, -2.0), (np.pi / 2.0, 1.0), (2.0, 2.5), (2.9, 4.0)]
"""Inclinations, also beyond the plane of the orbit, and phases of the orbit."""


def mass_of(one):
    return one.total_mass * SOLAR_MASS_SECONDS


def turned(modes, by, f, time):
    """Modes ``{mode: (amplitude, phase)}`` as complex numbers, of an orbit turned by an angle, earlier."""
    return {
        mode: amplitude * np.exp(1j * (phase + mode[1] * by + 2.0 * np.pi * f * time))
        for mode, (amplitude, phase) in modes.items()
    }


def mismatch(ours, theirs):
    """Of both polarisations together, signs included, nothing maximised."""
    product = sum(np.vdot(a, b).real for a, b in zip(ours, theirs, strict=True))
    norms = [sum(np.vdot(a, a).real for a in pair) for pair in (ours, theirs)]
    return 1.0 - product / np.sqrt(norms[0] * norms[1])


@pytest.mark.parametrize(("inclination", "azimuth"), DIRECTIONS)
def test_the_factors_are_those_of_lals_harmonics_for_any_modes(inclination, azimuth):
    """h_plus - i h_cross: sum of h_lm(t) times its harmonic, h_l,-m = (-1)^l conj(h_lm); in time, then transformed."""
    t = np.arange(4096) / 4096.0
    total, transforms = np.zeros(4096, complex), {}
    for number, (degree, order) in enumerate(MODES):
        envelope = np.exp(-0.5 * ((t - 0.5) / 0.06) ** 2) * (1.0 + 0.3 * number) * cmath.exp(1j * number)
        h = envelope * np.exp(-2j * np.pi * order * (150.0 * t + 40.0 * t**2))
        for m, own in ((order, h), (-order, (-1) ** degree * h.conj())):
            total += own * lal.SpinWeightedSphericalHarmonic(inclination, azimuth, -2, degree, m)
        transforms[degree, order] = 0.5 * np.sqrt(1.25 / np.pi) * np.fft.fft(h.conj())[:2048]
    expected = [np.fft.fft(part)[:2048] for part in (total.real, -total.imag)]
    found = polarisations(transforms, inclination, azimuth)
    scale = max(np.abs(part).max() for part in expected)
    for ours, theirs in zip(found, expected, strict=True):
        np.testing.assert_allclose(ours, theirs, atol=1e-9 * scale)


@pytest.mark.parametrize("inclination", [0.0, 0.4, 1.1, 2.0, np.pi])
def test_at_azimuth_zero_plus_is_real_and_cross_imaginary(inclination):
    for (degree, order), (plus, cross) in harmonics(inclination).items():
        assert plus.imag == cross.real == 0.0
        across = harmonics(inclination, 0.7)[degree, order]
        np.testing.assert_allclose(across, np.array([plus, cross]) * np.exp(-0.7j * order), atol=1e-14)
    cosine = np.cos(inclination)
    plus, cross = harmonics(inclination)[2, 2]
    np.testing.assert_allclose([plus, cross], [0.5 * (1.0 + cosine**2), -1j * cosine], atol=1e-14)


@pytest.mark.parametrize(("inclination", "orbital_phase"), DIRECTIONS)
@pytest.mark.parametrize("reference", [40.0, 75.0])
def test_all_modes_together_are_lals_at_every_orientation_and_orbital_phase(inclination, orbital_phase, reference):
    """The orbital phase at f_ref as LAL has it; only the time is fitted, because a black hole merges elsewhere."""
    f, one = np.arange(40.0, 80.0, 0.005), replace(ONE, inclination=inclination)
    modes = modes_of_teobresums(f, one, IN_LAL)
    theirs = strain_of_lal(f, one, "IMRPhenomXHM", orbital_phase, reference=reference)
    face_on = strain_of_lal(f, replace(one, inclination=0.0), "IMRPhenomXHM", reference=reference)[0]
    time = slope(f, np.unwrap(np.angle(face_on)) - modes[2, 2][1]) / (2.0 * np.pi)
    turn = 2.0 * orbital_phase + turn_to_reference(np.interp(reference, f, modes[2, 2][1]))
    ours = turned(modes, 0.5 * turn - np.pi * reference * time, f, time)  # the phase is fixed whatever the time is
    found = mismatch(polarisations(ours, inclination), theirs)
    assert found < 1e-4
    if 0.4 < inclination < 2.9:
        for mode in ((2, 2), (2, 1), (3, 3), (4, 4)):  # each counts
            spoilt = {other: -h if other == mode else h for other, h in ours.items()}
            assert mismatch(polarisations(spoilt, inclination), theirs) > found + 5e-5
    plus, cross = polarisations(ours, inclination)
    assert abs(np.cos(inclination)) < 1e-9 or mismatch((plus, -cross), theirs) > 0.1


def slope(f, phase):
    """Of the best line, in radians per Hz."""
    return np.polynomial.Polynomial.fit(f, phase, 1).convert().coef[1]


OTHERS = [replace(ONE, chi_1=0.0, chi_2=0.0), replace(ONE, mass_ratio=3.0, chi_1=0.4, chi_2=0.4), ONE]


@pytest.mark.parametrize("one", OTHERS, ids=["no spins", "unequal", "spins"])
@pytest.mark.parametrize(("mode", "tolerance"), [((2, 1), 0.3), ((3, 3), 0.2), ((4, 4), 0.1), ((3, 2), 0.15)])
def test_each_mode_has_the_phase_of_lals_at_low_frequencies(one, mode, tolerance):
    """At one instant, at which (2, 2) passes 20 Hz. IMRPhenomXHM keeps its modes together to 0.3 rad, as PN tells."""
    x, reference = np.array([19.0, 20.0, 21.0]), 20.0
    modes = modes_of_teobresums({(2, 2): x, mode: 0.5 * mode[1] * x}, one)
    turn = turn_to_reference(modes[2, 2][1][1])
    amplitude, phase = (part[1] for part in modes[mode])
    theirs = {own: mode_of_lal(own, one, 0.5 * own[1] * reference, reference) for own in ((2, 2), mode)}
    np.testing.assert_allclose(abs(amplitude) / modes[2, 2][0][1], abs(theirs[mode] / theirs[2, 2]), rtol=0.02)
    ours = amplitude * cmath.exp(1j * (phase + 0.5 * mode[1] * turn))
    assert abs(cmath.phase(ours / theirs[mode])) < tolerance


def mode_of_lal(mode, one, frequency, reference):
    """Of IMRPhenomXHM at azimuth pi / 2, where LAL's observer is at orbital phase zero."""
    degree, order = mode
    masses = one.total_mass * lal.MSUN_SI * np.array([one.mass_ratio, 1.0]) / (1.0 + one.mass_ratio)
    at = lal.CreateREAL8Vector(2)
    at.data = np.array([frequency, 1.01 * frequency])
    options = lal.CreateDict()
    simulation.SimInspiralWaveformParamsInsertPhenomXHMThresholdMband(options, 0.0)
    found = simulation.SimIMRPhenomXHMFrequencySequenceOneMode(
        at, *masses, one.chi_1, one.chi_2, degree, -order, one.distance_mpc * 1e6 * lal.PC_SI, 0.0, reference, options
    )
    unit = 0.5 * np.sqrt(1.25 / np.pi) * (-1) ** degree * (-1j) ** order
    return complex(unit * found.data.data[0])


def post_newtonian(mode, q):
    """The leading term of a mode over that of (2, 2), less exp(-i m phase) and the power of v.

    Blanchet, Faye, Iyer, Sinha, CQG 25, 165003 (2008), eq. (9.4); the phase is that of the heavier star.
    """
    nu, delta = q / (1.0 + q) ** 2, (q - 1.0) / (q + 1.0)
    return {
        (2, 2): 1.0,
        (2, 1): 1j / 3.0 * delta,
        (3, 3): -0.75j * np.sqrt(15.0 / 14.0) * delta,
        (3, 1): 1j * delta / (12.0 * np.sqrt(14.0)),
        (4, 4): -8.0 / 9.0 * np.sqrt(5.0 / 7.0) * (1.0 - 3.0 * nu),
        (3, 2): np.sqrt(5.0 / 7.0) / 3.0 * (1.0 - 3.0 * nu),
        (4, 3): -2.25j / np.sqrt(70.0) * delta * (1.0 - 2.0 * nu),
    }[mode]


POWERS = {(2, 2): 0, (2, 1): 1, (3, 3): 1, (3, 1): 1, (4, 4): 2, (3, 2): 2, (4, 3): 3}


@pytest.mark.parametrize("q", [1.2, 1.7, 3.0])
@pytest.mark.parametrize("mode", MODES, ids=str)
def test_each_mode_is_post_newtonian_at_low_frequencies(mode, q):
    """In the stationary-phase approximation, at one instant at which the orbit has phase zero by LAL's azimuth."""
    one, x = replace(OTHERS[0], mass_ratio=q), np.array([9.9, 10.0, 10.1])
    modes = modes_of_teobresums({(2, 2): x, mode: 0.5 * mode[1] * x}, one)
    turn = turn_to_reference(modes[2, 2][1][1])
    amplitude, phase = (part[1] for part in modes[mode])
    v = (np.pi * mass_of(one) * 10.0) ** (1.0 / 3.0)
    expected = np.conj(post_newtonian(mode, q)) * v ** POWERS[mode] * np.sqrt(2.0 / mode[1])
    expected *= cmath.exp(1j * (0.25 * np.pi - 0.5 * np.pi * mode[1]))
    ours = amplitude / modes[2, 2][0][1] * cmath.exp(1j * (phase + 0.5 * mode[1] * turn))
    assert abs(ours / expected) == pytest.approx(1.0, abs=0.03)  # the next order is v^2 = 0.006 times a few
    assert abs(cmath.phase(ours / expected)) < 3e-3


@pytest.mark.parametrize("mode", MODES[:-1], ids=str)
def test_lals_post_newtonian_modes_are_these(mode):
    """Also (3, 1), which IMRPhenomXHM lacks; LAL's (4, 3) lacks the factor i that all odd m have by symmetry."""
    v, at = 0.05, 0.2
    found = {}
    for own in ((2, 2), mode):
        series = [
            lal.CreateREAL8TimeSeries("", lal.LIGOTimeGPS(0), 0.0, 1.0, lal.DimensionlessUnit, 2) for _ in range(2)
        ]
        series[0].data.data, series[1].data.data = np.full(2, v), np.full(2, at)
        function = getattr(simulation, f"SimInspiralPNMode{own[0]}{own[1]}")
        masses = 2.8 * lal.MSUN_SI * np.array([1.7, 1.0]) / 2.7
        found[own] = function(*series, v, *masses, 1e6 * lal.PC_SI, POWERS[own]).data.data[0]
    ratio = found[mode] / found[2, 2] * cmath.exp(1j * (mode[1] - 2) * at)
    assert ratio == pytest.approx(post_newtonian(mode, 1.7) * v ** POWERS[mode], rel=1e-6)


@pytest.mark.parametrize("name", ["IMRPhenomXHM", "IMRPhenomXPHM", "IMRPhenomHM"])
def test_in_lal_the_orbital_phase_is_the_heavier_stars_in_whatever_order_they_are_given(name):
    """So that whoever puts the stars in order leaves the phase alone."""
    f = np.linspace(30.0, 200.0, 50)
    exchanged = replace(ONE, mass_ratio=1.0 / ONE.mass_ratio, chi_1=ONE.chi_2, chi_2=ONE.chi_1)
    for ours, theirs in zip(strain_of_lal(f, ONE, name, 0.3), strain_of_lal(f, exchanged, name, 0.3), strict=True):
        np.testing.assert_allclose(ours, theirs, rtol=1e-9)
    turned_by_half = strain_of_lal(f, exchanged, name, 0.3 + np.pi)
    assert mismatch(strain_of_lal(f, ONE, name, 0.3), turned_by_half) > 1e-3


TIDAL = replace(ONE, lambda_1=400.0, lambda_2=600.0)
RATE = 8192.0


def transformed(t, parts):
    """Fourier transforms of parts of a signal in time, ``(frequencies, [...])``, switched on within four seconds."""
    points = 2 ** int(np.ceil(np.log2(len(t))) + 1)
    rise = np.clip((t - t[0]) / 4.0, 0.0, 1.0)
    window = 0.5 * (1.0 - np.cos(np.pi * rise))
    return np.fft.fftfreq(points, 1.0 / RATE), [np.fft.fft(part * window, points) / RATE for part in parts]


def in_time(inclination, angle):
    """t, h_plus, h_cross and modes of TEOBResumS in the time domain."""
    teobresums = pytest.importorskip("EOBRun_module")
    from bnserve_surrogate.training.data.generators._teobresums import MODE_NUMBERS

    request = {
        "M": TIDAL.total_mass, "q": TIDAL.mass_ratio, "distance": TIDAL.distance_mpc, "inclination": inclination,
        "chi1": TIDAL.chi_1, "chi2": TIDAL.chi_2, "chi1z": TIDAL.chi_1, "chi2z": TIDAL.chi_2,
        "LambdaAl2": TIDAL.lambda_1, "LambdaBl2": TIDAL.lambda_2, "coalescence_angle": angle,
        "use_geometric_units": "no", "domain": 0, "srate_interp": RATE, "interp_uniform_grid": "yes",
        "initial_frequency": 50.0, "use_mode_lm": sorted(MODE_NUMBERS.values()), "arg_out": "yes", "output_hpc": "no",
        "ode_tmax": 1e12,
    }  # fmt: skip
    t, plus, cross, found, _ = teobresums.EOBRunPy(request)
    modes = {mode: found[str(number)] for mode, number in MODE_NUMBERS.items()}
    return np.asarray(t), plus, cross, {mode: a * np.exp(-1j * np.asarray(b)) for mode, (a, b) in modes.items()}


@pytest.mark.parametrize(("inclination", "angle"), DIRECTIONS)
def test_in_the_time_domain_they_are_teobresums_with_lals_plus(inclination, angle):
    """One time and one orbital phase for all modes, taken from (2, 2); its plus and cross are minus LAL's."""
    t, plus, cross, theirs = in_time(inclination, angle)
    f, (plus, cross, *theirs) = transformed(t, [plus, cross, *(theirs[mode].conj() for mode in MODES)])
    inside = (f > 160.0) & (f < 1000.0)
    f = f[inside]
    modes = modes_of_teobresums(f, TIDAL)
    reference = -theirs[0][inside]
    difference = np.unwrap(np.angle(reference) - modes[2, 2][1])
    time = slope(f, difference) / (2.0 * np.pi)
    orbit = 0.5 * np.angle(np.mean(reference * np.exp(-1j * (modes[2, 2][1] + 2.0 * np.pi * f * time))))
    candidates = [turned(modes, orbit + half, f, time) for half in (0.0, np.pi)]
    ours = min(candidates, key=lambda found: mismatch([found[3, 3]], [-theirs[MODES.index((3, 3))][inside]]))
    for mode, own in zip(MODES, theirs, strict=True):
        assert mismatch([ours[mode]], [-own[inside]]) < 0.02, mode
    found = [-part for part in polarisations(ours, inclination, 0.5 * np.pi - angle)]
    assert mismatch(found, [plus[inside], cross[inside]]) < 1e-3
    np.testing.assert_allclose(np.linalg.norm(found), np.linalg.norm([plus[inside], cross[inside]]), rtol=5e-3)


def test_the_merger_of_the_model_with_modes_is_that_of_the_model_without():
    """Though its signals begin at half the frequency: time and phase of (2, 2) are those of 1.0.0, to both errors."""
    draw = np.random.default_rng(3)
    rows, chi, tides = 200, (-0.5, 0.5), (5.0, 5000.0)
    batch = {
        "mass_ratio": draw.uniform(1.0, 3.0, rows), "chi_1": draw.uniform(*chi, rows),
        "chi_2": draw.uniform(*chi, rows), "lambda_1": draw.uniform(*tides, rows),
        "lambda_2": draw.uniform(*tides, rows), "distance_mpc": 40.0, "inclination": 0.0, "total_mass": 2.8,
    }  # fmt: skip
    f = np.geomspace(3.6, 400.0, 100)
    options = EvaluationOptions(alignment="merger", modes=((2, 2),))
    new, old = (
        Model.load("default", version).predict_amplitude_phase(f, batch, options=options).phase
        for version in ("2.0.0", "1.0.0")
    )
    assert np.abs(new - old)[:, 0].max() < 1e-3  # of some 1e6 radians
    times = [slope(f, row) / (2.0 * np.pi) for row in new - old]
    assert np.abs(times).max() < 1.5e-5
    assert np.median(np.abs(times)) < 2e-6


@pytest.mark.parametrize(("inclination", "orbital_phase"), DIRECTIONS)
@pytest.mark.parametrize("alignment", ["merger", "post_newtonian"])
def test_a_model_at_a_reference_frequency_is_lals(inclination, orbital_phase, alignment):
    """``reference_phase`` is twice ``phiRef``, also beyond 2 pi; only the time is fitted, as above."""
    model, reference = Model.load("default", "2.0.0"), 60.0
    f = np.arange(40.0, 80.0, 0.005)
    one = replace(ONE, inclination=inclination, reference_phase=2.0 * orbital_phase)
    options = EvaluationOptions(alignment=alignment, modes=IN_LAL, reference_frequency=reference)
    found = model.predict_modes(f, one, options=options)
    theirs = strain_of_lal(f, one, "IMRPhenomXHM", orbital_phase, reference=reference)
    face_on = strain_of_lal(f, replace(one, inclination=0.0), "IMRPhenomXHM", orbital_phase, reference=reference)[0]
    time = slope(f, np.unwrap(np.angle(face_on / found.h[0, 0]))) / (2.0 * np.pi)
    orders = np.array([order for _, order in found.modes])
    moved = found.h[0] * np.exp(2j * np.pi * time * (f - 0.5 * reference * orders[:, None]))
    assert mismatch((found.plus[0] @ moved, found.cross[0] @ moved), theirs) < 1e-4
    for (degree, order), plus, cross in zip(found.modes, found.plus[0], found.cross[0], strict=True):
        np.testing.assert_allclose([plus, cross], harmonics(inclination)[degree, order], atol=1e-14)
    summed = model.predict(f, one, options=options)
    for part, counts in ((summed.plus, found.plus[0]), (summed.cross, found.cross[0])):
        np.testing.assert_allclose(part, counts @ found.h[0], atol=1e-12 * np.abs(part).max())


def test_a_reference_phase_has_a_period_of_four_pi():
    model, f = Model.load("default", "2.0.0"), np.geomspace(20.0, 1000.0, 50)
    odd = [mode for mode in MODES if mode[1] % 2]
    for modes, sign in ((odd, -1.0), ([(2, 2), (4, 4), (3, 2)], 1.0)):
        options = EvaluationOptions(modes=modes, reference_frequency=50.0)
        h = [
            model.predict(f, replace(ONE, reference_phase=turn), options=options).plus
            for turn in (0.3, 0.3 + 2.0 * np.pi)
        ]
        np.testing.assert_allclose(h[1], sign * h[0], rtol=1e-9)
