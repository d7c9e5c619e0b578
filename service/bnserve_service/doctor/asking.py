"""One question to something that may be a server, and what it says."""

from __future__ import annotations

import http.client
import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from bnserve_protocol import BnserveError, printable
from bnserve_protocol.wire import JSON
from bnserve_service.bench.load import Target

ANSWER_SECONDS = 30.0
"""Without a byte; a server under load may take its time."""
LARGEST_ANSWER = 2**20


class NoAnswer(BnserveError):
    """Nobody answers, or not in HTTP."""

    code = "no-answer"
    title = "No answer"


@dataclass(frozen=True, slots=True)
class Answer:
    """What a server said."""

    status: int
    headers: Mapping[str, str]
    """Names in lower case."""
    body: bytes

    def document(self) -> dict[str, Any]:
        """The JSON object in it; an empty one where there is none."""
        try:
            found = json.loads(self.body)
        except (ValueError, RecursionError):
            return {}
        return found if isinstance(found, dict) else {}

    def detail(self) -> str:
        """What it says is wrong, on one line."""
        return printable(str(self.document().get("detail", f"status {self.status}")))[:300]


def ask(target: Target, path: str, body: bytes = b"", seconds: float = ANSWER_SECONDS) -> Answer:
    """One question over a connection of its own: GET, or POST where there is a body in JSON.

    Raises
    ------
    NoAnswer
        Nothing listens there, or what it says is no HTTP.
    """
    headers = {"Accept": f"{JSON}, application/problem+json", "Connection": "close"}
    headers |= {"Content-Type": JSON} if body else {}
    try:
        with target.connect() as connection:
            connection.settimeout(seconds)
            connection.sendall(target.request(path, body, headers, "POST" if body else "GET"))
            with http.client.HTTPResponse(connection) as response:
                response.begin()
                named = {name.lower(): value for name, value in response.getheaders()}
                return Answer(response.status, named, response.read(LARGEST_ANSWER))
    except (OSError, http.client.HTTPException, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
        raise NoAnswer(f"no answer in HTTP: {printable(reason)}") from error
