"""Conversations over HTTP as they should be, and changes of them: methods, paths, hosts, headers, framing, trailers."""

from random import Random

import msgspec

from tests.fuzz.conversation import MARK
from tests.fuzz.framing import NUMBER, TOKENS
from tests.fuzz.mutations import damage
from tests.service.asking import GRID, GW170817

# fmt: off
WAVEFORMS = b"/v1/models/default/waveforms"
METHODS = (
    b"GET", b"HEAD", b"POST", b"PUT", b"DELETE", b"OPTIONS", b"PATCH", b"TRACE", b"CONNECT", b"PRI", b"get", b"FOO",
    b"M-SEARCH", b"G\tT", b"",
)
TARGETS = (
    b"/v2/health/live", b"/v2/health/live%0A", b"/v1/limits", b"/v1/limits%0A", b"/v1/models", b"/metrics",
    b"/metrics%0A", b"/metrics%0D", b"/%6detrics", b"/metrics/", b"//metrics", b"/metrics%00", b"/metrics?a=/v2/",
    b"/v2/../metrics", b"/v2/..%2fmetrics", b"/v2/%2e%2e/metrics", b"/docs%0A", b"/%09", b"/METRICS", b"/metrics%250A",
    b"/v1/reload", b"/v1/reload%0A", b"/v1/reload%0a%0a", b"/v1/./reload", b"/v1%2freload", b"/docs", b"/", b"/;a=b",
    b"http://localhost/metrics", b"http://localhost/v2/health/live", b"http://other.example/v1/limits", b"*",
    b"localhost:80", b"/v1/limits#x", b"/v1/\xff", b"/%ff%fe", b"/%", b"/%zz", b"", b"?", b"/a b", b"/" + b"a" * 9000,
    WAVEFORMS, WAVEFORMS + b"%0A", WAVEFORMS + b"?x=1", b"/v1/models/default%0A/waveforms",
    b"/v1/models/default/versions/stable/waveforms", b"/v1/grids/" + b"0" * 64, b"/v1/analyses/" + b"0" * 64,
    b"/v1/models/default/likelihoods/" + b"0" * 64,
)
VERSIONS = (b"HTTP/1.1", b"HTTP/1.1", b"HTTP/1.0", b"HTTP/2.0", b"HTTP/0.9", b"HTTP/1.2", b"http/1.1", b"HTTP/11", b"")
LINES = (
    b"Upgrade: h2c\r\nConnection: Upgrade, HTTP2-Settings\r\nHTTP2-Settings: AAMAAABkAARAAAAAAAIAAAAA",
    b"Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==", b"Upgrade: TLS/1.0",
    b"Connection: upgrade, close\r\nUpgrade: h2c", b"Connection: close", b"Connection: keep-alive", b"Connection: x",
    b"Connection: keep-alive\r\nConnection: close", b"Transfer-Encoding: chunked", b"Transfer-Encoding: identity",
    b"Transfer-Encoding: gzip, chunked", b"Transfer-Encoding: chunked, identity", b"Transfer-Encoding:\x0bchunked",
    b"Transfer-Encoding: xchunked", b"Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked",
    b"Content-Length: 0", b"Content-Length: 5", b"Content-Length: +5", b"Content-Length: 5, 5", b"Content-Length: -1",
    b"Content-Length: 0x10", b"Content-Length: 1_0", b"Content-Length: 99999999999999999999", b"Content-Length : 5",
    b"Content-Length: 5\r\nContent-Length: 6", b"Content-Length:", b"Host: localhost", b"Host: other.example", b"Host:",
    b"Host: localhost:80", b"Host: a b", b"Host: localhost, other.example", b"Host: u@localhost", b"hOST: localhost",
    b"Expect: 100-continue", b"Expect: else", b"Authorization: Bearer " + TOKENS["all"],
    b"Authorization: Bearer " + TOKENS["none"], b"Authorization: Bearer wrong", b"Authorization: Basic YTpi",
    b"X-Request-ID: NUMBERED-other", b"X-Request-ID: two words", b"X-Request-ID:", b"Accept: application/json",
    b"Accept: application/msgpack", b"Accept: text/html", b"Content-Type: application/json",
    b"Content-Type: text/plain", b"Trailer: Authorization",
    b"TE: trailers", b" folded: line", b"\tfolded", b"X-A : b", b"X\x00A: b", b"X-A: \x7f",
    b"X-A: \x00", b"X-A: a\rb", b"X-A: a\nb", b": nameless", b"nocolon", b"X-A: " + b"a" * 8000, b"X-A: \xff\xfe",
    b"Origin: http://other.example", b"Origin: null", b"X-Original-URL: /metrics", b"X-HTTP-Method-Override: PUT",
    b"X-Forwarded-Host: localhost", b"Content-Encoding: gzip", b"Range: bytes=0-1", b"X-Request-Deadline-Ms: 0",
    b"traceparent: \xc2\x85x",
)
TRAILERS = (
    b"Authorization: Bearer " + TOKENS["all"], b"X-Request-ID: NUMBERED-trailer", b"Accept: application/json",
    b"Accept: application/msgpack", b"Host: other.example", b"Content-Length: 7", b"Transfer-Encoding: chunked",
    b"Connection: close", b"Upgrade: h2c", b"Expect: 100-continue", b"Content-Type: application/json", b"X-A: b",
    b"X-A: " + b"a" * 5000, b"X-A: " + b"a" * 150_000, b"\r\n".join(b"X-%d: %s" % (n, b"a" * 90) for n in range(1600)),
    b"X-A : b", b" folded", b"nocolon", b"X-A: \x00",
)
SIZES = (
    b"0", b"00", b"1", b"5", b"ffffffffffffffff", b"ffffffffffffffff1", b"-1", b"0x5", b"5;a=b", b"5 ;a", b"", b"5\n",
    b"5;" + b"a" * 150_000,
)
# fmt: on
BODY = {"parameters": GW170817, "grid": GRID}
MSGPACK_BODY, JSON_BODY = msgspec.msgpack.encode(BODY), msgspec.json.encode(BODY)
SMUGGLED = (
    b"GET /metrics HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " + TOKENS["all"] + b"\r\n"
    b"X-Request-ID: NUMBERED-smuggled\r\n\r\n"
)
BODIES = (
    MSGPACK_BODY,
    JSON_BODY,
    SMUGGLED,
    b"",
    b"0\r\n\r\n" + SMUGGLED,
    MSGPACK_BODY + SMUGGLED,
    b"\r\n\r\n",
    b"x" * 40_000,
)


