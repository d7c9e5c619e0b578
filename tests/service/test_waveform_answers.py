"""What a right question gets back, read with libraries that are not ours."""

import base64
import hashlib
import json

import msgpack
import numpy as np
import pytest

from bnserve_protocol import ParametersWithExtrinsic, UniformGrid
from tests.service.asking import (
    GRID,
    GW170817,
    JSON,
    MSGPACK,
    as_array,
    ask,
    evaluate,
    evaluate_json,
    question,
    read_msgpack,
)
from tests.service.chirp import ChirpModel

LOCAL = ChirpModel()
FREQUENCIES = UniformGrid(**GRID).frequencies()
ROWS = [ParametersWithExtrinsic(**(GW170817 | {"total_mass": mass})) for mass in (2.5, 2.76, 3.0)]
COLUMNS = GW170817 | {"total_mass": [2.5, 2.76, 3.0]}


def same_bits(one, other):
    return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()


def test_polarizations_are_the_default_output(server):
    answer = read_msgpack(evaluate(server.address, question(COLUMNS)).body)
    plus, cross = LOCAL.predict_batch(FREQUENCIES, ROWS)
    assert set(answer) == {"h_plus", "h_cross", "status", "model"}
    assert same_bits(answer["h_plus"], plus)
    assert same_bits(answer["h_cross"], cross)
    assert answer["status"].tolist() == [0, 0, 0]
    assert answer["status"].dtype == np.uint8
    assert answer["model"] == {"name": "chirp", "version": "1.0.0", "digest": "sha256:0"}


def test_factored(server):
    answer = read_msgpack(evaluate(server.address, question(COLUMNS, output="factored")).body)
    expected = LOCAL.predict_factored(FREQUENCIES, ROWS)
    assert set(answer) == {"h", "plus", "cross", "status", "model"}
    for name in ("h", "plus", "cross"):
        assert same_bits(answer[name], getattr(expected, name)), name


def test_a_mode_is_h_with_its_factors(server):
    answer = read_msgpack(evaluate(server.address, question(COLUMNS, output="modes")).body)
    expected = LOCAL.predict_factored(FREQUENCIES, ROWS)
    assert set(answer) == {"h_22", "plus_22", "cross_22", "status", "model"}
    for name in ("h", "plus", "cross"):
        assert same_bits(answer[f"{name}_22"], getattr(expected, name)), name


def test_amplitude_and_phase(server):
    answer = read_msgpack(evaluate(server.address, question(COLUMNS, output="amplitude_phase")).body)
    expected = LOCAL.predict_amplitude_phase(FREQUENCIES, ROWS)
    assert same_bits(answer["amplitude"], expected.amplitude)
    assert same_bits(answer["phase"], expected.phase)


def test_complex64_halves_the_bytes(server):
    answer = read_msgpack(evaluate(server.address, question(COLUMNS, dtype="complex64")).body)
    expected = LOCAL.predict_batch(FREQUENCIES, ROWS, dtype="complex64")
    assert same_bits(answer["h_plus"], expected.plus)


def test_flagged_rows_come_back_as_nan_with_a_status(server):
    columns = GW170817 | {"mass_ratio": [1.2, 9.0]}
    answer = read_msgpack(evaluate(server.address, question(columns, out_of_domain="flag")).body)
    assert answer["status"].tolist() == [0, 2]
    assert np.isfinite(answer["h_plus"][0]).all()
    assert np.isnan(answer["h_plus"][1]).all()


def test_json_gives_the_same_numbers(server):
    answer = evaluate_json(server.address, question(COLUMNS)).document
    plus, cross = LOCAL.predict_batch(FREQUENCIES, ROWS)
    assert np.array_equal(np.array(answer["h_plus"]["re"]) + 1j * np.array(answer["h_plus"]["im"]), plus)
    assert np.array_equal(answer["h_cross"]["im"], cross.imag)
    assert answer["status"] == [0, 0, 0]


def test_json_says_null_for_nan(server):
    columns = GW170817 | {"mass_ratio": 9.0}
    answer = evaluate_json(server.address, question(columns, out_of_domain="flag")).document
    assert answer["h_plus"]["re"] == [[None] * len(FREQUENCIES)]


