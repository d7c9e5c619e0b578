"""What a run leaves in its folder, so that the same command need not sample again."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.gw170817.annealing import Annealing
from benchmarks.gw170817.sampling import Cost, Posterior, SamplerSettings
from benchmarks.gw170817.setting import OtherRun

_SAMPLES, _COST, _SETTINGS = "posterior.npz", "cost.json", "settings.json"


def keep_posterior(folder: Path, posterior: Posterior) -> None:
    """Write the samples and their evidence; the cost is there already."""
    partial = folder / f"part.{_SAMPLES}"
    np.savez(partial, **{name: value for name, value in posterior._asdict().items() if name != "cost"})
    partial.replace(folder / _SAMPLES)


def kept_posterior(folder: Path, settings: Annealing | SamplerSettings) -> Posterior | None:
    """What an earlier run with these settings found, if it came to its end.

    Raises
    ------
    OtherRun
        The earlier run had other settings.
    """
    folder.mkdir(parents=True, exist_ok=True)
    ours, written = json.dumps({type(settings).__name__: asdict(settings)}), folder / _SETTINGS
    if written.exists() and written.read_text() != ours:
        raise OtherRun(
            f"'{folder.name}' holds a run with other settings of the sampler: name another folder with --work, or give "
            f"those settings again: {written.read_text()}."
        )
    written.write_text(ours)
    if not (folder / _SAMPLES).exists():
        return None
    with np.load(folder / _SAMPLES, allow_pickle=False) as file:
        kept: dict[str, Any] = {name: file[name] for name in ("points", "weights", "log_likelihood")}
        kept |= {name: float(file[name]) for name in ("log_evidence", "log_evidence_error", "effective")}
    return Posterior(**kept, cost=Cost(**json.loads((folder / _COST).read_text())))
