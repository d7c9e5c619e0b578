"""What is analysed, and how: the configuration of ``bnserve analyse``, a closed schema in TOML."""

from bnserve_posterior.events._errors import EventInvalid, OutputExists
from bnserve_posterior.events._reading import changed_event, parse_event, read_event
from bnserve_posterior.events._sections import (
    DataSection,
    DetectorSection,
    Event,
    InjectionSection,
    LikelihoodSection,
    ModelSection,
    OutputSection,
    SamplerSection,
)

__all__ = [
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
    "changed_event",
    "parse_event",
    "read_event",
]
