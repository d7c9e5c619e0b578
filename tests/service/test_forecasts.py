"""Forecasts: a network from its upload to its end, questions in it, and everything about both that is refused."""

import hashlib
import json

import msgpack
import numpy as np
import pytest

from bnserve_inference.fisher import ForecastOptions, Network, forecast, signal_to_noise
from bnserve_protocol import FORECAST_COORDINATES, SKY_NAMES, RowStatus, decode_network, from_triangle
from bnserve_service import BackgroundServer, Settings, Token
from bnserve_surrogate import Model
from tests.service.asking import JSON, MSGPACK, ask, read_msgpack
from tests.service.chirp import ChirpModel
from tests.service.networks import BINARY, SIXTEEN, network, put
from tests.service.networks import forecast as evaluate
from tests.service.test_metrics import value

ONE = {"parameters": BINARY, "modes": [[2, 2]]}
MINE, YOURS = ({"authorization": f"Bearer the-token-of-{name}"} for name in ("mine", "yours"))


@pytest.fixture(scope="module")
def address():
    """The shipped models."""
    with BackgroundServer(Settings(port=0)) as server:
        yield server.address


@pytest.fixture(scope="module")
def sha256(address):
    answer, sha256 = put(address, network())
    assert answer.status == 201
    return sha256


def refusal(answer, status, code, *words):
    assert (answer.status, answer.code) == (status, code), answer.body
    for word in words:
        assert word in answer.document["detail"]


def local(told=None, columns=BINARY, options=ForecastOptions(modes=[(2, 2)]), of=forecast):  # noqa: B008  # frozen
    read = decode_network(json.dumps(told or network()).encode())
    return of(Model.default(), Network.of(read), columns, options)


def test_a_network_lives_from_its_upload_to_its_end(address):
    told = network(("E1", "H1"))
    answer, sha256 = put(address, told)
    at = f"/v1/networks/{sha256}"
    assert answer.status == 201
    assert answer.document == {
        "sha256": sha256, "detectors": ["E1", "H1"], "f_min": 20.0, "f_max": 1024.0, "trigger_time": 1187008882.4,
        "moving": True, "stored_bytes": len(json.dumps(told)),
    }  # fmt: skip
    assert put(address, told)[0].status == 200
    assert ask(address, "GET", at).document == answer.document
    assert ask(address, "HEAD", at.upper().replace("/V1/NETWORKS", "/v1/networks")).status == 200
    assert evaluate(address, sha256, ONE).status == 200
    assert ask(address, "DELETE", at).status == 204
    for answer in (ask(address, "GET", at), ask(address, "DELETE", at), evaluate(address, sha256, ONE)):
        refusal(answer, 404, "network-unknown", "PUT /v1/networks")
    assert ask(address, "HEAD", at).status == 404


def test_an_answer_is_what_is_computed_here(address, sha256):
    ours = local()
    told = evaluate(address, sha256, ONE | {"output": "covariance"}).document
    assert told["names"] == [*FORECAST_COORDINATES, *SKY_NAMES] == list(ours.names)
    assert told["network"] == f"sha256:{sha256}"
    assert told["model"]["name"] == "default"
    assert told["snr"] == ours.snr.tolist()
    assert told["detector_snr"] == ours.detector_snr.tolist()
    assert told["condition"] == ours.condition.tolist()
    assert told["errors"] == np.column_stack(list(ours.errors().values())).tolist()
    assert told["sky_area"] == ours.sky_area(np.array([BINARY["declination"]])).tolist()
    full = from_triangle(np.array(told["covariance"]), symmetric=True)
    assert np.array_equal(full, ours.covariance)
    assert told["status"] == told["singular"] == [0]
    assert told["beyond"] == ours.beyond.astype(int).tolist()
    assert "root" not in told
    roots = evaluate(address, sha256, ONE).document
    assert np.array_equal(from_triangle(np.array(roots["root"])), ours.root)
    ratios = evaluate(address, sha256, ONE | {"output": "snr"}).document
    assert ratios["snr"] == local(of=signal_to_noise).snr.tolist()
    assert ratios.keys() == {"model", "network", "names", "snr", "detector_snr", "status"}


