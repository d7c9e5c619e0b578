"""The time until merger, from phases whose derivative is known."""

from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import (
    AmplitudePhase,
    InvalidFrequencies,
    MergerStencil,
    ParametersWithExtrinsic,
    time_until_merger,
)

ONE = ParametersWithExtrinsic.gw170817()
CHIRP_TIME = 3.2e5
"""Seconds; times (f / Hz)**(-8/3) that is about 150 s at 18 Hz."""


class Analytic:
    """A chirp that merges at t = 0: t(f) = -CHIRP_TIME f**(-8/3), and phase = -2 pi (integral of t over f)."""

    def predict_amplitude_phase(self, frequencies, batch, *, options):
        assert options.alignment == "merger"
        phase = -2.0 * np.pi * CHIRP_TIME * 0.6 * frequencies ** (-5.0 / 3.0)
        phase = phase + batch.reference_phase + 2.0 * np.pi * frequencies * batch.time_shift
        return AmplitudePhase(amplitude=np.ones(4), phase=phase, status=np.zeros(1, np.uint8))


@pytest.mark.parametrize("frequency", [1.0, 18.0, 400.0, 1500.0])
def test_it_is_the_slope_of_the_phase(frequency):
    assert time_until_merger(Analytic(), frequency, ONE) == pytest.approx(CHIRP_TIME * frequency ** (-8 / 3), rel=1e-8)


def test_shifts_of_time_and_phase_do_not_matter():
    shifted = replace(ONE, time_shift=12.0, reference_phase=1.0)
    assert time_until_merger(Analytic(), 20.0, shifted) == time_until_merger(Analytic(), 20.0, ONE)


def test_the_stencil_asks_for_four_frequencies_around_the_one_given():
    frequencies = MergerStencil(100.0).frequencies
    assert frequencies.shape == (4,)
    assert (np.diff(frequencies) > 0).all()
    assert frequencies.mean() == pytest.approx(100.0)


@pytest.mark.parametrize("frequency", [0.0, -20.0, np.nan, np.inf, "20 Hz"])
def test_a_frequency_that_is_none_is_refused(frequency):
    with pytest.raises(InvalidFrequencies):
        time_until_merger(Analytic(), frequency, ONE)