def head(method: bytes, target: bytes, *lines: bytes, name: bytes = b"a", caller: str = "") -> bytes:
    """Request line and headers, without the empty line."""
    own = [b"Host: localhost", *([b"Authorization: Bearer " + TOKENS[caller]] if caller else []), *lines]
    return b"\r\n".join([method + b" " + target + b" HTTP/1.1", *own, b"X-Request-ID: " + NUMBER + b"-" + name])


def sized(start: bytes, body: bytes = b"") -> bytes:
    """A request whose length is stated."""
    return start + (b"\r\nContent-Length: %d" % len(body)) + b"\r\n\r\n" + body


def chunked(start: bytes, body: bytes, *trailers: bytes, piece: int = 100) -> bytes:
    """A request in chunks, with trailers."""
    parts = [body[place : place + piece] for place in range(0, len(body), piece)]
    chunks = b"".join(b"%x\r\n%b\r\n" % (len(part), part) for part in parts)
    ends = b"".join(line + b"\r\n" for line in trailers)
    return start + b"\r\nTransfer-Encoding: chunked\r\n\r\n" + chunks + b"0\r\n" + ends + b"\r\n"


def ours(name: bytes) -> bytes:
    """A request with the head of our client, which the fast path knows."""
    lines = [b"Content-Type: application/msgpack", b"Accept: application/msgpack"]
    start = head(b"POST", WAVEFORMS, *lines, name=name, caller="all")
    return start + b"\r\nX-Request-Deadline-Ms: 30000\r\nContent-Length: %d\r\n\r\n" % len(MSGPACK_BODY) + MSGPACK_BODY


