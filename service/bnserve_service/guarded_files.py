"""Files that decide who is let in: nobody else may write them."""

from __future__ import annotations

import logging
import os
import stat
from pathlib import Path
from typing import NamedTuple

from bnserve_service.errors import SettingsInvalid

logger = logging.getLogger("bnserve.server")


class Content(NamedTuple):
    """Of a text file, and the permissions that it had when it was opened."""

    path: Path
    text: str
    mode: int

    def check_access(self) -> None:
        """Refuse a file that others can write, and warn of one that they can read.

        Raises
        ------
        SettingsInvalid
            Others than its owner can write it.
        """
        if self.mode & (stat.S_IWGRP | stat.S_IWOTH):
            raise SettingsInvalid(
                f"The file '{self.path}' says which tokens are let in, and others than its owner can write to it: take "
                f"that from them, chmod go-w '{self.path}'."
            )
        if self.mode & stat.S_IROTH:
            logger.warning(
                "everybody on this machine can read '%s', which says which tokens are let in: chmod o-r '%s'",
                self.path,
                self.path,
            )


def read_text(path: Path, what: str) -> Content:
    """A text file.

    Parameters
    ----------
    path
        Where it is.
    what
        Its name in errors: ``"settings file"``.

    Raises
    ------
    SettingsInvalid
        It cannot be read.
    """
    try:
        with path.open(encoding="utf-8") as file:
            return Content(path, file.read(), os.fstat(file.fileno()).st_mode)
    except OSError as error:
        raise SettingsInvalid(f"The {what} '{path}' cannot be read: {error.strerror}.") from error
    except UnicodeDecodeError as error:
        raise SettingsInvalid(f"The {what} '{path}' cannot be read: it is not UTF-8.") from error