@pytest.mark.parametrize(
    "parameters",
    [
        COLUMNS,
        {name: as_array(np.broadcast_to(np.float64(value), 3)) for name, value in COLUMNS.items()},
    ],
    ids=["lists", "arrays"],
)
def test_parameters_as_named_vectors(server, parameters):
    answer = read_msgpack(evaluate(server.address, question(parameters)).body)
    assert same_bits(answer["h_plus"], LOCAL.predict_batch(FREQUENCIES, ROWS).plus)


@pytest.mark.parametrize("form", [as_array, np.ndarray.tolist], ids=["array", "lists"])
def test_parameters_as_one_array_with_names(server, form):
    rows = np.array([[getattr(row, name) for name in GW170817] for row in ROWS])
    answer = read_msgpack(evaluate(server.address, question(form(rows), names=list(GW170817))).body)
    assert same_bits(answer["h_plus"], LOCAL.predict_batch(FREQUENCIES, ROWS).plus)


def test_the_three_forms_of_a_grid_give_the_same_bits(server):
    body = FREQUENCIES.astype("<f8").tobytes()
    digest = hashlib.sha256(body).hexdigest()
    assert ask(server.address, "PUT", f"/v1/grids/{digest}", body).status in (200, 201)
    grids = [GRID, {"frequencies": as_array(FREQUENCIES)}, {"frequencies": FREQUENCIES.tolist()}, {"sha256": digest}]
    answers = [read_msgpack(evaluate(server.address, question(COLUMNS, grid)).body)["h_plus"] for grid in grids]
    assert len({answer.tobytes() for answer in answers}) == 1


def test_a_version_or_a_label_may_be_named(server):
    body = msgpack.packb(question())
    answers = [
        ask(server.address, "POST", f"/v1/models/chirp/{middle}waveforms", body, content_type=MSGPACK)
        for middle in ("", "versions/1.0.0/", "versions/stable/")
    ]
    assert [answer.status for answer in answers] == [200, 200, 200]
    assert len({answer.body for answer in answers}) == 1


def test_an_empty_batch_has_an_empty_answer(server):
    columns = {name: [] for name in GW170817}
    answer = read_msgpack(evaluate(server.address, question(columns)).body)
    assert answer["h_plus"].shape == (0, len(FREQUENCIES))
    assert answer["status"].shape == (0,)


def test_every_answer_carries_its_digest_and_that_of_its_question(server):
    body = msgpack.packb(question())
    answer = ask(server.address, "POST", "/v1/models/chirp/waveforms", body, content_type=MSGPACK)
    stated = answer.headers["content-digest"]
    assert stated == f"sha-256=:{base64.b64encode(hashlib.sha256(answer.body).digest()).decode()}:"
    assert answer.headers["x-request-digest"] == hashlib.sha256(body).hexdigest()


@pytest.mark.parametrize("path", ["/v1/models", "/v1/limits", "/v2/health/ready", "/", "/docs", "/nowhere"])
def test_other_answers_carry_a_digest_too(server, path):
    answer = ask(server.address, "GET", path)
    assert answer.headers["content-digest"] == (
        f"sha-256=:{base64.b64encode(hashlib.sha256(answer.body).digest()).decode()}:"
    )


def test_the_time_is_told_in_parts(server):
    timing = evaluate(server.address, question()).headers["server-timing"]
    parts = dict(part.split(";dur=") for part in timing.split(", "))
    assert set(parts) == {"queue", "eval", "pack"}
    assert all(float(milliseconds) >= 0.0 for milliseconds in parts.values())


def test_the_request_id_is_echoed(server):
    assert evaluate(server.address, question(), x_request_id="run-7/walker-3").headers["x-request-id"] == (
        "run-7/walker-3"
    )


@pytest.mark.parametrize("given", ["", "x" * 129, "with space", "ümlaut"])
def test_a_request_id_that_could_do_harm_is_replaced(server, given):
    echoed = evaluate(server.address, question(), x_request_id=given.encode("latin-1")).headers["x-request-id"]
    assert len(echoed) == 32
    assert int(echoed, 16) >= 0


