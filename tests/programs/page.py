"""The blocks of a page as they stand, in order, in one fresh interpreter and folder.

    python tests/programs/page.py docs/guides/pycbc.md http://127.0.0.1:8000 folder

Blocks of Python are run, and commands of a shell; only the address is that of the server, in ``BNSERVE_URL``, too. The
folder has what the page's reader has, and the checkout's ``configs`` and ``examples``.
``tests/integration/test_pages.py`` runs most pages so, and ``tests/programs.sh`` those of other programs in their
environments. This file imports nothing of ours, nor of others.

A block below ``<!-- not run: REASON -->`` is left out, and so is what :data:`ELSEWHERE` says where to look for.
"""

import os
import re
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit

ROOT = Path(__file__).parents[2]
NOT_RUN = re.compile(r"<!-- not run: \S.*-->")
COMMAND = re.compile(
    r"(\.venv(-test)?/bin/)?(apt-get|bajes_pipe|bash|bnserve|cp|curl|deploy/batch|docker|echo|export|install"
    r"|kubectl|mkdir|mypy|pip|pycbc_inference|python3?|ruff|sbatch|sed|serve|sudo|uv)\b|[A-Za-z0-9]+=\S"
)
"""How a command begins; an indented block is one of a shell where its first line does."""
OTHER = re.compile(r"\S.* = |\[|def ")
"""How a formula, a configuration and a signature begin."""
ELSEWHERE = {
    r"\bpip install\b": "tests/programs.sh installs so, in the environments of the programs and of the examples",
    r"bnserve serve\b": "the server of the tests stands in the place of one that is started here",
    r"bnserve (analyse|train|search|validate|roq|models|doctor|tokens)\b": (
        "trained for minutes or hours, or a name that the reader has: tests/architecture/test_documented_commands.py "
        "reads them, tests of each command run them, tests/integration/test_own_model.py goes the whole way"
    ),
    r"python -m benchmarks\b": (
        "measured for minutes or hours: tests/architecture/test_documented_commands.py reads them, and "
        "tests/integration run their short forms"
    ),
    r"\b(bash tests/|ruff|mypy|python docs/generate|uv pip compile)": "the tests are part of it",
    r"\b(docker|kubectl|haproxy|nginx|serve run)\b": "tests/deploy and integration/test_container.py run what is there",
    r"\b(deploy/batch/|sbatch|systemctl)": "tests/deploy/test_batch.py and test_systemd.py run what is there",
    r"python3 -m tests\.image\b": "takes minutes and root; tests/integration/test_container.py runs its steps",
    r"python examples/": "tests/integration/test_examples.py and test_samplers.py, and tests/programs.sh examples",
}
"""Where commands are looked after that no page runs."""
HOSTS = {"127.0.0.1": "127.0.0.1", "one": "127.0.0.1", "two": "localhost", "three": "127.0.0.1", "host": "127.0.0.1"}
"""What the server stands for."""
SHORT = {
    "bilby.run_sampler": "import bilby as _b; _run = _b.run_sampler; "
    "_few = {'nlive': 50, 'maxiter': 20, 'check_point': False}; "  # a run with checkpoints has such a limit each time
    "_b.run_sampler = lambda *a, **k: _run(*a, **(_few | k | {'npool': 1}))",
    "emcee.EnsembleSampler": "import emcee as _e; _walk = _e.EnsembleSampler.run_mcmc; "
    "_e.EnsembleSampler.run_mcmc = lambda self, start, steps: _walk(self, start, 10)",
    "nautilus.Sampler": "import nautilus as _n; _more = _n.Sampler.run; "
    "_n.Sampler.run = lambda *a, **k: _more(*a, **(k | {'n_like_max': 3000, 'discard_exploration': False}))",
    "pm.sample": "import pymc as _p; _draw = _p.sample; "
    "_p.sample = lambda *a, **k: _draw(*a, **(k | {'draws': 20, 'tune': 60}))",
    "npool": "import multiprocessing as _m; _m.set_start_method('fork', force=True)",  # the page is no module
}
"""Where a page has one of them, what makes its runs end early, and lets a program of blocks start processes."""


class Block(NamedTuple):
    """Lines of a page: the number of the first one (from 0), the language, and the text without its indentation."""

    line: int
    language: str
    text: str
    is_marked: bool

    @property
    def is_run(self) -> bool:
        """Whether it is run with its page."""
        elsewhere = self.language == "shell" and any(re.search(pattern, self.text) for pattern in ELSEWHERE)
        return self.language in ("python", "shell") and not self.is_marked and not elsewhere


def blocks(page: str) -> list[Block]:
    """All blocks of a page, fenced and indented."""
    lines, found, number = page.split("\n"), [], 0
    while number < len(lines):
        line, before = lines[number], lines[number - 1] if number else ""
        is_marked = bool(NOT_RUN.fullmatch(before))
        if line.startswith("```"):
            end = lines.index("```", number + 1)
            found.append(Block(number + 1, line[3:] or "text", "\n".join(lines[number + 1 : end]), is_marked))
        elif line.startswith("    ") and (not before.strip() or is_marked):
            end = next(
                (n for n in range(number, len(lines)) if lines[n].strip() and lines[n][:4] != "    "), len(lines)
            )
            indent = len(line) - len(line.lstrip())
            text = "\n".join(inside[indent:] for inside in lines[number:end]).rstrip()
            language = "shell" if COMMAND.match(text) else "text" if OTHER.match(text) else "unknown"
            found.append(Block(number, language, text, is_marked or bool(NOT_RUN.fullmatch(lines[number - 2]))))
            end -= 1  # the line after it may begin another
        else:
            end = number
        number = end + 1
    return found


def script(page: str) -> str:
    """A page as a program that has each block that is run on the lines where the page has it."""
    program = [""] * (page.count("\n") + 1)
    for block in blocks(page):
        if block.is_run and block.language == "python":
            text = block.text.splitlines()
            program[block.line : block.line + len(text)] = text
        elif block.is_run:
            command = [
                "bash",
                "-euo",
                "pipefail",
                "-c",
                block.text.replace("curl ", "curl --silent --show-error --fail "),
            ]
            program[block.line] = f"__import__('subprocess').run({command!r}, check=True)"
    return "\n".join(program)


def program(page: str, address: str) -> str:
    """:func:`script` for the server of this address; samplers stop early."""
    found = script(page)
    for host, here in HOSTS.items():
        found = found.replace(f"//{host}:8000", f"//{here}:{urlsplit(address).port}")
        found = found.replace(f" {host}:8000", f" {here}:{urlsplit(address).port}")
    first = "; ".join(short for name, short in SHORT.items() if name in found)
    return found.replace("\n", f"{first}\n", 1)  # a page begins with its title


def main(name: str, address: str, folder: Path, options: Sequence[str] = ("-W", "ignore")) -> int:
    """Run a page in a folder; the status of its program."""
    for below in ("configs", "examples"):
        (folder / below).symlink_to(ROOT / below)
    path = folder / "blocks_of_a_page.py"
    path.write_text(program((ROOT / name).read_text(encoding="utf-8"), address), encoding="utf-8")
    search = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = os.environ | {"BNSERVE_URL": address, "PATH": search, "HOME": str(folder)}
    command = [sys.executable, *options, str(path)]
    return subprocess.run(command, cwd=folder, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], Path(sys.argv[3])))
