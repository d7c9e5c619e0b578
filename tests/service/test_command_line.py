"""The command: errors are sentences with exit code 2, and nothing heavy is imported to print the help."""

import argparse
import json
import shutil
import socket
import subprocess
import sys
from pathlib import Path

import pytest

import bnserve_store
from bnserve_service.cli import build_parser, main
from bnserve_service.cli.places import server_address
from bnserve_service.process.system import ONE_THREAD
from bnserve_store import ModelStore
from tests.architecture.rooms import room_environment

COMMAND = [sys.executable, "-m", "bnserve_service"]


def run(*arguments, **options):
    return subprocess.run(
        [*COMMAND, *arguments], capture_output=True, text=True, check=False, env=room_environment(), timeout=120,
        **options,
    )  # fmt: skip


def test_every_subcommand_has_help(capsys):
    for arguments in (["--help"], ["serve", "--help"], ["models", "--help"], ["models", "publish", "--help"]):
        with pytest.raises(SystemExit) as ended:
            build_parser().parse_args(arguments)
        assert ended.value.code == 0
        assert "usage: bnserve" in capsys.readouterr().out


def test_the_parser_is_built_without_numpy():
    code = "import sys; from bnserve_service.cli import build_parser; build_parser(); print('numpy' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=room_environment()
    )
    assert done.stdout.strip() == "False"


def test_libraries_get_one_thread_each_before_numpy_starts(monkeypatch, tmp_path):
    for name in ONE_THREAD:
        monkeypatch.setenv(name, "placeholder")
        monkeypatch.delenv(name)
    import os

    assert main(["serve", "--store", str(tmp_path / "missing"), "--port", "0"]) == 2
    assert [os.environ[name] for name in ONE_THREAD] == ["1", "1", "1"]


def test_a_port_in_use(tmp_path):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        done = run("serve", "--port", str(taken.getsockname()[1]))
    assert done.returncode == 2
    assert "in use" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_store_that_is_not_there(tmp_path):
    done = run("serve", "--port", "0", "--store", str(tmp_path / "nowhere"))
    assert done.returncode == 2
    assert "nowhere" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_model_that_is_not_there(tmp_path):
    done = run("serve", "--port", "0", "--model", "no-such-model")
    assert done.returncode == 2
    assert "no-such-model" in done.stderr


def test_a_settings_file_with_an_unknown_key(tmp_path, capsys):
    path = tmp_path / "bnserve.toml"
    path.write_text("prot = 1")
    assert main(["serve", "--config", str(path)]) == 2
    assert "Did you mean 'port'?" in capsys.readouterr().err


def test_an_unreadable_token_file(tmp_path, capsys):
    assert main(["serve", "--token-file", str(tmp_path / "none")]) == 2
    assert "cannot be read" in capsys.readouterr().err
    (tmp_path / "empty").write_text("\n")
    (tmp_path / "empty").chmod(0o600)
    assert main(["serve", "--token-file", str(tmp_path / "empty")]) == 2
    assert "no token" in capsys.readouterr().err


@pytest.mark.parametrize("given", ["--token", "--token-file"])
def test_a_token_that_could_be_guessed(tmp_path, capsys, given):
    (tmp_path / "tokens").write_text("a-long-enough-token\nshort\n")
    (tmp_path / "tokens").chmod(0o600)
    assert main(["serve", given, "short" if given == "--token" else str(tmp_path / "tokens")]) == 2
    said = capsys.readouterr().err
    assert "at least 16 characters" in said
    assert "bnserve tokens new" in said


@pytest.mark.parametrize("mode", [0o620, 0o602, 0o666])
@pytest.mark.parametrize("given", ["--config", "--token-file"])
def test_a_file_of_tokens_that_others_can_write(tmp_path, capsys, given, mode):
    path = tmp_path / "tokens"
    path.write_text(f'[[tokens]]\nsha256 = "{"0" * 64}"\n' if given == "--config" else "a-long-enough-token\n")
    path.chmod(mode)
    assert main(["serve", given, str(path)]) == 2
    assert f"chmod go-w '{path}'" in capsys.readouterr().err


def test_a_published_copy_has_the_digest_of_its_original(tmp_path):
    shipped = Path(bnserve_store.SHIPPED_MODELS)
    done = run("models", "publish", "default", "--from", str(shipped), "--store", str(tmp_path))
    assert done.returncode == 0, done.stderr
    original, copy = (ModelStore([root]).manifest("default") for root in (shipped, tmp_path))
    assert copy.digest == original.digest
    assert copy.digest in done.stdout
    assert copy.digest in (tmp_path / "default" / copy.version / "report.html").read_text()  # the training's, beside it


