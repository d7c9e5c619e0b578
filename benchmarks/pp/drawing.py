"""The percentile-percentile plot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.figures.style import GREY, figure, talk

TITLES = {"ligo": "LIGO and Virgo, 128 s", "et": "Einstein Telescope, 8,192 s"}
Results = Sequence[Mapping[str, Any]]


def draw_percentiles(networks: Mapping[str, tuple[Results, Mapping[str, float]]], path: Path) -> None:
    """Fraction of injections whose truth lies below each fraction of the posterior, by parameter; band: 3 sigma.

    ``networks``: results and p-values of each.
    """
    with talk():
        page = figure(8.0 * len(networks), 8.0)
        for place, (network, (results, p_values)) in enumerate(networks.items()):
            axis = page.add_subplot(1, len(networks), place + 1)
            _draw(axis, results, p_values)
            axis.set(title=f"{TITLES[network]}: {len(results)} injections")
        page.savefig(path)


def _draw(axis: Any, results: Results, p_values: Mapping[str, float]) -> None:
    x, count = np.linspace(0.0, 1.0, 201), len(results)
    width = 3.0 * np.sqrt(x * (1.0 - x) / count)
    axis.fill_between(x, np.maximum(0.0, x - width), np.minimum(1.0, x + width), color=GREY, alpha=0.25, lw=0)
    for name, value in p_values.items():
        ranks = np.sort([result["ranks"][name] for result in results])
        axis.step(
            np.concatenate([[0.0], ranks, [1.0]]), np.concatenate([[0.0], np.arange(1, count + 1) / count, [1.0]]),
            where="post", lw=1.5, label=f"{name.replace('_', ' ')}  p = {value:.2f}",
        )  # fmt: skip
    axis.plot([0.0, 1.0], [0.0, 1.0], color=GREY, lw=1.0)
    axis.set(
        xlim=(0, 1), ylim=(0, 1), xlabel="fraction of the posterior below the truth", ylabel="fraction of injections"
    )
    axis.legend(fontsize=10, loc="upper left")
