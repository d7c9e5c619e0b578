"""Building the likelihood that is sampled, and the full one that it is held against."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from bnserve_inference import (
    DetectorData,
    LikelihoodOptions,
    full_analysis,
    relative_binning_analysis,
    roq_analysis,
)
from bnserve_inference.roq import ReducedOrderQuadrature, load_basis, load_shipped_basis, shipped_bases
from bnserve_posterior.data import EventData
from bnserve_posterior.events import Event, EventInvalid
from bnserve_posterior.likelihoods._envelopes import Envelopes
from bnserve_posterior.likelihoods._marginalised import marginalised_distance, marginalised_time
from bnserve_posterior.likelihoods._ranges import analysis_ranges
from bnserve_posterior.priors import PriorCube, likelihood_parameters
from bnserve_protocol import (
    PARAMETER_NAMES,
    Analysis,
    AnalysisInvalid,
    LikelihoodBatch,
    OutOfDomain,
    ParameterBatch,
    WaveformModel,
)

QUADRUPOLE = ((2, 2),)


class Choice(NamedTuple):
    """The analysis that is sampled; why it is this one, a sentence each; and by how much ln L of detectors that stand
    still may be wrong, None where that was not looked at."""

    analysis: Analysis
    facts: list[str]
    static_error: float | None = None


def build_likelihood(event: Event, data: EventData, cube: PriorCube, model: WaveformModel) -> Choice:
    """The likelihood of an event.

    Parameters
    ----------
    event, data, cube
        What is analysed, and its prior.
    model
        Makes the waveforms.

    Raises
    ------
    AnalysisInvalid, EventInvalid
        Data or settings that no likelihood could be evaluated with.
    """
    kind = event.likelihood.kind
    options = _options(event, cube, model)
    if kind == "full":
        return Choice(full_likelihood(event, data, cube, model), ["Likelihood: the full grid, as asked for."])
    if kind == "roq":
        if event.likelihood.basis is None:
            known = ", ".join(shipped_bases())
            raise EventInvalid(f"A reduced-order quadrature needs 'basis' in [likelihood]: a file, or one of {known}.")
        analysis = _quadrature(event, data.detectors, _basis(event.likelihood.basis), model, options)
        return Choice(analysis, [f"Likelihood: reduced-order quadrature, {event.likelihood.basis}."])
    if kind == "relative_binning":
        analysis = _binned(event, data, cube, model, options)
        return Choice(
            analysis, [f"Likelihood: relative binning, {_said(event, analysis, analysis)}."], analysis.static_error
        )
    return _cheapest(event, data, cube, model, options)


def _cheapest(
    event: Event, data: EventData, cube: PriorCube, model: WaveformModel, options: LikelihoodOptions
) -> Choice:
    """A quadrature that fits, where detectors may stand still; or else relative binning; or else the full grid."""
    facts: list[str] = []
    binned = None
    try:
        binned = _binned(event, data, cube, model, options)
    except (AnalysisInvalid, OutOfDomain) as error:
        facts.append(f"Not relative binning: {error}")
    still = options.response == "static" if binned is None else binned.settings.response != "moving"
    bases = (event.likelihood.basis,) if event.likelihood.basis else _fitting_bases(event, model, options)
    for name in bases if still else ():
        try:
            found = _quadrature(event, data.detectors, _basis(name), model, options)
            said = f"Likelihood: reduced-order quadrature {name}, {_said(event, found, binned)}."
            return Choice(found, [*facts, said], None if binned is None else binned.static_error)
        except AnalysisInvalid as error:
            facts.append(f"Not the quadrature {name}: {error}")
    if binned is not None:
        said = f"Likelihood: relative binning, {len(binned.linear_nodes)} nodes, {_said(event, binned, binned)}."
        return Choice(binned, [*facts, said], binned.static_error)
    full = full_likelihood(event, data, cube, model)
    return Choice(full, [*facts, "Likelihood: the full grid, because nothing cheaper is within the bound."])


def _said(event: Event, analysis: Analysis, binned: Analysis | None) -> str:
    """What is promised of an analysis, how its detectors move, and why, which relative binning knows."""
    moves = "turn with the Earth" if analysis.settings.response == "moving" else "stand still"
    said = f"held to {event.likelihood.error_bound:g} in ln L all over the prior, of detectors that {moves}"
    if binned is None or binned.static_error is None:
        return said
    return f"{said} (standing still, ln L would be wrong by up to {binned.static_error:.2g})"


def full_likelihood(event: Event, data: EventData, cube: PriorCube, model: WaveformModel) -> Analysis:
    """The likelihood on all frequencies of the data, integrating over the same; as :func:`build_likelihood`."""
    band = event.data
    return full_analysis(
        data.detectors, trigger_time=band.trigger_time, f_min=band.f_min, f_max=band.f_max,
        options=_options(event, cube, model),
    )  # fmt: skip


def _options(event: Event, cube: PriorCube, model: WaveformModel) -> LikelihoodOptions:
    section, envelopes = event.likelihood, Envelopes.read(event)
    distance = marginalised_distance(cube.priors) if section.distance_marginalisation else None
    return LikelihoodOptions(
        prior=analysis_ranges(cube, model.description),
        phase_marginalisation=section.phase_marginalisation,
        distance_marginalisation=distance,
        time_marginalisation=marginalised_time(cube) if section.time_marginalisation else None,
        calibration=None if envelopes is None else envelopes.calibration,
        error_bound=section.error_bound,
        modes=section.modes,
        response=section.response,
    )


def _binned(
    event: Event, data: EventData, cube: PriorCube, model: WaveformModel, options: LikelihoodOptions
) -> Analysis:
    band = event.data
    return relative_binning_analysis(
        data.detectors, trigger_time=band.trigger_time, f_min=band.f_min, f_max=band.f_max,
        fiducial=_fiducial(event, data, cube, options), model=model, options=options,
    )  # fmt: skip


def _fiducial(event: Event, data: EventData, cube: PriorCube, options: LikelihoodOptions) -> ParameterBatch:
    """The configured binary, or the injected one, or the middle of the prior; inside the box of the analysis."""
    given = event.likelihood.fiducial or data.injection
    if given is not None:
        extrinsic = {"ra": 0.0, "dec": 0.0, "psi": 0.0, "theta_jn": 0.0, "luminosity_distance": 1.0}
        row = likelihood_parameters({**extrinsic, **given}, event.data.trigger_time)
        return LikelihoodBatch.coerce(row).waveform_batch()
    middle = cube(np.full((1, len(cube)), 0.5))
    batch = cube.batch({**middle, "luminosity_distance": np.ones(1)}).waveform_batch(reference_phase=0.0)
    values = batch.values.copy()
    for name, (low, high) in options.prior.items():
        if name in PARAMETER_NAMES and name != "total_mass":
            column = PARAMETER_NAMES.index(name)
            values[:, column] = np.clip(values[:, column], low, high)
    return ParameterBatch(values)


def _fitting_bases(event: Event, model: WaveformModel, options: LikelihoodOptions) -> list[str]:
    """Names of bases that come with bnserve and are for this band, this model and (2, 2) alone; fewest nodes first."""
    modes = event.likelihood.modes or tuple(model.description.modes)
    if tuple(tuple(mode) for mode in modes) != QUADRUPOLE:
        return []
    found: list[tuple[int, str]] = []
    for name in shipped_bases():
        basis, band = load_shipped_basis(name), event.data
        same = (basis.f_min, basis.f_max, basis.duration) == (band.f_min, band.f_max, band.duration)
        covered = all(
            low <= options.prior[key][0] and options.prior[key][1] <= high
            for key, (low, high) in basis.prior.items()
            if key in options.prior
        )
        if same and covered and basis.model_digest == model.description.digest:
            found.append((len(basis.linear_nodes) + len(basis.quadratic_nodes), name))
    return [name for _, name in sorted(found)]


def _basis(given: str) -> ReducedOrderQuadrature:
    return load_shipped_basis(given) if given in shipped_bases() else load_basis(given)


def _quadrature(
    event: Event, detectors: list[DetectorData], basis: ReducedOrderQuadrature, model: WaveformModel,
    options: LikelihoodOptions,
) -> Analysis:  # fmt: skip
    return roq_analysis(
        detectors, trigger_time=event.data.trigger_time, basis=basis, model=model,
        options=replace(options, modes=options.modes or QUADRUPOLE, response="static"), checked=True,
    )  # fmt: skip
