"""The clients in other languages: built as their first lines say, and they print the numbers that Python has."""

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

CLIENTS = Path(__file__).parents[2] / "examples" / "clients"
BINARIES = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": [600.0, 700.0], "chi_1": 0.01, "chi_2": 0.0,
    "distance_mpc": 40.0, "inclination": 2.5, "total_mass": 2.76,
}  # fmt: skip


@pytest.fixture
def expected(local) -> list[tuple[float, float]]:
    """Real and imaginary part of h_plus, where the clients look at it."""
    waveforms = local.predict_batch(20.0 + 0.25 * np.arange(8113), BINARIES)
    return [(value.real, value.imag) for value in waveforms.plus[:, -1000]]


def run(*command: str | Path, **environment: str) -> str:
    tool = str(command[0])
    assert shutil.which(tool), f"{tool} is not installed (tests/run.sh does)"
    done = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, check=False, timeout=300,
        env=os.environ | environment,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


def read(printed: str) -> list[tuple[float, float]]:
    rows = [line.split() for line in printed.splitlines()]
    assert [row[0] for row in rows] == ["0", "1"]
    return [(float(real), float(imaginary)) for _, real, imaginary in rows]


@pytest.fixture(scope="module")
def packages(tmp_path_factory) -> Path:
    """A folder with the two MessagePack libraries of JavaScript."""
    folder = tmp_path_factory.mktemp("javascript")
    run("npm", "install", "--silent", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", folder,
        "@msgpack/msgpack", "msgpackr")  # fmt: skip
    return folder


@pytest.mark.parametrize("library", ["@msgpack/msgpack", "msgpackr"])
def test_javascript(bnserve_server, packages, expected, library):
    script = (CLIENTS / "waveforms.mjs").read_text(encoding="utf-8").replace("@msgpack/msgpack", library)
    (packages / "waveforms.mjs").write_text(script, encoding="utf-8")
    assert read(run("node", packages / "waveforms.mjs", bnserve_server.address)) == expected


def test_c(bnserve_server, tmp_path, expected):
    flags = run("pkg-config", "--cflags", "--libs", "libcurl", "msgpack").split()
    run("cc", "-Wall", "-Wextra", "-Werror", CLIENTS / "waveforms.c", "-o", tmp_path / "waveforms", *flags)
    assert read(run(tmp_path / "waveforms", bnserve_server.address)) == expected


def test_go(bnserve_server, tmp_path, expected):
    """With the package of Debian; elsewhere `go get github.com/vmihailenco/msgpack/v5` in a module of one's own."""
    settings = {"GO111MODULE": "off", "GOPATH": "/usr/share/gocode", "GOCACHE": str(tmp_path / "cache"), "GOFLAGS": ""}
    run("go", "build", "-o", tmp_path / "waveforms", CLIENTS / "waveforms.go", **settings)
    assert read(run(tmp_path / "waveforms", bnserve_server.address)) == expected
