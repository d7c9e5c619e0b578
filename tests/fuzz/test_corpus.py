"""What once broke a reader, or nearly, never does again; and the fuzzers start from messages that are right."""

import tracemalloc

import msgpack
import pytest

from tests.fuzz.corpus import HERE, kept
from tests.fuzz.likelihoods import model
from tests.fuzz.targets import TARGETS
from tests.service.asking import GRID, GW170817

MEMORY = 64 * 2**20
MANY = 2**17
"""Of numbers or letters; a body may have a hundred times as many."""


@pytest.fixture(scope="module", autouse=True)
def _loaded():
    """The model of the likelihoods; its memory is not that of a reader."""
    model()


def peak_of(target, data):
    """Bytes that reading took at most."""
    tracemalloc.start()
    try:
        target(data)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    "path", [path for name in TARGETS for path in kept(name)], ids=lambda path: f"{path.parent.name}/{path.name}"
)
def test_what_once_broke_a_reader_is_read_or_refused(path):
    assert peak_of(TARGETS[path.parent.name], path.read_bytes()) < MEMORY


def test_every_folder_of_the_corpus_has_a_reader():
    assert {path.name for path in HERE.iterdir() if path.is_dir() and path.name != "__pycache__"} <= set(TARGETS)


def test_every_kept_input_is_explained():
    readme = (HERE / "README.md").read_text()
    for name in TARGETS:
        for path in kept(name):
            assert f"`{name}/{path.name}`" in readme


@pytest.mark.parametrize("target", TARGETS.values(), ids=TARGETS)
def test_valid_messages_are_taken(target):
    assert any(target(data) for data in target.seeds())


@pytest.mark.parametrize("target", TARGETS.values(), ids=TARGETS)
def test_a_target_does_not_forgive_errors_without_a_name(target):
    def fail(data):
        raise KeyError("a defect")

    broken = type(target)(target.name, fail, target.errors, target.seeds, target.mutate)
    with pytest.raises(KeyError):
        broken(b"anything")


LARGE = {
    "a name without end": ("request", {"parameters": GW170817 | {"x" * MANY: 1.0}, "grid": GRID}),
    "a name without end, of a likelihood": ("likelihood", {"parameters": {"x" * MANY: 1.0}}),
    "a long list of numbers": ("request", {"parameters": GW170817 | {"chi_1": [0] * MANY}, "grid": GRID}),
    "a long grid": ("request", {"parameters": GW170817, "grid": {"frequencies": [*range(1, MANY)]}}),
    "many rows without values": ("request", {"parameters": [[]] * MANY, "names": [], "grid": GRID}),
    "a name without end, of an analysis": ("analysis", {"settings": {}, "arrays": {"x" * MANY: b""}}),
}


@pytest.mark.parametrize(("name", "message"), LARGE.values(), ids=LARGE)
def test_a_large_message_takes_its_part_of_the_promised_memory(name, message):
    body = msgpack.packb(message)
    assert peak_of(TARGETS[name], body) < MEMORY * MANY // 2**20


@pytest.mark.parametrize(("name", "message"), list(LARGE.values())[:2], ids=list(LARGE)[:2])
def test_what_is_not_a_name_is_not_compared_with_names(name, message):
    """Looking for the nearest known name of one of megabytes took seconds, and forty times its memory."""
    body = msgpack.packb(message)
    assert peak_of(TARGETS[name], body) < 4 * len(body)
