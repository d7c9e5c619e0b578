"""Memory of a server by its number of worker processes, and what a server costs that shares nothing.

    python -m benchmarks.worker_memory [--workers 1 2 4 8] [--requests 50]

One line for each number: the processes, their memory that no file backs (anonymous and shared memory; pages that
several processes share are counted in parts, as the kernel does in ``smaps_rollup``), the part of it that is one
worker's own, and what as many servers of one process would take. Measured when each worker has answered requests.
"""

from __future__ import annotations

import argparse
import http.client
import json
from pathlib import Path

from benchmarks.reliability.serving import Server, serving

QUESTION = json.dumps(
    {
        "parameters": {
            "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0,
            "distance_mpc": 40.0, "inclination": 2.5, "total_mass": 2.76,
        },
        "grid": {"f_min": 20, "f_max": 2048, "delta_f": 1},
    }
)  # fmt: skip
MIB = 1024.0


def fields(pid: int) -> dict[str, float]:
    """The kernel's summary of a process' memory, in MiB."""
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()[1:]
    return {name.rstrip(":"): float(value) / MIB for name, value, *_ in map(str.split, lines)}


def memory(pid: int) -> float:
    """What no file backs, in MiB; what is shared counts in part."""
    found = fields(pid)
    return found["Pss_Anon"] + found["Pss_Shmem"]


def ask(server: Server, connections: int, requests: int) -> None:
    """Ask on so many connections at the same time, so that every worker has some."""
    callers = [http.client.HTTPConnection(*server.address) for _ in range(connections)]
    for number in range(requests * connections):
        caller = callers[number % connections]
        caller.request("POST", "/v1/models/default/waveforms", QUESTION, {"content-type": "application/json"})
        answer = caller.getresponse()
        answer.read()
        assert answer.status == 200, answer.status
    for caller in callers:
        caller.close()


def measure(workers: int, requests: int) -> tuple[int, float, float]:
    """Processes, memory of all of them, and the least that belongs to one alone; MiB."""
    with serving("--workers", str(workers), "--workers-threads", "1") as server:
        ask(server, 4 * workers, requests)
        processes = server.processes()
        own = min(fields(pid)["Private_Dirty"] for pid in processes[1:] or processes)
        return len(processes), sum(memory(pid) for pid in processes), own


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2, 4, 8])
    parser.add_argument("--requests", type=int, default=50, help="on each of four connections for each worker")
    options = parser.parse_args()
    _, alone, _ = measure(1, options.requests)
    print("| workers | processes | memory, MiB | a worker's own, MiB | servers of one process, MiB |")
    print("|--:|--:|--:|--:|--:|")
    for workers in options.workers:
        processes, together, own = measure(workers, options.requests)
        print(f"| {workers} | {processes} | {together:.0f} | {own:.0f} | {workers * alone:.0f} |")


if __name__ == "__main__":
    main()
