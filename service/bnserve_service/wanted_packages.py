"""Packages of extras that settings ask for."""

from __future__ import annotations

from bnserve_service.admission.issuers import Issuers
from bnserve_service.http.tracing import Tracing
from bnserve_service.settings import Settings


def check_packages(settings: Settings) -> list[str]:
    """Import what these settings need beside what every server does; the names of the settings that need something.

    Raises
    ------
    PackageMissing
        It is not installed.
    """
    found = []
    if settings.issuers:
        Issuers(settings.issuers)
        found.append("issuers")
    if Tracing.of(settings) is not None:
        found.append("otlp_endpoint")
    return found