def conversations() -> list[bytes]:
    """What callers say, in whole pieces and pipelined."""
    json = (b"Content-Type: application/json", b"Accept: application/json")
    get = b"GET %b HTTP/1.1\r\nHost: localhost\r\nX-Request-ID: NUMBERED-%b\r\n\r\n"
    said = [
        [ours(b"a"), ours(b"b"), ours(b"c")],
        [ours(b"a") + ours(b"b"), get % (b"/v2/health/live", b"c") + ours(b"d")],
        [chunked(head(b"POST", WAVEFORMS, *json, caller="all"), JSON_BODY, b"X-Checksum: 1"), ours(b"b")],
        [sized(head(b"POST", WAVEFORMS, *json, caller="all"), SMUGGLED), get % (b"/docs", b"b")],
        [sized(head(b"GET", b"/metrics", caller=who, name=who.encode() or b"-")) for who in ("all", "usual", "")],
        [sized(head(b"POST", b"/v1/reload", caller=who, name=who.encode() or b"-")) for who in ("usual", "none", "")],
        [sized(head(b"GET", b"/v1/limits", caller="none")), sized(head(b"HEAD", b"/v1/models", name=b"b"))],
        [sized(head(b"PUT", b"/v1/grids/" + b"0" * 64, caller="all"), bytes(64)), get % (b"/", b"b")],
        [sized(head(b"POST", WAVEFORMS, *json, b"Expect: 100-continue", caller="all"), JSON_BODY), ours(b"b")],
        [sized(head(b"POST", WAVEFORMS, *json, b"Connection: close", caller="all"), JSON_BODY) + SMUGGLED],
    ]
    return [MARK.join(pieces) for pieces in said]


def compose(random: Random) -> bytes:
    """A request of random parts, framed as it should be."""
    lines = random.sample(LINES, random.randrange(4))
    who = random.choice([*TOKENS, ""])
    name = b"%08x" % random.getrandbits(32)
    method, target = random.choice(METHODS[:5] + METHODS), random.choice(TARGETS)
    start = head(method, target, b"Content-Type: application/msgpack", *lines, name=name, caller=who)
    body = random.choice(BODIES)
    kind = random.randrange(4)
    if kind == 0:
        return start + b"\r\n\r\n"
    if kind == 1:
        return sized(start, body)
    trailers = random.sample(TRAILERS, random.randrange(3)) if kind == 2 else ()
    return chunked(start, body, *trailers, piece=random.choice([1, 7, 100, 20_000]) if len(body) < 1000 else 9000)


def mutate_requests(data: bytes, random: Random) -> bytes:
    """A few changes of a conversation."""
    pieces = data.split(MARK)
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        place = random.randrange(len(pieces))
        action = random.randrange(9)
        if action == 0:
            pieces[place] = compose(random)
        elif action == 1:
            pieces.insert(place, compose(random))
        elif action == 2:
            pieces[place : place + 2] = [b"".join(pieces[place : place + 2])]
        elif action == 3:
            cut = random.randrange(len(pieces[place]) + 1)
            pieces[place : place + 1] = [pieces[place][:cut], pieces[place][cut:]]
        elif action == 4:
            pieces[place] = damage(pieces[place], random)
        else:
            pieces[place] = _change(pieces[place], action, random)
    return MARK.join(pieces)


def _change(request: bytes, action: int, random: Random) -> bytes:
    """Another first line, another header more or less, other sizes of chunks or trailers."""
    start, end, body = request.partition(b"\r\n\r\n")
    first, *lines = start.split(b"\r\n")
    if action == 5:
        words = first.split(b" ")
        known = (METHODS, TARGETS, VERSIONS)
        which = random.randrange(3)
        words[which : which + 1] = [random.choice(known[which])]
        first = b" ".join(words)
    elif action == 6 or not lines:
        lines.insert(random.randrange(len(lines) + 1), random.choice(LINES))
    elif action == 7:
        lines[random.randrange(len(lines))] = random.choice(LINES)
    elif b"0\r\n" in body:
        before, _, after = body.rpartition(b"0\r\n")
        body = (
            before
            + random.choice([b"0\r\n", random.choice(SIZES) + b"\r\n"])
            + random.choice(TRAILERS)
            + b"\r\n"
            + after
        )
    return b"\r\n".join([first, *lines]) + end + body
