"""Modes beside (2, 2), as their ratios to it: nearly constant, where their own phases run through 1e5 radians.

Mode m has the frequency m x / 2 at the moment at which (2, 2) has the frequency x, so that

.. math:: h_{lm}(m x / 2) = A_{22}(x) \\, e^{-i (m/2) \\psi_{22}(x)} \\, v^{p} R_{lm}(x),
          \\qquad v = (\\pi M x)^{1/3}

with the leading post-Newtonian power p of the mode. R is complex and smooth, where the amplitude of an odd mode
changes its sign, too.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.data.generators import FloatArray, WaveformGenerator
from bnserve_surrogate.training.errors import GeneratorFailure

Mode: TypeAlias = tuple[int, int]
LEADING_POWERS: Mapping[Mode, int] = MappingProxyType(
    {(2, 1): 1, (3, 3): 1, (3, 1): 1, (4, 4): 2, (3, 2): 2, (4, 3): 3}
)
"""Powers of v by which a mode's amplitude begins above that of (2, 2) (arXiv:0802.1249, eqs. (9.3)-(9.4))."""
Waveforms: TypeAlias = tuple[FloatArray, FloatArray, NDArray[np.complex128]]


@dataclass(frozen=True)
class ModeNodes:
    """Which modes beside (2, 2), and the M x (n_m,) at which their ratios are kept."""

    modes: tuple[Mode, ...]
    mx: FloatArray

    @property
    def shape(self) -> tuple[int, int]:
        """Of the ratios of one waveform."""
        return len(self.modes), self.mx.size

    @property
    def description(self) -> dict[str, Any]:
        """For the digest of a data set; nothing without modes."""
        if not self.modes:
            return {}
        nodes = hashlib.sha256(np.ascontiguousarray(self.mx, dtype="<f8").tobytes()).hexdigest()
        return {"modes": [list(mode) for mode in self.modes], "mode_nodes": nodes}


NO_MODES = ModeNodes((), np.empty(0))


def with_modes(generator: WaveformGenerator, theta: FloatArray, mf: FloatArray, nodes: ModeNodes) -> Waveforms:
    """All modes of one binary ``theta`` (5,): (2, 2) at ``mf``, which holds ``nodes.mx``, and the others' ratios.

    Returns
    -------
    Amplitude and psi of (2, 2), (n,) each, and the ratios, (L, n_m).

    Raises
    ------
    GeneratorFailure
        The generator has no modes.
    """
    if not nodes.modes:
        return *generator(theta, mf), np.empty(nodes.shape, complex)
    modes = getattr(generator, "modes", None)
    if modes is None:
        raise GeneratorFailure(f"{generator.name} gives the (2, 2) mode alone; leave [modes] out.")
    found = modes(theta, {(2, 2): mf, **{mode: 0.5 * mode[1] * nodes.mx for mode in nodes.modes}})
    amplitude, psi = found[2, 2]
    place = np.searchsorted(mf, nodes.mx)
    v = np.cbrt(np.pi * nodes.mx)
    ratios = np.empty(nodes.shape, complex)
    for row, mode in enumerate(nodes.modes):
        size, own = found[mode]
        turned = np.exp(-1j * (own - 0.5 * mode[1] * psi[place]))
        ratios[row] = size / amplitude[place] / v ** LEADING_POWERS[mode] * turned
    return amplitude, psi, ratios
