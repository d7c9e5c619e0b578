"""Ratios of the other modes to (2, 2): what they are, kept and resumed with the rest of a data set."""

import numpy as np
import pytest

from bnserve_surrogate.training.data.chunks import evaluate_modes
from bnserve_surrogate.training.data.dataset import DatasetSpecification, build_dataset
from bnserve_surrogate.training.data.generators import CallableGenerator, TEOBResumSPA
from bnserve_surrogate.training.data.modes import LEADING_POWERS, NO_MODES, ModeNodes
from bnserve_surrogate.training.data.sampling import ParameterRanges, UniformSampling
from bnserve_surrogate.training.errors import GeneratorFailure
from tests.surrogate.smooth_waveforms import waveform

MX = np.geomspace(2e-4, 0.03, 24)
SOME = ModeNodes(((3, 3), (2, 1), (4, 4)), MX)
EVERY = ModeNodes(tuple(LEADING_POWERS), MX)


def swapped(theta):
    q, chi_1, chi_2, lambda_1, lambda_2 = theta
    return np.array([q, chi_2, chi_1, lambda_2, lambda_1])


def test_a_ratio_restores_its_mode():
    generator, theta = TEOBResumSPA(first_mf=1.5e-4), np.array([1.7, 0.2, -0.1, 400.0, 600.0])
    amplitude, psi, ratios = evaluate_modes(generator, theta, MX, SOME)
    for (degree, order), ratio in zip(SOME.modes, ratios, strict=True):
        size, own = generator.modes(theta, {(degree, order): 0.5 * order * MX})[degree, order]
        v = np.cbrt(np.pi * MX) ** LEADING_POWERS[degree, order]
        restored = amplitude * np.exp(-0.5j * order * psi) * v * ratio
        np.testing.assert_allclose(restored, size * np.exp(-1j * own), rtol=1e-9)


def test_ratios_are_nearly_constant_in_the_inspiral():
    """Half a per cent while v doubles: the leading power is off, and nothing of 1e5 radians is left."""
    generator = TEOBResumSPA(first_mf=1.5e-4)
    ratios = evaluate_modes(
        generator, np.array([1.7, 0.0, 0.0, 400.0, 600.0]), MX[:10], ModeNodes(EVERY.modes, MX[:10])
    )[2]
    assert np.abs(ratios / ratios[:, :1] - 1.0).max() < 0.05


def test_equal_stars_exchanged_have_odd_modes_of_the_other_sign():
    generator, theta = TEOBResumSPA(first_mf=1.5e-4), np.array([1.0, 0.3, -0.2, 300.0, 2000.0])
    ours, theirs = (evaluate_modes(generator, t, MX, EVERY)[2] for t in (theta, swapped(theta)))
    for mode, first, second in zip(EVERY.modes, ours, theirs, strict=True):
        np.testing.assert_allclose(first, (-1) ** mode[1] * second, atol=1e-4 * np.abs(first).max())


@pytest.mark.parametrize("spin", [-0.5, 0.0, 0.5])
@pytest.mark.parametrize("tides", [(1.5, 5000.0), (400.0, 400.0)])
def test_equal_stars_with_equal_spins_have_no_noise_for_odd_modes(spin, tides):
    ratios = evaluate_modes(TEOBResumSPA(first_mf=1.5e-4), np.array([1.0, spin, spin, *tides]), MX, EVERY)[2]
    assert np.abs(ratios).max() < 2.0


def test_a_generator_without_modes_says_so():
    with pytest.raises(GeneratorFailure, match=r"\(2, 2\) mode alone; leave \[modes\] out"):
        evaluate_modes(CallableGenerator(waveform), np.array([1.2, 0.0, 0.0, 400.0, 600.0]), MX, SOME)


def test_modes_are_kept_with_the_data_set_and_belong_to_its_digest(tmp_path):
    def made(modes):
        return DatasetSpecification(
            TEOBResumSPA(first_mf=1.5e-4), ParameterRanges(), UniformSampling(), 1, "modes", MX, MX, 2, modes
        )

    options = {"n_jobs": 1, "backend": "sequential", "progress": False}
    first = build_dataset(made(SOME), 3, tmp_path, **options)
    again = build_dataset(made(SOME), 3, tmp_path, **options)
    assert first.ratios.shape == (3, 3, 24)
    assert first.subset(np.array([0, 2])).ratios.shape == (2, 3, 24)
    np.testing.assert_array_equal(first.ratios, again.ratios)
    assert len({made(modes).digest for modes in (SOME, EVERY, NO_MODES)}) == 3
