"""Approximations that are held to the likelihood on the full grid before they are used."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._band import Band
from bnserve_inference._bin_weights import BinWeights
from bnserve_inference._bins import Bins
from bnserve_inference._building import Alignment, Basis, LikelihoodOptions, Nodes
from bnserve_inference._comparison import Comparison
from bnserve_inference._fiducial import CalibratedBasis, FiducialBasis
from bnserve_inference._fine_binning import FineBinning
from bnserve_inference._fine_bins import FineBins, FullGrid, Judge
from bnserve_inference._modes import options_for
from bnserve_inference._modes_trial import ModesTrial
from bnserve_inference._search import COORDINATES, Box, climb
from bnserve_inference._trial import CalibrationErrors, Trial
from bnserve_inference._weights import ARRIVAL_MARGIN, BasisWeights, TimeRange, Weights, quadratic_weights
from bnserve_protocol import AnalysisInvalid, FieldError, Mode, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]

RELEVANT = 25.0
"""Below the maximum of ln L, nothing matters: no sampler goes there, and an evidence has not a part in 10^9 of it."""
_SHARE = 0.5
"""Of the bound, which what is measured may use up: binaries that were not looked at may be twice as wrong."""
_COMPARED, _DRAWN = 64, 32
_HELD = 8
"""Modes of binaries for which fine bins are held to all frequencies, of two binaries at least and four at most."""
_ATTEMPTS = 8
_FARTHER = 1.02
"""What turns so many times as far as all that was seen is new."""


@dataclass(frozen=True, eq=False)
class Weighted:
    """A basis with its sums over the data, and over the noise ``(D, Q)``; complex ``(D, P, Q)`` for pairs of orders.

    ``top`` is the largest ln L that was found, where that was looked for.
    """

    basis: Nodes
    weights: Weights
    quadratic: NDArray[Any]
    top: float = math.nan


class Compared(NamedTuple):
    """Binaries of the prior that fit with a basis, and what was found for some of them and others, with those errors of
    calibration."""

    fitting: ParameterBatch
    batch: ParameterBatch
    errors: CalibrationErrors | None
    found: Comparison

    @property
    def top(self) -> float:
        """The largest ln L that was found."""
        return float(self.found.best.max())

    @property
    def misleads(self) -> NDArray[np.bool_]:
        """Which of them seem to fit and do not."""
        least = self.top - RELEVANT
        return np.asarray((self.found.approximate > least) & (self.found.best <= least))

    @property
    def relevant(self) -> NDArray[np.bool_]:
        """Which of them fit, or seem to."""
        return np.asarray((self.found.best > self.top - RELEVANT) | self.misleads)


@dataclass(frozen=True, eq=False)
class Fitting:
    """What approximations of one analysis are held to.

    Parameters
    ----------
    band, model, alignment, options
        Of the analysis; all ranges that matter are in the prior of the options.
    fiducial
        A binary that is thought to fit, or None.
    modes
        Of the signal.
    """

    band: Band
    model: WaveformModel
    alignment: Alignment
    options: LikelihoodOptions
    fiducial: ParameterBatch | None
    modes: tuple[Mode, ...]

    @property
    def allowed(self) -> float:
        """Error of ln L that may be measured."""
        return _SHARE * self.options.error_bound

    def draws(self) -> ParameterBatch:
        """Some binaries of the prior, uniform in the box."""
        box = Box.of(self.options.prior, self.model)
        unit = np.random.default_rng(_DRAWN).random((4 * _DRAWN, len(COORDINATES)))
        batch = box.binaries(unit)
        return ParameterBatch(batch.values[~box.outside(batch)][:_DRAWN])

    @property
    def arrivals(self) -> TimeRange:
        """All times of arrival that the prior allows."""
        low, high = self.options.prior["coalescence_time"]
        return TimeRange(low - ARRIVAL_MARGIN, high + ARRIVAL_MARGIN)

    def weighted(self, basis: Basis) -> Weighted:
        """The sums of a basis that is given by its rows."""
        weights = BasisWeights(basis.linear_chunks(self.model), basis.linear_nodes, self.band, self.arrivals)
        return Weighted(basis, weights, self.quadratic(basis))

    def binned(self, basis: FiducialBasis, fine: FineBins) -> Weighted:
        """The sums of bins."""
        weights = BinWeights(basis, fine, self.model, self.arrivals)
        pairs = weights.pairs()
        return Weighted(basis, weights, pairs if len(self.modes) > 1 else np.ascontiguousarray(pairs[:, 0].real))

    def quadratic(self, basis: Basis) -> Floats:
        """The sums of squared moduli of a basis over the noise, ``(D, Q)``."""
        return quadratic_weights(basis.quadratic_chunks(self.model), self.band)

    def trial(self, weighted: Weighted) -> Trial | ModesTrial:
        """The likelihood with a basis."""
        basis, weights, quadratic = weighted.basis, weighted.weights, weighted.quadratic
        if quadratic.ndim == 3 and isinstance(basis, FiducialBasis):
            return ModesTrial(self.model, self.alignment, basis, weights, quadratic, self.modes)
        options = options_for(self.model, self.modes, alignment=self.alignment, out_of_domain="flag")
        return Trial(self.model, options, basis, weights, quadratic)

    def compared(self, trial: Trial | ModesTrial, judge: Judge, seed: int, seen: ParameterBatch | None) -> Compared:
        """Binaries that fit with the basis, others of the prior, and those ``seen``: with it and as the judge says."""
        box = Box.of(self.options.prior, self.model)

        def value(unit: Floats) -> Floats:
            batch = box.binaries(unit)
            return np.where(box.outside(batch), -np.inf, trial.values(batch))

        start = None if self.fiducial is None else box.place(self.fiducial)
        points, values = climb(value, start, len(COORDINATES), seed)
        if not np.isfinite(values).any():
            raise AnalysisInvalid("The model makes no waveform in the band for any binary of the prior.")
        batch = box.binaries(_chosen(points, values, seed))
        if seen is not None:
            batch = ParameterBatch(np.concatenate([seen.values, batch.values]))
        errors = None
        if self.options.calibration is not None:
            errors = CalibrationErrors.draw(self.options.calibration, len(batch), len(self.band.detectors), seed)
        fits = box.binaries(points[values > values.max() - 2.0 * RELEVANT])
        return Compared(fits, batch, errors, trial.compare(batch, errors, judge))

    def held(self, trial: Trial | ModesTrial, compared: Compared) -> float:
        """The largest error of ln L beside the full grid, of the best binary and of those that were worst beside fine
        bins."""
        relevant, total = np.flatnonzero(compared.relevant), compared.found.total
        others = min(max(_HELD // len(self.modes), 2), 4) - 1
        rows = np.unique([compared.found.best.argmax(), *relevant[np.argsort(total[relevant])[-others:]]])
        errors = None if compared.errors is None else compared.errors.of(rows)
        batch = ParameterBatch(compared.batch.values[rows])
        return float(trial.compare(batch, errors, FullGrid(self.band)).total.max())


def fitted_bins(fitting: Fitting, basis: FiducialBasis) -> Weighted:
    """Bins that are good enough for the whole prior: those given, or narrower ones where they are too wide.

    They are made of fine bins and held to these; where they pass, to all frequencies at a few binaries.

    Raises
    ------
    AnalysisInvalid
        Too many would be needed.
    """
    calibration, arrivals = fitting.options.calibration, fitting.arrivals
    bins, seen = Bins(basis, fitting.model, calibration), None
    fine = FineBinning(fitting.band, fitting.model, basis, (arrivals.start, arrivals.stop), calibration)
    fine.follow(fitting.draws())
    for attempt in range(_ATTEMPTS):
        weighted = fitting.binned(basis, fine.bins)
        trial = fitting.trial(weighted)
        compared = fitting.compared(trial, fine.bins, attempt, seen)
        worst = float(compared.found.total[compared.relevant].max())
        if fine.follow(ParameterBatch(compared.batch.values[compared.relevant])):
            continue
        if worst <= fitting.allowed:
            worst = fitting.held(trial, compared)
            if worst <= fitting.allowed:
                return replace(weighted, top=compared.top)
            fine.narrow()
        else:
            basis = _narrower(bins, compared, fitting.allowed, 0 if seen is None else len(seen))
            seen = ParameterBatch(compared.batch.values[compared.relevant][:_COMPARED])
    raise AnalysisInvalid(
        f"Relative binning may be wrong by {worst / _SHARE:.2g} in ln L somewhere in the prior, where "
        f"{fitting.options.error_bound} is allowed: narrow the prior, state a larger error_bound, or take the full "
        "analysis.",
        errors=[FieldError(reason="too inaccurate", parameter="error_bound", value=worst / _SHARE)],
    )


def _narrower(bins: Bins, compared: Compared, allowed: float, seen: int) -> FiducialBasis:
    """Bins for what was compared, of which the first ``seen`` had bins placed for them before."""
    batch, found, followed = compared.batch, compared.found, bins.followed
    bins.see(ParameterBatch(batch.values[found.best > compared.top - 2.0 * RELEVANT]), misleading=False)
    bins.see(ParameterBatch(batch.values[compared.misleads]), misleading=True)
    if not compared.misleads.any():  # then what fits with the bins does fit
        bins.see(compared.fitting, misleading=False)
    if seen:
        worst = found.total[:seen][compared.relevant[:seen]].max(initial=0.0)
        if (
            worst <= allowed and bins.followed < _FARTHER * followed
        ):  # nothing is new, and some are too wide all the same
            worst = found.total[compared.relevant].max()
        bins.narrow(float(worst) / allowed)
    return bins.placed(compared.top)


def fitted_quadrature(fitting: Fitting, basis: Basis) -> Weighted:
    """A basis that is to give the model's waveforms, held to them all over the prior.

    Raises
    ------
    AnalysisInvalid
        It does not give them.
    """
    weighted = fitting.weighted(basis)
    plain = replace(fitting, options=replace(fitting.options, calibration=None))
    worst = float(plain.compared(plain.trial(weighted), FullGrid(fitting.band), 0, fitting.draws()).found.total.max())
    if worst > fitting.allowed:
        raise AnalysisInvalid(
            f"The basis does not give the waveforms of this model: ln L may be wrong by {worst / _SHARE:.2g} in the "
            f"prior, where {fitting.options.error_bound} is allowed. It may be for another model, prior, alignment or "
            "sign of the phase, or too coarse for a signal that is so loud: build one, or state a larger error_bound.",
            errors=[FieldError(reason="not the model's waveforms", parameter="basis", value=worst / _SHARE)],
        )
    return weighted


def fitted_calibrated_quadrature(fitting: Fitting, basis: CalibratedBasis) -> Weighted:
    """A basis that stands the calibration errors all over the prior; squared moduli get as many nodes as they need.

    Raises
    ------
    AnalysisInvalid
        Its linear rows do not stand them.
    """
    bins = Bins(basis.smooth, fitting.model, fitting.options.calibration)
    weighted, grid = fitting.weighted(basis), FullGrid(fitting.band)
    for attempt in range(_ATTEMPTS):
        found = fitting.compared(fitting.trial(weighted), grid, attempt, fitting.draws()).found
        if found.linear.max() > fitting.allowed:
            break
        worst = float(max(found.quadratic.max(), found.total.max()))
        if worst <= fitting.allowed:
            return weighted
        if attempt:
            bins.narrow(worst / fitting.allowed)
        basis = CalibratedBasis(basis.basis, bins.placed(float(found.best.max())))
        weighted = Weighted(basis, weighted.weights, fitting.quadratic(basis))
    worst = float(max(found.linear.max(), found.total.max()))
    raise AnalysisInvalid(
        f"The basis cannot stand calibration errors as wide as these: ln L may be wrong by {worst / _SHARE:.2g} in the "
        f"prior, where {fitting.options.error_bound} is allowed, because calibrated waveforms are not in its span. Use "
        "relative binning, build the basis with calibrated waveforms, state narrower errors (amplitude_width, "
        "phase_width) or a larger error_bound, or leave the calibration out.",
        errors=[FieldError(reason="outside of the span of the basis", parameter="calibration", value=worst / _SHARE)],
    )


def _chosen(points: Floats, values: Floats, seed: int) -> Floats:
    """Of a population, the most extreme that matter along every axis, also of their own spread, and some others."""
    relevant = np.flatnonzero(values > values.max() - RELEVANT)
    spread = points[relevant] - points[relevant].mean(axis=0)
    along = np.concatenate([spread, spread @ np.linalg.svd(spread, full_matrices=False)[2].T], axis=1)
    extremes = relevant[np.concatenate([along.argmin(axis=0), along.argmax(axis=0)])]
    possible = np.flatnonzero(np.isfinite(values))
    random = np.random.default_rng(seed)
    others = random.choice(possible, min(_COMPARED, len(possible)), replace=False)
    return points[np.unique(np.concatenate([extremes, [values.argmax()], others]))]
