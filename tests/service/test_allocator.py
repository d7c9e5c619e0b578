"""The memory of a server process: kept for the next answer. In a process of its own, because it is for good."""

import platform

import pytest

from tests.architecture.rooms import run_python

USED_AGAIN = """
import resource
import numpy as np
from bnserve_service.allocator import forget_what_is_imported, keep_freed_memory

kept = keep_freed_memory()
forget_what_is_imported()

def faults():
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt

def answer():
    return [np.ones(2**18) for _ in range(4)]  # 2 MiB are 512 pages

answer()
before = faults()
for _ in range(50):
    answer()
print(kept, faults() - before)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries have an allocator of their own")
def test_freed_memory_is_used_again():
    kept, faults = run_python(USED_AGAIN).split()
    assert kept == "True"
    assert int(faults) < 512
