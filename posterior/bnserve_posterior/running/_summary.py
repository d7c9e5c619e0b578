"""What a run says of itself: for the terminal, for machines, for the result and the page."""

from __future__ import annotations

import importlib.metadata
import platform
from typing import Any

import bnserve_protocol
from bnserve_posterior.data import segment_start
from bnserve_posterior.running._chain import Outcome
from bnserve_posterior.running._preparing import Prepared

_PACKAGES = ("bilby", "numpy", "scipy", "corner", "matplotlib")


def describe(outcome: Outcome) -> dict[str, Any]:
    """Figures of a finished run, plain numbers, texts, lists and dictionaries: those of ``bnserve analyse --json``.

    Logarithms are natural, evidences ratios to that of no signal, and times seconds.
    """
    posterior, prepared = outcome.posterior, outcome.prepared
    shift = outcome.log_evidence - posterior.log_evidence
    return {
        "log_evidence": outcome.log_evidence,
        "log_evidence_error": outcome.log_evidence_error,
        "log_evidences": [value + shift for value, _ in posterior.log_evidences],
        "log_evidence_errors": [error for _, error in posterior.log_evidences],
        "noise_log_likelihood": prepared.analysis.settings.noise_log_likelihood,
        "effective_samples": len(outcome.samples),
        "k_hat": posterior.k_hat,
        "likelihoods": posterior.likelihoods,
        "largest_log_likelihood": float(posterior.log_likelihood.max()),
        "likelihood": prepared.analysis.settings.kind,
        "response": "moving" if prepared.analysis.settings.moves else "static",
        "static_error": prepared.static_error,
        "calibration": None if outcome.samples.calibrated is None else outcome.samples.calibrated._asdict(),
        "check": None if outcome.check is None else outcome.check._asdict(),
        "seconds": {name: round(value, 2) for name, value in outcome.seconds.items()},
        "processor_seconds": round(outcome.processor_seconds, 2),
        "facts": prepared.facts,
        "doubts": prepared.doubts,
        "versions": versions(prepared),
        "digests": digests(prepared),
    }


def versions(prepared: Prepared) -> dict[str, str]:
    """Of everything that had a part."""
    model = prepared.model.description
    return {
        "bnserve": bnserve_protocol.__version__,
        "model": f"{model.name} {model.version}",
        "python": platform.python_version(),
        **{name: importlib.metadata.version(name) for name in _PACKAGES},
    }


def digests(prepared: Prepared) -> dict[str, str]:
    """Of the model, of the analysis and of the files of data."""
    return {
        "model": prepared.model.description.digest,
        "analysis": prepared.analysis.digest,
        **prepared.data.digests,
    }


def meta_data(outcome: Outcome) -> dict[str, Any]:
    """What bilby and PESummary look for in a result, and ours under ``bnserve``."""
    prepared, event = outcome.prepared, outcome.prepared.event
    columns = outcome.samples.values
    networks = {
        data.name: {"optimal_SNR": float(columns[f"{data.name}_optimal_snr"].mean())}
        for data in prepared.data.detectors
    }
    return {
        "likelihood": {
            "interferometers": networks,
            "duration": event.data.duration,
            "start_time": float(segment_start(event.data)),
            "sampling_frequency": 2.0 * (len(prepared.data.detectors[0].asd) - 1) / event.data.duration,
            "time_marginalization": "geocent_time" in prepared.integrated,
            "phase_marginalization": "phase" in prepared.integrated,
            "distance_marginalization": "luminosity_distance" in prepared.integrated,
            "frequency_domain_source_model": "bnserve",
            "waveform_arguments": {
                "waveform_approximant": "bnserve",
                "reference_frequency": event.data.f_min,
                "minimum_frequency": event.data.f_min,
                "maximum_frequency": event.data.f_max,
            },
        },
        "versions": versions(prepared),
        "bnserve": describe(outcome),
    }
