"""Memory for large bodies on their way."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from starlette.types import Message, Receive

from bnserve_protocol import Overloaded


class UploadRoom:
    """Memory for bodies on their way, counted as they arrive: a slow sender holds no more than it has sent.

    Parameters
    ----------
    capacity:
        Bytes of all together.
    """

    def __init__(self, capacity: int) -> None:
        self._capacity = capacity
        self.taken = 0
        """Bytes held now."""

    @contextmanager
    def counting(self, receive: Receive) -> Iterator[Receive]:
        """``receive``, which counts until the context ends.

        Raises
        ------
        Overloaded
            From that ``receive``: too many large bodies are on their way.
        """
        own = 0

        async def counted() -> Message:
            nonlocal own
            message = await receive()
            size = len(message.get("body", b""))
            if self.taken + size > self._capacity:
                raise Overloaded("Too many analyses are being uploaded at once; try again shortly.", retry_after=1.0)
            own += size
            self.taken += size
            return message

        try:
            yield counted
        finally:
            self.taken -= own
