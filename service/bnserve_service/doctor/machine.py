"""Whether this machine, or this container, has what a server with given settings needs."""

from __future__ import annotations

import os
import resource
import tempfile
import time
from pathlib import Path

from bnserve_service import _version
from bnserve_service.doctor.findings import Findings, fault, ok, warning
from bnserve_service.process.system import available_cpus
from bnserve_service.settings import Settings
from bnserve_service.shared.folder import free_bytes, usual_places

MIB = 2**20
FEWEST_FILES, USUAL_FILES = 256, 1024
"""Open files: each connection is one. Below the first, a few samplers use them up; the second is Linux's default."""
PROCESS_BYTES, WORKER_BYTES = 90 * MIB, 17 * MIB
"""Of a server, and of each worker beside that: docs/guides/operations.md, "Sizes"."""
LEAST_BYTES = 256 * MIB
"""A server with one model and small answers."""
_CGROUP_MEMORY = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")
_CLOCK_SLACK = 86_400.0
"""Seconds: files may come from a machine in another time zone that took its local time for UTC."""


def shared_folder(settings: Settings) -> Findings:
    """Workers share uploads in memory, where it can be written and has room."""
    needed = settings.max_grid_bytes + settings.max_analyses_bytes + settings.max_networks_bytes
    usable = []
    for place in usual_places():
        reason = _why_not_writable(place)
        if reason is not None:
            yield warning(f"{place}", f"cannot be written: {reason}", "make it writable, or mount a tmpfs there")
        elif free_bytes(place) < needed:
            usable.append(place)
            yield warning(
                f"{place}", f"{_mib(free_bytes(place))} are free, and uploads may take {_mib(needed)} with --workers",
                "give it room (docker run --shm-size 2g), or lower max_grid_bytes and max_analyses_bytes",
            )  # fmt: skip
        else:
            usable.append(place)
            yield ok(f"{place}", f"writable, {_mib(free_bytes(place))} free for what workers share")
    if not usable:
        yield fault("shared folder", "no place for it can be written: `bnserve serve --workers` cannot start",
                    "make /dev/shm or the folder named by TMPDIR writable")  # fmt: skip


def _why_not_writable(place: Path) -> str | None:
    try:
        with tempfile.TemporaryFile(dir=place) as file:
            file.write(bytes(4096))
    except OSError as error:
        return error.strerror or str(error)
    return None


def _mib(count: float) -> str:
    return f"{count / MIB:,.0f} MiB"


def open_files() -> Findings:
    """Each connection takes one."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    says = f"this process may open {soft} files, and each connection is one"
    do = "raise it with `ulimit -n 65536`, or LimitNOFILE= of systemd" + (f" (up to {hard})" if hard >= 0 else "")
    if 0 <= soft < FEWEST_FILES:
        yield fault("open files", says, do)
    elif 0 <= soft < USUAL_FILES:
        yield warning("open files", says, do)
    else:
        yield ok("open files", f"{soft if soft >= 0 else 'any number'} at a time")


def memory(settings: Settings) -> Findings:
    """The bounds in the settings against what the control group or the machine has."""
    available = memory_limit()
    bound = PROCESS_BYTES + settings.max_grid_bytes + settings.max_analyses_bytes + settings.max_networks_bytes
    bound += settings.workers * (WORKER_BYTES + settings.max_answer_bytes + settings.incoming_bytes)
    says = f"{_mib(available)} are there, and the limits in the settings add up to {_mib(bound)}"
    if available < LEAST_BYTES:
        yield fault("memory", f"{_mib(available)} are there; a server takes {_mib(LEAST_BYTES)}", "give it more")
    elif available < bound:
        yield warning("memory", says, "under full load it may be killed: give it more, lower max_answer_bytes, "
                      "max_grid_bytes and max_analyses_bytes, or run fewer workers")  # fmt: skip
    else:
        yield ok("memory", says)


def memory_limit() -> int:
    """Bytes that this process may take: those of its control group, or of the machine."""
    limit = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    for name in _CGROUP_MEMORY:
        try:
            text = Path(name).read_text(encoding="ascii").strip()
        except OSError:
            continue
        limit = min(limit, int(text)) if text.isdigit() else limit
    return limit


def processors(settings: Settings) -> Findings:
    """Threads of all workers against the CPU quota."""
    cpus = available_cpus()
    threads = settings.threads or max(1, cpus // settings.workers)
    says = f"{cpus} by affinity and quota; {settings.workers} worker(s) with {threads} thread(s) each"
    if settings.workers * threads > cpus:
        yield warning("processors", says, "more threads than processors wait for each other: lower workers or threads")
    else:
        yield ok("processors", says)


def clock() -> Findings:
    """It must not be before the installation."""
    installed = Path(_version.__file__).stat().st_mtime
    if time.time() < installed - _CLOCK_SLACK:
        yield fault("clock", f"it says {time.ctime()}, and bnserve was installed on {time.ctime(installed)}", "set it")
    else:
        yield ok("clock", time.strftime("%Y-%m-%d %H:%M:%S UTC", time.gmtime()))
