"""Everything that is measured of this installation."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from bnserve_service.bench.binaries import Questions
from bnserve_service.bench.breakdown import local_breakdown
from bnserve_service.bench.costs import Progress, batch_costs, single_costs
from bnserve_service.bench.processes import first_waveform, server_memory, threads_against_one
from bnserve_service.bench.sizes import Sizes
from bnserve_service.process.system import available_cpus
from bnserve_store import ModelStore
from bnserve_surrogate import Model


def measure_local(name: str, version: str, store: Path | None, sizes: Sizes, say: Progress) -> dict[str, Any]:
    """Measure a model in this process, and fresh processes beside it.

    Parameters
    ----------
    name, version
        Of the model.
    store
        A folder that is searched before the shipped models, or None.
    sizes
        How much.
    say
        Gets what is being measured.

    Returns
    -------
    A document of plain values.
    """
    model = Model.load(name, version, ModelStore.default([store] if store else ()))
    model.warm_up()
    questions = Questions(model.description)
    cores, few = available_cpus(), 3 if sizes.epochs <= 3 else 7
    say("single waveforms")
    single = single_costs(model, questions, sizes)
    say("breakdown")
    breakdown = local_breakdown(model, questions, sizes.points, sizes.epochs)
    say("batches")
    batches = batch_costs(model, questions, sizes)
    say("threads, processes")
    return {
        "model": model.description,
        "single": single,
        "breakdown": breakdown,
        "batches": batches,
        "threads": threads_against_one(model, questions, 2, few) if cores > 1 else None,
        "fresh_process": first_waveform(model.description.name, model.description.version, store, few),
        "server_memory": server_memory(),
    }
