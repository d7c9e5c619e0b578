"""What measures whole waveforms: the match of sums of modes, maximised over time and orbital phase."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize

from benchmarks.whole_waveform.measuring import Truth, counts_of, measure, orientations
from benchmarks.whole_waveform.overlaps import ORDERS, Grid, maximised, mismatch
from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate.training.data.residuals import baseline_amplitude, baseline_phase
from tests.surrogate.other_codes import MODES, harmonics

BAND = (20.0, 1000.0)
SIZES = {1: 0.01, 2: 1.0, 3: 0.05, 4: 0.01}
"""Of the modes of each m; about those of neutron stars."""


@pytest.fixture(scope="module")
def grid():
    return Grid.of(BAND, "ET-D", 2.8, 3.0)


def chirps(grid, f=None, root=None):
    """Newtonian chirps of every m for one binary, ``(4, 1, K)``, by the square root of the weights."""
    f, root = (grid.f, grid.root) if f is None else (f, root)
    chirp = 2.8 * SOLAR_MASS_SECONDS * 0.25**0.6
    waves = []
    for order in ORDERS:
        x = 2.0 * f / order
        phase = -0.5 * order * 3.0 / 128.0 * (np.pi * chirp * x) ** (-5.0 / 3.0)
        waves.append(SIZES[order] * (f / 100.0) ** (-7.0 / 6.0) * np.exp(1j * phase) * root)
    return np.array(waves)[:, None]


def test_products_of_different_orders_are_those_of_a_grid_that_follows_them_everywhere(grid):
    f = np.linspace(*BAND, 4_000_001)
    table = Grid.of(BAND, "ET-D", 2.8, 3.0)
    density = np.interp(f, table.f, (table.root**2 / np.gradient(table.f)).clip(0.0))
    exact = chirps(grid, f, np.sqrt(density * (f[1] - f[0])))
    ours = chirps(grid)
    norm = float(grid.product(ours, ours)[0])
    for one in range(4):
        for other in range(one):
            alone = np.zeros_like(ours), np.zeros_like(ours)
            alone[0][one], alone[1][other] = ours[one], ours[other]
            expected = np.vdot(exact[one], exact[other]).real
            assert float(grid.product(*alone)[0]) == pytest.approx(expected, abs=2e-5 * norm)


def test_a_waveform_that_is_moved_and_turned_is_found_where_it_is(grid):
    a = np.repeat(chirps(grid), 3, axis=1)
    time, phase = np.array([0.0, 2e-6, -1e-5]), np.array([0.0, -1e-3, 0.2])
    best = maximised(grid, a, 1.3 * grid.turned(a, time, phase))
    assert (best.mismatch < 1e-12).all()
    np.testing.assert_allclose(best.time, -time, atol=1e-11)
    np.testing.assert_allclose(best.phase, -phase, atol=1e-7)


def test_half_a_turn_of_the_orbit_is_no_turn_of_the_wave(grid):
    """The orders that are odd know the difference; the best is found from another phase."""
    a = chirps(grid)
    turned = grid.turned(a, np.zeros(1), np.array([np.pi]))
    assert mismatch(grid, a, turned)[0] > 1e-3
    assert maximised(grid, a, turned).mismatch[0] < 1e-12
    alone = np.where(np.array(ORDERS)[:, None, None] == 2, a, 0.0)
    assert mismatch(grid, alone, grid.turned(alone, np.zeros(1), np.array([np.pi])))[0] < 1e-12


@pytest.mark.parametrize("size", [1e-5, 1e-3, 0.1])
def test_the_maximum_is_that_of_a_search_over_both(grid, size):
    a = chirps(grid)
    draw = np.random.default_rng(3)
    error = 1.0 + size * np.array([np.interp(grid.f, np.linspace(*BAND, 9), draw.normal(size=9)) for _ in ORDERS])
    b = a * (error * np.exp(1j * (error - 1.0)))[:, None]
    best = maximised(grid, a, b)

    def other(at):
        return float(mismatch(grid, a, grid.turned(b, np.array([1e-5 * at[0]]), np.array([at[1]])))[0])

    found = minimize(other, [0.0, 0.0], method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 0.0, "maxiter": 400})
    assert best.mismatch[0] == pytest.approx(found.fun, rel=1e-3)
    assert best.mismatch[0] < mismatch(grid, a, b)[0]


@pytest.mark.parametrize("inclination", [0.3, 1.6, 2.7])
def test_modes_count_by_lals_harmonics(inclination):
    counts = counts_of(MODES, np.array([inclination]), np.array([0.4]))
    for mode, (plus, cross) in harmonics(inclination).items():
        np.testing.assert_allclose(counts[mode], np.cos(0.8) * plus + np.sin(0.8) * cross, atol=1e-13)


@pytest.fixture(scope="module")
def truth():
    """Baselines in place of the generator's (2, 2), with constant ratios."""
    theta = np.array([[1.3, 0.1, -0.1, 400.0, 600.0], [2.6, 0.3, 0.0, 100.0, 900.0], [2.0, -0.2, 0.2, 900.0, 300.0]])
    x = np.geomspace(8.0, 1000.0, 200)
    mf = x * 2.8 * SOLAR_MASS_SECONDS
    ratios = {mode: np.full((3, 200), 1.0 if mode == (2, 2) else 0.03 * np.exp(0.2j * mode[0])) for mode in MODES}
    amplitude = np.log([baseline_amplitude(row, mf) for row in theta])
    return Truth(np.arange(3), theta, x, amplitude, np.zeros((3, 200)), ratios, 2.8)


