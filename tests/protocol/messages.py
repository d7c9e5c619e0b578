"""Messages made and read without bnserve: plain ``msgpack`` and ten lines of numpy, as a user would."""

import msgpack
import numpy as np


def read_array(value):
    """A numpy array from the map of the wire."""
    fields = {key.decode() if isinstance(key, bytes) else key: item for key, item in value.items()}
    assert fields["nd"] is True
    assert fields["kind"] in (b"", "")
    return np.frombuffer(fields["data"], fields["type"]).reshape(fields["shape"])


def read_message(body):
    """A message of maps and arrays."""
    message = msgpack.unpackb(body, strict_map_key=False)
    return {name: read_array(item) if is_array(item) else item for name, item in message.items()}


def is_array(item):
    """Whether a value of a message is an array."""
    return isinstance(item, dict) and (b"nd" in item or "nd" in item)


def array_map(array, keys=str):
    """The map of an array, with text or binary keys."""
    fields = {"nd": True, "type": array.dtype.str, "kind": "", "shape": list(array.shape), "data": array.tobytes()}
    if keys is str:
        return fields
    return {key.encode(): b"" if key == "kind" else value for key, value in fields.items()}
