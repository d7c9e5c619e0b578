"""The analyses of the event, kept in files so that an interrupted run does not build them again."""

from __future__ import annotations

from pathlib import Path

from benchmarks.gw170817 import priors, setting
from bnserve_inference import LikelihoodOptions, full_analysis, relative_binning_analysis, roq_analysis
from bnserve_inference.roq import load_shipped_basis
from bnserve_protocol import Analysis, Calibration, WaveformModel, decode_analysis, encode_analysis

BASIS = "gw170817_fine"
PHASE_TOLERANCE = 0.2
"""Radians across a bin, to begin with: bins are placed anew until they serve the whole prior."""
CALIBRATION = Calibration(nodes=10, f_min=setting.F_MIN, f_max=setting.F_MAX)
"""As the paper's: ten logarithmic nodes in every detector."""


def build(kind: str, event: setting.Event, model: WaveformModel) -> Analysis:
    """An analysis over the prior, with the phase integrated over.

    ``kind`` is ``"roq"``, ``"relative_binning"`` or ``"full"``, which integrate over the distance as well;
    ``"distance"``, relative binning which does not; or ``"calibration"``, relative binning with calibration errors.
    """
    options = LikelihoodOptions(
        prior=priors.RANGES,
        phase_marginalisation=True,
        distance_marginalisation=None if kind == "distance" else priors.DISTANCE,
        calibration=CALIBRATION if kind == "calibration" else None,
        modes=setting.MODES,
    )
    if kind == "full":
        return full_analysis(
            event.data, trigger_time=setting.TRIGGER, f_min=setting.F_MIN, f_max=setting.F_MAX, options=options
        )
    if kind == "roq":
        basis = load_shipped_basis(BASIS)
        return roq_analysis(event.data, trigger_time=setting.TRIGGER, basis=basis, model=model, options=options)
    return relative_binning_analysis(
        event.data, trigger_time=setting.TRIGGER, f_min=setting.F_MIN, f_max=setting.F_MAX, fiducial=setting.fiducial(),
        model=model, phase_tolerance=PHASE_TOLERANCE, options=options,
    )  # fmt: skip


def kept(kind: str, event: setting.Event, model: WaveformModel, folder: Path) -> Analysis:
    """The same, from ``folder`` if it is there; the folder belongs to one event and one model."""
    path = folder / f"{kind}.analysis"
    if path.exists():
        return decode_analysis(path.read_bytes())
    analysis = build(kind, event, model)
    folder.mkdir(parents=True, exist_ok=True)
    partial = path.with_suffix(".part")
    partial.write_bytes(b"".join(encode_analysis(analysis)))
    partial.replace(path)
    return analysis
