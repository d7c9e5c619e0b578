"""The result as one of bilby's, JSON or HDF5, for bilby and PESummary to read."""

from __future__ import annotations

import contextlib
import logging
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

import numpy as np

from bnserve_posterior.events import EventInvalid
from bnserve_posterior.priors import PriorCube
from bnserve_posterior.results._samples import Samples
from bnserve_posterior.sampling import Posterior
from bnserve_store import replacing


def bilby_result(
    label: str,
    samples: Samples,
    posterior: Posterior,
    cube: PriorCube,
    priors: Any,
    *,
    log_evidence: tuple[float, float],
    noise_log_likelihood: float,
    injection: Mapping[str, float] | None,
    meta_data: Mapping[str, Any],
    settings: Mapping[str, Any],
    seconds: float,
    integrated: Sequence[str],
) -> Any:
    """A ``CBCResult``.

    Parameters
    ----------
    samples, posterior, cube, priors
        What was found, and the prior as bilby has it.
    log_evidence
        ln of the evidence ratio, over the prior that the constraints leave, and its standard error.
    noise_log_likelihood
        Of the data without a signal.
    injection
        With bilby's names; None for none.
    meta_data, settings, seconds
        What the result says of itself; of the sampler; and its time.
    integrated
        Names of the prior that were integrated over.
    """
    import bilby
    import pandas
    from bilby.gw.result import CBCResult

    frame = pandas.DataFrame(samples.values)
    frame["log_likelihood"] = samples.log_likelihood
    names = ["geocent_time" if name == "coalescence_time" else name for name in cube.names]
    known = [name for name in (*names, *integrated) if name in frame]
    frame["log_prior"] = sum(np.asarray(priors[name].ln_prob(frame[name].to_numpy())) for name in known)
    with _quiet():
        return CBCResult(
            label=label,
            outdir=".",
            sampler="bnserve",
            search_parameter_keys=names,
            fixed_parameter_keys=list(cube.fixed),
            constraint_parameter_keys=list(cube.constraints),
            priors=priors,
            sampler_kwargs=dict(settings),
            injection_parameters=None if injection is None else dict(injection),
            meta_data=dict(meta_data),
            posterior=frame,
            samples=frame[names].to_numpy(),
            log_evidence=log_evidence[0] + noise_log_likelihood,
            log_evidence_err=log_evidence[1],
            log_noise_evidence=noise_log_likelihood,
            log_bayes_factor=log_evidence[0],
            log_likelihood_evaluations=samples.log_likelihood,
            num_likelihood_evaluations=posterior.likelihoods,
            sampling_time=seconds,
            version=f"bilby={bilby.__version__}, bnserve={meta_data['versions']['bnserve']}",
        )


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """bilby says of every result that is made which of its fields it left out."""
    logger = logging.getLogger("bilby")
    before = logger.level
    logger.setLevel(logging.WARNING)
    try:
        yield
    finally:
        logger.setLevel(before)


def save_result(result: Any, path: Path, kind: Literal["json", "hdf5"]) -> None:
    """Write a result, whole or not at all.

    Raises
    ------
    EventInvalid
        The file cannot be written.
    """
    try:
        with replacing(path) as temporary:
            result.save_to_file(filename=str(temporary), extension=kind, overwrite=True)
    except OSError as error:
        raise EventInvalid(f"The result cannot be written to {path}: {error.strerror or error}. Make room.") from error
