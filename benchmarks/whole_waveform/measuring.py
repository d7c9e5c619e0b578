"""Waveforms of the generator by their modes, and a model's against them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.whole_waveform.overlaps import ORDERS, Grid, Waves, maximised, mismatch
from bnserve_protocol import (
    INTRINSIC_NAMES,
    MEGAPARSEC_SECONDS,
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    ParameterBatch,
    WaveformModel,
)
from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.modes import LEADING_POWERS
from bnserve_surrogate.training.data.residuals import baseline_amplitude, baseline_phase
from bnserve_surrogate.training.reduction.metric import spline_matrix

Floats = NDArray[np.float64]
Mode = tuple[int, int]
_ROWS = 32
"""Binaries at a time; a result is kept for each such piece."""
_CARRIER: Mode = (2, 2)
_EDGE = 1.0 + 1e-9
_TAIL = 40
"""Nodes above the last one of (2, 2)."""


@dataclass(frozen=True)
class Truth:
    """The generator's modes of N binaries, where (2, 2) has the frequencies ``x`` (n,) in Hz at ``total_mass``.

    ``log_amplitude`` (N, n) is that of (2, 2), and ``residual`` its psi less the baseline's; ``ratios`` (N, n) are
    those of every mode to its carrier, which is (2, 2)'s amplitude with m / 2 times its phase.
    """

    index: NDArray[np.int64]
    theta: Floats
    x: Floats
    log_amplitude: Floats
    residual: Floats
    ratios: dict[Mode, NDArray[np.complex128]]
    total_mass: float

    @classmethod
    def of(cls, dataset: ResidualDataset, total_mass: float) -> Truth:
        """From waveforms as a training has them."""
        mf = dataset.mf_phase
        amplitude = np.array([np.log(baseline_amplitude(theta, mf)) for theta in dataset.theta])
        ratios: dict[Mode, NDArray[np.complex128]] = {_CARRIER: np.ones(dataset.psi_residual.shape, complex)}
        for place, mode in enumerate(dataset.modes.modes):
            ratios[mode] = np.cbrt(np.pi * mf) ** LEADING_POWERS[mode] * dataset.ratios[:, place]
        return cls(
            dataset.index,
            dataset.theta,
            mf / (total_mass * SOLAR_MASS_SECONDS),
            amplitude + dataset.log_amplitude_ratio,
            dataset.psi_residual,
            ratios,
            total_mass,
        ).extended()

    def extended(self) -> Truth:
        """To twice the last frequency, where m = 1 comes to the others' end.

        TEOBResumS's own tail is this exactly: (2, 2) falls as x^(-10/3), its phase is a straight line, and the ratios
        are constant (to 0.4 %, and 0.1 rad at the end).
        """
        more = np.geomspace(self.x[-1], 2.0 * self.x[-1], _TAIL + 1)[1:]
        mf, phase = more * self.total_mass * SOLAR_MASS_SECONDS, self.phase()
        slope = (phase[:, -1] - phase[:, -2]) / (self.x[-1] - self.x[-2])
        line = phase[:, -1:] + slope[:, None] * (more - self.x[-1])
        baseline = np.array([-baseline_phase(theta, mf) for theta in self.theta])
        fall = self.log_amplitude[:, -1:] - 10.0 / 3.0 * np.log(more / self.x[-1])
        return replace(
            self,
            x=np.concatenate([self.x, more]),
            log_amplitude=np.hstack([self.log_amplitude, fall]),
            residual=np.hstack([self.residual, baseline - line]),
            ratios={mode: np.hstack([own, np.repeat(own[:, -1:], _TAIL, axis=1)]) for mode, own in self.ratios.items()},
        )

    @property
    def mf(self) -> Floats:
        """Of the nodes."""
        return self.x * self.total_mass * SOLAR_MASS_SECONDS

    def phase(self) -> Floats:
        """Of (2, 2) at the nodes, (N, n)."""
        return np.array([-baseline_phase(theta, self.mf) for theta in self.theta]) - self.residual

    def rows(self, chosen: slice) -> Truth:
        """Some of the binaries."""
        columns = {name: getattr(self, name)[chosen] for name in ("index", "theta", "log_amplitude", "residual")}
        return replace(self, **columns, ratios={mode: own[chosen] for mode, own in self.ratios.items()})


def ratios_of_model(model: WaveformModel, truth: Truth, modes: Sequence[Mode]) -> dict[Mode, NDArray[np.complex128]]:
    """A model's modes over the generator's carriers, as :attr:`Truth.ratios`; aligned at the merger."""
    columns = dict(zip(INTRINSIC_NAMES, truth.theta.T, strict=True))
    batch = ParameterBatch.coerce({**columns, "distance_mpc": 1.0, "inclination": 0.0, "total_mass": truth.total_mass})
    q = batch["mass_ratio"]
    unit = q / (1.0 + q) ** 2 * (truth.total_mass * SOLAR_MASS_SECONDS) ** 2 / MEGAPARSEC_SECONDS
    amplitude, phase = unit[:, None] * np.exp(truth.log_amplitude), truth.phase()
    found = {}
    for mode in modes:
        options = EvaluationOptions(alignment="merger", modes=(mode,))
        h = np.asarray(model.predict_modes(0.5 * mode[1] * truth.x, batch, options=options).h)[:, 0]
        found[mode] = h / amplitude * np.exp(-0.5j * mode[1] * phase)
    return found


class Carriers:
    """(2, 2)'s amplitude with m / 2 times its phase for every m, on the grid, and splines of what it is times."""

    def __init__(self, grid: Grid, truth: Truth) -> None:
        self._matrices, self._inside, self._carriers = [], [], []
        mass = truth.total_mass * SOLAR_MASS_SECONDS
        for order in ORDERS:
            half = 0.5 * order
            known = half * truth.x <= grid.f[-1] * _EDGE  # a model has nothing above its band
            inside = (grid.f >= half * truth.x[0]) & (grid.f <= half * truth.x[known][-1])
            x = grid.f[inside] / half
            matrix = spline_matrix(np.log(truth.x[known]), np.log(x))
            size = np.exp(truth.log_amplitude[:, known] @ matrix.T) * grid.root[inside]
            turn = np.zeros((len(truth.theta), len(x)))
            seen = grid.window[inside] > 0.0  # elsewhere the phase drops out
            baseline = [baseline_phase(theta, x[seen] * mass) for theta in truth.theta]
            turn[:, seen] = -half * (np.array(baseline) + truth.residual[:, known] @ matrix[seen].T)
            self._matrices.append((known, matrix))
            self._inside.append(inside)
            self._carriers.append(size * np.exp(1j * turn))
        self._shape = len(ORDERS), len(truth.theta), len(grid.f)

    def waves(self, ratios: dict[Mode, NDArray[np.complex128]], counts: dict[Mode, NDArray[np.complex128]]) -> Waves:
        """Modes times what each counts, (N,), summed for every m."""
        found = np.zeros(self._shape, complex)
        for place, order in enumerate(ORDERS):
            own = [mode for mode in ratios if mode[1] == order and mode in counts]
            if own:
                known, matrix = self._matrices[place]
                before = sum(counts[mode][:, None] * ratios[mode][:, known] for mode in own)
                found[place][:, self._inside[place]] = self._carriers[place] * (before @ matrix.T)
        return found


