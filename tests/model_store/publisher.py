"""A process that publishes, for the tests: ``publisher.py ROOT VERSION SEED [LABEL] [--die-at STEP | --then-huge]``."""

import os
import signal
import sys
from pathlib import Path

import numpy as np

from bnserve_protocol import BnserveError
from bnserve_store import ModelStore

STEPS = ("mkdir", "fsync", "rename", "replace", "rmdir", "unlink", "flock")


def die_at(step):
    """Kill this process, as kill -9 does, instead of the call number ``step`` to the file system."""
    import fcntl

    calls = 0

    def counted(original):
        def call(*arguments, **options):
            nonlocal calls
            calls += 1
            if calls == step:
                os.kill(os.getpid(), signal.SIGKILL)
            return original(*arguments, **options)

        return call

    for name in STEPS:
        module = fcntl if name == "flock" else os
        setattr(module, name, counted(getattr(module, name)))


def publish(root, version, values, seed, labels):
    try:
        ModelStore([root]).publish("gw", version, {"weights": values}, {"seed": seed}, labels=labels)
        print("published", flush=True)
    except BnserveError as error:
        print(type(error).__name__, error.detail, flush=True)


def main(root, version, seed, *more):
    labels = [more[0]] if more and not more[0].startswith("--") else ["stable"]
    if "--die-at" in more:
        die_at(int(more[-1]))
    random = np.random.default_rng(int(seed))
    publish(root, version, random.standard_normal(2_000), int(seed), labels)
    if "--then-huge" in more:
        publish(root, "9.0", random.standard_normal(100_000), int(seed), labels)
        ModelStore([root]).verify("gw")
        print("left:", *sorted(str(path.relative_to(root)) for path in Path(root).rglob("*")))


main(*sys.argv[1:])