def shell(line, folder):
    """What a shell says and returns for a command line with ``bnserve`` in it."""
    line = line.replace("bnserve", f"'{sys.executable}' -m bnserve_service")
    environment = room_environment() | {"PYTHONUNBUFFERED": ""}  # as from a shell, output waits to be written
    done = subprocess.run(
        ["bash", "-o", "pipefail", "-c", line],
        capture_output=True, text=True, check=False, env=environment, cwd=folder, timeout=120,
    )  # fmt: skip
    assert "Traceback" not in done.stderr
    assert "Exception ignored" not in done.stderr
    return done


FULL = "bnserve: The output cannot be written: No space left on device.\n"


@pytest.mark.parametrize("command", ["models list", "models verify default", "tokens new --name me", "--help"])
@pytest.mark.parametrize(
    ("to", "status"), [(">&-", 0), ("> /dev/full", 2), ("| head -0", 0), ("2>&-", 0), ("<&- >&- 2>&-", 0)]
)
def test_output_that_is_closed_full_or_not_read_is_no_defect(command, to, status, tmp_path):
    done = shell(f"bnserve {command} {to}", tmp_path)
    assert done.returncode == status
    assert done.stderr.endswith(FULL) is (to == "> /dev/full")


@pytest.mark.parametrize(
    "to", [">&-", "> /dev/full", "2>&-", "2> /dev/full", "<&- >&- 2>&-", "> /dev/full 2> /dev/full"]
)
def test_an_error_keeps_its_exit_code_whatever_the_output(to, tmp_path):
    for command in ("models list --store missing", "no-such-command", "serve --port 0 --store missing"):
        assert shell(f"bnserve {command} {to}", tmp_path).returncode == 2


def test_a_token_that_nobody_can_read_is_not_made(tmp_path):
    done = shell("bnserve tokens new --name me 2> /dev/full", tmp_path)
    assert (done.returncode, done.stdout) == (2, "")


ROOT = Path(__file__).parents[2]
PLACES = {
    "validate": ["validate", "default", "--count", "8", "--output"],
    "roq build": ["roq", "build", str(ROOT / "configs" / "roq_gw170817.toml"), "--no-report", "--output"],
    "bench": ["bench", "--plot"],
}


@pytest.mark.parametrize("arguments", PLACES.values(), ids=list(PLACES))
def test_a_place_that_cannot_be_written_is_found_before_the_work(tmp_path, monkeypatch, capsys, arguments):
    """Below a file there is no folder; what would take hours has not even begun."""
    pytest.importorskip("sklearn")
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    place = tmp_path / "file" / "results.json"
    assert main([*arguments, str(place)]) == 2
    printed = capsys.readouterr()
    assert f"Cannot write {place}" in printed.err
    assert printed.out == ""
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def parsers(parser=None):
    """Every parser of the command, by the words that lead to it."""
    parser = parser or build_parser()
    found = {parser.prog: parser}
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for sub in action.choices.values():
                found |= parsers(sub)
    return found


@pytest.mark.parametrize("prog", list(parsers()))
def test_help_is_plain_text(prog):
    text = parsers()[prog].format_help()
    assert "``" not in text
    assert ":class:" not in text


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("sevre", "There is no command 'sevre'. Did you mean 'serve'?"),
        ("models labl", "There is no action 'labl'. Did you mean 'label'?"),
        ("serve --prot 1", "There is no option '--prot'. Did you mean '--port'?"),
        ("tokens new --nam --name a --scop=x", "--name"),
        ("models show default --stroe=x", "There is no option '--stroe'. Did you mean '--store'?"),
        ("tokens new --name a --scope evalute", "There is no scope 'evalute'. Did you mean 'evaluate'?"),
        ("serve here", "Nothing here takes the argument 'here'"),
        ("xyzzy", "there are demo"),
        ("models", "required: ACTION"),
    ],
)
def test_what_is_not_understood_is_one_sentence_with_the_nearest_that_is(capsys, line, says):
    with pytest.raises(SystemExit, match="2"):
        main(line.split())
    told = capsys.readouterr()
    assert told.out == ""
    assert says in told.err
    assert told.err.count("\n") == 1
    assert "--help` lists what there is." in told.err


