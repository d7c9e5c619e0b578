"""Whether the port is free, and whether a server that is there answers rightly."""

from __future__ import annotations

import json
import re
import statistics
import time
from email.utils import parsedate_to_datetime
from typing import Any

import numpy as np

from bnserve_protocol import InvalidRequest, ParametersWithExtrinsic, __version__, printable
from bnserve_protocol.wire import content_digest
from bnserve_service.bench.load import Target
from bnserve_service.doctor.asking import Answer, NoAnswer, ask
from bnserve_service.doctor.encryption import on_the_way
from bnserve_service.doctor.findings import Findings, fault, looking, ok, warning
from bnserve_service.process.listening import CannotListen, listen_tcp
from bnserve_service.settings import Settings
from bnserve_store import ModelStore

PROBE_SECONDS = 2.0
"""Whoever has the port may say nothing at all."""
CLOCK_SECONDS, FAR_SECONDS = 2.0, 60.0
"""Dates of HTTP are whole seconds; from the second on, logs and certificates are wrong, too."""
SLOW_SECONDS = 0.1
"""A round trip longer than that, and a sampler waits for the network more than for waveforms."""
CALLS = 20
QUESTION = {name: getattr(ParametersWithExtrinsic.gw170817(), name) for name in (
    "mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination", "total_mass",
)}  # fmt: skip
_NAME = re.compile(r"[A-Za-z0-9_-]{1,64}/[0-9A-Za-z.+_-]{1,64}")
FREQUENCIES = [50.0, 100.0, 500.0]


def port(settings: Settings) -> Findings:
    """It is free, or who is there."""
    if settings.uds is not None:
        taken = settings.uds.exists() or settings.uds.is_symlink()
        yield ok("socket", f"{settings.uds} is there, and replaced if nobody answers" if taken else "its path is free")
        return
    where = f"{settings.host}:{settings.port}"
    try:
        listen_tcp(settings.host, settings.port).close()
    except CannotListen as error:
        host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(settings.host, settings.host)
        scheme = "https" if settings.speaks_tls else "http"
        there = f"{scheme}://[{host}]:{settings.port}" if ":" in host else f"{scheme}://{host}:{settings.port}"
        if _is_bnserve(there):
            yield warning("port", f"a bnserve answers at {there}", f"look at it with `bnserve doctor --url {there}`, "
                          "or start another with --port 0")  # fmt: skip
        else:
            yield fault("port", error.detail, "`ss -ltnp` names who listens")
    else:
        yield ok("port", f"{where} is free" if settings.port else "a free one will be taken")


def _is_bnserve(url: str) -> bool:
    try:
        return _readiness(ask(Target.parse(url), "/v2/health/ready", seconds=PROBE_SECONDS)) is not None
    except NoAnswer:
        return False


def _readiness(answer: Answer) -> bool | None:
    """Whether a server says that it is ready; None where it is no bnserve."""
    if answer.status == 200 and answer.document().get("ready") is True:
        return True
    problem = answer.headers.get("content-type", "").startswith("application/problem+json")
    return False if problem and answer.status >= 500 else None


def round_trip(url: str, token: str | None, store: ModelStore) -> Findings:
    """A server is there, ready, of our version, has our time and models, lets us in, and gives our numbers.

    Parameters
    ----------
    url
        ``http://host:8000``, ``https://host/prefix`` or ``unix:/path/to/socket``.
    token
        Where the server wants one.
    store
        What its models are compared with.
    """
    target = _target(url, token)
    yield from on_the_way(url, target)
    try:
        before = time.time()
        ready = ask(target, "/v2/health/ready")
        after = time.time()
    except NoAnswer as error:
        yield fault("server", f"{url}: {error.detail}", "start it with `bnserve serve`, or correct --url")
        return
    state = _readiness(ready)
    if state is None:
        yield fault("server", f"what answers at {url} is no bnserve (status {ready.status})", "correct --url; a "
                    "server behind a proxy has its path in the address")  # fmt: skip
    elif not state:
        yield fault("server", f"{url} is there and not ready: {ready.detail()}", _what_unready_means(ready))
    else:
        yield ok("server", f"{url} answers and is ready")
    yield from _clocks(ready, before, after)
    if state is not None:
        yield from _manifest(target, store)
        yield from _latency(target)


def _target(url: str, token: str | None) -> Target:
    """What its parts are; InvalidRequest where it has none."""
    if not url.startswith(("http://", "https://", "unix:")):
        raise InvalidRequest(f"'{url}' is no address of a server; write http://host:8000, https://host or unix:/path.")
    if token is not None and not (token.isascii() and token.isprintable()):
        raise InvalidRequest("the token is no printable ASCII: it was not copied whole")
    try:
        return Target.parse(url, token)
    except ValueError as error:
        raise InvalidRequest(f"'{url}' is no address of a server: {error}") from error


def _what_unready_means(answer: Answer) -> str:
    if answer.document().get("code") == "draining":
        return "it is stopping, as it was told to: wait for the one that replaces it"
    return "wait if it has just been started; else its log says why"


