"""``python -m benchmarks.reliability.faulty_server FAULT serve ...``: ``bnserve`` with one mechanism taken away.

Measurements run against such a server to show that they can fail.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path

from benchmarks.reliability import model_faults, request_faults

FAULT_NAME = "BNSERVE_INJECTED_FAULT"
"""The variable that tells the programs that a server starts which fault to inject."""
FAULTS: dict[str, Callable[[], None]] = {
    "bare-errors": request_faults.bare_errors,
    "batch-bits": model_faults.batch_bits,
    "endless-frames": request_faults.endless_frames,
    "endless-queue": request_faults.endless_queue,
    "leak": request_faults.leak,
    "mixed-versions": model_faults.mixed_versions,
    "log-tokens": request_faults.log_tokens,
    "no-cap": request_faults.no_cap,
    "no-drain": request_faults.no_drain,
    "no-timers": request_faults.no_timers,
    "no-verification": model_faults.no_verification,
    "no-watch": request_faults.no_watch,
    "open-files": request_faults.open_files,
    "timeout-restarts": request_faults.timeout_restarts,
    "prefix-compare": request_faults.prefix_compare,
    "reload-on-loop": model_faults.reload_on_loop,
    "room-to-the-end": request_faults.room_to_the_end,
    "trailers-as-headers": request_faults.trailers_as_headers,
    "unpickle-bodies": request_faults.unpickle_bodies,
}


def main() -> int:
    """Inject the fault, then do what ``bnserve`` does."""
    fault, *arguments = sys.argv[1:]
    FAULTS[fault]()
    os.environ[FAULT_NAME] = fault
    sys.path.insert(0, str(Path(__file__).parent / "injecting"))  # which the supervisor gets from this process
    from bnserve_service.cli import main as bnserve

    return bnserve(arguments)


if __name__ == "__main__":
    sys.exit(main())