def harmonic(degree: int, order: int, inclination: Floats) -> Floats:
    """The spherical harmonic of spin weight -2 at azimuth zero, by Wigner's sum (Goldberg et al. 1967)."""
    factorial, cosine, sine = math.factorial, np.cos(0.5 * inclination), np.sin(0.5 * inclination)
    root = math.sqrt(math.prod(map(factorial, (degree + order, degree - order, degree + 2, degree - 2))))
    total = np.zeros_like(cosine)
    for k in range(max(0, order - 2), min(degree + order, degree - 2) + 1):
        below = math.prod(map(factorial, (degree + order - k, degree - 2 - k, k, k + 2 - order)))
        powers = cosine ** (2 * degree + order - 2 - 2 * k) * sine ** (2 * k + 2 - order)
        total += (-1) ** k * root / below * powers
    return total * math.sqrt((2 * degree + 1) / (4.0 * math.pi))


def counts_of(modes: Sequence[Mode], inclination: Floats, polarisation: Floats) -> dict[Mode, NDArray[np.complex128]]:
    """cos(2 psi) plus_lm + sin(2 psi) cross_lm, (N,) for every mode: of a detector that sees the source overhead."""
    found, unit = {}, math.sqrt(4.0 * math.pi / 5.0)
    for degree, order in modes:
        up, down = harmonic(degree, order, inclination), (-1) ** degree * harmonic(degree, -order, inclination)
        plus, cross = unit * (up + down), -1j * unit * (up - down)
        found[degree, order] = np.cos(2.0 * polarisation) * plus + np.sin(2.0 * polarisation) * cross
    return found


