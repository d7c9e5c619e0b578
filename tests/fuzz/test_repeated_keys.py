"""A key that is there twice is an error in every map of every message that somebody else may have written."""

import json

import msgpack
import msgspec
import pytest

from bnserve_client import NotBnserve
from bnserve_client._answers import read_json
from bnserve_protocol import FieldError, InvalidParameters, Limits
from bnserve_protocol.wire import Problem
from tests.fuzz import valid
from tests.fuzz.targets import TARGETS

JSON_READERS = ("request_json", "likelihood_json", "manifest", "labels")
MSGPACK_READERS = ("request", "likelihood", "analysis", "waveform_answer", "likelihood_answer")


class Pairs(list):
    """The entries of a map, one after the other, as they were written."""


def maps_in(value, path=()):
    """The path to every map of a message, itself included."""
    if isinstance(value, Pairs):
        yield path
        for place, (_, entry) in enumerate(value):
            yield from maps_in(entry, (*path, place))
    elif isinstance(value, list):
        for place, entry in enumerate(value):
            yield from maps_in(entry, (*path, place))


def map_at(value, path):
    for place in path:
        value = value[place][1] if isinstance(value, Pairs) else value[place]
    return value


def read_msgpack(data):
    return msgpack.unpackb(data, object_pairs_hook=Pairs, strict_map_key=False)


def write_msgpack(value):
    packer = msgpack.Packer(autoreset=False)

    def write(item):
        if isinstance(item, Pairs):
            packer.pack_map_header(len(item))
            for key, entry in item:
                packer.pack(key)
                write(entry)
        elif isinstance(item, list):
            packer.pack_array_header(len(item))
            for entry in item:
                write(entry)
        else:
            packer.pack(item)

    write(value)
    return packer.bytes()


def read_json_pairs(data):
    return json.loads(data, object_pairs_hook=Pairs)


def write_json(value):
    if isinstance(value, Pairs):
        return "{" + ", ".join(f"{json.dumps(key)}: {write_json(entry)}" for key, entry in value) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(write_json, value)) + "]"
    return json.dumps(value)


def with_a_key_twice(message, read, write):
    """The message, once for every map in it, with the map's first entry repeated at its end: the same in both."""
    for path in maps_in(read(message)):
        value = read(message)
        entries = map_at(value, path)
        if entries:
            entries.append(entries[0])
            yield write(value)


@pytest.mark.parametrize("name", MSGPACK_READERS)
def test_messagepack(name):
    reader = TARGETS[name]
    for message in reader.seeds():
        assert reader(write_msgpack(read_msgpack(message))), "what is changed is taken without the change"
        for changed in with_a_key_twice(message, read_msgpack, write_msgpack):
            assert not reader(changed), changed[:300]


@pytest.mark.parametrize("name", JSON_READERS)
def test_json(name):
    reader = TARGETS[name]
    for message in reader.seeds():
        assert name == "manifest" or reader(write_json(read_json_pairs(message)).encode())
        for changed in with_a_key_twice(message, read_json_pairs, write_json):
            assert not reader(changed.encode()), changed[:300]


@pytest.mark.parametrize("escaped", ["output", "o\\u0075tput"])
def test_an_escape_does_not_hide_a_key(escaped):
    [message, *_] = valid.waveform_requests_json()
    start = message[:-1].decode()
    assert TARGETS["request_json"](f'{start}, "{escaped}": "polarizations"}}'.encode())
    assert not TARGETS["request_json"](f'{start}, "output": "polarizations", "{escaped}": "polarizations"}}'.encode())


def test_colons_in_texts_are_no_keys():
    message = json.loads(valid.likelihood_requests_json()[0]) | {"analysis": "sha256:" + "a:" * 16}
    assert TARGETS["likelihood_json"](json.dumps(message).encode())


@pytest.mark.parametrize("header", [b"\xde\x00", b"\xdf\x00\x00\x00"])
@pytest.mark.parametrize("entries", [3, 17, 94, 95])
def test_long_headers_of_maps(header, entries):
    """Every form of a map's length: 94 and 95 are those for which the first byte of the long forms would be right."""
    columns = [(f"column_{number}", None) for number in range(entries)]
    reader = TARGETS["waveform_answer"]
    message = read_msgpack(valid.waveform_answers()[0])
    for twice in (False, True):
        body = write_msgpack(Pairs([*message, *columns, *columns[: int(twice)]]))
        count = len(message) + entries + twice
        after = 1 if count < 16 else 3
        assert reader(header + bytes([count]) + body[after:]) is not twice
    for short in (count - 1, count):
        exact = write_msgpack(Pairs([*message, *columns, *columns[:1]][:short]))
        assert reader(exact) is (short < count)


def test_the_client_refuses_such_answers():
    limits, problem = (
        b'{"max_rows": 5}',
        msgspec.json.encode(
            Problem.from_error(InvalidParameters("no", errors=[FieldError("no", "chi_1", 0, 2.0)]), 422)
        ),
    )
    assert read_json(limits, Limits, "here").max_rows == 5
    assert read_json(problem, Problem, "here").code
    for message, schema in ((b'{"max_rows": 5, "max_rows": 6}', Limits), (problem[:-1] + b', "code": "x"}', Problem)):
        with pytest.raises(NotBnserve):
            read_json(message, schema, "here")
    for changed in with_a_key_twice(problem, read_json_pairs, write_json):
        with pytest.raises(NotBnserve):
            read_json(changed.encode(), Problem, "here")
