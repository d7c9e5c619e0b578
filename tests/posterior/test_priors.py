"""Priors as bilby writes them: read without running anything, over the unit cube, in coordinates that suit a binary."""

import math

import bilby
import numpy as np
import pytest
from scipy.special import ndtr

from bnserve_inference import Detector, DetectorData, antenna_pattern, sidereal_time, time_delay
from bnserve_posterior.events import EventInvalid
from bnserve_posterior.priors import (
    PriorCube,
    coordinates_of,
    derived_parameters,
    parse_prior,
    priors_of,
    read_prior_file,
    seconds_before,
    twins_of,
)
from bnserve_protocol import SOLAR_MASS_SECONDS

TRIGGER = 1187008882.43
GIVEN = {
    "chirp_mass": "bilby.gw.prior.UniformInComponentsChirpMass(name='chirp_mass', minimum=1.1, maximum=1.3)",
    "mass_ratio": "UniformInComponentsMassRatio(minimum=0.5, maximum=1)",
    "chi_1": "AlignedSpin(name='chi_1', a_prior=Uniform(minimum=0, maximum=0.4))",
    "chi_2": "AlignedSpin(a_prior=Uniform(minimum=0, maximum=0.4))",
    "lambda_1": (5.0, 5000.0),
    "lambda_2": (5.0, 5000.0),
    "luminosity_distance": "PowerLaw(alpha=2, minimum=1, maximum=75)",
}


def cube_of(integrated=("phase", "luminosity_distance"), quadrupole=True, **changes):
    priors, _ = priors_of({**GIVEN, **changes}, TRIGGER)
    return PriorCube(priors, TRIGGER, integrated, quadrupole)


def points(cube, count=500, seed=1):
    return np.random.default_rng(seed).random((count, len(cube)))


@pytest.mark.parametrize(
    "text",
    [
        "Uniform(minimum=0, maximum=2 * np.pi, boundary='periodic')",
        "Cosine(name='x')",
        "PowerLaw(alpha=-2.5, minimum=10, maximum=100 / 2 + 3)",
        r"Uniform(minimum=1, maximum=2, unit='$M_{\odot}$', latex_label=None)",
        "bilby.gw.prior.UniformSourceFrame(minimum=10, maximum=100, cosmology='Planck15', name='luminosity_distance')",
        "bilby.core.prior.Interped(xx=[0, 1, 2], yy=[1.0, 2.0, 1.0], minimum=0, maximum=2)",
        "Constraint(minimum=1, maximum=2)",
    ],
)
def test_a_prior_is_what_bilby_makes_of_the_same_words(text):
    name = "luminosity_distance" if "SourceFrame" in text else "x"
    ours = parse_prior(name, text)
    bilbys = bilby.core.prior.PriorDict({name: text})[name]
    bilbys.name = ours.name
    assert repr(ours) == repr(bilbys)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("Uniform(minimum=__import__('os').getpid(), maximum=1)", "bilby has no prior"),
        ("Uniform(minimum=(lambda: 0)(), maximum=1)", "bilby has no prior"),
        ("os.system('true')", "must have names"),
        ("bilby.core.utils.run_commandline(cl='true')", "bilby has no prior"),
        ("Uniform(minimum=open, maximum=1)", "nothing called open"),
        ("[x for x in (1,)]", "neither a number nor a prior"),
        ("Uniform(0, 1)", "must have names"),
        ("Uniforn(minimum=0, maximum=1)", r"did you mean Uniform\?"),
        ("Uniform(minimum=0, maximum=1, colour=3)", "colour"),
        ("Uniform(minimum=2 ** 99999999, maximum=1)", "neither a number nor a prior"),
        ("'text'", "must be a prior of bilby or a number"),
        ("(" * 1000, "none that bilby writes"),
    ],
)
def test_what_is_no_prior_is_refused_and_nothing_runs(text, sentence):
    with pytest.raises(EventInvalid, match=sentence):
        parse_prior("x", text)


@pytest.mark.filterwarnings("ignore:invalid escape sequence")  # of bilby, in a unit
@pytest.mark.parametrize("name", ["aligned_spins_bns_tides_on.prior", "GW170817.prior"])
def test_the_files_that_come_with_bilby_are_read_as_bilby_reads_them(name):
    file = f"{bilby.gw.__path__[0]}/prior_files/{name}"
    ours = read_prior_file(file)
    bilbys = bilby.gw.prior.BNSPriorDict(filename=file)
    assert {key: repr(value) for key, value in ours.items()} == {key: repr(value) for key, value in bilbys.items()}


