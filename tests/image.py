"""The image without an engine: built in a root of its own from Debian, and run there as an engine would run it.

    python -m tests.image             builds it below a temporary folder, runs it, and says what was seen; some minutes

Needs root, `debootstrap`, `unshare`, `nsenter` and `ip`, and the indexes of Debian and of Python packages. The steps
are those of the Dockerfile, each in the root of its stage; Debian's python3 stands for the base image. What was built
runs with a network, processes and mounts of its own: on a read-only root, with a `/tmp` in memory, as the image's
user, without rights, as process 1. The tests run the same steps in a folder (tests/integration/test_container.py).
"""

from __future__ import annotations

import argparse
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.integration.dockerfile import Builder, Image

ROOT = Path(__file__).parents[1]
PACKAGES = "python3,python3-venv,ca-certificates"
ANSWER = """
import json, urllib.request
from dataclasses import asdict
import numpy as np
from bnserve_surrogate import Model, ParametersWithExtrinsic
one, frequencies = ParametersWithExtrinsic.gw170817(), [20.0, 100.0, 1000.0]
request = urllib.request.Request(
    "http://127.0.0.1:8000/v1/models/default/waveforms",
    data=json.dumps({"parameters": asdict(one), "grid": {"frequencies": frequencies}}).encode(),
    headers={"Content-Type": "application/json", "Accept": "application/json"},
)
with urllib.request.urlopen(request, timeout=60) as response:
    plus = json.load(response)["h_plus"]
got = np.array(plus["re"][0]) + 1j * np.array(plus["im"][0])
assert np.array_equal(got, Model.default().predict(frequencies, one)[0])
"""
"""Asks inside, and compares with the bits of the model there."""
RUN = """
set -e
mount --bind "$1" "$1"
mount -t proc proc "$1/proc"
mount -t tmpfs tmpfs "$1/dev"
for device in null zero random urandom; do touch "$1/dev/$device"; mount --bind "/dev/$device" "$1/dev/$device"; done
mkdir "$1/dev/shm"
mount -t tmpfs -o size=64m tmpfs "$1/dev/shm"
mount -t tmpfs tmpfs "$1/tmp"
mount -o remount,bind,ro "$1"
if touch "$1/written" 2>/dev/null; then echo "the root can be written" >&2; exit 3; fi
ip link set lo up
shift
exec "$@"
"""
"""What an engine does before it starts the image's program, in the namespaces of the container."""


def say(text: str) -> None:
    print(f"{time.strftime('%H:%M:%S')}  {text}", flush=True)


class RootBuilder(Builder):
    """Runs the instructions in a root for each stage, with the paths that they name."""

    def __init__(self, base: Path, folder: Path) -> None:
        super().__init__(ROOT, folder, "python3", {})
        self.base, self.stages = base, folder / "stages"
        self.names: dict[str, Path] = {}

    def inside(self, text: str) -> str:
        return text

    def do_from(self, text: str) -> None:
        assert text.startswith("${BASE}")
        root = self.stages / str(len(self.names))
        self.names[text.partition(" AS ")[2] or "last"] = root
        subprocess.run(["cp", "--archive", "--reflink=auto", self.base, root], check=True)
        self.root, self.image, self.workdir = root, Image(root), Path("/")
        (root / "usr/local/bin").mkdir(parents=True, exist_ok=True)
        (root / "usr/local/bin/python").symlink_to("/usr/bin/python3")  # where the base image has it

    def do_workdir(self, text: str) -> None:
        self.workdir = Path(text)
        self.below(self.workdir).mkdir(parents=True, exist_ok=True)

    def below(self, path: Path) -> Path:
        return self.root / path.relative_to("/")

    def do_copy(self, text: str) -> None:
        *sources, target = text.split()
        place = self.below(self.workdir / target)
        if sources[0].startswith("--from="):
            other = self.names[sources[0].partition("=")[2]]
            shutil.copytree(other / sources[1].lstrip("/"), place, symlinks=True)
            return
        for name in sources:
            assert name in self.allowed, f"{name} is kept out by .dockerignore"
            self._copy(self.context / name, place)

    def do_run(self, text: str) -> None:
        say(f"RUN {text[:100]}")
        with index_of_packages(self.root) as environment:
            given = [f"{name}={value}" for name, value in (environment | self.image.environment).items()]
            command = f"cd {self.workdir} && {text}"
            subprocess.run(["chroot", self.root, "/usr/bin/env", "-i", *given, "sh", "-ec", command], check=True)


