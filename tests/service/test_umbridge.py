"""UM-Bridge: its own client, and whatever else a stranger may send to its paths."""

import base64
import json

import emcee
import jsonschema
import numpy as np
import pytest
import requests
import umbridge
from umbridge.emcee import UmbridgeLogProb

from bnserve_inference import likelihood
from bnserve_protocol import LIKELIHOOD_NAMES
from bnserve_service import BackgroundServer, Settings, Token
from bnserve_surrogate import Model
from tests.service.asking import JSON, ask
from tests.service.chirp import ChirpModel, MemorySource, as_it_is
from tests.service.conftest import SMALL_LIMITS
from tests.service.injections import SIGNAL, name_of, small_analysis, upload
from tests.service.test_metrics import value

ANALYSIS = small_analysis(phase_marginalisation=True)
NAMES = [name for name in LIKELIHOOD_NAMES if name != "reference_phase"]
POINT = [SIGNAL[name] for name in NAMES]
NAME, OF_DEFAULT = f"chirp/{name_of(ANALYSIS)}", f"default/{name_of(ANALYSIS)}"
OUTSIDE = [9.0 if name == "mass_ratio" else SIGNAL[name] for name in NAMES]
LOCAL = likelihood(ChirpModel(), ANALYSIS)
STRICT = json.JSONDecoder(parse_constant=lambda text: pytest.fail(f"{text} is no JSON"))


@pytest.fixture(scope="module")
def server():
    """Of the chirp, which has no derivatives, and of a model that has."""
    source = MemorySource().add(ChirpModel()).add(Model.default())
    with BackgroundServer(Settings(**SMALL_LIMITS), source=source, factory=as_it_is) as it:
        assert upload(it.address, ANALYSIS).status == 201
        yield it


@pytest.fixture(scope="module")
def surrogate():
    """The likelihood of the model that has derivatives, here."""
    return likelihood(Model.default(), ANALYSIS)


@pytest.fixture
def url(server):
    return f"{server.address}/v1/umbridge"


def post(address, operation, message, **headers):
    body = message if isinstance(message, bytes | str) else json.dumps(message)
    headers.setdefault("content_type", JSON)
    return ask(address, "POST", f"/v1/umbridge/{operation}", body, **headers)


def error(answer):
    """The type of an error, after checking that the body is one and nothing else."""
    told = STRICT.decode(answer.body.decode())
    assert answer.headers["content-type"] == JSON
    assert set(told) == {"error"}
    assert set(told["error"]) == {"type", "message"}
    assert told["error"]["message"]
    assert len(answer.body) < 4096, "an error does not repeat its input"
    return answer.status, told["error"]["type"]


# Its clients


def test_its_client_evaluates_an_uploaded_analysis(url):
    assert set(umbridge.supported_models(url)) >= {NAME, OF_DEFAULT}
    model = umbridge.HTTPModel(url, NAME)
    assert model.supports_evaluate()
    assert not model.supports_apply_hessian()
    assert (model.get_input_sizes(), model.get_output_sizes()) == ([12], [1])
    assert model([POINT]) == [LOCAL.log_likelihood(SIGNAL).tolist()]
    assert model([OUTSIDE]) == [[-np.inf]]


def test_some_parameters_may_be_fixed(url):
    model = umbridge.HTTPModel(url, NAME)
    config = {"fixed": {name: SIGNAL[name] for name in NAMES if name not in ("mass_ratio", "distance_mpc")}}
    assert model.get_input_sizes(config) == [2]
    assert (
        model([[1.3, 50.0]], config)[0][0]
        == LOCAL.log_likelihood(SIGNAL | {"mass_ratio": 1.3, "distance_mpc": 50.0})[0]
    )


def test_emcee_samples_through_its_client(url):
    config = {"fixed": {name: SIGNAL[name] for name in NAMES if name not in ("mass_ratio", "distance_mpc")}}
    density = UmbridgeLogProb(url, NAME, config)
    start = [1.2, 40.0] + np.random.default_rng(1).normal(size=(8, 2)) * [0.01, 0.5]
    sampler = emcee.EnsembleSampler(8, density.ndim, density)
    sampler.run_mcmc(start, 10)
    chain, values = sampler.get_chain(flat=True), sampler.get_log_prob(flat=True)
    batch = SIGNAL | {"mass_ratio": chain[:, 0], "distance_mpc": chain[:, 1]}
    assert values.tolist() == LOCAL.log_likelihood(batch).tolist()
    assert np.ptp(values) > 1.0


