"""What is in the repository: small modules, nothing of the machine that wrote it, nothing huge."""

import re

import pytest

from tests.architecture.rooms import ROOMS, ROOT, python_files, tracked_files

MOST_LINES = 400
"""A longer module has become two nouns."""

LARGEST_FILE = 16 * 2**20
"""Bytes; a trained model is below, a data set above."""

MACHINE = re.compile(r"(?<![\w.])/(?:[w]ork|[r]oot|[f]arm|[h]ome/\w+)/")
"""Absolute paths into somebody's machine. (The brackets keep this line from finding itself.)"""

INDEX = re.compile(r"[-]-(?:extra-)?index-url|[-]-find-links|[f]iles\.pythonhosted\.org|[p]ypi\.org/simple")
"""Addresses of package indexes."""


def texts() -> list[tuple[str, str]]:
    """Name and content of every tracked text file."""
    found = []
    for path in tracked_files():
        content = (ROOT / path).read_bytes()
        if b"\0" not in content:
            found.append((str(path), content.decode(errors="replace")))
    return found


@pytest.mark.parametrize("pattern", [MACHINE, INDEX], ids=["machine paths", "index addresses"])
def test_no_file_carries_addresses_of_a_machine(pattern):
    hits = [(name, match.group()) for name, text in texts() for match in pattern.finditer(text)]
    assert hits == []


@pytest.mark.parametrize(
    ("pattern", "text"),
    [
        (MACHINE, "open('/{}/data.txt')".format("root")),
        (MACHINE, "cd /{}/someone/src".format("home")),
        (INDEX, "pip install -{}-url x".format("-index")),
    ],
)
def test_an_address_is_found(pattern, text):
    assert pattern.search(text)


def test_modules_are_small():
    lengths = {str(path): len((ROOT / path).read_text().splitlines()) for path in python_files()}
    assert {name: lines for name, lines in lengths.items() if lines > MOST_LINES} == {}


NAMED_BY_OTHERS = {
    "client/bnserve_client/compat/mlgw_bns.py": "is the module mlgw_bns of other programs",
    "jax_model/bnserve_jax/ripple.py": "imports ripple, which the package does without",
    "inference/bnserve_inference/adjoint_kernel/build.py": "run with `python -m`",
    "inference/bnserve_inference/fisher_kernel/build.py": "run with `python -m`",
    "inference/bnserve_inference/kernel/build.py": "run with `python -m`",
    "inference/bnserve_inference/marginal_kernel/build.py": "run with `python -m`",
    "inference/bnserve_inference/modes_kernel/build.py": "run with `python -m`",
    "inference/bnserve_inference/moving_kernel/build.py": "run with `python -m`",
    "surrogate/bnserve_surrogate/adjoint/build.py": "run with `python -m`",
    "surrogate/bnserve_surrogate/kernel/build.py": "run with `python -m`",
    "surrogate/bnserve_surrogate/precession/build.py": "run with `python -m`",
    "surrogate/bnserve_surrogate/tangents/build.py": "run with `python -m`",
    "surrogate/bnserve_surrogate/joblib_workers.py": "used by inference",
}
"""Public modules of packages that are an API, and why."""
PROGRAMS = ("service/bnserve_service", "surrogate/bnserve_surrogate/training")
"""Nobody imports what is in them but they themselves: no module is private there, nor in the folders below."""
APIS_IN_PROGRAMS = {"surrogate/bnserve_surrogate/training/data/generators"}


def test_modules_are_private_where_the_package_is_the_api():
    program, api = set(), set()
    for path in map(str, python_files(*ROOMS)):
        folder = path.rpartition("/")[0]
        is_program = path.startswith(PROGRAMS) and folder not in APIS_IN_PROGRAMS
        (program if is_program else api).add(path)
    assert {path for path in api if not path.rpartition("/")[2].startswith("_")} == set(NAMED_BY_OTHERS)
    private = {path for path in program if path.rpartition("/")[2].startswith("_") and not path.endswith("__.py")}
    assert private == {"service/bnserve_service/_version.py"}  # read without the protocol, which needs numpy


def test_no_file_is_huge():
    sizes = {str(path): (ROOT / path).stat().st_size for path in tracked_files()}
    assert {name: size for name, size in sizes.items() if size > LARGEST_FILE} == {}


def test_no_lock_file_of_one_tool_is_kept():
    assert "uv.lock" not in {path.name for path in tracked_files()}  # it would carry the addresses of package indexes