@contextmanager
def index_of_packages(root: Path) -> Iterator[dict[str, str]]:
    """How this machine reaches an index, in a root, for as long as a step runs: names, certificates, pip's settings."""
    places = [
        Path("/etc/resolv.conf"),
        Path("/etc/hosts"),
        Path("/etc/ssl/certs"),
        Path("/etc/pip.conf"),
        Path("/etc/xdg/pip"),
    ]
    mounted = []
    try:
        for place in places:
            if not place.exists():
                continue
            inside = root / place.relative_to("/")
            inside.parent.mkdir(parents=True, exist_ok=True)
            if not inside.exists():
                inside.mkdir() if place.is_dir() else inside.touch()
            subprocess.run(["mount", "--bind", place, inside], check=True)
            mounted.append(inside)
        known = {
            name: value
            for name, value in os.environ.items()
            if name.startswith(("PIP_", "SSL_CERT")) or "proxy" in name.lower()
        }
        quiet = {"PIP_QUIET": "1", "PIP_ROOT_USER_ACTION": "ignore"}
        yield known | quiet | {"PATH": "/usr/local/bin:/usr/bin:/bin", "HOME": "/root", "LANG": "C.UTF-8"}
    finally:
        for inside in mounted:
            subprocess.run(["umount", inside], check=True)


class Container:
    """The image, running."""

    def __init__(self, image: Image, *options: str) -> None:
        user, group = image.user
        self.image = image
        self.inside = [
            "chroot",
            str(image.root),
            "/usr/bin/env",
            "-i",
            *(f"{k}={v}" for k, v in image.environment.items()),
        ]
        nobody = ["/usr/bin/setpriv", f"--reuid={user}", f"--regid={group}", "--clear-groups", "--no-new-privs",
                  "--bounding-set=-all", "--inh-caps=-all", "--ambient-caps=-all"]  # fmt: skip
        program = [*self.inside, *nobody, *image.entrypoint, *options]
        self.process = subprocess.Popen(
            ["unshare", "--mount", "--net", "--pid", "--ipc", "--uts", "--fork", "--kill-child", "sh", "-c", RUN, "sh",
             str(image.root), *program]
        )  # fmt: skip

    @property
    def pid(self) -> int:
        """Of process 1 in there, as it is numbered here."""
        return int(Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()[0])

    def run(self, command: list[str]) -> bool:
        """Run something beside it, as `docker exec` does; whether it ended well."""
        namespaces = ["nsenter", f"--target={self.pid}", "--mount", "--net", "--pid"]
        user, group = self.image.user
        become = ["/usr/bin/setpriv", f"--reuid={user}", f"--regid={group}", "--clear-groups"]
        return not subprocess.run(
            [*namespaces, *self.inside, *become, *command], check=False, capture_output=True
        ).returncode

    def wait_until_healthy(self) -> float:
        """Seconds until the image's own check passes."""
        begun = time.monotonic()
        while True:
            assert self.process.poll() is None, f"it ended with {self.process.returncode}"
            assert time.monotonic() - begun < 120.0, "it does not become healthy"
            try:
                if self.run(self.image.healthcheck):
                    return time.monotonic() - begun
            except (OSError, IndexError):  # not there yet
                pass
            time.sleep(0.2)

    def status(self) -> dict[str, str]:
        """What the kernel says of process 1."""
        lines = Path(f"/proc/{self.pid}/status").read_text().splitlines()
        return {name: value.strip() for name, _, value in (line.partition(":") for line in lines)}


def check(image: Image, *options: str) -> None:
    """Start it, have it answer, look at what it may, and stop it."""
    container = Container(image, *options)
    try:
        seconds = container.wait_until_healthy()
        status = container.status()
        assert status["Uid"].split() == [str(image.user[0])] * 4, status["Uid"]
        assert status["NSpid"].split()[-1] == "1", "it is process 1"
        assert {int(status[name], 16) for name in ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb")} == {0}
        assert status["NoNewPrivs"] == "1"
        assert not container.run(["touch", "/written"])
        assert container.run(["touch", "/tmp/written"])
        assert container.run(["/opt/bnserve/bin/python", "-I", "-c", ANSWER]), "its answer is wrong"
        os.kill(container.pid, signal.SIGTERM)
        assert container.process.wait(40) == 0
    finally:
        container.process.kill()
    say(f"{' '.join(options) or 'as it is'}: healthy after {seconds:.1f} s, the bits of the model in it, ended with 0")


def files(root: Path) -> dict[str, int]:
    return {str(path): path.lstat().st_mtime_ns for path in root.rglob("*") if not path.is_mount()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--suite", default="trixie", help="of Debian (trixie)")
    parser.add_argument("--mirror", default="http://deb.debian.org/debian", help="of Debian")
    parser.add_argument("--base", type=Path, help="a root that debootstrap has made already")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="bnserve-image-") as name:
        folder = Path(name)
        folder.chmod(0o755)
        base = options.base
        if base is None:
            base = folder / "base"
            say(f"debootstrap {options.suite}")
            command = [
                "debootstrap",
                "--variant=minbase",
                f"--include={PACKAGES}",
                options.suite,
                str(base),
                options.mirror,
            ]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        (folder / "stages").mkdir()
        image = RootBuilder(base, folder).build()
        size = sum(path.lstat().st_size for path in (image.root / "opt").rglob("*")) / 2**20
        say(f"built: /opt/bnserve has {size:.0f} MiB; user {image.user[0]}, {' '.join(image.entrypoint)}")
        before = files(image.root)
        check(image)
        check(image, "--workers", "2")
        assert files(image.root) == before, "it changed a file"
    return 0


if __name__ == "__main__":
    sys.exit(main())
