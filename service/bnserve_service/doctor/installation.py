"""Whether what is installed fits together and computes, and which extras are there."""

from __future__ import annotations

import importlib.util
import platform
from importlib import metadata

from bnserve_protocol import __version__
from bnserve_service.doctor.findings import Findings, fault, ok, warning
from bnserve_service.settings import Settings
from bnserve_service.wanted_packages import check_packages

ROOMS = ("protocol", "store", "surrogate", "inference", "service", "client")
"""Distributions ``bnserve-...`` of one repository and one version."""

EXTRAS: dict[str, tuple[tuple[str, ...], str]] = {
    "demo": (("bnserve_client", "matplotlib"), "`bnserve demo`, pictures, and `bnserve waveform --url`"),
    "completion": (("shtab",), "`bnserve completion`"),
    "train": (
        ("EOBRun_module", "joblib", "matplotlib", "numba", "optuna", "scipy", "sklearn", "tqdm"),
        "`bnserve train`, `validate` and `search`",
    ),
    "roq": (("joblib", "matplotlib", "tqdm"), "`bnserve roq build`"),
    "analyse": (("bnserve_posterior",), "from a likelihood to a posterior"),
    "jax": (("bnserve_jax",), "the model in JAX"),
    "frames": (("gwpy",), "strain in frame files (`bnserve analyse`)"),
    "bilby": (("bilby", "lal"), "bnserve_client.bilby"),
    "progress": (("tqdm",), "progress bars of the client"),
    "buckets": (("fsspec",), "model stores behind a URL"),
    "oidc": (("jwt", "cryptography"), "tokens of OpenID providers and SciTokens"),
    "otel": (("opentelemetry.sdk", "opentelemetry.exporter.otlp.proto.http"), "spans of requests (otlp_endpoint)"),
    "ray": (("ray",), "serving and training on a Ray cluster"),
    "lal": (("lalsimulation",), "training on waveforms of LAL"),
}
"""By extra of the repository, the modules that it brings and what needs them."""
_PART_OF_ALL = ("demo", "completion")
"""Extras that ``pip install .`` brings; a container that only serves has neither."""


def versions() -> Findings:
    """All rooms are of one version."""
    found = {f"bnserve-{room}": _installed(f"bnserve-{room}") for room in ROOMS}
    other = {name: version for name, version in found.items() if version not in (None, __version__)}
    if other:
        listed = ", ".join(f"{name} is {version}" for name, version in other.items())
        yield fault(
            "versions",
            f"the packages of bnserve do not belong together: {listed}, bnserve_protocol is {__version__}",
            "install all of them from one checkout: pip install .",
        )
        return
    count = sum(version is not None for version in found.values())
    yield ok("versions", f"bnserve {__version__} in {count} packages, Python {platform.python_version()}")


def _installed(distribution: str) -> str | None:
    try:
        return metadata.version(distribution)
    except metadata.PackageNotFoundError:  # a container without the client; a checkout on the PYTHONPATH
        return None


def kernels() -> Findings:
    """The compiled code of waveforms and of likelihoods can be loaded on this processor."""
    from bnserve_inference import adjoint_kernel, fisher_kernel, kernel, marginal_kernel, modes_kernel, moving_kernel
    from bnserve_surrogate import adjoint
    from bnserve_surrogate.kernel import load_kernel

    load_kernel()
    adjoint.load_adjoint()
    kernel.load_contraction()
    modes_kernel.load_contraction()
    moving_kernel.load_contraction()
    marginal_kernel.load_integrals()
    fisher_kernel.load_factorisation()
    adjoint_kernel.load_adjoint()
    yield ok("kernels", f"waveforms and likelihoods, as machine code for {platform.machine()}")


def extras() -> Findings:
    """One line for each that is not complete."""
    there = []
    for extra, (modules, purpose) in EXTRAS.items():
        missing = [module for module in modules if not _is_there(module)]
        if not missing:
            there.append(extra)
            continue
        command = "pip install ." if extra in _PART_OF_ALL else f"pip install '.[{extra}]'"
        yield warning(
            f"extra {extra}", f"not there ({', '.join(missing)}); {purpose} would need it",
            f"if you want that, in a checkout of bnserve: {command}",
        )  # fmt: skip
    yield ok("extras", f"there are {', '.join(there) or 'none'}")


def wanted(settings: Settings) -> Findings:
    """What these settings ask for is installed, also where it is of an extra."""
    names = check_packages(settings)
    if names:
        yield ok("packages", f"those that {' and '.join(names)} need are there")


def _is_there(module: str) -> bool:
    try:
        return importlib.util.find_spec(module) is not None
    except (ImportError, ValueError):  # forbidden, or half imported
        return False
