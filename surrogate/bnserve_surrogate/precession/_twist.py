"""Calling the compiled precession."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import Mode, ParameterBatch
from bnserve_protocol.wire import address_of, result_memory
from bnserve_surrogate.kernel import Workspace, load_assembly
from bnserve_surrogate.precession._harmonics import harmonics
from bnserve_surrogate.precession._layout import LANES, Argument, scratch_size
from bnserve_surrogate.precession._steps import refuse_unfollowed, steps_between

ASSEMBLY = Path(__file__).with_name("twist.ll")
ENTRY_POINT = "bnserve_twist"

Floats = NDArray[np.float64]
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
        More turns of precession lie between the frequencies than are followed, or spins are given beyond the merger.
    InvalidRequest
        A mode cannot precess here.
    """
    order = sorted(range(len(modes)), key=lambda k: (modes[k][1], modes[k][0]))
    if order != list(range(len(modes))):
        modes, h = tuple(modes[k] for k in order), h[:, order]
    orders = np.array([order for _, order in modes], np.int64)
    table = harmonics(modes)
    rows, points = len(batch), len(frequencies)
    plus, cross = (result_memory.empty((rows, points), "complex128") for _ in range(2))
    if not (rows and points):
        return plus, cross
    assert batch.in_plane is not None
    steps = steps_between(batch, reference_frequency, frequencies, modes)
    refuse_unfollowed(batch, reference_frequency, frequencies, steps)
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
