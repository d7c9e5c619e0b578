"""What can be wrong with an event's configuration."""

from __future__ import annotations

from bnserve_protocol import BnserveError


class EventInvalid(BnserveError):
    """A configuration of an event that cannot be read, or makes no sense."""

    code = "event-invalid"
    title = "Event invalid"


class OutputExists(BnserveError):
    """The folder for the results holds those of another run, or of one that has not finished."""

    code = "output-exists"
    title = "Output exists"
