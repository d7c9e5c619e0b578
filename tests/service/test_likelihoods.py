"""Likelihoods inside the service: an analysis is uploaded once, samples go there, eight bytes each come back."""

import base64
import hashlib
import json
from concurrent.futures import ThreadPoolExecutor

import jsonschema
import msgpack
import numpy as np
import pytest

from bnserve_inference import likelihood
from bnserve_protocol import LIKELIHOOD_NAMES, Calibration, RowStatus, likelihood_samples
from bnserve_protocol.wire import encode_likelihood_request
from tests.service.asking import JSON, MSGPACK, as_array, ask, read_msgpack
from tests.service.chirp import ChirpModel
from tests.service.injections import SIGNAL, columns, name_of, samples, small_analysis, upload
from tests.service.test_metrics import value

ANALYSIS = small_analysis()
NAME = name_of(ANALYSIS)
PATH = f"/v1/models/chirp/likelihoods/{NAME}"
LOCAL = likelihood(ChirpModel(), ANALYSIS)
BATCH = samples(17)


@pytest.fixture(scope="module", autouse=True)
def uploaded(server):
    assert upload(server.address, ANALYSIS).status in (200, 201)


def evaluate(address, batch, path=PATH, **headers):
    """Send a batch as our client does."""
    headers.setdefault("content_type", MSGPACK)
    return ask(address, "POST", path, encode_likelihood_request(ANALYSIS.digest, batch), **headers)


def same_bits(answer, expected):
    assert answer.status == 200, answer.body
    got = read_msgpack(answer.body)["log_likelihood"]
    return (got.dtype, got.shape, got.tobytes()) == (expected.dtype, expected.shape, expected.tobytes())


def test_it_is_the_local_likelihood_to_the_bit(server):
    answer = evaluate(server.address, BATCH)
    assert same_bits(answer, LOCAL.log_likelihood(BATCH))
    told = read_msgpack(answer.body)
    assert told["status"].tolist() == [0] * 17
    assert told["status"].dtype == np.uint8
    assert told["model"] == {"name": "chirp", "version": "1.0.0", "digest": "sha256:0"}
    assert told["analysis"] == ANALYSIS.digest
    assert np.ptp(told["log_likelihood"]) > 1.0  # there is a signal, and it matters where one looks


def test_every_answer_carries_its_digest_and_that_of_its_question(server):
    body = encode_likelihood_request(ANALYSIS.digest, BATCH)
    answer = ask(server.address, "POST", PATH, body, content_type=MSGPACK)
    digest = base64.b64encode(hashlib.sha256(answer.body).digest()).decode()
    assert answer.headers["content-digest"] == f"sha-256=:{digest}:"
    assert answer.headers["x-request-digest"] == hashlib.sha256(body).hexdigest()
    assert {part.split(";")[0] for part in answer.headers["server-timing"].split(", ")} == {"queue", "eval", "pack"}


FORMS = {
    "named lists": lambda: {"parameters": columns(BATCH)},
    "named arrays": lambda: {"parameters": {name: as_array(BATCH[name].copy()) for name in LIKELIHOOD_NAMES}},
    "rows": lambda: {"parameters": BATCH.values.tolist(), "names": list(LIKELIHOOD_NAMES)},
    "one array": lambda: {"parameters": as_array(BATCH.values), "names": list(LIKELIHOOD_NAMES)},
    "columns in another order": lambda: {
        "parameters": as_array(np.ascontiguousarray(BATCH.values[:, ::-1])), "names": list(LIKELIHOOD_NAMES[::-1])
    },
    "with the analysis": lambda: {"parameters": columns(BATCH), "analysis": ANALYSIS.digest},
}  # fmt: skip


@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)
def test_any_reader_and_writer_of_messagepack_will_do(server, form):
    answer = ask(server.address, "POST", PATH, msgpack.packb(form()), content_type=MSGPACK)
    assert same_bits(answer, LOCAL.log_likelihood(BATCH))


