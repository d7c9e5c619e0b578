"""A file of old bytes must still decode; see ``golden/README.md``."""

from pathlib import Path

import numpy as np
import pytest

from bnserve_protocol import ParameterBatch, UniformGrid
from bnserve_protocol.wire import JSON, decode_answer, decode_request
from tests.protocol.golden.write import ANSWERS, BATCH, FREQUENCIES, MODEL, REQUESTS, STATUS
from tests.protocol.messages import read_message

GOLDEN = Path(__file__).with_name("golden")


def equal(one, other):
    """Equal values, NaN being equal to itself."""
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and np.array_equal(one, other, equal_nan=True)
    return one == other


@pytest.mark.parametrize("name", REQUESTS)
def test_old_requests_still_mean_the_same(name):
    request, expected = decode_request((GOLDEN / name).read_bytes()), REQUESTS[name]
    np.testing.assert_array_equal(request.batch.values, expected.batch.values)
    assert equal(request.grid, expected.grid)
    assert (request.output, request.dtype, request.options) == (expected.output, expected.dtype, expected.options)


def test_old_json_requests_still_mean_the_same():
    request = decode_request((GOLDEN / "request_columns.json").read_bytes(), JSON)
    np.testing.assert_array_equal(request.batch.values, BATCH.values)
    np.testing.assert_array_equal(request.grid, FREQUENCIES)
    assert request.output == "factored"
    request = decode_request((GOLDEN / "request_rows.json").read_bytes(), JSON)
    np.testing.assert_array_equal(request.batch.values, ParameterBatch(BATCH.values[:1]).values)
    assert request.grid == UniformGrid(20.0, 1024.0, 0.25)
    assert (request.output, request.dtype) == ("polarizations", "complex64")
    assert request.options == REQUESTS["request_uniform.msgpack"].options


@pytest.mark.parametrize("name", ANSWERS)
def test_old_answers_still_mean_the_same(name):
    answer, expected = decode_answer((GOLDEN / name).read_bytes()), ANSWERS[name] | {"status": STATUS}
    assert answer.model == MODEL
    assert set(answer.arrays) == set(expected)
    assert all(equal(answer.arrays[field], expected[field]) for field in expected)


@pytest.mark.parametrize("name", ANSWERS)
def test_old_answers_are_readable_without_bnserve(name):
    message = read_message((GOLDEN / name).read_bytes())
    assert message["model"]["version"] == "1.0.0"
    assert all(equal(message[field], ANSWERS[name][field]) for field in ANSWERS[name])


def test_no_file_is_forgotten():
    written = {path.name for path in GOLDEN.iterdir() if path.suffix in (".msgpack", ".json")}
    assert written == {*REQUESTS, *ANSWERS, "request_columns.json", "request_rows.json"}
