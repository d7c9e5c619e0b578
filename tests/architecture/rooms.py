"""The rooms of the repository, its files, and a way to look at an import from a fresh interpreter."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

ROOMS = {
    "protocol": "bnserve_protocol",
    "model_store": "bnserve_store",
    "surrogate": "bnserve_surrogate",
    "inference": "bnserve_inference",
    "posterior": "bnserve_posterior",
    "jax_model": "bnserve_jax",
    "service": "bnserve_service",
    "client": "bnserve_client",
}
"""Folder of each room and the package in it."""


def tracked_files() -> list[Path]:
    """Everything that git tracks or would track, relative to the root."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, check=True, text=True).stdout
    return sorted(path for name in listed.split("\0") if name and (ROOT / (path := Path(name))).is_file())


def python_files(*folders: str) -> list[Path]:
    """The tracked Python files below some top-level folders (all of them by default)."""
    return [path for path in tracked_files() if path.suffix == ".py" and (not folders or path.parts[0] in folders)]


def room_environment(*rooms: str) -> dict[str, str]:
    """An environment whose ``PYTHONPATH`` holds these rooms of this checkout (all of them by default)."""
    folders = [str(ROOT / room) for room in rooms or ROOMS]
    return os.environ | {"PYTHONPATH": os.pathsep.join(folders)}


def run_python(code: str, *arguments: str, **options) -> str:
    """Run code in a fresh interpreter and return what it printed; a failure shows its standard error."""
    options.setdefault("env", room_environment())
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=False, **options
    )
    assert done.returncode == 0, done.stderr
    return done.stdout
