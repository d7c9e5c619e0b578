"""Where the phase and the time of a waveform are zero: a choice, which bilby leaves to each waveform model.

By itself a model of bnserve has the meanings that LAL documents: ``geocent_time`` is the merger, and ``phase`` the
orbital phase at ``reference_frequency`` (:func:`~bnserve_client._lal_meaning.phase_of_the_orbit`).

LAL's models differ: in IMRPhenomPv2_NRTidal ``phase`` does not belong to a frequency, in IMRPhenomD_NRTidalv2 the
constant is missing and the time is that of black holes, milliseconds off. Where ``waveform_approximant`` names one of
them, each waveform is shifted to that model's phase and time, so that ``phase`` and ``geocent_time`` keep the meaning
that they have in a run with it: by the two numbers with which the difference of both models' phases has the least
square, weighted as detectors on the ground see it. (In LAL's NRTidal models of the IMRPhenomX family the time depends
on the highest frequency that they are asked for, where it is below the merger's: it is always asked for here.)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import phase_of_the_orbit
from bnserve_protocol import InvalidRequest, require

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_NODES = np.geomspace(20.0, 512.0, 128)
"""Hz; the phases of two models whose mergers are 35 ms apart can still be followed from node to node."""

_LEAST_TOP = 40.0
"""Hz; less than an octave is not enough to tell a phase from a time."""


def _sensitivity() -> Floats:
    """Weights of :data:`_NODES`: of a binary's squared strain over the noise of Advanced LIGO (Ajith 2011, eq. 4.7)."""
    x = _NODES / 215.0
    noise = x**-4.14 - 5.0 * x**-2 + 111.0 * (1.0 - x**2 + 0.5 * x**4) / (1.0 + 0.5 * x**2)
    weights = _NODES ** (-4.0 / 3.0) / noise  # f^(-7/3) for equal steps in f
    return np.asarray(weights)


_WEIGHTS = _sensitivity()


@dataclass(frozen=True)
class ZeroPoints:
    """Of phase and time.

    Parameters
    ----------
    reference_frequency
        Hz.
    approximant
        The model of LAL whose zero points they are; None for those of bnserve.
    orders
        What LAL is told beside that: the post-Newtonian orders that bilby names.
    """

    reference_frequency: float
    approximant: str | None = None
    orders: tuple[tuple[str, int], ...] = ()

    def frequencies(self, top: float) -> Floats:
        """Where a waveform up to ``top`` Hz must be known to shift it, in Hz, ``(K,)``.

        Raises
        ------
        InvalidRequest
            Too low for a model of LAL.
        """
        if self.approximant is None:
            return np.array([self.reference_frequency])
        if top < _LEAST_TOP:
            raise InvalidRequest(
                f"Phase and time of LAL's {self.approximant} cannot be found from frequencies up to {top:g} Hz alone: "
                f"ask up to {_LEAST_TOP:g} Hz, or leave out 'waveform_approximant'."
            )
        return np.append(_NODES[top > _NODES], top)

    def shifts(
        self, strain: Complex, columns: dict[str, Floats], top: float, own: Floats | None = None
    ) -> tuple[Floats, Floats]:
        """Phase (radians) and time (seconds), each ``(N,)``: h exp(i phase + 2 pi i f time) has these zero points.

        Parameters
        ----------
        strain
            The (2, 2) mode of N binaries at :meth:`frequencies`, ``(N, K)``, aligned at the merger.
        own
            The phase for those of bnserve, ``(N,)``, where it is known and counts modulo 4 pi: with modes of odd m.
            Nobody knows which of two opposite orbits a model of LAL with the (2, 2) mode alone means; then it is the
            one that is nearer to our own. None: found from ``strain``, modulo 2 pi.
        columns
            The binaries, by our names, each ``(N,)``. NaN where LAL refuses one.
        top
            Hz, as for :meth:`frequencies`.

        Raises
        ------
        InvalidRequest
            The model has no strain at the reference frequency, or LAL no such waveform.
        PackageMissing
            LAL is not installed.
        """
        if self.approximant is not None:
            nodes = self.frequencies(top)
            theirs = self._of_lal(columns, nodes, np.isfinite(strain[:, 0]))
            phase, time = _least_squares(nodes, theirs * strain.conj())
            if own is not None:
                there = phase + 2.0 * np.pi * self.reference_frequency * time
                phase += 2.0 * np.pi * np.round((own - there) / (2.0 * np.pi))
            return phase, time
        if own is not None:
            return own, np.zeros(len(strain))
        phase = phase_of_the_orbit(strain[:, 0], self.reference_frequency, "reference_frequency")
        return phase, np.zeros(len(strain))

    def _of_lal(self, columns: dict[str, Floats], nodes: Floats, wanted: NDArray[np.bool_]) -> Complex:
        """The approximant's strain at the nodes, ``(N, K)``, at phase zero, seen face on; NaN where not wanted."""
        require("lalsimulation", f"Phase and time of LAL's {self.approximant} ('waveform_approximant')", "bilby")
        found = np.full((len(wanted), len(nodes)), complex(np.nan, np.nan))
        rows = np.column_stack(_ordered(columns))
        for row in np.flatnonzero(wanted):
            try:
                found[row] = self._of_one(nodes, *rows[row].tolist())
            except RuntimeError as error:  # LAL's only kind
                raise InvalidRequest(
                    f"LAL has no waveform by '{self.approximant}' with tides, or not here ({error}; it prints why): "
                    "name a model that it has as 'waveform_approximant', or leave it out."
                ) from error
        return found

    def _of_one(
        self, nodes: Floats, m1: float, m2: float, chi_1: float, chi_2: float, lambda_1: float, lambda_2: float
    ) -> Any:
        from bilby.gw.source import binary_neutron_star_frequency_sequence as sequence  # imports LAL

        found = sequence(
            nodes, mass_1=m1, mass_2=m2, luminosity_distance=1.0, theta_jn=0.0, phase=0.0,
            a_1=abs(chi_1), tilt_1=0.0 if chi_1 >= 0.0 else np.pi, phi_12=0.0,
            a_2=abs(chi_2), tilt_2=0.0 if chi_2 >= 0.0 else np.pi, phi_jl=0.0,
            lambda_1=lambda_1, lambda_2=lambda_2, frequencies=nodes, catch_waveform_errors=True,
            waveform_approximant=self.approximant, reference_frequency=self.reference_frequency, **dict(self.orders),
        )  # fmt: skip
        return np.nan if found is None else found["plus"]


def _ordered(columns: dict[str, Floats]) -> tuple[Floats, ...]:
    total, q = columns["total_mass"], columns["mass_ratio"]
    spins_and_tides = (columns[name] for name in ("chi_1", "chi_2", "lambda_1", "lambda_2"))
    return total * q / (1.0 + q), total / (1.0 + q), *spins_and_tides


def _least_squares(nodes: Floats, turn: Complex) -> tuple[Floats, Floats]:
    """The line a + 2 pi f b through the phases of ``turn``, ``(N, K)`` at the nodes; the last has no weight."""
    weights = np.append(_WEIGHTS[: len(nodes) - 1], 0.0)
    weights /= weights.sum()
    x = 2.0 * np.pi * nodes
    difference = np.unwrap(np.angle(turn), axis=1)
    middle = weights @ x
    slope = difference @ (weights * (x - middle)) / (weights @ (x - middle) ** 2)
    return difference @ weights - slope * middle, slope
