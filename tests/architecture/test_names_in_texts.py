"""Pages and docstrings name modules, functions and files that there are."""

import re

from tests.architecture.rooms import ROOMS, ROOT, tracked_files

FILES = {str(path) for path in tracked_files()}
FOLDERS = {str(parent) for path in tracked_files() for parent in path.parents}
TEXTS = [
    path
    for path in tracked_files()
    if path.suffix in (".md", ".py") and path.name not in ("CHANGELOG.md", "test_names_in_texts.py")
]
"""The changelog tells of what there was, and this test of what there is not."""
_FOLDER = "|".join([*ROOMS, "benchmarks", "docs", "tests", "deploy", "examples", "configs"])
_PATH = re.compile(rf"`((?:{_FOLDER})/[\w./-]*\w)/?`")
_DOTTED = re.compile(rf"(?<![\w./-])((?:{'|'.join(ROOMS.values())}|benchmarks)(?:\.\w+)+)(?![\w/])")
_ELSEWHERE = {"bnserve_client.html", "bnserve_protocol.nothing", "bnserve_service.__file__"}
"""A page of the site, what a test looks for in vain, and what Python gives to every package."""
_PATTERNS = {"configs/roq_NAME.toml"}
"""Names of several files."""


def is_there(dotted: str) -> bool:
    """Whether it is a module, or a name in the text of one."""
    parts = dotted.split(".")
    folder = {package: room for room, package in ROOMS.items()}.get(parts[0], "")
    for length in range(len(parts), 0, -1):
        stem = "/".join([folder, *parts[:length]]).lstrip("/")
        for module in (f"{stem}.py", f"{stem}/__init__.py"):
            if module in FILES:
                names = parts[length : length + 1]
                return all(re.search(rf"\b{name}\b", (ROOT / module).read_text()) for name in names)
    return False


def test_modules_and_functions_that_texts_name_are_there():
    named = {(str(path), name) for path in TEXTS for name in _DOTTED.findall((ROOT / path).read_text())}
    assert len(named) > 1000
    assert sorted(place for place in named if place[1] not in _ELSEWHERE and not is_there(place[1])) == []


def test_files_and_folders_that_texts_name_are_there():
    named = {(str(path), found) for path in TEXTS for found in _PATH.findall((ROOT / path).read_text())}
    assert len(named) > 50
    assert sorted(place for place in named if place[1] not in FILES | FOLDERS | _PATTERNS) == []


def test_what_is_not_there_is_found():
    assert is_there("bnserve_surrogate._artifact.ModeMetadata")
    assert not is_there("bnserve_surrogate._nothing")
    assert not is_there("bnserve_service.app.create_nothing")
