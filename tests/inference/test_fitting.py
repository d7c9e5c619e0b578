"""Approximate analyses are held to the full grid when they are made: they are right, are made right, or refused.

Right is, within 25 of the maximum of ln L, an error of at most 0.1; and nothing else may seem to be there.
"""

import dataclasses

import numpy as np
import pytest

from benchmarks.gw170817 import setting
from benchmarks.inference.measuring import posterior_points, prior_samples
from bnserve_inference import LikelihoodOptions, full_analysis, likelihood, relative_binning_analysis, roq_analysis
from bnserve_inference._fitting import Fitting
from bnserve_inference.roq import load_shipped_basis
from bnserve_protocol import LIKELIHOOD_NAMES, AnalysisInvalid, Calibration, LikelihoodBatch
from bnserve_surrogate import Model
from tests.inference.bases import CHIRP_MASS, RANGES, WIDTH, made_basis
from tests.inference.networks import F_MAX, F_MIN, PRIOR, TRIGGER, TRUTH, columns, full, network, without
from tests.inference.test_kinds_agree import binned, errors

PHASELESS = LikelihoodOptions(prior=setting.RANGES, phase_marginalisation=True, modes=setting.MODES)
BAND = {"trigger_time": setting.TRIGGER, "f_min": setting.F_MIN, "f_max": setting.F_MAX}


def assert_right(approximate, exact):
    """Of ln L at the same places."""
    relevant = exact > exact.max() - 25.0
    assert relevant.sum() > 20
    assert np.abs(approximate[relevant] - exact[relevant]).max() < 0.1
    assert (approximate[~relevant] < exact.max() - 25.0 + 0.1).all()


@pytest.fixture(scope="module")
def default():
    return Model.default()


@pytest.fixture(scope="module")
def event(default):
    """The event's noise curves with a signal like it."""
    return setting.inject(setting.read_asds(), default).data


@pytest.fixture(scope="module")
def full_event(default, event):
    return likelihood(default, full_analysis(event, **BAND, options=PHASELESS))


def binned_event(model, data, phase_tolerance):
    return relative_binning_analysis(
        data, **BAND, fiducial=setting.fiducial(), model=model, phase_tolerance=phase_tolerance, options=PHASELESS
    )


