"""Schemas of bodies, from the structures that read and write them, and descriptions from their docstrings; written here
is only what the types do not know: the forms in which arrays travel.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable
from typing import Any

import msgspec

from bnserve_protocol import (
    DRAWN_NAMES,
    IN_PLANE_NAMES,
    LIKELIHOOD_NAMES,
    MOST_DETECTORS,
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    EvaluationOptions,
    ForecastOptions,
    LikelihoodParameters,
    ParametersWithExtrinsic,
    RunManifest,
)
from bnserve_protocol.wire import (
    ForecastAnswerBody,
    ForecastBody,
    LikelihoodAnswerBody,
    LikelihoodBody,
    Problem,
    WaveformBody,
)
from bnserve_service.evaluation.umbridge_bodies import (
    UmBridgeApplyJacobianAnswer,
    UmBridgeApplyJacobianRequest,
    UmBridgeConfig,
    UmBridgeEvaluateAnswer,
    UmBridgeEvaluateRequest,
    UmBridgeGradientAnswer,
    UmBridgeGradientRequest,
    UmBridgeInfo,
    UmBridgeInputSizes,
    UmBridgeModelInfo,
    UmBridgeModelRequest,
    UmBridgeOutputSizes,
    UmBridgeProblem,
)
from bnserve_service.reference.documents import (
    AnalysisDocument,
    GridDocument,
    ModelDocument,
    ModelList,
    NetworkDocument,
    ReloadDocument,
)
from bnserve_service.settings import ServiceLimits

_REF = "#/components/schemas/{name}"
_STRUCTS = [
    Problem, ModelDocument, ModelList, GridDocument, AnalysisDocument, NetworkDocument, ServiceLimits, RunManifest,
    ReloadDocument,
    UmBridgeApplyJacobianAnswer, UmBridgeEvaluateAnswer, UmBridgeGradientAnswer, UmBridgeInfo, UmBridgeInputSizes,
    UmBridgeModelInfo, UmBridgeOutputSizes, UmBridgeProblem,
]  # fmt: skip

_UMBRIDGE: tuple[type[msgspec.Struct], ...] = (
    UmBridgeConfig, UmBridgeModelRequest, UmBridgeEvaluateRequest, UmBridgeGradientRequest,
    UmBridgeApplyJacobianRequest,
)  # fmt: skip
"""Whose fields their docstrings describe."""


def reference(name: str) -> dict[str, Any]:
    """A reference to the schema of that name."""
    return {"$ref": _REF.format(name=name)}


def _array_or(*forms: dict[str, Any]) -> dict[str, Any]:
    return {"oneOf": [*forms, reference("Array")]}


def _list(items: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": items}


def _object(properties: dict[str, Any], optional: Iterable[str] = ()) -> dict[str, Any]:
    required = [name for name in properties if name not in optional]
    return {"type": "object", "additionalProperties": False, "properties": properties, "required": required}


_NUMBERS = _list({"type": "number"})
_VECTOR = _array_or({"type": "number"}, _NUMBERS)
_PART = _list(_list({"type": ["number", "null"]}))
"""In JSON, NaN is null."""
_COMPLEX = _array_or({"type": "object", "properties": {"re": _PART, "im": _PART}, "required": ["re", "im"]})
_ARRAY = _object(
    {
        "nd": {"const": True},
        "type": {"enum": ["<f8", "<f4", "<c16", "<c8", "|u1"]},
        "kind": {"const": ""},
        "shape": _list({"type": "integer", "minimum": 0}) | {"maxItems": 2},
        "data": {"type": "string", "format": "binary"},
    }
) | {"description": "MessagePack only: a numpy array as msgpack-numpy writes it; its keys may be text or binary."}
_GRID = {
    "oneOf": [
        _object({key: {"type": "number", "exclusiveMinimum": 0} for key in ("f_min", "f_max", "delta_f")}),
        _object({"frequencies": _array_or(_NUMBERS)}),
        _object({"sha256": {"type": "string"}}),
    ]
}
_THREE = _list({"type": "number"}) | {"minItems": 3, "maxItems": 3}
_NAME = {"type": "string", "pattern": "^[A-Za-z0-9_-]{1,32}$"}
_CURVE = _object({"frequencies": _array_or(_NUMBERS), "asd": _array_or(_NUMBERS)})
_NETWORK_DETECTOR = _object(
    {
        "name": _NAME | {"description": "Known here, unless there are a response and a location."},
        "noise": {"oneOf": [_NAME, _CURVE], "description": "A curve known here, or frequencies in Hz and an ASD."},
        "response": _list(_THREE) | {"minItems": 3, "maxItems": 3},
        "location": _THREE | {"description": "Metres."},
        "arms": _list(_THREE) | {"minItems": 2, "maxItems": 2, "description": "Metres, where their length counts."},
    },
    optional=("response", "location", "arms"),
)
_NETWORK = _object(
    {
        "detectors": _list(_NETWORK_DETECTOR) | {"minItems": 1, "maxItems": MOST_DETECTORS},
        "f_min": {"type": "number", "exclusiveMinimum": 0, "description": "Hz"},
        "f_max": {"type": "number", "exclusiveMinimum": 0, "description": "Hz"},
        "trigger_time": {"type": "number", "description": "GPS seconds that coalescence_time is relative to"},
        "moving": {"type": "boolean", "default": True, "description": "Whether the Earth turns while a signal lasts"},
    },
    optional=("moving",),
)
_WAVEFORMS = {
    "type": "object",
    "required": ["model", "status"],
    "description": "The arrays of the requested output, [N, M] unless stated.",
    "properties": {
        "model": reference("ModelIdentity"),
        "status": _array_or(_list({"enum": [0, 1, 2, 3]}))
        | {"description": "[N]: 0 fine, 1 not finite, 2 out of domain, 3 out of band."},
        **dict.fromkeys(("h_plus", "h_cross", "h"), _COMPLEX),
        **dict.fromkeys(("amplitude", "phase"), _array_or(_PART)),
        "plus": _VECTOR | {"description": "[N], with 'h'"},
        "cross": {"description": "[N], complex, with 'h'"},
        "h_22": _COMPLEX | {"description": "of 'modes'; so every mode (l, m) has its h_lm, plus_lm and cross_lm"},
        "plus_22": _VECTOR | {"description": "[N], with 'h_22': what it counts in h_plus at the inclination"},
        "cross_22": {"description": "[N], complex, with 'h_22': what it counts in h_cross"},
        "estimated_mismatch": _VECTOR | {"description": "[N], the model's own estimate, if it has one"},
    },
    "patternProperties": {r"^h_\d\d(_\w+)?$": _COMPLEX, r"^plus_(slope_)?\d\d$": _VECTOR},
}


def _texts(*structs: type) -> dict[str, str]:
    """What the sections ``Parameters`` of docstrings say, by name; of equal names the last counts."""
    found: dict[str, str] = {}
    for struct in structs:
        section = (inspect.getdoc(struct) or "").partition("Parameters\n----------\n")[2].partition("\n\n")[0]
        for names, text in re.findall(r"^(\w[\w, ]*)\n((?:    .*\n?)+)", section, re.MULTILINE):
            plain = re.sub(r":\w+:`([^`]*)`", r"\1", " ".join(text.split()))
            if not plain.startswith("As in "):
                found |= dict.fromkeys(names.split(", "), plain)
    return found


def _parameter_forms(names: tuple[str, ...], optional: Iterable[str], *structs: type) -> dict[str, Any]:
    texts = _texts(*structs)
    columns = {name: _VECTOR | {"description": texts.get(name, "")} for name in names}
    return {
        "parameters": _array_or(_object(columns, optional), _list(_NUMBERS)),
        "names": _list({"enum": list(names)}) | {"uniqueItems": True},
    }


def _body(name: str, schema: dict[str, Any], forms: dict[str, Any], *structs: type) -> dict[str, Any]:
    """A generated schema with the forms of its arrays, and what the docstrings say of its fields."""
    texts = {name: {"description": text} for name, text in _texts(*structs).items()}
    fields = {name: forms.get(name, field) | texts.get(name, {}) for name, field in schema["properties"].items()}
    summary = schema.get("description", "").partition("\n\nParameters\n")[0]
    return {name: schema | {"title": name, "properties": fields, "description": summary}}


def schemas() -> dict[str, Any]:
    """The schemas of everything that travels, by name."""
    bodies = (WaveformBody, LikelihoodBody, LikelihoodAnswerBody, ForecastBody, ForecastAnswerBody)
    _, made = msgspec.json.schema_components([*_STRUCTS, *_UMBRIDGE, *bodies], ref_template=_REF)
    for struct in _UMBRIDGE:
        made |= _body(struct.__name__, made[struct.__name__], {}, *reversed(struct.__mro__[:-2]))
    question, sample, values, binaries, forecasts = (made.pop(body.__name__) for body in bodies)
    calibration = {"type": "object", "maxProperties": 64, "additionalProperties": _array_or(_list(_NUMBERS))}
    names = (*PARAMETER_NAMES, *IN_PLANE_NAMES)
    waveforms = _parameter_forms(names, PARAMETER_DEFAULTS, ParametersWithExtrinsic)
    optional = ("distance_mpc", "coalescence_time", "reference_phase")
    likelihoods = _parameter_forms(LIKELIHOOD_NAMES, optional, ParametersWithExtrinsic, LikelihoodParameters)
    likelihoods |= dict.fromkeys(("calibration_amplitude", "calibration_phase"), calibration)
    likelihoods["uniforms"] = _array_or(_list(_list({"type": "number", "minimum": 0, "exclusiveMaximum": 1})))
    answers = {
        "log_likelihood": _array_or(_list({"type": ["number", "null"]})),
        "status": _array_or(_list({"enum": [0, 1, 2, 3, 4]})),
        "d_inner_h": _COMPLEX,
        "h_inner_h": _array_or(_PART),
        "gradient": _array_or(_PART),
        **dict.fromkeys(DRAWN_NAMES, _array_or(_list({"type": ["number", "null"]}))),
    }
    whole = _parameter_forms(LIKELIHOOD_NAMES, ("reference_phase",), ParametersWithExtrinsic, LikelihoodParameters)
    flags = _array_or(_list({"enum": [0, 1]}))
    measured = {
        **dict.fromkeys(("snr", "condition", "sky_area"), _array_or(_list({"type": ["number", "null"]}))),
        **dict.fromkeys(("detector_snr", "root", "errors", "covariance"), _array_or(_PART)),
        "status": _array_or(_list({"enum": [0, 1, 2, 3]})),
        "singular": flags,
        "beyond": _array_or(_list(_list({"enum": [0, 1]}))),
    }
    return (
        made
        | {"Array": _ARRAY, "GridBody": _GRID, "NetworkBody": _NETWORK, "WaveformAnswer": _WAVEFORMS}
        | _body("ForecastRequest", binaries, whole, ForecastOptions, ForecastBody)
        | _body("ForecastAnswer", forecasts, measured, ForecastAnswerBody)
        | _body("WaveformRequest", question, waveforms, EvaluationOptions, WaveformBody)
        | _body("LikelihoodRequest", sample, likelihoods, LikelihoodBody)
        | _body("LikelihoodAnswer", values, answers, LikelihoodAnswerBody)
    )
