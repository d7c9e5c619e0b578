"""Whether what is said to a server goes unseen, and until when its certificate counts."""

from __future__ import annotations

import ssl
import time
from ipaddress import ip_address

from bnserve_service.bench.load import Target
from bnserve_service.doctor.findings import Findings, fault, ok, warning
from bnserve_service.process.certificate import Certificate
from bnserve_service.settings import Settings

SOON_SECONDS = 14 * 86_400.0
"""Programs that renew certificates do so weeks before their end: one with less left is not renewed."""


def certificate_files(settings: Settings) -> Findings:
    """Those of the settings belong together."""
    if Certificate.of(settings) is not None:  # or it says why not
        yield ok("certificate", f"{settings.tls_cert} and its key belong together")


def on_the_way(url: str, target: Target) -> Findings:
    """Nobody between here and the server reads what is said.

    Parameters
    ----------
    url
        As it was given.
    target
        The same, understood.
    """
    if target.tls:
        yield from _certificate(url, target)
    elif target.token is not None and not isinstance(target.address, str) and not _is_loopback(target.address[0]):
        yield warning("encryption", f"the token travels to {url} in clear", "have the server, or a proxy in front of "
                      "it, speak TLS (bnserve serve --tls-cert), and use https://")  # fmt: skip


def _certificate(url: str, target: Target) -> Findings:
    try:
        with target.connect() as connection:
            assert isinstance(connection, ssl.SSLSocket), "the address is of https"
            version, shown = connection.version(), connection.getpeercert() or {}
    except ssl.SSLCertVerificationError as error:
        yield fault("certificate", f"that of {url} is not trusted here: {error.verify_message}",
                    "name the file of its authority in SSL_CERT_FILE; one that does not go by this name, or has ended, "
                    "has to be made anew by whoever runs the server")  # fmt: skip
        return
    except ssl.SSLError as error:
        yield fault("certificate", f"{url} speaks no TLS: {error.reason}", "it may be http://")
        return
    except OSError:  # nobody is there, which is said next
        return
    left = ssl.cert_time_to_seconds(str(shown["notAfter"])) - time.time()
    says = f"{version}, trusted, for {left / 86_400.0:.0f} more days"
    if left < SOON_SECONDS:
        yield warning("certificate", says, "see that it is renewed: the server takes the new one from its file")
    else:
        yield ok("certificate", says)


def _is_loopback(host: str) -> bool:
    try:
        return ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return host == "localhost" or host.endswith(".localhost")
