"""What commands are told: files to write, which can be or not before the work and not after it, servers, and models."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path
from typing import Any


def check_place(path: Path, option: str) -> None:
    """Refuse a file that could not be written, before it is worked for; its folders need not exist.

    Raises
    ------
    InvalidRequest
        It is a folder, or its folder cannot be written, or the disk is full.
    """
    from bnserve_protocol import InvalidRequest
    from bnserve_store import check_writable

    try:
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        check_writable(path.parent)
    except OSError as error:
        raise InvalidRequest(
            f"Cannot write {path}: {error.strerror}. Make room, or choose another {option}."
        ) from error


def server_address(text: str) -> str:
    """What a client connects to, also where ``http://`` or ``unix:`` was left out."""
    if "://" in text or text.startswith("unix:"):
        return text
    return f"unix:{text}" if text.startswith("/") else f"http://{text}"


def name_and_version(model: str) -> tuple[str, str]:
    """From ``NAME[@VERSION]``, a version or a label."""
    name, _, version = model.partition("@")
    return name, version or "stable"


def open_model(
    model: str,
    stores: list[Path] | None,
    *,
    url: str | None = None,
    token: str | None = None,
    purpose: str = "A model",
    retries: int | None = 2,
) -> Any:
    """A model ``NAME[@VERSION]`` of these stores or of those that ship with the package, or of a server.

    Parameters
    ----------
    url, token
        Of the server; the token may be in the environment.
    purpose
        What needs the client then, as the beginning of a sentence.
    retries
        Of every request to it; None for as many as its time allows.

    Raises
    ------
    BnserveError
        There is no such model, or no such server.
    """
    from bnserve_protocol import require

    name, version = name_and_version(model)
    if url:
        client = require("bnserve_client", purpose)
        return client.Model.connect(
            server_address(url), name, version=version, token=token or token_of_environment(), retries=retries
        )
    from bnserve_store import ModelStore
    from bnserve_surrogate import Model

    return Model.load(name, version, store=ModelStore.default(stores or ()))


def modes_of(text: str | None) -> tuple[tuple[int, int], ...] | None:
    """From ``22,33``, degree and order of each mode; None, for all, where nothing is given.

    Raises
    ------
    InvalidRequest
        It is no such list.
    """
    from bnserve_protocol import EvaluationOptions, InvalidRequest

    if text is None:
        return None
    parts = text.replace(" ", "").split(",")
    if not all(len(part) == 2 and part.isascii() and part.isdigit() for part in parts):
        raise InvalidRequest(f"--modes is a list of l and m of each mode, such as 22,33; got {text[:40]!r}.")
    return EvaluationOptions(modes=tuple((int(part[0]), int(part[1])) for part in parts)).modes


def print_json(document: object) -> None:
    """For machines, on standard output."""
    print(json.dumps(document, indent=2, ensure_ascii=False))


def save_numbers(path: Path, arrays: dict[str, Any], summary: dict[str, Any]) -> None:
    """Write a waveform as the ending of the file's name says.

    Parameters
    ----------
    path
        It ends in one of :data:`WRITERS`.
    arrays
        ``frequencies`` in Hz, ``h_plus`` and ``h_cross`` in 1/Hz, each of shape ``(M,)``.
    summary
        What it is, for those that have room for it.

    Raises
    ------
    InvalidRequest
        The file cannot be written.
    """
    from bnserve_protocol import InvalidRequest

    try:
        WRITERS[path.suffix.lower()](path, arrays, summary)
    except OSError as error:
        raise InvalidRequest(f"'{path}' cannot be written: {error.strerror or error}.") from error


def _save_npz(path: Path, arrays: dict[str, Any], summary: dict[str, Any]) -> None:
    import numpy as np

    np.savez(path, **arrays, summary=np.array(json.dumps(summary)))


def _save_csv(path: Path, arrays: dict[str, Any], _: dict[str, Any]) -> None:
    import numpy as np

    plus, cross = arrays["h_plus"], arrays["h_cross"]
    table = np.column_stack([arrays["frequencies"], plus.real, plus.imag, cross.real, cross.imag])
    header = "frequency_hz,h_plus_re,h_plus_im,h_cross_re,h_cross_im"
    np.savetxt(path, table, fmt="%.17g", delimiter=",", header=header, comments="")


def _save_hdf5(path: Path, arrays: dict[str, Any], summary: dict[str, Any]) -> None:
    import h5py

    with h5py.File(path, "w") as file:
        for name, array in arrays.items():
            file[name] = array
        file.attrs["summary"] = json.dumps(summary)


def token_of_environment() -> str | None:
    """That of ``BNSERVE_TOKEN``, or in the file that ``BNSERVE_TOKEN_FILE`` names; as the client takes it.

    Raises
    ------
    InvalidRequest
        The file cannot be read.
    """
    from bnserve_protocol import InvalidRequest

    token, name = os.environ.get("BNSERVE_TOKEN"), os.environ.get("BNSERVE_TOKEN_FILE")
    if token or not name:
        return token or None
    try:
        return Path(name).read_text(encoding="utf-8").strip()
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "it is no text"
        raise InvalidRequest(
            f"The token cannot be read from the file '{name}' ($BNSERVE_TOKEN_FILE): {reason}."
        ) from error


WRITERS = {".npz": _save_npz, ".csv": _save_csv, ".h5": _save_hdf5, ".hdf5": _save_hdf5}
"""By ending of a file's name; each has frequencies in Hz and strain in 1/Hz, and all but CSV the summary as JSON."""
