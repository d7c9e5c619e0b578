"""What building an analysis of any kind has in common."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol, get_args

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._units import real_ranges
from bnserve_protocol import (
    DEFAULT_ERROR_BOUND,
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    EvaluationOptions,
    FieldError,
    Mode,
    Response,
    TimeMarginalisation,
)

Alignment = Literal["post_newtonian", "merger"]
ResponseChoice = Literal["static", "moving", "auto"]
Ranges = Mapping[str, tuple[float, float]]


def check_response(response: str, *others: str) -> None:
    """Refuse what is no response of detectors, nor one of ``others``.

    Raises
    ------
    AnalysisInvalid
        It is something else.
    """
    known = [*get_args(Response), *others]
    if response not in known:
        raise AnalysisInvalid(
            f"'response' is one of {', '.join(known)}; got {str(response)[:40]!r}.",
            errors=[FieldError(reason="no response", parameter="response")],
        )


class Nodes(Protocol):
    """Where the model is evaluated."""

    @property
    def linear_nodes(self) -> NDArray[np.float64]:
        """Hz, increasing, ``(L,)``."""

    @property
    def quadratic_nodes(self) -> NDArray[np.float64]:
        """Hz, increasing, ``(Q,)``."""


class Basis(Nodes, Protocol):
    """What an analysis needs of a basis, such as :class:`bnserve_inference.roq.ReducedOrderQuadrature`."""

    def linear_chunks(self, model: Any) -> Iterator[tuple[slice, NDArray[np.complex128]]]:
        """Rows of h on the grid, piece by piece, ``(L, m)``."""

    def quadratic_chunks(self, model: Any) -> Iterator[tuple[slice, NDArray[np.float64]]]:
        """Rows of abs(h)**2 on the grid, piece by piece, ``(Q, m)``."""


@dataclass(frozen=True)
class LikelihoodOptions:
    """What is integrated over, and what the detectors are uncertain about.

    Parameters
    ----------
    prior
        Ranges by name outside of which the log-likelihood is -inf, in the parameters' units, to which those that carry
        another one are converted. ``coalescence_time`` is relative to the trigger;
        kinds other than the full one need it.
    phase_marginalisation
        Over a uniform prior of the reference phase.
    time_marginalisation, distance_marginalisation
        Over the priors they state; None for none.
    calibration
        The nodes of calibration envelopes, and the width of the errors; None for perfect detectors.
    error_bound
        By how much ln L may differ from that on the full grid, within 25 of its maximum. It holds for relative binning,
        and for quadratures with a calibration or from a table; a basis of the model's own waveforms has a tolerance.
    modes
        ``(l, m)`` of the modes of the signal, such as ``[(2, 2), (3, 3)]``; None for all that the model has.
    response
        ``"static"``: antenna patterns and delays are those at the coalescence. ``"moving"``: those at the time at which
        each mode passes each frequency, as signals of minutes and hours need. ``"auto"``: static where that is checked
        to be right to a part of ``error_bound``, and moving otherwise; on the full grid always moving. What an analysis
        has is ``settings.response``, and of relative binning, unless it was told to be moving, ``static_error`` says by
        how much ln L of detectors that stand still may be wrong: look at it where a signal lasts for minutes.
    reference_frequency
        Hz; where ``reference_phase`` is twice the orbital phase, as LAL's and bilby's: samples may then have bilby's
        ``phase``. None: it is added to the phase of the alignment.
    """

    prior: Ranges = field(default_factory=dict)
    phase_marginalisation: bool = False
    time_marginalisation: TimeMarginalisation | None = None
    distance_marginalisation: DistanceMarginalisation | None = None
    calibration: Calibration | None = None
    error_bound: float = DEFAULT_ERROR_BOUND
    modes: Sequence[Mode] | None = None
    response: ResponseChoice = "static"
    reference_frequency: float | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "prior", real_ranges(self.prior))
        check_response(self.response, "auto")
        chosen = EvaluationOptions(modes=self.modes, reference_frequency=self.reference_frequency)  # type: ignore[arg-type]  # lists become tuples
        object.__setattr__(self, "modes", chosen.modes)
        object.__setattr__(self, "reference_frequency", chosen.reference_frequency)
