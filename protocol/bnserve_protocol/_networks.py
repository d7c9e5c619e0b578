"""A network of detectors with their noise on the wire, for forecasts: named by the digest of the bytes that travel.

It is read here and judged by who evaluates it: names of detectors and curves are those that it knows.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any, Protocol, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_checks import check_detector_names
from bnserve_protocol._errors import AnalysisInvalid, FieldError, UndecodableBody
from bnserve_protocol._modes import Mode
from bnserve_protocol.wire._arrays import decode_real, is_array, raw_array
from bnserve_protocol.wire._envelope import (
    JSON,
    MSGPACK,
    UNREADABLE,
    read_maps,
    refuse_repeated_keys,
    undecodable,
)

Floats = NDArray[np.float64]
Vector: TypeAlias = tuple[float, float, float]

MOST_DETECTORS = 16
"""Of a network, as of an analysis."""
_MOST_PLAIN_BYTES = 2**20
"""Of numbers that do not travel as an array: decoded one by one they take up to sixty times as much."""


class DescribesNetwork(Protocol):
    """Whatever forecasts may be asked for: a :class:`DetectorNetwork` or a ``bnserve_inference.fisher.Network``."""

    @property
    def description(self) -> DetectorNetwork:
        """What travels."""


@dataclass(frozen=True, eq=False)
class NetworkDetector:
    """A detector of a network, with its noise.

    Parameters
    ----------
    name
        Of one that ``bnserve_inference.Detector.named`` knows, unless a response and a location are given.
    noise
        The name of a curve that ``bnserve_inference.fisher.NoiseCurve.named`` knows, or frequencies in Hz and an ASD in
        1/sqrt(Hz), ``(n,)`` each.
    response, location, arms
        ``(3, 3)``, ``(3,)`` in metres and, where their length counts, ``(2, 3)`` in metres; as a ``Detector`` has them.
    """

    name: str
    noise: str | tuple[Floats, Floats]
    response: Floats | None = None
    location: Floats | None = None
    arms: Floats | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.noise, str):
            frequencies, asd = (np.asarray(values, dtype=np.float64) for values in self.noise)
            object.__setattr__(self, "noise", (frequencies, asd))


_BANDS, _NARROWEST = (1e-6, 1e6), 1e-6
"""Hz; and of f_min, so that nodes have room."""


def check_band(f_min: float, f_max: float) -> None:
    """Refuse what is no band of a network: AnalysisInvalid."""
    least, most = _BANDS
    if not least <= f_min < f_max <= most or f_max < (1.0 + _NARROWEST) * f_min:
        raise AnalysisInvalid(
            f"The band of a network is 0 < f_min < f_max, from {least:g} to {most:g} Hz and not narrower than a "
            f"millionth of f_min; got {f_min!r} and {f_max!r} Hz.",
            errors=[FieldError(reason="no band", parameter="f_min", value=f_min)],
        )


@dataclass(frozen=True, eq=False)
class DetectorNetwork:
    """A network as it travels; ``bnserve_inference.fisher.Network`` is what becomes of it where it is evaluated.

    Parameters
    ----------
    detectors
        With their noise.
    f_min, f_max
        Hz; the band of the integrals.
    trigger_time
        GPS seconds that ``coalescence_time`` is relative to.
    moving
        Whether the Earth turns them while the signal lasts.

    Raises
    ------
    AnalysisInvalid
        More detectors than a network has, none, or one twice; or no band.
    """

    detectors: Sequence[NetworkDetector]
    f_min: float
    f_max: float
    trigger_time: float
    moving: bool = True

    def __post_init__(self) -> None:
        if not 1 <= len(self.detectors) <= MOST_DETECTORS:
            raise AnalysisInvalid(
                f"A network has 1 to {MOST_DETECTORS} detectors; got {len(self.detectors)}.",
                errors=[FieldError(reason="too many or none", parameter="detectors")],
            )
        check_detector_names([detector.name for detector in self.detectors])
        check_band(self.f_min, self.f_max)

    @property
    def description(self) -> DetectorNetwork:
        """Itself."""
        return self

    @cached_property
    def body(self) -> bytes:
        """What travels: a MessagePack map."""
        fields = _NetworkBody(
            detectors=[_to_wire(detector) for detector in self.detectors], f_min=float(self.f_min),
            f_max=float(self.f_max), trigger_time=float(self.trigger_time), moving=bool(self.moving),
        )  # fmt: skip
        return msgspec.msgpack.encode(fields)

    @cached_property
    def digest(self) -> str:
        """``sha256:...`` of :attr:`body`, which it is uploaded under."""
        return f"sha256:{hashlib.sha256(self.body).hexdigest()}"


class _Curve(msgspec.Struct, forbid_unknown_fields=True):
    frequencies: msgspec.Raw
    asd: msgspec.Raw


class _DetectorBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    name: Annotated[str, msgspec.Meta(pattern="^[A-Za-z0-9_-]{1,32}$")]
    noise: Annotated[str, msgspec.Meta(max_length=32)] | _Curve
    response: tuple[Vector, Vector, Vector] | None = None
    location: Vector | None = None
    arms: tuple[Vector, Vector] | None = None


class _NetworkBody(msgspec.Struct, forbid_unknown_fields=True):
    detectors: Annotated[list[_DetectorBody], msgspec.Meta(min_length=1, max_length=MOST_DETECTORS)]
    f_min: float
    f_max: float
    trigger_time: float
    moving: bool = True


def _to_wire(detector: NetworkDetector) -> _DetectorBody:
    noise = detector.noise if isinstance(detector.noise, str) else _Curve(*map(_raw, detector.noise))
    places = (detector.response, detector.location, detector.arms)
    return _DetectorBody(detector.name, noise, *(None if it is None else _nested(it) for it in places))


def _raw(values: Floats) -> msgspec.Raw:
    return raw_array(np.asarray(values, dtype=np.float64))


def _nested(array: Floats) -> Any:
    values = np.asarray(array, dtype=np.float64).tolist()
    return tuple(tuple(it) if isinstance(it, list) else it for it in values)


_DECODERS: dict[str, Any] = {
    MSGPACK: (msgspec.msgpack.Decoder(_NetworkBody), msgspec.msgpack.Decoder(list[float])),
    JSON: (msgspec.json.Decoder(_NetworkBody), msgspec.json.Decoder(list[float])),
}


_BEGINS_JSON = (b"{", b" ", b"\t", b"\r", b"\n")


def decode_network(body: bytes | memoryview) -> DetectorNetwork:
    """Read a network, which is MessagePack or JSON: no map of the one begins as an object of the other does.

    Raises
    ------
    UndecodableBody
        Not such a message.
    """
    media_type = JSON if bytes(body[:1]) in _BEGINS_JSON else MSGPACK
    whole, numbers = _DECODERS[media_type]
    try:
        wire: _NetworkBody = whole.decode(body)
        detectors = [_from_wire(detector, numbers) for detector in wire.detectors]
        if media_type == JSON:
            refuse_repeated_keys(body)
        else:
            _refuse_twice(body)
    except UNREADABLE as error:
        raise undecodable(error, media_type, "network", body) from error
    return DetectorNetwork(detectors, wire.f_min, wire.f_max, wire.trigger_time, wire.moving)


_outer = msgspec.msgpack.Decoder(list[msgspec.Raw])


def _refuse_twice(body: bytes | memoryview) -> None:
    """Refuse keys that are there twice in the maps of a MessagePack message."""
    fields = msgspec.msgpack.decode(body, type=dict[str, msgspec.Raw])
    read_maps(body)
    for detector in _outer.decode(fields["detectors"]):
        read_maps(detector)


def _from_wire(detector: _DetectorBody, numbers: Any) -> NetworkDetector:
    noise = detector.noise
    if not isinstance(noise, str):
        curve = (_vector(noise.frequencies, numbers), _vector(noise.asd, numbers))
    places = (detector.response, detector.location, detector.arms)
    arrays = (None if it is None else np.array(it, dtype=np.float64) for it in places)
    return NetworkDetector(detector.name, noise if isinstance(noise, str) else curve, *arrays)


def _vector(raw: msgspec.Raw, numbers: Any) -> Floats:
    if is_array(raw):
        return decode_real(raw)
    if memoryview(raw).nbytes > _MOST_PLAIN_BYTES:
        raise UndecodableBody("Curves of so many numbers travel as MessagePack arrays.")
    return np.array(numbers.decode(raw), dtype=np.float64)


_POINTS = (40.0, 140.0)
"""Nodes of the integrals over an e-fold of frequency, with one noise curve: of one order of modes, and of several."""
_WAVEFORM, _FURTHER_MODE, _SIGNAL = 60, 8, 11
"""Work at a node, in samples: of the (2, 2) with its derivatives and all that is done once, of every mode beside it,
and of the signal of one order of modes in a detector (``python -m benchmarks.fisher``)."""
_WITHOUT = 2.5
"""Times as much as the signal-to-noise ratio alone."""


def forecast_work(network: DetectorNetwork, modes: Sequence[Mode], *, derivatives: bool = True) -> int:
    """About what the forecast of one binary costs, in samples, the unit of :attr:`.Limits.max_samples`; or, without
    ``derivatives``, its signal-to-noise ratio alone."""
    count, orders = len(modes), len({order for _, order in modes})
    curves = len({it.noise if isinstance(it.noise, str) else it.noise[1].tobytes() for it in network.detectors})
    points = _POINTS[orders > 1] * max(1.0, math.log(network.f_max / network.f_min))
    waveforms = curves * (_WAVEFORM + (count - 1) * _FURTHER_MODE)
    work = points * (waveforms + _SIGNAL * len(network.detectors) * orders)
    return int(work if derivatives else work / _WITHOUT)
