"""Places in the sky relative to the line between two detectors, and times of arrival at one: what data say directly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analyses import Analysis
from bnserve_protocol._batches import column_of_numbers
from bnserve_protocol._errors import FieldError, InvalidParameters, InvalidRequest
from bnserve_protocol._foreign import SAME
from bnserve_protocol._given import Table, as_columns

Floats = NDArray[np.float64]

_LIGHT_SPEED = 299792458.0
"""Metres per second."""
_ANGLES = ("zenith", "azimuth")
_TIMES = ("coalescence_time", "geocent_time")


class DetectorFrame:
    """Samples of an analysis by where they are relative to its detectors, as bilby's ``reference_frame="H1L1"`` and
    ``time_reference="H1"`` mean it.

    ``zenith`` and ``azimuth`` (radians) are spherical coordinates about the line from the second detector of the pair
    to the first, ``H1_time`` the GPS seconds of the merger's arrival at H1.

    Parameters
    ----------
    analysis
        Whose detectors and times they are.
    reference_frame
        ``"sky"``, or two of its detectors: ``"H1L1"`` or ``("H1", "L1")``.
    time_reference
        ``"geocenter"``, or one of its detectors.

    Raises
    ------
    InvalidRequest
        A detector that the analysis has not, one place for both, or times that are not the merger's.
    """

    def __init__(
        self, analysis: Analysis, *, reference_frame: str | Sequence[str] = "sky", time_reference: str = "geocenter"
    ) -> None:
        self._settings = analysis.settings
        self._rotation = None
        if reference_frame != "sky":
            first, second = (_location(analysis, name) for name in _pair(reference_frame))
            self._rotation = _rotation(first - second)
        self._place, self._time_name = None, "geocent_time"
        if "geocent" not in time_reference:
            self._place, self._time_name = _location(analysis, time_reference), f"{time_reference}_time"
        if self._settings.alignment != "merger":
            raise InvalidRequest(
                "Times of arrival are those of the merger: make the analysis with alignment='merger' for this frame."
            )

    def to_sky(self, samples: Mapping[str, Any] | Table) -> dict[str, Any]:
        """The samples with ``right_ascension``, ``declination`` and ``coalescence_time`` in place of what is relative.

        Parameters
        ----------
        samples
            Numbers and vectors ``(N,)`` by name: a mapping or a table. What else there is stays; names of a place or
            time that are not those of this frame do, too.

        Raises
        ------
        InvalidParameters
            One of the angles without the other or without a time, or two statements of one place or time.
        """
        named, ours = _named(samples), dict[str, Any]()
        from_trigger = self._from_trigger(named)
        angles = [name for name in _ANGLES if name in named]
        if self._rotation is not None and angles:
            if len(angles) == 1 or from_trigger is None or {"right_ascension", "declination"} & named.keys():
                raise _refusal(
                    "zenith", f"A place relative to detectors is 'zenith' and 'azimuth' with '{self._time_name}', and "
                    "without another statement of it.",
                )  # fmt: skip
            zenith, azimuth = (column_of_numbers(name, named.pop(name), "rad") for name in _ANGLES)
            sidereal = self._sidereal(from_trigger)
            ours["right_ascension"], ours["declination"] = _on_the_sky(self._rotation, zenith, azimuth, sidereal)
        if from_trigger is not None:
            place = self._place_of(named | ours) if self._place is not None and self._time_name in named else None
            if place is not None:
                from_trigger = from_trigger - self._delay(*place, from_trigger)
            for name in (*_TIMES, self._time_name):
                named.pop(name, None)
            ours["coalescence_time"] = from_trigger
        return named | ours

    def from_sky(self, samples: Mapping[str, Any] | Table) -> dict[str, Any]:
        """The reverse of :meth:`to_sky`, of samples with a place and a time: for starting points and injections."""
        named = _named(samples)
        geocentric = self._coalescence(named)
        if geocentric is None:
            raise _refusal("coalescence_time", "A frame of detectors needs 'coalescence_time' or 'geocent_time'.")
        place = self._place_of(named)
        arrival = geocentric
        if self._place is not None:
            for _ in range(4):  # the Earth turns by 1e-6 rad while the wave crosses it
                arrival = geocentric + self._delay(*place, arrival)
        for name in _TIMES:
            named.pop(name, None)
        ours: dict[str, Any] = {self._time_name: arrival + self._settings.trigger_time}
        if self._rotation is not None:
            right_ascension, declination = (named.pop(name) for name in ("right_ascension", "declination"))
            direction = _direction(self._sidereal(arrival) - right_ascension, declination)
            x, y, z = (sum(self._rotation[i][j] * direction[i] for i in range(3)) for j in range(3))
            ours["zenith"] = np.arccos(np.clip(z, -1.0, 1.0))
            ours["azimuth"] = np.arctan2(y, x) % (2.0 * np.pi)
        return named | ours

    def _from_trigger(self, named: Mapping[str, Any]) -> Floats | None:
        """The time of this frame in seconds from the trigger; None where there is none."""
        if self._place is None or self._time_name not in named:
            return self._coalescence(named)
        if any(name in named for name in _TIMES):
            raise _refusal(self._time_name, f"'{self._time_name}' states the time: leave the other time out.")
        return column_of_numbers(self._time_name, named[self._time_name], "s") - self._settings.trigger_time

    def _coalescence(self, named: Mapping[str, Any]) -> Floats | None:
        if "geocent_time" in named:
            return column_of_numbers("geocent_time", named["geocent_time"], "s") - self._settings.trigger_time
        if "coalescence_time" in named:
            return column_of_numbers("coalescence_time", named["coalescence_time"], "s")
        return None

    def _place_of(self, named: Mapping[str, Any]) -> tuple[Floats, Floats]:
        for name in ("right_ascension", "declination"):
            if name not in named:
                raise _refusal(name, f"'{name}' is missing: a time of arrival is that of a place in the sky.")
        return (
            column_of_numbers("right_ascension", named["right_ascension"], "rad"),
            column_of_numbers("declination", named["declination"], "rad"),
        )

    def _sidereal(self, from_trigger: Floats) -> Floats:
        return np.asarray(self._settings.sidereal_time + self._settings.sidereal_rate * from_trigger)

    def _delay(self, right_ascension: Floats, declination: Floats, from_trigger: Floats) -> Floats:
        """Seconds by which the reference detector is reached later than the centre of the Earth."""
        assert self._place is not None
        direction = _direction(self._sidereal(from_trigger) - right_ascension, declination)
        return np.asarray(-sum(one * at for one, at in zip(direction, self._place, strict=True)) / _LIGHT_SPEED)


def _named(samples: Mapping[str, Any] | Table) -> dict[str, Any]:
    columns = as_columns(samples)
    if columns is None:
        raise InvalidParameters(f"Samples are a mapping or a table of columns by name; got {type(samples).__name__}.")
    return {SAME.get(name, name): value for name, value in columns.items()}


def _pair(frame: str | Sequence[str]) -> tuple[str, str]:
    names = (frame[:2], frame[2:]) if isinstance(frame, str) else tuple(frame)
    if len(names) != 2 or names[0] == names[1]:
        raise InvalidRequest(f"A reference frame is 'sky' or two detectors, such as 'H1L1'; got {str(frame)[:40]!r}.")
    return names[0], names[1]


def _location(analysis: Analysis, name: str) -> Floats:
    if name not in analysis.settings.detectors:
        raise InvalidRequest(
            f"The analysis has no detector {name[:32]!r} that a frame could refer to; it has "
            f"{', '.join(analysis.settings.detectors)}.",
            errors=[FieldError(reason="not a detector of the analysis", parameter="reference_frame", value=name[:32])],
        )
    return np.asarray(analysis.arrays[f"location/{name}"])


def _rotation(line: Floats) -> list[list[float]]:
    """What turns the z axis onto a line while azimuths keep their origin: turns about z, y and z, as bilby's."""
    length = float(np.sqrt(line @ line))
    if length == 0.0:
        raise InvalidRequest("The two detectors of the frame are at one place: choose another pair.")
    c = float(line[2]) / length
    s = float(np.sqrt(max(0.0, 1.0 - c * c)))
    first, last = np.arctan2(-line[1] * c, line[0]), np.arctan2(line[1], line[0])
    ca, sa, cg, sg = (float(f(angle)) for angle in (first, last) for f in (np.cos, np.sin))
    return [
        [ca * c * cg - sa * sg, -sa * c * cg - ca * sg, s * cg],
        [ca * c * sg + sa * cg, -sa * c * sg + ca * cg, s * sg],
        [-ca * s, sa * s, c],
    ]


def _on_the_sky(
    rotation: list[list[float]], zenith: Floats, azimuth: Floats, sidereal: Floats
) -> tuple[Floats, Floats]:
    """Right ascension within [0, 2 pi) and declination."""
    local = np.sin(zenith) * np.cos(azimuth), np.sin(zenith) * np.sin(azimuth), np.cos(zenith)
    x, y, z = (sum(row[j] * local[j] for j in range(3)) for row in rotation)
    return (np.arctan2(y, x) + sidereal) % (2.0 * np.pi), np.arcsin(np.clip(z, -1.0, 1.0))


def _direction(hour_angle: Floats, declination: Floats) -> tuple[Floats, Floats, Floats]:
    """The unit vector to a source in the Earth's frame."""
    cosine = np.cos(declination)
    return cosine * np.cos(hour_angle), -cosine * np.sin(hour_angle), np.sin(declination)


def _refusal(name: str, sentence: str) -> InvalidParameters:
    return InvalidParameters(sentence, errors=[FieldError(reason=sentence, parameter=name[:80])])