def test_options_are_those_of_the_local_function(address, sha256):
    asked = {
        "coordinates": ["mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination",
                        "total_mass", "reference_phase", "coalescence_time"],
        "priors": {"lambda_1": 100.0, "chi_1": 0.05}, "alignment": "post_newtonian", "reference_frequency": 100.0,
    }  # fmt: skip
    ours = local(options=ForecastOptions(**asked, modes=[(2, 2)]))
    told = evaluate(address, sha256, ONE | asked | {"output": "errors"}).document
    assert told["names"][:2] == ["mass_ratio", "lambda_1"]
    assert told["errors"] == np.column_stack(list(ours.errors().values())).tolist()


def test_messagepack_says_what_json_says(address, sha256):
    body = msgpack.packb(ONE | {"output": "errors", "network": f"sha256:{sha256}"})
    path = f"/v1/models/default/versions/stable/forecasts/{sha256}"
    answer = ask(address, "POST", path, body, content_type=MSGPACK)
    packed = read_msgpack(answer.body)
    plain = evaluate(address, sha256, ONE | {"output": "errors"}).document
    for name in ("snr", "detector_snr", "errors", "sky_area", "condition", "status", "beyond", "singular"):
        assert packed[name].tolist() == plain[name], name
    whole = msgpack.packb(network())
    digest = hashlib.sha256(whole).hexdigest()
    assert ask(address, "PUT", f"/v1/networks/{digest}", whole, content_type=MSGPACK).status in (200, 201)
    again = evaluate(address, digest, ONE | {"output": "errors"}).document
    assert again["errors"] == plain["errors"]


def test_rows_that_are_none_are_flagged_and_the_others_are_as_they_are(address, sha256):
    columns = BINARY | {"mass_ratio": [1.2, 99.0, 1.2], "lambda_1": [400.0, 400.0, 500.0]}
    told = evaluate(address, sha256, {"parameters": columns, "modes": [[2, 2]]}).document
    assert told["status"] == [RowStatus.OK, RowStatus.OUT_OF_DOMAIN, RowStatus.OK]
    assert told["snr"][1] is None
    assert told["root"][1] == [None] * 91
    assert told["root"][0] == evaluate(address, sha256, ONE).document["root"][0]
    nobody = evaluate(address, sha256, {"parameters": {name: [] for name in BINARY}, "modes": [[2, 2]]})
    assert (nobody.status, nobody.document["snr"]) == (200, [])
    body = msgpack.packb(ONE | {"parameters": BINARY | {"right_ascension": float("nan")}})
    answer = ask(address, "POST", f"/v1/models/default/forecasts/{sha256}", body, content_type=MSGPACK, accept=JSON)
    assert answer.document["status"] == [RowStatus.NOT_FINITE]
    nowhere = ONE | {"parameters": BINARY | {"declination": [9.0, -0.4, -0.4], "coalescence_time": [0.0, 1e12, 0.0]}}
    for output in ("errors", "snr"):
        found = evaluate(address, sha256, nowhere | {"output": output}).document
        assert found["status"] == [RowStatus.OUT_OF_DOMAIN, RowStatus.OUT_OF_DOMAIN, RowStatus.OK]
        assert found["snr"][:2] == [None, None]
    above = evaluate(address, sha256, ONE | {"reference_frequency": 5e4}).document
    assert above["status"] == [RowStatus.OUT_OF_BAND]


def test_what_is_not_measured_is_said(address):
    _, one = put(address, network(("E1",), moving=False))
    told = evaluate(address, one, ONE | {"output": "errors"}).document
    assert told["singular"] == [1]
    assert told["errors"] == [[None] * 13]
    assert told["sky_area"] == [None]
    assert told["snr"][0] > 100.0


