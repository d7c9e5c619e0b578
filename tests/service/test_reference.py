"""The OpenAPI document is valid and says what the service does; the pages need nothing from elsewhere."""

import re
from importlib.resources import files

import jsonschema
import pytest
from openapi_spec_validator import validate

from bnserve_protocol import IN_PLANE_NAMES, PARAMETER_NAMES
from bnserve_service.reference.explorer import PAGES
from tests.service.asking import GW170817, JSON, MSGPACK, ask, evaluate_json, question


@pytest.fixture(scope="module")
def document(server):
    return ask(server.address, "GET", "/openapi.json").document


def schema(document, name):
    return {"$ref": f"#/components/schemas/{name}", "components": document["components"]}


def test_it_is_valid_openapi(document):
    validate(document)
    assert document["openapi"].startswith("3.1")


def test_every_path_is_described_and_nothing_else(server, document):
    described = {(path, method.upper()) for path, methods in document["paths"].items() for method in methods}
    expected = {
        ("/v1/models", "GET"),
        ("/v1/models/{name}", "GET"),
        ("/v1/models/{name}/versions/{version}", "GET"),
        ("/v1/models/{name}/waveforms", "POST"),
        ("/v1/models/{name}/versions/{version}/waveforms", "POST"),
        ("/v1/grids/{sha256}", "PUT"),
        ("/v1/grids/{sha256}", "HEAD"),
        ("/v1/analyses/{sha256}", "PUT"),
        ("/v1/analyses/{sha256}", "GET"),
        ("/v1/analyses/{sha256}", "HEAD"),
        ("/v1/analyses/{sha256}", "DELETE"),
        ("/v1/networks/{sha256}", "PUT"),
        ("/v1/networks/{sha256}", "GET"),
        ("/v1/networks/{sha256}", "HEAD"),
        ("/v1/networks/{sha256}", "DELETE"),
        ("/v1/models/{name}/likelihoods/{sha256}", "POST"),
        ("/v1/models/{name}/versions/{version}/likelihoods/{sha256}", "POST"),
        ("/v1/models/{name}/forecasts/{sha256}", "POST"),
        ("/v1/models/{name}/versions/{version}/forecasts/{sha256}", "POST"),
        ("/v1/umbridge/Info", "GET"),
        ("/v1/umbridge/ModelInfo", "POST"),
        ("/v1/umbridge/InputSizes", "POST"),
        ("/v1/umbridge/OutputSizes", "POST"),
        ("/v1/umbridge/Evaluate", "POST"),
        ("/v1/umbridge/Gradient", "POST"),
        ("/v1/umbridge/ApplyJacobian", "POST"),
        ("/v1/umbridge/ApplyHessian", "POST"),
        ("/v1/limits", "GET"),
        ("/v2/health/live", "GET"),
        ("/v2/health/ready", "GET"),
        ("/v2/models/{name}/ready", "GET"),
        ("/v1/manifest", "GET"),
        ("/v1/reload", "POST"),
        ("/metrics", "GET"),
    }
    assert described == expected
    for path, method in described:
        filled = re.sub(r"\{\w+\}", "chirp", path)
        answer = ask(server.address, method, filled)
        assert answer.status != 405, (method, path)
        if answer.status == 404 and answer.body:
            assert answer.code != "path-unknown", (method, path)


@pytest.mark.parametrize(
    ("path", "name"),
    [
        ("/v1/models", "ModelList"),
        ("/v1/models/chirp", "ModelDocument"),
        ("/v1/limits", "ServiceLimits"),
        ("/nowhere", "Problem"),
    ],
)
def test_answers_fit_their_schema(server, document, path, name):
    jsonschema.validate(ask(server.address, "GET", path).document, schema(document, name))


def test_nothing_is_claimed_that_is_not_so(document):
    assert "HTTPValidationError" not in str(document), "FastAPI's own form of errors, which is not ours"
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            assert "default" in operation["responses"], (method, path)


@pytest.mark.parametrize("output", ["polarizations", "factored", "amplitude_phase", "modes"])
def test_waveforms_fit_their_schema_in_json(server, document, output):
    answer = evaluate_json(server.address, question(output=output))
    jsonschema.validate(answer.document, schema(document, "WaveformAnswer"))


