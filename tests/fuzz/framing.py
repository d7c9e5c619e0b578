"""A conversation of bytes with a real server, and what has to be so of its answers, whatever the bytes are.

Each request is answered once, in order, or the connection ends; the bytes of a body or of a trailer are no request, no
name and no token; nobody gets what his token does not let him have; what no server should read is refused.
"""

import hashlib
import re
import socket
import time
from contextlib import suppress
from dataclasses import dataclass, field
from urllib.parse import unquote_to_bytes

from bnserve_protocol import UndecodableBody
from tests.fuzz.conversation import MARK
from tests.fuzz.reading_http import Reading, Request, read

NUMBER = b"NUMBERED"
"""Stands in the names of requests for eight digits that no other conversation has."""
TOKENS = {
    "all": b"a-token-that-may-do-everything-0",
    "usual": b"a-token-with-the-usual-scopes-00",
    "none": b"a-token-that-may-do-nothing-0000",
}
"""By the name of the caller."""
SCOPES = {"all": ("evaluate", "upload", "admin"), "usual": ("evaluate", "upload"), "none": ()}
LAST = b"GET /v2/health/live HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nX-Request-ID: NUMBERED-last\r\n\r\n"
TIMEOUT = 20.0
"""Seconds until an answer that has not come counts as none: a very busy machine takes some."""
_CUT_OFF = 5.0
"""Seconds within which what is too large is refused: it is there in whole."""
_MIDDLE = 0.5
"""Seconds that the rest of an answer may take whose beginning is there."""
_SURPLUS = 0.03
"""Seconds in which answers to nothing would come."""

_STATUS = re.compile(rb"HTTP/1\.1 ([1-5][0-9]{2}) [^\r\n]*")
_WORD = re.compile(rb"[\x21-\x7e]{1,128}")
_PAGES = (b"/", b"/docs", b"/openapi.json")
_LOOPBACK = re.compile(rb"((localhost|127\.0\.0\.1)\.?(:[0-9]*)?)?", re.IGNORECASE)
"""What a server on the loopback interface goes by; nothing is what no browser sends."""
_CONTROL = re.compile(rb"[\x00-\x1f\x7f]")
_SCOPED = (b"POST", b"PUT", b"DELETE")
_WITH_BODIES = (b"POST", b"PUT")


class FramingFault(AssertionError):
    """What a server must not do."""


@dataclass
class Answer:
    """One answer."""

    status: int
    headers: dict[bytes, bytes]
    body: bytes

    @property
    def closes(self) -> bool:
        """Whether it says that it is the last."""
        return self.headers.get(b"connection", b"").lower() == b"close"


@dataclass
class Heard:
    """What came back on one connection."""

    answers: list[Answer] = field(default_factory=list)
    surplus: bytes = b""
    """What is no answer, or only the beginning of one."""
    ended: bool = False
    """Whether the server has ended the connection."""


def talk(address: tuple[str, int], data: bytes, number: int = 0, behind_gateway: bool = False) -> tuple[Reading, Heard]:
    """Send the pieces of a conversation, each when the answers to those before have come, and listen to the end."""
    pieces = data.replace(NUMBER, b"%08d" % number).split(MARK)
    sent = b""
    with socket.create_connection(address, timeout=TIMEOUT) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        listener = _Listener(connection)
        for piece in pieces:
            _send(connection, piece)
            sent += piece
            reading = read(sent)
            if listener.wait(reading, TIMEOUT):
                break
        reading = read(sent)
        if reading.rest == "nothing" and not (reading.requests and reading.requests[-1].closes):
            last = LAST.replace(NUMBER, b"%08d" % number)
            _send(connection, last)
            reading = read(sent + last)
            listener.wait(reading, TIMEOUT)
        cut_off = _SURPLUS if behind_gateway else _CUT_OFF  # gateways have limits of their own
        listener.finish(reading, {"nothing": TIMEOUT, "too large": cut_off}.get(reading.rest, _SURPLUS))
        return reading, listener.heard(reading)


def _send(connection: socket.socket, piece: bytes) -> None:
    with suppress(OSError):  # ended meanwhile: what it said before can still be read
        connection.sendall(piece)