@pytest.mark.parametrize("workers", ["1", "2"])
@pytest.mark.parametrize("version", ["9.9.9", "stable"])
def test_a_version_that_is_not_there_is_found_before_anybody_can_connect(capsys, version, workers):
    with socket.socket() as taken:  # whoever tries to listen first complains about the port
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        line = ["serve", "--port", str(taken.getsockname()[1]), "--model", f"default@{version}", "--workers", workers]
        done = run(*line)
    assert done.returncode == 2
    assert f"Model 'default' has no version '{version}' to serve; there are 1.0.0, 2.0.0." in done.stderr
    assert "in use" not in done.stderr


def printed_json(capsys, *arguments, status=0):
    assert main(list(arguments)) == status
    return json.loads(capsys.readouterr().out)


@pytest.fixture
def copied_store(tmp_path):
    """A store of one's own with a copy of the shipped model of today, which may be damaged."""
    shipped, others = bnserve_store.SHIPPED_MODELS / "fast", shutil.ignore_patterns("1.0.0")
    shutil.copytree(shipped, tmp_path / "store" / "fast", ignore=others)
    return tmp_path / "store"


def test_models_for_machines(capsys, copied_store):
    listed = printed_json(capsys, "models", "list", "--json")
    assert {"name": "default", "version": "2.0.0", "labels": ["stable"]} in listed
    assert printed_json(capsys, "models", "show", "fast")["digest"].startswith("sha256:")
    store = ["--store", str(copied_store)]
    [good] = printed_json(capsys, "models", "verify", "fast", "--json", *store)
    assert (good["version"], good["fine"], good["reason"]) == ("2.0.0", True, None)
    assert printed_json(capsys, "models", "label", "fast", "trial", "--json", *store) == {
        "name": "fast", "label": "trial", "version": "2.0.0", "before": None,
    }  # fmt: skip
    manifest = printed_json(capsys, "models", "manifest", "fast")
    assert manifest["models"][0]["name"] == "fast"
    tensors = copied_store / "fast" / "2.0.0" / "tensors.safetensors"
    content = tensors.read_bytes()
    tensors.write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    [bad] = printed_json(capsys, "models", "verify", "fast", "--json", *store, status=1)
    assert (bad["fine"], bad["name"]) == (False, "fast")
    assert bad["reason"]


def test_label_and_verify_say_which_version_they_mean(capsys, copied_store):
    store = ["--store", str(copied_store)]
    assert main(["models", "label", "fast", "trial", *store]) == 0
    assert capsys.readouterr().out == f"fast: trial is version 2.0.0 now (it is new), in {copied_store}\n"
    assert main(["models", "label", "fast@trial", "trial", *store]) == 0
    assert "trial is version 2.0.0 now (as before)" in capsys.readouterr().out
    assert main(["models", "verify", "fast@trial", *store]) == 0
    assert capsys.readouterr().out.startswith("fast 2.0.0 (stable, trial): fine (")


def test_a_label_needs_a_store_that_may_be_written(capsys):
    assert main(["models", "label", "default", "trial"]) == 2
    assert "with --store DIR" in capsys.readouterr().err


def test_an_address_of_another_machine(capsys):
    assert main(["serve", "--port", "0", "--host", "192.0.2.1"]) == 2  # kept for documentation: nobody has it
    assert "'192.0.2.1' is not an address of this machine. With --host 127.0.0.1" in capsys.readouterr().err


def test_a_basis_that_comes_with_the_package_is_shown_by_its_name(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["roq", "show", "gw170817_fine"]) == 0
    assert "model       default " in capsys.readouterr().out
    known = printed_json(capsys, "roq", "show", "gw170817", "--json")
    assert known["linear_nodes"] > known["quadratic_nodes"] > 0
    assert known["prior"]["chirp_mass"][0] < known["prior"]["chirp_mass"][1]
    for action in ("show", "validate"):
        assert main(["roq", action, "gw170817.h5"]) == 2
        told = capsys.readouterr().err
        assert "There is no file 'gw170817.h5'" in told
        assert "those are gw170817, gw170817_fine." in told


@pytest.mark.parametrize(
    ("given", "address"),
    [
        ("localhost:8000", "http://localhost:8000"),
        ("10.0.0.1", "http://10.0.0.1"),
        ("[::1]:8000", "http://[::1]:8000"),
        ("https://host/prefix", "https://host/prefix"),
        ("unix:/run/bnserve", "unix:/run/bnserve"),
        ("/run/bnserve", "unix:/run/bnserve"),
    ],
)
def test_the_address_of_a_server_may_be_short(given, address):
    assert server_address(given) == address


def test_a_server_is_measured_by_host_and_port(capsys):
    assert main(["bench", "--short", "--url", "127.0.0.1:9"]) == 2
    assert "http://127.0.0.1:9" in capsys.readouterr().err
