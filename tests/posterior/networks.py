"""A small event: seconds of two detectors, with five parameters to sample."""

import copy
import tomllib

from bnserve_posterior.events import parse_event

TRIGGER = 1187008882.43
TOML = """
[data]
trigger_time = 1187008882.43
duration = 8.0
f_min = 64.0
f_max = 512.0

[data.injection]
snr = 15.0
seed = 3

[data.injection.parameters]
chirp_mass = 1.2
mass_ratio = 0.8
chi_1 = 0.0
chi_2 = 0.0
lambda_1 = 300.0
lambda_2 = 500.0
theta_jn = 0.6
ra = 1.0
dec = 0.4
psi = 0.7
reference_phase = 1.0

[detectors]
H1.asd = "aLIGO_O4_high_asd.txt"
L1.asd = "aLIGO_O4_high_asd.txt"

[likelihood]
modes = [[2, 2]]

[prior]
chirp_mass = [1.19, 1.21]
mass_ratio = [0.6, 1.0]
chi_1 = 0.0
chi_2 = 0.0
lambda_1 = 300.0
lambda_2 = 500.0
ra = 1.0
dec = 0.4
luminosity_distance = "PowerLaw(alpha=2, minimum=10, maximum=500)"
geocent_time = [1187008882.42, 1187008882.44]

[sampler]
effective = 500
particles = 500

[output]
folder = "run"
checks = 50
"""
SMALL = tomllib.loads(TOML)


def with_values(table=SMALL, **changes):
    """A copy with other values, by path: ``data__f_min``; None takes one away."""
    table = copy.deepcopy(table)
    for path, value in changes.items():
        *sections, key = path.split("__")
        place = table
        for section in sections:
            place = place.setdefault(section, {})
        if value is None:
            place.pop(key, None)
        else:
            place[key] = value
    return table


def event(**changes):
    return parse_event(with_values(**changes))