def test_what_goes_without_saying_is_said():
    priors, remarks = priors_of(GIVEN, TRIGGER)
    assert [line.split()[3] for line in remarks] == ["ra", "dec", "theta_jn", "psi", "phase", "geocent_time"]
    assert (priors["geocent_time"].minimum, priors["geocent_time"].maximum) == (TRIGGER - 0.1, TRIGGER + 0.1)


def test_columns_are_as_probable_as_bilby_says():
    cube = cube_of(integrated=("phase",), quadrupole=False)
    values = cube(points(cube, 20_000))
    for name in cube.names:
        samples = cube.priors[name].sample(20_000) if name != "coalescence_time" else None
        if samples is not None:
            assert np.quantile(values[name], [0.1, 0.5, 0.9]) == pytest.approx(
                np.quantile(samples, [0.1, 0.5, 0.9]), abs=0.03 * np.ptp(samples)
            )
    assert values["coalescence_time"].min() > -0.1
    assert values["coalescence_time"].max() < 0.1


def test_times_are_known_to_less_than_a_nanosecond():
    """GPS seconds as a number are known to 240 of them."""
    cube = cube_of()
    u = np.full((1, len(cube)), 0.5)
    nearby = u.copy()
    nearby[0, cube.names.index("coalescence_time")] += 1e-9
    assert cube(nearby)["coalescence_time"][0] - cube(u)["coalescence_time"][0] == pytest.approx(2e-10, rel=1e-6)


def test_constraints_leave_a_part_of_the_cube():
    cube = cube_of(mass_1="Constraint(minimum=1.3, maximum=1.6)")
    u = points(cube, 20_000)
    values = cube(u)
    allowed = cube.allowed(values)
    heavier = derived_parameters(values)["mass_1"]
    assert (allowed == ((heavier >= 1.3) & (heavier <= 1.6))).all()
    assert math.exp(cube.log_allowed()) == pytest.approx(allowed.mean(), abs=0.02)
    assert cube_of().log_allowed() == 0.0
    with pytest.raises(EventInvalid, match="none meets the constraints"):
        cube_of(mass_1="Constraint(minimum=3, maximum=4)").log_allowed()
    with pytest.raises(EventInvalid, match="no 'mass_3' to be constrained"):
        cube_of(mass_3="Constraint(minimum=3, maximum=4)").allowed(values)


def test_half_of_the_polarisation_angle_is_sampled_where_the_other_half_is_the_same_and_given_back():
    cube = cube_of()
    values = cube(points(cube, 4000))
    assert values["psi"].max() < 0.5 * math.pi
    whole = cube.unfolded(values, np.random.default_rng(1))["psi"]
    assert np.mean(whole > 0.5 * math.pi) == pytest.approx(0.5, abs=0.03)
    assert np.allclose(np.mod(whole, 0.5 * math.pi), values["psi"])
    assert cube_of(quadrupole=False)(points(cube))["psi"].max() > 0.5 * math.pi


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"geocent_time": "Gaussian(mu=0, sigma=1)"}, "must be uniform"),
        ({"chi_1": "Gaussian(mu=0, sigma=1)"}, "has no ends"),
        ({"lambda_1": (5.0, 1.0)}, "two increasing numbers"),
        ({"lambda_1": (5.0, math.inf)}, "two increasing numbers"),
        ({"dec": -23.4}, "from -23.4 to -23.4; it is an angle in radians, from -1.571 to 1.571"),
        ({"dec": (-1.6, 1.0)}, "isotropic as Cosine"),
        ({"theta_jn": (0.0, 180.0)}, "in radians, from 0 to 3.142, and isotropic as Sine"),
    ],
)
def test_priors_that_no_cube_has_are_refused(changes, sentence):
    with pytest.raises(EventInvalid, match=sentence):
        cube_of(**changes)


NETWORK = [Detector.named(name) for name in ("H1", "L1", "V1")]
TRIANGLE = [Detector.named(name) for name in ("ETS1", "ETS2", "ETS3")]
POLE = [Detector.at("P1", latitude=-0.5 * math.pi, longitude=0.0, x_azimuth=0.0, y_azimuth=1.0)]
CENTRE = [Detector("C1", TRIANGLE[0].response, np.zeros(3))]


