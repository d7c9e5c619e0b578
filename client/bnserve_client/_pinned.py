"""The first contact: which model it is that will answer, for the life of an object."""

from __future__ import annotations

from urllib.parse import quote

import msgspec

from bnserve_client._messages import Conversation, not_bnserve
from bnserve_client._session import Session
from bnserve_client._settings import Settings
from bnserve_protocol import DigestUnknown, Limits, ModelDescription, ModelIdentity, ModelUnknown, check_model_digest

_CONNECT_RETRIES = 3
"""At the first contact a wrong address is likelier than an outage, so it is reported soon."""


class Pinned(msgspec.Struct, frozen=True):
    """What connecting found out and what stays for the life of a model."""

    description: ModelDescription
    limits: Limits
    by_digest: bool = False
    """Whether every request names the digest, because the user did; the version otherwise."""

    @property
    def path(self) -> str:
        """Of the one artifact that answers."""
        named = self.description.digest if self.by_digest else self.description.version
        return model_path(self.description.name, named)

    @property
    def identity(self) -> ModelIdentity:
        """What every answer must say about its model."""
        return ModelIdentity(
            name=self.description.name, version=self.description.version, digest=self.description.digest
        )


def model_path(name: str, version: str) -> str:
    """The path of a version, label or digest of a model."""
    return f"/v1/models/{quote(name, safe='')}/versions/{quote(version, safe=':')}"


def _is_name(text: str) -> bool:
    return isinstance(text, str) and bool(text) and text.isprintable()


class _ModelDocument(ModelDescription, frozen=True, kw_only=True):
    """``GET /v1/models/{name}/versions/{version or label}``."""

    labels: dict[str, str]
    limits: Limits


def connecting(settings: Settings, name: str, version: str, digest: str | None = None) -> Conversation[Pinned]:
    """The first contact: find a model, turn a label into the version it stands for now, and learn the limits.

    Errors are those of :meth:`.Model.connect`.
    """
    if not (_is_name(name) and _is_name(version)):
        raise ModelUnknown("A model has a name and a version or label, such as 'default' and 'stable'.")
    if digest is not None:
        check_model_digest(digest)
    session = Session(settings.with_retries(_CONNECT_RETRIES if settings.retries is None else settings.retries))
    retries = session.retry_policy()
    found = yield from session.get(model_path(name, digest or version), _ModelDocument, retries)
    if digest is not None and found.digest == digest and version not in (found.version, *found.labels):
        raise DigestUnknown(f"The digest {digest} is that of '{name}' {found.version}, not of {version}.")
    right = found.version == found.labels.get(version, version) if digest is None else found.digest == digest
    if found.name != name or not right:
        raise not_bnserve(retries.address.text, f"asked for the model '{name}' {version}, it describes another")
    fields = {field: getattr(found, field) for field in ModelDescription.__struct_fields__}
    return Pinned(description=ModelDescription(**fields), limits=found.limits, by_digest=digest is not None)
