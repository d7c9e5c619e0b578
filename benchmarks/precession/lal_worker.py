"""LALSimulation's SpinTaylorT4: the orbit's frame when the (2, 2) mode passes given frequencies. Needs lalsuite:

    python3 -m venv "$BNSERVE_PEERS/lal" && "$BNSERVE_PEERS/lal/bin/pip" install "lalsuite>=7.26"

Run as ``python lal_worker.py QUESTION.npz ANSWER.npz`` in that environment, where bnserve is not installed. The
question has ``binaries`` (N, 12): m1 and m2 in solar masses of ``mtsun`` seconds, two spins, two quadrupoles and tidal
polarisabilities; ``reference`` and ``x`` (N, X), frequencies in Hz. The answer has ``axes`` (N, X, 2, 3): the axis x of
the orbit's frame and its z, and how long that took.
"""

from __future__ import annotations

import sys
import time
from typing import Any

import lal
import lalsimulation
import numpy as np

PIECES = ((100.0, 1.0 / 256.0), (1.0e4, 1.0 / 16384.0))
"""Up to these frequencies in Hz with these intervals in s: later, all is faster."""


def evolve(binary: Any, unit: float, reference: float) -> np.ndarray:
    """v, the orbit's z and x, in columns, from ``reference`` on until it stops."""
    m1, m2, spins, quadrupoles, tides = binary[0], binary[1], binary[2:8], binary[8:10], binary[10:12]
    masses = m1 * unit, m2 * unit
    axes: Any = (0.0, 0.0, 1.0, 1.0, 0.0, 0.0)
    start, parts = reference, []
    for end, interval in PIECES:
        series = lalsimulation.SimInspiralSpinTaylorPNEvolveOrbit(
            interval, *masses, start, end if end < 1000.0 else 0.0, *spins, *axes, *tides, *quadrupoles, -1, -1, -1, 0,
            lalsimulation.SpinTaylorT4,
        )  # fmt: skip
        values = np.array([part.data.data for part in series[-14:]])
        parts.append(values[:, :-1])
        last = values[:, -2]
        spins, axes = last[2:8], last[8:14]
        start = last[0] ** 3 / (np.pi * (masses[0] + masses[1]) / lal.MSUN_SI * lal.MTSUN_SI)
    return np.concatenate(parts, axis=1)


def main(question: str, answer: str) -> None:
    """Answer one file."""
    asked = np.load(question)
    unit = lal.MSUN_SI * float(asked["mtsun"]) / lal.MTSUN_SI
    begin, found = time.perf_counter(), []
    for binary, x in zip(asked["binaries"], asked["x"], strict=True):
        orbit = evolve(binary, unit, float(asked["reference"]))
        rising = np.concatenate([[True], np.diff(np.maximum.accumulate(orbit[0])) > 0.0])
        orbit = orbit[:, rising]
        v = np.cbrt(np.pi * x * (binary[0] + binary[1]) * float(asked["mtsun"]))
        at = [np.interp(v, orbit[0], row) for row in orbit[8:14]]
        found.append([np.stack(at[3:], axis=-1), np.stack(at[:3], axis=-1)])
    np.savez(answer, axes=np.moveaxis(np.array(found), 1, 2), seconds=time.perf_counter() - begin)


if __name__ == "__main__":
    main(*sys.argv[1:])
