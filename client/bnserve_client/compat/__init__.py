"""bnserve under the names of other waveform packages, for programs that import them.

::

    import bnserve_client.compat

    bnserve_client.compat.register()  # from mlgw_bns import Model is bnserve's from here on
"""

from __future__ import annotations

import importlib
import importlib.util
import sys

from bnserve_protocol import InvalidRequest

__all__ = ["register"]

_NAME = "mlgw_bns"


def register(*, replace: bool = False) -> None:
    """Let ``mlgw_bns`` be :mod:`bnserve_client.compat.mlgw_bns` in this process, before a program imports it.

    ``mlgw_bns.model`` is it, too. Processes that are forked have it; where a pool starts new interpreters, call it at
    the top of the script, outside of ``if __name__ == "__main__"``. A second call changes nothing.

    Parameters
    ----------
    replace
        Take the place of an mlgw_bns that is installed or imported, in this process.

    Raises
    ------
    InvalidRequest
        There is an mlgw_bns, and ``replace`` is not set: nobody is given another's waveforms unasked.
    """
    ours = importlib.import_module(f"{__name__}.{_NAME}")
    there = sys.modules.get(_NAME) or importlib.util.find_spec(_NAME)
    if there not in (None, ours) and not replace:
        where = getattr(there, "__file__", None) or getattr(there, "origin", None)
        raise InvalidRequest(
            f"There is an mlgw_bns here ({where}), which would be hidden: bnserve_client.compat.register(replace=True) "
            "takes its place in this process, or uninstall it."
        )
    for name in [name for name in sys.modules if name.startswith(f"{_NAME}.")]:
        del sys.modules[name]
    sys.modules[_NAME] = sys.modules[f"{_NAME}.model"] = vars(ours)["model"] = ours
