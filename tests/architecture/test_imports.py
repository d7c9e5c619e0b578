"""Imports point one way: the contracts of the root pyproject.toml hold."""

import subprocess
import sys
from pathlib import Path

from tests.architecture.rooms import ROOT, room_environment


def test_the_import_contracts_hold():
    lint_imports = Path(sys.executable).with_name("lint-imports")
    command = [str(lint_imports), "--no-cache", "--no-logo", "--config", str(ROOT / "pyproject.toml")]
    done = subprocess.run(command, cwd=ROOT, env=room_environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
