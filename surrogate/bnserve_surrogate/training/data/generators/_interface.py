"""The interface of a waveform generator and the conventions that every implementation converts to."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol, TypeAlias

from bnserve_protocol import INTRINSIC_NAMES
from bnserve_surrogate.training.data.residuals import FloatArray

AmplitudePhasePair: TypeAlias = tuple[FloatArray, FloatArray]


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


def describe_theta(theta: FloatArray) -> str:
    """``mass_ratio=1.2, chi_1=...`` for messages."""
    return ", ".join(f"{name}={value:.8g}" for name, value in zip(INTRINSIC_NAMES, theta, strict=True))
