"""Small changes of valid messages, made in their structure: a value, a name, an extent, a length; sometimes in bytes.

Every choice is drawn from a ``random.Random``. That of Hypothesis (``st.randoms()``) makes the choices shrink, that of
a coverage-guided fuzzer makes them repeatable.
"""

import copy
import json
import math
from collections.abc import Callable
from random import Random
from typing import Any

import msgpack

from tests.fuzz.conversation import MARK

# fmt: off
NUMBERS = (
    0, 1, -1, 2, 127, 128, 255, 256, 2**15, 2**16, 2**31 - 1, 2**31, 2**32, 2**53, 2**60, 2**63 - 1, 2**63, 2**64 - 1,
    -(2**31), -(2**63), 0.0, -0.0, 0.5, 1e-300, 5e-324, 1e300, -1e300, math.inf, -math.inf, math.nan,
)
TEXTS = (
    "", "a", "\0", "\N{SNOWMAN}", "../..", "x" * 300, "9" * 5000, "NaN", "nd", "sha256:", "Row " + "9" * 5000 + ": x",
)
TYPES = (
    "<f8", "<f4", "<c16", "<c8", "|u1", ">f8", "|O", "|V8", "<U4", "|S8", "<i8", "<M8[s]", "f8", "F64", "BOOL", "BF16",
)
SHAPES = (
    [], [0], [1], [-1], [2**32], [2**40, 2**40], [2**63 - 1], [2**62, 2], [0, 2**63 - 1], [1, 1, 1], [0, 3], [3, 1],
)
NAMES = (
    "parameters", "names", "grid", "f_min", "frequencies", "sha256", "mass_ratio", "lambda_1", "nd", "data", "shape",
    "model", "digest", "status", "h", "settings", "arrays", "tensors", "metadata", "__metadata__", "offsets",
)
HEADERS = (
    b"", b"content-length: -1", b"content-length: 99999999999999999999", b"transfer-encoding: chunked",
    b"connection: close", b"content-digest: sha-256=:AAAA:", b"retry-after: " + b"9" * 400, b"HTTP/1.1 503 x",
    b"HTTP/1.1 204 x", b"HTTP/1.1 100 x", b"content-type: application/problem+json", b"retry-after: Sun, 06 Nov 1994",
)
# fmt: on
_DEEP = 3000


def interesting(random: Random) -> Any:
    """A value that readers may not expect."""
    kind = random.randrange(9)
    if kind == 0:
        return random.choice(NUMBERS)
    if kind == 1:
        return random.choice(TEXTS)
    if kind == 2:
        return random.choice([None, True, False])
    if kind == 3:
        return bytes(random.choice([0, 1, 7, 8, 24, 255, 300]))
    if kind == 4:
        return [interesting(random)] * random.choice([0, 1, 2, 65])
    if kind == 5:
        return {random.choice(NAMES): interesting(random) for _ in range(random.randrange(3))}
    if kind == 6:
        return random.choice(TYPES)
    if kind == 7:
        return list(random.choice(SHAPES))
    return {
        b"nd": True,
        b"type": random.choice(TYPES),
        b"kind": b"",
        b"shape": list(random.choice(SHAPES)),
        b"data": bytes(24),
    }


def places(tree: Any) -> list[tuple[Any, Any]]:
    """Every (container, key) of a tree."""
    found, todo = [], [tree]
    while todo:
        node = todo.pop()
        pairs = (
            list(node.items()) if isinstance(node, dict) else list(enumerate(node)) if isinstance(node, list) else []
        )
        for key, value in pairs:
            found.append((node, key))
            todo.append(value)
    return found


def change(tree: Any, random: Random) -> Any:
    """One change somewhere in a tree, which is changed in place where it can be."""
    where = places(tree)
    if not where or random.randrange(40) == 0:
        return interesting(random)
    node, key = random.choice(where)
    action = random.randrange(8)
    if action <= 2:
        node[key] = fitting(node[key], key, random)
    elif action == 3:
        del node[key]
    elif action == 4:
        node[key] = interesting(random)
    elif action == 5:
        other, name = random.choice(where)
        node[key] = copy.deepcopy(other[name])
    elif isinstance(node, list):
        node.insert(key, interesting(random))
    else:
        value = node.pop(key) if action == 6 else node[key]
        name = random.choice(NAMES + TEXTS)
        node[name.encode() if isinstance(key, bytes) else name] = value
    return tree


