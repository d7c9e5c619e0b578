"""What LAL, and the programs around it (bilby, PyCBC, GWFish), mean by modes and by the phase of the orbit.

Where the lighter star is named first, the stars change places and nothing else does: LAL's models of the frequency
domain (IMRPhenomXHM, IMRPhenomXPHM) have the same waveform then, odd modes included, so that the phase is that of the
heavier star, and x points to it where spins are in the orbital plane.
"""

from __future__ import annotations

import operator
from collections.abc import Iterable, Mapping
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_client._harmonics import mode_factors
from bnserve_protocol import (
    EvaluationOptions,
    InvalidRequest,
    Mode,
    ModelDescription,
    WaveformModel,
    chosen_modes,
    turn_to_reference,
)

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

QUADRUPOLE: tuple[Mode, ...] = ((2, 2),)


class ByModes(NamedTuple):
    """N binaries by their L modes on M frequencies: ``h`` complex ``(N, L, M)``, ``status`` ``(N,)``."""

    modes: tuple[Mode, ...]
    h: Complex
    status: NDArray[np.uint8]


def read_mode_array(modes: Iterable[Any] | None) -> tuple[Mode, ...] | None:
    """A ``mode_array`` as the modes of ours that it stands for; None, as programs leave it, for all of the model.

    (l, -m) and (l, m) are one here, as symmetry has them.

    Raises
    ------
    InvalidRequest
        It holds what is no mode.
    """
    if modes is None:
        return None
    try:
        found = dict.fromkeys((operator.index(degree), abs(operator.index(order))) for degree, order in modes)
    except (TypeError, ValueError):
        raise InvalidRequest(f"'mode_array' is a list of pairs such as [[2, 2], [3, 3]]; got {modes!r:.80}.") from None
    return EvaluationOptions(modes=tuple(found)).modes


def modes_of(description: ModelDescription, modes: Iterable[Mode] | None) -> tuple[Mode, ...]:
    """The chosen modes of a model; all of it where None are chosen.

    Raises
    ------
    InvalidRequest
        The model lacks one; names those that there are.
    """
    known = tuple((int(degree), int(order)) for degree, order in description.modes)
    return chosen_modes(EvaluationOptions(modes=modes), known)  # type: ignore[arg-type]  # becomes a tuple


def is_single(description: ModelDescription) -> bool:
    """Whether a model has the (2, 2) mode alone: it has no half turns of the orbit, and may be of an older server."""
    return modes_of(description, None) == QUADRUPOLE


def by_modes(
    model: WaveformModel,
    frequencies: Floats,
    columns: Mapping[str, Any],
    modes: tuple[Mode, ...],
    reference: float,
    name: str,
    *,
    out_of_domain: Literal["error", "flag"] = "flag",
) -> ByModes:
    """Binaries by their modes, at 1 Mpc, with the merger at time zero.

    The orbital phase at the reference frequency is zero where the model has several modes; a single (2, 2) has the
    phase that the model gives it, for :func:`phase_of_the_orbit` to be asked.

    Parameters
    ----------
    frequencies
        Hz, ``(M,)``.
    columns
        Mass ratio, total mass, aligned spins and tides.
    reference, name
        Hz, and what the program calls it.

    Raises
    ------
    InvalidRequest
        There is no strain at the reference frequency.
    """
    batch = {**columns, "distance_mpc": 1.0, "inclination": 0.0}
    if is_single(model.description):
        one = model.predict_factored(
            frequencies, batch, options=EvaluationOptions(alignment="merger", out_of_domain=out_of_domain)
        )
        return ByModes(modes, np.asarray(one.h, dtype=np.complex128)[:, np.newaxis], one.status)
    check_reference(model.description, columns["total_mass"], reference, name)
    options = EvaluationOptions(
        alignment="merger", out_of_domain=out_of_domain, modes=modes, reference_frequency=reference
    )
    found = model.predict_modes(frequencies, batch, options=options)
    return ByModes(found.modes, np.asarray(found.h, dtype=np.complex128), found.status)


def turned(found: Complex, modes: tuple[Mode, ...], phase: Any, time: Any, frequencies: Floats) -> Complex:
    """Modes ``(..., L, M)``: the (2, 2) is turned by a phase (radians), shifted in time (seconds), and all with it."""
    orders = np.array([order for _, order in modes])
    found = found * np.exp(0.5j * orders * np.asarray(phase)[..., np.newaxis])[..., np.newaxis]
    if np.any(time):
        found *= np.exp(2j * np.pi * np.asarray(time)[..., np.newaxis, np.newaxis] * frequencies)
    return found


def polarisation_factors(modes: tuple[Mode, ...], inclination: float, phase: float) -> dict[str, Complex]:
    """``plus`` and ``cross``, ``(L,)``: what each mode counts at an orbital phase (radians)."""
    turn = np.exp(1j * phase * np.array([order for _, order in modes]))
    plus, cross = mode_factors(modes, inclination)
    return {"plus": np.multiply(plus, turn, dtype=np.complex128), "cross": cross * turn}


def check_reference(description: ModelDescription, total_mass: Any, reference: float, name: str) -> None:
    """Refuse a reference frequency above the band, where a phase is a straight line and nobody's.

    Raises
    ------
    InvalidRequest
        It is above that of one of the masses (solar masses).
    """
    top = description.training_band[1] * description.reference_mass
    if np.any(reference * np.asarray(total_mass) > top):
        raise _no_strain(reference, name)


def _no_strain(reference: float, name: str) -> InvalidRequest:
    return InvalidRequest(
        f"The model's waveforms end below the '{name}' of {reference:g} Hz; take a lower one, such as 50 Hz."
    )


def orbital_turn(model: WaveformModel, columns: Mapping[str, Any], reference: float, name: str) -> Floats:
    """What is added to ``reference_phase`` for half of it to be the orbital phase at the reference frequency, ``(N,)``.

    Of a model with several modes, aligned at the merger; it counts modulo 4 pi. NaN outside of its range. Raises as
    :func:`by_modes`.
    """
    check_reference(model.description, columns["total_mass"], reference, name)
    batch = {**columns, "distance_mpc": 1.0, "inclination": 0.0}
    options = EvaluationOptions(alignment="merger", out_of_domain="flag", modes=QUADRUPOLE)
    return np.asarray(turn_to_reference(model.predict_amplitude_phase([reference], batch, options=options).phase[:, 0]))


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
        raise _no_strain(reference, name)
    return np.asarray(turn_to_reference(np.angle(strain)))