@pytest.mark.parametrize(
    ("changes", "network"),
    [
        ({}, NETWORK),
        ({"chi_1": 0.01}, NETWORK),
        ({"chi_2": 0.0, "lambda_1": 300.0}, NETWORK),
        ({"ra": 3.4, "dec": -0.4}, NETWORK),
        ({"geocent_time": TRIGGER}, NETWORK),
        ({"mass_ratio": (1.0, 3.0)}, NETWORK),
        ({"chirp_mass": (0.9, 2.0)}, NETWORK),
        ({}, TRIANGLE),
        ({}, POLE),
        ({}, CENTRE),
    ],
)
def test_coordinates_lead_back_and_their_volume_is_that_of_the_map(changes, network):
    cube = cube_of(**changes)
    coordinates = coordinates_of(cube, network)
    u = 0.02 + 0.96 * points(cube, 40)
    y, volume = coordinates.from_cube(u)
    back, same = coordinates.to_cube(y)
    np.testing.assert_allclose(back, u, atol=1e-9)
    np.testing.assert_allclose(same, volume, atol=1e-6)
    for row in range(3):
        steps = 1e-6 * np.maximum(np.abs(y[row]), 0.1)
        above, below = (coordinates.to_cube(y[row] + sign * np.diag(steps))[0] for sign in (1.0, -1.0))
        jacobian = (above - below) / (2.0 * steps[:, None])
        # phases are measured to 1e-7 of themselves by such steps
        assert np.linalg.slogdet(jacobian)[1] == pytest.approx(volume[row], abs=2e-3)


def test_of_detectors_at_one_place_the_time_is_that_of_arrival_and_the_sky_begins_at_their_vertical():
    cube = cube_of()
    u = points(cube, 40)
    values, found = cube(u), coordinates_of(cube, TRIANGLE).from_cube(u)[0]
    turned = sidereal_time(TRIGGER)[0]
    delays = [time_delay(TRIANGLE[0], ra, dec, turned) for ra, dec in zip(values["ra"], values["dec"], strict=True)]
    arrival = found[:, cube.names.index("coalescence_time")]
    assert np.argsort(arrival).tolist() == np.argsort(values["coalescence_time"] + delays).tolist()
    # What is high in the sky arrives early.
    assert np.argsort(found[:, cube.names.index("dec")]).tolist() == np.argsort(delays)[::-1].tolist()


def test_places_of_no_binary_are_outside_of_the_cube():
    cube = cube_of()
    coordinates = coordinates_of(cube, NETWORK)
    y = np.random.default_rng(1).standard_normal((1000, len(cube)))
    u = coordinates.to_cube(1e3 * y)[0]
    assert np.isfinite(u).all()
    assert ((u < 0.0).any(axis=1) | (u > 0.0).all(axis=1)).all()


TRIANGLE = [Detector.named(name) for name in ("E1", "E2", "E3")]


def seen(detector, values, row):
    """Both polarisations of a (2, 2) mode in a detector, and when its signal arrives."""
    sidereal = sidereal_time(TRIGGER)[0]
    place = values["ra"][row], values["dec"][row]
    plus, cross = antenna_pattern(detector, *place, values["psi"][row], sidereal)
    cosine = np.cos(values["theta_jn"][row])
    arrival = values["coalescence_time"][row] + time_delay(detector, *place, sidereal)
    return np.array([0.5 * plus * (1.0 + cosine**2), cross * cosine]), arrival


@pytest.mark.parametrize("quadrupole", [False, True], ids=["all modes", "(2, 2), whose sign is a phase"])
def test_detectors_at_one_place_hear_twins_alike(quadrupole):
    cube = cube_of(quadrupole=quadrupole)
    random, u = np.random.default_rng(7), points(cube, 200)
    there = twins_of(cube, TRIANGLE)(u, random)
    some = np.flatnonzero(((there > 0.0) & (there < 1.0)).all(axis=1))  # others arrive outside of the prior
    assert len(some) > 100
    one, other = cube(u[some]), cube(there[some])
    assert np.min(sum(np.abs(one[name] - other[name]) for name in ("ra", "dec", "psi"))) > 1e-3
    found = set()
    for row in range(len(some)):
        signs = []
        for detector in TRIANGLE:
            (h, arrival), (again, later) = seen(detector, one, row), seen(detector, other, row)
            assert abs(arrival - later) < 1e-4
            signs.append(np.sign(h @ again))
            np.testing.assert_allclose(again, signs[0] * h, atol=0.02)
        found.add(signs[0])
    assert found == {-1.0, 1.0}


def test_twins_keep_volumes_and_lead_back():
    cube = cube_of(geocent_time=TRIGGER)
    random, u = np.random.default_rng(8), points(cube, 20_000)
    hop = twins_of(cube, TRIANGLE)
    there = hop(u, random)
    for column in range(len(cube)):
        held, _ = np.histogram(there[:, column], 20, (0.0, 1.0))
        assert np.abs(held - 1000).max() < 160  # five standard deviations
    back = np.min([np.abs(hop(there, random) - u).max(axis=1) for _ in range(120)], axis=0)
    assert np.quantile(back, 0.99) < 1e-9


