"""Loading the training modules, which need packages that a server does not have."""

from __future__ import annotations

import importlib
from types import ModuleType

from bnserve_protocol import BnserveError


def import_training(*names: str) -> list[ModuleType]:
    """Modules of ``bnserve_surrogate.training``; a missing package is an error that says how to get it."""
    try:
        return [importlib.import_module(f"bnserve_surrogate.training.{name}") for name in names]
    except ModuleNotFoundError as error:
        missing = (error.name or "").partition(".")[0]
        if missing.startswith("bnserve"):
            raise
        raise BnserveError(
            f"Training needs the package '{missing}', which is not installed. In a checkout: pip install '.[train]' "
            "(TEOBResumS is compiled then: it needs a C compiler and the GNU Scientific Library, libgsl-dev)."
        ) from error
