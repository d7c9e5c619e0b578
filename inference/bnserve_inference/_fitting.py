"""Approximations that are held to the likelihood on the full grid before they are used."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._bins import Bins
from bnserve_inference._building import Alignment, Band, Basis, LikelihoodOptions
from bnserve_inference._fiducial import CalibratedBasis, FiducialBasis
from bnserve_inference._modes import options_for
from bnserve_inference._modes_trial import ModesTrial
from bnserve_inference._search import COORDINATES, Box, climb
from bnserve_inference._trial import CalibrationErrors, Comparison, Trial
from bnserve_inference._weights import ARRIVAL_MARGIN, TimeRange, Weights, quadratic_weights
from bnserve_protocol import AnalysisInvalid, FieldError, Mode, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]

RELEVANT = 25.0
"""Below the maximum of ln L, nothing matters: no sampler goes there, and an evidence has not a part in 10^9 of it."""
_SHARE = 0.5
"""Of the bound, which what is measured may use up: binaries that were not looked at may be twice as wrong."""
_COMPARED, _DRAWN = 64, 32
_ATTEMPTS = 8


@dataclass(frozen=True, eq=False)
class Weighted:
    """A basis with its sums over the data, and over the noise ``(D, Q)``; complex ``(D, P, Q)`` for pairs of orders.

    ``top`` is the largest ln L that was found, where that was looked for.
    """

    basis: Basis
    weights: Weights
    quadratic: NDArray[Any]
    top: float = math.nan


class Compared(NamedTuple):
    """Binaries of the prior that fit with a basis, and what was found for some of them and others."""

    fitting: ParameterBatch
    batch: ParameterBatch
    found: Comparison


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

    def weighted(self, basis: Basis) -> Weighted:
        """The sums of a basis."""
        low, high = self.options.prior["coalescence_time"]
        arrivals = TimeRange(low - ARRIVAL_MARGIN, high + ARRIVAL_MARGIN)
        quadratic: NDArray[Any]
        if isinstance(basis, FiducialBasis) and len(self.modes) > 1:
            quadratic, nodes = basis.pair_weights(self.model, self.band.densities), basis.all_nodes
        else:
            quadratic, nodes = self.quadratic(basis), basis.linear_nodes
        chunks = basis.linear_chunks(self.model)
        weights = Weights(chunks, nodes, self.band.frequencies, self.band.data, arrivals)
        return Weighted(basis, weights, quadratic)

    def quadratic(self, basis: Basis) -> Floats:
        """The sums of squared moduli of a basis over the noise, ``(D, Q)``."""
        return quadratic_weights(basis.quadratic_chunks(self.model), self.band.densities)

    def _trial(self, weighted: Weighted) -> Trial | ModesTrial:
        basis, weights, quadratic = weighted.basis, weighted.weights, weighted.quadratic
        if quadratic.ndim == 3 and isinstance(basis, FiducialBasis):
            return ModesTrial(self.band, self.model, self.alignment, basis, weights, quadratic, self.modes)
        options = options_for(self.model, self.modes, alignment=self.alignment, out_of_domain="flag")
        return Trial(self.band, self.model, options, basis, weights, quadratic)

    def compared(self, weighted: Weighted, seed: int, seen: ParameterBatch | None) -> Compared:
        """Binaries that fit with the basis, others of the prior, and those ``seen``: with it and on the full grid."""
        box, trial = Box.of(self.options.prior, self.model), self._trial(weighted)

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
            errors = CalibrationErrors.draw(self.options.calibration, len(batch), len(self.band.data), seed)
        return Compared(
            box.binaries(points[values > values.max() - 2.0 * RELEVANT]), batch, trial.compare(batch, errors)
        )


def fitted_bins(fitting: Fitting, basis: FiducialBasis) -> Weighted:
    """Bins that are good enough for the whole prior: those given, or narrower ones where they are too wide.

    Raises
    ------
    AnalysisInvalid
        Too many would be needed.
    """
    bins, seen = Bins(basis, fitting.model, fitting.options.calibration), None
    for attempt in range(_ATTEMPTS):
        weighted = fitting.weighted(basis)
        fit, batch, found = fitting.compared(weighted, attempt, seen)
        top = float(found.best.max())
        fits = found.best > top - RELEVANT
        misleads = (found.approximate > top - RELEVANT) & ~fits
        worst = float(found.total[fits | misleads].max())
        if worst <= fitting.allowed:
            return replace(weighted, top=top)
        if seen is not None:  # bins were placed for these and are still too wide
            bins.narrow(
                float(found.total[: len(seen)][(fits | misleads)[: len(seen)]].max(initial=0.0)) / fitting.allowed
            )
        seen = ParameterBatch(batch.values[fits | misleads][:_COMPARED])
        bins.see(ParameterBatch(batch.values[found.best > top - 2.0 * RELEVANT]), misleading=False)
        bins.see(ParameterBatch(batch.values[misleads]), misleading=True)
        if not misleads.any():  # then what fits with the bins does fit
            bins.see(fit, misleading=False)
        basis = bins.placed(top)
    raise AnalysisInvalid(
        f"Relative binning may be wrong by {worst / _SHARE:.2g} in ln L somewhere in the prior, where "
        f"{fitting.options.error_bound} is allowed: narrow the prior, state a larger error_bound, or take the full "
        "analysis.",
        errors=[FieldError(reason="too inaccurate", parameter="error_bound", value=worst / _SHARE)],
    )


def fitted_quadrature(fitting: Fitting, basis: Basis) -> Weighted:
    """A basis that is to give the model's waveforms, held to them all over the prior.

    Raises
    ------
    AnalysisInvalid
        It does not give them.
    """
    weighted = fitting.weighted(basis)
    plain = replace(fitting, options=replace(fitting.options, calibration=None))
    worst = float(plain.compared(weighted, 0, fitting.draws()).found.total.max())
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
    weighted = fitting.weighted(basis)
    for attempt in range(_ATTEMPTS):
        found = fitting.compared(weighted, attempt, fitting.draws()).found
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
