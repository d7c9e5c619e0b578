"""A model by the digest of its artifact, whatever its labels stand for now."""

from __future__ import annotations

from bnserve_protocol import ArtifactError, DigestUnknown, check_model_digest
from bnserve_store import ModelStore


def version_with_digest(store: ModelStore, name: str, version: str, digest: str) -> str:
    """The version of a model whose artifact has a digest.

    Parameters
    ----------
    store, name
        Where, and which model.
    version
        A label, which is not compared, or the version that it must be.
    digest
        ``"sha256:..."``.

    Raises
    ------
    DigestUnknown
        No version has it, or another one than ``version``.
    InvalidRequest, ModelUnknown, StoreUnknown
        The digest is none; there is no such model, or no such store.
    """
    check_model_digest(digest)
    versions = store.versions(name)
    candidates = versions if version in store.labels(name) else [each for each in versions if each == version]
    there = {each: found for each in candidates if (found := _digest(store, name, each)) is not None}
    for each, found in there.items():
        if found == digest:
            return each
    known = ", ".join(f"{each} ({found})" for each, found in there.items()) or f"versions {', '.join(versions)}"
    raise DigestUnknown(f"No artifact of '{name}' {version} in this store has the digest {digest}; there are: {known}.")


def _digest(store: ModelStore, name: str, version: str) -> str | None:
    """None for an artifact that must not be used: it is no reason not to use another."""
    try:
        return store.manifest(name, version).digest
    except ArtifactError:
        return None
