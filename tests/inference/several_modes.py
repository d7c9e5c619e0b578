"""A model of seven modes, and its likelihood worked out in the plainest way: with nothing of the product but the modes
of the model and the numbers of an analysis."""

import itertools
import math

import numpy as np

from bnserve_protocol import EvaluationOptions
from bnserve_surrogate import Model
from tests.inference.networks import DURATION, START, TRIGGER

LIGHT = 299792458.0


def seven_modes():
    """The shipped default model."""
    return Model.default()


def harmonic(degree, order, inclination):
    """Of spin weight -2 at azimuth zero: Goldberg et al., J. Math. Phys. 8, 2155 (1967), eq. 3.1."""
    total = 0.0
    half = 0.5 * inclination
    for r in range(max(0, order - 2), min(degree + order, degree - 2) + 1):
        sign = (-1) ** r
        ways = math.sqrt(
            math.factorial(degree + order)
            * math.factorial(degree - order)
            * math.factorial(degree + 2)
            * math.factorial(degree - 2)
        )
        ways /= (
            math.factorial(degree + order - r)
            * math.factorial(degree - 2 - r)
            * math.factorial(r)
            * math.factorial(r + 2 - order)
        )
        total += (
            sign * ways * math.cos(half) ** (2 * degree + order - 2 - 2 * r) * math.sin(half) ** (2 * r + 2 - order)
        )
    return math.sqrt((2 * degree + 1) / (4.0 * math.pi)) * total


def in_polarisations(mode, inclination):
    """What a mode and its mirror image make of plus and cross, relative to (2, 2) face on."""
    degree, order = mode
    one, other = harmonic(degree, order, inclination), (-1) ** degree * harmonic(degree, -order, inclination)
    norm = math.sqrt(5.0 / (4.0 * math.pi))
    return (one + other) / norm, -1j * (one - other) / norm


def rotation(axis, angle):
    """About an axis of the frame, active."""
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = math.cos(angle)
    matrix[i, j], matrix[j, i] = -math.sin(angle), math.sin(angle)
    return matrix


def towards(right_ascension, declination, polarization, sidereal):
    """Unit vectors in the Earth's frame: of the wave's plus axes, and from which it comes."""
    turned = rotation(2, right_ascension - sidereal) @ rotation(1, 0.5 * math.pi - declination)
    south, east, source = turned.T
    x = -math.cos(polarization) * east - math.sin(polarization) * south
    y = -math.cos(polarization) * south + math.sin(polarization) * east
    return x, y, source


def plain_log_likelihood(model, data, analysis, sample, modes, reference_phases=None):
    """ln L of one sample by a sum over frequencies, at its own or other reference phases."""
    settings = analysis.settings
    count = round((settings.f_max - settings.f_min) * DURATION) + 1
    f = settings.f_min + np.arange(count) / DURATION
    phases = [sample["reference_phase"]] if reference_phases is None else reference_phases
    names = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination", "total_mass")
    binary = {name: sample[name] for name in names}
    options = EvaluationOptions(alignment=settings.alignment, modes=modes)
    h = model.predict_modes(f, binary, options=options).h[0]
    factors = [in_polarisations(mode, sample["inclination"]) for mode in modes]
    time = sample["coalescence_time"]
    sidereal = settings.sidereal_time + settings.sidereal_rate * time
    place = sample["right_ascension"], sample["declination"], sample["polarization_angle"], sidereal
    x, y, source = towards(*place)
    found = np.zeros(len(phases))
    for detector in data:
        response = analysis.arrays[f"response/{detector.name}"]
        f_plus, f_cross = x @ response @ x - y @ response @ y, x @ response @ y + y @ response @ x
        arrival = TRIGGER - START + time - source @ analysis.arrays[f"location/{detector.name}"] / LIGHT
        delayed = np.exp(-2j * np.pi * f * arrival)
        band = slice(round(settings.f_min * DURATION), round(settings.f_max * DURATION) + 1)
        strain, weight = detector.strain[band], 4.0 / DURATION / detector.asd[band] ** 2
        signals = [(f_plus * plus + f_cross * cross) * h[k] * delayed for k, (plus, cross) in enumerate(factors)]
        with_data = [np.sum(weight * strain.conj() * signal) for signal in signals]
        among = {
            (one, other): np.sum(weight * signals[one].conj() * signals[other])
            for one, other in itertools.product(range(len(modes)), repeat=2)
        }
        for place_of, phase in enumerate(phases):
            turns = np.exp(0.5j * np.array([order for _, order in modes]) * phase)
            found[place_of] += sum((turn * z).real for turn, z in zip(turns, with_data, strict=True))
            found[place_of] -= 0.5 * sum(
                (turns[one].conj() * turns[other] * value).real for (one, other), value in among.items()
            )
    return found
