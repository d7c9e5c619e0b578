"""A client that talks to a hostile server: the script of the server is the input of the fuzzer.

A script is a list of HTTP answers with :data:`MARK` between them, one for each request. In an answer, ``DIGEST``,
``ASKED`` and ``LENGTH`` stand for the right values, because a hostile server knows them.
"""

from typing import Any

from bnserve_client._addresses import parse_addresses
from bnserve_client._http1 import encode_request, exchange
from bnserve_client._messages import (
    Conversation,
    HttpResponse,
    LookUp,
    Send,
    Sleep,
    Together,
    TransportFailure,
    explain,
)
from bnserve_client._pinned import connecting
from bnserve_client._settings import Settings
from bnserve_client._waveforms import RemoteModel
from bnserve_protocol import DEFAULT_OPTIONS, BnserveError, ParametersWithExtrinsic
from bnserve_protocol.wire import content_digest, request_digest

MARK = b"\n=====\n"
HEAD = (
    b"HTTP/1.1 %b OK\r\ncontent-type: %b\r\ncontent-digest: DIGEST\r\nx-request-digest: ASKED\r\n"
    b"content-length: LENGTH\r\n\r\n"
)


_PIECES = (2**20, 100, 2**20, 7, 2**20, 1000, 2**20, 1)


class HostileServer:
    """Says what its script says, in pieces of a size that the script decides, and then nothing more."""

    def __init__(self, script: bytes) -> None:
        self._answers = script.split(MARK)
        self._piece = _PIECES[len(script) % len(_PIECES)]

    def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`, as a transport does."""
        steps = exchange(encode_request(send.address, send.request), send.max_bytes)
        said = self._next(send)
        try:
            step = next(steps)
            while True:
                received = 0
                if isinstance(step, memoryview):
                    received = min(self._piece, len(step), len(said))
                    step[:received] = said[:received]
                    said = said[received:]
                step = steps.send(received)
        except StopIteration as finished:
            response, _ = finished.value
            assert len(response.body) <= send.max_bytes
            return response
        except TransportFailure as failure:
            raise explain(failure, send) from failure

    def _next(self, send: Send) -> bytes:
        if not self._answers:
            return b""
        said = self._answers.pop(0)
        body = said.partition(b"\r\n\r\n")[2]
        said = said.replace(b"DIGEST", content_digest([body], "crc32c").encode(), 1)
        said = said.replace(b"ASKED", request_digest(send.request.body).encode(), 1)
        return said.replace(b"LENGTH", b"%d" % len(body), 1)


def hold(conversation: Conversation[Any], server: HostileServer) -> Any:
    """Hold a conversation without waiting."""
    outcome, failure = None, None
    while True:
        try:
            effect = conversation.send(outcome) if failure is None else conversation.throw(failure)
        except StopIteration as finished:
            return finished.value
        outcome, failure = None, None
        try:
            if isinstance(effect, Send):
                outcome = server.send(effect)
            elif isinstance(effect, Together):
                outcome = [hold(each, server) for each in effect.conversations]
            elif isinstance(effect, LookUp):
                outcome = dict.fromkeys(effect.addresses, ("",))
            else:
                assert isinstance(effect, Sleep)
        except BnserveError as error:
            failure = error


def ask(script: bytes, frequencies: Any, parameters: dict[str, float], batch: dict[str, Any]) -> None:
    """Connect, and ask for one waveform and for a batch in pieces: answered in the right shapes, or a named error."""
    server = HostileServer(script)
    settings = Settings(parse_addresses("http://server:1"), retries=2, chunk_samples=2 * len(frequencies), parallel=1)
    model = RemoteModel(settings, hold(connecting(settings, "default", "stable", None), server))
    one = hold(model.predict(frequencies, ParametersWithExtrinsic(**parameters), DEFAULT_OPTIONS, "complex128"), server)
    assert one.plus.shape == one.cross.shape == (len(frequencies),)
    many = hold(model.predict_batch(frequencies, batch, DEFAULT_OPTIONS, "complex128"), server)
    assert many.plus.shape == (len(batch["mass_ratio"]), len(frequencies))
