"""What a construction has measured, as plain values, and as text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from bnserve_inference.roq._config import RoqConfiguration
from bnserve_inference.roq._family import Family
from bnserve_inference.roq._growth import Growth
from bnserve_inference.roq._interpolant import FloatArray, Term
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature
from bnserve_inference.roq._sampling import Draws
from bnserve_inference.roq._validation import ValidationTask, full_grid_errors, on_grid, summary

VALIDATIONS = {"validation": "fresh", "edges": "edge"}
"""Names of the two validations, and what their binaries are called."""
_FULL_GRID_SAMPLE = 12
_STAGE = 14
"""Part of the key of its draws."""


def growth_figures(configuration: RoqConfiguration, term: Term, growth: Growth) -> dict[str, Any]:
    """The history of one basis: tolerances, errors of the pre-selection, sweeps of the cycles."""
    names = ("cycle", "elements", "outliers", "worst")
    return {
        "tolerance": getattr(configuration, term).tolerance,
        "preselection_errors": growth.preselection_errors.tolist(),
        "sweeps": [dict(zip(names, [int(c), int(n), int(o), float(w)], strict=True)) for c, n, o, w in growth.sweeps],
    }


def validation_figures(configuration: RoqConfiguration, errors: FloatArray) -> dict[str, dict[str, float]]:
    """Outliers and quantiles of the validation errors ``(2, N)``, by term."""
    limit = configuration.validation.limit
    return {
        "linear": summary(errors[0], configuration.linear.tolerance, limit),
        "quadratic": summary(errors[1], configuration.quadratic.tolerance, limit),
    }


def full_grid_figures(
    configuration: RoqConfiguration, quadrature: ReducedOrderQuadrature, family: Family
) -> dict[str, float]:
    """By how much errors on the thinned grid differ from those on the full grid, relative to the tolerance; by term."""
    draws = Draws(family.prior, _FULL_GRID_SAMPLE, (configuration.seed, _STAGE))
    task = ValidationTask(family, draws, on_grid(family, quadrature.linear), on_grid(family, quadrature.quadratic))
    thinned, model = task(0), family.source.model
    terms: tuple[Term, Term] = ("linear", "quadratic")
    found: dict[str, float] = {}
    for errors, term in zip(thinned, terms, strict=True):
        exact = full_grid_errors(quadrature, model, draws.chunk(0), term)
        found[term] = float(np.abs(errors - exact).max() / getattr(configuration, term).tolerance)
    return found


def describe(quadrature: ReducedOrderQuadrature) -> str:
    """A basis in a few lines of text."""
    prior = ", ".join(f"{name} {low:g} to {high:g}" for name, (low, high) in quadrature.prior.items())
    points = len(quadrature.grid)
    return "\n".join(
        [
            f"model       {quadrature.model_name} {quadrature.model_version} ({quadrature.model_digest})",
            f"modes       {', '.join(map(str, quadrature.modes))}",
            f"band        {quadrature.f_min:g} to {quadrature.f_max:g} Hz in steps of 1 / {quadrature.duration:g} s: "
            f"{points} frequencies; alignment {quadrature.alignment}",
            f"prior       {prior}",
            _term_line("linear", len(quadrature.linear_nodes), points, quadrature.diagnostics),
            _term_line("quadratic", len(quadrature.quadratic_nodes), points, quadrature.diagnostics),
            *(
                _validation_line(kind, *item)
                for kind in VALIDATIONS
                for item in quadrature.diagnostics.get(kind, {}).items()
            ),
        ]
    )


def _term_line(term: Term, elements: int, points: int, diagnostics: Mapping[str, Any]) -> str:
    line = f"{term:11} {elements} elements, {points / elements:.0f} times fewer frequencies"
    if term not in diagnostics:
        return line
    figures = diagnostics[term]
    return (
        f"{line}; tolerance {figures['tolerance']:g}, condition number {figures['condition_number']:.3g}, "
        f"Lebesgue constant {figures['lebesgue_constant']:.3g}"
    )


def _validation_line(kind: str, term: str, figures: Mapping[str, Any]) -> str:
    return (
        f"{kind:12}{term}: {figures['outliers']} of {figures['count']} {VALIDATIONS[kind]} binaries above "
        f"{figures['tolerance']:g} ({100.0 * figures['outlier_fraction']:.4f} %), {figures['above_limit']} above "
        f"{figures['limit']:g}; median {figures['median']:.2e}, 99.9 % {figures['99.9 %']:.2e}, "
        f"largest {figures['max']:.2e}"
    )
