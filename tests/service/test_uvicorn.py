"""What of the inside of uvicorn we rely on, all of it.

When a test here fails with a new uvicorn, read what it changed of the thing that is named, and adapt
``bnserve_service/http/protocol.py``, where alone it is used.
"""

import ast
import asyncio
import inspect
import re
import socket
from pathlib import Path

import pytest
import uvicorn
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol
from uvicorn.server import ServerState

import bnserve_service
from bnserve_service import Settings
from bnserve_service.http import protocol as ours
from bnserve_service.http.protocol import bounded_protocol

SERVICE = Path(bnserve_service.__file__).parent
METHODS = {
    "connection_made": ["transport"],
    "connection_lost": ["exc"],
    "data_received": ["data"],
    "pause_writing": [],
    "resume_writing": [],
    "on_message_begin": [],
    "on_header": ["name", "value"],
    "on_headers_complete": [],
    "on_body": ["body"],
    "on_message_complete": [],
    "on_response_complete": [],
    "shutdown": [],
    "timeout_keep_alive_handler": [],
    "send_400_response": ["msg"],
    "_unset_keepalive_if_required": [],
}
"""Of its protocol, called or overridden: their parameters."""
ATTRIBUTES = {
    "client", "cycle", "expect_100_continue", "flow", "headers", "loop", "parser", "pipeline", "scheme", "server_state",
    "timeout_keep_alive_task", "transport", "url",
}  # fmt: skip
"""Of its protocol."""
OF_A_CYCLE = {"response_complete", "disconnected", "message_event", "keep_alive"}
"""What it looks at, of a request that is being answered, whoever answers."""
OF_ITS_OWN_CYCLES = {"body", "more_body", "run_asgi"}
SERVER = {
    "capture_signals", "config", "force_exit", "lifespan", "serve", "server_state", "should_exit", "shutdown",
    "started", "startup",
}  # fmt: skip


def used(path, base, own):
    """What a module takes from ``base``: names behind it that are none of its own."""
    found = re.findall(rf"(?<![\w.]){re.escape(base)}\.(\w+)", path.read_text())
    return {name for name in found if name not in own}


def own_names(classes):
    """What our classes define themselves."""
    assigned = re.findall(r"self\.(\w+)(?:: [^=\n]+)? = ", inspect.getsource(ours))
    defined = {name for each in classes for name in (*vars(each), *vars(each).get("__annotations__", ()))}
    return defined | {name for name in assigned if name.startswith("_")}


def test_one_module_knows_its_inside():
    imports = {}
    for path in SERVICE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            if any(name.split(".")[0] == "uvicorn" for name in names):
                imports.setdefault(path.relative_to(SERVICE).as_posix(), set()).update(names)
    inside = {path for path, names in imports.items() if any(name.startswith("uvicorn.") for name in names)}
    assert inside == {"http/protocol.py"}
    assert used(SERVICE / "server.py", "uvicorn", ()) == {"Config"}, "which its documentation describes"


def test_nothing_else_of_it_is_used():
    classes = [each for each in vars(ours).values() if inspect.isclass(each) and each.__module__ == ours.__name__]
    protocols = [each for each in classes if issubclass(each, HttpToolsProtocol)]
    taken = used(Path(ours.__file__), "self", own_names(classes)) | used(Path(ours.__file__), "super()", {"__init__"})
    overridden = {name for each in protocols for name in vars(each) if hasattr(HttpToolsProtocol, name)}
    overridden = {name for name in overridden if not name.startswith("__")}
    assert (taken | overridden) - (SERVER - ATTRIBUTES - METHODS.keys()) == METHODS.keys() | ATTRIBUTES, (
        "write down what is new, and test it here"
    )
    assert used(SERVICE / "server.py", "self._uvicorn", ("acceptor", "connection")) <= SERVER


@pytest.mark.parametrize("name", METHODS)
def test_its_methods_are_called_as_we_call_and_override_them(name):
    method = getattr(HttpToolsProtocol, name, None)
    assert method is not None, f"uvicorn {uvicorn.__version__} has no HttpToolsProtocol.{name} any more"
    assert list(inspect.signature(method).parameters)[1:] == METHODS[name], f"HttpToolsProtocol.{name} takes others"


def test_it_looks_at_nothing_of_an_answer_but_what_the_fast_path_has():
    looked_at = set(re.findall(r"cycle\.(\w+)", inspect.getsource(HttpToolsProtocol)))
    assert looked_at == OF_A_CYCLE | OF_ITS_OWN_CYCLES
    assert {name for name in vars(ours._FastCycle) if not name.startswith("__")} == OF_A_CYCLE


def test_its_server_is_started_and_stopped_as_we_do_it():
    server = uvicorn.Server(uvicorn.Config(lambda *_: None))
    server.lifespan = None  # made by serve()
    assert not {name for name in SERVER if not hasattr(server, name)}
    for name in ("startup", "shutdown"):
        assert list(inspect.signature(getattr(uvicorn.Server, name)).parameters) == ["self", "sockets"]
    assert {"connections", "default_headers", "total_requests"} <= vars(ServerState()).keys()
    assert STATUS_LINE[200] == b"HTTP/1.1 200 OK\r\n"


async def connected(protocol):
    """A connection of it, and the peer's end."""
    near, far = socket.socketpair()
    near.setblocking(False)
    await asyncio.get_running_loop().connect_accepted_socket(lambda: protocol, near)
    return far


GET = b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"


@pytest.mark.parametrize("made", [HttpToolsProtocol, bounded_protocol(Settings())], ids=["uvicorn's", "ours"])
def test_a_connection_passes_through_the_states_that_we_go_by(made):
    async def live():
        proceed = asyncio.Event()

        async def app(scope, receive, send):
            await proceed.wait()
            await send({"type": "http.response.start", "status": 200, "headers": [(b"content-length", b"0")]})
            await send({"type": "http.response.body", "body": b""})

        state = ServerState()
        protocol = made(config=uvicorn.Config(app, log_config=None), server_state=state, app_state={})
        with await connected(protocol):
            assert (protocol.cycle, protocol.timeout_keep_alive_task, list(protocol.pipeline)) == (None, None, [])
            assert protocol in state.connections
            protocol.data_received(GET)
            first = protocol.cycle
            assert [first.response_started, first.response_complete, first.disconnected] == [False] * 3
            assert first.keep_alive
            assert (protocol.url, protocol.headers) == (b"/", [(b"host", b"localhost")])
            assert not protocol.expect_100_continue
            protocol.data_received(GET + GET)
            assert protocol.pipeline[0][0] is protocol.cycle, "the newest is the first"
            assert protocol.cycle is not first
            assert [len(protocol.pipeline), protocol.flow.write_paused, protocol.flow.read_paused] == [2, False, True]
            proceed.set()
            while state.total_requests < 3:
                await asyncio.sleep(0)
            assert protocol.cycle.response_started
            assert protocol.cycle.response_complete
            assert (len(protocol.pipeline), protocol.flow.read_paused) == (0, False)
            assert protocol.timeout_keep_alive_task is not None
            protocol.transport.abort()
            while protocol in state.connections:
                await asyncio.sleep(0)

    asyncio.run(live())
