"""The time until merger, from phases whose derivative is known."""

from dataclasses import replace

import numpy as np
import pytest

from bnserve_protocol import (
    AmplitudePhase,
    InvalidFrequencies,
    InvalidParameters,
    MergerStencil,
    ModelDescription,
    OutOfBand,
    ParametersWithExtrinsic,
    time_until_merger,
)

ONE = ParametersWithExtrinsic.gw170817()
CHIRP_TIME = 3.2e5
"""Seconds; times (f / Hz)**(-8/3) that is about 150 s at 18 Hz."""


TOP = 2048.0
"""Hz, of the band of a binary like ONE."""


class Analytic:
    """A chirp that merges at t = 0: t(f) = -CHIRP_TIME f**(-8/3), and phase = -2 pi (integral of t over f).

    Above the band, at M f of 2048 Hz and ONE's mass, it has nothing, or says so if asked to.
    """

    description = ModelDescription(
        name="chirp",
        version="1",
        digest="",
        modes=[(2, 2)],
        parameters=[],
        frequency_band=(1.0, TOP / 2.0),
        training_band=(1.0, 2.0 * TOP),
        reference_mass=ONE.total_mass / 2.0,
    )

    def predict_amplitude_phase(self, frequencies, batch, *, options):
        assert options.alignment == "merger"
        phase = -2.0 * np.pi * CHIRP_TIME * 0.6 * frequencies ** (-5.0 / 3.0)
        phase = phase + batch.reference_phase + 2.0 * np.pi * frequencies * batch.time_shift
        above = frequencies * batch.total_mass > TOP * ONE.total_mass * (1.0 + 1e-9)
        if options.above_band == "error" and above.any():
            raise OutOfBand("above the band")
        phase[above] = 0.0
        return AmplitudePhase(amplitude=np.where(above, 0.0, 1.0), phase=phase, status=np.zeros(1, np.uint8))


@pytest.mark.parametrize("frequency", [1.0, 18.0, 400.0, 1500.0])
def test_it_is_the_slope_of_the_phase(frequency):
    assert time_until_merger(Analytic(), frequency, ONE) == pytest.approx(CHIRP_TIME * frequency ** (-8 / 3), rel=1e-8)


@pytest.mark.parametrize("mass", [0.5, 1.0, 1.7])
@pytest.mark.parametrize("fraction", [0.99, 0.998, 0.9985, 0.999, 0.9995, 1.0])
def test_up_to_the_top_of_the_band_it_is_the_slope_of_the_phase_below(mass, fraction):
    """Whatever the mass, by which the band's top moves: the stencil does not reach over it."""
    one = replace(ONE, total_mass=mass * ONE.total_mass)
    frequency = fraction * TOP / mass
    expected = CHIRP_TIME * frequency ** (-8 / 3)
    assert time_until_merger(Analytic(), frequency, one) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("fraction", [1.0001, 1.001, 1.5])
def test_above_the_band_there_is_no_time(fraction):
    with pytest.raises(OutOfBand):
        time_until_merger(Analytic(), fraction * TOP, ONE)


def test_a_stencil_from_below_ends_at_its_frequency():
    inside, edge = (MergerStencil.within(Analytic.description, f, ONE) for f in (0.99 * TOP, TOP))
    assert not inside.from_below
    assert edge.from_below
    assert edge.frequencies[-1] == TOP
    assert (np.diff(edge.frequencies) > 0).all()


def test_a_stencil_is_for_one_binary():
    with pytest.raises(InvalidParameters):
        MergerStencil.within(Analytic.description, 100.0, [ONE, ONE])


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
