"""The replicas of a service: whom to ask, and the hosts that one name may stand for (as in Kubernetes)."""

from __future__ import annotations

import ipaddress
import itertools
import os
import socket
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
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
    given
        As the user wrote them.
    names
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


_FIRST_REST = 1.0
_LONGEST_REST = 15.0


@dataclass(slots=True)
class _Record:
    """What is remembered of one replica."""

    failures: int = 0
    """In a row."""
    resting_until: float = 0.0
    """``time.monotonic()``; 0 when it is in use."""
    probing_until: float = 0.0
    """Until then somebody else is finding out whether it is back."""


class Replicas:
    """Asks the replica with the fewest requests of this process under way, in turns among equals.

    One that fails is left out, for one second and twice as long each further time. Then one caller asks whether it is
    ready, and only if so it gets work again: nobody's request waits for a host that hangs. Where all have failed, the
    one that would be tried first is asked all the same.

    Holds no lock: the worst that two threads can do to each other is to ask the same replica.

    Parameters
    ----------
    addresses
        As the user gave them.
    resolver
        Turns names that stand for several hosts into these; None asks no name service.
    """

    probe_seconds = 1.0
    """A replica that does not say within this time that it is ready is not."""

    def __init__(self, addresses: Sequence[Address], resolver: Resolver | None = None) -> None:
        self.resolver = resolver
        self._given = tuple(addresses)
        self.only = self._given[0] if resolver is None and len(self._given) == 1 else None
        """The one address that there is and will be."""
        self._turn = itertools.count(int.from_bytes(os.urandom(2), "big"))
        self._records = {address: _Record() for address in self._given}
        self._busy: dict[tuple[int, Address], set[object]] = {}

    @property
    def addresses(self) -> tuple[Address, ...]:
        """Those that are asked now."""
        return self._given if self.resolver is None else self.resolver.addresses

    def choose(self) -> Address:
        """The next address that is not resting, or the one that will wake first."""
        addresses = self.addresses
        if len(addresses) == 1:
            return addresses[0]
        start = next(self._turn) + os.getpid()
        turned = [addresses[(start + step) % len(addresses)] for step in range(len(addresses))]
        in_use = [address for address in turned if not self._record(address).resting_until]
        if in_use:
            return min(in_use, key=self._under_way)
        return min(turned, key=lambda address: self._record(address).resting_until)

    @contextmanager
    def asking(self, address: Address) -> Iterator[None]:
        """While a request to the address is under way."""
        if len(self.addresses) == 1:
            yield
            return
        request, busy = object(), self._busy.setdefault((os.getpid(), address), set())
        busy.add(request)
        try:
            yield
        finally:
            busy.discard(request)

    def rest(self, address: Address, at_least: float = 0.0, *, broken: bool = True) -> None:
        """Leave the address out for a while; ``broken`` ones for longer each time."""
        record = self._record(address)
        record.failures = min(record.failures + broken, 30)
        seconds = min(_LONGEST_REST, _FIRST_REST * 2.0 ** max(0, record.failures - 1))
        record.resting_until, record.probing_until = time.monotonic() + max(seconds, at_least), 0.0
        if self.resolver is not None:
            self.resolver.look_again_soon()

    def wake(self, address: Address) -> None:
        """The address answered."""
        record = self._records.get(address)
        if record is not None:
            record.failures, record.resting_until = 0, 0.0

    def to_probe(self) -> Address | None:
        """An address that has rested and of which it is to be found out now whether it is back, while others work."""
        addresses = self.addresses
        if len(addresses) == 1:
            return None
        now = time.monotonic()
        records = {address: self._record(address) for address in addresses}
        if all(record.resting_until for record in records.values()):
            return None
        for address, record in records.items():
            if 0.0 < record.resting_until <= now and record.probing_until <= now:
                record.probing_until = now + 2.0 * self.probe_seconds
                return address
        return None

    def is_resting(self, address: Address) -> bool:
        """Whether the address failed a moment ago."""
        return self._record(address).resting_until > time.monotonic()

    def any_awake(self) -> bool:
        """Whether some address has not failed a moment ago."""
        return any(not self.is_resting(address) for address in self.addresses)

    def _record(self, address: Address) -> _Record:
        record = self._records.get(address)
        return self._records.setdefault(address, _Record()) if record is None else record

    def _under_way(self, address: Address) -> int:
        return len(self._busy.get((os.getpid(), address), ()))