def around_the_posterior(rows=300):
    """The posterior's own points, and such that are up to three times as far from the fiducial binary."""
    points = posterior_points(rows)
    middle = LikelihoodBatch.coerce(setting.reference()).values
    stretched = middle + np.repeat([1.0, 1.5, 3.0], rows // 3)[:, None] * (points.values - middle)
    return LikelihoodBatch(stretched)


@pytest.mark.parametrize("phase_tolerance", [0.2, 0.5])
def test_relative_binning_is_right_all_over_the_prior_of_the_event(default, event, full_event, phase_tolerance):
    """Bins that trusted the tolerance were wrong by 1.5 and 19 within 25 of the maximum, and elsewhere by hundreds."""
    ours = likelihood(default, binned_event(default, event, phase_tolerance))
    batch = LikelihoodBatch(np.concatenate([around_the_posterior().values, prior_samples(300).values]))
    assert_right(ours.log_likelihood(batch), full_event.log_likelihood(batch))


def far_in_chirp_mass(rows=1000):
    """The signal at many a chirp mass, most of them far from its own."""
    batch = columns(rows, seed=12, width=0.5)
    for name in ("inclination", "right_ascension", "declination", "polarization_angle", "distance_mpc"):
        batch[name][:] = getattr(TRUTH, name)
    batch["total_mass"][rows // 4 :] *= np.random.default_rng(13).uniform(0.96, 1.04, rows - rows // 4)
    return batch


@pytest.mark.parametrize("phase_tolerance", [0.5, 2.0])
def test_relative_binning_is_right_for_wide_priors_of_the_chirp_mass(model, data, phase_tolerance):
    wide = PRIOR | {"chirp_mass": (CHIRP_MASS - 0.05, CHIRP_MASS + 0.05)}
    ours = likelihood(model, binned(model, data, phase_tolerance, wide, phase_marginalisation=True))
    batch = far_in_chirp_mass()
    exact = likelihood(model, full(data, phase_marginalisation=True)).log_likelihood(batch)
    assert_right(ours.log_likelihood(batch), exact)


def test_bins_are_as_narrow_as_asked_for_where_that_is_narrower_than_needed(model, data):
    narrow, narrower = binned(model, data, 0.1), binned(model, data, 0.09)
    assert len(narrower.linear_nodes) / len(narrow.linear_nodes) == pytest.approx(0.1 / 0.09, rel=0.01)
    batch = columns(16, width=1.5)
    expected = likelihood(model, full(data)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, narrow).log_likelihood(batch), expected, atol=0.005)


def test_bins_that_are_just_too_wide_for_what_is_new_become_narrower(model, data, monkeypatch):
    """They stayed as they were where what had been seen before was just right, and after eight times were refused."""
    usual, binning, nodes = Fitting.compared, Fitting.binned, []

    def counted(self, basis, fine):
        nodes.append(len(basis.linear_nodes))
        return binning(self, basis, fine)

    def just_too_wide(self, trial, judge, seed, seen):
        compared = usual(self, trial, judge, seed, seen)
        if seen is not None and nodes[-1] < 1.1 * nodes[1]:
            compared.found.total[len(seen) :] = 1.1 * self.allowed
        return compared

    monkeypatch.setattr(Fitting, "binned", counted)
    monkeypatch.setattr(Fitting, "compared", just_too_wide)
    binned(model, data, 2.0)
    assert nodes[-1] >= 1.1 * nodes[1]


@pytest.mark.parametrize("phase_tolerance", [0.001, 1e-300])
def test_more_bins_than_frequencies_are_refused(model, data, phase_tolerance):
    with pytest.raises(AnalysisInvalid, match=r"takes \d+ bins, where 2048 are the most for data of 7361 frequencies"):
        binned(model, data, phase_tolerance)


def test_a_prior_that_takes_too_many_bins_is_refused(model, data):
    """Noise alone: everything is within 25 of the maximum, and all masses that the model has take 10,000 bins."""
    signal = network(model, seed=None)
    noise = [without([one], 0, strain=one.strain - there.strain)[0] for one, there in zip(data, signal, strict=True)]
    with pytest.raises(AnalysisInvalid, match="Narrow the prior"):
        binned(model, noise, 0.2)
    narrow = PRIOR | {"chirp_mass": (CHIRP_MASS - 0.001, CHIRP_MASS + 0.001), "mass_ratio": (1.0, 1.5)}
    batch = columns(100)
    expected = likelihood(model, full(noise)).log_likelihood(batch)
    ours = likelihood(model, binned(model, noise, 0.2, narrow))
    np.testing.assert_allclose(ours.log_likelihood(batch), expected, atol=0.1)


def test_priors_outside_of_the_model_are_refused_by_name(model, data):
    with pytest.raises(AnalysisInvalid, match=r"prior of 'mass_ratio', 5\.0 to 6\.0, lies outside"):
        binned(model, data, 0.5, PRIOR | {"mass_ratio": (5.0, 6.0)})


@pytest.mark.parametrize("nodes", [10, 64])
def test_relative_binning_follows_calibration_errors(model, data, nodes):
    """With 64 nodes it was off by 0.8."""
    calibration = Calibration(nodes=nodes, f_min=F_MIN, f_max=F_MAX)
    batch = columns(60)
    batch |= errors(batch, 0.05, nodes)
    expected = likelihood(model, full(data, calibration=calibration)).log_likelihood(batch)
    ours = likelihood(model, binned(model, data, 0.2, calibration=calibration))
    np.testing.assert_allclose(ours.log_likelihood(batch), expected, atol=0.05)


def calibrated_event(nodes, **bound):
    calibration = Calibration(nodes=nodes, f_min=setting.F_MIN, f_max=setting.F_MAX)
    return dataclasses.replace(PHASELESS, calibration=calibration, **bound)


@pytest.mark.parametrize(("nodes", "bound"), [(10, 0.05), (20, 0.1)])
def test_a_quadrature_follows_calibration_errors(default, event, nodes, bound):
    """Its thirty nodes for squared moduli were off by 0.4 with ten nodes of calibration, and by 3.5 with twenty."""
    options = calibrated_event(nodes, error_bound=bound)
    basis = load_shipped_basis("gw170817_fine")
    analysis = roq_analysis(event, trigger_time=setting.TRIGGER, basis=basis, model=default, options=options)
    batch = posterior_points(60)
    given = {name: batch[name] for name in LIKELIHOOD_NAMES} | errors(batch, 0.05, nodes)
    expected = likelihood(default, full_analysis(event, **BAND, options=options)).log_likelihood(given)
    np.testing.assert_allclose(likelihood(default, analysis).log_likelihood(given), expected, atol=bound)


def test_a_quadrature_that_cannot_follow_calibration_errors_is_refused(default, event):
    """With forty nodes, calibrated waveforms are not in the span of its linear rows: it was off by 31."""
    basis = load_shipped_basis("gw170817_fine")
    with pytest.raises(AnalysisInvalid, match="cannot stand calibration errors"):
        roq_analysis(event, trigger_time=setting.TRIGGER, basis=basis, model=default, options=calibrated_event(40))


def quadrature(data, model, basis, **options):
    options = {"prior": PRIOR} | options
    return roq_analysis(data, trigger_time=TRIGGER, basis=basis, model=model, options=LikelihoodOptions(**options))


def test_the_bound_is_stated_in_the_analysis_and_decides(model, data):
    calibration = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)
    basis = made_basis(model)
    with pytest.raises(AnalysisInvalid, match=r"where 0\.05 is allowed"):
        quadrature(data, model, basis, calibration=calibration)
    analysis = quadrature(data, model, basis, calibration=calibration, error_bound=0.3)
    assert analysis.settings.error_bound == 0.3


