"""A run's parts: likelihoods in threads, what is kept of the choice of a likelihood, and the data that are shown."""

import numpy as np
import pytest

from bnserve_inference import DetectorData, detector_strain
from bnserve_posterior.report._figures import last_seconds, whitened
from bnserve_posterior.running import Folder, prepare
from bnserve_posterior.running._threads import in_threads
from bnserve_protocol import LikelihoodParameters
from bnserve_surrogate import Model
from tests.posterior.networks import event


@pytest.fixture(scope="module")
def model():
    return Model.default()


def prepared(model, folder, **changes):
    found = event(output__folder=str(folder), **changes)
    return prepare(found, model, Folder(found.output, resume=True))


@pytest.mark.parametrize("count", [1, 127, 1000])
def test_values_do_not_depend_on_how_many_threads_evaluate_them(model, tmp_path, count):
    run = prepared(model, tmp_path / "run")
    u = np.random.default_rng(1).random((count, len(run.cube)))
    with in_threads(run.bound.log_likelihood, 3) as evaluate:
        assert (run.log_likelihood(u, evaluate) == run.log_likelihood(u)).all()


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
    run = prepared(model, tmp_path / "run", likelihood__response="static", likelihood__error_bound=bound)
    assert any("Leave out 'response'" in doubt for doubt in run.doubts) == doubtful
    assert run.static_error is not None


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
