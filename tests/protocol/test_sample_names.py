"""Samples by the names of other programs, and tables of them: the same batch as by ours."""

import numpy as np
import pandas as pd
import pytest
from bilby.gw import conversion

from bnserve_protocol import AnalysisSettings, Calibration, InvalidParameters, LikelihoodBatch, ParameterBatch
from bnserve_protocol import samples_of as samples_in
from tests.service.injections import SIGNAL

TRIGGER = 1187008882.4


def settings(**given):
    given = {
        "kind": "full", "detectors": ("H1", "L1"), "f_min": 20.0, "f_max": 64.0, "duration": 4.0,
        "trigger_time": TRIGGER, "sidereal_time": 1.0, "sidereal_rate": 7.292e-5, "alignment": "merger",
    } | given  # fmt: skip
    return AnalysisSettings(**given)


OURS = SIGNAL | {"mass_ratio": np.array([1.2, 1.1]), "total_mass": np.array([2.76, 2.75]), "chi_2": 0.02}
M1, M2 = (
    OURS["total_mass"] * OURS["mass_ratio"] / (1 + OURS["mass_ratio"]),
    OURS["total_mass"] / (1 + OURS["mass_ratio"]),
)
REST = {
    "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.02, "theta_jn": 2.5, "ra": 3.4, "dec": -0.4,
    "psi": 0.3, "luminosity_distance": 40.0, "geocent_time": TRIGGER + 0.01,
}  # fmt: skip
MASSES = {
    "components": {"mass_1": M1, "mass_2": M2},
    "chirp mass and mass ratio": {
        "chirp_mass": conversion.component_masses_to_chirp_mass(M1, M2),
        "mass_ratio": 1.0 / OURS["mass_ratio"],
    },
    "chirp mass and symmetric mass ratio": {
        "chirp_mass": conversion.component_masses_to_chirp_mass(M1, M2),
        "symmetric_mass_ratio": conversion.component_masses_to_symmetric_mass_ratio(M1, M2),
    },
}


@pytest.mark.parametrize("masses", MASSES.values(), ids=MASSES)
@pytest.mark.parametrize("form", [dict, pd.DataFrame, lambda columns: pd.DataFrame(columns).to_records(index=False)])
def test_names_of_bilby_and_tables_of_them(masses, form):
    ours = LikelihoodBatch.coerce(OURS)
    theirs = samples_in(form(masses | REST), settings())
    np.testing.assert_allclose(theirs.values, ours.values, rtol=1e-12, atol=1e-6)  # a GPS time has steps of 0.2 us
    assert theirs.absent == ours.absent


def test_a_table_by_our_names_is_taken_as_it_is():
    frame = pd.DataFrame(OURS)
    for found in (samples_in(frame, settings()), LikelihoodBatch.coerce(frame)):
        assert found.values.tobytes() == LikelihoodBatch.coerce(OURS).values.tobytes()
    row = samples_in(frame.iloc[1], settings())
    assert row.values.tobytes() == LikelihoodBatch.coerce(OURS).rows(slice(1, 2)).values.tobytes()
    binaries = frame.drop(columns=["right_ascension", "declination", "polarization_angle", "coalescence_time"])
    assert len(ParameterBatch.coerce(binaries)) == 2


def test_what_is_integrated_over_is_ignored_by_any_name():
    found = samples_in(MASSES["components"] | REST | {"phase": 1.0}, settings(phase_marginalisation=True))
    assert (found["reference_phase"] == 0.0).all()
    without = {name: value for name, value in REST.items() if name not in ("geocent_time", "luminosity_distance")}
    assert samples_in(MASSES["components"] | without, settings()).absent == {"distance_mpc", "coalescence_time"}


def test_a_phase_at_the_reference_frequency_of_the_analysis():
    found = samples_in(MASSES["components"] | REST | {"phase": [1.0, 4.0]}, settings(reference_frequency=50.0))
    assert found["reference_phase"].tolist() == [2.0, 8.0]


def test_aligned_spins_with_their_angles():
    spins = {"a_1": 0.01, "tilt_1": 0.0, "a_2": 0.02, "tilt_2": np.pi, "phi_12": 0.0, "phi_jl": 0.0}
    rest = {name: value for name, value in REST.items() if not name.startswith("chi")}
    found = samples_in(MASSES["components"] | rest | spins, settings())
    np.testing.assert_allclose(found["chi_2"], -0.02)
    with pytest.raises(InvalidParameters, match="orbital plane"):
        samples_in(MASSES["components"] | rest | spins | {"tilt_1": 1.0}, settings())


def test_calibration_errors():
    nodes = settings(calibration=Calibration(nodes=4, f_min=20.0, f_max=64.0))
    errors = {f"recalib_L1_{kind}_{node}": 0.01 * node for kind in ("amplitude", "phase") for node in range(4)}
    errors["recalib_L1_phase_3"] = np.array([0.1, 0.2])
    found = samples_in(MASSES["components"] | REST | errors, nodes)
    np.testing.assert_allclose(found.calibration_amplitude["L1"], [[0.0, 0.01, 0.02, 0.03]] * 2)
    np.testing.assert_allclose(found.calibration_phase["L1"][:, 3], [0.1, 0.2])
    del errors["recalib_L1_phase_2"]
    with pytest.raises(InvalidParameters, match="'recalib_L1_phase_2' is missing"):
        samples_in(MASSES["components"] | REST | errors, nodes)
    with pytest.raises(InvalidParameters, match="'recalib_L1_amplitude_0' is no calibration error of this analysis"):
        samples_in(MASSES["components"] | REST | {"recalib_L1_amplitude_0": 0.0}, settings())


REFUSED = {
    "a phase at a frequency": ({"phase": 1.0}, {}, "reference frequency, which this analysis does not have"),
    "a phase twice": ({"phase": 1.0, "reference_phase": 2.0}, {"reference_frequency": 50.0}, "leave one out"),
    "a time of another meaning": ({}, {"alignment": "post_newtonian"}, "alignment='merger'"),
    "a time twice": ({"coalescence_time": 0.0}, {}, "one quantity"),
    "masses twice": ({"total_mass": 2.7}, {}, "stated twice"),
    "a distance twice": ({"distance_mpc": 40.0}, {}, "two names of one quantity"),
    "what is no parameter": ({"log_prior": -3.0}, {}, "'log_prior' cannot be converted"),
    "text": ({"geocent_time": "now"}, {}, "geocent_time"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_not_exact_is_refused(case):
    given, of, reason = REFUSED[case]
    with pytest.raises(InvalidParameters, match=reason):
        samples_in(MASSES["components"] | REST | given, settings(**of))


def test_more_than_a_quarter_is_no_symmetric_mass_ratio():
    given = MASSES["chirp mass and symmetric mass ratio"] | {"symmetric_mass_ratio": np.array([0.25, 0.26])}
    found = samples_in(given | REST, settings())
    assert np.isfinite(found["mass_ratio"]).tolist() == [True, False]
