"""A data analysis on the wire: everything that a server needs to evaluate its likelihood, named by its own digest.

All kinds have one form. The model is evaluated on nodes; in every detector the strain at the nodes meets *linear
weights* (complex; they may depend on the time of arrival) and *quadratic weights* (real)::

    <d|h> = sum_j w_j(t) h(f_j) exp(-2 pi i f_j t),    <h|h> = sum_m q_m |h(f_m)|^2

For ``"full"`` the nodes are the whole grid of the data, for ``"roq"`` the empirical interpolation nodes of a basis,
for ``"relative_binning"`` the edges of bins around a fiducial waveform. ``docs/explanations/likelihoods.md`` has the
formulas.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Annotated, Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_checks import check_arrays, check_settings
from bnserve_protocol._analysis_settings import AnalysisSettings, canonical, encode_settings, time_steps, with_step
from bnserve_protocol._errors import AnalysisInvalid, FieldError, InvalidRequest
from bnserve_protocol._given import NotNumbers, as_numbers
from bnserve_protocol._model import ModelDescription, ModelIdentity
from bnserve_protocol.wire._arrays import decode_array, encode_array
from bnserve_protocol.wire._envelope import MSGPACK, UNREADABLE, read_map, read_maps, undecodable


@dataclass(frozen=True, slots=True)
class Analysis:
    """Settings and arrays of one analysis; immutable, and named by the digest of its canonical encoding.

    Parameters
    ----------
    settings
        All that is not an array.
    arrays
        By name; copied unless they are read-only, C-contiguous float64 or complex128. For every
        detector ``X``: ``response/X`` float64 ``(3, 3)`` and ``location/X`` float64 ``(3,)`` in metres (Earth-fixed
        frame), ``linear_weights/X`` complex128 ``(T, L)`` and ``quadratic_weights/X`` float64 ``(Q,)``. For ``"roq"``
        and ``"relative_binning"`` also ``linear_nodes`` ``(L,)`` and ``quadratic_nodes`` ``(Q,)``, increasing, in Hz;
        for ``"full"`` both are :attr:`AnalysisSettings.grid`. T is 1 without a time grid, and at least 6 with one.
        Relative binning with modes of G > 1 orders m has linear weights ``(T, G L)``, those of the lowest order first,
        and, for the G (G + 1) / 2 pairs of orders (0, 0), (0, 1), ..., (1, 1), ..., complex128 quadratic weights
        ``(P, Q)`` of conj(h) h'; with several modes, linear and quadratic nodes are the same.
        With ``response="moving"`` relative binning also has, of each order of modes, ``(G, L)``, the phases (radians)
        of the waveform that the bins were made around, ``reference_phases``, and when it passes the nodes,
        ``reference_times`` (seconds from ``coalescence_time``); linear and quadratic nodes are the same then. A
        detector may have ``arms/X`` ``(2, 3)``, the vectors of its arms in metres in the Earth-fixed frame, which then
        make its response; without, its arms are short.
    static_error
        By how much ln L of detectors that stand still may be wrong, where the builder looked; None where it did not.
        Whoever builds an analysis is told; it is no part of the analysis, and does not travel.

    Raises
    ------
    AnalysisInvalid
        Settings or arrays that contradict each other or hold values that cannot be.
    """

    settings: AnalysisSettings
    arrays: Mapping[str, NDArray[Any]]
    static_error: float | None = field(default=None, repr=False, compare=False)
    digest: str = field(init=False)
    samples: int = field(init=False, repr=False, compare=False)
    """Work of one log-likelihood, see :func:`likelihood_samples`."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "settings", canonical(self.settings))
        check_settings(self.settings)
        object.__setattr__(self, "settings", with_step(self.settings))
        arrays = {name: _frozen_array(name, self.arrays[name]) for name in sorted(self.arrays)}
        check_arrays(self.settings, arrays)
        object.__setattr__(self, "arrays", MappingProxyType(arrays))
        digest = hashlib.sha256()
        for part in encode_analysis(self):
            digest.update(part)
        object.__setattr__(self, "digest", f"sha256:{digest.hexdigest()}")
        object.__setattr__(self, "samples", _samples(self))

    def __reduce__(self) -> tuple[Any, ...]:
        return Analysis, (self.settings, dict(self.arrays), self.static_error)

    @property
    def nbytes(self) -> int:
        """Memory of the arrays in bytes."""
        return sum(array.nbytes for array in self.arrays.values())

    @property
    def linear_nodes(self) -> NDArray[np.float64]:
        """Frequencies of the linear weights in Hz, ``(L,)``."""
        return self._nodes("linear_nodes")

    @property
    def quadratic_nodes(self) -> NDArray[np.float64]:
        """Frequencies of the quadratic weights in Hz, ``(Q,)``."""
        return self._nodes("quadratic_nodes")

    def _nodes(self, name: str) -> NDArray[np.float64]:
        return self.settings.grid.frequencies() if self.settings.kind == "full" else self.arrays[name]


_ARRAY_UNITS = {
    "response": "1", "location": "m", "arms": "m", "linear_nodes": "Hz", "quadratic_nodes": "Hz",
    "reference_phases": "rad", "reference_times": "s",
}  # fmt: skip
"""Of the arrays of an analysis that may be given with one; weights are made by us, without."""


