"""``bnserve completion``: scripts that the shells themselves take, and what they complete."""

import shutil
import subprocess

import pytest

from bnserve_service.cli import SUBCOMMANDS, main


@pytest.fixture
def script(capsys, tmp_path):
    def write(shell):
        assert main(["completion", shell]) == 0
        path = tmp_path / "bnserve"
        path.write_text(capsys.readouterr().out)
        return path

    return write


def in_shell(shell, *arguments, **options):
    assert shutil.which(shell), f"{shell} is not installed (tests/run.sh does)"
    done = subprocess.run([shell, *arguments], capture_output=True, text=True, check=False, timeout=60, **options)
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


ASK_BASH = """
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMP_LINE="$*"; COMP_POINT=${#COMP_LINE}
_shtab_bnserve bnserve "${COMP_WORDS[COMP_CWORD]}"
printf "%s\\n" "${COMPREPLY[@]}"
"""


@pytest.mark.parametrize(
    ("words", "completed"),
    [
        ([""], SUBCOMMANDS),
        (["mod"], ["models"]),
        (["models", ""], ["list", "show", "manifest", "verify", "publish", "label"]),
        (["serve", "--wor"], ["--workers", "--workers-threads"]),
        (["completion", ""], ["bash", "zsh", "fish"]),
        (["waveform", "--theta"], ["--theta-jn"]),
        (["roq", "show", "basis"], ["basis.h5"]),
        (["serve", "--config", "set"], ["settings.toml"]),
    ],
)
def test_bash_completes(script, tmp_path, words, completed):
    for name in ("basis.h5", "settings.toml"):
        (tmp_path / name).write_text("")
    found = in_shell("bash", "-c", ASK_BASH, "bash", str(script("bash")), "bnserve", *words, cwd=tmp_path)
    assert set(completed) <= set(found)
    if words[-1]:
        assert set(found) == set(completed)


def test_zsh_reads_it(script):
    in_shell("zsh", "-n", str(script("zsh")))
    assert script("zsh").read_text().startswith("#compdef bnserve")


@pytest.mark.parametrize(
    ("line", "completed"),
    [("bnserve ", SUBCOMMANDS), ("bnserve models ", ["list", "verify"]), ("bnserve serve --wor", ["--workers"])],
)
def test_fish_completes(script, line, completed, tmp_path):
    home = {"HOME": str(tmp_path), "PATH": "/usr/bin:/bin"}
    found = in_shell("fish", "-c", f"source {script('fish')}; complete -C '{line}'", env=home)
    assert set(completed) <= set(found)


def test_another_shell_is_refused(capsys):
    with pytest.raises(SystemExit, match="2"):
        main(["completion", "tcsh"])
    assert "There is no shell 'tcsh'" in capsys.readouterr().err
