"""Writing what a run has found."""

from __future__ import annotations

from pathlib import Path

from bnserve_posterior.report._page import write_page
from bnserve_posterior.results import bilby_result, save_result
from bnserve_posterior.running import Folder, Outcome, meta_data


def save_outcome(outcome: Outcome, folder: Folder, *, page: bool = True) -> list[Path]:
    """Write the result as bilby's, and the page; the files that were written.

    Raises
    ------
    EventInvalid
        One cannot be written.
    PackageMissing
        A page without matplotlib or corner.
    """
    prepared = outcome.prepared
    section = prepared.event.sampler
    result = bilby_result(
        folder.label,
        outcome.samples,
        outcome.posterior,
        prepared.cube,
        prepared.priors,
        log_evidence=(outcome.log_evidence, outcome.log_evidence_error),
        noise_log_likelihood=prepared.analysis.settings.noise_log_likelihood,
        injection=prepared.data.injection,
        meta_data=meta_data(outcome),
        settings={"effective": section.effective, "particles": section.particles, "seed": section.seed},
        seconds=sum(outcome.seconds.values()),
        integrated=prepared.integrated,
    )
    if page:
        write_page(outcome, folder.page)
    save_result(result, folder.result, prepared.event.output.format)
    return [folder.result, folder.page] if page else [folder.result]
