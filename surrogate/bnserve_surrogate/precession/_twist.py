"""Calling the compiled precession."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS, FieldError, InvalidRequest, Mode, OutOfBand, ParameterBatch
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace, load_assembly
from bnserve_surrogate.precession._harmonics import harmonics
from bnserve_surrogate.precession._layout import BEND, LANES, LAST, MOST_STEPS, RADIANS, Argument, scratch_size

ASSEMBLY = Path(__file__).with_name("twist.ll")
ENTRY_POINT = "bnserve_twist"

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Complex = NDArray[np.complex128]


@functools.cache
def load_twist() -> Callable[[int, int, int], int]:
    """The compiled precession, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


_workspace = Workspace(len(Argument))


def twist(
    frequencies: Floats, modes: tuple[Mode, ...], h: Complex, batch: ParameterBatch, reference_frequency: float
) -> tuple[Complex, Complex]:
    """Polarisations of binaries whose spins are not aligned, from the modes of those whose spins are.

    Parameters
    ----------
    frequencies
        Increasing, in Hz, ``(M,)``.
    modes
        The L modes, each for (l, m) and (l, -m).
    h
        They, in 1/Hz, ``(N, L, M)``: normalised and with the phase that
        :meth:`~bnserve_protocol.WaveformModel.predict_modes` gives them at this reference frequency.
    batch
        N binaries with spins in the orbital plane.
    reference_frequency
        Hz; where spins, inclination and phase are what the batch says.

    Returns
    -------
    h_plus and h_cross in 1/Hz, ``(N, M)`` each.

    Raises
    ------
    OutOfBand
        More turns of precession lie between the frequencies than are followed.
    InvalidRequest
        A mode cannot precess here, or the reference frequency is beyond the merger.
    """
    order = sorted(range(len(modes)), key=lambda k: (modes[k][1], modes[k][0]))
    if order != list(range(len(modes))):
        modes, h = tuple(modes[k] for k in order), h[:, order]
    orders = np.array([order for _, order in modes], np.int64)
    table = harmonics(modes)
    rows, points = len(batch), len(frequencies)
    plus, cross = np.empty((rows, points), np.complex128), np.empty((rows, points), np.complex128)
    if not (rows and points):
        return plus, cross
    assert batch.in_plane is not None
    steps = steps_between(batch, reference_frequency, frequencies[[0, -1]], (int(orders[0]), int(orders[-1])))
    f = np.concatenate([frequencies, np.repeat(frequencies[-1:], LANES)])
    reference, own = np.array([reference_frequency]), np.empty((LANES, 2), np.int64)
    arrays = f, orders, table, np.ascontiguousarray(h, np.complex128), batch.values, batch.in_plane, reference, steps
    at = [address_of(array) for array in arrays]
    size = scratch_size(int(steps.max(axis=0).sum()))
    if _workspace.scratch.size < size:
        _workspace.reserve(size)
    _workspace.arguments[:] = [
        rows, points, at[0], len(modes), *at[1:], address_of(own), _workspace.scratch_at, address_of(plus),
        address_of(cross),
    ]  # fmt: skip
    if load_twist()(*_workspace.addresses) != 0:
        raise RuntimeError("The precession stopped with an error.")
    return plus, cross


def steps_between(batch: ParameterBatch, reference_frequency: float, ends: Floats, orders: tuple[int, int]) -> Integers:
    """How many steps lead from the reference frequency to where the ends of a grid need directions.

    Parameters
    ----------
    batch
        N binaries.
    reference_frequency
        Hz.
    ends
        The first and the last frequency, in Hz.
    orders
        The least and the greatest m: mode m passes f when the (2, 2) mode passes 2 f / m.

    Returns
    -------
    ``(N, 2)``: towards the merger and away from it, at least one each.

    Raises
    ------
    OutOfBand, InvalidRequest
        As :func:`twist`.
    """
    mass = batch["total_mass"] * (np.pi * SOLAR_MASS_SECONDS)
    scale = RADIANS / (5.0 / 96.0 * (2.0 + 1.5 * batch["mass_ratio"]))

    def place(frequency: float) -> Floats:
        y = np.maximum(1.0 / (mass * frequency), LAST)
        return np.asarray((y + np.sqrt(y * (y + (4.0 * BEND) * scale))) / (2.0 * scale))

    beyond = mass * reference_frequency > 1.0 / LAST
    if beyond.any():
        row = int(np.argmax(beyond))
        raise InvalidRequest(
            f"Row {row}: at the reference_frequency {reference_frequency:g} Hz this binary has merged; spins are given "
            f"where it spirals in, below {1.0 / (LAST * mass[row]):.4g} Hz.",
            errors=[FieldError(reason="beyond the merger", parameter="reference_frequency", row=row)],
        )
    middle = place(reference_frequency)
    ahead = middle - place(2.0 * ends[1] / orders[0])
    back = place(2.0 * ends[0] / orders[1]) - middle
    steps = np.ceil(np.maximum(np.stack([ahead, back], axis=1), 0.0)) + 1.0
    too_many = steps.sum(axis=1) > MOST_STEPS
    if too_many.any():
        row = int(np.argmax(too_many))
        raise OutOfBand(
            f"Row {row}: its spins turn about {steps[row].sum() * RADIANS / (2.0 * np.pi):.0f} times between "
            f"{ends[0]:g} Hz, the reference_frequency and {ends[1]:g} Hz, and {MOST_STEPS * RADIANS / 6.3:.0f} turns "
            "are followed; begin at a higher frequency.",
            errors=[FieldError(reason="outside the band", parameter="frequencies", row=row)],
        )
    return steps.astype(np.int64)
