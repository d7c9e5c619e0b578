"""Where a token comes from travels to other processes; the token itself is in no pickle, text or report of an error."""

import asyncio
import copy
import multiprocessing
import pickle
import pprint
import traceback
from pathlib import Path

import numpy as np
import pytest

from bnserve_client import AsyncModel, InvalidRequest, ParametersWithExtrinsic, Unauthorized
from tests.client.conftest import same
from tests.client.reference_likelihood import LikelihoodReference, tiny_analysis
from tests.client.reference_model import ReferenceModel

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")

SECRET = "correct-horse-battery-staple"
FREQUENCIES = np.linspace(20.0, 1024.0, 50)
ONE = ParametersWithExtrinsic.gw170817()
RIGHT = ReferenceModel().predict(FREQUENCIES, ONE)
START_METHODS = ("fork", "spawn", "forkserver")


def secret():
    """A function that a module has."""
    return SECRET


@pytest.fixture
def address(start_server):
    return start_server(LikelihoodReference(token=SECRET)).address


@pytest.fixture(params=["itself", "file", "function", "environment"])
def given(request, tmp_path, monkeypatch):
    """A token in every form; the environment has it only where it comes from there."""
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    if request.param == "environment":
        monkeypatch.setenv("BNSERVE_TOKEN", SECRET)
        return None
    file = tmp_path / "token"
    file.write_text(f"{SECRET}\n")
    return {"itself": SECRET, "file": file, "function": secret}[request.param]


def ask(model):
    return same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_a_token_is_taken_in_every_form(address, connect, given):
    assert ask(connect(address, token=given))


def test_asynchronous_models_take_it_too(address, given):
    async def run():
        async with await AsyncModel.connect(address, token=given) as model:
            travelled = pickle.dumps(model)
            return await model.predict(FREQUENCIES, ONE), travelled

    answer, travelled = asyncio.run(run())
    assert same(answer, RIGHT)
    assert SECRET.encode() not in travelled


def test_a_token_that_the_environment_has_later_is_found_after_a_refusal(start_server, connect, monkeypatch):
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    service = LikelihoodReference()
    model = connect(start_server(service).address)
    assert ask(model)
    service.token = SECRET
    with pytest.raises(Unauthorized):
        ask(model)
    monkeypatch.setenv("BNSERVE_TOKEN", SECRET)
    assert ask(model)


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_no_pickle_holds_it(address, connect, given, protocol):
    model = connect(address, token=given)
    likelihood = model.likelihood(tiny_analysis())
    assert ask(model)
    for travelling in (model, likelihood, model._remote.settings, [likelihood.log_likelihood]):
        pickled = pickle.dumps(travelling, protocol)
        assert SECRET.encode() not in pickled


def everything_in(thing, seen):
    """Representations of an object, its attributes, and so on."""
    if id(thing) in seen or isinstance(thing, type | str | bytes | np.ndarray):
        return repr(thing)
    seen[id(thing)] = thing
    names = [
        *getattr(thing, "__dict__", ()),
        *(n for kind in type(thing).__mro__ for n in getattr(kind, "__slots__", ())),
    ]
    inner = [getattr(thing, name, None) for name in names]
    inner += list(thing.values()) if isinstance(thing, dict) else list(thing) if isinstance(thing, tuple | list) else []
    return repr(thing) + "".join(everything_in(each, seen) for each in inner)


def test_nothing_that_is_printed_shows_it(address, connect, given):
    model = connect(address, token=given)
    assert ask(model)
    shown = repr(model) + str(model) + pprint.pformat(vars(model)) + everything_in(model, {})
    assert "Token from" in shown
    assert SECRET not in shown


@pytest.mark.parametrize("wrong", ["wrong-horse", "two words", "ümlaut", "line\nbreak", " ", ""])
def test_no_report_of_an_error_shows_it(address, connect, monkeypatch, tmp_path, wrong):
    """Not even one with the variables of all frames of ours."""
    for given in (wrong, lambda: wrong):
        with pytest.raises((Unauthorized, InvalidRequest)) as raised:
            connect(address, token=given)
        error = raised.value
        texts = [error.detail, repr(error), str(error.errors), pickle.dumps(error).decode("latin-1")]
        report = traceback.TracebackException.from_exception(error, capture_locals=True)
        ours = [frame.locals for frame in report.stack if "_session" in frame.filename or "_blocking" in frame.filename]
        if len(wrong) > 3:
            assert wrong not in "".join(texts) + repr(ours)


COPIES = {"copied": copy.copy, "deep-copied": copy.deepcopy, "pickled": lambda model: pickle.loads(pickle.dumps(model))}