def orientations(index: NDArray[np.int64], seed: int) -> tuple[Floats, Floats]:
    """Inclination, uniform on the sphere, and polarisation angle of each binary by its number."""
    drawn = np.random.default_rng(seed).random((int(index.max()) + 1, 2))[index]
    return np.arccos(1.0 - 2.0 * drawn[:, 0]), np.pi * drawn[:, 1]


def estimates(model: WaveformModel, truth: Truth, inclination: Floats) -> Floats:
    """What the model says of its mismatch at these inclinations, (N,); NaN where it says nothing."""
    columns = dict(zip(INTRINSIC_NAMES, truth.theta.T, strict=True))
    batch = {**columns, "distance_mpc": 1.0, "inclination": inclination, "total_mass": truth.total_mass}
    found = model.predict_batch([100.0], batch, options=EvaluationOptions(alignment="merger")).estimated_mismatch
    return np.full(len(truth.theta), np.nan) if found is None else np.asarray(found)


def measure(model: WaveformModel, truth: Truth, grid: Grid, seed: int, folder: Path) -> dict[str, Floats]:
    """Mismatches of every binary, (N,) each; pieces that are in the folder are not measured again.

    ``maximised`` over time and orbital phase, which are ``time`` and ``phase``; ``aligned`` at the merger, nothing
    maximised; ``carrier``, of (2, 2) alone; ``without``: the loss of a waveform that has (2, 2) alone and is perfect.
    """
    folder.mkdir(parents=True, exist_ok=True)
    pieces = []
    for start in range(0, len(truth.theta), _ROWS):
        path = folder / f"{start:05d}.npz"
        if not path.exists():
            found = _measured(model, truth.rows(slice(start, start + _ROWS)), grid, seed)
            temporary = path.with_suffix(".tmp")
            with temporary.open("wb") as file:
                np.savez(file, allow_pickle=False, **found)
            temporary.replace(path)
        with np.load(path, allow_pickle=False) as archive:
            pieces.append(dict(archive))
    return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


def _measured(model: WaveformModel, truth: Truth, grid: Grid, seed: int) -> dict[str, Floats]:
    modes = list(truth.ratios)
    inclination, polarisation = orientations(truth.index, seed)
    counts = counts_of(modes, inclination, polarisation)
    carriers, ours = Carriers(grid, truth), ratios_of_model(model, truth, modes)
    a, b = carriers.waves(truth.ratios, counts), carriers.waves(ours, counts)
    alone = {_CARRIER: np.ones(len(truth.theta), complex)}
    one = [carriers.waves(ratios, alone) for ratios in (truth.ratios, ours)]
    best = maximised(grid, a, b)
    return {
        "inclination": inclination,
        "mass_ratio": truth.theta[:, 0],
        "maximised": best.mismatch,
        "time": best.time,
        "phase": best.phase,
        "aligned": mismatch(grid, a, b),
        "carrier": maximised(grid, *one).mismatch,
        "without": maximised(grid, a, carriers.waves(truth.ratios, {_CARRIER: counts[_CARRIER]})).mismatch,
        "estimate": estimates(model, truth, inclination),
    }
