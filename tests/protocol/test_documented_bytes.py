"""The messages that the reference prints byte by byte are those that are read and written."""

import re
from pathlib import Path

import msgpack
import msgspec
import numpy as np

from bnserve_protocol import AnalysisSettings
from bnserve_protocol.wire import JSON, Problem, decode_request, encode_array

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "wire.md").read_text(encoding="utf-8")


def documented() -> list[bytes]:
    blocks = re.findall(r"```hex\n(.*?)```", PAGE, re.DOTALL)
    return [bytes.fromhex("".join(line.partition("#")[0] for line in block.splitlines())) for block in blocks]


def test_the_request_is_read_as_its_comments_say():
    body = documented()[0]
    asked = decode_request(body)
    assert [asked.batch[name].tolist() for name in ("mass_ratio", "lambda_1", "total_mass")] == [[1.2], [400.0], [2.76]]
    again = decode_request(msgspec.json.encode(msgpack.unpackb(body)), JSON)
    assert np.array_equal(asked.batch.values, again.batch.values)


def test_the_array_is_what_is_written():
    name, array = documented()[1][:7], documented()[1][7:]
    assert name == msgpack.packb("h_plus")
    real, imaginary = re.findall(r"# (-?[\d.]+e-\d+)$", PAGE, re.MULTILINE)
    assert array == b"".join(encode_array(np.array([[complex(float(real), float(imaginary))]])))


def test_every_field_of_a_problem_and_every_setting_of_an_analysis_is_there():
    names = re.findall(r"`(\w+)`", PAGE)
    for structure in (Problem, AnalysisSettings):
        assert not {field.name for field in msgspec.structs.fields(structure)} - set(names)
