"""The interface of a waveform generator and the conventions that every implementation converts to."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import INTRINSIC_NAMES, SOLAR_MASS_SECONDS, PackageMissing
from bnserve_surrogate.training.errors import GeneratorFailure, TrainingError

FloatArray: TypeAlias = NDArray[np.float64]
AmplitudePhasePair: TypeAlias = tuple[FloatArray, FloatArray]

REFERENCE_MASS = 2.8
"""Total mass in solar masses at which frequencies in Hz are quoted during training."""


def mass_seconds(total_mass: float = REFERENCE_MASS) -> float:
    """G M / c^3 in seconds for a total mass in solar masses: M f = f in Hz times this."""
    return total_mass * SOLAR_MASS_SECONDS


class WaveformGenerator(Protocol):
    """A source of frequency-domain (2, 2) waveforms.

    An instance is called as ``generator(theta, mf)`` with ``theta`` of shape (5,), ordered as
    :data:`bnserve_protocol.INTRINSIC_NAMES`, and increasing dimensionless frequencies ``mf`` = G M f / c^3 of shape
    (n,). It returns (amplitude, psi), both (n,) float64, where in LALSimulation's convention h_plus = amplitude
    exp(-i psi):

    * amplitude is the baseline's A: the modulus of h_plus of a face-on binary in units of nu M**2 / D_L (G = c =
    1), with
      nu the symmetric mass ratio; about 20 at M f = 0.02;
    * psi is continuous over ``mf`` with the sign of TaylorF2 (leading term + 3 / (128 nu) v**-5), in radians. The time
      and phase of reference are the generator's own, and continuous functions of ``theta``, since they are learnt: a
      number modulo 2 pi is not one. A generator whose signal has phase zero when it passes a frequency, that is psi - f
      dpsi/df = 0 there, says so by an attribute ``phase_start``, this M f;
    * what it gives at a frequency does not depend on the other frequencies asked for.

    A generator that has no waveforms in a part of parameter space may have ``check_box(lower, upper)``, which raises
    for a box of corners (5,) that reaches into it.

    It raises :class:`GeneratorFailure` when it has no waveform for ``theta``; the run then goes on without it.
    Instances travel to worker processes, so they must be picklable by cloudpickle, and the same arguments must give
    the same bits.
    """

    @property
    def name(self) -> str:
        """Identifies the waveform model."""

    @property
    def version(self) -> str:
        """Version of the code behind it."""

    @property
    def settings(self) -> Mapping[str, str | float | None]:
        """Everything else that changes the waveforms; part of the digest of a data set."""

    def __call__(self, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
        """Amplitude and psi at ``mf``, each of shape (n,)."""


def evaluate(generator: WaveformGenerator, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
    """One waveform, checked: right shapes, finite, positive amplitude.

    Raises
    ------
    GeneratorFailure
        From the generator, or because what it returned cannot be used.
    """
    try:
        amplitude, psi = generator(theta, mf)
        amplitude, psi = np.asarray(amplitude, dtype=np.float64), np.asarray(psi, dtype=np.float64)
    except (TrainingError, PackageMissing):
        raise
    except Exception as error:
        raise GeneratorFailure(f"{generator.name} raised {type(error).__name__}: {error}") from error
    if amplitude.shape != mf.shape or psi.shape != mf.shape:
        raise GeneratorFailure(
            f"{generator.name} returned arrays of shapes {amplitude.shape} and {psi.shape} for {mf.size} frequencies."
        )
    for label, bad in (
        ("amplitude is not a finite number", ~np.isfinite(amplitude)),
        ("phase is not a finite number", ~np.isfinite(psi)),
        ("amplitude is not positive", amplitude <= 0.0),
    ):
        if bad.any():
            first = float(mf[np.argmax(bad)])
            raise GeneratorFailure(
                f"{generator.name}: the {label} at {int(bad.sum())} of {mf.size} frequencies, first M f = {first:.6g}."
            )
    return amplitude, psi


def describe_theta(theta: FloatArray) -> str:
    """``mass_ratio=1.2, chi_1=...`` for messages."""
    return ", ".join(f"{name}={value:.8g}" for name, value in zip(INTRINSIC_NAMES, theta, strict=True))