@pytest.mark.parametrize("copied", COPIES.values(), ids=COPIES)
def test_copies_know_it(address, connect, given, copied, monkeypatch):
    model = connect(address, token=given)
    if given == SECRET and copied is COPIES["pickled"]:
        monkeypatch.setenv("BNSERVE_TOKEN", SECRET)  # where one that was given itself is looked for
    with copied(model) as twin:
        assert ask(twin)


@pytest.mark.parametrize("method", START_METHODS)
def test_pools_take_it_from_where_it_came(address, connect, given, method, monkeypatch):
    model = connect(address, token=given)
    if given == SECRET:
        monkeypatch.setenv("BNSERVE_TOKEN", SECRET)
    context = multiprocessing.get_context(method)
    if method == "forkserver":
        return in_a_fresh_fork_server(model)
    with context.Pool(1) as pool:
        assert pool.apply(ask, (model,))


def in_a_fresh_fork_server(model):
    """A fork server of an earlier test has the environment of that time, so a process of its own asks one."""
    context = multiprocessing.get_context("spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=through_a_fork_server, args=(model, sender))
    process.start()
    assert receiver.recv()
    process.join()


def through_a_fork_server(model, sender):
    with multiprocessing.get_context("forkserver").Pool(1) as pool:
        sender.send(pool.apply(ask, (model,)))


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_one_that_is_nowhere_is_an_error_that_says_how_to_give_it(address, connect, monkeypatch, method):
    """When the model is first used: an error while unpickling would have a pool wait for ever."""
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    model = connect(address, token=SECRET)
    with multiprocessing.get_context(method).Pool(1) as pool, pytest.raises(Unauthorized) as raised:
        pool.apply(ask, (model,))
    says = raised.value.detail
    assert "does not travel to other processes. Set BNSERVE_TOKEN in their environment, or connect with token=" in says
    assert "pathlib.Path" in says
    assert "module-level function" in says


def test_a_child_that_inherits_the_model_knows_it(address, connect, given, monkeypatch):
    model = connect(address, token=given)
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    receiver, sender = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.get_context("fork").Process(target=lambda: sender.send(ask(model)))
    child.start()
    assert receiver.recv()
    child.join()


def test_a_new_token_in_the_file_is_read_where_it_arrives(start_server, connect, tmp_path, monkeypatch):
    file = tmp_path / "token"
    file.write_text("old")
    monkeypatch.chdir(tmp_path)
    service = LikelihoodReference(token="old")
    travelling = pickle.dumps(connect(start_server(service).address, token=Path("token")))
    file.write_text("new")
    service.token = "new"
    monkeypatch.chdir("/")
    assert ask(pickle.loads(travelling))


def test_a_model_that_was_pickled_by_0_1_is_read(start_server, connect, monkeypatch):
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    pickled = pickle.dumps(connect(start_server().address), protocol=0)
    assert pickled.count(b"cbnserve_client._settings\n_taken_from\n") == 1
    assert ask(pickle.loads(pickled.replace(b"_settings\n_taken_from", b"_tokens\n_taken_from")))


def test_without_a_token_none_is_sent(start_server, connect, monkeypatch):
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    server = start_server()
    assert ask(pickle.loads(pickle.dumps(connect(server.address))))
    monkeypatch.setenv("BNSERVE_TOKEN", "")
    assert ask(connect(server.address))
    assert all("authorization" not in headers for _, _, headers, _ in server.service.requests)


NO_TOKENS = {
    "a file that is not there": (
        Path("/nothing/here"),
        Unauthorized,
        "cannot be read from the file '/nothing/here': No",
    ),
    "a number": (3, InvalidRequest, "'token' is a string, a path of a file that holds it, or a function"),
    "bytes": (b"secret", InvalidRequest, "'token' is a string"),
    "a function without one": (
        lambda: None,
        InvalidRequest,
        "in the function given as 'token' must be",
    ),
    "an empty string": ("", InvalidRequest, "in token must be printable ASCII"),
}


@pytest.mark.parametrize(("given", "kind", "says"), NO_TOKENS.values(), ids=NO_TOKENS)
def test_what_is_no_token_is_named(address, connect, given, kind, says):
    with pytest.raises(kind) as raised:
        connect(address, token=given)
    assert says in raised.value.detail


def test_an_empty_file_is_named(address, connect, tmp_path):
    (tmp_path / "token").write_text("\n")
    with pytest.raises(InvalidRequest, match=r"in the file '.*token' must be printable ASCII"):
        connect(address, token=tmp_path / "token")
