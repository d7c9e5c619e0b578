"""A SLURM of one node: Debian's daemons, in the foreground of the tests, with all that they write in one folder."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

from tests.integration.workers import until
from tests.running_server import free_port, running

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch")
_SBIN = ("/usr/sbin", "/usr/local/sbin")


def unavailable() -> str:
    """Why it cannot run here; empty if it can."""
    if os.getuid() != 0:
        return "only root can run jobs as their users"
    path = os.pathsep.join([os.environ.get("PATH", ""), *_SBIN])
    missing = [program for program in PROGRAMS if shutil.which(program, path=path) is None]
    return f"not installed: {', '.join(missing)}" if missing else ""


@dataclass
class Slurm:
    """One that runs."""

    environment: dict[str, str]

    def ask(self, *command: str) -> str:
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, timeout=60)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout.strip()

    def submit(self, *arguments: str) -> str:
        """Submit a job; its number."""
        return self.ask("sbatch", "--parsable", *arguments)

    def state(self, job: str) -> str:
        return self.ask("scontrol", "--oneliner", "show", "job", job).partition("JobState=")[2].split()[0]


def _configuration(folder: Path) -> str:
    node = socket.gethostname().partition(".")[0]
    return f"""
ClusterName=test
SlurmctldHost={node}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
AuthType=auth/munge
AuthInfo=socket={folder}/munged.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/linear
ReturnToService=2
MpiDefault=none
NodeName={node} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} RealMemory=1000 State=UNKNOWN
PartitionName=test Nodes={node} Default=YES MaxTime=INFINITE State=UP
"""


@contextmanager
def slurm(folder: Path) -> Iterator[Slurm]:
    """Start the daemons; jobs inherit this environment."""
    for name in ("state", "spool"):
        (folder / name).mkdir()
    file = folder / "slurm.conf"
    file.write_text(_configuration(folder))
    key = folder / "munge.key"
    key.write_bytes(os.urandom(128))
    key.chmod(0o400)
    folder.chmod(0o755)
    path = os.pathsep.join([os.environ.get("PATH", ""), *_SBIN])  # as the test has it now
    environment = os.environ | {"SLURM_CONF": str(file), "PATH": path}
    made = Slurm(environment)

    def idle() -> bool:
        done = subprocess.run(["sinfo", "-h", "-o", "%T"], env=environment, capture_output=True, text=True, check=False)
        return done.stdout.strip() == "idle"

    files = {name: f"{folder}/munged.{name}" for name in ("socket", "log-file", "pid-file", "seed-file")}
    munged = [
        "munged",
        "--foreground",
        "--force",
        f"--key-file={key}",
        *(f"--{name}={at}" for name, at in files.items()),
    ]
    with ExitStack() as stack:

        def start(command: list[str], ready) -> None:
            stack.enter_context(running(command, folder / f"{command[0]}.out", ready, env=environment))

        start(munged, (folder / "munged.socket").exists)
        start(["slurmctld", "-D"], (folder / "slurmctld.pid").exists)
        start(["slurmd", "-D"], idle)
        try:
            yield made
        except BaseException:
            made.ask("scancel", "--me")  # or what it runs would outlive the tests
            raise
        finally:
            until(lambda: not made.ask("squeue", "-h"), "no job is left")
