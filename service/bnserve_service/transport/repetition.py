"""Requests that repeat the last one of their connection, but for their name, their deadline and their body.

A sampler sends the same head for hours. Parsing it again costs more than comparing it with one that the parser has
accepted, byte by byte.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from bnserve_service.transport.answers import Header

_VARIABLE = re.compile(
    rb"X-Request-ID: ([\x21-\x7e]{1,128})\r\nX-Request-Deadline-Ms: ([0-9]{1,12})\r\n"
    rb"Content-Length: ([0-9]{1,6})\r\n\r\n"
)
"""How the heads of our client end."""
_LONGEST = 2**13
_VARIABLE_NAMES = (b"x-request-id", b"x-request-deadline-ms", b"content-length")


class RepeatedHead(NamedTuple):
    """A head that the parser has accepted."""

    constant: bytes
    url: bytes
    headers: list[Header]
    """Of the constant part; names in lower case."""

    def read(self, data: bytes) -> tuple[list[Header], bytes] | None:
        """Headers and body of one whole request; None unless its head is this one."""
        if not data.startswith(self.constant):
            return None
        found = _VARIABLE.match(data, len(self.constant))
        if found is None or len(data) - found.end() != int(found[3]):
            return None
        return [*self.headers, *zip(_VARIABLE_NAMES, found.groups(), strict=True)], data[found.end() :]


def repeatable(data: bytes, url: bytes, headers: list[Header]) -> RepeatedHead | None:
    """The head of a request that came in one piece, if ours can be recognised in it.

    Parameters
    ----------
    data:
        What came.
    url, headers:
        What the parser read from it.
    """
    found = _VARIABLE.search(data, 0, _LONGEST)
    if found is None or data.find(b"\r\n\r\n") != found.end() - 4:
        return None
    names = [name for name, _ in headers]
    if any(names.count(name) != 1 for name in _VARIABLE_NAMES):
        return None
    constant = [(name, value) for name, value in headers if name not in _VARIABLE_NAMES]
    return RepeatedHead(data[: found.start()], url, constant)
