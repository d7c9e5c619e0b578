"""What holds for every likelihood: the remote ones equal the local one in bits, types and errors."""

import asyncio
import functools

import astropy.units as u
import msgspec
import numpy as np
import pandas as pd
import pytest

from bnserve_client import AsyncModel
from bnserve_client import Model as RemoteModel
from bnserve_inference import likelihood, tabulated_distance_prior
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Analysis,
    AnalysisSettings,
    BnserveError,
    Calibration,
    DistanceMarginalisation,
    InvalidParameters,
    InvalidRequest,
    Likelihood,
    LikelihoodCounts,
    LikelihoodParameters,
    LikelihoodValues,
    OutOfDomain,
    RowStatus,
    TimeGrid,
    TimeMarginalisation,
    convert,
    gradient_names,
    integrated_names,
)
from tests.service.injections import SIGNAL, samples, sites, small_analysis

DETECTORS = ("H1", "L1", "V1")


def with_nodes(kind, **settings):
    """An analysis whose weights depend on time; they belong to no data, which the arithmetic does not mind."""
    random = np.random.default_rng(4)
    settings = AnalysisSettings(
        kind=kind, detectors=DETECTORS, f_min=20.0, f_max=1024.0, duration=4.0, trigger_time=0.0, sidereal_time=2.0,
        sidereal_rate=7.292e-5, prior={"coalescence_time": (-0.1, 0.1)}, time_grid=TimeGrid(start=-0.15, step=0.01),
        **settings,
    )  # fmt: skip
    arrays = {"linear_nodes": np.geomspace(20.0, 1000.0, 97), "quadratic_nodes": np.geomspace(21.0, 900.0, 11)}
    for name, response, location in sites(DETECTORS):
        arrays[f"response/{name}"], arrays[f"location/{name}"] = response, location
        parts = random.normal(size=(2, 31, 97)) * 1e23
        arrays[f"linear_weights/{name}"] = parts[0] + 1j * parts[1]
        arrays[f"quadratic_weights/{name}"] = random.uniform(0.5, 1.0, 11) * 1e46
    return Analysis(settings=settings, arrays=arrays)


def moving_bins():
    """The same, in detectors that move, one of which has long arms."""
    given = with_nodes("relative_binning")
    arrays, nodes = dict(given.arrays), given.arrays["linear_nodes"]
    arrays["quadratic_nodes"] = nodes
    for name in DETECTORS:
        arrays[f"quadratic_weights/{name}"] = np.linspace(0.5, 1.0, len(nodes)) * 1e46
    arrays["reference_phases"] = -np.cumsum(nodes)[None] % 6.0
    arrays["reference_times"] = -5e3 * (nodes[None] / 20.0) ** (-8.0 / 3.0)
    arrays["arms/V1"], arrays["response/V1"] = 4e4 * np.eye(3)[:2], np.diag([0.5, -0.5, 0.0])
    return Analysis(settings=msgspec.structs.replace(given.settings, response="moving"), arrays=arrays)


SUMS = TimeMarginalisation(minimum=-0.05, maximum=0.05, step=1e-3)
FAR = DistanceMarginalisation(minimum=10.0, maximum=100.0)
ANALYSES = {
    "full": lambda model: small_analysis(model, DETECTORS, f_max=256.0),
    "reduced-order quadrature": lambda model: with_nodes("roq", model_digest=model.description.digest),
    "relative binning": lambda model: with_nodes("relative_binning"),
    "calibration": lambda model: with_nodes("roq", calibration=Calibration(nodes=6, f_min=20.0, f_max=1024.0)),
    "phase and distance": lambda model: with_nodes("roq", phase_marginalisation=True, distance_marginalisation=FAR),
    "a table of distances": lambda model: with_nodes(
        "roq",
        phase_marginalisation=True,
        distance_marginalisation=tabulated_distance_prior(np.sin, minimum=0.1, maximum=3.0),
    ),
    "detectors that move": lambda model: moving_bins(),
    "detectors that move, on the full grid": lambda model: small_analysis(model, f_max=64.0, response="moving"),
    "time": lambda model: with_nodes("relative_binning", time_marginalisation=SUMS),
    "time and phase on the full grid": lambda model: small_analysis(
        model, f_max=64.0, phase_marginalisation=True, time_marginalisation=SUMS
    ),
    "aligned at the merger": lambda model: small_analysis(model, alignment="merger"),
}


@pytest.fixture(params=ANALYSES.values(), ids=ANALYSES)
def analysis(request, local):
    return request.param(local)


