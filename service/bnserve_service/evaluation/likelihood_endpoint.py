"""``POST /v1/models/{name}[/versions/{version}]/likelihoods/{sha256}``."""

from __future__ import annotations

from starlette.types import Receive, Scope, Send

from bnserve_service.evaluation.endpoint import answer_headers
from bnserve_service.evaluation.likelihoods import LikelihoodService, pack
from bnserve_service.evaluation.waiting import wait_for
from bnserve_service.http.answers import send_answer
from bnserve_service.http.body import BodyReader
from bnserve_service.http.front import context_of
from bnserve_service.http.requests import answer_media_type, request_media_type
from bnserve_service.settings import Settings

PATHS = ("/v1/models/{name}/likelihoods/{sha256}", "/v1/models/{name}/versions/{version}/likelihoods/{sha256}")


class LikelihoodEndpoint:
    """An ASGI application for the likelihood paths.

    Parameters
    ----------
    service:
        The use case.
    settings:
        Limits of size.
    bodies:
        Reads the bodies.
    """

    def __init__(self, service: LikelihoodService, settings: Settings, bodies: BodyReader) -> None:
        self._service = service
        self._settings = settings
        self._bodies = bodies

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Evaluate one request."""
        context = context_of(scope)
        path = scope["path_params"]
        media_type = request_media_type(context.headers)
        answer_type = answer_media_type(context.headers, preferred=media_type)
        deadline = context.deadline
        model, sha256 = (path["name"], path.get("version")), path["sha256"].lower()
        with self._bodies.of(context) as incoming:
            body = await incoming.read(receive, self._settings.body_limit(media_type))
            context.request_digest = await self._service.digest(body)
            question = await self._service.ask(context.owner, model, sha256, body, media_type)
            del body
        with context.paying(len(question.batch)):
            jobs = self._service.submit(question, deadline, context.owner)
            pieces = await wait_for(jobs, receive, self._service.withdraw)
        packed = pack(question, pieces, answer_type)
        await send_answer(send, 200, answer_headers(packed, answer_type, jobs[0].submitted), packed.parts)
