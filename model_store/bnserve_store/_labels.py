"""Labels: names that move, like ``stable``, for versions that do not."""

from __future__ import annotations

import msgspec

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete, UndecodableBody
from bnserve_protocol.wire import refuse_repeated_keys
from bnserve_store._names import is_version
from bnserve_store._roots import Root

LABELS_FILE = "labels.json"
_LIMIT = 2**20
"""Bytes; thousands of labels."""

_decoder = msgspec.json.Decoder(dict[str, str])


def read_labels(root: Root, name: str) -> dict[str, str]:
    """The labels of a model in one root, label to version; none where there is no file.

    Raises
    ------
    ArtifactCorrupted
        The file is not a JSON object of versions.
    """
    if name not in root.folders():
        return {}
    try:
        data = root.read(name, LABELS_FILE, limit=_LIMIT)
    except ArtifactIncomplete as error:
        if isinstance(error.__cause__, FileNotFoundError):
            return {}
        raise
    try:
        labels = _decoder.decode(data)
        refuse_repeated_keys(data, data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError, UndecodableBody) as error:
        raise _corrupted(name) from error
    if not all(is_version(version) for version in labels.values()):
        raise _corrupted(name)
    return labels


def _corrupted(name: str) -> ArtifactCorrupted:
    return ArtifactCorrupted(
        f"{name}/{LABELS_FILE} is damaged: it should be a JSON object from labels to versions. Remove it and set the "
        "labels again (the versions themselves are not affected)."
    )


def encode_labels(labels: dict[str, str]) -> bytes:
    """The bytes of ``labels.json``."""
    return msgspec.json.format(msgspec.json.encode(labels, order="sorted"), indent=2) + b"\n"