def test_minus_infinity_has_another_number_for_those_whose_json_has_none(server):
    asked = {"name": NAME, "input": [OUTSIDE]}
    assert post(server.address, "Evaluate", asked).body == b'{"output": [[-Infinity]]}'
    answer = post(server.address, "Evaluate", asked | {"config": {"outside": -1e300}})
    assert STRICT.decode(answer.body.decode()) == {"output": [[-1e300]]}
    inside = post(server.address, "Evaluate", {"name": NAME, "input": [POINT], "config": {"outside": -1e300}})
    assert inside.document["output"] == [LOCAL.log_likelihood(SIGNAL).tolist()]


@pytest.mark.parametrize("content_type", [JSON, "application/json; charset=utf-8", ""])
def test_bodies_need_not_say_that_they_are_json(server, content_type):
    answer = post(server.address, "Evaluate", {"name": NAME, "input": [POINT]}, content_type=content_type)
    assert answer.status == 200
    assert answer.headers["content-type"] == JSON


# Gradients


GRADIENT = {"name": OF_DEFAULT, "input": [POINT], "outWrt": 0, "inWrt": 0, "sens": [1.0]}
JACOBIAN = {key: entry for key, entry in GRADIENT.items() if key != "sens"} | {"vec": [1.0] * len(NAMES)}


def test_its_client_has_gradients_and_products_with_the_jacobian(url, surrogate):
    model = umbridge.HTTPModel(url, OF_DEFAULT)
    assert model.supports_gradient()
    assert model.supports_apply_jacobian()
    expected = surrogate.gradients(SIGNAL)
    assert list(expected.names) == NAMES
    assert model([POINT]) == [expected.log_likelihood.tolist()]
    assert model.gradient(0, 0, [POINT], [1.0]) == expected.gradient[0].tolist()
    assert model.gradient(0, 0, [POINT], [-2.0]) == (-2.0 * expected.gradient[0]).tolist()
    direction = np.linspace(-1.0, 1.0, len(NAMES))
    assert model.apply_jacobian(0, 0, [POINT], direction.tolist()) == [float(expected.gradient[0] @ direction)]
    with pytest.raises(Exception, match="not supported by model"):
        model.apply_hessian(0, 0, 0, [POINT], [1.0], POINT)


def test_gradients_are_in_what_is_not_fixed(url, surrogate):
    free = ("distance_mpc", "mass_ratio")
    config = {"fixed": {name: SIGNAL[name] for name in NAMES if name not in free}}
    model = umbridge.HTTPModel(url, OF_DEFAULT)
    point = [[SIGNAL["mass_ratio"], SIGNAL["distance_mpc"]]]
    expected = surrogate.gradients(SIGNAL).gradient[0]
    columns = [NAMES.index("mass_ratio"), NAMES.index("distance_mpc")]
    assert model.gradient(0, 0, point, [1.0], config) == expected[columns].tolist()
    assert model.apply_jacobian(0, 0, point, [0.0, 3.0], config) == [3.0 * expected[columns[1]]]


def test_where_the_likelihood_is_0_so_is_its_gradient(url):
    model = umbridge.HTTPModel(url, OF_DEFAULT)
    assert model([OUTSIDE]) == [[-np.inf]]
    assert model.gradient(0, 0, [OUTSIDE], [1.0]) == [0.0] * len(NAMES)
    assert model.apply_jacobian(0, 0, [OUTSIDE], [1.0] * len(NAMES)) == [0.0]


WRONG = {
    "no such output": ("Gradient", GRADIENT | {"outWrt": 1}),
    "no such input": ("Gradient", GRADIENT | {"inWrt": -1}),
    "an index that is none": ("Gradient", GRADIENT | {"inWrt": 0.5}),
    "no factor": ("Gradient", GRADIENT | {"sens": []}),
    "two factors": ("Gradient", GRADIENT | {"sens": [1.0, 1.0]}),
    "factors in a list": ("Gradient", GRADIENT | {"sens": [[1.0]]}),
    "no sens": ("Gradient", {"name": OF_DEFAULT, "input": [POINT], "outWrt": 0, "inWrt": 0}),
    "a vector for gradients": ("Gradient", JACOBIAN),
    "a short direction": ("ApplyJacobian", JACOBIAN | {"vec": [1.0]}),
    "no direction": ("ApplyJacobian", GRADIENT),
    "a direction of NaN": ("ApplyJacobian", JACOBIAN | {"vec": [np.nan] * len(NAMES)}),
    "a factor beyond numbers": ("Gradient", GRADIENT | {"sens": [1e300]}),
    "a direction beyond numbers": ("ApplyJacobian", JACOBIAN | {"vec": [-1e308] * len(NAMES)}),
    "no input": ("ApplyJacobian", JACOBIAN | {"input": []}),
}


