"""How long one question takes from the client to a server and back, by each transport, next to the floor.

    python -m benchmarks.client_round_trip                      # starts the server with the shipped model
    python -m benchmarks.client_round_trip --url http://host:8000

Prints medians in microseconds, on the clock and of the client's own processor time, for one waveform on 277 points and
other sizes: this client over plain sockets (in both precisions), over httpx, asynchronously; and below them the floor:
``http.client`` posting the same bytes to the same server, and to a bare uvicorn that answers with as many preallocated
bytes. Everything is measured in one run, in turns. The last line of each size is the processor time of the server for
one answer to this client (where the server was started here).
"""

from __future__ import annotations

import argparse
import asyncio
import http.client
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory
from urllib.parse import urlsplit

import httpx
import numpy as np

from bnserve_client import AsyncModel, Model, ParametersWithExtrinsic
from bnserve_protocol import ParameterBatch
from bnserve_protocol.wire import MSGPACK, WaveformRequest, encode_request
from tests.running_server import free_port, is_ready, running

ONE = ParametersWithExtrinsic.gw170817()
SIZES = ((1, 277), (1, 1000), (256, 277), (64, 10_000), (1, 253_056))
_ENVELOPE = 400

BARE = """
import sys, uvicorn
sizes = {"/" + size: bytes(int(size)) for size in sys.argv[2:]}
async def app(scope, receive, send):
    if scope["type"] != "http":
        return
    while (await receive()).get("more_body"):
        pass
    body = sizes[scope["path"]]
    headers = [(b"content-length", b"%d" % len(body))]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": body})
uvicorn.run(app, port=int(sys.argv[1]), log_level="error", access_log=False, lifespan="off")
"""


def medians(calls: dict[str, Callable[[], object]], repetitions: int) -> dict[str, tuple[float, float]]:
    """Median seconds of each call, on the clock and of this process' own processor time.

    The calls take turns, so that a slow moment of the machine hits all of them.
    """
    seconds: dict[str, list[tuple[float, float]]] = {name: [] for name in calls}
    for _ in range(repetitions):
        for name, call in calls.items():
            begun, worked = time.perf_counter(), time.process_time()
            call()
            seconds[name].append((time.perf_counter() - begun, time.process_time() - worked))
    return {name: tuple(np.median(values, axis=0).tolist()) for name, values in seconds.items()}


def post(connection: http.client.HTTPConnection, path: str, body: bytes) -> bytes:
    """One request with the standard library."""
    connection.request("POST", path, body, {"Content-Type": MSGPACK})
    return connection.getresponse().read()


def measure(url: str, bare_url: str | None, rows: int, points: int, repetitions: int) -> dict[str, tuple[float, float]]:
    """Median seconds of one batch of ``rows`` on ``points`` frequencies, by each way to ask."""
    grid = np.geomspace(20.0, 2000.0, points)
    batch = ParameterBatch.coerce([ONE] * rows)
    body = encode_request(WaveformRequest(batch=batch, grid=grid))
    with ExitStack() as stack:
        model = stack.enter_context(Model.connect(url))
        through_httpx = stack.enter_context(Model.connect(url, transport=httpx.HTTPTransport))
        loop = asyncio.new_event_loop()  # asyncio.Runner would print the answer's numbers into an error nobody sees
        stack.callback(loop.close)
        asynchronous = loop.run_until_complete(AsyncModel.connect(url))
        stack.callback(lambda: loop.run_until_complete(asynchronous.close()))
        direct = http.client.HTTPConnection(urlsplit(url).netloc)
        stack.callback(direct.close)
        path = "/v1/models/default/waveforms"
        calls: dict[str, Callable[[], object]] = {
            "client": lambda: model.predict_batch(grid, batch),
            "client, complex64": lambda: model.predict_batch(grid, batch, dtype="complex64"),
            "client, httpx": lambda: through_httpx.predict_batch(grid, batch),
            "client, asyncio": lambda: loop.run_until_complete(asynchronous.predict_batch(grid, batch)),
            "http.client, no checks": lambda: post(direct, path, body),
        }
        if bare_url is not None:
            bare = http.client.HTTPConnection(urlsplit(bare_url).netloc)
            stack.callback(bare.close)
            calls["floor"] = lambda: post(bare, f"/{answer_bytes(rows, points)}", body)
        medians(calls, 5)
        return medians(calls, repetitions)


def server_cost(process: int, url: str, rows: int, points: int, repetitions: int) -> float:
    """Seconds of processor time that a server process spends on one answer to this client."""
    grid, batch = np.geomspace(20.0, 2000.0, points), ParameterBatch.coerce([ONE] * rows)
    with Model.connect(url) as model:
        for _ in range(5):
            model.predict_batch(grid, batch)
        begun = processor_seconds(process)
        for _ in range(repetitions):
            model.predict_batch(grid, batch)
        return (processor_seconds(process) - begun) / repetitions


def processor_seconds(process: int) -> float:
    """Of all threads of a process so far, as the kernel's scheduler counts them."""
    threads = Path(f"/proc/{process}/task").iterdir()
    return sum(int((thread / "schedstat").read_text().split()[0]) for thread in threads) / 1e9


def answer_bytes(rows: int, points: int) -> int:
    """About the size of a factored complex128 answer."""
    return rows * (points * 16 + 25) + _ENVELOPE


def main() -> None:
    """Measure and print a table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--url", help="a running server; by default one is started here")
    parser.add_argument("--repetitions", type=int, default=1000)
    options = parser.parse_args()
    with ExitStack() as stack:
        url, server = options.url, None
        if url is None:
            port = free_port()
            url = f"http://127.0.0.1:{port}"
            log = Path(stack.enter_context(TemporaryDirectory())) / "server.log"
            command = [sys.executable, "-m", "bnserve_service", "serve", "--port", str(port)]
            server = stack.enter_context(running(command, log, lambda: is_ready(url)))
        bare_port = free_port()
        sizes = [str(answer_bytes(rows, points)) for rows, points in SIZES]
        bare = subprocess.Popen([sys.executable, "-c", BARE, str(bare_port), *sizes])
        stack.callback(bare.wait)
        stack.callback(bare.terminate)
        time.sleep(2.0)
        print(f"{'batch':<13} {'way':<24} {'round trip':>10} {'client CPU':>10} {'x floor':>10}   (medians, us)")
        for rows, points in SIZES:
            repetitions = max(30, options.repetitions // max(1, rows * points // 2000))
            found = measure(url, f"http://127.0.0.1:{bare_port}", rows, points, repetitions)
            for name, (elapsed, worked) in found.items():
                times_floor = elapsed / found["floor"][0]
                numbers = f"{1e6 * elapsed:>10.0f} {1e6 * worked:>10.0f} {times_floor:>10.1f}"
                print(f"{rows:>4} x {points:<6} {name:<24} {numbers}")
            if server is not None:
                cost = server_cost(server.pid, url, rows, points, repetitions)
                print(f"{rows:>4} x {points:<6} {'processor of the server':<24} {1e6 * cost:>10.0f}")


if __name__ == "__main__":
    main()