def _frozen_array(name: str, value: NDArray[Any]) -> NDArray[Any]:
    try:
        array = as_numbers(value, _ARRAY_UNITS.get(name.split("/")[0]))
    except NotNumbers as error:
        raise AnalysisInvalid(
            f"Array '{name[:80]}' of the analysis must hold numbers; it {error}.",
            errors=[FieldError(reason=f"not numbers: it {error}", parameter=name[:80])],
        ) from error
    dtype = "<c16" if array.dtype.kind == "c" else "<f8"
    frozen = np.require(array, dtype, ("C", "A"))  # aligned, because numpy sums what is not in other, slower ways
    if frozen.flags.writeable:
        frozen = frozen.copy()
        frozen.flags.writeable = False
    return frozen


class _WireAnalysis(msgspec.Struct, forbid_unknown_fields=True):
    settings: AnalysisSettings
    arrays: Annotated[dict[str, msgspec.Raw], msgspec.Meta(max_length=128)]
    """Bounded, as all lengths here, before decoding: a body of nothing but entries would take fifty times its size."""


_decoder = msgspec.msgpack.Decoder(_WireAnalysis)


def encode_analysis(analysis: Analysis) -> list[bytes | memoryview]:
    """Write an analysis as a list of buffers; array memory is not copied.

    Joined, they are the MessagePack map ``{settings: {...}, arrays: {name: array}}`` in canonical form: names sorted,
    arrays as msgpack-numpy writes them. The digest of an analysis is the SHA-256 of these bytes.
    """
    head = b"\x82" + msgspec.msgpack.encode("settings") + encode_settings(analysis.settings)
    parts: list[bytes | memoryview] = [head + msgspec.msgpack.encode("arrays") + _map_header(len(analysis.arrays))]
    for name in sorted(analysis.arrays):
        header, data = encode_array(analysis.arrays[name], keys="bytes")
        parts += [msgspec.msgpack.encode(name) + bytes(header), data]
    return parts


def _map_header(entries: int) -> bytes:
    return bytes([0x80 + entries]) if entries < 16 else b"\xde" + entries.to_bytes(2, "big")


def decode_analysis(body: bytes | memoryview) -> Analysis:
    """Read an analysis; its arrays are read-only, and views of ``body`` where they are aligned there.

    Raises
    ------
    UndecodableBody
        Not such a message.
    AnalysisInvalid
        Settings or arrays that no likelihood could be evaluated with.
    """
    try:
        wire = _decoder.decode(body)
        fields = read_map(body)
        read_maps(fields["settings"])
        read_map(fields["arrays"])
    except UNREADABLE as error:
        raise undecodable(error, MSGPACK, "analysis") from error
    return Analysis(settings=wire.settings, arrays={name: _decode(name, raw) for name, raw in wire.arrays.items()})


def _decode(name: str, raw: msgspec.Raw) -> NDArray[Any]:
    array = decode_array(raw)
    if array.dtype.str not in ("<f8", "<c16"):
        raise AnalysisInvalid(f"Array '{name}' of the analysis travels as <f8 or <c16; got {array.dtype.str}.")
    return array


def check_model_of(analysis: Analysis, model: ModelIdentity | ModelDescription) -> None:
    """Refuse to evaluate an analysis with another model than the one it is made for, if it is made for one.

    Raises
    ------
    AnalysisInvalid
        It is made for another model, or for modes that the description of this one lacks.
    InvalidRequest
        It is no analysis at all.
    """
    if not isinstance(analysis, Analysis):
        raise InvalidRequest(
            f"A likelihood is that of an Analysis; got {type(analysis).__name__}. full_analysis, roq_analysis and "
            "relative_binning_analysis of bnserve_inference build one."
        )
    wanted, modes = analysis.settings.model_digest, analysis.settings.modes
    if wanted not in (None, model.digest):
        raise AnalysisInvalid(
            f"The analysis was made for the model {wanted}, and this is {model.name} {model.version} ({model.digest}). "
            "Use that model, or build the analysis again for this one.",
            errors=[FieldError(reason="made for another model", parameter="model_digest", value=model.digest)],
        )
    if isinstance(model, ModelIdentity) or isinstance(modes, msgspec.UnsetType):
        return
    there = {tuple(mode) for mode in model.modes}
    if missing := [mode for mode in modes if mode not in there]:
        raise AnalysisInvalid(
            f"The analysis is of modes that {model.name} {model.version} lacks: {', '.join(map(str, missing))}. The "
            f"model has {', '.join(map(str, sorted(there)))}; use another one, or build the analysis for these.",
            errors=[FieldError(reason="not a mode of the model", parameter="modes", value=str(missing[0]))],
        )


def likelihood_nodes(analysis: Analysis) -> int:
    """Frequencies at which the model is evaluated for one log-likelihood."""
    if analysis.settings.kind == "full":
        return len(analysis.settings.grid)
    return len(analysis.linear_nodes) + len(analysis.quadratic_nodes)


def likelihood_samples(analysis: Analysis) -> int:
    """Work of one log-likelihood in samples, the unit of :attr:`Limits.max_samples`.

    A sample is one frequency of one mode of one waveform. In every detector each node costs about as much again, and a
    sum over coalescence times as much as its times in every detector; a response that moves costs as much again. An
    analysis that does not name its modes counts as of one.
    """
    return analysis.samples


def _samples(analysis: Analysis) -> int:
    detectors = len(analysis.settings.detectors)
    times = 0 if analysis.settings.time_marginalisation is None else time_steps(analysis.settings)[0] + 1
    modes = 1 if isinstance(analysis.settings.modes, msgspec.UnsetType) else len(analysis.settings.modes)
    each = 2 * detectors if analysis.settings.moves else detectors
    return likelihood_nodes(analysis) * modes * (1 + each) + detectors * times
