"""A run's parts: likelihoods in threads, what is kept of the choice of a likelihood, and the data that are shown."""

import msgspec
import numpy as np
import pytest
from scipy.special import logsumexp

from benchmarks.gw170817.setting import DATA
from bnserve_inference import DetectorData, detector_strain
from bnserve_posterior.events import EventInvalid, OutputExists
from bnserve_posterior.report._figures import interval, last_seconds, whitened
from bnserve_posterior.results import bilby_result, samples_of_posterior
from bnserve_posterior.running import Folder, meta_data, prepare, run
from bnserve_posterior.running._threads import in_threads
from bnserve_posterior.sampling import Posterior
from bnserve_protocol import LikelihoodParameters
from bnserve_surrogate import Model
from tests.posterior.networks import TRIGGER, event


@pytest.fixture(scope="module")
def model():
    return Model.default()


def prepared(model, folder, **changes):
    found = event(output__folder=str(folder), **changes)
    return prepare(found, model, Folder(found.output, resume=True))


def bilby_result_of(found):
    evidence = found.log_evidence, found.log_evidence_error
    return bilby_result(
        "x", found.samples, found.posterior, found.prepared.cube, found.prepared.priors, log_evidence=evidence,
        noise_log_likelihood=0.0, injection=None, meta_data=meta_data(found), settings={}, seconds=1.0,
        integrated=found.prepared.integrated,
    )  # fmt: skip


@pytest.mark.parametrize("count", [1, 127, 1000])
def test_values_do_not_depend_on_how_many_threads_evaluate_them(model, tmp_path, count):
    found = prepared(model, tmp_path / "run")
    u = np.random.default_rng(1).random((count, len(found.cube)))
    with in_threads(found.bound.log_likelihood, 3) as evaluate:
        assert (found.log_likelihood(u, evaluate) == found.log_likelihood(u)).all()


def test_by_how_much_detectors_may_not_stand_still_is_kept(model, tmp_path):
    first = prepared(model, tmp_path / "run")
    again = prepared(model, tmp_path / "run")
    assert first.analysis.settings.response == again.analysis.settings.response == "moving"
    assert 0.01 < first.static_error == again.static_error < 1.0
    (fact,) = [fact for fact in again.facts if fact.startswith("Likelihood")]
    assert f"turn with the Earth (standing still, ln L would be wrong by up to {first.static_error:.2g})" in fact
    assert not any("stand still" in doubt for doubt in again.doubts)


@pytest.mark.parametrize(("bound", "doubtful"), [(1.0, False), (0.05, True)])
def test_detectors_that_were_told_to_stand_still_and_should_not_are_doubtful(model, tmp_path, bound, doubtful):
    found = prepared(model, tmp_path / "run", likelihood__response="static", likelihood__error_bound=bound)
    assert any("Leave out 'response'" in doubt for doubt in found.doubts) == doubtful
    assert found.static_error is not None


def test_the_end_of_a_long_signal_is_shown_as_the_whole_of_it_would_be(model):
    """Of 64 times fewer frequencies."""
    duration, points = 8192.0, 8192 * 256 + 1
    frequencies = np.arange(points) / duration
    asd = 1e-24 * (1.0 + (40.0 / np.maximum(frequencies, 1.0)) ** 4)
    data = DetectorData("ETS1", np.zeros(points, complex), asd, start_time=1900000000.0, duration=duration)
    end = last_seconds(data)
    assert (end.duration, len(end.asd)) == (128.0, 128 * 256 + 1)
    trigger = data.start_time + duration - 2.0
    binary = LikelihoodParameters(
        mass_ratio=1.2, lambda_1=300.0, lambda_2=500.0, chi_1=0.0, chi_2=0.0, inclination=0.5, total_mass=2.8,
        right_ascension=1.0, declination=0.4, polarization_angle=0.3, distance_mpc=100.0, coalescence_time=0.0,
        reference_phase=0.0,
    )  # fmt: skip

    def shown(one):
        f = np.arange(len(one.asd)) / one.duration
        inside = np.flatnonzero((f >= 20.0) & (f < 250.0))
        strain = np.zeros(len(f), dtype=complex)
        strain[inside] = detector_strain(one.site(), f[inside], model, binary, trigger_time=trigger)
        strain *= np.exp(-2j * np.pi * f * (trigger - one.start_time))
        return whitened(one, strain)

    (times, whole), (late, short) = shown(data), shown(end)
    assert times[-len(late) :] - (data.duration - end.duration) == pytest.approx(late, abs=1e-9)
    near = (late > 125.5) & (late < 126.1)
    assert np.abs(whole[-len(late) :] - short)[near].max() < 0.01 * np.abs(short[near]).max()


def finished(model, folder, **changes):
    found = event(
        output__folder=str(folder), sampler__effective=300, sampler__particles=250, output__checks=20, **changes
    )
    kept = Folder(found.output)
    return run(prepare(found, model, kept), kept)


