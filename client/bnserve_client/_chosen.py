"""The model that a program chooses by address and name; without an address, one of this process.

What evaluates models and builds analyses here is no dependency of the client. Rooms that are installed beside it
register themselves in the entry-point group ``bnserve.local``: ``models`` is the class that loads models, ``analyses``
the package that builds analyses.
"""

from __future__ import annotations

import functools
import os
from importlib.metadata import entry_points
from typing import Any, Literal

from bnserve_client._model import Model
from bnserve_protocol import PackageMissing, WaveformModel

GROUP = "bnserve.local"
URL_VARIABLE = "BNSERVE_URL"

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


def chosen_model(
    url: str | tuple[str, ...] | None = None,
    name: str = "default",
    *,
    version: str = "stable",
    digest: str | None = None,
    timeout: float = 300.0,
) -> WaveformModel:
    """The model of a service; without an address here and in ``BNSERVE_URL``, the one of this name in this process.

    It is looked for once in a process, and kept.

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