@pytest.mark.parametrize("calibrated", [False, True])
def test_a_table_that_is_conjugated_is_refused(model, data, calibrated):
    """Rows of the other sign of the phase were taken, 907 off."""
    right = made_basis(model)
    linear = dataclasses.replace(right.linear, table=right.linear.table.conj())
    calibration = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX, amplitude_width=0.01, phase_width=0.01)
    options = {"calibration": calibration} if calibrated else {}
    quadrature(data, model, right, **options)
    with pytest.raises(AnalysisInvalid, match="does not give the waveforms of this model"):
        quadrature(data, model, dataclasses.replace(right, linear=linear), **options)


def test_a_table_that_is_wrong_in_a_corner_of_its_ranges_is_refused(model, data):
    wide = {**RANGES, "chi_1": (-0.3, 0.3)}
    with pytest.raises(AnalysisInvalid, match="does not give the waveforms of this model"):
        quadrature(data, model, made_basis(model, prior=wide))


def test_a_table_without_ranges_is_held_to_those_of_the_prior(model, data):
    """As those that are read from files of bajes: no check looked at them."""
    silent = made_basis(model, prior={}, model_digest="")
    with pytest.raises(AnalysisInvalid, match="State the prior ranges of chirp_mass, mass_ratio, chi_1"):
        quadrature(data, model, silent)
    batch = columns(20, width=WIDTH)
    ours = likelihood(model, quadrature(data, model, silent, prior=PRIOR | RANGES))
    np.testing.assert_allclose(
        ours.log_likelihood(batch), likelihood(model, full(data)).log_likelihood(batch), atol=2e-3
    )
    with pytest.raises(AnalysisInvalid, match="does not give the waveforms of this model"):
        quadrature(data, model, silent, prior=PRIOR | RANGES | {"chi_1": (-0.5, 0.5)})


def test_a_basis_is_nothing_without_its_model(data, model):
    with pytest.raises(AnalysisInvalid, match="Give the model"):
        quadrature(data, None, made_basis(model))
