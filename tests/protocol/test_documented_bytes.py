"""The messages that the reference prints byte by byte are those that are read and written."""

import json
import re
from pathlib import Path

import msgpack
import msgspec
import numpy as np

from bnserve_protocol import (
    IN_PLANE_NAMES,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    AnalysisSettings,
    DetectorNetwork,
    NetworkDetector,
    decode_network,
)
from bnserve_protocol.wire import JSON, ForecastAnswerBody, ForecastBody, Problem, decode_request, encode_array
from bnserve_surrogate import Model

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


def test_the_array_is_the_answer_to_the_request():
    """Of the default model; other processors round otherwise."""
    asked = decode_request(documented()[0])
    found = Model.default().predict_batch(asked.grid, asked.batch).plus
    real, imaginary = map(float, re.findall(r"# (-?[\d.]+e-\d+)$", PAGE, re.MULTILINE))
    np.testing.assert_allclose(found, [[complex(real, imaginary)]], rtol=1e-9)


def test_the_network_is_read_and_written_in_json_beside_it():
    body, plain = documented()[2], re.search(r"The same in JSON is `(.*?)`", PAGE)[1]
    assert msgpack.unpackb(body) == json.loads(plain)
    ours = DetectorNetwork([NetworkDetector("CE40", "CE40")], 5.0, 2048.0, 1.9e9)
    for told in (body, plain.encode()):
        assert decode_network(told).body == ours.body


def test_every_field_of_a_forecast_is_there():
    section = PAGE.partition("## Forecasts")[2].partition("## Arrays")[0]
    fields = {name for body in (ForecastBody, ForecastAnswerBody) for name in body.__struct_fields__}
    assert not fields - set(re.findall(r"`(\w+)`", section))


def test_every_parameter_is_there_with_its_unit_and_the_range_of_the_default_model():
    table = PAGE.partition("| Parameter | Unit |")[2].partition("\n\n")[0]
    rows = {name: line for line in table.splitlines() for name in re.findall(r"`(\w+)`", line)}
    units = {"Msun": "solar masses"}
    for name in (*PARAMETER_NAMES, *IN_PLANE_NAMES):
        unit = PARAMETER_UNITS[name]
        assert rows[name].split(" | ")[1] == units.get(unit, unit), name
    for parameter in Model.default().description.parameters:
        if parameter.maximum is not None:
            assert f"{parameter.minimum:g} to {parameter.maximum:g}" in rows[parameter.name]


def test_every_field_of_a_problem_and_every_setting_of_an_analysis_is_there():
    names = re.findall(r"`(\w+)`", PAGE)
    for structure in (Problem, AnalysisSettings):
        assert not {field.name for field in msgspec.structs.fields(structure)} - set(names)
