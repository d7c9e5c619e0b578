"""Tokens come, end and go while a server runs: by their date, by their file, without a restart."""

import logging
import threading
import time
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest

from bnserve_service import Settings, Token, load_settings
from bnserve_service.admission.token_book import TokenBook
from bnserve_service.cli.tokens import toml_lines
from bnserve_service.errors import SettingsInvalid
from tests.service.asking import ask, evaluate, question
from tests.service.chirp import ChirpModel, QuickChirpModel, until

ALICE, BOB, CAROL = "the token of alice", "the token of bob.", "the token of carol"


def bearer(text):
    return {"authorization": f"Bearer {text}"}


def write(path, *tokens, mode=0o600):
    fresh = path.with_suffix(".new")
    fresh.write_text("\n".join(line for token in tokens for line in toml_lines(token)))
    fresh.chmod(mode)
    fresh.replace(path)


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "tokens.toml"
    write(path, Token.of(ALICE, "alice"), Token.of(BOB, "bob"))
    return path


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def server(start, file, request):
    return start(request.param(), tokens_file=file)


def status(server, text):
    for _ in range(2):  # the second is for the fast path
        found = evaluate(server.address, question(), **bearer(text)).status
    return found


def test_a_token_that_is_taken_out_is_not_let_in_and_one_that_is_added_is(server, file, caplog):
    assert [status(server, text) for text in (ALICE, BOB, CAROL)] == [200, 200, 401]
    with caplog.at_level(logging.INFO, "bnserve.tokens"):
        write(file, Token.of(BOB, "bob"), Token.of(CAROL, "carol"))
        until(lambda: status(server, ALICE) == 401, "alice is gone")
    assert [status(server, text) for text in (ALICE, BOB, CAROL)] == [401, 200, 200]
    assert "2 are let in; new: carol; gone: alice" in caplog.text
    assert ALICE not in caplog.text


def test_it_is_read_again_when_the_server_is_told_to(start, file):
    server = start(ChirpModel(), tokens_file=file, poll_seconds=1000.0)
    write(file, Token.of(BOB, "bob", ("admin",)), Token.of(ALICE, "alice"))
    assert ask(server.address, "POST", "/v1/reload", **bearer(BOB)).status == 403, "not yet"
    server._server._loop.call_soon_threadsafe(server.app.parts.look_again)  # what SIGHUP does
    until(lambda: ask(server.address, "POST", "/v1/reload", **bearer(BOB)).status == 200, "bob is an operator")
    write(file, Token.of(BOB, "bob", ("admin",)))
    assert ask(server.address, "POST", "/v1/reload", **bearer(BOB)).status == 200
    assert status(server, ALICE) == 401, "who reloads has it read before the answer"


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (lambda file: file.write_text("[[tokens]]\nsha256 = 3\n"), "tokens.0.sha256"),
        (lambda file: file.write_text("[[tokens"), "not valid TOML"),
        (lambda file: file.unlink(), "cannot be read"),
        (lambda file: write(file, Token.of(CAROL), mode=0o666), "others than its owner can write"),
        (lambda file: write(file, Token.of(CAROL, "a"), Token.of(CAROL, "b")), "same sha256"),
    ],
    ids=["no token", "no TOML", "gone", "anybody's", "twice the same"],
)
def test_a_file_that_cannot_be_used_changes_nothing(start, file, caplog, spoil, says):
    server = start(ChirpModel(), tokens_file=file)
    spoil(file)
    until(lambda: "who is let in stays as it was" in caplog.text, "it is told")
    assert says in caplog.text
    assert [status(server, text) for text in (ALICE, CAROL)] == [200, 401]
    write(file, Token.of(CAROL))
    until(lambda: status(server, CAROL) == 200, "it is mended")


def test_a_file_that_is_written_where_it_lies_counts_when_it_is_whole(file):
    """Empty, then with half of its tokens, all of it valid: nobody is turned away meanwhile."""
    book = TokenBook(load_settings(file).token_files())
    whole, stop = file.read_text() + "# again\n", threading.Event()
    half = whole[: whole.index("[[tokens]]", 1)]

    def rewrite():
        while not stop.is_set():
            for text in ("", half, whole):
                file.write_text(text)
                time.sleep(0.002)
            time.sleep(0.1)

    writer = threading.Thread(target=rewrite)
    writer.start()
    try:
        for _ in range(60):
            book.renew()
            assert len(book.entries) == 2
            time.sleep(0.005)
    finally:
        stop.set()
        writer.join()


def test_without_a_token_in_it_nobody_is_let_in(start, file, caplog):
    server = start(ChirpModel(), tokens_file=file)
    write(file)
    until(lambda: status(server, ALICE) == 401, "alice is gone")
    assert "nobody is let in" in caplog.text
    assert ask(server.address, "GET", "/v1/models").status == 401


