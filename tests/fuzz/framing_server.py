"""A server in this process for conversations whose framing is odd, started with the first of them."""

from functools import cache
from itertools import count

from bnserve_service import BackgroundServer, Settings, Token
from tests.fuzz.framing import SCOPES, TOKENS, read_framing
from tests.service.chirp import MemorySource, QuickChirpModel, as_it_is

_numbers = count(1)


@cache
def server() -> BackgroundServer:
    """With a model that answers at once, and the tokens of the conversations."""
    tokens = [Token.of(text.decode(), name, SCOPES[name]) for name, text in TOKENS.items()]
    source = MemorySource().add(QuickChirpModel(name="default"))
    started = BackgroundServer(
        Settings(port=0, threads=1, tokens=tokens, drain_grace=0), source=source, factory=as_it_is
    )
    started.__enter__()
    return started


def stop() -> None:
    """End it, if it was started; before the interpreter ends, which takes its threads' work first."""
    if server.cache_info().currsize:
        server().__exit__()
        server.cache_clear()


def read_from_server(data: bytes) -> None:
    """Hold a conversation with it, as :func:`.framing.read_framing` says."""
    host, _, port = server().address.removeprefix("http://").rpartition(":")
    read_framing((host, int(port)), data, next(_numbers))
