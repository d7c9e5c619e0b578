"""Bearer tokens: what they may do, and how much."""

from __future__ import annotations

import hashlib
from typing import Any, Literal, TypeAlias

from pydantic import AwareDatetime, BaseModel, ConfigDict, Field, field_validator, model_validator

from bnserve_service.errors import SettingsInvalid

Scope: TypeAlias = Literal["evaluate", "upload", "metrics", "admin"]
USUAL_SCOPES: tuple[Scope, ...] = ("evaluate", "upload")
"""What a sampler needs. ``metrics`` is for a Prometheus, ``admin`` for operators: metrics and looking at the stores."""

_SHORTEST_TOKEN = 16
"""Characters: shorter ones can be tried out. Those of ``bnserve tokens new`` have 47."""
_NO_SECRETS = frozenset(hashlib.sha256(bytes(text)).hexdigest() for text in ([], *([code] for code in range(128))))
"""Digests of no text at all, which a caller without a token would have, and of a single character."""


class Token(BaseModel):
    """A bearer token, known by the SHA-256 of its text only."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: str = "token"
    """Who has it: shown in logs."""
    sha256: str = Field(pattern=r"^[0-9a-f]{64}$")
    """Of its text; `bnserve tokens new` prints both."""
    scopes: tuple[Scope, ...] = USUAL_SCOPES
    """What it may do; `metrics` is for a Prometheus, `admin` for operators."""
    expires: AwareDatetime | None = None
    """When it ends, with its distance from UTC: `2027-01-01T00:00:00Z`."""
    rows_per_second: float | None = Field(default=None, gt=0.0, allow_inf_nan=False)
    """Rows evaluated per second in the long run; None for no limit."""
    burst_rows: float | None = Field(default=None, ge=1.0, allow_inf_nan=False)
    """Rows that may be saved up for a burst; None for those of one second."""
    max_concurrent: int | None = Field(default=None, ge=1)
    """Requests under way at the same time."""
    rows_per_day: int | None = Field(default=None, ge=1)
    """Rows evaluated per day, from midnight to midnight UTC."""
    max_stored_bytes: int | None = Field(default=None, ge=1024)
    """Uploaded grids and analyses together."""

    @field_validator("sha256")
    @classmethod
    def _is_of_a_secret(cls, sha256: str) -> str:
        if sha256 in _NO_SECRETS:
            raise ValueError("this is the digest of an empty text or of one character; `bnserve tokens new` makes one")
        return sha256

    @model_validator(mode="after")
    def _burst_has_a_rate(self) -> Token:
        if self.burst_rows is not None and self.rows_per_second is None:
            raise ValueError("burst_rows says how many rows may be saved up; rows_per_second must say how fast")
        return self

    @property
    def burst(self) -> float:
        """Rows that may be saved up; at least one, or nothing could ever be let through."""
        return self.burst_rows if self.burst_rows is not None else max(1.0, self.rows_per_second or 1.0)

    @property
    def is_limited(self) -> bool:
        """Whether its requests have to be counted."""
        return any(each is not None for each in (self.rows_per_second, self.max_concurrent, self.rows_per_day))

    @property
    def ends(self) -> float:
        """``time.time()`` from which it is not let in any more."""
        return float("inf") if self.expires is None else self.expires.timestamp()

    @classmethod
    def of(cls, text: str, name: str = "token", scopes: tuple[Scope, ...] = USUAL_SCOPES, **limits: Any) -> Token:
        """The token whose text is ``text``; the text itself is not kept.

        Raises
        ------
        SettingsInvalid
            No client could send it, or it is so short that it can be guessed.
        """
        if not (text.isascii() and text.isprintable() and text.strip() == text != ""):
            raise SettingsInvalid(
                "A token is printable ASCII without blanks at its ends; `bnserve tokens new` makes one."
            )
        if len(text) < _SHORTEST_TOKEN:
            raise SettingsInvalid(
                f"A token has at least {_SHORTEST_TOKEN} characters, and this one has {len(text)}: it can be guessed. "
                "`bnserve tokens new` makes one."
            )
        return cls(name=name, sha256=hashlib.sha256(text.encode()).hexdigest(), scopes=scopes, **limits)
