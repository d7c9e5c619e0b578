"""Draws of parameters, frequency grids and the greedy choice of nodes."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.sampling_counts import main, sampling_counts, uniform_count
from bnserve_protocol import InvalidParameters
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.data.generators import CallableGenerator, mass_seconds
from bnserve_surrogate.training.data.sampling import (
    ArcsineSampling,
    EdgeSampling,
    MixtureSampling,
    ParameterRanges,
    UniformSampling,
    configured_sampling,
    draw,
)
from bnserve_surrogate.training.reduction.greedy import (
    greedy_downsampling,
    multibanded_grid,
    newtonian_duration,
    reconstruction_error,
)
from tests.surrogate.training_runs import SMOOTH, merged

RANGES = ParameterRanges()
SAMPLINGS = [UniformSampling(), ArcsineSampling(), EdgeSampling(), MixtureSampling(fraction=0.3)]
HERTZ = mass_seconds()


@pytest.mark.parametrize("sampling", SAMPLINGS, ids=lambda sampling: sampling.settings["name"])
@settings(max_examples=25, deadline=None)
@given(seed=st.integers(), purpose=st.text(max_size=10), start=st.integers(0, 10**6), more=st.integers(1, 9))
def test_a_sample_depends_on_seed_purpose_and_number_alone(sampling, seed, purpose, start, more):
    together = draw(sampling, RANGES, seed, purpose, start, start + more)
    alone = [draw(sampling, RANGES, seed, purpose, i, i + 1)[0] for i in range(start, start + more)]
    np.testing.assert_array_equal(together, alone)
    assert ((together >= RANGES.lower) & (together <= RANGES.upper)).all()


def test_samples_are_the_same_on_every_machine():
    """Reproducible data: these numbers may never change."""
    np.testing.assert_allclose(
        draw(UniformSampling(), RANGES, 1, "training", 1)[0],
        [1.8692579281529285, 0.37458889352579394, 0.22712015890889525, 280.8929218828297, 4171.816840442265],
        rtol=1e-14,
    )


def test_seeds_and_purposes_are_independent():
    sets = [draw(UniformSampling(), RANGES, seed, purpose, 500) for seed in (1, 2) for purpose in ("a", "b")]
    values = np.concatenate(sets)
    assert np.unique(values, axis=0).shape == values.shape
    correlation = np.corrcoef(np.column_stack(sets), rowvar=False) - np.eye(20)
    assert np.abs(correlation).max() < 0.2


def test_uniform_samples_fill_the_box_evenly():
    theta = draw(UniformSampling(), RANGES, 3, "x", 4000)
    scaled = (theta - RANGES.lower) / (RANGES.upper - RANGES.lower)
    for column in scaled.T:
        counts, _ = np.histogram(column, bins=10, range=(0, 1))
        assert np.abs(counts - 400).max() < 100


def test_arcsine_samples_have_the_chebyshev_density_in_stretched_coordinates():
    theta = draw(ArcsineSampling(), RANGES, 3, "x", 4000)
    stretched = [np.log(theta[:, 0]), theta[:, 1], theta[:, 3] ** 0.4]
    bounds = [np.log([1, 3]), (-0.5, 0.5), np.array([5.0, 5000.0]) ** 0.4]
    for values, (low, high) in zip(stretched, bounds, strict=True):
        angle = np.arccos(np.clip(1 - 2 * (values - low) / (high - low), -1, 1)) / np.pi
        counts, _ = np.histogram(angle, bins=10, range=(0, 1))
        assert np.abs(counts - 400).max() < 100


def test_edge_samples_have_one_to_five_parameters_at_a_bound_equally_often():
    theta = draw(EdgeSampling(), RANGES, 3, "x", 2000)
    bound = ((theta == RANGES.lower) | (theta == RANGES.upper)).sum(axis=1)
    counts = np.bincount(bound, minlength=6)
    assert counts[0] == 0
    assert np.abs(counts[1:] - 400).max() < 100
    assert (theta == RANGES.lower).any(axis=0).all()
    assert (theta == RANGES.upper).any(axis=0).all()


def test_edge_samples_without_corners_leave_one_parameter_inside():
    theta = draw(EdgeSampling(most=4), RANGES, 3, "x", 2000)
    bound = ((theta == RANGES.lower) | (theta == RANGES.upper)).sum(axis=1)
    counts = np.bincount(bound, minlength=6)
    assert counts[0] == counts[5] == 0
    assert np.abs(counts[1:5] - 500).max() < 100
    assert EdgeSampling(most=4).settings != EdgeSampling().settings
    with pytest.raises(InvalidParameters, match="Between 1 and 5"):
        EdgeSampling(most=6)


def test_a_mixture_takes_its_fraction_from_the_first_density():
    mixture = MixtureSampling(first=EdgeSampling(), second=UniformSampling(), fraction=0.25)
    theta = draw(mixture, RANGES, 3, "x", 2000)
    on_edge = ((theta == RANGES.lower) | (theta == RANGES.upper)).any(axis=1)
    assert 0.2 < on_edge.mean() < 0.3
    for fraction, expected in ((0.0, UniformSampling()), (1.0, ArcsineSampling())):
        np.testing.assert_array_equal(
            draw(MixtureSampling(fraction=fraction), RANGES, 3, "x", 50), draw(expected, RANGES, 3, "x", 50)
        )


def test_bad_ranges_and_names_are_refused():
    for wrong in (
        {"mass_ratio": (0.5, 2)},
        {"chi": (0.5, -0.5)},
        {"tidal_deformability": (5, np.inf)},
        {"chi": (0, 2)},
    ):
        with pytest.raises(InvalidParameters, match=next(iter(wrong))):
            ParameterRanges(**wrong)
    for fraction in (-0.1, 1.1):
        with pytest.raises(InvalidParameters, match="fraction"):
            MixtureSampling(fraction=fraction)


@pytest.mark.parametrize(
    ("section", "expected"),
    [
        ({"sampling": "uniform"}, UniformSampling()),
        ({"sampling": "arcsine"}, ArcsineSampling()),
        ({"sampling": "mixture", "arcsine_fraction": 0.2}, MixtureSampling(fraction=0.2)),
    ],
)
def test_a_configuration_names_its_density(section, expected):
    assert configured_sampling(parse_configuration(merged(SMOOTH, {"dataset": section}))) == expected


def test_the_duration_is_the_papers_formula():
    """T = 5/256 (pi f)^(-8/3) M^(-5/3) / nu, in seconds, for 1.4 + 1.4 solar masses from 5 Hz: 1 h 48 min."""
    seconds = newtonian_duration(5.0 * HERTZ, 1.0) * HERTZ
    assert seconds == pytest.approx(5 / 256 * (np.pi * 5) ** (-8 / 3) * HERTZ ** (-5 / 3) / 0.25)
    assert 6000 < seconds < 7000


def test_the_multibanded_spacing_is_the_inverse_of_the_duration_below_the_pivot_and_uniform_above():
    grid = multibanded_grid(5.0 * HERTZ, 2048.0 * HERTZ, 2.0)
    assert grid[0] == 5.0 * HERTZ
    assert grid[-1] == 2048.0 * HERTZ
    spacing, middle = np.diff(grid), 0.5 * (grid[1:] + grid[:-1])
    below = middle < 39.9 * HERTZ
    expected = np.array([1 / newtonian_duration(f, 2.0) for f in middle])
    np.testing.assert_allclose(spacing[below], expected[below], rtol=1e-3)
    above = middle > 40.1 * HERTZ
    np.testing.assert_allclose(spacing[above][:-1], 1 / newtonian_duration(40.0 * HERTZ, 2.0), rtol=1e-9)
    assert 0.0 < spacing[-1] <= 1.01 * spacing[-2]


def test_point_counts_have_the_papers_orders_of_magnitude_and_scalings():
    def counts(f_min, mass_ratio=2.0):
        band = f_min * HERTZ, 2926.0 * HERTZ
        return uniform_count(*band, mass_ratio), multibanded_grid(*band, mass_ratio).size

    uniform, multibanded = counts(5.0)
    assert 1e7 < uniform < 4e7
    assert 0.5e5 < multibanded < 4e5
    assert counts(2.5)[0] / uniform == pytest.approx(2 ** (8 / 3), rel=1e-5)
    chirping = [size - counts(40.0)[1] for size in (counts(0.5)[1], counts(0.25)[1])]
    assert chirping[1] / chirping[0] == pytest.approx(2 ** (5 / 3), rel=1e-2)
    assert counts(5.0, 3.0)[1] > multibanded


@settings(max_examples=30, deadline=None)
@given(
    low=st.floats(1.0, 200.0),
    ratio=st.floats(1.001, 100.0),
    mass_ratio=st.floats(1.0, 5.0),
)
def test_multibanded_grids_are_increasing_and_end_where_asked(low, ratio, mass_ratio):
    grid = multibanded_grid(low * HERTZ, low * ratio * HERTZ, mass_ratio)
    assert (np.diff(grid) > 0).all()
    assert (grid[0], grid[-1]) == (low * HERTZ, low * ratio * HERTZ)


def chirps(count, points=4001):
    x = np.geomspace(1.0, 50.0, points)
    rates = np.linspace(0.5, 1.5, count)[:, None]
    return x, rates * x ** (-5 / 3) * 100 + np.sin(rates * x / 5)


def test_greedy_nodes_reconstruct_every_waveform_within_the_tolerance():
    x, values = chirps(20)
    before = values.copy()
    chosen = greedy_downsampling(x, values, tolerance=1e-5)
    assert (np.diff(chosen) > 0).all()
    assert chosen[[0, -1]].tolist() == [0, x.size - 1]
    assert chosen.size < x.size / 10
    assert reconstruction_error(x, values, chosen).max() <= 1e-5
    np.testing.assert_array_equal(values, before)
    np.testing.assert_array_equal(greedy_downsampling(x, values, tolerance=1e-5), chosen)


def test_a_tighter_tolerance_needs_more_nodes_and_a_cubic_needs_four():
    x, values = chirps(4)
    sizes = [greedy_downsampling(x, values, tolerance).size for tolerance in (1e-2, 1e-4, 1e-6)]
    assert sizes == sorted(set(sizes))
    assert greedy_downsampling(x, (x / 50) ** 3).size <= 5


def test_noise_needs_the_whole_grid():
    x, _ = chirps(1, points=200)
    noise = np.random.default_rng(0).normal(size=(1, 200))
    assert greedy_downsampling(x, noise).size > 150
    with pytest.raises(ValueError, match="increasing"):
        greedy_downsampling(x[::-1], noise)


def test_residuals_need_fewer_points_than_waveforms_and_those_fewer_than_grids():
    def toy(theta, mf):
        change = theta[0] * (mf / 0.02) ** 2
        amplitude = taylorf2_amplitude(mf, *theta[:3, None])[0] * np.exp(-0.1 * change)
        return amplitude, taylorf2_phase(mf, *theta[:, None])[0] + change + 3000.0 * mf

    counts = sampling_counts(CallableGenerator(toy), RANGES, f_min=20.0, f_max=1000.0, waveforms=3, n_jobs=1).table
    assert counts["uniform"] > counts["multibanded"] > 10 * counts["greedy_waveform_amplitude"]
    assert counts["greedy_waveform_amplitude"] > counts["greedy_residual_amplitude"] >= 2
    assert counts["greedy_waveform_phase"] > counts["greedy_residual_phase"] >= 2


def test_the_benchmark_prints_the_four_counts(capsys):
    pytest.importorskip("EOBRun_module")
    assert main(["--waveforms", "2", "--f-min", "30", "--json", "--jobs", "1"]) == 0
    measured = json.loads(capsys.readouterr().out)
    assert measured["setup"]["waveforms"] == 2
    assert measured["counts"]["multibanded"] > measured["counts"]["greedy_waveform_phase"] > 10
