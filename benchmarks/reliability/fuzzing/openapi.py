"""What our OpenAPI document promises, tried by schemathesis: MessagePack and JSON, right and wrong requests."""

from __future__ import annotations

import json
import urllib.request
from collections import Counter
from typing import Any

import msgpack
import schemathesis
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis.errors import Unsatisfiable
from schemathesis import GenerationMode
from schemathesis.checks import not_a_server_error
from schemathesis.core.failures import FailureGroup
from schemathesis.openapi import from_dict
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
    status_code_conformance,
)

MSGPACK = "application/msgpack"
CHECKS = (
    not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
)
_LARGEST = 2**64


@schemathesis.serializer(MSGPACK)
def write(_: Any, value: Any) -> bytes:
    """A generated body as MessagePack."""
    return bytes(value) if isinstance(value, bytes) else msgpack.packb(plain(value), default=str)


@schemathesis.deserializer(MSGPACK)
def read(_: Any, response: Any) -> Any:
    """An answer as the JSON that its schema speaks of."""
    return texts(msgpack.unpackb(response.content, strict_map_key=False))


def plain(value: Any) -> Any:
    """The nearest value that MessagePack has."""
    if isinstance(value, dict):
        named = {key: plain(each) for key, each in value.items()}
        if isinstance(named.get("data"), str):
            named["data"] = named["data"].encode("utf-8", "replace")
        return named
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    return float(value) if isinstance(value, int) and not -_LARGEST // 2 <= value < _LARGEST else value


def texts(value: Any) -> Any:
    """With text where MessagePack has bytes."""
    if isinstance(value, dict):
        return {texts(key): texts(each) for key, each in value.items()}
    if isinstance(value, list):
        return [texts(each) for each in value]
    return value.decode("latin-1") if isinstance(value, bytes) else value


def exercise(url: str, names: dict[str, str], examples: int, method: str = "") -> tuple[Counter[int], list[str]]:
    """Send generated requests of every operation to a running service.

    Parameters
    ----------
    url:
        Where it is.
    names:
        Path parameters that exist there, such as ``{"name": "default"}``; used in half of the cases.
    examples:
        Of every operation; as many wrong ones of those that have a body.
    method:
        Only operations of this method; empty for all.

    Returns
    -------
    How many answers of each status there were, and what did not keep the document's promises.
    """
    statuses: Counter[int] = Counter()
    failures: list[str] = []
    for found in from_dict(_document(url)).get_all_operations():
        operation: Any = found.ok()  # type: ignore[union-attr]  # a document of ours describes all its operations
        if method not in ("", operation.method.upper()):
            continue
        known = {name: value for name, value in names.items() if f"{{{name}}}" in operation.path}
        modes = [GenerationMode.POSITIVE, *([GenerationMode.NEGATIVE] if operation.body else [])]
        for mode, path in [(mode, path) for mode in modes for path in ([known, None] if known else [None])]:
            try:
                _try(operation.as_strategy(generation_mode=mode, path_parameters=path), url, examples, statuses)
            except FailureGroup as error:
                failures += [f"{operation.label}: {each.title}: {each.message}" for each in error.exceptions]
            except Unsatisfiable:
                pass  # nothing there that could be wrong
    return statuses, failures


def _document(url: str) -> dict[str, Any]:
    """The document; the bytes of arrays as text, because JSON's schema, which schemathesis reads, has no bytes."""
    with urllib.request.urlopen(f"{url}/openapi.json", timeout=30) as answer:
        document: dict[str, Any] = json.load(answer)
    del document["components"]["schemas"]["Array"]["properties"]["data"]["format"]
    return document


def _try(strategy: Any, url: str, examples: int, statuses: Counter[int]) -> None:
    @seed(20170817)
    @settings(
        max_examples=examples,
        deadline=None,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(case=strategy)
    def send(case: Any) -> None:
        response = case.call(base_url=url)
        statuses[response.status_code] += 1
        if response.status_code != 503:  # ready or not, full or not: the document has it
            case.validate_response(response, checks=list(CHECKS))

    send()