def test_twins_hear_the_doppler_effect_of_the_turning_earth_and_lead_back():
    cube, before, step = cube_of(), 750.0, 10.0
    random, u = np.random.default_rng(9), points(cube, 200)
    hop = twins_of(cube, TRIANGLE, before)
    there = hop(u, random)
    some = np.flatnonzero(((there > 0.0) & (there < 1.0)).all(axis=1))
    one, other = cube(u[some]), cube(there[some])
    for row in range(20):
        arrivals = np.zeros((2, 2))
        for place, values in enumerate((one, other)):
            for when, passed in enumerate((-before - step, -before + step)):
                turned = sidereal_time(TRIGGER + passed)[0]
                later = time_delay(TRIANGLE[0], values["ra"][row], values["dec"][row], turned)
                mass = values["chirp_mass"][row] / one["chirp_mass"][row]
                arrivals[place, when] = values["coalescence_time"][row] + mass * passed + later
        np.testing.assert_allclose(arrivals[0], arrivals[1], atol=2e-8)
    back = np.min([np.abs(hop(there, random)[some] - u[some]).max(axis=1) for _ in range(120)], axis=0)
    assert np.quantile(back, 0.9) < 1e-9


@pytest.mark.parametrize("integrated", [("phase", "luminosity_distance"), ("phase",)])
def test_where_the_polarisations_in_a_plane_are_the_same_a_triangle_hears_the_same(integrated):
    cube = cube_of(integrated)
    coordinates, random = coordinates_of(cube, TRIANGLE), np.random.default_rng(10)
    columns = [cube.names.index(name) for name in ("ra", "dec")]
    y = coordinates.from_cube(points(cube, 300))[0]
    moved = y.copy()
    moved[:, columns] = coordinates.from_cube(random.random(y.shape))[0][:, columns]
    there = coordinates.to_cube(moved)[0]
    high = np.abs(2.0 * ndtr(np.stack([y, moved])[:, :, columns[1]]) - 1.0).min(axis=0) > 0.16
    some = np.flatnonzero(high & ((there > 0.0) & (there < 1.0)).all(axis=1))
    assert len(some) > 50
    one, other = cube(coordinates.to_cube(y[some])[0]), cube(there[some])

    def strains(values, row):
        parts = [seen(detector, values, row)[0] for detector in TRIANGLE]
        distance = values["luminosity_distance"][row] if len(integrated) == 1 else 1.0
        return np.array([plus - 1j * cross for plus, cross in parts]) / distance

    for row in range(len(some)):
        here, now = strains(one, row), strains(other, row)
        gain = np.vdot(here, now) / np.vdot(here, here)
        np.testing.assert_allclose(now, gain * here, atol=0.03 * np.abs(now).max())
        assert len(integrated) == 2 or abs(abs(gain) - 1.0) < 0.02


def test_detectors_that_all_hear_the_same_polarisation_have_no_other_coordinates():
    cube = cube_of()
    psi = cube.names.index("psi")
    u = points(cube, 20)
    assert np.ptp(coordinates_of(cube, TRIANGLE[:1]).from_cube(u)[0][:, psi] - u[:, psi]) == 0.0
    assert np.ptp(coordinates_of(cube, TRIANGLE[:2]).from_cube(u)[0][:, psi] - u[:, psi]) > 0.1


def test_signals_come_from_minutes_before_their_coalescence_the_more_the_lower_the_band_begins():
    f = np.arange(0.0, 1024.0 + 0.25, 0.25)
    data = [DetectorData("E1", np.zeros(len(f), complex), np.full(len(f), 1e-24), 0.0, 4.0)]
    before = [seconds_before(data, f_min, 1024.0, 1.3) for f_min in (5.0, 10.0, 20.0)]
    assert before[0] > before[1] > before[2] > 0.0
    flat = lambda power: (1024.0 ** (power + 1) - 20.0 ** (power + 1)) / (power + 1)  # noqa: E731  (of one line)
    newton = 5.0 / 256.0 * np.pi ** (-8 / 3) * (1.3 * SOLAR_MASS_SECONDS) ** (-5 / 3)
    assert before[2] == pytest.approx(newton * flat(-5.0) / flat(-7.0 / 3.0), rel=0.02)


def test_detectors_at_two_places_or_a_prior_of_a_part_of_the_sky_have_no_twins():
    assert twins_of(cube_of(), [Detector.named("H1"), Detector.named("L1")]) is None
    assert twins_of(cube_of(), [*TRIANGLE, Detector.named("CE40")]) is None
    assert twins_of(cube_of(ra=1.0), TRIANGLE) is None
    assert twins_of(cube_of(theta_jn=(0.0, 1.0)), TRIANGLE) is None
    assert twins_of(cube_of(), TRIANGLE[:1]) is not None
