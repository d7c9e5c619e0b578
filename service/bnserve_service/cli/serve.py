"""``bnserve serve``: run the service."""

from __future__ import annotations

import argparse
import os
from pathlib import Path
from typing import Any

from bnserve_service.process.output import announce
from bnserve_service.process.system import compute_in_one_thread
from bnserve_service.telemetry.log import start_logging


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser: argparse.ArgumentParser = subparsers.add_parser(
        "serve",
        help="run the service",
        description="Run the service until SIGTERM or Ctrl-C; it finishes what is under way then. It prints where it "
        "listens, and when it is ready.",
    )
    add = parser.add_argument
    add("--config", type=Path, metavar="FILE", help="settings in TOML; options given here override it")
    add("--host", help="address to listen on (127.0.0.1)")
    add("--port", type=int, help="port to listen on (8000); 0 takes a free one and prints it")
    add("--uds", type=Path, metavar="PATH", help="listen on a Unix socket instead")
    add("--uds-mode", metavar="MODE", help="who may connect to it, as chmod says it: 660 (what the umask leaves)")
    add("--uds-group", metavar="GROUP", help="its group")
    add("--allowed-host", action="append", metavar="HOST", help="a host that the server is called by, beside localhost "
        "(repeatable); * for every one")  # fmt: skip
    add("--tls-cert", type=Path, metavar="FILE", help="speak TLS, with this certificate (PEM, the server's own first)")
    add("--tls-key", type=Path, metavar="FILE", help="its private key, without a password (PEM)")
    add("--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models")
    add("--model", action="append", metavar="NAME[@VERSION]", help="serve only this model (repeatable)")
    add("--metrics-port", type=int, metavar="PORT", help="serve /metrics on a port of its own, without a token")
    add("--metrics-uds", type=Path, metavar="PATH", help="or /metrics and /v1/reload on a Unix socket for operators")
    add("--metrics-host", metavar="HOST", help="address of the metrics port (127.0.0.1)")
    add("--workers", type=int, metavar="N", help="worker processes (1); with more, one that dies or hangs is replaced")
    add("--workers-threads", type=int, metavar="N", help="threads of each worker (its part of the processors)")
    add("--drain-grace", type=float, metavar="SECONDS", help="so long requests are still answered after SIGTERM (2)")
    add("--token", action="append", metavar="TOKEN", help="require this bearer token (repeatable); visible in the "
        "process list: on shared machines prefer --token-file or hashed tokens in the settings")  # fmt: skip
    add(
        "--token-file",
        type=Path,
        metavar="FILE",
        help="require one of the bearer tokens in this file, one a line; read again when it changes",
    )
    add("--access-log", action="store_true", default=None, help="write one line per request")
    add("--otlp-endpoint", metavar="URL", help="tell this collector of OpenTelemetry of requests, as spans")
    add("--log-format", choices=("text", "json"), help="the log for people, or in lines of JSON (text)")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Serve until told to stop."""
    compute_in_one_thread()
    from bnserve_service.process.given_sockets import GivenSockets
    from bnserve_service.settings import load_settings

    start_logging(options.log_format or "text")
    settings = load_settings(options.config, _overrides(options))
    start_logging(settings.log_format)
    given = GivenSockets.of(os.environ)
    if given is not None:
        settings = type(settings).model_validate(settings.model_dump() | given.settings())
    if settings.workers > 1:
        from bnserve_service.models.loading import loader_of
        from bnserve_service.models.registry import Registry
        from bnserve_service.wanted_packages import check_packages

        # What is not there is said before anybody can connect.
        loader_of(settings, Registry()).list_source()
        check_packages(settings)
        from bnserve_service.workers.supervisor import become_supervisor

        become_supervisor(settings, announce, given)
    from bnserve_service.process.allocator import forget_what_is_imported, keep_freed_memory
    from bnserve_service.server import serve

    keep_freed_memory()
    forget_what_is_imported()

    def tell(line: str) -> None:
        forget_what_is_imported()  # again: until it is ready, it imports and loads, and all of that stays
        announce(line)

    serve(settings, tell, given)
    return 0


def _overrides(options: argparse.Namespace) -> dict[str, Any]:
    return {
        "host": options.host,
        "port": options.port,
        "uds": options.uds,
        "uds_mode": options.uds_mode,
        "uds_group": options.uds_group,
        "allowed_hosts": options.allowed_host,
        "tls_cert": options.tls_cert,
        "tls_key": options.tls_key,
        "stores": options.store,
        "models": options.model,
        "metrics_port": options.metrics_port,
        "metrics_host": options.metrics_host,
        "metrics_uds": options.metrics_uds,
        "workers": options.workers,
        "threads": options.workers_threads,
        "drain_grace": options.drain_grace,
        "tokens": _tokens(options) or None,
        "token_list": options.token_file,
        "access_log": options.access_log,
        "log_format": options.log_format,
        "otlp_endpoint": options.otlp_endpoint,
    }


def _tokens(options: argparse.Namespace) -> list[Any]:
    from bnserve_service.admission.tokens import Token

    return [Token.of(text, name=f"token-{number}") for number, text in enumerate(options.token or (), start=1)]