def test_json_gives_the_same_numbers_and_null_for_minus_infinity(server):
    parameters = SIGNAL | {"mass_ratio": [1.2, 1.3, 9.0]}
    answer = ask(server.address, "POST", PATH, json.dumps({"parameters": parameters}), content_type=JSON)
    expected = LOCAL.log_likelihood(parameters)
    assert answer.document["log_likelihood"] == [*expected[:2].tolist(), None]
    assert answer.document["status"] == [0, 0, RowStatus.OUT_OF_PRIOR]


def test_products_and_draws_in_json(server):
    body = json.dumps({"parameters": SIGNAL | {"mass_ratio": [1.2, 1.3, 9.0]}, "output": "products"})
    told = ask(server.address, "POST", PATH, body, content_type=JSON).document
    expected = LOCAL.products(SIGNAL | {"mass_ratio": [1.2, 1.3, 9.0]})
    assert told["d_inner_h"]["im"][:2] == expected.d_inner_h.imag[:2].tolist()
    assert told["h_inner_h"][2] == [None, None]
    assert told["log_likelihood"] == [*expected.network_log_likelihood[:2].tolist(), None]

    analysis = small_analysis(phase_marginalisation=True)
    assert upload(server.address, analysis).status in (200, 201)
    path, numbers = f"/v1/models/chirp/likelihoods/{name_of(analysis)}", [[0.1, 0.6, 0.9]]
    body = json.dumps({"parameters": SIGNAL, "output": "draws", "uniforms": numbers})
    told = ask(server.address, "POST", path, body, content_type=JSON).document
    drawn = likelihood(ChirpModel(), analysis).draw_marginalised(SIGNAL, seed=np.array(numbers))
    assert told["reference_phase"] == drawn.parameters["reference_phase"].tolist()
    assert told["log_likelihood"] == drawn.log_likelihood.tolist()
    assert "distance_mpc" not in told
    nothing = ask(server.address, "POST", PATH, body, content_type=JSON)
    assert (nothing.status, nothing.document["code"]) == (422, "request-invalid")
    assert "integrates over nothing" in nothing.document["detail"]


def test_gradients_with_a_model_without_derivatives_are_refused(server):
    body = json.dumps({"parameters": SIGNAL, "output": "gradients"})
    refused = ask(server.address, "POST", PATH, body, content_type=JSON)
    assert (refused.status, refused.document["code"]) == (422, "request-invalid")
    assert "does not say that it has derivatives" in refused.document["detail"]


@pytest.mark.parametrize("output", ["products", "draws"])
def test_large_requests_for_more_are_divided_and_grouped_without_a_trace(server, output):
    analysis = small_analysis(phase_marginalisation=True)
    upload(server.address, analysis)
    batch, numbers = samples(64), np.random.default_rng(2).random((64, 3)) if output == "draws" else None
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"

    def asked(rows):
        part = None if numbers is None else numbers[rows]
        body = encode_likelihood_request(analysis.digest, batch.rows(rows), output, part)
        answer = ask(server.address, "POST", path, body, content_type=MSGPACK)
        assert answer.status == 200, answer.body
        return read_msgpack(answer.body)

    whole = asked(slice(0, 64))
    pieces = [slice(start, start + 7) for start in range(0, 63, 7)]
    with ThreadPoolExecutor(8) as threads:
        for rows, part in zip(pieces, threads.map(asked, pieces), strict=True):
            for name in ("log_likelihood", "reference_phase" if output == "draws" else "d_inner_h"):
                assert part[name].tobytes() == whole[name][rows].tobytes()
    assert all(len(array) == 0 for array in asked(slice(0, 0)).values() if isinstance(array, np.ndarray))


