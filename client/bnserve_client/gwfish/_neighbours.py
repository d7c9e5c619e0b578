"""The waveforms around one binary that GWFish's derivatives ask for: evaluated together, and kept."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from bnserve_client._chosen import chosen_model
from bnserve_client._lal_meaning import ByModes, by_modes, is_single, modes_of, phase_of_the_orbit, turned
from bnserve_client._lal_precession import precessing
from bnserve_protocol import InvalidParameters, Mode, WaveformModel, convert

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Binary = tuple[float, ...]

_NAMES = ("mass_ratio", "total_mass", "chi_1", "chi_2", "lambda_1", "lambda_2")
_STARS = ("mass_1", "mass_2", "a_1", "tilt_1", "a_2", "tilt_2", "lambda_1", "lambda_2")
_FACTORS = {"luminosity_distance", "theta_jn", "geocent_time", "phase", "ra", "dec", "psi", "phi_12", "phi_jl",
            "max_frequency_cutoff"}  # fmt: skip
"""What changes nothing of the modes' shapes."""
_OF_MASSES = {"chirp_mass", "chirp_mass_source", "mass_1", "mass_2", "mass_1_source", "mass_2_source"}
_EPS, _EPS_OF_MASSES = 1e-5, 1e-8
"""GWFish's defaults, from which its ``Derivative`` makes its steps."""
_LARGEST_STEP = 1e-3
"""Of the value or of one: two binaries further apart are no derivative."""
_MOST_KEPT = 64
"""Waveforms; a Fisher matrix of all parameters has about twenty, other steps than GWFish's defaults add theirs."""
_GRIDS_KEPT = 8
"""Each detector may have a grid of its own."""


class Neighbours:
    """Waveforms of one model on one grid; :func:`neighbours` keeps them.

    Parameters
    ----------
    model, modes
        What evaluates, and which of its modes.
    reference
        Hz: where the phase of the orbit is zero.
    frequencies
        Hz, ``(M,)``, increasing.
    """

    def __init__(self, model: WaveformModel, modes: tuple[Mode, ...], reference: float, frequencies: Floats) -> None:
        self.frequencies = frequencies.copy()
        self._model, self._reference = model, reference
        self.modes = modes
        self._all = np.union1d(frequencies, [reference])
        self._places = np.searchsorted(self._all, frequencies)
        self._place_of_reference = int(np.searchsorted(self._all, reference))
        self._centre: dict[str, Any] = {}
        self._steps_are_known = False
        self._known: dict[Binary, Complex] = {}

    def strain(self, given: Mapping[str, Any]) -> Complex:
        """The modes at 1 Mpc, ``(L, M)``, with the merger at zero, by GWFish's parameters.

        Raises
        ------
        OutOfDomain, InvalidParameters, ...
            As the model.
        """
        binary = _binary(given)
        if binary not in self._known:
            self._evaluate([binary, *self._with(given)])
        found = self._known.get(binary)
        if found is None:
            self._ask([binary], "error")  # raises, and says why
            raise AssertionError("a waveform that was flagged is not refused")
        return found

    def seen(self, angles: Mapping[str, float]) -> Complex:
        """Both polarisations at 1 Mpc, ``(2, M)``, of a binary that precesses; one waveform at a time.

        Parameters
        ----------
        angles
            As of :func:`~bnserve_client._lal_precession.precessing`, which raises the same.
        """
        key = tuple(angles.values())
        if key not in self._known:
            found = precessing(
                self._model, self.frequencies, angles, self.modes, self._reference, "f_ref", out_of_domain="error"
            )
            self._known[key] = np.stack([found.plus[0], found.cross[0]])
            self._forget(1)
        return self._known[key]

    def _forget(self, new: int) -> None:
        while len(self._known) > max(_MOST_KEPT, new):
            del self._known[next(iter(self._known))]

    def _with(self, given: Mapping[str, Any]) -> list[Binary]:
        """What to evaluate beside a binary that is not known: all steps, where it is one."""
        shape = {name: value for name, value in given.items() if name not in _FACTORS}
        if not _is_step(self._centre, shape):
            self._centre, self._steps_are_known = shape, False
            self._known.clear()
            return []
        if self._steps_are_known:
            return []
        self._steps_are_known = True
        return _steps(self._centre)

    def _evaluate(self, binaries: list[Binary]) -> None:
        asked = [binary for binary in dict.fromkeys(binaries) if binary not in self._known]
        found = self._ask(asked, "flag")
        turn = np.zeros(len(asked))
        if is_single(self._model.description):
            turn = phase_of_the_orbit(found.h[:, 0, self._place_of_reference], self._reference, "f_ref")
        for row, binary in enumerate(asked):
            if found.status[row] == 0:
                self._known[binary] = turned(
                    found.h[row][:, self._places], self.modes, turn[row], 0.0, self.frequencies
                )
        self._forget(len(asked))

    def _ask(self, binaries: list[Binary], out_of_domain: Literal["error", "flag"]) -> ByModes:
        columns = dict(zip(_NAMES, np.array(binaries).T, strict=True))
        return by_modes(
            self._model, self._all, columns, self.modes, self._reference, "f_ref", out_of_domain=out_of_domain
        )


def neighbours(name: str, modes: Sequence[Mode] | None, reference: float, frequencies: Floats) -> Neighbours:
    """Those of the model of this name on this grid, the same as for the call before.

    Raises
    ------
    InvalidRequest
        The model lacks a mode.
    PackageMissing, ConnectionFailed, ModelUnknown, Unauthorized, ...
        As :func:`~bnserve_client._chosen.chosen_model`.
    """
    model = chosen_model(name=name)
    chosen = modes_of(model.description, modes)
    kept = _kept(model, chosen, reference)  # type: ignore[arg-type]  # one model equals itself
    for known in kept:
        if np.array_equal(known.frequencies, frequencies):
            return known
    new = Neighbours(model, chosen, reference, frequencies)
    kept[:] = [new, *kept[: _GRIDS_KEPT - 1]]
    return new


@functools.lru_cache(maxsize=8)
def _kept(model: WaveformModel, modes: tuple[Mode, ...], reference: float) -> list[Neighbours]:
    return []


def _binary(given: Mapping[str, Any]) -> Binary:
    from GWFish.modules.auxiliary import check_and_convert_to_mass_1_mass_2

    masses = check_and_convert_to_mass_1_mass_2(dict(given))
    columns = convert({name: float(masses.get(name, 0.0)) for name in _STARS})
    return tuple(float(columns[name]) for name in _NAMES)


def _is_step(centre: Mapping[str, Any], other: Mapping[str, Any]) -> bool:
    if centre.keys() != other.keys():
        return False
    apart = [name for name in centre if centre[name] != other[name]]
    return len(apart) == 1 and all(
        abs(centre[name] - other[name]) <= _LARGEST_STEP * max(1.0, abs(centre[name])) for name in apart
    )


def _steps(centre: Mapping[str, Any]) -> list[Binary]:
    """The binaries that GWFish's ``Derivative`` asks for around one; the arithmetic is its own, bit by bit."""
    found = []
    for name, value in centre.items():
        step = _EPS_OF_MASSES * value if name in _OF_MASSES else np.maximum(_EPS, _EPS * value)
        for shifted in (value - step / 2.0, value + step / 2.0):
            try:
                binary = _binary({**centre, name: shifted})
            except InvalidParameters:
                continue  # nobody may ask for it; who does gets the error
            if all(map(math.isfinite, binary)):
                found.append(binary)
    return found
