"""How much each token may keep uploaded: grids, analyses and networks together, over all processes of a server.

An upload beyond a token's quota takes the place of what it uploaded longest ago. What it uploaded within the last
minute is probably in use and stays: then the upload is refused until the minute is over, so that two analyses that do
not fit beside each other do not drive each other out for ever.

Uploads are written down before they are stored, so that many at the same time have no more room than one after the
other; and what several tokens have uploaded is there until the last of them has lost it.
"""

from __future__ import annotations

import threading
import time
import uuid
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, get_args

from bnserve_protocol import QuotaExceeded, TooLarge
from bnserve_service.uploads.blobs import DIGEST, gone, locked
from bnserve_service.uploads.stores import Kind, UploadStore

_KINDS: dict[str, Kind] = {kind: kind for kind in get_args(Kind)}
KEPT_SECONDS = 60.0
"""So long an upload stays in any case."""
LEFT_BEHIND = 60.0
"""Seconds after which an upload that is still being stored belongs to a worker that did not live to finish it."""
_MOMENT = 1.0
"""Seconds after which an upload that is under way has been stored or refused."""


@dataclass(frozen=True, slots=True)
class Upload:
    """What an owner has uploaded, or is uploading."""

    kind: Kind
    sha256: str
    nbytes: int
    coming: str = ""
    """A name of its own while it is being stored; empty once it is kept."""

    @property
    def what(self) -> tuple[Kind, str]:
        """The object: the same for all uploads of one content."""
        return self.kind, self.sha256


class Records:
    """Who has uploaded what, and when (``time.time()``), in a server of one process.

    Whoever reads records and then changes them does both :meth:`alone`.
    """

    def __init__(self) -> None:
        self._of: dict[str, dict[Upload, float]] = {}
        self._lock = threading.Lock()

    def alone(self) -> AbstractContextManager[object]:
        """Keep all others out for a moment."""
        return self._lock

    def of(self, owner: str) -> dict[Upload, float]:
        """Those of one owner."""
        return dict(self._of.get(owner, {}))

    def has_owner(self, kind: Kind, sha256: str) -> bool:
        """Whether anybody has this object, or is uploading it."""
        return any(upload.what == (kind, sha256) for uploads in self._of.values() for upload in uploads)

    def add(self, owner: str, upload: Upload) -> None:
        """Write one down, now."""
        self._of.setdefault(owner, {})[upload] = time.time()

    def remove(self, owner: str, upload: Upload) -> None:
        """Forget one, if it is there."""
        self._of.get(owner, {}).pop(upload, None)


class SharedRecords(Records):
    """The records of all workers of one server: empty files whose names say what, and whose times say when.

    Parameters
    ----------
    folder
        Where; it is made when it is needed.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def alone(self) -> AbstractContextManager[object]:
        """A process that dies lets go."""
        return locked(self._folder)

    def of(self, owner: str) -> dict[Upload, float]:
        """Those of one owner."""
        found: dict[Upload, float] = {}
        for path in sorted(self._folder.glob(f"{owner}/*-*")):
            kind, sha256, nbytes, *name = path.name.split("-")
            with suppress(FileNotFoundError):
                upload = Upload(_KINDS[kind], sha256, int(nbytes), "".join(name))
                found[upload] = path.stat().st_mtime
        return found

    def has_owner(self, kind: Kind, sha256: str) -> bool:
        """Whether anybody has this object, or is uploading it."""
        return any(self._folder.glob(f"*/{kind}-{sha256}-*"))

    def add(self, owner: str, upload: Upload) -> None:
        """Write one down, now."""
        path = self._path(owner, upload)
        path.parent.mkdir(mode=0o700, exist_ok=True)
        path.touch(mode=0o600)

    def remove(self, owner: str, upload: Upload) -> None:
        """Forget one, if it is there."""
        self._path(owner, upload).unlink(missing_ok=True)

    def _path(self, owner: str, upload: Upload) -> Path:
        name = f"{upload.kind}-{upload.sha256}-{upload.nbytes}"
        return self._folder / owner / (f"{name}-{upload.coming}" if upload.coming else name)


class StorageQuotas:
    """What each token has stored and what it may.

    Parameters
    ----------
    most
        How much an owner may keep; None for no limit.
    uploads
        Where they are, by kind.
    shared
        A folder that the processes of one server share; None for one process.
    """

    def __init__(
        self, most: Callable[[str], int | None], uploads: Mapping[Kind, UploadStore[Any]], shared: Path | None = None
    ) -> None:
        self._most = most
        self._uploads = uploads
        self._records = Records() if shared is None else SharedRecords(shared / "storage-quotas")

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
        upload = Upload(kind, sha256, nbytes, uuid.uuid4().hex)
        try:
            if not owner or not DIGEST.fullmatch(sha256):  # what is no digest is refused by whoever stores it
                yield
                return
            with self._records.alone():
                self._make_room(owner, upload)
                self._records.add(owner, upload)
            try:
                yield
                with self._records.alone():
                    self._records.add(owner, replace(upload, coming=""))
            finally:
                self._records.remove(owner, upload)
        except FileNotFoundError as error:
            raise gone() from error

    def _make_room(self, owner: str, upload: Upload) -> None:
        present = self._present(owner)  # also of those without a limit, whose records nobody else would tidy
        most = self._most(owner)
        if most is None:
            return
        if upload.nbytes > most:
            raise TooLarge(f"This token may keep {most} bytes uploaded, and this upload has {upload.nbytes}.")
        there = sorted((each for each in present if each.what != upload.what), key=lambda each: present[each])
        while there and _bytes_of(there) + upload.nbytes > most:
            oldest = there.pop(0)
            self._refuse_while_fresh(oldest, present[oldest], most)
            self._drop(owner, oldest)

    def _refuse_while_fresh(self, oldest: Upload, when: float, most: int) -> None:
        age = time.time() - when
        if oldest.coming or 0.0 <= age < KEPT_SECONDS:
            raise QuotaExceeded(
                f"This token may keep {most} bytes uploaded, and what it has was uploaded a moment ago; "
                "wait, delete an analysis, or ask the operators for a larger quota.",
                retry_after=max(_MOMENT, KEPT_SECONDS - age),
            )

    def _drop(self, owner: str, upload: Upload) -> None:
        self._records.remove(owner, upload)
        uploads = self._uploads[upload.kind]
        if not (uploads.is_common and self._records.has_owner(*upload.what)):
            uploads.discard(owner, upload.sha256)

    def _present(self, owner: str) -> dict[Upload, float]:
        """What an owner has, without what was dropped since for other reasons."""
        found = {}
        for upload, when in self._records.of(owner).items():
            is_coming = upload.coming and time.time() - when < LEFT_BEHIND
            if is_coming or (not upload.coming and self._uploads[upload.kind].has(owner, upload.sha256)):
                found[upload] = when
            else:
                self._records.remove(owner, upload)
        return found


def _bytes_of(uploads: Iterable[Upload]) -> int:
    """Of all together; what is uploaded several times at once is kept once."""
    return sum({each.what: each.nbytes for each in sorted(uploads, key=lambda each: each.nbytes)}.values())
