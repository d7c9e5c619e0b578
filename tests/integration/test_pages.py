"""What the pages tell to type works: page by page, in order, against a running server.

``tests/programs/page.py`` says what is run. A page with ``<!-- run by: tests/programs.sh PROGRAM -->`` is run there, in
the environment of that program.
"""

import re
import tomllib

import pytest

from tests.architecture.rooms import ROOT, room_environment, tracked_files
from tests.programs import page

PAGES = {str(path): (ROOT / path).read_text(encoding="utf-8") for path in tracked_files() if path.suffix == ".md"}
RUN_BY = re.compile(r"^<!-- run by: tests/programs\.sh (\w+) -->$", re.MULTILINE)
RUN = [name for name, text in PAGES.items() if not RUN_BY.search(text) and any(b.is_run for b in page.blocks(text))]
WARNINGS = {"docs/tutorial.md": "default"}
"""Of samplers and what they import; on all other pages warnings are errors."""


def test_a_script_has_the_blocks_where_the_page_has_them():
    text = "# P\n\n```python\na = 1\n```\n\n<!-- not run: takes hours -->\n```python\nb\n```\n\n    curl x\n"
    lines = page.script(text).splitlines()
    assert (lines[3], lines[8]) == ("a = 1", "")
    assert "curl --silent" in lines[11]
    assert [number for number, line in enumerate(lines) if line] == [3, 11]


def test_an_indented_block_below_another_is_found():
    found = page.blocks(
        "x:\n\n    bnserve serve\n\n```python\na\n```\n\n<!-- not run: why -->\n\n    curl x\n\n    h = 1\n"
    )
    assert [(block.language, block.text) for block in found] == [
        ("shell", "bnserve serve"), ("python", "a"), ("shell", "curl x\n\nh = 1"),
    ]  # fmt: skip
    assert [block.is_run for block in found] == [False, True, False]


@pytest.mark.parametrize("name", RUN)
def test_the_blocks_of_a_page_run(name, bnserve_server, tmp_path, monkeypatch):
    for variable, value in room_environment().items():
        monkeypatch.setenv(variable, value)
    assert page.main(name, bnserve_server.address, tmp_path, ["-W", WARNINGS.get(name, "error")]) == 0


def test_a_page_of_another_program_is_run_where_it_says():
    programs = (ROOT / "tests" / "programs.sh").read_text(encoding="utf-8")
    for name, text in PAGES.items():
        for program in RUN_BY.findall(text):
            function = re.search(rf"^{program}\(\) \{{.*?^\}}", programs, re.MULTILINE | re.DOTALL)
            assert function, f"{name}: no {program} in tests/programs.sh"
            assert re.search(rf"\bpage {re.escape(name)}\b", function.group()), name


@pytest.mark.parametrize("name", PAGES)
def test_every_block_of_a_page_is_of_a_kind_that_is_looked_after(name):
    """Run, or marked, or among the commands that are run elsewhere; or it is no code: output, a formula, a setting."""
    known = {"python", "shell", "text", "toml", "hex"}
    if name == "docs/guides/umbridge.md":
        known |= {"cpp", "r"}  # `UMBRIDGE=DIR tests/programs.sh umbridge` runs these clients
    assert [block for block in page.blocks(PAGES[name]) if block.language not in known] == []


def test_a_configuration_on_a_page_can_be_read():
    for text in PAGES.values():
        for block in page.blocks(text):
            if block.language == "toml":
                assert tomllib.loads(block.text)
