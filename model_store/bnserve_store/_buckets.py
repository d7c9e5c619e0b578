"""Roots in buckets (``s3://...``, ``gs://...``) through fsspec; read-only.

Buckets have no atomic rename, so publishing goes to a directory, which is then copied up.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from bnserve_protocol import ArtifactCorrupted, StoreUnknown
from bnserve_store._files import RESTORE


class BucketRoot:
    """A folder of a bucket, given as a URL."""

    def __init__(self, url: str) -> None:
        self.title = url
        try:
            self._files, self._path = import_module("fsspec.core").url_to_fs(url)
        except ModuleNotFoundError as error:
            raise StoreUnknown(
                f"The model store '{url}' is a URL, which needs more packages (missing: {error.name}): "
                "pip install '.[buckets]' in the repository of bnserve, and the fsspec package of its protocol."
            ) from error
        except Exception as error:  # every protocol of fsspec raises its own errors
            raise self._unreachable(error) from error

    def folders(self, *parts: str) -> list[str]:
        """As :meth:`Root.folders`, listed anew."""
        try:
            entries: list[dict[str, Any]] = self._files.ls(self._join(parts), detail=True, refresh=True)
        except FileNotFoundError as error:
            if parts:
                return []
            raise self._unreachable(error) from error
        except Exception as error:  # see above
            raise self._unreachable(error) from error
        return sorted(_last(entry["name"]) for entry in entries if entry["type"] == "directory")

    def read(self, *parts: str, limit: int) -> bytes | None:
        """As :meth:`Root.read`; StoreUnknown where the bucket cannot be reached."""
        file = "/".join(parts)
        try:
            with self._files.open(self._join(parts), "rb") as stream:
                data: bytes = stream.read(limit + 1)
        except FileNotFoundError:
            return None
        except Exception as error:  # see above
            raise self._unreachable(error) from error
        if len(data) > limit:
            raise ArtifactCorrupted(f"{file} is larger than the {limit} bytes it may have. {RESTORE}")
        return data

    def _join(self, parts: tuple[str, ...]) -> str:
        return "/".join((self._path.rstrip("/"), *parts))

    def _unreachable(self, error: Exception) -> StoreUnknown:
        return StoreUnknown(
            f"The model store '{self.title}' does not exist or cannot be reached ({type(error).__name__}); "
            "check the address and the credentials."
        )


def _last(path: str) -> str:
    return path.rstrip("/").rsplit("/", 1)[-1]
