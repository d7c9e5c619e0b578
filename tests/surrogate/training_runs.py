"""Small training configurations, and the command line that runs them."""

import copy
import json
import os
import subprocess
import sys
from pathlib import Path

from bnserve_service.cli import main
from tests.surrogate import smooth_waveforms

ROOT = Path(__file__).parents[2]
SMOOTH = {
    "name": "smooth",
    "version": "1.0.0",
    "generator": {"name": "callable", "options": {"path": f"{smooth_waveforms.PATH}:waveform"}},
    "nodes": {"count": 60},
    "dataset": {"count": 200},
    "reduction": {"components": 6},
    "regressor": {"polynomial": {"degree": 4}},
    "validation": {"count": 12, "edge_count": 6},
}
"""200 waveforms of :mod:`tests.surrogate.smooth_waveforms`, which a polynomial of degree 4 reproduces to rounding."""
QUICK = {
    "dataset": {"count": 40},
    "regressor": {"polynomial": {"degree": 2}},
    "validation": {"count": 4, "edge_count": 0},
}


def merged(*tables):
    """The first table with the later ones written over it, section by section."""
    result = {}
    for table in tables:
        for key, value in table.items():
            if isinstance(value, dict) and key != "options":
                result[key] = merged(result.get(key, {}), value)
            else:
                result[key] = copy.deepcopy(value)
    return result


def as_toml(table, prefix=""):
    """TOML of nested tables whose values are also JSON."""
    lines, sections = [], []
    for key, value in table.items():
        if isinstance(value, dict):
            sections.append(f"[{prefix}{key}]\n{as_toml(value, f'{prefix}{key}.')}")
        else:
            lines.append(f"{key} = {json.dumps(value)}\n")
    return "".join(lines + sections)


def written(directory, *changes, base=SMOOTH):
    """The path of a configuration file."""
    path = directory / "config.toml"
    path.write_text(as_toml(merged(base, *changes)))
    return path


def arguments(directory, configuration, *more):
    """Of ``bnserve train``, with store and work below ``directory``."""
    return [
        "train", str(configuration), "--store", str(directory / "store"), "--work", str(directory / "work"),
        "--no-progress", *more,
    ]  # fmt: skip


def train_here(directory, configuration, *more, report=False):
    """``bnserve train`` in this process; the exit code."""
    here = ["--jobs", "1", "--backend", "sequential", *([] if report else ["--no-report"])]
    return main(arguments(directory, configuration, *here, *map(str, more)))


def environment(**variables):
    """For a process that finds the tests' modules."""
    path = os.pathsep.join([str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])])
    return {**os.environ, "PYTHONPATH": path, **variables}


def in_a_process(command, script=None, **variables):
    """``bnserve`` with these arguments in a process of its own, after running ``script``."""
    begin = "import sys\nfrom bnserve_service.cli import main\n"
    code = f"{script or ''}\n{begin}sys.exit(main(sys.argv[1:]))"
    return subprocess.Popen(
        [sys.executable, "-c", code, *map(str, command)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment(**variables),
    )  # fmt: skip


def digests(manifest):
    """The digest of every tensor."""
    return {name: entry.sha256 for name, entry in manifest.tensors.items()}
