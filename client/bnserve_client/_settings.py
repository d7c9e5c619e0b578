"""What a user chooses when connecting."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from bnserve_client._addresses import Address
from bnserve_protocol import InvalidRequest


@dataclass(frozen=True, slots=True)
class Settings:
    """Closed and immutable; :meth:`Model.connect` documents each field."""

    addresses: tuple[Address, ...]
    token: str | None = field(default=None, repr=False)
    timeout: float = 300.0
    silence: float = 30.0
    retries: int | None = None
    parallel: int = 2
    chunk_samples: int = 2**21
    progress: bool = False
    names: bool = True
    """Whether names that stand for several hosts are looked up here: not where the user's transport does it."""

    def __post_init__(self) -> None:
        for name in ("timeout", "silence"):
            if not getattr(self, name) > 0.0:
                raise InvalidRequest(f"'{name}' must be a positive number of seconds; got {getattr(self, name)!r}.")
        for name in ("parallel", "chunk_samples"):
            if getattr(self, name) < 1:
                raise InvalidRequest(f"'{name}' must be at least 1; got {getattr(self, name)!r}.")
        if self.retries is not None and self.retries < 0:
            raise InvalidRequest(f"'retries' must not be negative; got {self.retries!r}.")
        if self.token is not None and not (self.token.isascii() and self.token.isprintable() and self.token.strip()):
            raise InvalidRequest("The token must be printable ASCII without line breaks; check how it was read.")

    def with_retries(self, retries: int) -> Settings:
        """The same with another number of retries."""
        return replace(self, retries=retries)