def _clocks(answer: Answer, before: float, after: float) -> Findings:
    try:
        said = parsedate_to_datetime(answer.headers["date"]).timestamp()
    except (KeyError, ValueError):
        yield warning("server clock", "its answers have no date", "ask whoever runs the proxy in front of it")
        return
    off = max(before - 1.0 - said, said - after, 0.0)
    does = "set both clocks by NTP; who is wrong cannot be seen from here"
    says = f"its clock and ours differ by {off:.0f} s"
    if off > FAR_SECONDS:
        yield fault("server clock", says, does)
    elif off > CLOCK_SECONDS:
        yield warning("server clock", says, does)
    else:
        yield ok("server clock", "its clock is ours, to the second")


def _manifest(target: Target, store: ModelStore) -> Findings:
    answer = ask(target, "/v1/manifest")
    if answer.status in (401, 403):
        yield fault("token", answer.detail(), "give one of the server's with --token or $BNSERVE_TOKEN; who runs the "
                    "server makes one with `bnserve tokens new`")  # fmt: skip
        return
    if answer.status != 200:
        yield fault("manifest", answer.detail(), "its log says why")
        return
    if answer.headers.get("content-digest") != content_digest([answer.body]):
        yield fault("digests", "an answer has not the bytes that its Content-Digest is of",
                    "something between here and there changes answers: a proxy?")  # fmt: skip
        return
    yield ok("digests", "an answer has the bytes that its Content-Digest is of")
    yield from _same_version(answer.document())
    models = _models(answer.document())
    for name, version, digest in models:
        yield from _same_model(name, version, digest, store)
    if models:
        yield from looking("waveform", lambda: _evaluation(target, *models[0][:2], store))


def _models(manifest: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Name, version and digest of each; what has not the form of one is left out, and so leads nowhere."""
    listed = manifest.get("models")
    found = [each for each in (listed if isinstance(listed, list) else []) if isinstance(each, dict)]
    named = [tuple(str(each.get(key)) for key in ("name", "version", "digest")) for each in found]
    return [(name, version, digest) for name, version, digest in named if _NAME.fullmatch(f"{name}/{version}")]


def _same_version(manifest: dict[str, Any]) -> Findings:
    software = manifest.get("software")
    theirs = software.get("bnserve") if isinstance(software, dict) else None
    if theirs == __version__:
        yield ok("server version", f"{theirs}, as here")
    else:
        yield warning("server version", f"it is bnserve {printable(str(theirs))[:40]}, and here is {__version__}",
                      "they understand each other; for the same numbers, install the same version")  # fmt: skip


def _same_model(name: str, version: str, digest: str, store: ModelStore) -> Findings:
    if name not in store.names() or version not in store.versions(name):
        return
    if store.manifest(name, version).digest != digest:
        yield fault("server models", f"its {name} {version} is another than the one here: the digests differ",
                    "one name and version stand for two models: publish one of them under another version")  # fmt: skip


def _evaluation(target: Target, name: str, version: str, store: ModelStore) -> Findings:
    from bnserve_surrogate import Model

    body = json.dumps({"parameters": QUESTION, "grid": {"frequencies": FREQUENCIES}}).encode()
    answer = ask(target, f"/v1/models/{name}/versions/{version}/waveforms", body)
    if answer.status != 200:
        yield fault("waveform", f"{name} {version}: {answer.detail()}", "a token needs the scope 'evaluate'")
        return
    theirs = answer.document()["h_plus"]
    plus = np.asarray(theirs["re"], np.float64)[0] + 1j * np.asarray(theirs["im"], np.float64)[0]
    if name not in store.names() or version not in store.versions(name):
        yield ok("waveform", f"{name} {version} answers; there is none here to compare it with")
        return
    ours = Model.load(name, version, store=store).predict(np.array(FREQUENCIES), ParametersWithExtrinsic.gw170817())
    if np.array_equal(plus, ours.plus):
        yield ok("waveform", f"{name} {version} gives the bits of this installation")
    elif np.allclose(plus, ours.plus, rtol=1e-9, atol=0.0):  # what processors with other instructions leave
        yield ok("waveform", f"{name} {version} gives the numbers of this installation, to 1e-9")
    else:
        yield fault("waveform", f"{name} {version} gives other numbers than the one here", "compare `bnserve models "
                    "manifest` with its /v1/manifest")  # fmt: skip


def _latency(target: Target) -> Findings:
    seconds = []
    for _ in range(CALLS):
        started = time.perf_counter()
        ask(target, "/v2/health/live")
        seconds.append(time.perf_counter() - started)
    median = statistics.median(seconds)
    says = f"{1e3 * median:.1f} ms from question to answer, connecting included (median of {CALLS})"
    if median > SLOW_SECONDS:
        yield warning("latency", says, "ask for many waveforms at once, or serve nearer to where you sample")
    else:
        yield ok("latency", says)
