"""Waveforms or Gram-Schmidt residuals as elements of a reduced basis: conditioning and errors, side by side.

The same selected binaries, in the same order, with five forms of the elements: waveforms (the paper's choice), one
pass of Gram-Schmidt with the coefficients conjugated (a slip that real vectors do not show), one pass of the classical
and of the modified Gram-Schmidt, and the iterated modified Gram-Schmidt. Nodes are found by the textbook algorithm,
which inverts the matrix of the elements at the nodes for every new one.

    python -m benchmarks.roq_elements configs/roq_gw170817.toml --work runs
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.roq import build_basis, read_roq_configuration
from bnserve_inference.roq._interpolant import Term, evaluate_term
from bnserve_inference.roq._interpolation import orthogonality_loss, orthonormalised, squared_norms
from bnserve_inference.roq._sampling import Prior
from bnserve_surrogate import Model

Array = NDArray[np.complex128]


def waveforms(vectors: Array) -> Array:
    """The unit vectors themselves."""
    return vectors


def conjugated_once(vectors: Array) -> Array:
    """One pass with <vector, row> where <row, vector> should be."""
    rows: list[Array] = []
    for vector in vectors:
        rest = vector
        for row in rows:
            rest = rest - np.vdot(rest, row) * row
        rows.append(rest / np.linalg.norm(rest))
    return np.array(rows)


def classical_once(vectors: Array) -> Array:
    """One pass: all projections are those of the vector as it came."""
    rows = vectors[:0]
    for vector in vectors:
        rest = vector - (rows.conj() @ vector) @ rows
        rows = np.vstack([rows, rest / np.linalg.norm(rest)])
    return rows


def modified_once(vectors: Array) -> Array:
    """One pass: each projection is that of what the ones before have left."""
    rows: list[Array] = []
    for vector in vectors:
        rest = vector
        for row in rows:
            rest = rest - np.vdot(row, rest) * row
        rows.append(rest / np.linalg.norm(rest))
    return np.array(rows)


def modified_iterated(vectors: Array) -> Array:
    """As the package does it."""
    rows = vectors[:0]
    for vector in vectors:
        rows = np.vstack([rows, orthonormalised(vector, rows)[0]])
    return rows


FORMS: dict[str, Callable[[Array], Array]] = {
    "waveforms": waveforms,
    "conjugated, one pass": conjugated_once,
    "classical, one pass": classical_once,
    "modified, one pass": modified_once,
    "modified, iterated": modified_iterated,
}


def textbook_nodes(elements: Array) -> NDArray[np.int64]:
    """Nodes by inverting the matrix anew for every element; they may repeat."""
    nodes = [int(np.argmax(np.abs(elements[0])))]
    for count in range(1, len(elements)):
        inverse = np.linalg.pinv(elements[:count, nodes].T)
        rest = elements[count] - (inverse @ elements[count, nodes]) @ elements[:count]
        nodes.append(int(np.argmax(np.abs(rest))))
    return np.array(nodes)


def main() -> None:
    """Build (or find built), compare, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("configuration", type=Path)
    parser.add_argument("--work", type=Path, default=Path("runs"))
    parser.add_argument("--fresh", type=int, default=1000, help="binaries whose errors are measured")
    options = parser.parse_args()
    configuration = read_roq_configuration(options.configuration)
    model = Model.load(configuration.model.name, configuration.model.version)
    built = build_basis(configuration, model, options.work, progress=False, say=lambda line: None)
    binaries = Prior(configuration.prior.ranges).draw(options.fresh, 31)
    print(f"{'':34}{'condition':>11}{'1 - Q Q^H':>11}{'nodes':>8}{'repeated':>10}{'median error':>14}{'max error':>11}")
    terms: tuple[Term, Term] = ("linear", "quadratic")
    for term in terms:
        growth, grid = built.growth[term], built.grid
        root = np.sqrt(grid.weights)
        fresh = evaluate_term(model, grid.frequencies, binaries, term, configuration.band.alignment)
        fresh = fresh / np.sqrt(squared_norms(fresh, grid.weights))[:, None]
        for name, form in FORMS.items():
            rows = form(growth.waveforms * root)
            elements = rows / root
            nodes = textbook_nodes(elements)
            matrix = elements[:, nodes]
            interpolant = np.linalg.pinv(matrix) @ elements
            errors = squared_norms(fresh - fresh[:, nodes] @ interpolant, grid.weights)
            loss = "" if form is waveforms else f"{orthogonality_loss(rows):.1e}"
            print(
                f"{term:10} {name:22} {np.linalg.cond(matrix):11.2e}{loss:>11}{len(set(nodes.tolist())):8d}"
                f"{len(nodes) - len(set(nodes.tolist())):10d}{np.median(errors):14.2e}{errors.max():11.2e}"
            )


if __name__ == "__main__":
    main()
