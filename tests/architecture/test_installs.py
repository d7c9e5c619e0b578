"""No line of ours installs one of our distributions by its bare name, which on the index could be a stranger's."""

import re
import tomllib

import pytest

from tests.architecture.rooms import ROOMS, ROOT
from tests.architecture.test_files import texts

INSTALL = re.compile(
    r"\b(?:pip3?|pipx|uv|conda|mamba|poetry|pdm)\s+(?:-\S+\s+)*(?:pip\s+|tool\s+)?(?:install|add|download|run)\b|\buvx\b"
)
"""How a command begins that takes distributions from an index."""
BARE = re.compile(r"(?<![\w./@{-])bnserve(?:[-_][a-z]+)?(?=\[|[<>=~!]=|[\s'\"`),;.]|$)")
"""A name of ours that is no path, no module and no part of a longer word."""
ROOM = re.compile(r"\./(\w+)")
END = re.compile(r"&&|\|\||[;|`]|\.\s|\)\s|\\n|\s#|\s(?:in|installs|is)\s")
"""Where a command ends, in a shell or in a sentence."""
WITHOUT = re.compile(r"--no-deps|--dry-run")


def installs() -> list[tuple[str, str]]:
    """File and arguments of every command that installs something; continued lines are one."""
    found = []
    for name, text in texts():
        if name.startswith("tests/architecture/test_installs"):
            continue
        for line in re.sub(r"\\\n\s*", " ", text).splitlines():
            for match in INSTALL.finditer(line):
                found.append((name, END.split(line[match.end() :], maxsplit=1)[0]))
    return found


def needed(room: str) -> set[str]:
    """The rooms that a room depends on, by their folders."""
    folders = {
        tomllib.loads((ROOT / other / "pyproject.toml").read_text())["project"]["name"]: other for other in ROOMS
    }
    project = tomllib.loads((ROOT / room / "pyproject.toml").read_text())["project"]
    direct = {folders[name] for name in project["dependencies"] if name in folders}
    return direct.union(*(needed(other) for other in direct))


def missing(arguments: str) -> set[str]:
    """The rooms that pip would look for on the index: those installed need them, and the command does not name them."""
    named = set(ROOM.findall(arguments)) & set(ROOMS)
    return set().union(*(needed(room) for room in named)) - named


def test_nothing_is_installed_by_a_bare_name():
    assert len(installs()) > 50
    assert [(name, arguments) for name, arguments in installs() if BARE.search(arguments)] == []


def test_rooms_are_installed_with_the_rooms_that_they_need():
    listed = [(name, arguments) for name, arguments in installs() if not WITHOUT.search(arguments)]
    assert [(name, arguments, gone) for name, arguments in listed if (gone := missing(arguments))] == []


@pytest.mark.parametrize(
    "command",
    ["pip install bnserve", "pip install 'bnserve[train]'", "uv pip install -q numpy bnserve-client>=0.5",
     "pipx install bnserve_service", "uvx bnserve demo", "python -m pip install bnserve."],
)  # fmt: skip
def test_a_bare_name_is_found(command):
    assert BARE.search(command[INSTALL.search(command).end() :])


def test_what_is_of_the_checkout_is_none():
    for command in ("pip install .", "pip install ./protocol './client[bilby]'", "pip install dist/bnserve-0.5-py3.whl",
                    "pip install git+https://host/bnserve.git"):  # fmt: skip
        assert not BARE.search(command), command
    assert missing(" ./client") == {"protocol"}
    assert missing(" ./protocol './client[bilby]'") == set()
