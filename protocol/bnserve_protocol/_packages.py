"""Packages that only an extra installs, imported where they are needed."""

from __future__ import annotations

import importlib
from typing import Any

from bnserve_protocol._errors import BnserveError


class PackageMissing(BnserveError):
    """A package of an extra is not installed, or cannot be imported."""

    code = "package-missing"
    title = "Package not installed"


def require(module: str, purpose: str, extra: str = "") -> Any:
    """Import a module that needs packages of an extra.

    Parameters
    ----------
    module
        Its full name: of the package, or of a module of bnserve that imports it.
    purpose
        What needs it, as the beginning of a sentence: ``"Training"``.
    extra
        The extra of the repository that installs it; without one, the repository itself does.

    Raises
    ------
    PackageMissing
        Names the package and the command that installs it.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        missing, own = ((name or module).partition(".")[0] for name in (error.name, module))
        if missing == own and own.startswith("bnserve"):  # a defect of ours, and nothing to install
            raise
        why = "is not installed" if isinstance(error, ModuleNotFoundError) else f"cannot be imported ({error})"
        command = f"pip install '.[{extra}]'" if extra else "pip install ."
        raise PackageMissing(
            f"{purpose} needs the package '{missing}', which {why}. In a checkout of bnserve: {command}"
        ) from error
