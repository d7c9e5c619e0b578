"""Text of others cannot move the cursor of a terminal, begin a line of a log, or hide."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_protocol import ERRORS_BY_CODE, BnserveError, FieldError, printable
from bnserve_protocol.wire import Problem

HOSTILE = {
    "a colour": ("\x1b[31mred\x1b[0m", r"\x1b[31mred\x1b[0m"),
    "a title": ("\x1b]0;owned\x07", r"\x1b]0;owned\x07"),
    "a control sequence in one character": ("\x9b2J", r"\x9b2J"),
    "the beginning of the line": ("good\rbad", r"good\rbad"),
    "a new line": ("one\ntwo", r"one\ntwo"),
    "a next line": ("one\x85two", r"one\x85two"),
    "a line separator": ("one\u2028two", r"one\u2028two"),
    "backspaces": ("bad\b\b\bgood", r"bad\x08\x08\x08good"),
    "a null": ("\0", r"\x00"),
    "text from right to left": ("abc\u202edef", r"abc\u202edef"),
    "what takes no room": ("a\u200bb", r"a\u200bb"),
    "half a pair": ("\ud800", r"\ud800"),
    "a tag beyond the first plane": ("\U000e0041", r"\U000e0041"),
}


@pytest.mark.parametrize(("text", "written"), HOSTILE.values(), ids=HOSTILE)
def test_what_a_terminal_would_obey_is_written_out(text, written):
    assert printable(text) == written


@pytest.mark.parametrize("text", ["", "mass_ratio = 0.5 is outside [1, 3]", "Λ₁ = 400, ünïcödé, 牡丹", "a\\b"])
def test_what_is_printed_as_it_is_stays(text):
    assert printable(text) is text


def test_some_may_be_kept():
    assert printable("one\n\ttwo\r", keep="\n\t") == "one\n\ttwo\\r"


@given(st.text())
def test_nothing_is_left_that_is_not_printed(text):
    assert printable(text).isprintable()


@pytest.mark.parametrize(("text", "written"), HOSTILE.values(), ids=HOSTILE)
@pytest.mark.parametrize("code", ["out-of-domain", "internal", "unheard-of"])
def test_a_problem_of_a_server_becomes_a_harmless_error(code, text, written):
    problem = Problem(
        type=text, title=text, status=422, detail=f"says {text}", code=code, request_id=text,
        errors=[FieldError(reason=text, parameter=text, value=text), FieldError(reason="fine", value=0.5)],
    )  # fmt: skip
    error = problem.to_error()
    assert type(error) is ERRORS_BY_CODE.get(code, BnserveError)
    assert (error.detail, str(error), error.request_id) == (f"says {written}", f"says {written}", written)
    assert error.errors == (FieldError(written, written, None, written), FieldError(reason="fine", value=0.5))
    shown = (str(error), repr(error), str(error.errors), str(msgspec.to_builtins(Problem.from_error(error, 422))))
    assert all(each.isprintable() for each in shown)


def test_an_error_of_ours_may_have_lines():
    assert BnserveError("one:\n\ttwo\x1b[2J").detail == "one:\n\ttwo\\x1b[2J"
