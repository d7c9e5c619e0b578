"""Everything that is measured of a server."""

from __future__ import annotations

from typing import Any

from bnserve_client import Model
from bnserve_service.bench.binaries import Questions
from bnserve_service.bench.costs import Progress, batch_costs, single_costs
from bnserve_service.bench.load import Target
from bnserve_service.bench.remote import RawClient, concurrency, remote_breakdown
from bnserve_service.bench.sizes import Sizes


def measure_remote(url: str, name: str, version: str, token: str | None, sizes: Sizes, say: Progress) -> dict[str, Any]:
    """Measure a server through the client, and with prepared bytes where the client should not count.

    Parameters
    ----------
    url
        ``http://host:8000``, ``https://host/prefix`` or ``unix:/path/to/socket``.
    name, version
        Of the model.
    token
        Where the server wants one.
    sizes
        How much.
    say
        Gets what is being measured.

    Returns
    -------
    A document of plain values.
    """
    target = Target.parse(url, token)
    with Model.connect(url, name, version=version, token=token) as model:
        questions, raw = Questions(model.description), RawClient(target, model)
        say("single waveforms")
        single = single_costs(model, questions, sizes)
        say("breakdown")
        breakdown = remote_breakdown(model, raw, questions, sizes.points, sizes.epochs)
        say("batches")
        batches = batch_costs(model, questions, sizes)
        say("many clients")
        crowds = concurrency(target, raw, questions, sizes.clients, sizes.load_seconds)
        description = model.description
    return {
        "model": description,
        "single": single,
        "breakdown": breakdown,
        "batches": batches,
        "concurrency": crowds,
    }
