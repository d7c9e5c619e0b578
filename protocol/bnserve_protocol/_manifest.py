"""What a paper's appendix needs: the models, the programs and the processor that gave the numbers."""

from __future__ import annotations

import hashlib
from typing import Any

import msgspec


class ProcessorDescription(msgspec.Struct, frozen=True, kw_only=True):
    """The processor that the kernel's machine code was made for."""

    name: str
    """As it calls itself."""
    architecture: str
    target: str
    """As LLVM calls it, such as ``znver3``."""
    features: list[str]
    """Its instruction sets by LLVM's names, sorted."""


class ManifestModel(msgspec.Struct, frozen=True, kw_only=True):
    """One model; its digest names its every byte."""

    name: str
    version: str
    digest: str
    labels: list[str] = []
    """Those that stand for this version now; what they stand for later is not told by them."""


class RunManifest(msgspec.Struct, frozen=True, kw_only=True):
    """Everything the numbers of a run depend on: ``GET /v1/manifest`` and ``Model.manifest()``.

    Equal manifests have equal digests: nothing in one depends on the time, the load or the machine's name.
    """

    software: dict[str, str]
    """Versions by name: bnserve, python, numpy, LLVM and what else takes part."""
    kernel: str
    """The digest of the evaluation kernel before it is made machine code."""
    processor: ProcessorDescription
    platform: str
    models: list[ManifestModel]
    limits: dict[str, int] = {}
    """Of the service; empty for a local model."""
    digest: str = ""
    """SHA-256 of all the rest, as sorted JSON."""

    def sealed(self) -> RunManifest:
        """The same with its :attr:`digest`."""
        content: dict[str, Any] = msgspec.to_builtins(self)
        del content["digest"]
        text = msgspec.json.encode(content, order="deterministic")
        return msgspec.structs.replace(self, digest="sha256:" + hashlib.sha256(text).hexdigest())