@pytest.mark.parametrize("output", ["products", "draws"])
def test_the_largest_request_fits_into_the_smallest_queue_whatever_it_asks_for(start, output):
    """It was refused for ever: what it costs is more than a likelihood, and so is each of its pieces."""
    limits = {"max_rows": 64, "max_samples": 2**18, "queue_samples": 2**18 + 64 * 1_000 + 10_000}
    server = start(ChirpModel(), threads=2, group_samples=2**14, **limits)
    analysis = small_analysis(f_max=360.0, phase_marginalisation=True)
    assert 0.9 < 64 * likelihood_samples(analysis) / 2**18 <= 1.0
    upload(server.address, analysis)
    numbers = np.full((64, 3), 0.5) if output == "draws" else None
    body = encode_likelihood_request(analysis.digest, samples(64), output, numbers)
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"
    answer = ask(server.address, "POST", path, body, content_type=MSGPACK)
    assert answer.status == 200, answer.body


def test_a_version_or_a_label_may_be_named(server):
    for middle in ("versions/1.0.0/", "versions/stable/"):
        answer = evaluate(server.address, BATCH, f"/v1/models/chirp/{middle}likelihoods/{NAME}")
        assert same_bits(answer, LOCAL.log_likelihood(BATCH))


def test_an_empty_batch_has_an_empty_answer(server):
    assert same_bits(evaluate(server.address, samples(0)), np.zeros(0))


BAD_ROWS = {
    "outside the prior": ({"mass_ratio": 3.5}, RowStatus.OUT_OF_PRIOR),
    "outside the model's range": ({"lambda_1": 6000.0}, RowStatus.OUT_OF_DOMAIN),
    "not a number": ({"chi_1": np.nan}, RowStatus.NOT_FINITE),
    "infinite": ({"distance_mpc": np.inf}, RowStatus.NOT_FINITE),
    "too late": ({"coalescence_time": 0.2}, RowStatus.OUT_OF_PRIOR),
}


@pytest.mark.parametrize(("change", "status"), BAD_ROWS.values(), ids=BAD_ROWS)
def test_rows_that_cannot_be_are_minus_infinity_with_a_reason_and_the_others_do_not_notice(server, change, status):
    batch = samples(5)
    for name, bad in change.items():
        batch[name][3] = bad
    told = read_msgpack(evaluate(server.address, batch).body)
    expected = LOCAL.evaluate(batch)
    assert told["log_likelihood"].tobytes() == expected.log_likelihood.tobytes()
    assert told["status"].tolist() == [0, 0, 0, status, 0]
    assert told["log_likelihood"][3] == -np.inf


@pytest.mark.parametrize("rows", [1, 2, 16, 64])
def test_a_row_has_the_same_bits_in_any_batch(server, rows):
    batch = samples(64)
    parts = [read_msgpack(evaluate(server.address, part).body)["log_likelihood"] for part in batch.split(rows)]
    assert np.concatenate(parts).tobytes() == LOCAL.log_likelihood(batch).tobytes()


def test_large_requests_are_shared_out_to_all_workers_with_the_same_bits(start):
    server = start(ChirpModel(), threads=3, group_samples=2**10, max_rows=4096, max_samples=2**20)
    upload(server.address, ANALYSIS)
    batch = samples(1000)
    assert same_bits(evaluate(server.address, batch), LOCAL.log_likelihood(batch))
    assert value(server, "bnserve_group_requests_count") == 3


def test_calibration_errors_travel_too(server):
    analysis = small_analysis(calibration=Calibration(nodes=5, f_min=20.0, f_max=64.0))
    upload(server.address, analysis)
    random = np.random.default_rng(3)
    errors = {name: random.normal(scale=0.05, size=(7, 5)) for name in ("H1", "L1")}
    batch = samples(7, calibration_amplitude=errors, calibration_phase={"H1": 0.5 * errors["H1"]})
    body = encode_likelihood_request(analysis.digest, batch)
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"
    answer = ask(server.address, "POST", path, body, content_type=MSGPACK)
    expected = likelihood(ChirpModel(), analysis).log_likelihood(batch)
    assert same_bits(answer, expected)
    without = likelihood(ChirpModel(), analysis).log_likelihood(samples(7))
    assert not np.allclose(expected, without, rtol=0.0, atol=1e-3)


