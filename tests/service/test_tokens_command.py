"""``bnserve tokens new``: the token once on stderr, on stdout the lines that let it in."""

import hashlib
import json
import tomllib

import pytest

from bnserve_service.cli import main
from bnserve_service.settings import load_settings


def test_a_new_token_and_the_lines_that_let_it_in(capsys, tmp_path):
    assert main(["tokens", "new", "--name", "Zo\u00eb \"Z\"", "--scope", "evaluate", "--rows-per-second", "500",
                 "--max-concurrent", "8", "--max-stored-bytes", "1000000"]) == 0  # fmt: skip
    told = capsys.readouterr()
    text = told.err.split()[-1]
    assert len(text) > 40
    assert text not in told.out
    file = tmp_path / "settings.toml"
    file.write_text("port = 0\n" + told.out)
    file.chmod(0o600)
    [token] = load_settings(file).tokens
    assert token.sha256 == hashlib.sha256(text.encode()).hexdigest()
    assert (token.name, token.scopes) == ('Zo\u00eb "Z"', ("evaluate",))
    assert (token.rows_per_second, token.max_concurrent, token.max_stored_bytes) == (500.0, 8, 1_000_000)


def test_every_token_is_another_and_has_the_usual_scopes(capsys):
    texts = set()
    for _ in range(5):
        main(["tokens", "new", "--name", "a"])
        told = capsys.readouterr()
        texts.add(told.err.split()[-1])
        assert tomllib.loads(told.out)["tokens"][0]["scopes"] == ["evaluate", "upload"]
    assert len(texts) == 5


@pytest.mark.parametrize("wrong", [["--rows-per-second", "-1"], ["--burst-rows", "5"], ["--max-concurrent", "0"]])
def test_a_token_that_cannot_be_is_one_sentence(capsys, wrong):
    assert main(["tokens", "new", "--name", "a", *wrong]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.startswith("bnserve: There can be no such token: ")


def test_a_token_for_machines(capsys):
    assert main(["tokens", "new", "--name", "a", "--max-concurrent", "3", "--json"]) == 0
    told = capsys.readouterr()
    made = json.loads(told.out)
    assert told.err == ""
    assert made["settings"]["sha256"] == hashlib.sha256(made["token"].encode()).hexdigest()
    assert made["settings"]["max_concurrent"] == 3
