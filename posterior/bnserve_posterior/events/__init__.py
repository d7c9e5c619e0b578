"""What is analysed, and how: the configuration of ``bnserve analyse``, a closed schema in TOML."""

from bnserve_posterior.events._errors import EventInvalid, OutputExists
from bnserve_posterior.events._reading import changed_event, parse_event, read_event
from bnserve_posterior.events._sections import (
    CalibrationSection,
    DataSection,
    DetectorSection,
    Event,
    InjectionSection,
    LikelihoodSection,
    ModelSection,
    OutputSection,
    SamplerSection,
    SiteSection,
)

__all__ = [
    "CalibrationSection",
    "DataSection",
    "DetectorSection",
    "Event",
    "EventInvalid",
    "InjectionSection",
    "LikelihoodSection",
    "ModelSection",
    "OutputExists",
    "OutputSection",
    "SamplerSection",
    "SiteSection",
    "changed_event",
    "parse_event",
    "read_event",
]
