"""``python -m benchmarks.reliability.fuzzing TARGET``: look for bytes that break a reader, guided by its coverage.

Starts from valid messages and from what broke it before (``tests/fuzz/corpus``). What breaks it is written to a file
whose name is printed, and the exit status is 77 (a slow or large input: 70, 71).
"""

from __future__ import annotations

import argparse
import resource
import sys
import tempfile
from functools import partial
from pathlib import Path
from random import Random
from typing import cast

import atheris

with atheris.instrument_imports(
    include=[
        "bnserve_protocol",
        "bnserve_client",
        "bnserve_store",
        "bnserve_service.uploads.stores",
        "bnserve_inference",
        "tests.fuzz",
    ]
):
    from tests.fuzz.corpus import kept
    from tests.fuzz.targets import TARGETS, Target


def main() -> None:
    """Fuzz until the time is over or something breaks."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.reliability.fuzzing", description=__doc__)
    parser.add_argument("target", choices=sorted(TARGETS))
    parser.add_argument("--seconds", type=int, default=60, help="how long (60)")
    parser.add_argument("--memory", type=int, default=64, metavar="MIB", help="what it may grow by (64 MiB)")
    parser.add_argument("--found", type=Path, default=Path(), metavar="DIR", help="where to write what breaks it")
    options = parser.parse_args()
    target = TARGETS[options.target]
    with tempfile.TemporaryDirectory() as folder:
        for number, data in enumerate([*target.seeds(), *(path.read_bytes() for path in kept(target.name))]):
            target(data)
            (Path(folder) / str(number)).write_bytes(data)
        limits = [f"-max_total_time={options.seconds}", "-timeout=120", f"-rss_limit_mb={resident() + options.memory}"]
        where = f"-artifact_prefix={options.found.resolve()}/{target.name}-"
        program = [sys.argv[0], *limits, where, "-max_len=8192", "-print_final_stats=1", folder]
        atheris.Setup(program, target, custom_mutator=partial(mutate, target))
        atheris.Fuzz()


def mutate(target: Target, data: bytes, max_size: int, seed: int) -> bytes:
    """A change in the structure of a message where it still has one, or one of bytes."""
    if seed % 4:
        return cast(bytes, atheris.Mutate(data, max_size))
    try:
        return target.mutate(data, Random(seed))[:max_size]
    except (ValueError, TypeError, KeyError, LookupError, RecursionError, OverflowError):
        return cast(bytes, atheris.Mutate(data, max_size))


def resident() -> int:
    """The most memory of this process, or of the one that started it (the system does not tell them apart), MiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024


if __name__ == "__main__":
    main()
