"""The programs and the processor that waveforms are made with."""

from __future__ import annotations

import functools
import hashlib
import platform
from collections.abc import Iterable, Sequence
from pathlib import Path

import llvmlite.binding as llvm

from bnserve_protocol import ManifestModel, ProcessorDescription, RunManifest, __version__
from bnserve_surrogate.kernel import kernel_bytes

_SOFTWARE = ("numpy", "llvmlite", "msgspec")
_CPUINFO = Path("/proc/cpuinfo")


def describe_run(
    models: Sequence[ManifestModel], limits: dict[str, int] | None = None, also: Iterable[str] = ()
) -> RunManifest:
    """The manifest of a run in this process.

    Parameters
    ----------
    models
        What is evaluated.
    limits
        Of the service, if there is one.
    also
        Distributions that take part besides this package's own.
    """
    return RunManifest(
        software=_software(tuple(also)),
        kernel=_kernel_digest(),
        processor=_processor(),
        platform=platform.platform(),
        models=list(models),
        limits=limits or {},
    ).sealed()


def _software(also: tuple[str, ...]) -> dict[str, str]:
    from importlib.metadata import version  # where it is needed: it takes a tenth of a second to import

    own = {
        "bnserve": __version__,
        "python": f"{platform.python_implementation()} {platform.python_version()}",
        "LLVM": ".".join(str(part) for part in llvm.llvm_version_info),
    }
    return own | {name: version(name) for name in (*_SOFTWARE, *also)}


@functools.cache
def _kernel_digest() -> str:
    return "sha256:" + hashlib.sha256(kernel_bytes()).hexdigest()


@functools.cache
def _processor() -> ProcessorDescription:
    features = llvm.get_host_cpu_features()
    return ProcessorDescription(
        name=_processor_name(),
        architecture=platform.machine(),
        target=llvm.get_host_cpu_name(),
        features=sorted(name for name, is_there in features.items() if is_there),
    )


def _processor_name() -> str:
    try:
        lines = _CPUINFO.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or "unknown"
