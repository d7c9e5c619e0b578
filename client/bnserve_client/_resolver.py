"""Host names that stand for several hosts, as those of a Kubernetes service without a cluster address do."""

from __future__ import annotations

import ipaddress
import os
import socket
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from bnserve_client._addresses import Address

PROXY_VARIABLES = ("http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY")
_LOOK_EVERY = 30.0
"""Seconds; replicas come and go."""
_LOOK_SOON = 1.0
"""Seconds after a failure."""


def behind_proxy() -> bool:
    """Whether the environment names a proxy for ``http://``."""
    return any(os.environ.get(name) for name in PROXY_VARIABLES)


def names_to_resolve(addresses: Iterable[Address]) -> tuple[Address, ...]:
    """The addresses whose hosts are names that this process looks up itself.

    Not those of ``https``, where the name is what the certificate vouches for and the transport looks it up, nor where
    a proxy does it.
    """
    return () if behind_proxy() else tuple(address for address in addresses if _is_name(address))


class Resolver:
    """The addresses in use: those given, and in place of a name that stands for several hosts, each of them.

    Parameters
    ----------
    given:
        As the user wrote them.
    names:
        Those of them to look up.
    """

    def __init__(self, given: Sequence[Address], names: Sequence[Address]) -> None:
        self.addresses = tuple(given)
        self._given = tuple(given)
        self._names = tuple(names)
        self._hosts: dict[Address, tuple[str, ...]] = {}
        self._look_at = 0.0

    def due(self) -> tuple[Address, ...]:
        """The names to look up now, by the caller alone."""
        now = time.monotonic()
        if now < self._look_at:
            return ()
        self._look_at = now + _LOOK_EVERY
        return self._names

    def look_again_soon(self) -> None:
        """A replica failed: perhaps it has moved."""
        self._look_at = min(self._look_at, time.monotonic() + _LOOK_SOON)

    def found(self, hosts: Mapping[Address, Sequence[str]]) -> None:
        """Take what a look-up has found; a name that was not found stays what it was."""
        self._hosts |= {address: tuple(several) for address, several in hosts.items() if several}
        self.addresses = tuple(
            dict.fromkeys(each for address in self._given for each in _each(address, self._hosts.get(address, ())))
        )


def several_hosts(entries: Iterable[tuple[Any, ...]]) -> tuple[str, ...]:
    """The hosts among the entries of ``getaddrinfo``, of one family: the other reaches the same ones."""
    for family in (socket.AF_INET, socket.AF_INET6):
        hosts = sorted({str(entry[4][0]) for entry in entries if entry[0] == family})
        if len(hosts) > 1:
            return tuple(hosts)
    return ("",)


def _each(address: Address, hosts: Sequence[str]) -> list[Address]:
    if len(hosts) < 2:  # one host, perhaps of both families: connecting tries them in turn
        return [address]
    return [replace(address, text=f"{address.text} ({host})", ip=host) for host in hosts]


def _is_name(address: Address) -> bool:
    if address.scheme != "http" or address.host == "localhost":
        return False
    try:
        ipaddress.ip_address(address.host)
    except ValueError:
        return True
    return False
