"""Certificates for tests: an authority of our own, and what it makes for this machine."""

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import trustme


@dataclass(frozen=True)
class Certificates:
    """An authority and the files of one server."""

    authority: trustme.CA
    folder: Path

    @property
    def trusted(self) -> Path:
        """The authority, for who shall trust it."""
        return self.folder / "authority.pem"

    @property
    def chain(self) -> Path:
        return self.folder / "server.pem"

    @property
    def key(self) -> Path:
        return self.folder / "server.key"

    @property
    def options(self) -> tuple[str, ...]:
        """Those of ``bnserve serve``."""
        return "--tls-cert", str(self.chain), "--tls-key", str(self.key)

    @property
    def settings(self) -> dict[str, Path]:
        return {"tls_cert": self.chain, "tls_key": self.key}

    def renew(self, *names: str, expires: datetime | None = None) -> None:
        """Write another certificate and its key, each in one step, as the programs do that renew them."""
        made = self.authority.issue_cert(*(names or ("localhost", "127.0.0.1")), not_after=expires)
        for path, content in (
            (self.key, made.private_key_pem.bytes()),
            (self.chain, b"".join(pem.bytes() for pem in made.cert_chain_pems)),
        ):
            fresh = path.with_suffix(".new")
            fresh.write_bytes(content)
            fresh.replace(path)


def certificates(folder: Path, *names: str) -> Certificates:
    """Certificates for ``localhost`` and 127.0.0.1, or for other names."""
    made = Certificates(trustme.CA(), folder)
    made.authority.cert_pem.write_to_path(str(made.trusted))
    made.renew(*names)
    return made
