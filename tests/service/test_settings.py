"""Settings are closed and typed: what is unknown or wrong is refused, with a hint."""

import logging
from hashlib import sha256

import pytest
from pydantic import ValidationError

from bnserve_service import Settings, Token, load_settings
from bnserve_service.errors import SettingsInvalid


def write(folder, text):
    path = folder / "bnserve.toml"
    path.write_text(text)
    path.chmod(0o600)
    return path


def test_a_file_sets_and_the_command_line_overrides(tmp_path):
    path = write(tmp_path, f'port = 9000\nmax_rows = 7\n[[tokens]]\nname = "a"\nsha256 = "{"0" * 64}"\n')
    settings = load_settings(path, {"port": 0, "host": None})
    assert (settings.port, settings.max_rows, settings.host) == (0, 7, "127.0.0.1")
    assert settings.tokens == (Token(name="a", sha256="0" * 64),)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("prot = 1", ["prot", "Did you mean 'port'?"]),
        ("wibble = 1", ["wibble", "Known settings"]),
        ('port = "many"', ["port"]),
        ("port = 70000", ["port"]),
        ("max_rows = 0", ["max_rows"]),
        ("queue_samples = 10", ["queue_samples"]),
        ('[[tokens]]\nsha256 = "plain text"', ["tokens", "sha256"]),
        *((f'[[tokens]]\nsha256 = "{sha256(text).hexdigest()}"', ["tokens.0.sha256"]) for text in (b"", b"x", b"\n")),
        ("port =", ["TOML"]),
    ],
)
def test_what_is_wrong_is_said(tmp_path, text, words):
    with pytest.raises(SettingsInvalid) as refused:
        load_settings(write(tmp_path, text))
    for word in words:
        assert word in refused.value.detail


def test_a_missing_file_is_said(tmp_path):
    with pytest.raises(SettingsInvalid, match="cannot be read"):
        load_settings(tmp_path / "nothing.toml")


def test_settings_do_not_change():
    with pytest.raises(ValidationError):
        Settings().port = 1


def test_the_largest_allowed_request_always_fits_into_the_queue():
    settings = Settings()
    limits = settings.limits()
    assert limits.max_samples <= settings.queue_samples


@pytest.mark.parametrize(("mode", "warns"), [(0o600, False), (0o640, False), (0o604, True), (0o644, True)])
def test_a_file_of_tokens_that_others_can_read_is_told(tmp_path, caplog, mode, warns):
    path = write(tmp_path, f'[[tokens]]\nsha256 = "{"0" * 64}"\n')
    path.chmod(mode)
    with caplog.at_level(logging.WARNING):
        assert len(load_settings(path).tokens) == 1
    assert (f"chmod o-r '{path}'" in caplog.text) is warns


def test_a_file_without_tokens_may_be_anybodys(tmp_path, caplog):
    path = write(tmp_path, "port = 1")
    path.chmod(0o666)
    assert load_settings(path).port == 1
    assert caplog.text == ""


@pytest.mark.parametrize("text", ["x", "fifteen letters"])
def test_a_token_that_could_be_guessed_is_refused(text):
    with pytest.raises(SettingsInvalid, match=f"at least 16 characters, and this one has {len(text)}"):
        Token.of(text)
    assert Token.of("sixteen letters.").sha256 == sha256(b"sixteen letters.").hexdigest()
