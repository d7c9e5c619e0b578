"""A reduced-order quadrature for binaries close to the signal of the network, made in the plainest way."""

import numpy as np

from bnserve_inference._calibration import calibration_splines
from bnserve_inference.roq import ReducedOrderQuadrature, TabulatedInterpolant
from bnserve_protocol import EvaluationOptions, LikelihoodBatch, UniformGrid
from tests.inference.networks import DURATION, F_MAX, F_MIN, TRUTH, columns

WIDTH = 0.3
"""Of the box, as of ``columns``."""
CHIRP_MASS = TRUTH.total_mass * (TRUTH.mass_ratio / (1.0 + TRUTH.mass_ratio) ** 2) ** 0.6
RANGES = {
    "chirp_mass": (CHIRP_MASS * (1.0 - 1e-4 * WIDTH), CHIRP_MASS * (1.0 + 1e-4 * WIDTH)),
    **{
        name: (getattr(TRUTH, name) - WIDTH * half, getattr(TRUTH, name) + WIDTH * half)
        for name, half in {
            "mass_ratio": 0.1,
            "lambda_1": 200.0,
            "lambda_2": 200.0,
            "chi_1": 0.01,
            "chi_2": 0.01,
        }.items()
    },
}


def linear_basis(basis, model=None):
    """All linear rows of a basis, (n, len(grid))."""
    return np.concatenate([piece for _, piece in basis.linear_chunks(model)], axis=1)


def quadratic_basis(basis, model=None):
    """All quadratic rows of a basis, (n, len(grid))."""
    return np.concatenate([piece for _, piece in basis.quadratic_chunks(model)], axis=1)


def interpolant(term, rows, frequencies):
    """An interpolant of the family that ``rows`` span, by pivoting: nodes and rows as any construction gives them."""
    basis = np.linalg.svd(rows / np.linalg.norm(rows, axis=1)[:, None], full_matrices=False)
    kept = basis[2][basis[1] > 1e-9 * basis[1][0]]
    remainder, nodes = kept.copy(), []
    for index in range(len(kept)):
        nodes.append(int(np.argmax(np.abs(remainder[index]))))
        pivot = remainder[index] / remainder[index, nodes[-1]]
        remainder -= np.outer(remainder[:, nodes[-1]], pivot)
    nodes = sorted(nodes)
    table = np.linalg.solve(kept[:, nodes], kept)
    return TabulatedInterpolant.in_order(term, frequencies[nodes], table, rows=True)


def made_basis(model, calibration=None, **changes):
    """For the binaries of :data:`RANGES`; also under errors at the nodes of a ``calibration``, of 0.03."""
    grid = UniformGrid(f_min=F_MIN, f_max=F_MAX, delta_f=1.0 / DURATION)
    batch = LikelihoodBatch.coerce(columns(160, seed=8, width=WIDTH)).waveform_batch(distance_mpc=100.0)
    strain = model.predict_factored(grid, batch, options=EvaluationOptions(alignment="merger")).h
    frequencies = grid.frequencies()
    if calibration is not None:
        # Calibration errors multiply the waveform: a basis that is to stand them has to have seen some.
        draw = np.random.default_rng(9).normal(0.0, 0.03, (2, len(strain), calibration.nodes))
        amplitude, phase = draw @ calibration_splines(calibration, frequencies)
        strain = np.concatenate([strain, strain * (1.0 + amplitude) * np.exp(1j * phase)])
    settings = {
        "linear": interpolant("linear", strain, frequencies),
        "quadratic": interpolant("quadratic", np.abs(strain) ** 2, frequencies),
        "f_min": F_MIN,
        "f_max": F_MAX,
        "duration": DURATION,
        "alignment": "merger",
        "prior": RANGES,
        "model_digest": model.description.digest,
    }
    return ReducedOrderQuadrature(**(settings | changes))
