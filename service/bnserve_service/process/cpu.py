"""How many processors this process may really use."""

from __future__ import annotations

import math
import os
from pathlib import Path

_CGROUP_V2 = Path("/sys/fs/cgroup/cpu.max")
_CGROUP_V1_QUOTA = Path("/sys/fs/cgroup/cpu/cpu.cfs_quota_us")
_CGROUP_V1_PERIOD = Path("/sys/fs/cgroup/cpu/cpu.cfs_period_us")


def available_cpus() -> int:
    """Processors by affinity mask and by container quota, whichever is smaller; at least one.

    Container runtimes limit CPU time through the quota of a control group, which ``os.cpu_count`` does not see.
    """
    by_affinity = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    quota = _container_quota()
    return max(1, min(by_affinity, math.ceil(quota)) if quota is not None else by_affinity)


def parse_cpu_max(text: str) -> float | None:
    """Processors granted by the content of cgroup v2's ``cpu.max`` (``"200000 100000"`` is 2.0); None if unlimited."""
    quota, _, period = text.strip().partition(" ")
    if quota == "max" or not quota.isdigit() or not period.isdigit() or int(period) == 0:
        return None
    return int(quota) / int(period)


def _container_quota() -> float | None:
    try:
        return parse_cpu_max(_CGROUP_V2.read_text())
    except OSError:
        pass
    try:
        return parse_cpu_max(f"{_CGROUP_V1_QUOTA.read_text().strip()} {_CGROUP_V1_PERIOD.read_text().strip()}")
    except OSError:
        return None