def test_a_time_that_is_integrated_over_is_no_column_and_is_drawn(model, tmp_path):
    plain = prepared(model, tmp_path / "plain")
    found = prepared(model, tmp_path / "run", likelihood__time_marginalisation=True)
    assert plain.cube.names == (*found.cube.names, "coalescence_time")
    random = np.random.default_rng(3)
    u = 0.5 + 0.02 * (random.random((4, len(found.cube))) - 0.5)
    times = (np.arange(2000) + 0.5) / 2000
    each = [plain.log_likelihood(np.concatenate([np.tile(row, (len(times), 1)), times[:, None]], axis=1)) for row in u]
    values = found.log_likelihood(u)
    assert values == pytest.approx(logsumexp(each, axis=1) - np.log(len(times)), abs=0.01)
    many = np.tile(u[:1], (100, 1))
    posterior = Posterior(many, np.full(100, 0.01), np.full(100, values[0]), 0.0, 0.1, 100.0, 0.1, (), 100)
    samples = samples_of_posterior(posterior, found.cube, found.bound, found.integrated, 1, model, 64.0)
    late = samples.values["geocent_time"] - TRIGGER
    weights = np.exp(each[0] - logsumexp(each[0]))
    middle = weights @ (0.02 * times - 0.01)
    width = np.sqrt(weights @ (0.02 * times - 0.01 - middle) ** 2)
    assert late.mean() == pytest.approx(middle, abs=0.5 * width)
    assert late.std() == pytest.approx(width, rel=0.3)


def test_a_time_of_one_value_cannot_be_integrated_over(model, tmp_path):
    changes = {"likelihood__time_marginalisation": True, "prior__geocent_time": TRIGGER}
    with pytest.raises(EventInvalid, match="give the two ends of geocent_time"):
        prepared(model, tmp_path / "run", **changes)


def test_calibration_errors_of_a_file_are_in_the_result(model, tmp_path):
    site = {"latitude": 0.8109, "longitude": -2.0841, "x_azimuth": 5.6549, "y_azimuth": 4.0841}
    changes = {
        "calibration": {"correction": "data", "nodes": 5, "draws": 8},
        "detectors__H1__calibration": str(DATA / "H1_CalEnv.txt"),
        "detectors__X1": {"asd": "aLIGO_O4_high_asd.txt", "site": site},
    }
    found = finished(model, tmp_path / "run", **changes)
    errors = found.samples.calibrated
    assert errors.draws == 8
    assert 0.9 < errors.efficiency < 1.0
    assert abs(errors.shift) < 0.2
    assert found.log_evidence_error > found.posterior.log_evidence_error
    columns = bilby_result_of(found).posterior
    widths = {"H1": 0.01, "L1": 0.0, "X1": 0.0}
    for name, width in widths.items():
        assert columns[f"recalib_{name}_amplitude_4"].std() == pytest.approx(width, abs=0.005), name
    envelope = found.prepared.envelopes.by_detector["H1"]
    assert columns["recalib_H1_phase_0"].mean() == pytest.approx(envelope.phase[0], abs=envelope.phase_width[0])
    assert found.check.largest < 0.05
    assert "H1_CalEnv.txt" in found.prepared.data.digests


def test_another_calibration_is_another_run(model, tmp_path):
    file = tmp_path / "calibration.txt"
    file.write_text((DATA / "H1_CalEnv.txt").read_text())
    changes = {"calibration": {"correction": "data"}, "detectors__H1__calibration": str(file)}
    prepared(model, tmp_path / "run", **changes)
    for other in ({"calibration__correction": "template"}, {"calibration__draws": 30}, {"calibration__nodes": 6}):
        with pytest.raises(OutputExists, match="another configuration"):
            prepared(model, tmp_path / "run", **changes, **other)
    file.write_text((DATA / "L1_CalEnv.txt").read_text())
    with pytest.raises(OutputExists, match="other data"):
        prepared(model, tmp_path / "run", **changes)


def test_a_signal_may_be_of_another_model_than_the_one_that_analyses_it(model, tmp_path):
    asked = []

    class Other:
        description = msgspec.structs.replace(model.description, digest="sha256:other")

        def __getattr__(self, name):
            asked.append(name)
            return getattr(model, name)

    found = event(output__folder=str(tmp_path / "run"))
    own = prepare(found, model, Folder(found.output, resume=True))
    with pytest.raises(OutputExists, match="another model"):
        prepare(found, model, Folder(found.output, resume=True), signals=Other())
    assert asked
    other = prepare(found, model, Folder(found.output, force=True), signals=Other())
    assert other.model is model
    assert other.analysis.digest == own.analysis.digest


@pytest.mark.parametrize(
    ("low", "middle", "high", "text"),
    [(1.19738, 1.19749, 1.19772, "$1.19749^{+0.00023}_{-0.00011}$"), (93.0, 253.0, 460.0, "$253^{+207}_{-160}$"),
     (-0.446, -0.371, -0.316, "$-0.371^{+0.055}_{-0.075}$")],
)  # fmt: skip
def test_intervals_have_as_many_digits_as_are_known(low, middle, high, text):
    x = np.linspace(0.0, 1.0, 100_001)
    assert interval(np.interp(x, [0.0, 0.05, 0.5, 0.95, 1.0], [low, low, middle, high, high])) == text
