"""``POST /v1/models/{name}[/versions/{version}]/waveforms``."""

from __future__ import annotations

from starlette.types import Receive, Scope, Send

from bnserve_service.admission.queue import Job
from bnserve_service.evaluation.service import WaveformService
from bnserve_service.evaluation.waiting import wait_for
from bnserve_service.evaluation.waveforms import Packed, Question
from bnserve_service.http.answers import send_answer
from bnserve_service.http.body import BodyReader
from bnserve_service.http.front import context_of
from bnserve_service.http.requests import answer_digest, answer_media_type, request_media_type
from bnserve_service.settings import Settings

PATHS = ("/v1/models/{name}/waveforms", "/v1/models/{name}/versions/{version}/waveforms")


class WaveformEndpoint:
    """An ASGI application for the waveform paths.

    Parameters
    ----------
    service:
        The use case.
    settings:
        Limits of size.
    bodies:
        Reads the bodies.
    """

    def __init__(self, service: WaveformService, settings: Settings, bodies: BodyReader) -> None:
        self._service = service
        self._settings = settings
        self._bodies = bodies

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Evaluate one request."""
        context = context_of(scope)
        parameters = scope["path_params"]
        media_type = request_media_type(context.headers)
        answer_type = answer_media_type(context.headers, preferred=media_type)
        digest = answer_digest(context.headers)
        deadline = context.deadline
        with self._bodies.of(context) as incoming:
            body = await incoming.read(receive, self._settings.body_limit(media_type))
            self._service.foresee(len(body), deadline, context.owner)
            context.request_digest = await self._service.digest(body)
            question = await self._service.ask(
                parameters["name"], parameters.get("version"), body, media_type, answer_type, digest
            )
            self._service.learn(len(body), question, context.owner)
            del body
        with context.paying(len(question.batch)), self._service.reserve(question, context.owner) as give_back:
            job = self._service.submit(question, deadline, context.owner)
            packed = await self._wait(job, receive)
            headers = answer_headers(packed, answer_type, job.submitted)
            await send_answer(send, 200, headers, packed.parts, give_back)

    async def _wait(self, job: Job[Question, Packed], receive: Receive) -> Packed:
        if job.quick:
            return await job.result
        [packed] = await wait_for([job], receive, self._service.withdraw)
        return packed


def answer_headers(packed: Packed, media_type: str, submitted: float) -> list[tuple[bytes, bytes]]:
    """The headers of an evaluated answer, with the time that its parts took."""
    timing = "queue;dur={:.3f}, eval;dur={:.3f}, pack;dur={:.3f}".format(
        *(1e3 * seconds for seconds in (packed.started - submitted, packed.evaluated, packed.packed))
    )
    return [
        (b"content-type", media_type.encode()),
        (b"content-length", b"%d" % packed.length),
        (b"content-digest", packed.digest),
        (b"server-timing", timing.encode()),
    ]