class _Listener:
    """Collects what a server says."""

    def __init__(self, connection: socket.socket) -> None:
        self._connection, self._said, self._ended = connection, b"", False

    def wait(self, reading: Reading, timeout: float) -> bool:
        """Until all that is due has come; whether the server has ended the connection."""
        until = time.monotonic() + timeout
        while not self._ended and len(self.heard(reading).answers) < len(reading.requests):
            if time.monotonic() > until:
                break
            self._receive(until)
        return self._ended

    def finish(self, reading: Reading, seconds: float) -> None:
        """Until the server ends the connection, or is silent for this long, and not in the middle of an answer."""
        now = time.monotonic()
        until, latest = now + seconds, now + seconds + _MIDDLE
        while not self._ended and (now < until or (now < latest and self.heard(reading).surplus)):
            self._receive(max(until, now + _SURPLUS))
            now = time.monotonic()

    def heard(self, reading: Reading) -> Heard:
        """The answers so far."""
        methods = [each.method for each in reading.requests] + [reading.partial.method if reading.partial else b""]
        answers, surplus = parse_answers(self._said, methods)
        return Heard(answers, surplus, self._ended)

    def _receive(self, until: float) -> None:
        self._connection.settimeout(max(1e-3, until - time.monotonic()))
        try:
            said = self._connection.recv(2**20)
        except TimeoutError:
            return
        except OSError:
            said = b""
        self._said += said
        self._ended = not said


def parse_answers(said: bytes, methods: list[bytes]) -> tuple[list[Answer], bytes]:
    """The final answers to requests of these methods, and what is left over."""
    answers: list[Answer] = []
    while said:
        head, end, rest = said.partition(b"\r\n\r\n")
        first, *lines = head.split(b"\r\n")
        status = _STATUS.fullmatch(first)
        if not end or status is None:
            break
        headers = {name.lower(): value.strip() for name, _, value in (line.partition(b":") for line in lines)}
        code = int(status[1])
        if code < 200:
            said = rest
            continue
        length = int(headers.get(b"content-length", b"0"))
        is_for_head = methods[len(answers) : len(answers) + 1] == [b"HEAD"]
        if code in (204, 304) or (is_for_head and not rest.startswith(b"{")):  # a refusal may not know the method
            length = 0
        if len(rest) < length:
            break
        answers.append(Answer(code, headers, rest[:length]))
        said = rest[length:]
    return answers, said


def judge(reading: Reading, heard: Heard, behind_gateway: bool = False) -> None:
    """Compare what a server said with what it was asked.

    A gateway may make something else of what is no whole request, and pass that on: only what comes before is judged.

    Raises
    ------
    FramingFault
    """
    if behind_gateway and reading.rest != "nothing":
        for request, answer in zip(reading.requests, heard.answers, strict=False):
            _check(request, answer, behind_gateway)
        return
    due = [*reading.requests, *([reading.partial] if reading.partial is not None else [])]
    for number, answer in enumerate(heard.answers):
        if number < len(reading.requests):
            _check(reading.requests[number], answer, behind_gateway)
        elif reading.rest != "nothing" and number == len(reading.requests):
            _check_refusal(reading, answer)
        else:
            raise FramingFault(f"{len(heard.answers)} answers to {len(due)} requests: {answer}")
        if answer.closes and number + 1 < len(heard.answers):
            raise FramingFault(f"there are answers after the last one: {heard.answers[number + 1]}")
    if heard.surplus and not heard.ended:
        raise FramingFault(f"this is no answer: {heard.surplus[:200]!r}")
    silent = len(heard.answers) < len(reading.requests)
    if silent and not heard.ended:
        raise FramingFault(f"no answer to {reading.requests[len(heard.answers)]}")
    if silent and reading.certain and not (heard.answers and heard.answers[-1].closes):
        raise FramingFault(f"the connection ended without an answer to {reading.requests[len(heard.answers)]}")
    if reading.rest == "too large" and not heard.ended:
        raise FramingFault("more than 64 KiB of a head or of trailers, and the connection is still open")


def _check_refusal(reading: Reading, answer: Answer) -> None:
    """What may be said of a request that is wrong or not there in whole: no, or what needs no body."""
    partial, name = reading.partial, answer.headers.get(b"x-request-id")
    if answer.status < 400 and (partial is None or partial.method in _WITH_BODIES):
        raise FramingFault(f"an answer to a request that is {reading.rest}: {answer}, {partial}")
    if partial is not None and name is not None:
        if not _is_name_of(partial, name):
            raise FramingFault(f"{name!r} is not the name of {partial}")
        _check_access(partial, answer)


