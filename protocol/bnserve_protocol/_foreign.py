"""Names that other programs have for what a binary is, and what to give in their place."""

from __future__ import annotations

from collections.abc import Collection

SAME = {
    "luminosity_distance": "distance_mpc",
    "theta_jn": "inclination",
    "iota": "inclination",
    "ra": "right_ascension",
    "dec": "declination",
    "psi": "polarization_angle",
    "spin_1z": "chi_1",
    "spin_2z": "chi_2",
    "spin1z": "chi_1",
    "spin2z": "chi_2",
    "spin_1x": "chi_1x",
    "spin_1y": "chi_1y",
    "spin_2x": "chi_2x",
    "spin_2y": "chi_2y",
    "spin1x": "chi_1x",
    "spin1y": "chi_1y",
    "spin2x": "chi_2x",
    "spin2y": "chi_2y",
    "lambda1": "lambda_1",
    "lambda2": "lambda_2",
}
"""By names of others, ours of the same quantity in the same unit. (``theta_jn`` is the inclination where spins are
aligned, and nowhere else.)"""
ANGLE_OF_TOTAL = (
    "inclination is the angle of the orbital angular momentum (LAL's and PyCBC's), and theta_jn that of the total one"
)

_MASSES = (
    "mass_ratio = mass_1 / mass_2, the heavier over the lighter, and total_mass = mass_1 + mass_2, both redshifted"
)
_TIDES = (
    "lambda_1 and lambda_2 follow from lambda_tilde and delta_lambda_tilde together (Wade et al. 2014, eqs. 5 and 6), "
    "which convert() solves"
)
FORMULAS = (
    dict.fromkeys(("mass_1", "mass_2", "mass1", "mass2", "m1", "m2"), _MASSES)
    | {
        "chirp_mass": "total_mass = chirp_mass * ((1 + q)**2 / q)**0.6 with q = mass_ratio",
        "symmetric_mass_ratio": "mass_ratio = (1 - 2 eta + sqrt(1 - 4 eta)) / (2 eta)",
        "eta": "mass_ratio = (1 - 2 eta + sqrt(1 - 4 eta)) / (2 eta)",
    }
    | dict.fromkeys(("lambda_tilde", "delta_lambda_tilde"), _TIDES)
    | {
        f"{name}_{star}": (
            f"chi_{star} = a_{star} * cos(tilt_{star}), and chi_{star}x, chi_{star}y are what is in the orbital plane"
        )
        for name in ("a", "tilt", "cos_tilt")
        for star in (1, 2)
    }
    | dict.fromkeys(
        ("phase", "coa_phase", "phi_ref"),
        "reference_phase is twice that of the orbit at f_ref where the options have reference_frequency=f_ref; without "
        "them it is added to the phase of the alignment: see the page on conventions",
    )
    | dict.fromkeys(
        ("geocent_time", "tc", "geocentric_end_time"),
        "coalescence_time of a likelihood is in seconds from its trigger; time_shift moves a waveform",
    )
    | {"redshift": "total_mass is that of the detector's frame: (1 + redshift) times the source's"}
)
"""What to give in place of names that are not ours."""


def hint_for(name: str, known: Collection[str]) -> str | None:
    """What to give in place of a name that other programs have, where ``known`` are taken; None if it is not such."""
    ours = SAME.get(name)
    if ours is not None and ours in known:
        if name == "theta_jn":
            return f"'{ours}' is the same where spins are aligned: {ANGLE_OF_TOTAL}."
        return f"'{ours}' is the same, in the same unit."
    return f"Here, {FORMULAS[name]}." if name in FORMULAS else None
