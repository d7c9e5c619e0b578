"""Where other people's software is installed for a comparison: one virtual environment each, in one folder.

Every script that needs one says how to make it, in the indented lines of its docstring; :func:`install` runs them.
"""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path


def find_python(folder: Path | None, environment: str) -> Path | None:
    """The interpreter of an environment; this one for ``""``; None if it is not installed."""
    if not environment:
        return Path(sys.executable)
    python = folder / environment / "bin" / "python" if folder else None
    return python if python and python.exists() else None


def folder_from_environment(variable: str) -> Path | None:
    """The folder that a variable names, for the default of an option."""
    text = os.environ.get(variable)
    return Path(text).absolute() if text else None


def install_commands(script: Path) -> list[str]:
    """The commands in a script's docstring: its lines with four spaces before them."""
    docstring = ast.get_docstring(ast.parse(script.read_text(encoding="utf-8"))) or ""
    return [line[4:] for line in docstring.splitlines() if line.startswith("    ")]


def install(script: Path, variable: str, folder: Path, root: Path) -> bool:
    """Run the commands of a script's docstring in the checkout, with ``$variable`` the folder; whether all worked."""
    folder.mkdir(parents=True, exist_ok=True)
    environment = os.environ | {variable: str(folder.absolute())}
    for command in install_commands(script):
        print(f"$ {command}", flush=True)
        if subprocess.run(["bash", "-c", command], cwd=root, env=environment, check=False).returncode != 0:
            print(f"{script.name}: that command failed", file=sys.stderr)
            return False
    return True
