"""How far spins have to be followed, and what is said where that is too far."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS, FieldError, Mode, OutOfBand, ParameterBatch
from bnserve_surrogate.precession._layout import BEND, LAST, MOST_STEPS, RADIANS

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
_TURN = 2.0 * np.pi / RADIANS
"""Steps in a turn of the faster spin."""


def steps_between(
    batch: ParameterBatch, reference_frequency: float, frequencies: Floats, modes: Sequence[Mode]
) -> Integers:
    """How many steps lead from the reference frequency to where the ends of a grid need directions.

    Parameters
    ----------
    batch
        N binaries.
    reference_frequency
        Hz.
    frequencies
        Increasing, in Hz, at least one.
    modes
        At least one; mode m passes f when the (2, 2) mode passes 2 f / m.

    Returns
    -------
    ``(N, 2)``: towards the merger and away from it, at least one each.
    """
    orders = [order for _, order in modes]
    mass = batch["total_mass"] * (np.pi * SOLAR_MASS_SECONDS)
    scale = RADIANS / (5.0 / 96.0 * (2.0 + 1.5 * batch["mass_ratio"]))

    def place(frequency: float) -> Floats:
        y = np.maximum(1.0 / (mass * frequency), LAST)
        return np.asarray((y + np.sqrt(y * (y + (4.0 * BEND) * scale))) / (2.0 * scale))

    middle = place(reference_frequency)
    ahead = middle - place(2.0 * frequencies[-1] / min(orders))
    back = place(2.0 * frequencies[0] / max(orders)) - middle
    steps = np.ceil(np.clip(np.stack([ahead, back], axis=1), 0.0, 2.0**40)) + 1.0
    return steps.astype(np.int64)


def followed(batch: ParameterBatch, reference_frequency: float, steps: Integers) -> NDArray[np.bool_]:
    """Which binaries spiral in at the reference frequency, and take no more steps than there is room for, ``(N,)``."""
    early = batch["total_mass"] * (np.pi * SOLAR_MASS_SECONDS) * reference_frequency <= 1.0 / LAST
    return np.asarray(early & (steps.sum(axis=1) <= MOST_STEPS))


def refuse_unfollowed(batch: ParameterBatch, reference_frequency: float, frequencies: Floats, steps: Integers) -> None:
    """Say what is wrong with the first binary that is not :func:`followed`, if there is one.

    Raises
    ------
    OutOfBand
        There is.
    """
    wrong = ~followed(batch, reference_frequency, steps)
    if not wrong.any():
        return
    row = int(np.argmax(wrong))
    last = 1.0 / (LAST * np.pi * SOLAR_MASS_SECONDS * float(batch["total_mass"][row]))
    if reference_frequency > last:
        raise OutOfBand(
            f"Row {row}: at the reference_frequency {reference_frequency:g} Hz this binary has merged; its spins are "
            f"given where it spirals in, below {last:.4g} Hz.",
            errors=[FieldError(reason="beyond the merger", parameter="reference_frequency", row=row)],
        )
    raise OutOfBand(
        f"Row {row}: its spins turn about {steps[row].sum() / _TURN:.0f} times between the frequencies "
        f"{frequencies[0]:g} to {frequencies[-1]:g} Hz and the reference_frequency, and {MOST_STEPS / _TURN:.0f} turns "
        "are followed; begin at a higher frequency.",
        errors=[FieldError(reason="too many turns", parameter="frequencies", row=row)],
    )
