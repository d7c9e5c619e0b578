"""Mismatches of waveforms that precess, over time and orbital phase, and their distribution."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import minimize

from benchmarks.precession.draws import REFERENCE
from benchmarks.precession.judges import ORDERS

F = np.geomspace(1.025 * REFERENCE, 2048.0, 1200)
"""Hz: just above where both judges begin, whose first step is not to be trusted."""
QUANTILES = {"median": 0.5, "90 %": 0.9, "99 %": 0.99, "max": 1.0}
Orders = dict[int, np.ndarray]


def weights(psd: Any) -> np.ndarray:
    """4 df / S_n on :data:`F`."""
    return np.asarray(4.0 * np.gradient(F) / psd(F))


def cut(orders: Orders) -> Orders:
    """Without the part of mode m below m / 2 of the start, which TEOBResumS leaves out."""
    return {m: np.where(0.5 * m * F[0] <= F, h, 0.0) for m, h in orders.items()}


def observed(plus: np.ndarray, cross: np.ndarray, psi: float) -> np.ndarray:
    """F_plus h_plus + F_cross h_cross of a detector that sees the source overhead."""
    return np.asarray(np.cos(2.0 * psi) * plus + np.sin(2.0 * psi) * cross)


def mismatch(one: Orders, other: np.ndarray, weight: np.ndarray, line: tuple[float, float]) -> float:
    """1 - the largest overlap, over a time and an orbital phase by which the modes of ``one`` are moved.

    Parameters
    ----------
    one
        By order m, complex ``(M,)``.
    other
        Complex ``(M,)``.
    weight
        ``(M,)``.
    line
        Where to begin: radians per Hz, and radians of the (2, 2) mode, by which its phase exceeds that of ``one``.
    """
    moved = {m: one[m] * np.exp(1j * (line[0] * F + 0.5 * m * line[1])) for m in ORDERS}
    scale = np.sqrt(np.sum(weight * np.abs(other) ** 2))

    def loss(place: np.ndarray) -> float:
        # milliseconds, and orbital phase
        h = sum(moved[m] * np.exp(1j * (2e-3 * np.pi * F * place[0] + m * place[1])) for m in ORDERS)
        norm = np.sqrt(np.sum(weight * np.abs(h) ** 2))
        return float(1.0 - np.sum(weight * (other.conj() * h).real) / (norm * scale))

    starts = [np.array([0.0, turn]) for turn in np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)]
    begin = min(starts, key=loss)
    settings = {"xatol": 1e-7, "fatol": 1e-13, "maxiter": 400}
    simplex = np.array([begin, begin + np.array([0.02, 0.0]), begin + np.array([0.0, 0.02])])
    return float(minimize(loss, begin, method="Nelder-Mead", options=settings | {"initial_simplex": simplex}).fun)


def fitted_line(phase: np.ndarray, weight: np.ndarray) -> tuple[float, float]:
    """Slope and constant of a phase over :data:`F`."""
    slope, constant = np.polyfit(F, phase, 1, w=np.sqrt(weight))
    return float(slope), float(constant)


def distribution(values: np.ndarray) -> dict[str, float]:
    """The quantiles that are told."""
    if not len(values):
        return {}
    return {name: float(np.quantile(values, level)) for name, level in QUANTILES.items()}
