"""Errors of building analyses that the vocabulary does not have."""

from __future__ import annotations

from bnserve_protocol import BnserveError


class DetectorsMissing(BnserveError):
    """The extra ``bnserve-inference[detectors]`` is not installed."""

    code = "detectors-missing"
    title = "Extra not installed"
