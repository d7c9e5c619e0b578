"""Settings for every test."""

import atexit
import logging
import os
import shutil
import signal
import tempfile
from collections.abc import Iterator

import pytest
from hypothesis import settings

# As the commands do: with several, sums have other last bits from run to run. numpy reads it when it is imported.
for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

# Machine code that tests make is kept for the tests after them, and not in anybody's home.
os.environ["XDG_CACHE_HOME"] = tempfile.mkdtemp(prefix="bnserve-tests-")
atexit.register(shutil.rmtree, os.environ["XDG_CACHE_HOME"], ignore_errors=True)

# In a background shell interrupts are ignored, and every process started here would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Tests never assert on time: shared machines pause.
settings.register_profile("bnserve", deadline=None, derandomize=True)
settings.load_profile("bnserve")


@pytest.fixture(autouse=True)
def log_goes_where_it_went() -> Iterator[None]:
    """A command that a test calls logs to what is standard error then, which is closed when the next test logs."""
    root = logging.getLogger()
    before, level = list(root.handlers), root.level
    yield
    for handler in [handler for handler in root.handlers if handler not in before]:
        root.removeHandler(handler)
    root.setLevel(level)
