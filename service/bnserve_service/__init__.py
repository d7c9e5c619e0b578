"""The HTTP service of bnserve and the ``bnserve`` command: the composition root of all rooms.

What is exported is imported on first use, so that the command line can set thread limits before numpy starts.
"""

from __future__ import annotations

import importlib
import typing
from typing import Any

from bnserve_service._version import __version__

if typing.TYPE_CHECKING:
    from bnserve_service.admission.tokens import Token
    from bnserve_service.app import Application, create_app
    from bnserve_service.background import BackgroundServer
    from bnserve_service.models.registry import ModelFactory, ModelSource, ServedModel
    from bnserve_service.server import serve
    from bnserve_service.settings import ServiceLimits, Settings, load_settings

_HOMES = {
    "Application": "app",
    "BackgroundServer": "background",
    "ModelFactory": "models.registry",
    "ModelSource": "models.registry",
    "ServedModel": "models.registry",
    "ServiceLimits": "settings",
    "Settings": "settings",
    "Token": "admission.tokens",
    "create_app": "app",
    "load_settings": "settings",
    "serve": "server",
}

__all__ = [
    "Application",
    "BackgroundServer",
    "ModelFactory",
    "ModelSource",
    "ServedModel",
    "ServiceLimits",
    "Settings",
    "Token",
    "__version__",
    "create_app",
    "load_settings",
    "serve",
]


def __getattr__(name: str) -> Any:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{home}"), name)
