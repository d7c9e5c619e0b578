"""What a process asks of the operating system: processors, a name, children, the file of a Unix socket.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import ctypes
import math
import os
from contextlib import suppress
from pathlib import Path

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""The service has its own worker threads; libraries that start more inside each of them only get in the way, and do
not see a container's CPU quota."""
_SUBREAPER = 36
"""``PR_SET_CHILD_SUBREAPER`` of Linux."""
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


def compute_in_one_thread() -> None:
    """Keep libraries from starting threads of their own; before numpy is imported."""
    for name in ONE_THREAD:
        os.environ.setdefault(name, "1")


def name_process(name: str) -> None:
    """Have ``ps`` and ``top`` call this process ``name`` (at most 15 characters), where the system can."""
    with suppress(OSError):
        Path("/proc/self/comm").write_text(name, encoding="ascii")


def become_subreaper() -> None:
    """Have processes whose own parent ends become children of this one.

    Raises
    ------
    OSError
        The system cannot.
    """
    if ctypes.CDLL(None, use_errno=True).prctl(_SUBREAPER, 1, 0, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "this system has no child subreapers")


class SocketFile:
    """The file that a server has just bound its Unix socket to: it removes it at the end, and never another's.

    Another server may take the path while this one drains.

    Parameters
    ----------
    path
        Where it is.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._made = _identity(path)

    def remove(self) -> None:
        """Remove it, unless it is gone, or what is there now was made by somebody else."""
        if self._made is not None and _identity(self._path) == self._made:
            self._path.unlink(missing_ok=True)


def _identity(path: Path) -> tuple[int, int, int] | None:
    """Device and number of the file, and when it was made: the number of a file that is gone may be given again."""
    try:
        about = path.lstat()
    except OSError:
        return None
    return about.st_dev, about.st_ino, about.st_mtime_ns