class _Waiting:
    """An asynchronous likelihood whose calls are waited for."""

    def __init__(self, address):
        self._loop = asyncio.new_event_loop()
        self._model = self._loop.run_until_complete(AsyncModel.connect(address))

    def bound_to(self, analysis, invalid_rows):
        self._likelihood = self._loop.run_until_complete(self._model.likelihood(analysis, invalid_rows=invalid_rows))
        return self

    @property
    def analysis(self):
        return self._likelihood.analysis

    @property
    def counts(self):
        return self._likelihood.counts

    def log_likelihood(self, batch):
        return self._loop.run_until_complete(self._likelihood.log_likelihood(batch))

    def evaluate(self, batch):
        return self._loop.run_until_complete(self._likelihood.evaluate(batch))

    def gradients(self, batch):
        return self._loop.run_until_complete(self._likelihood.gradients(batch))

    def products(self, batch):
        return self._loop.run_until_complete(self._likelihood.products(batch))

    def draw_marginalised(self, batch, *, seed):
        return self._loop.run_until_complete(self._likelihood.draw_marginalised(batch, seed=seed))

    def close(self):
        self._loop.run_until_complete(self._model.close())
        self._loop.close()


@pytest.fixture(params=["local", "remote", "asynchronous"])
def reach(request, local):
    """Binds an analysis to the model, reached in every way."""
    opened = []

    def bound(analysis, invalid_rows="flag"):
        if request.param == "local":
            return likelihood(local, analysis, invalid_rows=invalid_rows)
        address = request.getfixturevalue("address")
        if request.param == "asynchronous":
            opened.append(_Waiting(address))
            return opened[-1].bound_to(analysis, invalid_rows)
        opened.append(RemoteModel.connect(address))
        return likelihood(opened[-1], analysis, invalid_rows=invalid_rows)

    yield bound
    for one in opened:
        one.close()


def batch_for(analysis, rows=33):
    calibration = analysis.settings.calibration
    if calibration is None:
        return samples(rows)
    random = np.random.default_rng(9)
    errors = {name: random.normal(scale=0.03, size=(rows, calibration.nodes)) for name in DETECTORS[:2]}
    return samples(rows, calibration_amplitude=errors, calibration_phase=errors)


def test_it_is_a_likelihood(reach, analysis):
    bound = reach(analysis)
    assert isinstance(bound, Likelihood)
    assert bound.analysis is analysis


def test_values_are_equal_in_bits_and_finite(reach, analysis, local):
    batch = batch_for(analysis)
    values = reach(analysis).log_likelihood(batch)
    here = likelihood(local, analysis).log_likelihood(batch)
    assert (values.dtype, values.shape, values.tobytes()) == (here.dtype, here.shape, here.tobytes())
    assert np.isfinite(values).all()
    assert len(set(values.tolist())) == len(values)


def test_products_are_equal_in_bits(reach, analysis, local):
    batch = batch_for(analysis)
    found, here = reach(analysis).products(batch), likelihood(local, analysis).products(batch)
    assert found.detectors == analysis.settings.detectors
    for name in ("d_inner_h", "h_inner_h", "status"):
        one, other = getattr(found, name), getattr(here, name)
        assert (one.dtype, one.shape, one.tobytes()) == (other.dtype, other.shape, other.tobytes())
    assert np.isfinite(found.h_inner_h).all()


def test_gradients_are_equal_in_bits(reach, analysis, local):
    batch = batch_for(analysis)
    found, here = reach(analysis).gradients(batch), likelihood(local, analysis).gradients(batch)
    assert found.names == here.names == gradient_names(analysis.settings)
    for name in ("log_likelihood", "gradient", "status"):
        one, other = getattr(found, name), getattr(here, name)
        assert (one.dtype, one.shape, one.tobytes()) == (other.dtype, other.shape, other.tobytes())
    assert np.isfinite(found.gradient).all()
    assert found.log_likelihood.tobytes() == reach(analysis).log_likelihood(batch).tobytes()


def test_draws_are_equal_in_bits(reach, analysis, local):
    batch, bound = batch_for(analysis), reach(analysis)
    if not integrated_names(analysis.settings):
        with pytest.raises(InvalidRequest, match="integrates over nothing"):
            bound.draw_marginalised(batch, seed=3)
        return
    found, here = bound.draw_marginalised(batch, seed=3), likelihood(local, analysis).draw_marginalised(batch, seed=3)
    assert tuple(found.parameters) == integrated_names(analysis.settings)
    for name, values in here.parameters.items():
        assert found.parameters[name].tobytes() == values.tobytes()
    assert found.log_likelihood.tobytes() == here.log_likelihood.tobytes()
    part = bound.draw_marginalised(batch.rows(slice(4, 9)), seed=3)
    assert part.log_likelihood.tobytes() == here.log_likelihood[4:9].tobytes()
    assert bound.counts.rows >= len(batch)


