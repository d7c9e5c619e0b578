"""The bases that come with the package."""

from __future__ import annotations

from importlib.resources import as_file, files

from bnserve_inference.roq._errors import BasisFileInvalid
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature, load_basis


def shipped_bases() -> list[str]:
    """Names of the bases that come with the package; ``configs/roq_NAME.toml`` is what each was built from."""
    folder = files("bnserve_inference") / "bases"
    return sorted(entry.name.removesuffix(".h5") for entry in folder.iterdir() if entry.name.endswith(".h5"))


def load_shipped_basis(name: str) -> ReducedOrderQuadrature:
    """One of :func:`shipped_bases`, such as ``"gw170817_fine"``.

    Raises
    ------
    BasisFileInvalid
        No such basis; the message lists those there are.
    """
    if name not in shipped_bases():
        raise BasisFileInvalid(
            f"No basis '{str(name)[:40]}' comes with the package; there are {', '.join(shipped_bases())}. Build your "
            "own with bnserve roq build, and read its file with load_basis."
        )
    with as_file(files("bnserve_inference") / "bases" / f"{name}.h5") as path:
        return load_basis(path)