GOOD = [question(), question(names=list(GW170817), parameters=[list(GW170817.values())]), question(dtype="complex64")]
BAD = [
    question(outptu="modes"),
    question(output="mode"),
    question(GW170817 | {"lamda_1": 1}),
    {"parameters": GW170817},
    question(grid={"f_min": 1, "f_max": 2}),
    question(grid={"frequencies": "all"}),
]


@pytest.mark.parametrize("message", GOOD)
def test_what_the_schema_allows_is_answered(server, document, message):
    jsonschema.validate(message, schema(document, "WaveformRequest"))
    assert evaluate_json(server.address, message).status == 200


@pytest.mark.parametrize("message", BAD)
def test_what_the_schema_forbids_is_refused(server, document, message):
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(message, schema(document, "WaveformRequest"))
    assert evaluate_json(server.address, message).status in (400, 422)


def test_the_example_works(server, document):
    content = document["paths"]["/v1/models/{name}/waveforms"]["post"]["requestBody"]["content"]
    assert set(content) == {JSON, MSGPACK}
    assert evaluate_json(server.address, content[JSON]["example"]).status == 200


def test_parameters_are_those_of_the_protocol(document):
    forms = document["components"]["schemas"]["WaveformRequest"]["properties"]["parameters"]["oneOf"]
    assert set(forms[0]["properties"]) == {*PARAMETER_NAMES, *IN_PLANE_NAMES}


@pytest.mark.parametrize("name", ["WaveformRequest", "LikelihoodRequest"])
def test_every_field_and_parameter_of_a_request_is_described(document, name):
    fields = document["components"]["schemas"][name]["properties"]
    parameters = fields["parameters"]["oneOf"][0]["properties"]
    assert [key for key, field in (fields | parameters).items() if not field.get("description")] == []
    assert "in Mpc" in parameters["distance_mpc"]["description"]
    assert "in radians" in parameters["inclination"]["description"]
    assert not re.search(r":\w+:`|----", str([fields, parameters])), "marks of docstrings"


def test_what_is_left_out_is_described_as_what_it_is_taken_for(server, document):
    fields = document["components"]["schemas"]["WaveformRequest"]["properties"]
    defaults = {key: field["default"] for key, field in fields.items() if "default" in field}
    options = {"out_of_domain", "below_band", "above_band", "alignment", "modes", "reference_frequency"}
    assert set(defaults) == {"output", "dtype", *options}
    written = evaluate_json(server.address, question(**defaults))
    assert written.document == evaluate_json(server.address, question()).document


@pytest.mark.parametrize("path", PAGES)
def test_pages_load_nothing_from_elsewhere(server, path):
    answer = ask(server.address, "GET", path)
    assert answer.status == 200
    assert answer.headers["content-type"].startswith("text/html")
    assert "default-src 'none'" in answer.headers["content-security-policy"]
    assert "unsafe" not in answer.headers["content-security-policy"]
    page = answer.body.decode()
    assert "<noscript>" in page
    assert not re.search(r"<script>|<style| style=| on\w+=", page), "what the policy forbids"
    asked = re.findall(r"(?:src|href)=\"([^\"#]*)", page)
    assert len(asked) > 5
    for address in asked:  # without a / in front: behind a proxy, the pages may be somewhere below
        assert not re.match(r"\w+:|/", address)
        assert ask(server.address, "GET", f"/{address.removeprefix('.')}").status == 200, address


FILES = [path for path in (files("bnserve_service") / "pages").glob("*/*") if path.is_file()]


def test_files_of_pages_are_served_and_name_only_each_other(server):
    assert len(FILES) > 30
    for path in FILES:
        address = f"/pages/{path.parent.name}/{path.name}"
        answer = ask(server.address, "GET", address)
        assert (answer.status, answer.body) == (200, path.read_bytes())
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["cache-control"] == "no-cache"
        text = path.read_text().replace("http://www.w3.org/2000/svg", "")
        assert "@import" not in text
        assert not re.search(r"https?://\w", text), path
        for name in re.findall(r"^import .* from \"(.*)\";$", text, re.MULTILINE):
            assert (path.parent / name).is_file(), (path, name)


@pytest.mark.parametrize(
    "path", ["/pages/style/nothing.css", "/pages/nothing/base.css", "/pages/style/..", "/pages/style"]
)
def test_what_is_no_file_of_a_page_is_not_found(server, path):
    answer = ask(server.address, "GET", path)
    assert (answer.status, answer.code) == (404, "path-unknown")
