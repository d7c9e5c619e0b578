"""``bnserve doctor``: what works here, what does not, and what to do about it."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from bnserve_service.doctor.findings import Finding, Findings
    from bnserve_service.settings import Settings


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "doctor",
        help="say what works here, what does not, and what to do about it",
        description="Look at the installation, the model stores, this machine's limits and clock, the port that a "
        "server would take, and with --url at a server. One line for each finding: ok, warning or fault, and what to "
        "do. Exit code 1 if there is a fault; warnings are none.",
    )
    add = parser.add_argument
    add("--url", metavar="URL", help="also ask this server: http://host:8000, host:8000 or unix:/path/to/socket")
    add("--token", metavar="TOKEN", help="where the server wants one ($BNSERVE_TOKEN or $BNSERVE_TOKEN_FILE)")
    add("--config", type=Path, metavar="FILE", help="settings of the server that is to run here")
    add("--host", help="address that it is to listen on (127.0.0.1)")
    add("--port", type=int, help="port that it is to listen on (8000)")
    add("--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models")
    add("--workers", type=int, metavar="N", help="its worker processes (1)")
    add("--json", action="store_true", help="print one JSON object")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Look, print, count."""
    from bnserve_service.process.system import compute_in_one_thread

    compute_in_one_thread()
    found = []
    for finding in _findings(options):
        found.append(finding)
        if not options.json:
            advice = f" -> {finding.do}" if finding.do else ""
            print(f"{finding.status:8}{finding.what}: {finding.says}{advice}", flush=True)
    faults, warnings = (sum(each.status == status for each in found) for status in ("fault", "warning"))
    if options.json:
        print(json.dumps({"faults": faults, "warnings": warnings, "findings": [asdict(each) for each in found]}))
    else:
        print(f"\n{faults or 'No'} fault{'s' * (faults != 1)}, {warnings or 'no'} warning{'s' * (warnings != 1)}.")
    return 1 if faults else 0


def _findings(options: argparse.Namespace) -> Iterator[Finding]:
    from bnserve_service.doctor import installation, machine
    from bnserve_service.doctor.findings import looking

    checks: list[tuple[str, Callable[[], Findings]]] = [
        ("versions", installation.versions), ("kernels", installation.kernels), ("extras", installation.extras),
        ("open files", machine.open_files), ("clock", machine.clock),
    ]  # fmt: skip
    for what, check in checks:
        yield from looking(what, check)
    settings: list[Settings] = []

    def read() -> Findings:
        from bnserve_service.settings import load_settings

        given = {name: getattr(options, name) for name in ("host", "port", "workers")}
        settings.append(load_settings(options.config, given | {"stores": options.store}))
        yield from ()

    yield from looking("settings", read)
    for each in settings:
        yield from _of_server(options, each)


def _of_server(options: argparse.Namespace, settings: Settings) -> Iterator[Finding]:
    from bnserve_service.cli.places import server_address, token_of_environment
    from bnserve_service.doctor import encryption, installation, machine, server, stores
    from bnserve_service.doctor.findings import looking
    from bnserve_store import ModelStore

    yield from looking("stores", lambda: stores.stores(settings))
    for what, check in (
        ("shared folder", machine.shared_folder), ("memory", machine.memory), ("processors", machine.processors),
        ("packages", installation.wanted), ("certificate", encryption.certificate_files), ("port", server.port),
    ):  # fmt: skip
        yield from looking(what, lambda check=check: check(settings))  # type: ignore[misc]  # a default has no type
    if options.url:
        url, token = server_address(options.url), options.token or token_of_environment()
        store = ModelStore.default(settings.stores)
        yield from looking("server", lambda: server.round_trip(url, token, store))
