"""The model that a program chooses by address and name; without an address, one of this process.

What evaluates models and builds analyses here is no dependency of the client. Rooms that are installed beside it
register themselves in the entry-point group ``bnserve.local``: ``models`` is the class that loads models, ``analyses``
the package that builds analyses.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Iterable, Mapping
from importlib.metadata import entry_points
from typing import Any, Literal

from bnserve_client._model import Model
from bnserve_protocol import InvalidRequest, PackageMissing, WaveformModel, nearest_name

GROUP = "bnserve.local"
URL_VARIABLE, MODEL_VARIABLE = "BNSERVE_URL", "BNSERVE_MODEL"
ARGUMENTS = ("bnserve_url", "bnserve_model", "bnserve_version", "bnserve_digest", "bnserve_timeout")
"""By which users of other programs choose a model; see :func:`chosen_model`."""

_ROOMS = {
    "models": "./protocol ./model_store ./surrogate",
    "analyses": "./protocol ./model_store ./surrogate ./inference",
}
"""Folders of a checkout that bring each of them: nothing is installed by a bare name."""


@functools.cache
def local_part(name: Literal["models", "analyses"], purpose: str) -> Any:
    """What an installed room registered under a name of the group.

    Parameters
    ----------
    name
        ``"models"`` or ``"analyses"``.
    purpose
        What needs it, as the beginning of a sentence: ``"Building an analysis"``.

    Raises
    ------
    PackageMissing
        No such room is installed; says what to install.
    """
    for entry in entry_points(group=GROUP, name=name):
        return entry.load()
    raise PackageMissing(
        f"{purpose} needs a part of bnserve that is not installed here. In a checkout of bnserve: "
        f"pip install {_ROOMS[name]}"
    )


def read_arguments(
    given: Mapping[str, Any],
) -> tuple[str | tuple[str, ...] | None, str | None, str, str | None, float]:
    """What :func:`chosen_model` takes, of those of the :data:`ARGUMENTS` that are given and not None; hashable.

    Address and name are those of the environment of the moment where they are not given.

    Raises
    ------
    InvalidRequest
        A timeout that is no number.
    """
    url, model, version, digest, timeout = (given.get(name) for name in ARGUMENTS)
    url, model = url or os.environ.get(URL_VARIABLE), model or os.environ.get(MODEL_VARIABLE)
    return (
        url if url is None or isinstance(url, str) else tuple(map(str, url)),  # several replicas
        None if model is None else str(model),
        "stable" if version is None else str(version),
        None if digest is None else str(digest),
        300.0
        if timeout is None
        else number("bnserve_timeout", timeout, "seconds that an outage may last, such as 300"),
    )


def number(name: str, value: Any, of: str = "such as 50") -> float:
    """A number that a user gave by this name, as one or as its text.

    Parameters
    ----------
    of
        What it is, as the end of a sentence.

    Raises
    ------
    InvalidRequest
        It is none.
    """
    try:
        return float(value)
    except (TypeError, ValueError):
        raise InvalidRequest(f"'{name}' is a number, {of}; got {value!r:.80}.") from None


def unknown_argument(name: str, known: Iterable[str]) -> InvalidRequest:
    """The error of a waveform argument that is none."""
    near = nearest_name(name, sorted(known))
    hint = f"known are {', '.join(sorted(known))}." if near is None else f"did you mean '{near}'?"
    return InvalidRequest(f"Unknown waveform argument '{name[:80]}': {hint}")


def chosen_model(
    url: str | tuple[str, ...] | None = None,
    name: str | None = None,
    *,
    version: str = "stable",
    digest: str | None = None,
    timeout: float = 300.0,
) -> WaveformModel:
    """The model of a service; without an address here and in ``BNSERVE_URL``, the one of this name in this process.

    It is looked for once in a process, and kept. Without a name here and in ``BNSERVE_MODEL``, it is ``"default"``.

    Parameters
    ----------
    url, name, version, digest, timeout
        As in :meth:`.Model.connect`; the token is that of ``BNSERVE_TOKEN``.

    Raises
    ------
    PackageMissing
        There is no address, and no models are installed here.
    ConnectionFailed, NotBnserve, ModelUnknown, DigestUnknown, Unauthorized, InvalidRequest
        As :meth:`.Model.connect`.
    """
    name = name or os.environ.get(MODEL_VARIABLE) or "default"
    return _kept(url or os.environ.get(URL_VARIABLE) or None, name, version, digest, timeout)


@functools.lru_cache(maxsize=16)
def _kept(
    url: str | tuple[str, ...] | None, name: str, version: str, digest: str | None, timeout: float
) -> WaveformModel:
    if url is not None:
        return Model.connect(url, name, version=version, digest=digest, timeout=timeout)
    purpose = f"No address of a service is given (nor is {URL_VARIABLE} set), and evaluating the model '{name}' here"
    model: WaveformModel = local_part("models", purpose).load(name, version, digest=digest)
    return model
