"""The time until merger of every waveform model, and its phase above the band: the remote ones equal the local one."""

from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import EvaluationOptions, InvalidFrequencies, OutOfBand
from tests.contract.test_waveform_model import ONE, binaries, bits, failure

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")

TOP = 2048.0
"""Hz, of the band of the shipped models at 4 solar masses."""


@pytest.mark.parametrize("frequency", [10.0, 40.0, 900.0])
def test_the_time_until_merger_is_equal(model, local, frequency):
    assert model.time_until_merger(frequency, ONE) == local.time_until_merger(frequency, ONE)


@pytest.mark.parametrize("parameters", [ONE, binaries(1), binaries(40)], ids=["one", "a batch of one", "a batch"])
@pytest.mark.parametrize("frequencies", [40.0, [900.0, 20.0, 20.0, 20.01]], ids=["one frequency", "many"])
def test_times_until_merger_are_equal_in_bits(model, local, frequencies, parameters):
    there, here = (one.time_until_merger(frequencies, parameters) for one in (model, local))
    assert type(there) is type(here)
    assert np.shape(there) == (() if parameters is ONE else (len(parameters),)) + np.shape(frequencies)
    assert np.asarray(there).tobytes() == np.asarray(here).tobytes()


def test_times_until_merger_are_one_request(remote, monkeypatch):
    asked = []
    send = remote._connections.send
    monkeypatch.setattr(remote._connections, "send", lambda sent: asked.append(sent) or send(sent))
    assert remote.time_until_merger(np.geomspace(20.0, 1000.0, 10), binaries(100)).shape == (100, 10)
    assert len(asked) == 1


@pytest.mark.parametrize("fraction", [0.998, 0.9985, 0.9999, 1.0])
def test_the_time_until_merger_at_the_top_of_the_band_is_equal(model, local, fraction):
    heavy = replace(ONE, total_mass=4.0)
    there = model.time_until_merger(fraction * TOP, heavy)
    assert there == local.time_until_merger(fraction * TOP, heavy)
    assert there == pytest.approx(1e-4, rel=0.02)  # a tenth of a millisecond before the merger


def test_the_time_until_merger_from_above_the_band_is_the_same_error(model, local):
    heavy = replace(ONE, total_mass=4.0)
    there = failure(lambda: model.time_until_merger(1.001 * TOP, heavy))
    assert there == failure(lambda: local.time_until_merger(1.001 * TOP, heavy))
    assert there[0] is OutOfBand
    there = failure(lambda: model.time_until_merger([20.0, 1.001 * TOP], [ONE, ONE, heavy]))
    assert there == failure(lambda: local.time_until_merger([20.0, 1.001 * TOP], [ONE, ONE, heavy]))
    assert "Row 2: 2050.05 Hz is above" in there[2]


def test_a_difference_of_the_phase_does_not_see_the_top_of_the_band(model, local):
    """The phase goes on as the line with the slope at the top; the amplitude says where that is."""
    heavy = replace(ONE, total_mass=4.0, time_shift=0.0)
    f = np.linspace(TOP - 50.0, TOP + 450.0, 1001)
    options = EvaluationOptions(alignment="merger")
    there = model.predict_amplitude_phase(f, heavy, options=options)
    assert bits(there) == bits(local.predict_amplitude_phase(f, heavy, options=options))
    np.testing.assert_array_equal(there.amplitude > 0.0, f <= TOP)
    seconds = np.gradient(there.phase, f) / (2.0 * np.pi)
    at_top = model.time_until_merger(TOP, heavy)
    np.testing.assert_allclose(seconds, at_top, rtol=0.01)
    np.testing.assert_allclose(seconds[f > TOP + 1.0], at_top, rtol=1e-6)


@pytest.mark.parametrize("frequency", [3000.0, 1e6])
def test_the_time_until_merger_from_far_above_the_band_is_the_same_error(model, local, frequency):
    there = failure(lambda: model.time_until_merger(frequency, ONE))
    assert there == failure(lambda: local.time_until_merger(frequency, ONE))
    assert there[0] is OutOfBand


@pytest.mark.parametrize("frequency", [-1.0, 0.0, np.nan])
def test_the_time_until_merger_from_nowhere_is_the_same_error(model, local, frequency):
    there = failure(lambda: model.time_until_merger(frequency, ONE))
    assert there == failure(lambda: local.time_until_merger(frequency, ONE))
    assert there[0] is InvalidFrequencies
