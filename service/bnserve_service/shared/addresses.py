"""How many connections each address has, in all processes of one server."""

from __future__ import annotations

import contextlib
import json
from collections import Counter
from collections.abc import Callable, Iterator
from ipaddress import ip_address, ip_network
from pathlib import Path

from bnserve_service.shared.folder import addresses_file

_HOST_BITS = 64
"""Of an IPv6 address whatever follows is chosen by the host itself, which may have as many as it likes."""


class Addresses:
    """Counts connections by address, and says when one has enough.

    Each process writes down its own numbers, and reads those of the others when somebody connects. Two that take a
    connection at the same moment may let one too many in.

    Parameters
    ----------
    most
        Connections of one address.
    shared
        A folder that the processes of one server share; None for one process.
    place
        Which of them this is.
    """

    def __init__(self, most: int, shared: Path | None = None, place: int = 0) -> None:
        self.most = most
        self._shared, self._file = shared, None if shared is None else addresses_file(shared, place)
        self._own: Counter[str] = Counter()
        self._write()

    def enter(self, address: str) -> Callable[[], None] | None:
        """Count a connection, unless its address has as many as it may: then None.

        Returns what is to be called when it ends; once more is no harm.
        """
        host = _host(address)
        if self._own[host] + sum(numbers.get(host, 0) for numbers in self._others()) >= self.most:
            return None
        self._own[host] += 1
        self._write()
        open_ones = {host}

        def leave() -> None:
            if open_ones:
                open_ones.clear()
                self._own[host] -= 1
                if not self._own[host]:
                    del self._own[host]
                self._write()

        return leave

    def _others(self) -> Iterator[dict[str, int]]:
        if self._shared is None or self._file is None:
            return
        for path in self._shared.glob(addresses_file(self._shared, "*").name):
            if path != self._file:
                with contextlib.suppress(OSError, ValueError):  # it ends at this moment
                    yield json.loads(path.read_bytes())

    def _write(self) -> None:
        if self._file is None:
            return
        fresh = self._file.with_suffix(".new")
        with contextlib.suppress(OSError):  # no room, or the folder is gone: answering counts more
            fresh.write_text(json.dumps(self._own))
            fresh.replace(self._file)


def _host(address: str) -> str:
    """What counts as one: an address, or the network of one of IPv6."""
    try:
        known = ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if known.version == 4:
        return str(known)
    if known.ipv4_mapped is not None:
        return str(known.ipv4_mapped)
    return str(ip_network((known, _HOST_BITS), strict=False))
