"""What the pages tell to type works: page by page, in order, against a running server.

Blocks of Python and the requests of curl are run as they stand, in one fresh interpreter for each page; only the
address is that of the server. A block below ``<!-- not run: REASON -->`` is left out, and a page with
``<!-- blocks not run: REASON -->`` altogether. Indented commands are parsed by
``tests/architecture/test_documented_commands.py``.
"""

import re
import subprocess
import sys
from urllib.parse import urlsplit

import pytest

from tests.architecture.rooms import ROOT, room_environment, tracked_files

RUN = [
    "README.md", "docs/tutorial.md", "docs/guides/client.md", "docs/guides/http.md", "docs/guides/likelihoods.md",
    "docs/guides/deployment.md", "docs/guides/roq.md", "docs/guides/mlgw_bns.md",
]  # fmt: skip
NOT_RUN = re.compile(r"<!-- not run: \S.*-->")
PAGE_NOT_RUN = re.compile(r"<!-- blocks not run: \S[^>]*-->")
SHELL = re.compile(r"(?P<indent> {4,})(?:curl|SHA256=)")
HOSTS = {"127.0.0.1": "127.0.0.1", "one": "127.0.0.1", "two": "localhost", "three": "127.0.0.1"}
"""What the server stands for."""
WARNINGS = {"docs/tutorial.md": "default"}
"""Of bilby and what it imports; on all other pages warnings are errors."""


def script(page: str) -> str:
    """A page as a program that has each block on the lines where the page has it."""
    lines = page.splitlines()
    program = [""] * len(lines)
    number = 0
    while number < len(lines):
        is_run = not (number and NOT_RUN.fullmatch(lines[number - 1]))
        if lines[number] == "```python":
            end = lines.index("```", number)
            if is_run:
                program[number + 1 : end] = lines[number + 1 : end]
        elif match := SHELL.match(lines[number]):
            end = next((n for n in range(number, len(lines)) if not lines[n].startswith(match["indent"])), len(lines))
            text = "\n".join(line.removeprefix(match["indent"]) for line in lines[number:end])
            command = ["bash", "-euo", "pipefail", "-c", text.replace("curl ", "curl --silent --show-error --fail ")]
            program[number] = f"__import__('subprocess').run({command!r}, check=True)"
        else:
            end = number
        number = end + 1
    return "\n".join(program)


def test_a_script_has_the_blocks_where_the_page_has_them():
    page = "# P\n\n```python\na = 1\n```\n\n<!-- not run: takes hours -->\n```python\nb\n```\n\n    curl x\n\n    pip\n"
    lines = script(page).splitlines()
    assert (lines[3], lines[8]) == ("a = 1", "")
    assert "curl --silent" in lines[11]
    assert [number for number, line in enumerate(lines) if line] == [3, 11]


@pytest.mark.parametrize("name", RUN)
def test_the_blocks_of_a_page_run(name, bnserve_server, tmp_path):
    port = urlsplit(bnserve_server.address).port
    program = script((ROOT / name).read_text())
    for address, here in HOSTS.items():
        program = program.replace(f"//{address}:8000", f"//{here}:{port}")
    file = tmp_path / "blocks_of_a_page.py"
    file.write_text(program)
    command = [sys.executable, "-W", WARNINGS.get(name, "error"), file]
    environment = room_environment() | {"BNSERVE_URL": bnserve_server.address}
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False, timeout=300
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_pages_whose_blocks_are_not_run_say_why():
    pages = {str(path): (ROOT / path).read_text() for path in tracked_files() if path.suffix == ".md"}
    with_blocks = {name for name, text in pages.items() if "```python" in text and not PAGE_NOT_RUN.search(text)}
    assert with_blocks - set(RUN) == set()