def _is_name_of(request: Request, name: bytes) -> bool:
    given = request.all(b"x-request-id")
    own = re.fullmatch(rb"[0-9a-f]{32}", name) is not None
    return name in given or (own and not (len(given) == 1 and _WORD.fullmatch(given[0])))


def _check(request: Request, answer: Answer, behind_gateway: bool) -> None:
    """One answer to one request that can be read."""
    name = answer.headers.get(b"x-request-id")
    if name is None:
        if answer.status < 400 or not (behind_gateway or request.doubtful or _must_be_400(request)):
            raise FramingFault(f"an answer without the name of {request}: {answer}")
        return
    if not _is_name_of(request, name):
        raise FramingFault(f"{name!r} is not the name of {request}")
    digest = answer.headers.get(b"x-request-digest")
    if digest is not None and hashlib.sha256(request.body).hexdigest().encode() not in digest:
        raise FramingFault(f"answered was another body than that of {request}: {answer}")
    if answer.status >= 500 and answer.status not in (503, 504):  # full; or it has a deadline
        raise FramingFault(f"{answer} to {request}")
    if _must_be_400(request) and answer.status not in (400, 403) and not behind_gateway:  # which repairs hosts
        raise FramingFault(f"{answer.status} where 400 belongs: {request}")
    _check_access(request, answer)
    _check_negotiation(request, answer)


def _must_be_400(request: Request) -> bool:
    return request.host_is_wrong or _CONTROL.search(path_of(request)) is not None


def path_of(request: Request) -> bytes:
    """The decoded path."""
    target = request.target
    if b"://" in target.partition(b"?")[0]:
        target = b"/" + target.partition(b"://")[2].partition(b"/")[2]
    return unquote_to_bytes(target.partition(b"?")[0].partition(b"#")[0])


def caller_of(request: Request) -> str | None:
    """Who asks, by the head of the request."""
    given = request.all(b"authorization")
    kind, _, text = (given[0] if len(given) == 1 else b"").partition(b" ")
    return next((who for who, token in TOKENS.items() if kind.lower() == b"bearer" and text.strip() == token), None)


def _check_access(request: Request, answer: Answer) -> None:
    path, caller = path_of(request), caller_of(request)
    public = path in _PAGES or path.startswith(b"/v2/")
    let_in = answer.status < 300
    if caller is None and not public and (let_in or answer.status not in (400, 401, 403)):
        raise FramingFault(f"{answer.status} without a token: {request}")
    if caller is not None and answer.status == 401:
        raise FramingFault(f"the token of '{caller}' is not known: {request}")
    too_much = _is_for_operators(path) or (caller == "none" and request.method in _SCOPED)
    if caller != "all" and let_in and not public and too_much:
        raise FramingFault(f"{answer.status} for a token without the scope: {request}")
    hosts = request.all(b"host")
    if let_in and not path.startswith(b"/v2/") and not all(_LOOPBACK.fullmatch(host) for host in hosts):
        raise FramingFault(f"{answer.status} to another host: {request}")


def _is_for_operators(path: bytes) -> bool:
    """Whether some reader could take a path for one that needs the scope ``admin``."""
    plain = re.sub(rb"[\x00-\x20\x7f-\xff]|(?<=/)\.?/|/$", b"", unquote_to_bytes(path).lower())
    return plain.endswith((b"metrics", b"reload"))


def _check_negotiation(request: Request, answer: Answer) -> None:
    """A waveform comes in the form that the head asks for, and a page that is there is found."""
    accepted = request.all(b"accept")
    if answer.status == 200 and request.target.endswith(b"/waveforms") and len(accepted) == 1:
        kind = answer.headers.get(b"content-type", b"")
        if accepted[0] in (b"application/json", b"application/msgpack") and kind != accepted[0]:
            raise FramingFault(f"{kind!r} was not asked for: {request}")
    if request.method == b"GET" and request.target == b"/v2/health/live" and answer.status not in (200, 400, 406):
        raise FramingFault(f"{answer.status} for {request}")


def read_framing(address: tuple[str, int], data: bytes, number: int = 0) -> None:
    """Hold a conversation and judge it.

    Raises
    ------
    FramingFault
        The server did what it must not do.
    UndecodableBody
        It has refused some of it.
    """
    reading, heard = talk(address, data, number)
    judge(reading, heard)
    if reading.rest != "nothing" or len(heard.answers) < len(reading.requests):
        raise UndecodableBody(f"This is {reading.rest}, or was refused.")
