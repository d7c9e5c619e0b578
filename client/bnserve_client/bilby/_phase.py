"""A draw of the orbital phase that was integrated over, where modes of several m count."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np
from bilby.core.prior import Interped
from numpy.typing import NDArray

from bnserve_client._chosen import local_part
from bnserve_protocol import Analysis, Likelihood, Mode, WaveformModel

Floats = NDArray[np.float64]

_STEPS = 8192
"""Of a turn: a tenth of how well the phase of a signal with a ratio of 1000 is known."""


def with_the_phase(model: WaveformModel, bound: Likelihood) -> Likelihood:
    """The same likelihood with the phase as a parameter; its analysis is another one, and uploaded, too."""
    analysis = bound.analysis
    other = Analysis(msgspec.structs.replace(analysis.settings, phase_marginalisation=False), analysis.arrays)
    found: Likelihood
    if hasattr(model, "likelihood"):  # of a service
        found = model.likelihood(other)
    else:
        found = local_part("analyses", "Evaluating a likelihood here").likelihood(model, other)
    return found


def draw_phase(log_likelihoods: Callable[[Floats], Floats], modes: tuple[Mode, ...]) -> Any:
    """A phase between 0 and 2 pi by its posterior, from its log-likelihoods at a few phases, ``(K,)`` of ``(K,)``.

    As a function of the phase ln L is a polynomial of exp(i phase), of the largest m: a few values are all of it.
    """
    count = 2 * max(order for _, order in modes) + 1
    values = log_likelihoods(2.0 * np.pi * np.arange(count) / count)
    whole = np.fft.irfft(np.fft.rfft(values), n=_STEPS) * (_STEPS / count)
    whole = np.append(whole, whole[0])
    return Interped(np.linspace(0.0, 2.0 * np.pi, _STEPS + 1), np.exp(whole - whole.max())).sample()
