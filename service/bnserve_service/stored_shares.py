"""How much each token may keep uploaded: grids and analyses together, over all processes of a server.

An upload beyond a token's share takes the place of what it uploaded longest ago. What it uploaded within the last
minute is probably in use and stays: then the upload is refused until the minute is over, so that two analyses that do
not fit beside each other do not drive each other out for ever.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeAlias

from bnserve_protocol import ShareExceeded, TooLarge
from bnserve_service.settings import Token

Kind: TypeAlias = Literal["grid", "analysis"]
KEPT_SECONDS = 60.0


@dataclass(frozen=True, slots=True)
class Upload:
    """What a token has uploaded."""

    kind: Kind
    sha256: str
    nbytes: int
    when: float
    """``time.time()``."""


@dataclass(frozen=True, slots=True)
class Keeping:
    """Where uploads of one kind are: by owner and digest, whether one is there still, and how to drop it."""

    has: Callable[[str, str], bool]
    drop: Callable[[str, str], object]


class StoredShares:
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
        So long an upload stays in any case.
    """

    def __init__(
        self,
        tokens: Sequence[Token],
        keeping: Mapping[Kind, Keeping],
        shared: Path | None = None,
        kept_seconds: float = KEPT_SECONDS,
    ) -> None:
        self._kept_seconds = kept_seconds
        self._most = {token.sha256: token.max_stored_bytes for token in tokens if token.max_stored_bytes is not None}
        self._keeping = keeping
        self._uploads: _Uploads | _SharedUploads = (
            _Uploads() if shared is None else _SharedUploads(shared / "stored-shares")
        )

    def make_room(self, owner: str, kind: Kind, sha256: str, nbytes: int) -> None:
        """See that an upload is within its owner's share.

        Raises
        ------
        ShareExceeded
            Not now; ``retry_after`` says when.
        TooLarge
            It alone is larger than the share.
        """
        most = self._most.get(owner)
        if most is None:
            return
        if nbytes > most:
            raise TooLarge(f"This token may keep {most} bytes uploaded, and this upload has {nbytes}.")
        there = [each for each in self._present(owner) if (each.kind, each.sha256) != (kind, sha256)]
        there.sort(key=lambda each: each.when)
        while there and sum(each.nbytes for each in there) + nbytes > most:
            oldest = there.pop(0)
            age = time.time() - oldest.when
            if 0.0 <= age < self._kept_seconds:
                raise ShareExceeded(
                    f"This token may keep {most} bytes uploaded, and what it has was uploaded a moment ago; "
                    "wait, delete an analysis, or ask the operators for a larger share.",
                    retry_after=self._kept_seconds - age,
                )
            self._uploads.remove(owner, oldest)
            self._keeping[oldest.kind].drop(owner, oldest.sha256)

    def note(self, owner: str, kind: Kind, sha256: str, nbytes: int) -> None:
        """An upload was kept."""
        if owner in self._most:
            self._uploads.add(owner, Upload(kind, sha256, nbytes, time.time()))

    def _present(self, owner: str) -> list[Upload]:
        """What an owner has, without what was dropped since for other reasons."""
        found = []
        for upload in self._uploads.of(owner):
            if self._keeping[upload.kind].has(owner, upload.sha256):
                found.append(upload)
            else:
                self._uploads.remove(owner, upload)
        return found


class _Uploads:
    """In memory."""

    def __init__(self) -> None:
        self._of: dict[str, dict[tuple[Kind, str], Upload]] = {}

    def of(self, owner: str) -> list[Upload]:
        return list(self._of.get(owner, {}).values())

    def add(self, owner: str, upload: Upload) -> None:
        self._of.setdefault(owner, {})[upload.kind, upload.sha256] = upload

    def remove(self, owner: str, upload: Upload) -> None:
        self._of[owner].pop((upload.kind, upload.sha256), None)


class _SharedUploads:
    """As empty files whose names say what, and whose times say when."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def of(self, owner: str) -> list[Upload]:
        found = []
        for path in sorted(self._folder.glob(f"{owner}/*-*-*")):
            kind, sha256, nbytes = path.name.split("-")
            with suppress(FileNotFoundError):
                found.append(
                    Upload("grid" if kind == "grid" else "analysis", sha256, int(nbytes), path.stat().st_mtime)
                )
        return found

    def add(self, owner: str, upload: Upload) -> None:
        path = self._path(owner, upload)
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        path.touch(mode=0o600)

    def remove(self, owner: str, upload: Upload) -> None:
        self._path(owner, upload).unlink(missing_ok=True)

    def _path(self, owner: str, upload: Upload) -> Path:
        return self._folder / owner / f"{upload.kind}-{upload.sha256}-{upload.nbytes}"
