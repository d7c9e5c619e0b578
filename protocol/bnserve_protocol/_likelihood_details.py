"""What a likelihood says beside its value: inner products by detector, and draws of what it integrates over."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_settings import AnalysisSettings
from bnserve_protocol._errors import FieldError, InvalidParameters, InvalidRequest
from bnserve_protocol._likelihood_batches import LikelihoodBatch
from bnserve_protocol._likelihood_parameters import LIKELIHOOD_NAMES

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Seed: TypeAlias = int | Floats
"""A whole number, or three numbers for each sample, uniform in [0, 1), ``(N, 3)``."""

DRAWN_NAMES = ("coalescence_time", "reference_phase", "distance_mpc")
"""What may be integrated over, in the order in which it is drawn."""


def integrated_names(settings: AnalysisSettings) -> tuple[str, ...]:
    """What an analysis integrates over: those of :data:`DRAWN_NAMES` whose value in a sample does not matter."""
    integrated = (
        settings.time_marginalisation is not None,
        settings.phase_marginalisation,
        settings.distance_marginalisation is not None,
    )
    return tuple(name for name, there in zip(DRAWN_NAMES, integrated, strict=True) if there)


def nothing_integrated(settings: AnalysisSettings) -> AnalysisSettings:
    """The same settings with nothing integrated over: those that whole samples belong to."""
    return msgspec.structs.replace(
        settings, phase_marginalisation=False, time_marginalisation=None, distance_marginalisation=None
    )


@dataclass(frozen=True, eq=False)
class DetectorProducts:
    """Inner products of data and signals in every detector, of N samples and D detectors.

    They are those of the signal that a sample describes, at its own time, phase and distance, whatever the analysis
    integrates over; NaN wherever the :class:`RowStatus` is not OK.

    Attributes
    ----------
    detectors
        Their names, ``(D,)``.
    d_inner_h
        <d|h>, complex128 ``(N, D)``, conjugate linear in the data (bilby's is the complex conjugate).
    h_inner_h
        <h|h>, float64 ``(N, D)``.
    status
        uint8 ``(N,)``.
    """

    detectors: tuple[str, ...]
    d_inner_h: Complex
    h_inner_h: Floats
    status: NDArray[np.uint8]

    @property
    def optimal_snr(self) -> Floats:
        """The root of <h|h>, ``(N, D)``."""
        return np.asarray(np.sqrt(self.h_inner_h))

    @property
    def matched_filter_snr(self) -> Complex:
        """<h|d> over the root of <h|h>, complex ``(N, D)``, as bilby's and PESummary's."""
        return _ratio(self.d_inner_h, self.h_inner_h)

    @property
    def log_likelihood(self) -> Floats:
        """Re <d|h> - <h|h> / 2, ``(N, D)``: their sum over the detectors is the log-likelihood of the network."""
        return np.asarray(self.d_inner_h.real - 0.5 * self.h_inner_h)

    @property
    def network_optimal_snr(self) -> Floats:
        """The root of <h|h> of all detectors, ``(N,)``."""
        return np.asarray(np.sqrt(_total(self.h_inner_h)))

    @property
    def network_matched_filter_snr(self) -> Complex:
        """<h|d> over the root of <h|h> of all detectors, complex ``(N,)``: the network's for one coherent signal."""
        return _ratio(_total(self.d_inner_h), _total(self.h_inner_h))

    @property
    def network_log_likelihood(self) -> Floats:
        """The log-likelihood of the network, ``(N,)``, nothing integrated; -inf wherever the status is not OK."""
        return np.where(self.status == 0, _total(self.log_likelihood), -np.inf)

    def columns(self) -> dict[str, NDArray[Any]]:
        """Columns for a table of samples, ``(N,)`` each, by the names of bilby and PESummary: ``H1_optimal_snr``,
        ``H1_matched_filter_snr``, ``H1_log_likelihood``, ..., ``network_optimal_snr``.
        """
        found: dict[str, NDArray[Any]] = {}
        for name in ("optimal_snr", "matched_filter_snr", "log_likelihood"):
            values = getattr(self, name)
            found |= {f"{detector}_{name}": values[:, place] for place, detector in enumerate(self.detectors)}
            found[f"network_{name}"] = getattr(self, f"network_{name}")
        return found


def _total(values: NDArray[Any]) -> NDArray[Any]:
    """Sums over the detectors, in their order."""
    total = values[:, 0].copy()
    for column in range(1, values.shape[1]):
        total += values[:, column]
    return total


def _ratio(products: Complex, norms: Floats) -> Complex:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.conj(products) / np.sqrt(norms))


