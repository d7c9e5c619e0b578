"""Questions of UM-Bridge clients: one sample of an uploaded analysis there, its log-likelihood or gradient back.

An analysis is a model of theirs, which has one vector as input, the parameters, and one of one number as output. What
is asked is evaluated, limited, queued and grouped as every question for likelihoods is.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    BnserveError,
    FieldError,
    InvalidParameters,
    InvalidRequest,
    LikelihoodBatch,
    ModelUnknown,
    check_model_of,
)
from bnserve_protocol.wire import JSON, DigestName, LikelihoodOutput, LikelihoodRequest
from bnserve_service.errors import UnsupportedFeature
from bnserve_service.evaluation.likelihoods import LikelihoodQuestion, Likelihoods
from bnserve_service.evaluation.questions import Arrays, Buffer, Operation
from bnserve_service.evaluation.umbridge_bodies import (
    PREFIX,
    Named,
    UmBridgeApplyJacobianRequest,
    UmBridgeConfig,
    UmBridgeEvaluateRequest,
    UmBridgeGradientRequest,
    decode,
    encode,
)
from bnserve_service.http.requests import RequestContext, answer_digest, require_media_type
from bnserve_service.models.registry import DEFAULT_LABEL, Catalogue, LoadedModel
from bnserve_service.uploads.analyses import AnalysisStore, StoredAnalysis

_NAME = re.compile(r"([^/]{1,200})(?:/([^/]{1,200}))?/([0-9a-f]{64})")
ADVICE = f"UM-Bridge bodies are {JSON}: say so in Content-Type, or leave it out."
EXAMPLE = {
    "name": "default/" + 64 * "0",
    "input": [[1.2, 400.0, 600.0, 0.01, 0.0, 2.5, 2.76, 3.45, -0.41, 0.1, 40.0, 0.0, 0.0]],
    "config": {},
}


def address(body: bytes) -> dict[str, str]:
    """The model, its version if there is one, and the digest of the analysis that the ``name`` in a body stands for.

    Raises
    ------
    UndecodableBody
        There is none.
    ModelUnknown
        It is none of ours.
    """
    found = _NAME.fullmatch(decode(body, Named).name)
    if found is None:
        raise ModelUnknown(
            "A model is called '<model>/<digest of an uploaded analysis>' here, or '<model>/<version>/<digest>'; "
            f"GET {PREFIX}Info lists yours."
        )
    name, version, sha256 = found.groups()
    return {"name": name, "sha256": sha256} | ({} if version is None else {"version": version})


def names(analyses: AnalysisStore, owner: str, catalogue: Catalogue) -> list[str]:
    """What UM-Bridge clients of one owner may ask: every analysis with every version of a model that it fits."""
    return [
        f"{name}/{stored.sha256}"
        if catalogue.labels.get(name, {}).get(DEFAULT_LABEL) == version
        else f"{name}/{version}/{stored.sha256}"
        for stored in analyses.all_of(owner)
        for (name, version), loaded in catalogue.models.items()
        if _fits(stored, loaded)
    ]


def _fits(stored: StoredAnalysis, model: LoadedModel) -> bool:
    try:
        check_model_of(stored.analysis, model.model.description)
    except BnserveError:
        return False
    return True


def inputs(stored: StoredAnalysis, config: UmBridgeConfig) -> list[str]:
    """The parameters of the input vector, in its order.

    Raises
    ------
    InvalidParameters
        What is fixed is no parameter of this analysis.
    """
    unknown = [name for name in config.fixed if name not in stored.parameters]
    if unknown:
        raise InvalidParameters(
            f"config.fixed: this analysis has no parameter '{unknown[0][:80]}'; it has {', '.join(stored.parameters)}.",
            errors=[FieldError(reason="unknown", parameter=unknown[0][:80])],
        )
    return [name for name in stored.parameters if name not in config.fixed]


def sample(stored: StoredAnalysis, asked: UmBridgeEvaluateRequest) -> LikelihoodBatch:
    """The one sample that is asked for.

    Raises
    ------
    InvalidRequest
        It is not one vector of the right length.
    """
    wanted = inputs(stored, asked.config)
    lengths = [len(vector) for vector in asked.input]
    if lengths != [len(wanted)]:
        raise InvalidRequest(
            f"The input is one vector of {len(wanted)} numbers: {', '.join(wanted)}; got "
            f"{len(lengths)} of {', '.join(map(str, lengths[:8])) or 'no'} numbers."
        )
    return LikelihoodBatch.coerce({**asked.config.fixed, **dict(zip(wanted, asked.input[0], strict=True))})


class UmBridgeQuestion(LikelihoodQuestion, frozen=True, eq=False, kw_only=True):
    """What an UM-Bridge client asks."""

    asked: UmBridgeEvaluateRequest


class Evaluate(Likelihoods):
    """``POST /v1/umbridge/Evaluate``; parameters as of :class:`Likelihoods`."""

    name = "umbridge-evaluate"
    paths: ClassVar[tuple[str, ...]] = (f"{PREFIX}Evaluate",)
    operation = Operation(
        tag="umbridge",
        identifier="umbridge_evaluate",
        summary="The log-likelihood ratio of one sample of an uploaded analysis",
        bodies="UmBridgeEvaluate",
        example=EXAMPLE,
        json_alone=True,
    )
    form: ClassVar[type[UmBridgeEvaluateRequest]] = UmBridgeEvaluateRequest
    """Of the body."""
    wanted: ClassVar[LikelihoodOutput] = "log_likelihood"
    """What is evaluated for it."""

    def forms(self, headers: Mapping[bytes, bytes]) -> tuple[str, str, DigestName]:
        """JSON, said or not, whatever is accepted."""
        require_media_type(headers, JSON, ADVICE)
        return JSON, JSON, answer_digest(headers)

    def address(self, body: bytes, request: RequestContext) -> None:
        """As :func:`address`."""
        request.path = address(body)

    def subject(self, request: RequestContext) -> str:
        """The analysis, once its name was read."""
        return request.path.get("sha256", "")

    def read(self, model: LoadedModel, body: bytes, request: RequestContext) -> UmBridgeQuestion:
        """As :meth:`Likelihoods.read`; who asks for what there is not is told that first, whatever else is wrong."""
        stored = self._analyses.get(request.owner, self.subject(request))
        check_model_of(stored.analysis, model.model.description)
        if self.wanted == "gradients" and not model.has_derivatives:
            raise UnsupportedFeature(
                f"The model '{model.identity.name}' does not say that it has derivatives: use Evaluate."
            )
        asked = decode(body, self.form)
        likelihood = LikelihoodRequest(batch=sample(stored, asked), output=self.wanted)
        asked.check()
        return UmBridgeQuestion(asked=asked, **self._question(model, stored, likelihood, request))

    def encode(self, question: LikelihoodQuestion, arrays: Arrays) -> list[Buffer]:
        """The answer."""
        assert isinstance(question, UmBridgeQuestion)
        return [encode(self.output(question, arrays))]

    def output(self, question: UmBridgeQuestion, arrays: Arrays) -> list[Any]:
        """The output, where -inf is what the caller wants in its place."""
        value, outside = float(arrays["log_likelihood"][0]), question.asked.config.outside
        return [[value if outside is None or value > -math.inf else outside]]


class Gradient(Evaluate):
    """``POST /v1/umbridge/Gradient``."""

    name = "umbridge-gradient"
    paths = (f"{PREFIX}Gradient",)
    operation = Operation(
        tag="umbridge",
        identifier="umbridge_gradient",
        summary="The gradient of the log-likelihood ratio at one sample, times 'sens'",
        bodies="UmBridgeGradient",
        example=EXAMPLE | {"outWrt": 0, "inWrt": 0, "sens": [1.0]},
        json_alone=True,
    )
    form = UmBridgeGradientRequest
    wanted = "gradients"

    def output(self, question: UmBridgeQuestion, arrays: Arrays) -> list[Any]:
        """The gradient in what the input has."""
        assert isinstance(question.asked, UmBridgeGradientRequest)
        return (question.asked.sens[0] * _gradient(question, arrays)).tolist()


class ApplyJacobian(Evaluate):
    """``POST /v1/umbridge/ApplyJacobian``."""

    name = "umbridge-apply-jacobian"
    paths = (f"{PREFIX}ApplyJacobian",)
    operation = Operation(
        tag="umbridge",
        identifier="umbridge_apply_jacobian",
        summary="The derivative of the log-likelihood ratio at one sample along a direction",
        bodies="UmBridgeApplyJacobian",
        example=EXAMPLE | {"outWrt": 0, "inWrt": 0, "vec": [0.01, *[0.0] * 12]},
        json_alone=True,
    )
    form = UmBridgeApplyJacobianRequest
    wanted = "gradients"

    def output(self, question: UmBridgeQuestion, arrays: Arrays) -> list[Any]:
        """The product."""
        assert isinstance(question.asked, UmBridgeApplyJacobianRequest)
        return [float(_gradient(question, arrays) @ question.asked.vec)]


def _gradient(question: UmBridgeQuestion, arrays: Arrays) -> NDArray[np.float64]:
    """In the parameters of the input; 0 where the likelihood is."""
    asked = inputs(question.stored, question.asked.config)
    columns = [question.stored.parameters.index(name) for name in asked]
    gradient: NDArray[np.float64] = arrays["gradient"][0, columns]
    return np.zeros(len(columns)) if arrays["status"][0] else gradient