CURVE = {"frequencies": [10.0, 100.0, 2000.0], "asd": [1e-23, 1e-24, 1e-24]}
BAD_NETWORKS = {
    "unknown detector": (network(("X7",)), "analysis-invalid", "no detector 'X7'"),
    "unknown curve": (network(noise="ET-X"), "analysis-invalid", "no noise curve 'ET-X'"),
    "curve of zeros": (network(noise=CURVE | {"asd": [0.0, 1e-24, 1e-24]}), "analysis-invalid", "positive and finite"),
    "a PSD": (network(noise=CURVE | {"asd": [1e-46, 1e-48, 1e-48]}), "analysis-invalid", "PSD"),
    "curve backwards": (network(noise=CURVE | {"frequencies": [3.0, 2.0, 1.0]}), "analysis-invalid", "increasing"),
    "two lengths": (network(noise=CURVE | {"asd": [1e-24]}), "analysis-invalid", "one length"),
    "half a curve": (network(noise={"asd": [1e-24]}), "body-undecodable", "frequencies"),
    "band outside": (network(noise=CURVE, f_min=3000.0, f_max=4000.0), "analysis-invalid", "None of the noise curves"),
    "no band": (network(f_min=20.0, f_max=20.0), "analysis-invalid", "0 < f_min < f_max"),
    "a band without room": (network(f_min=100.0, f_max=100.00000000000001), "analysis-invalid", "a millionth of f_min"),
    "a band without end": (network(f_min=1e-300, f_max=1e300), "analysis-invalid", "from 1e-06 to 1e+06 Hz"),
    "a curve beyond numbers": (network(noise=CURVE | {"asd": [1e308] * 3}), "analysis-invalid", "leave such"),
    "arms alone": (
        network() | {"detectors": [{"name": "E1", "noise": "ET-D", "arms": [[1e4, 0, 0], [0, 1e4, 0]]}]},
        "analysis-invalid",
        "arms if their length counts",
    ),
    "a deaf detector": (
        network() | {"detectors": [{"name": "X1", "noise": "ET-D", "location": [0] * 3, "response": [[0] * 3] * 3}]},
        "analysis-invalid",
        "hears no gravitational wave",
    ),
    "no time": (network(trigger_time=-1.0), "analysis-invalid", "GPS time"),
    "no detectors": (network(()), "body-undecodable", "detectors"),
    "too many": (network((*SIXTEEN, "K1")), "body-undecodable", "detectors"),
    "one twice": (network(("E1", "H1", "E1")), "analysis-invalid", "got 'E1' 2 times"),
    "a field more": (network(colour="blue"), "body-undecodable", "colour"),
    "a name of a terminal": (network(("E1\x1b[2J",)), "body-undecodable", "name"),
    "half a detector": (
        network() | {"detectors": [{"name": "E1", "noise": "ET-D", "location": [6.4e6, 0.0, 0.0]}]},
        "analysis-invalid",
        "response and a location",
    ),
    "in kilometres": (
        network()
        | {
            "detectors": [
                {"name": "E1", "noise": "ET-D", "location": [6378.0, 0, 0], "response": [[0] * 3] * 3}
            ]
        },
        "analysis-invalid",
        "kilometres",
    ),
    "a key twice": (b'{"f_min": 20, ' + json.dumps(network()).encode()[1:], "body-undecodable", "twice"),
    "no object": (b"[]", "body-undecodable", "network"),
    "nothing": (b"", "body-undecodable", "network"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD_NETWORKS.values(), ids=BAD_NETWORKS)
def test_networks_that_are_none_are_refused(address, case):
    told, code, words = case
    answer, sha256 = put(address, told)
    refusal(answer, 400 if code == "body-undecodable" else 422, code, words)
    assert ask(address, "HEAD", f"/v1/networks/{sha256}").status == 404


def test_numbers_that_are_none_are_refused_in_messagepack_too(address):
    body = msgpack.packb(network(noise=CURVE | {"asd": [float("nan"), 1e-24, 1e-24]}))
    at = f"/v1/networks/{hashlib.sha256(body).hexdigest()}"
    refusal(ask(address, "PUT", at, body, content_type=MSGPACK), 422, "analysis-invalid", "positive and finite")
    body = msgpack.packb(network(f_min=float("nan")))
    at = f"/v1/networks/{hashlib.sha256(body).hexdigest()}"
    refusal(ask(address, "PUT", at, body, content_type=MSGPACK), 422, "analysis-invalid", "0 < f_min")


def test_blanks_before_a_network_are_no_messagepack(address):
    for blanks in (b" " * 1000, b"\r\n\t "):
        assert put(address, blanks + json.dumps(network()).encode())[0].status == 201


def test_a_network_goes_by_its_own_bytes(address):
    body = json.dumps(network()).encode()
    answer = ask(address, "PUT", f"/v1/networks/{'0' * 64}", body, content_type=JSON)
    refusal(answer, 422, "analysis-invalid", hashlib.sha256(body).hexdigest())
    refusal(put(address, network(), content_type="text/plain")[0], 415, "media-type-unsupported")


BAD_QUESTIONS = {
    "a prior of no width": ({"priors": {"chi_1": 0.0}}, 422, "request-invalid", "positive width"),
    "a prior of nothing": ({"priors": {"mass": 1.0}}, 422, "request-invalid", "positive width"),
    "no coordinates": ({"coordinates": []}, 422, "request-invalid", "got 0"),
    "other coordinates": ({"coordinates": ["colour"] * 10}, 422, "request-invalid", "colour"),
    "a mode that there is not": ({"modes": [[5, 5]]}, 422, "analysis-invalid", "(5, 5)"),
    "no modes": ({"modes": []}, 422, "request-invalid", "none"),
    "a frequency that is none": ({"reference_frequency": -1.0}, 422, "request-invalid", "reference frequency"),
    "another alignment": ({"alignment": "sideways"}, 400, "body-undecodable", "sideways"),
    "another output": ({"output": "everything"}, 400, "body-undecodable", "everything"),
    "a field more": ({"colour": 1}, 400, "body-undecodable", "colour"),
    "another network": ({"network": "sha256:" + "0" * 64}, 422, "request-invalid", "another network"),
    "no time": (
        {"parameters": {name: number for name, number in BINARY.items() if name != "coalescence_time"}},
        422,
        "parameters-invalid",
        "coalescence_time",
    ),
    "spins in the plane": ({"parameters": BINARY | {"chi_1x": 0.1}}, 422, "parameters-invalid", "chi_1x"),
}


NO_JSON = "JSON has no NaN and no Infinity"


def test_numbers_that_json_does_not_have_are_named(address, sha256):
    nan = ONE | {"parameters": BINARY | {"distance_mpc": float("nan")}}
    refusal(evaluate(address, sha256, nan), 400, "body-undecodable", NO_JSON)
    refusal(put(address, network(f_min=float("inf")))[0], 400, "body-undecodable", NO_JSON)
    waveform = {"parameters": {"mass_ratio": float("nan")}, "grid": {"frequencies": [20.0]}}
    answer = ask(address, "POST", "/v1/models/default/waveforms", json.dumps(waveform), content_type=JSON)
    refusal(answer, 400, "body-undecodable", NO_JSON)


@pytest.mark.parametrize("case", BAD_QUESTIONS.values(), ids=BAD_QUESTIONS)
def test_questions_that_are_none_are_refused(address, sha256, case):
    change, status, code, words = case
    refusal(evaluate(address, sha256, ONE | change), status, code, words)


def test_a_model_without_derivatives_has_signal_to_noise_ratios_alone(start):
    address = start(ChirpModel()).address
    _, sha256 = put(address, network())
    asked = {"parameters": BINARY}
    refusal(evaluate(address, sha256, asked, model="chirp"), 422, "request-invalid", "derivatives")
    assert evaluate(address, sha256, asked | {"output": "snr"}, model="chirp").document["snr"][0] > 0.0


def test_a_model_of_a_network_has_forecasts(address, sha256):
    told = evaluate(address, sha256, ONE | {"output": "errors"}, model="paper").document
    assert told["snr"] == pytest.approx(local().snr.tolist(), rel=1e-2)
    assert (np.array(told["errors"]) > 0.0).all()


def test_sizes_are_limited(start):
    server = start(ChirpModel(), max_rows=8, max_network_bytes=1024)
    answer, sha256 = put(server.address, network())
    assert answer.status == 201
    many = {"parameters": BINARY | {"lambda_1": [400.0] * 9}}
    refusal(evaluate(server.address, sha256, many, model="chirp"), 413, "too-large", "at most 8 rows")
    refusal(put(server.address, network(SIXTEEN, noise=CURVE))[0], 413, "too-large", "1024")
    assert ask(server.address, "GET", "/v1/limits").document["max_network_bytes"] == 1024


def test_work_is_limited(start):
    server = start(ChirpModel(), max_samples=9_000)
    _, sha256 = put(server.address, network())
    asked = {"parameters": BINARY, "output": "snr"}
    more = asked | {"parameters": BINARY | {"lambda_1": [400.0] * 6}}
    refusal(evaluate(server.address, sha256, more, model="chirp"), 413, "too-large", "at most 1 at a time")
    _, sha256 = put(server.address, network(SIXTEEN))
    refusal(evaluate(server.address, sha256, asked, model="chirp"), 413, "too-large", "fewer detectors")


@pytest.fixture
def of_two(start):
    tokens = (
        Token.of("the-token-of-mine", max_stored_bytes=2000),
        Token.of("the-token-of-yours"),
        Token.of("the-token-of-reads", scopes=("evaluate",)),
    )
    return start(ChirpModel(), tokens=tokens)


def test_a_network_of_another_token_is_as_unknown(of_two):
    address = of_two.address
    asked = {"parameters": BINARY, "output": "snr"}
    answer, sha256 = put(address, network(), **MINE)
    assert answer.status == 201
    for method in ("GET", "HEAD", "DELETE"):
        assert ask(address, method, f"/v1/networks/{sha256}", **YOURS).status == 404
    refusal(evaluate(address, sha256, asked, model="chirp", **YOURS), 404, "network-unknown")
    assert put(address, network(), **YOURS)[0].status == 201, "it is new to them"
    assert ask(address, "DELETE", f"/v1/networks/{sha256}", **YOURS).status == 204
    assert ask(address, "HEAD", f"/v1/networks/{sha256}", **MINE).status == 200
    reads = {"authorization": "Bearer the-token-of-reads"}
    refusal(put(address, network(), **reads)[0], 403, "forbidden")


def test_networks_count_towards_what_a_token_may_keep(of_two):
    larger = network(noise={"frequencies": list(range(1, 99)), "asd": [1e-24] * 98})
    refusal(put(of_two.address, larger, **MINE)[0], 413, "too-large", "2000 bytes")
    assert put(of_two.address, larger, **YOURS)[0].status == 201


def test_they_are_counted(start):
    server = start(ChirpModel())
    _, sha256 = put(server.address, network())
    asked = {"parameters": BINARY | {"mass_ratio": [1.2, 1.3]}, "output": "snr"}
    assert evaluate(server.address, sha256, asked, model="chirp").status == 200
    assert value(server, "bnserve_forecasts_total", model="chirp", status="ok") == 2.0
    assert value(server, "bnserve_networks") == 1.0
