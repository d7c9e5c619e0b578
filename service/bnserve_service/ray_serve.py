"""The service on a Ray cluster: ``serve run bnserve_service.ray_serve:app``. Needs the extra ``ray``.

Every replica is the same application that ``bnserve serve`` runs, so answers have the same bits. Ray's proxies stand in
front of it, in place of our own connection handling: they read a request in full before a replica sees it.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, Field
from ray import serve
from ray.serve import Application
from ray.serve.config import AutoscalingConfig
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from bnserve_service.app import Application as BnserveApplication
from bnserve_service.app import create_app
from bnserve_service.settings import ANY_HOST, Settings, load_settings

ONGOING = 256
"""Requests that one replica is given at the same time; its own queue is bounded and refuses what does not fit."""
QUEUED = 1024
"""Requests that a proxy holds while every replica has its :data:`ONGOING`; more are refused with 503."""


class Arguments(BaseModel):
    """What may be said on the command line, as in ``serve run bnserve_service.ray_serve:app max_replicas=8``."""

    model_config = ConfigDict(extra="forbid")

    config: Path | None = None
    """Settings of the service, a TOML file, read where the command runs; how it listens is Ray's business."""
    settings: dict[str, Any] = Field(default_factory=dict)
    """Single settings, which count more (in the configuration file of ``serve deploy``)."""
    min_replicas: int = Field(default=2, ge=1)
    max_replicas: int = Field(default=8, ge=1)
    target_requests: float = Field(default=16.0, gt=0)
    """Requests waiting or running in each replica that autoscaling aims at."""
    cpus: float = Field(default=1.0, gt=0)
    """Of each replica, which starts as many worker threads."""


class PicklableBodies:
    """Ray pickles what an application sends, which large answers, being views of arrays, do not allow.

    Parameters
    ----------
    inner
        The application.
    """

    def __init__(self, inner: ASGIApp) -> None:
        self._inner = inner

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve, every body as ``bytes``."""

        async def send_bytes(message: Message) -> None:
            body = message.get("body", b"")
            await send(message if isinstance(body, bytes) else {**message, "body": bytes(body)})

        await self._inner(scope, receive, send_bytes)


@serve.ingress()
class Replica:
    """One replica: its application, and what Ray asks it about its health."""

    def __init__(self, settings: Settings) -> None:
        self._app: BnserveApplication = create_app(settings)

    def __serve_build_asgi_app__(self) -> ASGIApp:
        """What Ray calls for the application; its start-up, the loading of models, follows."""
        return PicklableBodies(self._app)

    async def check_health(self) -> None:
        """Raise what the ready path would say; Ray replaces a replica that raises several times in a row."""
        reason = self._app.parts.health.reason_unready()
        if reason is not None:
            raise reason


def app(arguments: Arguments) -> Application:
    """Build the Ray Serve application.

    Raises
    ------
    SettingsInvalid
        A setting that is unknown or impossible.
    """
    threads = {"threads": max(1, math.floor(arguments.cpus))}
    settings = load_settings(arguments.config, threads | arguments.settings)
    if not settings.allowed_hosts:  # Ray listens, on addresses of its own: those of the settings mean nothing here
        settings = settings.model_copy(update={"allowed_hosts": (ANY_HOST,)})
    deployment = serve.deployment(
        name="bnserve",
        max_ongoing_requests=ONGOING,
        max_queued_requests=QUEUED,
        autoscaling_config=AutoscalingConfig(
            min_replicas=arguments.min_replicas,
            max_replicas=max(arguments.min_replicas, arguments.max_replicas),
            target_ongoing_requests=arguments.target_requests,
            upscale_delay_s=10.0,
            downscale_delay_s=300.0,
        ),
        ray_actor_options={"num_cpus": arguments.cpus},
        health_check_period_s=5.0,
        health_check_timeout_s=10.0,
        graceful_shutdown_wait_loop_s=1.0,
        graceful_shutdown_timeout_s=30.0,
    )
    return deployment(Replica).bind(settings)
