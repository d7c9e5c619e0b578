"""Same question, same bits: whatever the batch around a row, and whoever asks."""

import pickle
import threading

import numpy as np
import pytest

from bnserve_inference import likelihood
from bnserve_inference.adjoint_kernel import build as adjoint
from bnserve_inference.adjoint_kernel._call import ASSEMBLY as ADJOINT
from bnserve_inference.fisher_kernel import build as forecasts
from bnserve_inference.fisher_kernel._assembly import ASSEMBLY as FORECASTS
from bnserve_inference.kernel import build as one_mode
from bnserve_inference.kernel._contraction import ASSEMBLY as ONE_MODE
from bnserve_inference.marginal_kernel import build as integrals
from bnserve_inference.marginal_kernel._call import ASSEMBLY as INTEGRALS
from bnserve_inference.modes_kernel import build as several_modes
from bnserve_inference.modes_kernel._contraction import ASSEMBLY as SEVERAL_MODES
from bnserve_inference.moving_kernel import build as moving
from bnserve_inference.moving_kernel._contraction import ASSEMBLY as MOVING
from bnserve_protocol import (
    Calibration,
    DistanceMarginalisation,
    LikelihoodBatch,
    TimeMarginalisation,
    decode_analysis,
    encode_analysis,
)
from bnserve_surrogate.kernel._loader import DIGEST_PREFIX
from bnserve_surrogate.kernel.build import source_digest
from tests.inference.networks import F_MAX, F_MIN, columns, full
from tests.inference.test_kinds_agree import binned

ALL = {
    "plain": {},
    "phase and distance": {
        "phase_marginalisation": True,
        "distance_marginalisation": DistanceMarginalisation(minimum=20.0, maximum=200.0),
    },
    "time": {"time_marginalisation": TimeMarginalisation(minimum=-0.01, maximum=0.01, step=5e-4)},
    "time, phase and distance": {
        "time_marginalisation": TimeMarginalisation(minimum=-0.01, maximum=0.01, step=5e-4),
        "phase_marginalisation": True,
        "distance_marginalisation": DistanceMarginalisation(minimum=20.0, maximum=200.0),
    },
    "calibration": {"calibration": Calibration(nodes=4, f_min=F_MIN, f_max=F_MAX)},
}


@pytest.mark.parametrize("options", ALL)
def test_a_row_has_the_same_bits_in_every_batch(model, data, options):
    ours = likelihood(model, binned(model, data, **ALL[options]))
    given = columns(300)
    if options == "calibration":
        draw = np.random.default_rng(0)
        given["calibration_phase"] = {"H1": draw.normal(0.0, 0.1, (300, 4))}
    batch = LikelihoodBatch.coerce(given)
    together = ours.log_likelihood(batch)
    for rows in (1, 7, 256):
        pieces = np.concatenate([ours.log_likelihood(piece) for piece in batch.split(rows)])
        assert (pieces == together).all()
    backwards = ours.log_likelihood(batch.rows(np.arange(300)[::-1]))
    assert (backwards[::-1] == together).all()


def test_the_full_grid_has_the_same_bits_in_every_batch(model, data):
    ours = likelihood(model, full(data))
    batch = LikelihoodBatch.coerce(columns(20))
    together = ours.log_likelihood(batch)
    for rows in (1, 7):
        assert (np.concatenate([ours.log_likelihood(piece) for piece in batch.split(rows)]) == together).all()


def test_rows_that_cannot_be_evaluated_leave_the_others_alone(model, data):
    ours = likelihood(model, binned(model, data))
    given = columns(50)
    expected = ours.log_likelihood(given)
    given["mass_ratio"][[3, 20]] = 50.0, np.nan
    values = ours.log_likelihood(given)
    assert np.isneginf(values[[3, 20]]).all()
    kept = np.setdiff1d(np.arange(50), [3, 20])
    assert (values[kept] == expected[kept]).all()


def test_threads_do_not_disturb_each_other(model, data):
    ours = likelihood(model, binned(model, data))
    batch = columns(64)
    expected, found = ours.log_likelihood(batch), []
    threads = [threading.Thread(target=lambda: found.append(ours.log_likelihood(batch))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 8
    assert all((values == expected).all() for values in found)
    assert ours.counts.rows == 9 * 64


def test_an_analysis_that_travelled_gives_the_same_bits(model, data):
    analysis = binned(model, data)
    there = decode_analysis(b"".join(encode_analysis(analysis)))
    pickled = pickle.loads(pickle.dumps(analysis))
    assert there.digest == analysis.digest == pickled.digest
    batch = columns(20)
    expected = likelihood(model, analysis).log_likelihood(batch)
    assert (likelihood(model, there).log_likelihood(batch) == expected).all()


@pytest.mark.parametrize(
    ("assembly", "build"),
    [
        (ONE_MODE, one_mode),
        (SEVERAL_MODES, several_modes),
        (MOVING, moving),
        (FORECASTS, forecasts),
        (ADJOINT, adjoint),
        (INTEGRALS, integrals),
    ],
)
def test_the_compiled_contractions_are_of_these_sources(assembly, build):
    first_line = assembly.read_text().split("\n", 1)[0]
    assert first_line == DIGEST_PREFIX + source_digest(build.sources()), f"run: python -m {build.__name__}"
