"""How much each token may keep uploaded: grids and analyses together, over all processes of a server.

An upload beyond a token's quota takes the place of what it uploaded longest ago. What it uploaded within the last
minute is probably in use and stays: then the upload is refused until the minute is over, so that two analyses that do
not fit beside each other do not drive each other out for ever.

Room is taken before an upload is stored, so that many at the same time have no more of it than one after the other;
and what several tokens have uploaded is there until the last of them has lost it.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from bnserve_protocol import QuotaExceeded, TooLarge
from bnserve_service.settings import Token
from bnserve_service.shared.files import gone
from bnserve_service.uploads.records import LEFT_BEHIND, Kind, OwnRecords, SharedRecords, Upload, UploadRecords
from bnserve_service.uploads.records import coming as about_to_store
from bnserve_service.uploads.records import kept as stored

KEPT_SECONDS = 60.0
_MOMENT = 1.0
"""Seconds after which an upload that is under way has been stored or refused."""
_DIGEST = re.compile(r"[0-9a-f]{64}")


@dataclass(frozen=True, slots=True)
class Keeping:
    """Where uploads of one kind are: by owner and digest, whether one is there still, and how to drop it."""

    has: Callable[[str, str], bool]
    drop: Callable[[str, str], object]
    is_common: bool = False
    """Whether all owners of one have the same: then it is dropped when the last of them loses it."""


class StorageQuotas:
    """What each token has stored and what it may.

    Parameters
    ----------
    tokens:
        The tokens of the settings.
    keeping:
        By kind.
    shared:
        A folder that the processes of one server share; None for one process.
    kept_seconds:
        So long an upload stays in any case; by default ``KEPT_SECONDS``.
    """

    def __init__(
        self,
        tokens: Sequence[Token],
        keeping: Mapping[Kind, Keeping],
        shared: Path | None = None,
        kept_seconds: float | None = None,
    ) -> None:
        self._kept_seconds = KEPT_SECONDS if kept_seconds is None else kept_seconds
        self._most = {token.sha256: token.max_stored_bytes for token in tokens if token.max_stored_bytes is not None}
        self._keeping = keeping
        self._records: UploadRecords = OwnRecords() if shared is None else SharedRecords(shared / "storage-quotas")

    @contextmanager
    def room(self, owner: str, kind: Kind, sha256: str, nbytes: int) -> Generator[None, None, None]:
        """Hold room for an upload while it is stored; it is given back if that fails.

        Raises
        ------
        QuotaExceeded
            Not now; ``retry_after`` says when.
        TooLarge
            It alone is larger than the quota.
        Unavailable
            The folder that workers share is gone.
        """
        try:
            with self._room(owner, kind, sha256, nbytes):
                yield
        except FileNotFoundError as error:
            raise gone() from error

    @contextmanager
    def _room(self, owner: str, kind: Kind, sha256: str, nbytes: int) -> Generator[None, None, None]:
        if not self._most or not _DIGEST.fullmatch(sha256):  # what is no digest is refused by whoever stores it
            yield
            return
        upload = about_to_store(kind, sha256, nbytes)
        with self._records.alone():
            self._make_room(owner, upload)
            self._records.add(owner, upload)
        try:
            yield
            with self._records.alone():
                self._records.add(owner, stored(upload))
        finally:
            self._records.remove(owner, upload)

    def _make_room(self, owner: str, upload: Upload) -> None:
        present = self._present(owner)  # also of those without a limit, whose records nobody else would tidy
        most = self._most.get(owner)
        if most is None:
            return
        if upload.nbytes > most:
            raise TooLarge(f"This token may keep {most} bytes uploaded, and this upload has {upload.nbytes}.")
        there = sorted((each for each in present if each.what != upload.what), key=lambda each: each.when)
        while there and _bytes_of(there) + upload.nbytes > most:
            oldest = there.pop(0)
            self._refuse_while_fresh(oldest, most)
            self._drop(owner, oldest)

    def _refuse_while_fresh(self, oldest: Upload, most: int) -> None:
        age = time.time() - oldest.when
        if oldest.coming or 0.0 <= age < self._kept_seconds:
            raise QuotaExceeded(
                f"This token may keep {most} bytes uploaded, and what it has was uploaded a moment ago; "
                "wait, delete an analysis, or ask the operators for a larger quota.",
                retry_after=max(_MOMENT, self._kept_seconds - age),
            )

    def _drop(self, owner: str, upload: Upload) -> None:
        self._records.remove(owner, upload)
        keeping = self._keeping[upload.kind]
        if not (keeping.is_common and self._records.has_owner(*upload.what)):
            keeping.drop(owner, upload.sha256)

    def _present(self, owner: str) -> list[Upload]:
        """What an owner has, without what was dropped since for other reasons."""
        found = []
        for upload in self._records.of(owner):
            is_there = (
                time.time() - upload.when < LEFT_BEHIND
                if upload.coming
                else self._keeping[upload.kind].has(owner, upload.sha256)
            )
            if is_there:
                found.append(upload)
            else:
                self._records.remove(owner, upload)
        return found


def _bytes_of(uploads: Sequence[Upload]) -> int:
    """Of all together; what is uploaded several times at once is kept once."""
    largest: dict[tuple[Kind, str], int] = {}
    for upload in uploads:
        largest[upload.what] = max(upload.nbytes, largest.get(upload.what, 0))
    return sum(largest.values())