def test_a_table_by_the_names_of_bilby(reach, local):
    analysis = small_analysis(local, alignment="merger")
    batch = samples(5, reference_phase=0.0)
    ours = pd.DataFrame({name: batch[name] for name in LIKELIHOOD_NAMES if name != "reference_phase"})
    theirs = ours.rename(
        columns={"distance_mpc": "luminosity_distance", "inclination": "theta_jn", "right_ascension": "ra"}
    )
    masses = convert({"total_mass": theirs.pop("total_mass"), "mass_ratio": theirs["mass_ratio"]})
    q, total = masses["mass_ratio"], masses["total_mass"]
    theirs["mass_1"], theirs["mass_2"] = total * q / (1.0 + q), total / (1.0 + q)
    theirs["geocent_time"] = theirs.pop("coalescence_time") + analysis.settings.trigger_time
    bound = reach(analysis)
    assert bound.log_likelihood(ours).tobytes() == bound.log_likelihood(batch).tobytes()
    found = bound.log_likelihood(theirs.drop(columns=["mass_ratio"]))
    np.testing.assert_allclose(found, bound.log_likelihood(batch), rtol=1e-5)  # of 0.2 us in a GPS time
    with pytest.raises(InvalidParameters, match="phase"):
        bound.log_likelihood(theirs.assign(phase=0.0))


def test_a_row_has_the_same_bits_alone_and_in_a_batch(reach, analysis):
    batch, bound = batch_for(analysis), reach(analysis)
    together = bound.log_likelihood(batch)
    alone = [bound.log_likelihood(batch.rows(slice(row, row + 1))) for row in range(len(batch))]
    assert np.concatenate(alone).tobytes() == together.tobytes()


@functools.cache
def small():
    return with_nodes("roq", phase_marginalisation=True)


BATCHES = {
    "one": LikelihoodParameters(**SIGNAL),
    "a list": [LikelihoodParameters(**SIGNAL), LikelihoodParameters(**SIGNAL | {"chi_1": 0.1})],
    "vectors and numbers": SIGNAL | {"polarization_angle": [0.0, 0.1, 0.2]},
    "nothing": [],
}


@pytest.mark.parametrize("batch", BATCHES.values(), ids=BATCHES)
def test_every_form_of_a_batch_is_accepted(reach, local, batch):
    here = likelihood(local, small()).log_likelihood(batch)
    assert reach(small()).log_likelihood(batch).tobytes() == here.tobytes()


KILOPARSECS, DEGREES = 40e3 * u.kpc, np.array([10.0, 20.0]) * u.deg
IN_OTHER_UNITS = {"distance_mpc": KILOPARSECS, "polarization_angle": DEGREES, "coalescence_time": -2 * u.ms}
IN_OURS = {
    "distance_mpc": 40.0,
    "polarization_angle": DEGREES.to_value("rad"),
    "coalescence_time": (-2 * u.ms).to_value("s"),
}


def test_samples_that_carry_a_unit_are_converted(reach, local):
    here = likelihood(local, small()).log_likelihood(SIGNAL | IN_OURS)
    assert reach(small()).log_likelihood(SIGNAL | IN_OTHER_UNITS).tobytes() == here.tobytes()


BAD = {
    "outside the prior": ("coalescence_time", 0.11, RowStatus.OUT_OF_PRIOR),
    "outside the model's range": ("mass_ratio", 0.5, RowStatus.OUT_OF_DOMAIN),
    "not a number": ("declination", np.nan, RowStatus.NOT_FINITE),
    "no distance": ("distance_mpc", np.inf, RowStatus.NOT_FINITE),
}


def bad_batch():
    batch = samples(9)
    for row, (name, bad, _) in enumerate(BAD.values()):
        batch[name][2 * row] = bad
    return batch


def test_rows_that_cannot_be_are_minus_infinity_and_counted(reach, local):
    bound = reach(small())
    values, status = bound.evaluate(bad_batch())
    here = likelihood(local, small()).evaluate(bad_batch())
    assert (values.tobytes(), status.tobytes()) == (here[0].tobytes(), here[1].tobytes())
    assert status[[0, 2, 4, 6]].tolist() == [bad[2] for bad in BAD.values()]
    assert (values[::2][:4] == -np.inf).all()
    assert bound.counts == LikelihoodCounts(rows=9, not_finite=2, out_of_domain=1, out_of_prior=1)