class Perturbed:
    """The truth as a model that makes an error in one mode, comes too early and is turned."""

    def __init__(self, truth, mode, error, time=0.0, phase=0.0):
        self.truth, self.mode, self.error, self.time, self.phase = truth, mode, error, time, phase

    def predict_modes(self, f, batch, options):
        mode, rows = options.modes[0], [self.truth.theta[:, 0].tolist().index(q) for q in batch["mass_ratio"]]
        q, mass = self.truth.theta[rows, 0], 2.8 * SOLAR_MASS_SECONDS
        mf = 2.0 * np.asarray(f) / mode[1] * mass
        psi = np.array([baseline_phase(row, mf) for row in self.truth.theta[rows]])
        unit = (q / (1.0 + q) ** 2)[:, None] * mass**2 / MEGAPARSEC_SECONDS
        h = unit * np.exp(self.truth.log_amplitude[rows]) * self.truth.ratios[mode][rows]
        turn = 0.5 * mode[1] * (self.phase - psi) + 2.0 * np.pi * np.asarray(f) * self.time
        wrong = 1.0 + self.error if mode == self.mode else 1.0
        return SimpleNamespace(h=(wrong * h * np.exp(1j * turn))[:, None])

    def predict_batch(self, f, batch, options):
        return SimpleNamespace(estimated_mismatch=None)


def test_a_model_is_measured_against_the_generator_mode_by_mode(grid, truth, tmp_path):
    """An error of a part e of a mode that has a share s of the square costs e^2 s / 2, where s is small."""
    exact = measure(Perturbed(truth, (3, 3), 0.0), truth, grid, 1, tmp_path / "exact")
    assert (exact["maximised"] < 1e-15).all()
    assert (exact["without"] > 1e-5).all()
    found = measure(Perturbed(truth, (3, 3), 1e-3, 2e-6, 1e-3), truth, grid, 1, tmp_path / "one")
    assert (found["carrier"] < 1e-14).all()
    np.testing.assert_allclose(found["time"], -2e-6, atol=2e-7)
    assert (found["aligned"] > 10.0 * found["maximised"]).all()
    inclination, polarisation = orientations(truth.index, 1)
    np.testing.assert_array_equal(found["inclination"], inclination)
    counts = counts_of(MODES, inclination, polarisation)
    share = np.abs(0.03 * counts[3, 3]) ** 2 / np.abs(counts[2, 2]) ** 2 * 1.5 ** (7.0 / 3.0)
    np.testing.assert_allclose(found["maximised"], 0.5e-6 * share, rtol=0.25)


def test_what_was_measured_is_kept(grid, truth, tmp_path):
    first = measure(Perturbed(truth, (3, 3), 1e-3), truth, grid, 1, tmp_path)
    again = measure(None, replace(truth), grid, 1, tmp_path)
    for name, values in first.items():
        np.testing.assert_array_equal(again[name], values)