def fitting(value: Any, key: Any, random: Random) -> Any:
    """A value of the kind that belongs there, at the edge of what is possible."""
    if key in (b"type", "type", "dtype"):
        return random.choice(TYPES)
    if key in (b"shape", "shape"):
        return list(random.choice(SHAPES))
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        return random.choice([*NUMBERS, value + 1, -value, value * 1e6])
    if isinstance(value, str):
        return random.choice([*TEXTS, value[:-1], value + "x", value.upper()])
    if isinstance(value, bytes):
        return random.choice([value[:-1], value + b"\0", value * 2, b"", bytes(len(value)), b"\xff" * len(value)])
    if isinstance(value, list):
        return random.choice([value * 2, value[:-1], [], [value], [*value, None]])
    return interesting(random)


def damage(data: bytes, random: Random) -> bytes:
    """A change of bytes that knows nothing of their meaning."""
    action, place = random.randrange(6), random.randrange(len(data) + 1)
    if action == 0:
        return data[:place]
    if action == 1:
        return data[:place] + bytes([random.randrange(256)]) + data[place:]
    if action == 2:
        return data[:place] + data[place + random.choice([1, 2, 4, 8]) :]
    if action == 3:
        return data + data[place:]
    if action == 4:
        deep = random.choice([b"\x91", b"\x81\xa1a", b"[", b'{"a":', b"\xdc\xff\xff", b"\xc6\xff\xff\xff\xff"])
        return data[:place] + deep * random.choice([1, _DEEP]) + data[place:]
    flipped = bytearray(data)
    for _ in range(random.randrange(1, 4)):
        if flipped:
            flipped[random.randrange(len(flipped))] ^= 1 << random.randrange(8)
    return bytes(flipped)


def in_tree(read: Callable[[bytes], Any], write: Callable[[Any], bytes]) -> Callable[[bytes, Random], bytes]:
    """A mutation for a format that is read into a tree and written again."""

    def mutate(data: bytes, random: Random) -> bytes:
        tree = read(data)
        for _ in range(random.choice([0, 1, 1, 1, 2, 3])):
            tree = change(tree, random)
        data = write(tree)
        return damage(data, random) if random.randrange(4) == 0 else data

    return mutate


def _read_safetensors(data: bytes) -> Any:
    size = int.from_bytes(data[:8], "little")
    return {"size": 0, "header": json.loads(data[8 : 8 + size]), "data": data[8 + size :]}


def _write_safetensors(tree: Any) -> bytes:
    if not (isinstance(tree, dict) and isinstance(tree.get("size"), int) and isinstance(tree.get("data"), bytes)):
        return _json(tree)
    header = _json(tree.get("header"))
    return ((len(header) + tree["size"]) % 2**64).to_bytes(8, "little") + header + tree["data"]


def _json(tree: Any) -> bytes:
    return json.dumps(tree, default=lambda value: value.decode("latin-1"), skipkeys=True).encode()


def _text_keys(tree: Any) -> Any:
    if isinstance(tree, dict):
        return {
            key.decode("latin-1") if isinstance(key, bytes) else key: _text_keys(value) for key, value in tree.items()
        }
    return [_text_keys(value) for value in tree] if isinstance(tree, list) else tree


def _read_msgpack(data: bytes) -> Any:
    return msgpack.unpackb(data, strict_map_key=False)


mutate_msgpack = in_tree(_read_msgpack, msgpack.packb)
mutate_json = in_tree(json.loads, lambda tree: _json(_text_keys(tree)))
mutate_safetensors = in_tree(_read_safetensors, lambda tree: _write_safetensors(_text_keys(tree)))


def mutate_conversation(data: bytes, random: Random) -> bytes:
    """A change of one of the answers: of its body, its headers, or its place."""
    answers = data.split(MARK)
    index = random.randrange(len(answers))
    head, empty, body = answers[index].partition(b"\r\n\r\n")
    action = random.randrange(6)
    if action <= 2:
        mutate = mutate_json if body[:1] == b"{" else mutate_msgpack if body[:1] >= b"\x80" else damage
        answers[index] = head + empty + mutate(body, random)
    elif action == 3:
        lines = head.split(b"\r\n")
        lines[random.randrange(len(lines))] = random.choice(HEADERS)
        answers[index] = b"\r\n".join(lines) + empty + body
    elif action == 4:
        answers[index] = damage(answers[index], random)
    else:
        answers.insert(random.randrange(len(answers) + 1), answers[index])
    return MARK.join(answers)
