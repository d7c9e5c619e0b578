"""Interpolation errors of binaries that the construction never saw."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from bnserve_inference._workers import Progress, Workers
from bnserve_inference.roq._errors import BasisFileInvalid
from bnserve_inference.roq._family import Family, normalised
from bnserve_inference.roq._interpolant import FloatArray, Term, WaveformInterpolant, evaluate_term
from bnserve_inference.roq._interpolation import interpolation_errors
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature
from bnserve_inference.roq._sampling import CHUNK_ROWS, Draws, Prior
from bnserve_inference.roq._storage import Checkpoints
from bnserve_protocol import ParameterBatch, WaveformModel

_LIMIT = 1e-3
"""The error that the paper found no binary to exceed."""
QUANTILES = {"median": 0.5, "99 %": 0.99, "99.9 %": 0.999}


@dataclass(frozen=True)
class ValidationTask:
    """Both errors of a chunk of draws, from one evaluation of the model."""

    family: Family
    draws: Draws
    linear: tuple[Any, Any]
    quadratic: tuple[Any, Any]

    def __call__(self, chunk: int) -> FloatArray:
        """``(2, N)``: linear, quadratic; ``linear`` and ``quadratic`` are pairs of interpolant and nodes."""
        return self.errors(self.draws.chunk(chunk))

    def errors(self, binaries: ParameterBatch) -> FloatArray:
        """The same for any binaries."""
        weights = self.family.grid.weights
        strain = normalised(self.family.raw(binaries), weights)
        power = normalised(np.square(np.abs(strain)), weights)
        return np.array(
            [
                interpolation_errors(strain, *self.linear, weights),
                interpolation_errors(power, *self.quadratic, weights),
            ]
        )


def validate(
    family: Family,
    quadrature: ReducedOrderQuadrature,
    draws: Draws,
    workers: Workers,
    checkpoints: Checkpoints,
    name: str,
    progress: Progress,
) -> FloatArray:
    """Errors of both interpolants for all draws, ``(2, N)``: linear, quadratic; squared norms.

    Parameters
    ----------
    family
        The linear one, on the thinned grid.
    checkpoints, name
        Where to keep them and to go on from, and under what name.
    """
    task = ValidationTask(family, draws, on_grid(family, quadrature.linear), on_grid(family, quadrature.quadratic))
    errors = np.zeros((2, draws.count))
    kept = checkpoints.find(name) or {"errors": errors[:, :0]}
    begin = kept["errors"].shape[1] // CHUNK_ROWS
    done = min(begin * CHUNK_ROWS, draws.count)
    errors[:, :done] = kept["errors"][:, :done]
    with progress.bar(draws.count, name, done) as show:
        for more in workers.map(task, range(begin, draws.chunks)):
            errors[:, done : done + more.shape[1]] = more
            done += more.shape[1]
            checkpoints.keep(name, {"errors": errors[:, :done]}, force=done == draws.count)
            show(done, f"worst of the last {more[0].max():.1e}, {more[1].max():.1e}")
    return errors


def on_grid(family: Family, interpolant: Any) -> tuple[Any, Any]:
    """An interpolant on the thinned grid, ``(n, M)``, and where its nodes are in it, ``(n,)``.

    Evaluated from binaries and coefficients, as users of the compact file will.
    """
    assert isinstance(interpolant, WaveformInterpolant)
    frequencies = family.grid.frequencies
    elements = evaluate_term(family.source.model, frequencies, interpolant.binaries, interpolant.term, family.alignment)
    return interpolant.coefficients.T @ elements, np.searchsorted(frequencies, interpolant.nodes)


def full_grid_errors(
    quadrature: ReducedOrderQuadrature, model: WaveformModel, binaries: ParameterBatch, term: Term
) -> FloatArray:
    """Interpolation errors summed over the full grid instead of the thinned one, ``(N,)``."""
    interpolant = quadrature.linear if term == "linear" else quadrature.quadratic
    at_nodes = evaluate_term(model, interpolant.nodes, binaries, term, quadrature.alignment)
    frequencies = quadrature.grid.frequencies()
    missed, whole = np.zeros(len(binaries)), np.zeros(len(binaries))
    for place, rows in interpolant.chunks(model, quadrature.grid, quadrature.alignment):
        values = evaluate_term(model, frequencies[place], binaries, term, quadrature.alignment)
        missed += np.square(np.abs(values - at_nodes @ rows)).sum(axis=1)
        whole += np.square(np.abs(values)).sum(axis=1)
    return missed / whole


def validate_basis(
    quadrature: ReducedOrderQuadrature, model: WaveformModel, count: int = 64, seed: int = 2024
) -> dict[Term, dict[str, float]]:
    """Interpolation errors of fresh uniform draws from the basis' prior, summed over the full grid.

    Parameters
    ----------
    count
        Binaries; each takes some 20 ms for GW170817.
    seed
        Of the draws.

    Returns
    -------
    For each term, ``summary`` of the errors against the tolerance that the basis was built for.

    Raises
    ------
    BasisMismatch
        Another model.
    BasisFileInvalid
        A basis without a prior or tolerances, as from another program's file.
    """
    quadrature.check_model(model)
    terms: tuple[Term, Term] = ("linear", "quadratic")
    if not quadrature.prior or not set(terms) <= set(quadrature.diagnostics):
        raise BasisFileInvalid("This basis does not say what prior and tolerance it is for; only compact ones do.")
    found: dict[Term, dict[str, float]] = {}
    for term in terms:
        draws = Draws(Prior(quadrature.prior), count, (seed,))
        pieces = [full_grid_errors(quadrature, model, draws.chunk(number), term) for number in range(draws.chunks)]
        found[term] = summary(np.concatenate(pieces), quadrature.diagnostics[term]["tolerance"], _LIMIT)
    return found


def summary(errors: FloatArray, tolerance: float, limit: float) -> dict[str, float]:
    """What is reported of errors ``(N,)``."""
    return {
        "count": len(errors),
        "tolerance": tolerance,
        "outliers": int(np.count_nonzero(errors > tolerance)),
        "outlier_fraction": float(np.mean(errors > tolerance)),
        "limit": limit,
        "above_limit": int(np.count_nonzero(errors > limit)),
        "max": float(errors.max()),
        **{name: float(np.quantile(errors, level)) for name, level in QUANTILES.items()},
    }