class MarginalisedDraws(NamedTuple):
    """One draw for each of N samples of what its analysis integrates over, by its posterior given the rest.

    ``parameters`` are ``(N,)`` by name, so that ``samples | draws.parameters`` are whole; ``log_likelihood`` ``(N,)``
    is the one there, nothing integrated. NaN, and -inf, wherever the :class:`RowStatus`, uint8 ``(N,)``, is not OK.
    """

    parameters: dict[str, Floats]
    log_likelihood: Floats
    status: NDArray[np.uint8]


def random_numbers(batch: LikelihoodBatch, settings: AnalysisSettings, seed: Seed) -> Floats:
    """Three numbers for each sample, uniform in [0, 1), ``(N, 3)``: what draws of :data:`DRAWN_NAMES` are made of.

    They follow from the seed and the sample, so that a sample has the same draw in any batch, on any machine. What is
    integrated over does not count. Of equal samples in one batch each has numbers of its own. Numbers that are given in
    the place of a seed are taken.

    Raises
    ------
    InvalidRequest
        The analysis integrates over nothing, or the seed is no whole number from 0 to 2**64 - 1.
    InvalidParameters
        As :func:`check_uniforms`.
    """
    if not (integrated := integrated_names(settings)):
        raise InvalidRequest(
            "The analysis integrates over nothing that could be drawn: samples have all parameters, and products() "
            "evaluates them."
        )
    if isinstance(seed, np.ndarray):
        return check_uniforms(seed, len(batch))
    if isinstance(seed, bool) or not isinstance(seed, int | np.integer) or not 0 <= seed < 2**64:
        raise InvalidRequest(
            f"A seed is a whole number from 0 to 2**64 - 1; got {str(seed)[:40]!r}.",
            errors=[FieldError(reason="no seed", parameter="seed")],
        )
    key, seen = int(seed).to_bytes(8, "little"), Counter[bytes]()
    words = np.empty((len(batch), len(DRAWN_NAMES)), dtype="<u8")
    for place, content in enumerate(_contents(batch, integrated)):
        number = seen[content].to_bytes(8, "little")
        seen[content] += 1
        words[place] = np.frombuffer(hashlib.blake2b(content + number, key=key, digest_size=24).digest(), "<u8")
    return np.asarray((words >> np.uint64(11)) * 2.0**-53)


def check_uniforms(uniforms: NDArray[Any], rows: int) -> Floats:
    """Numbers that draws of so many samples can be made of, as they are.

    Raises
    ------
    InvalidParameters
        They are none: another shape than ``(rows, 3)``, or not in [0, 1).
    """
    shape = rows, len(DRAWN_NAMES)
    if uniforms.dtype != np.float64 or uniforms.shape != shape or not ((uniforms >= 0.0) & (uniforms < 1.0)).all():
        raise InvalidParameters(
            f"Draws are made of float64 numbers in [0, 1), of shape {list(shape)} for {rows} samples; got "
            f"{uniforms.dtype} of shape {list(uniforms.shape)}.",
            errors=[FieldError(reason="not such numbers", parameter="uniforms")],
        )
    return uniforms


def _contents(batch: LikelihoodBatch, integrated: tuple[str, ...]) -> Iterator[bytes]:
    """The bytes of each sample, but for what is integrated over."""
    used = [column for column, name in enumerate(LIKELIHOOD_NAMES) if name not in integrated]
    errors = [
        arrays[name] for arrays in (batch.calibration_amplitude, batch.calibration_phase) for name in sorted(arrays)
    ]
    table = np.concatenate([batch.values[:, used], *errors], axis=1)
    return (row.tobytes() for row in table.astype("<f8", copy=False))
