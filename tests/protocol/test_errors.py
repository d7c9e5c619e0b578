"""One tree of errors: drawn once, one code each, the same exception locally and over the wire."""

import json
import pickle
import re

import msgspec
import pytest

import bnserve_protocol
from bnserve_protocol import (
    ERRORS_BY_CODE,
    BnserveError,
    FieldError,
    InvalidRequest,
    NotFound,
    OutOfDomain,
    Unavailable,
    _errors,
)
from bnserve_protocol.wire import Problem

CLASSES = sorted(
    {item for item in vars(_errors).values() if isinstance(item, type) and issubclass(item, BnserveError)},
    key=lambda item: item.__name__,
)
ERRORS = (
    FieldError(reason="outside [1, 3]", parameter="mass_ratio", row=4, value=0.5),
    FieldError(reason="not finite"),
)


def drawn_tree():
    """Class name and parents' names, as the docstring draws them."""
    found, stack = {}, []
    for line in _errors.__doc__.splitlines():
        match = re.match(r"    ([│├└─ ]*)(\w+)(?: \((\w+)\))?", line)
        if match:
            depth = len(match[1]) // 4
            stack = [*stack[:depth], match[2]]
            found[match[2]] = {stack[depth - 1] if depth else "Exception"} | ({match[3]} - {None})
    return found


def test_the_tree_is_as_drawn():
    assert drawn_tree() == {cls.__name__: {base.__name__ for base in cls.__bases__} for cls in CLASSES}


def test_every_code_belongs_to_one_class():
    assert len({cls.code for cls in CLASSES}) == len(CLASSES)
    assert {cls.code: cls for cls in CLASSES} == ERRORS_BY_CODE


@pytest.mark.parametrize("cls", CLASSES, ids=lambda cls: cls.__name__)
def test_every_class_is_public_documented_and_titled(cls):
    assert getattr(bnserve_protocol, cls.__name__) is cls
    assert cls.__name__ in bnserve_protocol.__all__
    assert cls.__doc__
    assert re.fullmatch(r"[a-z]+(-[a-z]+)*", cls.code)
    assert cls is BnserveError or cls.title != BnserveError.title


@pytest.mark.parametrize("cls", CLASSES, ids=lambda cls: cls.__name__)
def test_every_error_survives_pickling(cls):
    error = cls("What to do.", errors=ERRORS, retry_after=1.5, request_id="abc")
    copy = pickle.loads(pickle.dumps(error))
    assert type(copy) is cls
    assert str(copy) == copy.detail == "What to do."
    assert (copy.errors, copy.retry_after, copy.request_id) == (ERRORS, 1.5, "abc")


@pytest.mark.parametrize("name", ["OutOfDomain", "ShareExceeded"])
def test_errors_that_were_pickled_by_0_1_are_read(name):
    error = pickle.loads(
        f"cbnserve_protocol._errors\n_rebuild\n(cbnserve_protocol._errors\n{name}\nVIt is.\n(tF1.5\nNtR.".encode()
    )
    assert type(error) is getattr(_errors, name)
    assert (error.detail, error.errors, error.retry_after, error.request_id) == ("It is.", (), 1.5, None)


@pytest.mark.parametrize("cls", CLASSES, ids=lambda cls: cls.__name__)
@pytest.mark.parametrize("codec", [msgspec.json, msgspec.msgpack], ids=["json", "msgpack"])
def test_every_error_survives_the_wire(cls, codec):
    sent = Problem.from_error(cls("What to do.", errors=ERRORS), status=422, request_id="abc")
    received = codec.decode(codec.encode(sent), type=Problem).to_error(retry_after=2.0)
    assert type(received) is cls
    assert received.detail == "What to do."
    assert received.errors == ERRORS
    assert (received.request_id, received.retry_after) == ("abc", 2.0)


def test_a_problem_is_as_rfc_9457_and_open_inference_want_it():
    problem = json.loads(msgspec.json.encode(Problem.from_error(OutOfDomain("No.", errors=ERRORS), 422, "abc")))
    assert problem == {
        "type": "urn:bnserve:error:out-of-domain",
        "title": "Parameters outside the trained range",
        "status": 422,
        "detail": "No.",
        "code": "out-of-domain",
        "error": "No.",
        "request_id": "abc",
        "errors": [
            {"reason": "outside [1, 3]", "parameter": "mass_ratio", "row": 4, "value": 0.5},
            {"reason": "not finite"},
        ],
    }


def test_an_unknown_code_of_a_newer_service_is_a_plain_error():
    body = b'{"type":"urn:x","title":"New","status":418,"detail":"I am new.","code":"brand-new","hint":{"a":1}}'
    error = msgspec.json.decode(body, type=Problem).to_error()
    assert type(error) is BnserveError
    assert error.detail == "I am new."


def test_what_may_be_tried_again():
    retryable = {cls.__name__ for cls in CLASSES if cls.retryable}
    assert retryable == {
        "Unavailable", "Overloaded", "QuotaExceeded", "Draining", "ModelLoading", "ConnectionFailed", "AnswerCorrupted"
    }  # fmt: skip


def test_the_builtin_that_says_the_same_catches_them():
    assert issubclass(InvalidRequest, ValueError)
    assert issubclass(NotFound, LookupError)
    assert not issubclass(Unavailable, ValueError | LookupError)
