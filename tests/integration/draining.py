"""Stopping a server while callers who never try again ask it without a pause."""

import http.client
import json
import signal
import threading

from tests.integration.workers import until
from tests.service.asking import JSON, ask_on, closing_connection

CALLERS = 8


def stopped_under_load(server, asked):
    """Send SIGTERM to a busy server; its exit status, the statuses of all answers, and what went wrong for a caller."""
    answers, failures = [], []

    def keep_asking():
        with closing_connection(server.address) as connection:
            while True:
                try:
                    answer = ask_on(
                        connection, "POST", "/v1/models/default/waveforms", json.dumps(asked), content_type=JSON
                    )
                except (OSError, http.client.HTTPException) as error:
                    failures.append(repr(error))
                    return
                answers.append(answer.status)
                if answer.headers.get("connection") == "close":
                    return

    callers = [threading.Thread(target=keep_asking) for _ in range(CALLERS)]
    for caller in callers:
        caller.start()
    until(lambda: len(answers) > 50, "the server is busy")
    server.process.send_signal(signal.SIGTERM)
    for caller in callers:
        caller.join()
    return server.process.wait(60), answers, failures
