"""The corner plot of a posterior."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from benchmarks.figures.style import BLUE, ORANGE, figure, talk
from benchmarks.gw170817.priors import UnitCube
from benchmarks.gw170817.sampling import Posterior, equal_weights
from benchmarks.gw170817.setting import CHIRP_MASS
from bnserve_protocol import LikelihoodBatch, LikelihoodParameters

Floats = NDArray[np.float64]
_BINS = 30


def physical(batch: LikelihoodBatch) -> dict[str, Floats]:
    """What is shown, by label: chirp mass, mass ratio, effective spin, reduced tidal parameter, inclination, sky."""
    q, total = batch["mass_ratio"], batch["total_mass"]
    heavy, light = q / (1.0 + q), 1.0 / (1.0 + q)
    tides = (heavy + 12.0 * light) * heavy**4 * batch["lambda_1"] + (light + 12.0 * heavy) * light**4 * batch[
        "lambda_2"
    ]
    return {
        f"chirp mass - {CHIRP_MASS} [$10^{{-4}} M_\\odot$]": 1e4 * (total * (heavy * light) ** 0.6 - CHIRP_MASS),
        "mass ratio": q,
        "effective spin": heavy * batch["chi_1"] + light * batch["chi_2"],
        "reduced tide": 16.0 / 13.0 * tides,
        "inclination": batch["inclination"],
        "right ascension": batch["right_ascension"],
        "declination": batch["declination"],
    }


def draw_corner(posterior: Posterior, cube: UnitCube, truth: LikelihoodParameters | None, path: Path) -> None:
    """Histograms of parameters and pairs; contours hold 50 and 90 percent; lines are the injection."""
    shown = physical(cube(posterior.points[equal_weights(posterior, 5000)]))
    true = None if truth is None else {name: float(x[0]) for name, x in physical(LikelihoodBatch.coerce(truth)).items()}
    names = list(shown)
    with talk():
        page = figure(15.0, 15.0)
        axes = page.subplots(len(names), len(names))
        for row, below in enumerate(names):
            for column, across in enumerate(names):
                axis = axes[row, column]
                axis.grid(False)
                if column > row:
                    axis.axis("off")
                    continue
                if row == column:
                    axis.hist(shown[across], bins=_BINS, histtype="step", color=BLUE, density=True)
                else:
                    _contours(axis, shown[across], shown[below])
                if true is not None:
                    axis.axvline(true[across], color=ORANGE, lw=1.2)
                    if row != column:
                        axis.axhline(true[below], color=ORANGE, lw=1.2)
                axis.set_xlabel(across if row == len(names) - 1 else "", fontsize=12)
                axis.set_ylabel(below if column == 0 and row else "", fontsize=12)
                axis.tick_params(labelsize=8, labelbottom=row == len(names) - 1, labelleft=column == 0 and row > 0)
        page.savefig(path, dpi=80)


def _contours(axis: Axes, x: Floats, y: Floats) -> None:
    counts, xs, ys = np.histogram2d(x, y, bins=_BINS)
    order = np.sort(counts.ravel())[::-1]
    held = np.cumsum(order) / order.sum()
    levels = sorted({float(order[np.searchsorted(held, part)]) for part in (0.9, 0.5)})
    middles = 0.5 * (xs[1:] + xs[:-1]), 0.5 * (ys[1:] + ys[:-1])
    axis.scatter(x, y, s=1, color=BLUE, alpha=0.08)
    axis.contour(*middles, counts.T, levels=levels, colors=BLUE, linewidths=1.2)
