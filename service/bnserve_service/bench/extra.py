"""Loading what measuring needs beside a server: the client, and for plots matplotlib."""

from __future__ import annotations

import importlib
from types import ModuleType

from bnserve_protocol import BnserveError


def import_bench(name: str) -> ModuleType:
    """A module of ``bnserve_service.bench``; a missing package is an error that says how to get it."""
    try:
        return importlib.import_module(f"bnserve_service.bench.{name}")
    except ModuleNotFoundError as error:
        missing = (error.name or "").partition(".")[0]
        raise BnserveError(
            f"This measurement needs the package '{missing}', which is not installed. In a checkout, `pip install .` "
            "brings everything that it needs; beside an installed service, install matplotlib and bnserve-client."
        ) from error
