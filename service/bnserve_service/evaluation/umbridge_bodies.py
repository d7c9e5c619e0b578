"""What travels in UM-Bridge's protocol 1.0 (https://um-bridge-benchmarks.readthedocs.io): JSON, one evaluation each."""

from __future__ import annotations

import json
from typing import Annotated, Any, TypeVar

import msgspec

from bnserve_protocol import InvalidRequest
from bnserve_protocol.wire import JSON, refuse_repeated_keys, undecodable
from bnserve_service.errors import UMBRIDGE

PREFIX = UMBRIDGE
"""Of the paths; a client is given what is before the last ``/``."""
PROTOCOL_VERSION = 1.0
_LARGEST = 1e100
"""Of factors and directions."""
_MOST_NAMES = 64
"""As in :mod:`bnserve_protocol.wire`: more than there are, so that the answer can still say which is unknown."""


class UmBridgeConfig(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The options of one evaluation.

    Parameters
    ----------
    fixed
        Values of parameters by name; the input is the others, in their order.
    outside
        The output where the likelihood is 0, in the place of ``-Infinity``, which many a JSON has not.
    """

    fixed: Annotated[dict[str, float], msgspec.Meta(max_length=_MOST_NAMES)] = {}
    outside: float | None = None


class UmBridgeModelRequest(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A question about a model.

    Parameters
    ----------
    name
        ``<model>/<digest of an uploaded analysis>``, or ``<model>/<version>/<digest>``.
    config
        The options.
    """

    name: str
    config: UmBridgeConfig = UmBridgeConfig()


class UmBridgeEvaluateRequest(UmBridgeModelRequest, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """One sample.

    Parameters
    ----------
    input
        One vector: the parameters of the analysis in their order, without those that are fixed.
    """

    input: list[list[float]]

    def check(self) -> None:
        """Look at what there is beside a sample, which was looked at.

        Raises
        ------
        InvalidRequest
            An input or output that there is not, too many numbers or too few.
        """


class UmBridgeDerivativeRequest(UmBridgeEvaluateRequest, frozen=True, rename="camel"):
    """One sample, for derivatives of one output with respect to one input vector.

    Parameters
    ----------
    outWrt
        Of which output: 0, there is one.
    inWrt
        With respect to which input vector: 0, there is one.
    """

    out_wrt: int
    in_wrt: int

    def _check(self, name: str, numbers: list[float], length: int) -> None:
        if (self.out_wrt, self.in_wrt) != (0, 0):
            raise InvalidRequest("There is one input vector and one output vector: outWrt and inWrt are 0.")
        if len(numbers) != length:
            raise InvalidRequest(f"'{name}' has {length} numbers here; got {len(numbers)}.")
        if any(abs(number) > _LARGEST for number in numbers):
            raise InvalidRequest(
                f"The numbers of '{name}' are {_LARGEST:g} at most, or derivatives times them are none."
            )


class UmBridgeGradientRequest(UmBridgeDerivativeRequest, frozen=True, rename="camel"):
    """One sample, for its gradient.

    Parameters
    ----------
    sens
        One number, by which the gradient is multiplied.
    """

    sens: list[float]

    def check(self) -> None:
        """As of any sample."""
        self._check("sens", self.sens, 1)


class UmBridgeApplyJacobianRequest(UmBridgeDerivativeRequest, frozen=True, rename="camel"):
    """One sample, for its derivative along a direction.

    Parameters
    ----------
    vec
        The direction, as long as the input.
    """

    vec: list[float]

    def check(self) -> None:
        """As of any sample."""
        self._check("vec", self.vec, len(self.input[0]))


class UmBridgeInfo(msgspec.Struct, frozen=True, rename="camel"):
    """What this caller may ask: a name for every analysis and every model that it can be evaluated with."""

    protocol_version: float
    models: list[str]


class UmBridgeSupport(msgspec.Struct, frozen=True, rename="pascal"):
    """What a model can be asked for."""

    evaluate: bool
    gradient: bool
    apply_jacobian: bool
    apply_hessian: bool


class UmBridgeModelInfo(msgspec.Struct, frozen=True):
    """What is known about a model."""

    support: UmBridgeSupport


class UmBridgeInputSizes(msgspec.Struct, frozen=True, rename="camel"):
    """The length of the one input vector."""

    input_sizes: list[int]


class UmBridgeOutputSizes(msgspec.Struct, frozen=True, rename="camel"):
    """The length of the one output vector, which is 1."""

    output_sizes: list[int]


class UmBridgeEvaluateAnswer(msgspec.Struct, frozen=True):
    """The log-likelihood ratio, as one vector of one number."""

    output: list[list[float]]


class UmBridgeGradientAnswer(msgspec.Struct, frozen=True):
    """The gradient in the input's parameters, in their units; 0 where the likelihood is."""

    output: list[float]


class UmBridgeApplyJacobianAnswer(msgspec.Struct, frozen=True):
    """The derivative along the direction, as one number."""

    output: list[float]


class UmBridgeError(msgspec.Struct, frozen=True):
    """What went wrong: its ``type`` and a ``message``."""

    type: str
    message: str


class UmBridgeProblem(msgspec.Struct, frozen=True):
    """The body of every error answer."""

    error: UmBridgeError


class Named(msgspec.Struct, frozen=True):
    """Any question: whom it asks."""

    name: str


B = TypeVar("B", bound=msgspec.Struct)


def decode(body: bytes, form: type[B]) -> B:
    """Read a body.

    Raises
    ------
    UndecodableBody
        It is not such a body, or an object in it has a key twice.
    """
    try:
        found = msgspec.json.decode(body, type=form)
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        raise undecodable(error, JSON, body=body) from error
    refuse_repeated_keys(body)
    return found


def encode(output: list[Any]) -> bytes:
    """Write an answer; -inf as ``-Infinity``, which is no JSON, and which Python and Julia read all the same."""
    return json.dumps({"output": output}).encode()
