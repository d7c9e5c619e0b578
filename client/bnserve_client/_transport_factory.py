"""The ``transport`` argument of ``connect``: an httpx client or transport, or a function that makes one."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeAlias

from bnserve_protocol import InvalidRequest

if TYPE_CHECKING:
    import httpx

TransportLike: TypeAlias = "httpx.Client | httpx.BaseTransport | Callable[[], httpx.Client | httpx.BaseTransport]"
AsyncTransportLike: TypeAlias = (
    "httpx.AsyncClient | httpx.AsyncBaseTransport | Callable[[], httpx.AsyncClient | httpx.AsyncBaseTransport]"
)

_USE_A_FUNCTION = (
    "A transport object belongs to the process that made it; to use the model in other processes, pass a module-level "
    "function that makes the transport instead: Model.connect(..., transport=make_transport)."
)


class TransportFactory:
    """Where httpx clients come from.

    Parameters
    ----------
    given
        An ``httpx.Client``, an ``httpx.BaseTransport`` or their asynchronous sisters, which the user also closes and
        which work in this process alone; or a function without arguments that returns one.
    """

    def __init__(self, given: Any) -> None:
        self.makes_new = _makes_new(given)
        self._given = given
        self._process = os.getpid()

    def make(self, client: Callable[..., Any], transport: type[Any]) -> Any:
        """An httpx client: the given one, one from the given function, or one around the given transport.

        Raises
        ------
        InvalidRequest
            The transport belongs to another process, or is none.
        """
        if not self.makes_new and os.getpid() != self._process:
            raise InvalidRequest(_USE_A_FUNCTION)
        made = self._given() if self.makes_new else self._given
        if isinstance(made, transport):
            return client(transport=made)
        if isinstance(client, type) and isinstance(made, client):
            return made
        raise InvalidRequest(
            f"'transport' must be or return an httpx client or transport of the matching kind "
            f"({transport.__name__}); got {type(made).__name__}."
        )

    def __reduce__(self) -> tuple[Any, ...]:
        if not self.makes_new:
            raise TypeError(_USE_A_FUNCTION)
        return TransportFactory, (self._given,)


def _makes_new(given: Any) -> bool:
    import httpx

    kinds = (httpx.Client, httpx.AsyncClient, httpx.BaseTransport, httpx.AsyncBaseTransport)
    return callable(given) and not isinstance(given, kinds)
