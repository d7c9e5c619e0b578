"""The locks of the container: every package by its hash, and everything that serving needs is among them."""

import re
import tomllib

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from tests.architecture.rooms import ROOMS, ROOT

ENTRY = re.compile(r"^([\w.-]+)==(\S+)((?:.*\\\n +--hash=sha256:[0-9a-f]{64})+)", re.MULTILINE)
"""Name, version and the hashes below."""


def locked(name: str) -> dict[str, list[str]]:
    """Versions of every package of a lock (several where they depend on the interpreter)."""
    versions: dict[str, list[str]] = {}
    for package, version, _ in ENTRY.findall((ROOT / name).read_text()):
        versions.setdefault(canonicalize_name(package), []).append(version)
    return versions


def requirements(folder: str, *keys: str) -> list[Requirement]:
    with (ROOT / folder / "pyproject.toml").open("rb") as file:
        table = tomllib.load(file)
    for key in keys:
        table = table[key]
    own = {f"bnserve-{package.removeprefix('bnserve_')}" for package in ROOMS.values()}
    return [needed for text in table if (needed := Requirement(text)).name not in own]


@pytest.mark.parametrize("name", ["requirements.lock", "requirements-build.lock"])
def test_every_package_is_pinned_by_hash(name):
    text = (ROOT / name).read_text()
    assert len(ENTRY.findall(text)) == len(re.findall(r"^[^\s#]", text, re.MULTILINE)) > 0


@pytest.mark.parametrize("folder", [folder for folder in ROOMS if folder not in ("posterior", "jax_model", "client")])
def test_the_lock_satisfies_every_room_that_serves(folder):
    versions = locked("requirements.lock")
    for needed in requirements(folder, "project", "dependencies"):
        assert all(version in needed.specifier for version in versions[canonicalize_name(needed.name)]), needed


@pytest.mark.parametrize("folder", ROOMS)
def test_the_lock_builds_every_room(folder):
    versions = locked("requirements-build.lock")
    for needed in requirements(folder, "build-system", "requires"):
        assert all(version in needed.specifier for version in versions[needed.name]), needed


def test_training_is_not_served():
    assert {"scikit-learn", "scipy", "optuna", "joblib", "teobresums", "matplotlib", "numba"} & set(
        locked("requirements.lock")
    ) == set()
