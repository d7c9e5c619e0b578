"""A machine whose first process is a real systemd: in namespaces of its own, with nothing but our units on it.

What it would write lies in memory: the tests leave nothing behind, and see nothing that was there before. It shares the
network, so that the tests can connect.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from tests.architecture.rooms import ROOT
from tests.integration.workers import children, until

UNITS = ROOT / "deploy" / "systemd"
TARGETS = ("sysinit", "basic", "sockets", "shutdown", "network", "multi-user")
"""What units count on, empty: no other service is started, and nothing tidies up."""
_SYSTEMD = "/lib/systemd/systemd"
_IN_MEMORY = ("/run", "/tmp", "/var/tmp", "/var/cache", "/var/lib/systemd", "/opt", "/home")
_NAMESPACES = ("--mount", "--pid", "--uts", "--ipc", "--cgroup")


def unavailable() -> str:
    """Why there can be no such machine here; empty if there can."""
    if os.getuid() != 0:
        return "only root can make namespaces"
    if not Path(_SYSTEMD).exists():
        return "systemd is not installed"
    if subprocess.run(["unshare", *_NAMESPACES, "--fork", "true"], capture_output=True, check=False).returncode:
        return "no namespaces can be made here"
    return "" if _cgroups() else "there are no control groups of version 2"


def _cgroups() -> Path | None:
    """Where those of version 2 are."""
    mounts = (line.split() for line in Path("/proc/self/mounts").read_text().splitlines())
    return next((Path(fields[1]) for fields in mounts if fields[2] == "cgroup2"), None)


@dataclass
class Machine:
    """One that runs."""

    folder: Path
    """Seen as ``/opt/test`` there."""
    pid: int

    def run(self, *command: str) -> subprocess.CompletedProcess:
        """Run a command there."""
        enter = ["nsenter", "--target", str(self.pid), "--mount", "--pid", "--uts", "--ipc", "--cgroup"]
        return subprocess.run([*enter, *command], capture_output=True, text=True, check=False, timeout=120)

    def systemctl(self, *arguments: str) -> str:
        done = self.run("systemctl", *arguments)
        assert done.returncode == 0, f"{arguments}: {done.stdout}{done.stderr}\n{self.log()}"
        return done.stdout

    def log(self) -> str:
        """What the service printed."""
        file = self.folder / "service.log"
        return file.read_text() if file.exists() else ""


def _program(rooms: str) -> str:
    """``/opt/bnserve/bin/bnserve`` of that machine: these rooms, with the interpreter and the packages of the tests."""
    python = f"/opt/python/bin/python{sys.version_info.major}.{sys.version_info.minor}"
    # Its shared library, too, which it would look for where it was installed.
    environment = f"LD_LIBRARY_PATH=/opt/python/lib PYTHONPATH={rooms}:/opt/packages"
    return f'#!/bin/sh\nexport {environment}\nexec {python} -m bnserve_service "$@"\n'


def install(folder: Path, rooms: str) -> None:
    """Put the program in the place of what is there, as an upgrade does."""
    fresh = folder / "bin" / "bnserve.new"
    fresh.parent.mkdir(exist_ok=True)
    fresh.write_text(_program(rooms))
    fresh.chmod(0o755)
    fresh.replace(folder / "bin" / "bnserve")


def rooms_at(place: str) -> str:
    """The rooms of this checkout, as that machine sees them."""
    return ":".join(f"{place}/{room}" for room in ("protocol", "model_store", "surrogate", "inference", "service"))


def _prepare(folder: Path, drop_ins: dict[str, str], settings: str) -> None:
    units = folder / "units"
    units.mkdir()
    for unit in UNITS.iterdir():
        if unit.suffix in (".service", ".socket"):
            shutil.copy(unit, units)
    for target in TARGETS:
        (units / f"{target}.target").write_text("[Unit]\nDefaultDependencies=no\n")
    for unit, text in drop_ins.items():
        (units / f"{unit}.d").mkdir()
        (units / f"{unit}.d" / "test.conf").write_text(text)
    (folder / "bnserve.toml").write_text(settings)
    install(folder, rooms_at("/opt/rooms"))


def _script(folder: Path) -> str:
    """What happens between the new namespaces and the first process of the machine."""
    binds = {
        folder: "/opt/test", folder / "bin": "/opt/bnserve/bin", ROOT: "/opt/rooms",
        Path(sysconfig.get_paths()["purelib"]): "/opt/packages", Path(sys.base_prefix): "/opt/python",
    }  # fmt: skip
    held = {
        source: f"/mnt/{number}" for number, source in enumerate(binds)
    }  # /opt hides none of them before they moved
    lines = ["set -e", "mount --make-rprivate /", "mount -t tmpfs tmpfs /mnt"]
    for source, place in held.items():
        lines += [f"mkdir {place}", f"mount --rbind {shlex.quote(str(source))} {place}"]
    lines += [f"mount -t tmpfs tmpfs {place}" for place in _IN_MEMORY]
    layers = "lowerdir=/etc,upperdir=/run/etc/upper,workdir=/run/etc/work"
    lines += ["mkdir -p /run/etc/upper /run/etc/work", f"mount -t overlay overlay -o {layers} /etc"]
    for source, place in binds.items():
        lines += [f"mkdir -p {place}", f"mount --rbind {held[source]} {place}"]
    lines += [
        "umount -l /sys/fs/cgroup", "mount -t cgroup2 none /sys/fs/cgroup",
        f"systemd-sysusers /opt/rooms/{(UNITS / 'bnserve.sysusers').relative_to(ROOT)}",
        "install -d -m 750 -g bnserve /etc/bnserve",
        "install -m 640 -g bnserve /opt/test/bnserve.toml /etc/bnserve/bnserve.toml",
        "chmod 755 /opt /opt/test", "chmod 777 /opt/test/shared",
        "exec env -i PATH=$PATH container=test SYSTEMD_UNIT_PATH=/opt/test/units "
        f"{_SYSTEMD} --system --unit=sockets.target --log-target=null --show-status=no",
    ]  # fmt: skip
    return "\n".join(lines)


@contextmanager
def machine(folder: Path, drop_ins: dict[str, str], settings: str) -> Iterator[Machine]:
    """Start one with our units, to which ``drop_ins`` are added by name, and with these settings of the service."""
    (folder / "shared").mkdir()
    _prepare(folder, drop_ins, settings)
    above = _cgroups()
    assert above is not None
    group = above / f"bnserve-test-{os.getpid()}"
    group.mkdir()
    unshare = ["unshare", *_NAMESPACES, "--fork", "--kill-child", "--mount-proc", "sh", "-c", _script(folder)]
    command = ["sh", "-c", f"echo $$ > {group}/cgroup.procs && exec {shlex.join(unshare)}"]
    try:
        with (folder / "machine.log").open("wb") as log:
            process = subprocess.Popen(command, stdout=log, stderr=log)
        try:
            first = until(lambda: _first_of(process, folder), "systemd runs")
            made = Machine(folder, first)
            until(
                lambda: made.run("systemctl", "is-system-running").stdout.strip() in ("running", "degraded"), "booted"
            )
            yield made
        finally:
            process.kill()
            process.wait()
    finally:
        _remove(group)


def _first_of(process: subprocess.Popen, folder: Path) -> int | None:
    """The number of the machine's first process, once it is systemd."""
    assert process.poll() is None, (folder / "machine.log").read_text()
    return next((pid for pid, name in children(process.pid).items() if name == "systemd"), None)


def _remove(group: Path) -> None:
    def empty() -> bool:
        for below in sorted(group.rglob("*/"), key=lambda path: -len(path.parts)):
            with suppress(OSError):
                below.rmdir()
        with suppress(OSError):
            group.rmdir()
        return not group.exists()

    until(empty, "all processes of the machine have ended")
