"""The floor of HTTP in Python: a bare uvicorn that reads a request and answers with bytes allocated before.

python -m benchmarks.bare_server --port 9000 4832 ...       # POST /4832 is answered by 4,832 bytes
"""

from __future__ import annotations

import argparse
from typing import Any

import uvicorn


class BareApplication:
    """An ASGI application that does nothing.

    Parameters
    ----------
    sizes:
        Of the answers, in bytes; the path of a request is one of them.
    """

    def __init__(self, sizes: list[int]) -> None:
        self._answers = {f"/{size}": bytes(size) for size in sizes}

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        """Answer one request."""
        if scope["type"] != "http":
            return
        while (await receive()).get("more_body"):
            pass
        body = self._answers[scope["path"]]
        headers = [(b"content-length", b"%d" % len(body))]
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        await send({"type": "http.response.body", "body": body})


def main() -> None:
    """Serve until told to stop."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.bare_server", description=__doc__.splitlines()[0])
    parser.add_argument("--port", type=int, default=9000)
    parser.add_argument("sizes", type=int, nargs="+", metavar="BYTES")
    options = parser.parse_args()
    uvicorn.run(
        BareApplication(options.sizes),
        port=options.port,
        log_level="error",
        access_log=False,
        lifespan="off",
        timeout_keep_alive=3600,  # between two of its turns in a shuffled run there may be minutes
    )


if __name__ == "__main__":
    main()
