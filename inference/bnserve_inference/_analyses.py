"""Building analyses: from strain, noise and settings to the arrays that a likelihood is evaluated with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._band import Band
from bnserve_inference._building import Alignment, LikelihoodOptions, Ranges
from bnserve_inference._data import DetectorData
from bnserve_inference._fiducial import CalibratedBasis, FiducialBasis
from bnserve_inference._fitting import Fitting, Weighted, fitted_bins, fitted_calibrated_quadrature, fitted_quadrature
from bnserve_inference._modes import QUADRUPOLE, chosen_modes, known_modes, orders, quadrupole_options
from bnserve_inference._passing import reference_times
from bnserve_inference._rows import chirp_mass
from bnserve_inference._search import Box, middle, refuse_missing_ranges, usual_masses
from bnserve_inference._standing import may_stand, static_error
from bnserve_inference._units import in_units
from bnserve_inference._weights import time_table
from bnserve_protocol import (
    Analysis,
    AnalysisInvalid,
    AnalysisKind,
    BatchLike,
    FieldError,
    ParameterBatch,
    Response,
    WaveformModel,
)

Floats = NDArray[np.float64]

_FAINT = 0.2
"""Norm of what is not of the order of the (2, 2) mode, which has one; it is less."""
TIME_TOLERANCE = 1e-5
"""Error of <d|h> from interpolating weights over time, for a signal of norm one: times the signal-to-noise ratio."""


@in_units(trigger_time="s", f_min="Hz", f_max="Hz")
def full_analysis(
    data: Sequence[DetectorData],
    *,
    trigger_time: float,
    f_min: float,
    f_max: float,
    alignment: Alignment = "merger",
    options: LikelihoodOptions = LikelihoodOptions(),  # noqa: B008  (frozen)
) -> Analysis:
    """The exact likelihood, on all frequencies of the data.

    Parameters
    ----------
    data
        Of every detector.
    trigger_time
        GPS seconds that all times are relative to.
    f_min, f_max
        Band in Hz, multiples of 1 / duration.
    alignment
        What ``coalescence_time`` means for a waveform: see ``EvaluationOptions``.
    options
        Prior ranges, marginalisations, calibration.

    Raises
    ------
    AnalysisInvalid
        Data or settings that no likelihood could be evaluated with.
    """
    band = Band(data, trigger_time, f_min, f_max)
    options = replace(band.timed(options), response="static" if options.response == "static" else "moving")
    weights, densities = band.whole()
    arrays = band.arrays(list(weights[:, None]), list(densities))
    return Analysis(settings=band.settings("full", alignment, options), arrays=arrays)


@in_units(trigger_time="s")
def roq_analysis(
    data: Sequence[DetectorData],
    *,
    trigger_time: float,
    basis: Any,
    model: WaveformModel,
    options: LikelihoodOptions,
    checked: bool = False,
) -> Analysis:
    """The likelihood by reduced-order quadrature.

    Parameters
    ----------
    basis
        A :class:`~bnserve_inference.roq.ReducedOrderQuadrature`; band, duration and alignment are its own.
    model
        The one that the basis was built for. With a calibration, and if the basis is a table, its waveforms are
        compared with the basis all over the prior.
    options
        Its ``prior`` must state ``coalescence_time`` (seconds from the trigger) and must be covered by the basis; where
        it is silent, the ranges of the basis hold. Other parameters as :func:`full_analysis`.
    checked
        Whether ln L is compared with that on the full grid all over the prior, as it is for a table in any case.

    Raises
    ------
    AnalysisInvalid
        As :func:`full_analysis`; also data of another duration, a prior that the basis does not cover, a table, or with
        ``checked`` any basis, that does not give the model's waveforms within the options' ``error_bound``, or
        calibration errors that the basis cannot stand: a calibrated waveform need not be in the span of a basis of
        waveforms.
    """
    band = Band(data, trigger_time, basis.f_min, basis.f_max)
    if abs(band.duration - basis.duration) > 1e-9 * basis.duration:
        raise AnalysisInvalid(
            f"The basis is for data of {basis.duration} s and the data last {band.duration} s; build a basis for them.",
            errors=[FieldError(reason="not that of the data", parameter="duration", value=basis.duration)],
        )
    if model is None:
        raise AnalysisInvalid("Give the model: a basis is held to its waveforms.")
    options = band.timed(_covered(options, basis.prior))
    band.check(options)
    basis.check_model(model)
    if options.response != "static":
        raise AnalysisInvalid(
            "A reduced-order quadrature gives waveforms, and not what detectors that move make of them: state "
            "response='static', which is right for short signals, or take relative binning or the full analysis.",
            errors=[FieldError(reason="not with a quadrature", parameter="response")],
        )
    modes = chosen_modes(options.modes, model.description)
    if len(model.description.modes) > 1 and modes != (QUADRUPOLE,):
        raise AnalysisInvalid(
            f"A basis holds the (2, 2) mode alone, and {model.description.name} has {len(model.description.modes)} "
            "modes: say that it is enough, with modes=[(2, 2)] in the options, or take relative binning for all.",
            errors=[FieldError(reason="not (2, 2) alone", parameter="modes")],
        )
    reference = middle(basis.prior)
    fitting = Fitting(band, model, basis.alignment, options, None, modes)
    checked = checked or basis.tabulated
    if options.calibration is not None or checked:
        refuse_missing_ranges(options.prior)
    weighted = fitted_quadrature(fitting, basis) if checked else fitting.weighted(basis)
    if options.calibration is not None:
        around = reference or Box.of(options.prior, model).middle()
        calibrated = CalibratedBasis.around(basis, around, band.grid, model)
        weighted = fitted_calibrated_quadrature(fitting, calibrated)
    return _reduced("roq", weighted, replace(fitting, fiducial=reference), basis.model_digest or None)


@in_units(trigger_time="s", f_min="Hz", f_max="Hz", phase_tolerance="rad")
def relative_binning_analysis(
    data: Sequence[DetectorData],
    *,
    trigger_time: float,
    f_min: float,
    f_max: float,
    fiducial: BatchLike,
    model: WaveformModel,
    phase_tolerance: float = 0.2,
    alignment: Alignment = "merger",
    options: LikelihoodOptions,
) -> Analysis:
    """The likelihood by relative binning (heterodyning) around a fiducial waveform.

    The ratio to the fiducial waveform is interpolated by a cubic spline through the edges of bins; the time of arrival
    is not part of the ratio, so that it may lie anywhere in its prior.

    Parameters
    ----------
    fiducial
        One binary near the maximum of the likelihood; its distance and orientation do not matter.
    model
        Makes the fiducial waveform; the analysis may then be evaluated with any model.
    phase_tolerance
        Radians by which waveforms that fit may differ from the fiducial one across a bin. Where such bins are wrong
        by more than the options' ``error_bound`` somewhere in the prior, others take their place.
    options
        Its ``prior`` must state ``coalescence_time``; where it is silent about a binary, the model's range counts, and
        for its masses those that the model's ``frequency_band`` is for. Other parameters as :func:`full_analysis`.

    Raises
    ------
    AnalysisInvalid, OutOfDomain
        As :func:`full_analysis`; more bins than are allowed; the fiducial binary outside the model's range, or of a
        mass that has to be in a prior.
    """
    band = Band(data, trigger_time, f_min, f_max)
    one = ParameterBatch.one(fiducial)
    options = band.timed(_covered(options, usual_masses(options.prior, one, model)), float(chirp_mass(one)[0]))
    modes = chosen_modes(options.modes, model.description)
    several = len(model.description.modes) > 1
    if several and QUADRUPOLE not in known_modes(model.description):
        raise AnalysisInvalid(
            "Relative binning follows the phase of the (2, 2) mode, which this model lacks: take the full analysis."
        )
    options = replace(options, modes=modes if several else None)
    band.check(options)
    followed = orders(modes) if several else QUADRUPOLE[1:]
    basis = FiducialBasis.build(band.grid, one, model, phase_tolerance, alignment, followed)
    fitting = Fitting(band, model, alignment, options, one, modes)
    weighted = fitted_bins(fitting, basis)
    if options.response == "moving":
        return _reduced("relative_binning", weighted, fitting, None)
    error = static_error(fitting, weighted)
    if options.response == "auto":
        chosen: Response = "static" if may_stand(error, options.error_bound) else "moving"
        fitting = replace(fitting, options=replace(options, response=chosen))
    return _reduced("relative_binning", weighted, fitting, None, error)


def _reduced(
    kind: AnalysisKind, weighted: Weighted, fitting: Fitting, model_digest: str | None, error: float | None = None
) -> Analysis:
    """The analysis of a basis with its sums; ``fitting.fiducial`` is a typical binary, or None, and ``error`` that of
    detectors that stand still."""
    basis, quadratic, band = weighted.basis, weighted.quadratic, fitting.band
    grid, table, _ = time_table(weighted.weights, _amplitudes(weighted, fitting), TIME_TOLERANCE)
    if quadratic.ndim == 3 and quadratic.shape[1] == 1:  # modes of one order have the weights of one mode
        quadratic = quadratic[:, 0].real
    arrays = band.arrays(list(table), list(quadratic))
    arrays |= {"linear_nodes": basis.linear_nodes, "quadratic_nodes": basis.quadratic_nodes}
    if fitting.options.response == "moving" and isinstance(basis, FiducialBasis):
        phases, times = reference_times(fitting.model, basis)
        arrays |= {"reference_phases": phases, "reference_times": times}
    settings = band.settings(kind, fitting.alignment, fitting.options, grid, model_digest)
    return Analysis(settings=settings, arrays=arrays, static_error=error)


def _amplitudes(weighted: Weighted, fitting: Fitting) -> NDArray[np.float64]:
    """Size of a typical strain at the linear nodes, ``(D, L)``, of norm one in every detector; of every order."""
    basis, quadratic, reference, model = weighted.basis, weighted.quadratic, fitting.fiducial, fitting.model
    f, q = basis.linear_nodes, basis.quadratic_nodes
    if isinstance(basis, FiducialBasis) and quadratic.ndim == 3:
        return _amplitudes_of_orders(basis, quadratic, model)
    if reference is None:
        at_linear, at_quadratic = f ** (-7.0 / 6.0), q ** (-7.0 / 6.0)
    else:
        options = quadrupole_options(model, alignment=fitting.alignment)
        at_linear = np.abs(model.predict_factored(f, reference, options=options).h[0])
        at_quadratic = np.abs(model.predict_factored(q, reference, options=options).h[0])
    return at_linear / np.sqrt(np.abs(quadratic @ at_quadratic**2))[:, None]


def _amplitudes_of_orders(basis: FiducialBasis, pairs: NDArray[np.complex128], model: WaveformModel) -> Floats:
    found, at = [], 0
    for place, order in enumerate(basis.orders):
        size = np.abs(basis.reference(model, order, basis.linear_nodes))
        share = _FAINT if QUADRUPOLE[1] in basis.orders and order != QUADRUPOLE[1] else 1.0
        found.append(share * size / np.sqrt(np.abs(pairs[:, at].real @ size**2))[:, None])
        at += len(basis.orders) - place
    return np.concatenate(found, axis=1)


def _covered(options: LikelihoodOptions, ranges: Ranges) -> LikelihoodOptions:
    """The options with all ranges stated; refuses a prior beyond ``ranges`` and one without a coalescence time."""
    prior = dict(options.prior)
    if "coalescence_time" not in prior:
        raise AnalysisInvalid(
            "State the prior range of 'coalescence_time' in seconds from the trigger: the weights are made for it.",
            errors=[FieldError(reason="missing", parameter="coalescence_time")],
        )
    for name, (low, high) in ranges.items():
        wanted = prior.setdefault(name, (low, high))
        if wanted[0] < low or wanted[1] > high:
            raise AnalysisInvalid(
                f"The basis covers '{name}' from {low} to {high}, the prior wants {wanted[0]} to {wanted[1]}. "
                "Narrow the prior or build a wider basis.",
                errors=[FieldError(reason="not covered by the basis", parameter=name)],
            )
    return replace(options, prior=prior)
