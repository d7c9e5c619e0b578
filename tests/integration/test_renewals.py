"""Tokens and certificates change under load: who may still ask loses nothing, who may not is refused at once."""

import os
import signal
import socket
import ssl
import threading
from pathlib import Path

import numpy as np

from bnserve_client import Model, ParametersWithExtrinsic, Unauthorized
from bnserve_service import Token
from bnserve_service.cli.tokens import toml_lines
from tests.certificates import certificates
from tests.integration.workers import serving_with, until

FREQUENCIES = np.linspace(20.0, 1024.0, 50)
ONE = ParametersWithExtrinsic.gw170817()


def write(path: Path, **tokens: str) -> None:
    """A file that lets some tokens in, by name."""
    lines = [line for name, text in tokens.items() for line in toml_lines(Token.of(text, name))]
    fresh = path.with_suffix(".new")
    fresh.write_text("\n".join(lines))
    fresh.chmod(0o600)
    fresh.replace(path)


class Asking(threading.Thread):
    """Somebody who asks without pause, and never asks twice; counts answers and keeps what went wrong."""

    def __init__(self, model: Model) -> None:
        super().__init__(daemon=True)
        self.model, self.over = model, threading.Event()
        self.answers, self.errors = 0, []
        self.right = model.predict(FREQUENCIES, ONE).plus.tobytes()

    def run(self) -> None:
        while not self.over.is_set():
            try:
                assert self.model.predict(FREQUENCIES, ONE).plus.tobytes() == self.right
                self.answers += 1
            except Exception as error:
                self.errors.append(error)
                return

    def goes_on(self, more: int = 20) -> None:
        before = self.answers
        until(lambda: self.answers >= before + more or self.errors, "it is answered")
        assert self.errors == []

    def end(self) -> None:
        self.over.set()
        self.join()
        self.model.close()


def shown(address: str) -> bytes:
    host, port = address.removeprefix("https://").split(":")
    context = ssl.create_default_context()
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    with socket.create_connection((host, int(port)), timeout=30) as plain, context.wrap_socket(plain) as connection:
        return connection.getpeercert(binary_form=True)


def test_a_token_is_taken_away_and_another_replaced_and_a_certificate_renewed(tmp_path):
    made, tokens = certificates(tmp_path), tmp_path / "tokens.toml"
    write(tokens, alice="the token of alice", bob="the old token of bob")
    of_bob = tmp_path / "bob"
    of_bob.write_text("the old token of bob")
    settings = tmp_path / "bnserve.toml"
    settings.write_text(f'tokens_file = "{tokens}"\npoll_seconds = 1000.0\n')
    with serving_with(tmp_path / "log", 2, "--config", str(settings), *made.options, trusted=made.trusted) as workers:

        def connected(token):
            return Model.connect(workers.address, "default", token=token, verify=made.trusted, retries=0)

        # Bob's client asks again once, with the token that his file has by then; nobody else's asks twice.
        carol = Asking(connected("the token of alice"))
        alice = Asking(connected("the token of alice"))
        bob = Asking(Model.connect(workers.address, "default", token=of_bob, verify=made.trusted, retries=1))
        for each in (alice, bob, carol):
            each.start()
            each.goes_on()
        pids, before = workers.pids(), shown(workers.address)

        write(tokens, alice="the token of alice", bob="the new token of bob", carol="the token of carol")
        of_bob.write_text("the new token of bob")
        made.renew()
        os.kill(workers.supervisor, signal.SIGHUP)
        until(lambda: all(shown(workers.address) != before for _ in range(4)), "the certificate is new in all workers")
        for each in (alice, bob, carol):
            each.goes_on()
        with connected("the token of carol") as late:
            assert late.predict(FREQUENCIES, ONE).plus.tobytes() == alice.right
        carol.end()

        write(tokens, bob="the new token of bob")
        os.kill(workers.supervisor, signal.SIGHUP)
        until(lambda: alice.errors, "alice is refused")
        assert isinstance(alice.errors[0], Unauthorized)
        bob.goes_on()
        for each in (alice, bob):
            each.end()
        assert bob.errors == carol.errors == []
        assert workers.pids() == pids, "no worker was replaced"
    log = (tmp_path / "log").read_text()
    assert "gone: alice" in log
    assert "the token of" not in log
    assert "the new token of" not in log
