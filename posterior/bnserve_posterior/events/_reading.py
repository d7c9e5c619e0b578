"""Reading an event's configuration."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec

from bnserve_posterior.events._errors import EventInvalid
from bnserve_posterior.events._sections import FEWEST_PARTICLES, DataSection, DetectorSection, Event
from bnserve_protocol import check_table, read_table

_WHOLE = 1e-6
"""By how much an end of the band, in steps of the grid, may differ from a whole number; as for an analysis."""

_FILES = "strain", "asd", "psd", "psd_strain", "calibration"
"""Of a detector."""
_MOST_POINTS = 2.0**27
"""Of the full grid of a detector: two gigabytes of strain."""


def read_event(path: Path | str) -> Event:
    """Read a TOML file; files that it names are looked for beside it.

    Raises
    ------
    EventInvalid
        Not readable, not TOML, a key or value that the schema does not have (the nearest key is suggested), or values
        that do not go together.
    """
    event = parse_event(read_table(path, EventInvalid))
    return _beside(event, Path(path).resolve().parent)


def parse_event(table: dict[str, Any]) -> Event:
    """Check a configuration given as nested dictionaries; raises as :func:`read_event`."""
    event = check_table(table, Event, EventInvalid, "The event")
    problems = *_data_problems(event.data), *_other_problems(event), *_calibration_problems(event)
    problem = next(filter(None, problems), None)
    if problem:
        raise EventInvalid(f"The event is wrong: {problem}.")
    return event


def changed_event(
    event: Event, *, folder: Path | None = None, seed: int | None = None, particles: int | None = None
) -> Event:
    """The event with another folder for the results, or another seed or number of particles of the sampler.

    Raises
    ------
    EventInvalid
        A seed below zero, or too few particles.
    """
    if seed is not None:
        if seed < 0:
            raise EventInvalid(f"A seed is a whole number from 0 on; got {seed}.")
        event = msgspec.structs.replace(event, sampler=msgspec.structs.replace(event.sampler, seed=seed))
    if particles is not None:
        if particles < FEWEST_PARTICLES:
            raise EventInvalid(f"A population has {FEWEST_PARTICLES} particles or more; got {particles}.")
        event = msgspec.structs.replace(event, sampler=msgspec.structs.replace(event.sampler, particles=particles))
    if folder is not None:
        event = msgspec.structs.replace(event, output=msgspec.structs.replace(event.output, folder=str(folder)))
    return event


def _data_problems(data: DataSection) -> Iterator[str]:
    for name in ("trigger_time", "duration", "start_time", "f_min", "f_max", "roll_off"):
        value = getattr(data, name)
        if value is not None and not math.isfinite(value):
            yield f"[data] {name} must be a finite number, and is {value}"
    if not data.f_min < data.f_max:
        yield f"[data] f_max ({data.f_max:g} Hz) must be above f_min ({data.f_min:g} Hz)"
    for name, frequency in (("f_min", data.f_min), ("f_max", data.f_max)):
        steps = frequency * data.duration
        if abs(steps - round(steps)) > _WHOLE:
            yield f"[data] {name} ({frequency:g} Hz) must be a multiple of 1 / duration ({1.0 / data.duration:g} Hz)"
    if data.duration * data.f_max > _MOST_POINTS:
        yield f"[data] {data.duration:g} s up to {data.f_max:g} Hz are more points than {_MOST_POINTS:.3g}, gigabytes"
    if data.start_time is not None and not data.start_time < data.trigger_time < data.start_time + data.duration:
        yield "[data] trigger_time must lie inside the segment, start_time to start_time + duration"


def _other_problems(event: Event) -> Iterator[str]:
    label = event.output.label
    if label is not None and (not label or Path(label).name != label):
        yield f"[output] label is the beginning of a file's name; got '{label[:40]}'"
    injected = event.data.injection is not None
    for name, detector in event.detectors.items():
        if injected and detector.strain:
            yield f"[detectors.{name}] has strain and [data.injection] a signal; leave out one of the two"
        if not injected and not detector.strain:
            yield f"[detectors.{name}] needs 'strain', a file, or the event a section [data.injection]"
        if detector.asd and detector.psd:
            yield f"[detectors.{name}] has both asd and psd; leave out one of the two"
        if not (detector.asd or detector.psd or detector.strain or detector.psd_strain):
            yield f"[detectors.{name}] needs a noise curve, 'asd' or 'psd': there is no strain to estimate it from"
        if (detector.psd_start is None) != (detector.psd_duration is None):
            yield f"[detectors.{name}] psd_start and psd_duration belong together; give both or neither"
        if detector.site and detector.finite_arms:
            yield f"[detectors.{name}] has a site, whose arm_length counts if it is given; leave out finite_arms"
        for low, high in detector.notches:
            if not 0.0 <= low < high:
                yield f"[detectors.{name}] notches are pairs of increasing frequencies; one is {low:g}, {high:g}"


def _calibration_problems(event: Event) -> Iterator[str]:
    section = event.calibration
    named = [name for name, detector in event.detectors.items() if detector.calibration]
    if section is None:
        if named:
            yield (
                f"[detectors.{named[0]}] has a calibration, whose file does not say what it is multiplied with: give "
                'correction = "data" (as LIGO, Virgo and KAGRA publish them) or "template" in [calibration]'
            )
        return
    if not named:
        yield "[calibration] is there, and no detector has 'calibration', a file with its envelope"
    low, high = section.f_min or event.data.f_min, section.f_max or event.data.f_max
    if not low < high < math.inf:
        yield f"[calibration] has nodes from {low:g} to {high:g} Hz: the first must be below the second"


def _beside(event: Event, folder: Path) -> Event:
    """The event with the files that it names as they are to be opened."""

    def resolved(name: str | None) -> str | None:
        return str(folder / name) if name is not None and (folder / name).exists() else name

    def detector(given: DetectorSection) -> DetectorSection:
        files = {key: resolved(getattr(given, key)) for key in _FILES}
        return msgspec.structs.replace(given, **files)

    prior, likelihood = dict(event.prior), event.likelihood
    if isinstance(prior.get("file"), str):
        prior["file"] = str(resolved(str(prior["file"])))
    return msgspec.structs.replace(
        event,
        detectors={name: detector(given) for name, given in event.detectors.items()},
        likelihood=msgspec.structs.replace(likelihood, basis=resolved(likelihood.basis)),
        prior=prior,
    )
