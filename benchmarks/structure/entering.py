"""Which modules run when something warm is done: what somebody who reads its way has to open."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

from bnserve_service import Settings, create_app
from bnserve_service.process.listening import address_of, listen_tcp
from bnserve_service.server import BnserveServer
from tests.architecture.rooms import ROOMS


class Entered:
    """Records the modules of the product whose functions are called, in all threads that begin after it was made."""

    def __init__(self) -> None:
        self._files: set[str] = set()
        self._records = False
        threading.setprofile(self._see)

    def _see(self, frame: FrameType, event: str, _: Any) -> None:
        if self._records and event == "call":
            self._files.add(frame.f_code.co_filename)

    def during(self, action: Callable[[], Any]) -> set[str]:
        """The modules that ``action`` enters, here and in the other threads."""
        self._files = set()
        sys.setprofile(self._see)
        self._records = True
        try:
            action()
        finally:
            self._records = False
            sys.setprofile(None)
        return {name for path in self._files if (name := _module_name(Path(path)))}


def _module_name(path: Path) -> str:
    parts = path.with_suffix("").parts
    found = [number for number, part in enumerate(parts) if part in ROOMS.values()]
    return ".".join(parts[found[-1] :]).removesuffix(".__init__") if found else ""


@contextmanager
def server_here() -> Iterator[str]:
    """A server of one process in a thread of this one; its address."""
    app = create_app(Settings(port=0), wait_for_models=False)
    with listen_tcp("127.0.0.1", 0) as listener:
        server = BnserveServer(app, lambda line: None)
        thread = threading.Thread(target=server.run, args=(listener,), kwargs={"with_signals": False})
        thread.start()
        try:
            server.ready.wait()
            yield address_of(listener)
        finally:
            server.stop_from_thread()
            thread.join()
