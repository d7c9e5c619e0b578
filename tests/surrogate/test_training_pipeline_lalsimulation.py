"""A model of an approximant of LALSimulation, from 200 of its waveforms: absolute times and phases are learnt, too."""

import numpy as np
import pytest

from bnserve_protocol import INTRINSIC_NAMES, SOLAR_MASS_SECONDS, EvaluationOptions, ParameterBatch
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.chunks import evaluate
from bnserve_surrogate.training.data.generators import LALSimulationGenerator
from bnserve_surrogate.training.pipeline import train

pytest.importorskip("lalsimulation")

APPROXIMANTS = ["IMRPhenomXAS_NRTidalv3", "IMRPhenomD_NRTidalv2"]
BOX = {"mass_ratio": [1.0, 1.5], "chi": [-0.1, 0.1], "tidal_deformability": [200.0, 1500.0]}
BAND = {"total_mass": [2.6, 2.9], "frequency_band": [20.0, 1000.0]}


@pytest.fixture(scope="module", params=APPROXIMANTS)
def trained(request, tmp_path_factory):
    table = {
        "name": "phenom",
        "version": "0.1.0",
        "generator": {"name": "lalsimulation", "options": {"approximant": request.param}},
        "ranges": {**BOX, **BAND},
        "nodes": {"count": 60},
        "dataset": {"count": 200},
        "reduction": {"components": 8},
        "regressor": {"polynomial": {"degree": 3.5}},
        "validation": {"count": 24, "edge_count": 24},
    }
    quietly = {"n_jobs": 1, "backend": "sequential", "progress": False, "say": lambda line: None}
    return train(parse_configuration(table), tmp_path_factory.mktemp("work"), **quietly)


def test_absolute_phases_and_times_are_learnt(trained):
    """A constant that is known modulo 2 pi would leave 1.8 rad."""
    for validation in trained.validations.values():
        assert np.sqrt(np.mean(validation.merger_phase**2)) < 1e-3
        assert np.abs(validation.merger_phase).max() < 5e-3
        assert np.abs(validation.merger_time).max() < 2e-3
        assert np.median(validation.mismatch) < 1e-6


@pytest.mark.parametrize("total_mass", [2.6, 2.9])
def test_aligned_at_the_merger_it_is_the_generator_on_any_grid(trained, total_mass):
    """Also on grids that end far below the merger, or begin high in the band."""
    options = trained.metadata.provenance["configuration"]["generator"]["options"]
    generator = LALSimulationGenerator(**options)
    theta = np.array([1.2, 0.03, -0.05, 500.0, 900.0])
    columns = dict(zip(INTRINSIC_NAMES, theta, strict=True))
    batch = ParameterBatch.coerce({**columns, "distance_mpc": 40.0, "inclination": 0.0, "total_mass": total_mass})
    for f in (np.geomspace(20.0, 100.0, 30), np.geomspace(30.0, 1000.0, 40), np.array([400.0, 800.0])):
        ours = trained.model.predict_amplitude_phase(f, batch, options=EvaluationOptions(alignment="merger"))
        _, psi = evaluate(generator, theta, f * total_mass * SOLAR_MASS_SECONDS)
        late = np.polynomial.Polynomial.fit(f, ours.phase[0] + psi, 1).convert()
        np.testing.assert_allclose(ours.phase[0] + psi, late(f), atol=1e-3)
        assert abs(late.coef[0]) < 5e-3
        assert abs(late.coef[1]) / (2.0 * np.pi) < 1e-3  # seconds
