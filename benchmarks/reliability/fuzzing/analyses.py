"""``python -m benchmarks.reliability.fuzzing.analyses``: ten thousand analyses that are odd, and their likelihoods.

Half are uploaded to a server, changed in their numbers or their structure, half are made of odd data, priors and
settings (:mod:`tests.fuzz.likelihoods`). Each is refused with a reason, or its likelihoods are finite and right, or
flagged; those of the server have the bits of those here. What breaks that is written to ``--found``, and the exit
status is 77.
"""

from __future__ import annotations

import argparse
import http.client
import sys
import traceback
from collections import Counter
from pathlib import Path
from random import Random

import numpy as np

from benchmarks.reliability.serving import serving
from bnserve_inference import likelihood
from bnserve_protocol import BnserveError, decode_analysis, likelihood_samples
from bnserve_protocol.wire import MSGPACK, decode_likelihood_answer, encode_likelihood_request
from tests.fuzz.likelihoods import MOST_WORK, batch_of, model
from tests.fuzz.targets import TARGETS, Target

HEADERS = {"content-type": MSGPACK, "accept": MSGPACK}


class Fault(Exception):
    """What must not be."""


def main() -> None:
    """Try them all; say how many were refused and how many evaluated."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=10_000, help="analyses (10,000)")
    parser.add_argument("--seed", type=int, default=0, help="of the first change; each has the next one")
    parser.add_argument("--found", type=Path, default=Path(), metavar="DIR", help="where to write what breaks it")
    options = parser.parse_args()
    seen: Counter[str] = Counter()
    with serving("--model", "fast") as server:
        connection = http.client.HTTPConnection(*server.address, timeout=60)
        for number in range(options.count):
            target = TARGETS[("analysis_evaluated", "analysis_made")[number % 2]]
            data = changed(target, options.seed + number)
            try:
                seen[f"{target.name} {'evaluated' if target(data) else 'refused'}"] += 1
                if target.name == "analysis_evaluated":
                    seen[f"server {served(connection, data)}"] += 1
            except Exception:
                traceback.print_exc()
                seen["faults"] += 1
                (options.found / f"{target.name}-{options.seed + number}").write_bytes(data)
                connection.close()
    print(f"{options.count:,} analyses: {', '.join(f'{name} {seen[name]:,}' for name in sorted(seen))}")
    sys.exit(77 if seen["faults"] else 0)


def changed(target: Target, seed: int) -> bytes:
    """One of its seeds, with a change."""
    seeds = target.seeds()
    return target.mutate(seeds[seed // 2 % len(seeds)], Random(seed))


def served(connection: http.client.HTTPConnection, data: bytes) -> str:
    """Upload an analysis and ask for likelihoods; what became of it.

    Raises
    ------
    Fault
        The server says something else than this process.
    """
    try:
        analysis = decode_analysis(data)
    except BnserveError:
        analysis = None
    name = "0" * 64 if analysis is None else analysis.digest.removeprefix("sha256:")
    status, answer = _ask(connection, "PUT", f"/v1/analyses/{name}", data)
    if (status in (200, 201)) != (analysis is not None) or status >= 500:
        raise Fault(f"{status} for an upload: {answer[:200]!r}")
    if analysis is None or likelihood_samples(analysis) > MOST_WORK or analysis.settings.model_digest is not None:
        return "refused" if analysis is None else "kept"
    nodes = 0 if analysis.settings.calibration is None else analysis.settings.calibration.nodes
    batch = batch_of(analysis.settings.detectors, nodes)
    body = encode_likelihood_request(analysis.digest, batch)
    status, answer = _ask(connection, "POST", f"/v1/models/fast/likelihoods/{name}", body)
    if status != 200:
        raise Fault(f"{status} for likelihoods: {answer[:200]!r}")
    found, here = decode_likelihood_answer(answer), likelihood(model(), analysis).evaluate(batch)
    if found.log_likelihood.tobytes() != here.log_likelihood.tobytes() or not np.array_equal(found.status, here.status):
        raise Fault("other bits than here")
    return "evaluated"


def _ask(connection: http.client.HTTPConnection, method: str, path: str, body: bytes) -> tuple[int, bytes]:
    connection.request(method, path, body, HEADERS)
    answer = connection.getresponse()
    return answer.status, answer.read()


if __name__ == "__main__":
    main()