@pytest.mark.parametrize(("operation", "message"), WRONG.values(), ids=WRONG)
def test_what_is_no_derivative_is_invalid_input(server, operation, message):
    assert error(post(server.address, operation, message)) == (400, "InvalidInput")


@pytest.mark.parametrize("operation", ["Gradient", "ApplyJacobian"])
def test_a_model_without_derivatives_says_so(server, url, operation):
    model = umbridge.HTTPModel(url, NAME)
    assert not model.supports_gradient()
    assert not model.supports_apply_jacobian()
    assert error(post(server.address, operation, {"name": NAME})) == (400, "UnsupportedFeature")


# What the protocol's own tests of conformity ask of a server


def test_answers_have_the_fields_of_the_protocol_and_no_others(server, url):
    assert requests.get(f"{url}/Info", timeout=60).json()["protocolVersion"] == 1.0
    for operation, keys in (
        ("ModelInfo", {"support"}),
        ("InputSizes", {"inputSizes"}),
        ("OutputSizes", {"outputSizes"}),
    ):
        assert set(post(server.address, operation, {"name": NAME}).document) == keys
    support = post(server.address, "ModelInfo", {"name": NAME}).document["support"]
    assert {name for name, kind in support.items() if isinstance(kind, bool)} == {
        "Evaluate", "Gradient", "ApplyJacobian", "ApplyHessian"
    }  # fmt: skip


@pytest.mark.parametrize("operation", ["ModelInfo", "InputSizes", "OutputSizes", "Evaluate", "ApplyHessian"])
@pytest.mark.parametrize(
    "name", ["wrong_model_name", "", f"chirp/{64 * '0'}", f"no/{name_of(ANALYSIS)}", f"chirp/9.9/{name_of(ANALYSIS)}"]
)
def test_an_unknown_model_is_not_found_whatever_else_is_missing(server, operation, name):
    assert error(post(server.address, operation, {"name": name})) == (400, "ModelNotFound")


def test_what_is_not_supported_is_said(server):
    assert error(post(server.address, "ApplyHessian", {"name": NAME})) == (400, "UnsupportedFeature")


# Strangers


GOOD = {"name": NAME, "input": [POINT]}
BAD = {
    "nothing": b"",
    "no JSON": b"{",
    "a list": b"[]",
    "no name": {"input": [POINT]},
    "a number for a name": GOOD | {"name": 1},
    "no input": {"name": NAME},
    "no vector": GOOD | {"input": []},
    "two vectors": GOOD | {"input": [POINT, POINT]},
    "one number too many": GOOD | {"input": [[*POINT, 0.0]]},
    "one too few": GOOD | {"input": [POINT[:-1]]},
    "not nested": GOOD | {"input": POINT},
    "nested twice": GOOD | {"input": [[POINT]]},
    "nested for ever": b'{"name": "' + NAME.encode() + b'", "input": ' + b"[" * 20_000,
    "text": GOOD | {"input": [["1.2", *POINT[1:]]]},
    "null": GOOD | {"input": [[None, *POINT[1:]]]},
    "NaN": GOOD | {"input": [[np.nan, *POINT[1:]]]},
    "a huge vector": GOOD | {"input": [[0] * 20_000]},
    "more than fits": GOOD | {"input": [[0] * 200_000]},
    "a field twice": json.dumps(GOOD)[:-1] + f', "input": {json.dumps([POINT])}}}',
    "an unknown field": GOOD | {"inputs": 1},
    "an unknown option": GOOD | {"config": {"order": 4}},
    "config is a list": GOOD | {"config": []},
    "fixed: unknown": GOOD | {"config": {"fixed": {"masss_ratio": 1.0}}},
    "fixed: integrated over": GOOD | {"config": {"fixed": {"reference_phase": 1.0}}},
    "fixed: text": GOOD | {"config": {"fixed": {"mass_ratio": "1"}}},
    "fixed: an enormous name": GOOD | {"config": {"fixed": {"x" * 20_000: 1.0}}},
}


@pytest.mark.parametrize("message", BAD.values(), ids=BAD)
def test_what_is_no_evaluation_is_invalid_input(server, message):
    assert error(post(server.address, "Evaluate", message)) == (400, "InvalidInput")
    assert post(server.address, "Evaluate", GOOD).status == 200


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity"])
@pytest.mark.parametrize("operation", ["Evaluate", "ModelInfo"])
def test_numbers_that_json_does_not_have_are_named(server, operation, number):
    body = json.dumps(GOOD | {"config": {"fixed": {"mass_ratio": 1.2}}}).replace("1.2}}", number + "}}")
    told = json.loads(post(server.address, operation, body).body)["error"]
    place = body.index(number) + number.startswith("-")
    assert told["type"] == "InvalidInput"
    assert told["message"].startswith(f"JSON has no NaN and no Infinity, and this request has one at byte {place}: ")


