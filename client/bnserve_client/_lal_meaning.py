"""What LAL, and the programs around it (bilby, PyCBC), mean by modes and by the phase of the orbit."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import InvalidRequest

Floats = NDArray[np.float64]

_AT_REFERENCE = 1.25 * np.pi
"""-exp(i pi / 4): the sign of LAL's polarisations, and the quarter of pi of the stationary phase."""


def refuse_other_modes(modes: Iterable[tuple[int, int]] | None) -> None:
    """Refuse a ``mode_array`` of anything but the (2, 2) mode.

    Raises
    ------
    InvalidRequest
        It asks for other modes than the model's.
    """
    if modes is not None and {(abs(l), abs(m)) for l, m in modes} != {(2, 2)}:  # noqa: E741  (the field's letter)
        raise InvalidRequest(f"The model has the (2, 2) mode alone; 'mode_array' asks for {modes}. Leave it out.")


def phase_of_the_orbit(strain: NDArray[np.complexfloating[Any, Any]], reference: float, name: str) -> Floats:
    """By how much a waveform is turned for its orbital phase to be zero at the reference frequency, in radians.

    In the stationary-phase approximation the (2, 2) mode is ``-exp(i pi / 4) exp(2 i phase)`` times a positive number
    there, as in LAL's TaylorF2 and IMRPhenomX models.

    Parameters
    ----------
    strain
        The mode at the reference frequency.
    reference
        That frequency in Hz.
    name
        What the program calls it.

    Raises
    ------
    InvalidRequest
        There is no strain at the reference frequency.
    """
    if (strain == 0.0).any():
        raise InvalidRequest(
            f"The model's waveforms end below the '{name}' of {reference:g} Hz; take a lower one, such as 50 Hz."
        )
    return np.asarray(_AT_REFERENCE - np.angle(strain))
