"""Inner products and signal-to-noise ratios by detector, against sums over frequencies that share nothing with them."""

import numpy as np
import pytest

from bnserve_inference import LikelihoodOptions, detector_strain, likelihood, roq_analysis
from bnserve_protocol import (
    Calibration,
    DistanceMarginalisation,
    InvalidParameters,
    LikelihoodBatch,
    LikelihoodParameters,
    RowStatus,
    TimeMarginalisation,
)
from tests.inference.bases import made_basis
from tests.inference.networks import DETECTORS, DURATION, F_MAX, F_MIN, PRIOR, START, TRIGGER, columns, full, network
from tests.inference.several_modes import seven_modes
from tests.inference.test_kinds_agree import binned, errors

CALIBRATION = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)
INTEGRATED = {
    "phase_marginalisation": True,
    "time_marginalisation": TimeMarginalisation(minimum=-0.01, maximum=0.015),
    "distance_marginalisation": DistanceMarginalisation(minimum=20.0, maximum=200.0),
}


def by_sums(model, data, batch, row, calibration=None):
    """<d|h> and <h|h> of one sample in every detector."""
    errors = {
        part: {name: array[row] for name, array in batch.get(part, {}).items()}
        for part in ("calibration_amplitude", "calibration_phase")
    }
    one = LikelihoodParameters(
        **{name: float(v[row]) for name, v in batch.items() if not name.startswith("calib")}, **errors
    )
    band = slice(round(F_MIN * DURATION), round(F_MAX * DURATION) + 1)
    found = []
    for detector in data:
        f = np.arange(len(detector.asd))[band] / DURATION
        h = detector_strain(detector.site(), f, model, one, trigger_time=TRIGGER, calibration=calibration)
        h = h * np.exp(-2j * np.pi * f * (TRIGGER - START))
        weight = 4.0 / DURATION / detector.asd[band] ** 2
        found.append((np.sum(weight * detector.strain[band].conj() * h), np.sum(weight * abs(h) ** 2)))
    return np.array([z for z, _ in found]), np.array([n for _, n in found])


KINDS = {
    "full": (lambda data, model: full(data), 1e-9),
    "integrated": (lambda data, model: full(data, **INTEGRATED), 1e-9),
    "relative binning": (lambda data, model: binned(model, data, **INTEGRATED), 1e-3),
    "quadrature": (
        lambda data, model: roq_analysis(
            data, trigger_time=TRIGGER, basis=made_basis(model), model=model, options=LikelihoodOptions(prior=PRIOR)
        ),
        3e-3,
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_of_every_kind(model, data, kind):
    made, tolerance = KINDS[kind]
    batch = columns(4, width=0.3)
    found = likelihood(model, made(data, model)).products(batch)
    assert found.detectors == DETECTORS
    assert (found.status == RowStatus.OK).all()
    for row in range(4):
        with_data, norms = by_sums(model, data, batch, row)
        np.testing.assert_allclose(found.d_inner_h[row], with_data, rtol=tolerance, atol=tolerance * norms.max())
        np.testing.assert_allclose(found.h_inner_h[row], norms, rtol=tolerance)


def test_of_seven_modes():
    model = seven_modes()
    data = network(model)
    batch = columns(2, width=0.1)
    exact = likelihood(model, full(data)).products(batch)
    for row in range(2):
        with_data, norms = by_sums(model, data, batch, row)
        np.testing.assert_allclose(exact.d_inner_h[row], with_data, rtol=1e-8, atol=1e-6)
        np.testing.assert_allclose(exact.h_inner_h[row], norms, rtol=1e-9)


def test_in_detectors_that_move(model, data):
    batch = columns(3, width=0.3)
    moving = likelihood(model, full(data, response="moving"))
    np.testing.assert_allclose(moving.products(batch).network_log_likelihood, moving.log_likelihood(batch), rtol=1e-9)
    integrated = likelihood(model, full(data, response="moving", **INTEGRATED))
    drawn = integrated.draw_marginalised(batch, seed=1)
    np.testing.assert_allclose(moving.log_likelihood(batch | drawn.parameters), drawn.log_likelihood, atol=1e-3)


def test_of_calibrated_signals(model, data):
    batch = columns(3, width=0.3)
    batch |= errors(batch, 0.03)
    found = likelihood(model, full(data, calibration=CALIBRATION)).products(batch)
    for row in range(3):
        with_data, norms = by_sums(model, data, batch, row, CALIBRATION)
        np.testing.assert_allclose(found.d_inner_h[row], with_data, rtol=1e-8, atol=1e-6)
        np.testing.assert_allclose(found.h_inner_h[row], norms, rtol=1e-8)


def test_ratios_and_likelihoods_of_detectors_and_network(model, data):
    batch = columns(5)
    found = likelihood(model, full(data, **INTEGRATED)).products(batch)
    np.testing.assert_allclose(found.network_log_likelihood, likelihood(model, full(data)).log_likelihood(batch))
    for place in range(3):
        alone = likelihood(model, full(data[place : place + 1]))
        np.testing.assert_allclose(found.log_likelihood[:, place], alone.log_likelihood(batch), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(found.optimal_snr**2, found.h_inner_h)
    np.testing.assert_allclose(found.matched_filter_snr * found.optimal_snr, found.d_inner_h.conj())
    np.testing.assert_allclose(found.network_optimal_snr, np.sqrt((found.optimal_snr**2).sum(axis=1)))
    expected = found.d_inner_h.sum(axis=1).conj() / found.network_optimal_snr
    np.testing.assert_allclose(found.network_matched_filter_snr, expected)
    table = found.columns()
    assert {"H1_optimal_snr", "V1_matched_filter_snr", "L1_log_likelihood", "network_log_likelihood"} <= table.keys()
    assert all(values.shape == (5,) for values in table.values())


def test_a_row_has_the_same_bits_alone_and_one_that_cannot_be_evaluated_never_raises(model, data):
    bound = likelihood(model, full(data))
    batch = columns(12) | {"mass_ratio": np.array([1.3, 50.0, np.nan, *[1.3] * 9])}
    found = bound.products(batch)
    assert found.status[:4].tolist() == [RowStatus.OK, RowStatus.OUT_OF_DOMAIN, RowStatus.NOT_FINITE, RowStatus.OK]
    assert np.isfinite(found.d_inner_h).all(axis=1)[:4].tolist() == [True, False, False, True]
    assert np.isneginf(found.network_log_likelihood)[:4].tolist() == [False, True, True, False]
    alone = bound.products(LikelihoodBatch.coerce(batch).rows(slice(5, 6)))
    assert alone.d_inner_h.tobytes() == found.d_inner_h[5:6].tobytes()
    assert alone.h_inner_h.tobytes() == found.h_inner_h[5:6].tobytes()


def test_samples_are_whole(model, data):
    fewer = {name: values for name, values in columns(1).items() if name != "distance_mpc"}
    with pytest.raises(InvalidParameters, match="Missing parameter: distance_mpc"):
        likelihood(model, full(data, **INTEGRATED)).products(fewer)
