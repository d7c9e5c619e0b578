"""One version everywhere: the protocol states it, everything else repeats it."""

import re
import tomllib

import pytest

from bnserve_protocol import __version__
from tests.architecture.rooms import ROOMS, ROOT, python_files

VERSION_FILE = "protocol/bnserve_protocol/_version.py"


@pytest.mark.parametrize("folder", [".", *ROOMS])
def test_every_distribution_takes_its_version_from_the_protocol(folder):
    with (ROOT / folder / "pyproject.toml").open("rb") as file:
        settings = tomllib.load(file)
    source = ROOT / folder / settings["tool"]["hatch"]["version"]["path"]
    assert settings["project"]["dynamic"] == ["version"]
    assert source.resolve() == (ROOT / VERSION_FILE).resolve()


def test_no_room_states_another_version():
    stated = {path: (ROOT / path).read_text() for path in python_files(*ROOMS) if path.name == "_version.py"}
    assert {path for path, text in stated.items() if f'__version__ = "{__version__}"' not in text} == set()


def test_the_citation_names_this_version():
    assert f"\nversion: {__version__}\n" in (ROOT / "CITATION.cff").read_text()


def test_the_changelog_begins_with_this_version():
    headings = re.findall(r"^## \[(\d[^]]*)\]", (ROOT / "CHANGELOG.md").read_text(), flags=re.MULTILINE)
    assert headings[0] == __version__
