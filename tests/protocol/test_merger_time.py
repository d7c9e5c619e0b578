"""The time until merger, from phases whose derivative is known."""

from dataclasses import replace

import numpy as np
import pytest
from astropy import units as u

from bnserve_protocol import (
    PARAMETER_NAMES,
    AmplitudePhase,
    InvalidFrequencies,
    InvalidParameters,
    MergerStencil,
    ModelDescription,
    OutOfBand,
    ParametersWithExtrinsic,
    UniformGrid,
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

    def __init__(self):
        self.asked = []

    def predict_amplitude_phase(self, frequencies, batch, *, options):
        assert options.alignment == "merger"
        assert options.modes == ((2, 2),)
        self.asked.append((len(batch), len(frequencies)))
        phase = -2.0 * np.pi * CHIRP_TIME * 0.6 * frequencies ** (-5.0 / 3.0)
        phase = phase * np.ones((len(batch), 1)) + batch["reference_phase"][:, None]
        phase += 2.0 * np.pi * frequencies * batch["time_shift"][:, None]
        above = frequencies * batch["total_mass"][:, None] > TOP * ONE.total_mass * (1.0 + 1e-9)
        phase[above] = 0.0
        return AmplitudePhase(amplitude=np.where(above, 0.0, 1.0), phase=phase, status=np.zeros(len(batch), np.uint8))


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
    with pytest.raises(OutOfBand, match=r"^Row 0: .* is above the model's band, which ends at 2048 Hz"):
        time_until_merger(Analytic(), fraction * TOP, ONE)


def test_the_binary_and_the_frequency_above_the_band_are_named():
    batch = [ONE, replace(ONE, total_mass=2.0 * ONE.total_mass), ONE]
    with pytest.raises(OutOfBand, match=r"^Row 1: 1500 Hz .* ends at 1024 Hz at total mass 5\.52 Msun") as raised:
        time_until_merger(Analytic(), [20.0, 1500.0, 900.0], batch)
    assert [(one.row, one.value) for one in raised.value.errors] == [(1, 1500.0)]


MANY = [1400.0, 20.0, 55.0, 20.0, 2040.0, 20.02]
"""Hz, in no order, one twice, two whose stencils overlap, one at the top of the band."""
MASSES = np.array([1.0, 0.7, 0.999])


@pytest.mark.parametrize("frequencies", [MANY, tuple(MANY), np.array(MANY), np.array(MANY) * u.Hz])
def test_frequencies_may_be_many_in_any_order(frequencies):
    model = Analytic()
    found = time_until_merger(model, frequencies, ONE)
    np.testing.assert_allclose(found, CHIRP_TIME * np.array(MANY) ** (-8 / 3), rtol=1e-8)
    assert len(model.asked) == 1


def test_binaries_may_be_many():
    model, batch = Analytic(), [replace(ONE, total_mass=mass * ONE.total_mass) for mass in MASSES]
    found = time_until_merger(model, MANY, batch)
    assert found.shape == (3, 6)
    np.testing.assert_allclose(found, np.tile(CHIRP_TIME * np.array(MANY) ** (-8 / 3), (3, 1)), rtol=1e-8)
    assert time_until_merger(model, 40.0, batch).shape == (3,)
    assert time_until_merger(model, [40.0], batch).shape == (3, 1)
    assert [rows for rows, _ in model.asked] == [3, 3, 3]


def test_each_number_is_that_of_its_binary_at_its_frequency():
    """Not a bit depends on what else is asked."""
    batch = [replace(ONE, total_mass=mass * ONE.total_mass, time_shift=mass) for mass in MASSES]
    together = time_until_merger(Analytic(), MANY, batch)
    alone = [[time_until_merger(Analytic(), frequency, one) for frequency in MANY] for one in batch]
    assert together.tolist() == alone
    assert isinstance(alone[0][0], float)


def test_a_batch_is_a_batch_whatever_its_size():
    columns = {name: getattr(ONE, name) for name in PARAMETER_NAMES}
    assert time_until_merger(Analytic(), 20.0, [ONE]).shape == (1,)
    assert time_until_merger(Analytic(), 20.0, columns).shape == (1,)
    assert time_until_merger(Analytic(), 20.0, []).shape == (0,)
    assert time_until_merger(Analytic(), [20.0, 30.0], []).shape == (0, 2)
    assert time_until_merger(Analytic(), UniformGrid(20.0, 30.0, 1.0), ONE).shape == (11,)


@pytest.mark.parametrize("batch", [3, "binaries", {"mass_ratio": 1.0}])
def test_what_are_no_binaries_is_refused(batch):
    with pytest.raises(InvalidParameters):
        time_until_merger(Analytic(), 20.0, batch)


def test_a_stencil_from_below_ends_at_its_frequency():
    edge = MergerStencil(TOP, from_below=True)
    assert edge.frequencies[-1] == TOP
    assert (np.diff(edge.frequencies) > 0).all()


def test_shifts_of_time_and_phase_do_not_matter():
    shifted = replace(ONE, time_shift=12.0, reference_phase=1.0)
    assert time_until_merger(Analytic(), 20.0, shifted) == time_until_merger(Analytic(), 20.0, ONE)


def test_the_stencil_asks_for_four_frequencies_around_the_one_given():
    frequencies = MergerStencil(100.0).frequencies
    assert frequencies.shape == (4,)
    assert (np.diff(frequencies) > 0).all()
    assert frequencies.mean() == pytest.approx(100.0)


@pytest.mark.parametrize("frequency", [0.0, -20.0, np.nan, np.inf, "20 Hz", [], [20.0, -1.0], [20.0, np.nan], [[20.0]]])
def test_a_frequency_that_is_none_is_refused(frequency):
    with pytest.raises(InvalidFrequencies):
        time_until_merger(Analytic(), frequency, ONE)