@pytest.mark.parametrize(
    ("accept", "expected"),
    [
        (None, MSGPACK),
        ("*/*", MSGPACK),
        (JSON, JSON),
        (f"{JSON};q=0.5, {MSGPACK}", MSGPACK),
        (f"{MSGPACK};q=0, */*", JSON),
        ("application/*;q=0.1", MSGPACK),
        ("text/html, application/x-msgpack", MSGPACK),
        ("application/x-msgpack; keys=bytes", "application/msgpack;keys=bytes"),
        ("application/msgpack;q=0.5, application/msgpack;keys=bytes", "application/msgpack;keys=bytes"),
        ("application/msgpack;keys=bytes;q=0, */*", MSGPACK),
    ],
)
def test_the_answer_comes_as_the_caller_likes_it(server, accept, expected):
    headers = {} if accept is None else {"accept": accept}
    answer = evaluate(server.address, question(), **headers)
    assert answer.status == 200
    assert answer.headers["content-type"] == expected


@pytest.mark.parametrize(("accept", "kind"), [(MSGPACK, str), ("application/msgpack;keys=bytes", bytes)])
def test_names_in_arrays_are_text_or_what_msgpack_numpy_reads(server, accept, kind):
    answer = msgpack.unpackb(evaluate(server.address, question(), accept=accept).body)
    assert {type(name) for name in answer} == {str}
    assert {type(name) for name in answer["h_plus"]} == {kind}
    assert {type(name) for name in answer["status"]} == {kind}


def test_a_large_answer_arrives_whole(server):
    grid = {"f_min": 10.0, "f_max": 10.0 + 8191 * 0.125, "delta_f": 0.125}
    answer = evaluate(server.address, question(GW170817 | {"total_mass": [2.5 + 0.01 * i for i in range(32)]}, grid))
    assert len(answer.body) > 8 * 2**20
    rows = [ParametersWithExtrinsic(**(GW170817 | {"total_mass": 2.5 + 0.01 * i})) for i in range(32)]
    expected = LOCAL.predict_batch(UniformGrid(**grid), rows)
    assert same_bits(read_msgpack(answer.body)["h_cross"], expected.cross)


def test_models_are_described(server):
    for path in ("/v1/models/chirp", "/v1/models/chirp/versions/1.0.0", "/v1/models/chirp/versions/stable"):
        document = ask(server.address, "GET", path).document
        assert document["name"] == "chirp"
        assert document["labels"] == {"stable": "1.0.0"}
        assert document["versions"] == ["1.0.0"]
        assert document["limits"]["max_rows"] == 64
        assert document["parameters"][0] == {
            "name": "mass_ratio", "unit": "1", "minimum": 1.0, "maximum": 3.0, "default": None
        }  # fmt: skip
        assert document["accuracy"] == {"median_mismatch": 1e-7}
    listed = ask(server.address, "GET", "/v1/models").document["models"]
    assert [model["name"] for model in listed] == ["chirp"]


def test_limits_are_told(server):
    limits = ask(server.address, "GET", "/v1/limits").document
    assert limits["max_body_bytes"] == 2**20
    assert limits["max_samples"] == 2**18


def test_metadata_comes_as_messagepack_when_asked(server):
    answer = ask(server.address, "GET", "/v1/limits", accept=MSGPACK)
    assert msgpack.unpackb(answer.body) == ask(server.address, "GET", "/v1/limits").document


def test_many_questions_on_one_connection(server):
    from tests.service.asking import ask_on, closing_connection

    with closing_connection(server.address) as connection:
        for mass in np.linspace(2.1, 3.9, 50).tolist():
            body = json.dumps(question(GW170817 | {"total_mass": mass}))
            answer = ask_on(connection, "POST", "/v1/models/chirp/waveforms", body, content_type=JSON)
            binary = ParametersWithExtrinsic(**(GW170817 | {"total_mass": mass}))
            assert answer.document["h_plus"]["re"] == LOCAL.predict_batch(FREQUENCIES, binary).plus.real.tolist()
