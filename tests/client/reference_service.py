"""A bnserve service in a hundred lines, independent of the real one: what the tests script to misbehave.

``respond`` is a function of a request; it is used behind an httpx transport, behind real sockets
(:mod:`.scripted_server`), and in a process of its own (``python -m tests.client.reference_service``).
"""

import base64
import hashlib
import json
import re
import sys
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import msgspec
import numpy as np

from bnserve_protocol import (
    BnserveError,
    GridUnknown,
    Limits,
    ModelIdentity,
    ModelUnknown,
    NotFound,
    PathUnknown,
    TooLarge,
    Unauthorized,
)
from bnserve_protocol.wire import MSGPACK, GridDigest, Problem, decode_request, encode_answer
from tests.client.reference_model import ReferenceModel

_MODEL_PATH = re.compile(r"/v1/models/([^/]+)/versions/([^/]+)(/waveforms)?")


@dataclass
class Reply:
    status: int
    headers: dict
    body: bytes


@dataclass
class ReferenceService:
    model: ReferenceModel = field(default_factory=ReferenceModel)
    limits: Limits = field(default_factory=Limits)
    labels: dict = field(default_factory=lambda: {"stable": "1.0.0"})
    token: str | None = None
    grids: dict = field(default_factory=dict)
    requests: list = field(default_factory=list)
    """(method, path, headers, evaluated rows) of every request, in order of arrival."""

    def respond(self, method, path, headers, body):
        """A :class:`Reply`; header names are lower case."""
        self.requests.append((method, path, headers, None))
        try:
            if self.token is not None and headers.get("authorization") != f"Bearer {self.token}":
                raise Unauthorized("This service needs a token.")
            status, media_type, answer = self._route(method, path, body)
        except BnserveError as error:
            status, media_type, answer = self._problem(error, headers.get("x-request-id"))
        return Reply(status, tie(body if method != "GET" else None, answer) | {"content-type": media_type}, answer)

    def evaluations(self):
        """Rows of every evaluation."""
        return [rows for _, _, _, rows in self.requests if rows is not None]

    def _route(self, method, path, body):
        if method == "GET" and path == "/v1/limits":
            return 200, "application/json", msgspec.json.encode(self.limits)
        if method == "PUT" and path.startswith("/v1/grids/"):
            return self._keep_grid(path.rpartition("/")[2], body)
        found = _MODEL_PATH.fullmatch(path)
        if found is None:
            raise PathUnknown("There is no such path on this service.")
        name, version, waveforms = found.groups()
        description = self.model.description
        if name != description.name or self.labels.get(version, version) != description.version:
            raise ModelUnknown(f"There is no model '{name}' {version} here; known: {description.name}.")
        if waveforms is None:
            return 200, "application/json", self._describe()
        return 200, MSGPACK, self._evaluate(decode_request(body))

    def _describe(self):
        extra = {"labels": self.labels, "versions": ["1.0.0"], "limits": msgspec.to_builtins(self.limits)}
        return json.dumps(msgspec.to_builtins(self.model.description) | extra).encode()

    def _keep_grid(self, sha256, body):
        self.grids[sha256] = np.frombuffer(body, "<f8")
        return 201, "application/json", json.dumps({"sha256": sha256, "frequencies": len(body) // 8}).encode()

    def _evaluate(self, request):
        grid = request.grid
        if isinstance(grid, GridDigest):
            if grid.sha256 not in self.grids:
                raise GridUnknown("No uploaded grid has that digest.")
            grid = self.grids[grid.sha256]
        if len(request.batch) > self.limits.max_rows:
            raise TooLarge(f"A batch has at most {self.limits.max_rows} rows here; this one has {len(request.batch)}.")
        if len(grid) > self.limits.max_frequencies:
            raise TooLarge(f"A grid has at most {self.limits.max_frequencies} frequencies here.")
        self.requests[-1] = (*self.requests[-1][:3], len(request.batch))
        if request.output == "amplitude_phase":
            curves = self.model.predict_amplitude_phase(grid, request.batch, options=request.options)
            arrays = {"amplitude": curves.amplitude, "phase": curves.phase, "status": curves.status}
        else:
            one = self.model.predict_factored(grid, request.batch, options=request.options, dtype=request.dtype)
            arrays = {"h": one.h, "plus": one.plus, "cross": one.cross, "status": one.status}
        description = self.model.description
        identity = ModelIdentity(name=description.name, version=description.version, digest=description.digest)
        return b"".join(encode_answer(arrays, identity))

    def _problem(self, error, request_id):
        if isinstance(error, NotFound):
            status = 404
        else:
            status = {"too-large": 413, "unauthorized": 401}.get(error.code, 503 if error.retryable else 422)
        problem = Problem.from_error(error, status, request_id)
        return status, "application/problem+json", msgspec.json.encode(problem)


def tie(question, answer):
    """The headers that tie an answer to its bytes and to its question."""
    digest = base64.b64encode(hashlib.sha256(answer).digest()).decode()
    headers = {"content-digest": f"sha-256=:{digest}:", "content-length": str(len(answer))}
    return headers if question is None else headers | {"x-request-digest": hashlib.sha256(question).hexdigest()}


def handler_for(service):
    """Serve ``service`` with the standard library."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def serve(self):
            body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
            headers = {name.lower(): value for name, value in self.headers.items()}
            self.send(service.respond(self.command, self.path, headers, body))

        do_GET = do_POST = do_PUT = serve  # noqa: N815 - the names that http.server looks for

        def send(self, reply):
            head = [f"HTTP/1.1 {reply.status} Status", *(f"{name}: {value}" for name, value in reply.headers.items())]
            self.wfile.write("\r\n".join([*head, "", ""]).encode() + reply.body)

        def log_message(self, *arguments):
            """Nothing: the tests look at ``requests``."""

    return Handler


class QuietServer(ThreadingHTTPServer):
    daemon_threads = True
    disable_nagle_algorithm = True
    request_queue_size = 128

    def handle_error(self, request, client_address):
        """Nothing: peers that break connections are what the tests are about."""


if __name__ == "__main__":
    server = QuietServer(("127.0.0.1", 0), handler_for(ReferenceService()))
    print(server.server_address[1], flush=True)
    sys.stdin.close()
    server.serve_forever()
