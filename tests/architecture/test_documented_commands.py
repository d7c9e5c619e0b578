"""A fresh clone is enough: the commands of the pages exist, take their options, and read what is in the repository."""

import re
import shlex
from contextlib import nullcontext

import pytest

from bnserve_service.cli import build_parser
from tests.architecture.rooms import ROOT, tracked_files

OUTSIDE = re.compile(r"(?<![\w.])\.\./[s]hared|[s]hared/data")
"""A folder that nobody but its author has. (The brackets keep this line from finding itself.)"""


def documented(pattern: str) -> list[tuple[str, str]]:
    """Page and text of every indented command that contains ``pattern``, up to a comment or a pipe."""
    found = []
    for path in tracked_files():
        if path.suffix == ".md":
            for line in (ROOT / path).read_text().splitlines():
                if line.startswith("    ") and (match := re.search(pattern, line)):
                    found.append((str(path), re.split(r"\s#|\s[|&><]", line[match.start() :])[0].strip()))
    return found


def without_brackets(command: str) -> list[str]:
    """The words of a command whose page shows options in brackets."""
    return [word.strip("[]") for word in shlex.split(command)]


@pytest.mark.parametrize(("page", "command"), documented(r"(?<![\w/-])(?:\.venv/bin/)?bnserve (?=[a-z])"))
def test_a_documented_command_takes_its_arguments(page, command):
    words = shlex.split(command)[1:]
    with pytest.raises(SystemExit, match="0") if "--help" in words else nullcontext():
        build_parser().parse_args(words)


@pytest.mark.parametrize(("page", "command"), documented(r"python -m benchmarks[\w.]*"))
def test_a_documented_measurement_exists_and_takes_its_options(page, command):
    _, _, module, *words = without_brackets(command)
    place = ROOT / module.replace(".", "/")
    sources = list(place.glob("**/*.py")) if place.is_dir() else [place.with_suffix(".py")]
    text = "".join(source.read_text() for source in sources)
    assert [word for word in words if word.startswith("--") and f'"{word}"' not in text] == []


@pytest.mark.parametrize(("page", "command"), documented(r"python -m benchmarks|bnserve (?:train|search|roq build)"))
def test_a_documented_command_reads_what_is_in_the_repository(page, command):
    inputs = [word for word in without_brackets(command) if re.match(r"(configs|benchmarks|docs)/", word)]
    assert [name for name in inputs if not (ROOT / name).parent.is_dir()] == []
    assert [name for name in inputs if name.endswith((".toml", ".md")) and not (ROOT / name).exists()] == []


def test_nothing_reads_a_folder_beside_the_repository():
    names = [path for path in tracked_files() if path.suffix in (".py", ".md", ".toml", ".sh", ".yaml", ".cfg")]
    assert [str(path) for path in names if OUTSIDE.search((ROOT / path).read_text())] == []