@pytest.mark.parametrize("operation", ["ModelInfo", "InputSizes", "OutputSizes"])
@pytest.mark.parametrize("message", [b"", b"[]", b'{"name": 1}', {"name": NAME, "config": 1}, b"[" * 20_000])
def test_what_is_no_question_about_a_model_is_invalid_input(server, operation, message):
    assert error(post(server.address, operation, message)) == (400, "InvalidInput")


def test_the_right_parameters_are_named_where_the_input_is_wrong(server):
    told = post(server.address, "Evaluate", GOOD | {"input": [[1.2]]}).document["error"]["message"]
    assert ", ".join(NAMES) in told
    document = ask(server.address, "GET", f"/v1/analyses/{name_of(ANALYSIS)}").document
    assert document["parameters"] == NAMES


def test_numbers_beyond_double_precision_are_no_likelihood(server):
    body = json.dumps(GOOD).replace("1.2,", "1e400,", 1)
    answer = post(server.address, "Evaluate", body)
    assert answer.body == b'{"output": [[-Infinity]]}' or error(answer) == (400, "InvalidInput")


@pytest.mark.parametrize("method", ["GET", "PUT", "DELETE"])
def test_other_methods_are_refused_in_the_same_form(server, method):
    answer = ask(server.address, method, "/v1/umbridge/Evaluate")
    assert error(answer)[0] == 405
    assert answer.headers["allow"] == "POST"


@pytest.mark.parametrize("content_type", ["text/plain", "application/msgpack", "application/x-www-form-urlencoded"])
def test_other_media_types_are_refused_with_advice(server, content_type):
    answer = post(server.address, "Evaluate", GOOD, content_type=content_type)
    assert error(answer) == (400, "InvalidInput")
    assert "Content-Type" in answer.document["error"]["message"]


def test_an_analysis_for_another_model_is_not_listed_and_cannot_be_asked(server, url):
    other = small_analysis(model_digest="sha256:other")
    upload(server.address, other)
    assert f"chirp/{name_of(other)}" not in umbridge.supported_models(url)
    asked = {"name": f"chirp/{name_of(other)}", "input": [[*POINT, 0.0]]}
    assert error(post(server.address, "Evaluate", asked)) == (400, "InvalidInput")


# The service's own promises


def test_evaluations_are_counted_as_likelihoods(server):
    before = value(server, "bnserve_likelihoods_total", model="chirp", status="ok")
    post(server.address, "Evaluate", GOOD)
    assert value(server, "bnserve_likelihoods_total", model="chirp", status="ok") == before + 1


def test_each_token_has_its_own_models_and_clients_give_it_as_a_password(start):
    secrets = ["first-secret-of-a-sampler", "second-secret-of-a-sampler"]
    server = start(ChirpModel(), tokens=tuple(Token.of(secret, secret[:6].strip("-")) for secret in secrets))
    assert upload(server.address, ANALYSIS, authorization=f"Bearer {secrets[0]}").status == 201
    first, second, nobody = (
        f"http://{who}{server.address.removeprefix('http://')}/v1/umbridge"
        for who in (f"bnserve:{secrets[0]}@", f"bnserve:{secrets[1]}@", "bnserve:wrong@")
    )
    assert umbridge.HTTPModel(first, NAME)([POINT]) == [LOCAL.log_likelihood(SIGNAL).tolist()]
    assert umbridge.supported_models(second) == []
    refused = requests.get(f"{nobody}/Info", timeout=60)
    assert (refused.status_code, refused.json()["error"]["type"]) == (401, "Unauthorized")
    basic = base64.b64encode(f"bnserve:{secrets[0]}".encode()).decode()
    elsewhere = ask(server.address, "GET", "/v1/models", authorization=f"Basic {basic}")
    assert elsewhere.status == 401, "elsewhere a token is a bearer's"


def test_the_document_describes_what_travels(server):
    document = ask(server.address, "GET", "/openapi.json").document
    post_ = document["paths"]["/v1/umbridge/Evaluate"]["post"]
    assert set(post_["requestBody"]["content"]) == {JSON}
    schema = {"$ref": "#/components/schemas/UmBridgeEvaluateRequest", "components": document["components"]}
    jsonschema.validate(GOOD | {"config": {"fixed": {"mass_ratio": 1.2}, "outside": -1e300}}, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(GOOD | {"inputs": 1}, schema)
    problem = {"$ref": "#/components/schemas/UmBridgeProblem", "components": document["components"]}
    jsonschema.validate(post(server.address, "Evaluate", {"name": "x"}).document, problem)