def test_what_is_marginalised_may_be_left_out(server):
    analysis = small_analysis(phase_marginalisation=True)
    upload(server.address, analysis)
    path = f"/v1/models/chirp/likelihoods/{name_of(analysis)}"
    answer = ask(server.address, "POST", path, msgpack.packb({"parameters": SIGNAL}), content_type=MSGPACK)
    assert same_bits(answer, likelihood(ChirpModel(), analysis).log_likelihood(SIGNAL))


def test_what_is_not_may_not(server):
    message = {"parameters": {name: value for name, value in SIGNAL.items() if name != "distance_mpc"}}
    answer = ask(server.address, "POST", PATH, msgpack.packb(message), content_type=MSGPACK)
    assert (answer.status, answer.code) == (422, "parameters-invalid")
    assert "distance_mpc" in answer.document["detail"]


def test_one_callers_mistake_is_not_anothers(start):
    """Requests that wait together are evaluated together; only the one that is wrong is refused."""
    server = start(ChirpModel(), threads=1)
    upload(server.address, ANALYSIS)
    wrong = samples(2, calibration_phase={"H1": np.zeros((2, 4))})
    batches = [wrong if number % 3 == 0 else samples(3, seed=number) for number in range(24)]
    with ThreadPoolExecutor(12) as callers:
        answers = list(callers.map(lambda batch: evaluate(server.address, batch), batches))
    for batch, answer in zip(batches, answers, strict=True):
        if batch is wrong:
            assert (answer.status, answer.code) == (422, "parameters-invalid")
        else:
            assert same_bits(answer, LOCAL.log_likelihood(batch))


def test_log_likelihoods_are_counted_by_status(start):
    server = start(ChirpModel())
    upload(server.address, ANALYSIS)
    batch = samples(6)
    batch["mass_ratio"][:2] = 3.5
    evaluate(server.address, batch)
    assert value(server, "bnserve_likelihoods_total", model="chirp", status="ok") == 4
    assert value(server, "bnserve_likelihoods_total", model="chirp", status="out_of_prior") == 2
    assert value(server, "bnserve_analyses") == 1
    assert value(server, "bnserve_analyses_bytes") > ANALYSIS.nbytes


@pytest.fixture(scope="module")
def document(server):
    return ask(server.address, "GET", "/openapi.json").document


def schema(document, name):
    return {"$ref": f"#/components/schemas/{name}", "components": document["components"]}


def test_bodies_fit_the_openapi_document(server, document):
    operation = document["paths"]["/v1/models/{name}/likelihoods/{sha256}"]["post"]
    example = operation["requestBody"]["content"][JSON]["example"]
    for message in (
        example,
        {"parameters": columns(BATCH)},
        {"parameters": BATCH.values.tolist(), "names": list(LIKELIHOOD_NAMES)},
    ):
        jsonschema.validate(message, schema(document, "LikelihoodRequest"))
        answer = ask(server.address, "POST", PATH, json.dumps(message), content_type=JSON)
        assert answer.status == 200
        jsonschema.validate(answer.document, schema(document, "LikelihoodAnswer"))
    described = ask(server.address, "GET", f"/v1/analyses/{NAME}").document
    jsonschema.validate(described, schema(document, "AnalysisDocument"))


@pytest.mark.parametrize("message", [{"parameters": SIGNAL | {"time_shift": 0.0}}, {"parameters": SIGNAL, "x": 1}, {}])
def test_what_the_schema_forbids_is_refused(server, document, message):
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(message, schema(document, "LikelihoodRequest"))
    assert ask(server.address, "POST", PATH, json.dumps(message), content_type=JSON).status in (400, 422)


@pytest.mark.parametrize(("accept", "kind"), [(MSGPACK, str), ("application/msgpack;keys=bytes", bytes)])
def test_names_in_arrays_are_text_or_what_msgpack_numpy_reads(server, accept, kind):
    answer = evaluate(server.address, BATCH, accept=accept)
    assert answer.headers["content-type"] == accept
    assert {type(name) for name in msgpack.unpackb(answer.body)["log_likelihood"]} == {kind}
