"""Nobody gets in without a token, and no token gets out.

A server with tokens is asked with right, wrong, truncated, lengthened, re-cased and missing ones, in every form that a
header allows, on every path; then its log, its metrics and its error answers are searched for any of them.
"""

from __future__ import annotations

import hashlib
import random
import secrets
from collections.abc import Iterator

from benchmarks.reliability.asking import exchange
from benchmarks.reliability.load import waveforms_request
from benchmarks.reliability.outcome import Log, Outcome
from benchmarks.reliability.serving import Server, serving
from bnserve_service.bench.load import Target

MECHANISM = """The server knows SHA-256 digests alone and compares them in constant time, all of them for every request,
before anything else of the request is looked at. Nothing of the header is ever logged, counted or repeated."""
BAR = "401 and 403 where they belong, in all cases; nothing of a token in log, metrics or answers"
INJECTED_FAULTS = {
    "prefix-compare": "a token is compared up to the length of what was sent",
    "log-tokens": "the access log shows who asked with what",
}

SCOPES = ("evaluate", "upload", "admin")
NEEDS = {
    ("GET", "/v1/models"): None,
    ("GET", "/v1/limits"): None,
    ("POST", "/v1/models/default/waveforms"): "evaluate",
    ("PUT", f"/v1/grids/{'0' * 64}"): "upload",
    ("DELETE", f"/v1/analyses/{'0' * 64}"): "upload",
    ("GET", "/metrics"): "admin",
    ("POST", "/v1/reload"): "admin",
}
"""The scope that a token must have."""
PATHS = ("/v1/models", "/v1/models/default", "/v1/limits", "/metrics", "/v1/manifest", "/v1/none")
PUBLIC = ("/v2/health/live", "/v2/health/ready", "/openapi.json", "/docs", "/")


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes a minute."""
    draw = random.Random(1)
    texts = {scope: secrets.token_urlsafe(32) for scope in SCOPES}
    right = texts["evaluate"]
    tokens = [
        {"name": scope, "sha256": hashlib.sha256(text.encode()).hexdigest(), "scopes": [scope]}
        for scope, text in texts.items()
    ]
    wrong = list(_wrong_headers(right, draw, 20 if short else 1000))
    with serving("--model", "default", "--access-log", injected=injected, tokens=tokens) as server:
        refused = [
            s for s in (_evaluate(server, f"Bearer {right}"), _evaluate(server, f"bearer  {right} ")) if s != 200
        ]
        refused += [status for path in PUBLIC if (status := _ask(server, "GET", path, None)) != 200]
        let_in = [header for header in wrong if _evaluate(server, header) != 401]
        on_paths = [path for path in PATHS for header in wrong[:20] if _ask(server, "GET", path, header) != 401]
        log(f"{len(wrong)} wrong headers tried, {len(let_in)} let in, on other paths {len(on_paths)}")
        misplaced = _wrong_scopes(server, texts)
        log(f"wrong decisions about scopes: {misplaced}")
        shown = _searched(server, wrong, f"Bearer {texts['admin']}")
    secrets_used = {*texts.values(), *(_secret(each) for each in wrong)}
    leaked = sum(secret in shown for secret in secrets_used if len(secret) >= 12)
    figures = {
        "wrong headers": len(wrong),
        "requests": len(wrong) + 20 * len(PATHS),
        "let in": len(let_in) + len(on_paths),
        "right ones refused": len(refused),
        "scopes tried": len(texts) * len(NEEDS),
        "wrong decisions about scopes": len(misplaced),
        "tokens found in log, metrics, answers": leaked,
        "bytes searched": len(shown),
    }
    wrongly = len(let_in) + len(on_paths) + len(refused) + len(misplaced)
    summary = f"{len(wrong):,} wrong tokens: {wrongly} wrong decisions, {leaked} found in log, metrics or answers"
    return Outcome(figures, wrongly == leaked == 0, summary)


def _wrong_scopes(server: Server, texts: dict[str, str]) -> list[str]:
    """What a token of one scope may do and should not, or may not and should."""
    wrong = []
    for scope, text in texts.items():
        for (method, path), needed in NEEDS.items():
            status = _ask(server, method, path, f"Bearer {text}")
            if status in (0, 401) or (status == 403) is not (needed not in (None, scope)):
                wrong.append(f"{scope} {method} {path}: {status}")
    return wrong


def _wrong_headers(right: str, draw: random.Random, count: int) -> Iterator[str | None]:
    """Values of ``Authorization`` that must not be let in; None for no such header."""
    yield None
    yield from ("", "Bearer", "Bearer ", "bearer\t", right, f"Basic {right}", f"Bearer{right}", f"Bearer: {right}")
    yield from (f"Bearer {right}{extra}" for extra in ("x", ",", "=", "\u00e9", f" {right}", right))
    yield from (
        f"Bearer {x}" for x in (right[:-1], right[1:], right[::-1], right.swapcase(), f"x{right}", '"' + right + '"')
    )
    yield f"Bearer {hashlib.sha256(right.encode()).hexdigest()}"  # what the settings know
    yield "Bearer " + "x" * 10_000
    for _ in range(count):
        place = draw.randrange(len(right))
        letter = draw.choice([c for c in "abcdefXYZ0189-_" if c != right[place]])
        cut = right[: draw.randrange(len(right))]
        yield f"Bearer {draw.choice([right[:place] + letter + right[place + 1 :], cut])}"


def _secret(header: str | None) -> str:
    return (header or "").strip().rpartition(" ")[2]


def _evaluate(server: Server, authorization: str | None) -> int:
    return exchange(server.address, _with(waveforms_request(server.url), authorization)).status


def _ask(server: Server, method: str, path: str, authorization: str | None) -> int:
    request = Target.parse(server.url).request(path, b"", {}, method)
    return exchange(server.address, _with(request, authorization)).status


def _with(request: bytes, authorization: str | None) -> bytes:
    first, _, rest = request.partition(b"\r\n")
    extra = b"" if authorization is None else b"Authorization: " + authorization.encode("latin-1") + b"\r\n"
    return first + b"\r\nConnection: close\r\n" + extra + rest


def _searched(server: Server, wrong: list[str | None], right: str) -> str:
    """All that the server has said: its log, its metrics, its answers to some of these."""
    answers = [exchange(server.address, _with(waveforms_request(server.url), header)) for header in wrong[:40]]
    told = [f"{each.headers} {each.body.decode('latin-1')}" for each in answers]
    metrics = exchange(server.address, _with(Target.parse(server.url).request("/metrics", b"", {}, "GET"), right))
    assert metrics.status == 200, "the metrics can be read with the right token"
    return "\n".join([server.log.read_text(), metrics.body.decode(), *told])