def test_values_and_statuses_are_a_named_tuple(reach):
    found = reach(small()).evaluate(samples(3))
    assert type(found) is LikelihoodValues
    values, status = found
    assert found.log_likelihood is values is found[0]
    assert found.status is status is found[1]


@pytest.mark.parametrize("choice", ["ignore", "", None, True, ["flag"]])
def test_an_unknown_choice_for_invalid_rows_is_the_same_error(reach, local, choice):
    there = failure(lambda: reach(small(), choice))
    assert there == failure(lambda: likelihood(local, small(), invalid_rows=choice))
    assert there[0] is InvalidRequest


def test_what_overflows_is_never_all_right(reach, analysis, local):
    """A distance of 1e-300 Mpc, and calibration errors of 1e200: NaN with the status OK they were."""
    batch = batch_for(analysis, 6)
    ignored = analysis.settings.distance_marginalisation is not None
    if not ignored:
        batch["distance_mpc"][1] = 1e-300
    for name, array in batch.calibration_amplitude.items():
        array[2], batch.calibration_phase[name][3] = 1e200, 1e200
    values, status = reach(analysis).evaluate(batch)
    spoilt = {1} if not ignored else set()
    spoilt |= {2, 3} if batch.calibration_amplitude else set()
    assert {row for row in range(6) if status[row] == RowStatus.NOT_FINITE} == spoilt
    assert (np.isfinite(values) == (status == RowStatus.OK)).all()
    assert (values[status != RowStatus.OK] == -np.inf).all()
    here = likelihood(local, analysis).evaluate(batch)
    assert (values.tobytes(), status.tobytes()) == (here[0].tobytes(), here[1].tobytes())


def failure(call):
    with pytest.raises(BnserveError) as raised:
        call()
    error = raised.value
    return type(error), error.code, error.detail, error.errors


def test_a_signal_above_the_model_s_band_at_all_frequencies_is_minus_infinity(reach, local):
    """At 4 solar masses the band ends at 2048 Hz; zeros would be a likelihood of one."""
    analysis = small_analysis(local, f_min=2064.0, f_max=2080.0)
    values, status = reach(analysis).evaluate(SIGNAL | {"total_mass": [2.5, 4.0]})
    assert status.tolist() == [RowStatus.OK, RowStatus.OUT_OF_BAND]
    assert np.isfinite(values).tolist() == [True, False]


def test_they_raise_the_same_error_where_that_is_asked_for(reach, local):
    there = failure(lambda: reach(small(), "error").log_likelihood(bad_batch()))
    assert there == failure(lambda: likelihood(local, small(), invalid_rows="error").log_likelihood(bad_batch()))
    assert there[0] is OutOfDomain
    assert there[2].startswith("Row 0 is outside the ranges")


WRONG = {
    "an unknown name": SIGNAL | {"eccentricity": 0.1},
    "a missing name": {name: value for name, value in SIGNAL.items() if name != "declination"},
    "no distance": {name: value for name, value in SIGNAL.items() if name != "distance_mpc"},
    "unequal lengths": SIGNAL | {"chi_1": [0.0, 0.1], "chi_2": [0.0] * 3},
    "errors of no node": SIGNAL | {"calibration_phase": {"H1": [0.0] * 4}},
    "no batch": 3,
    "another unit": SIGNAL | {"distance_mpc": 3.0 * u.s},
    "a mask": SIGNAL | {"chi_1": np.ma.array([0.0, 0.1], mask=[False, True])},
    "complex numbers": SIGNAL | {"chi_1": np.array([0.1j])},
    "text": SIGNAL | {"chi_1": "0.1"},
    "truth values": SIGNAL | {"chi_1": [True, False]},
}


@pytest.mark.parametrize("batch", WRONG.values(), ids=WRONG)
def test_a_wrong_batch_is_the_same_error(reach, local, batch):
    there = failure(lambda: reach(small()).log_likelihood(batch))
    assert there == failure(lambda: likelihood(local, small()).log_likelihood(batch))
    assert there[0] is InvalidParameters


@pytest.mark.parametrize("analysis", [None, {}, "analysis"], ids=str)
def test_what_is_no_analysis_is_the_same_error(reach, local, analysis):
    there = failure(lambda: reach(analysis))
    assert there == failure(lambda: likelihood(local, analysis))
    assert there[0] is InvalidRequest


def test_another_models_analysis_is_the_same_error(reach, local):
    analysis = with_nodes("roq", model_digest="sha256:another")
    assert failure(lambda: reach(analysis)) == failure(lambda: likelihood(local, analysis))