def test_the_file_of_settings_is_read_again_for_its_tokens_alone(tmp_path, file):
    file.write_text("max_rows = 7\n" + file.read_text())
    settings = load_settings(file)
    assert (settings.tokens_file, len(settings.tokens), settings.max_rows) == (file, 2, 7)
    book = TokenBook(settings.token_files())
    file.write_text("max_rows = 9\n" + "\n".join(toml_lines(Token.of(CAROL, "carol"))))
    book.renew()
    assert [entry.token.name for entry in book.entries] == ["carol"]


def test_tokens_of_the_command_line_count_in_place_of_the_files(file):
    settings = load_settings(file, {"tokens": [Token.of(CAROL)]})
    assert settings.tokens_file is None
    assert [entry.token.sha256 for entry in TokenBook(settings.token_files()).entries] == [Token.of(CAROL).sha256]


def test_tokens_in_two_places_are_refused(file, tmp_path):
    file.write_text(f'tokens_file = "{tmp_path / "others.toml"}"\n' + file.read_text())
    with pytest.raises(SettingsInvalid, match="Tokens are in one file"):
        load_settings(file)


def test_a_list_of_tokens_is_read_again_too(start, tmp_path):
    lines = tmp_path / "tokens"
    lines.write_text(f"{ALICE}\n\n{BOB}\n")
    lines.chmod(0o600)
    server = start(ChirpModel(), token_list=lines)
    assert [status(server, text) for text in (ALICE, BOB, CAROL)] == [200, 200, 401]
    lines.write_text(f"{CAROL}\n")
    until(lambda: status(server, CAROL) == 200, "carol is new")
    assert status(server, ALICE) == 401
    lines.write_text("short\n")
    time.sleep(0.3)
    assert status(server, CAROL) == 200


def test_a_token_ends_when_it_says(start):
    ends = datetime.now(UTC) + timedelta(seconds=2.0)
    server = start(
        QuickChirpModel(),
        tokens=(
            Token.of(ALICE, "alice", expires=ends),
            Token.of(BOB, "bob", expires=ends + timedelta(days=1)),
        ),
    )
    until(lambda: status(server, ALICE) == 401, "alice has ended")
    assert datetime.now(UTC) >= ends
    refused = evaluate(server.address, question(), **bearer(ALICE))
    assert refused.code == "unauthorized"
    assert "This token ended on" in refused.document["detail"]
    assert status(server, BOB) == 200


def test_a_date_needs_its_distance_from_utc():
    with pytest.raises(ValueError, match="timezone"):
        Token.of(ALICE, expires=datetime(2030, 1, 1))  # which is what is wrong
    sha256 = "0" * 64
    for text in ("2030-01-01T00:00:00Z", "2030-01-01T01:00:00+01:00"):
        assert Token(sha256=sha256, expires=text).ends == datetime(2030, 1, 1, tzinfo=UTC).timestamp()


def test_accounts_outlive_a_change_of_the_file(start, file):
    write(file, Token.of(ALICE, "alice", rows_per_day=3), Token.of(BOB, "bob"))
    server = start(QuickChirpModel(), tokens_file=file)
    assert status(server, ALICE) == 200
    assert status(server, ALICE) == 429, "three rows, and one more"
    write(file, Token.of(ALICE, "alice", rows_per_day=3, rows_per_second=1e6))
    until(lambda: status(server, BOB) == 401, "it was read")
    assert status(server, ALICE) == 429
    write(file, Token.of(ALICE, "alice", rows_per_day=1000))
    until(lambda: status(server, ALICE) == 200, "there is more")


def test_who_may_read_the_metrics(start):
    scopes = {ALICE: ("metrics",), BOB: ("admin",), CAROL: ("evaluate", "upload")}
    server = start(ChirpModel(), tokens=tuple(Token.of(text, text[-5:], scopes[text]) for text in scopes))

    def asked(method, path):
        return [ask(server.address, method, path, **bearer(text)).status for text in scopes]

    assert asked("GET", "/metrics") == [200, 200, 403]
    assert asked("POST", "/v1/reload") == [403, 200, 403]
    assert [evaluate(server.address, question(), **bearer(text)).status for text in scopes] == [403, 403, 200]


def test_files_that_change_keep_no_files_open(tmp_path, file):
    book = TokenBook(Settings(tokens_file=file).token_files(), tmp_path)
    before = len(list(Path("/proc/self/fd").iterdir()))
    for number in range(50):
        write(file, Token.of(f"the token number {number}", rows_per_second=10.0, max_concurrent=3))
        book.renew()
    assert len(book.entries) == 1
    assert len(list(Path("/proc/self/fd").iterdir())) <= before + 1
