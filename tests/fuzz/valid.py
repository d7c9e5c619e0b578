"""Messages as they should be: where fuzzing starts."""

import tempfile
from functools import cache
from pathlib import Path

import httpx
import msgspec
import numpy as np

from bnserve_client import Model
from bnserve_protocol import (
    PARAMETER_NAMES,
    Calibration,
    DetectorNetwork,
    EvaluationOptions,
    FieldError,
    ForecastOptions,
    InvalidRequest,
    ModelIdentity,
    NetworkDetector,
    ParameterBatch,
    ParametersWithExtrinsic,
    UniformGrid,
    encode_analysis,
)
from bnserve_protocol.wire import (
    ForecastAnswer,
    GridDigest,
    LikelihoodAnswer,
    Problem,
    WaveformRequest,
    encode_answer,
    encode_forecast_answer,
    encode_forecast_request,
    encode_likelihood_answer,
    encode_likelihood_request,
    encode_request,
)
from bnserve_store import ModelStore
from bnserve_store._files import decode_tensors, encode_manifest, encode_tensors
from bnserve_store._publishing import describe
from bnserve_store._reading import LABELS_FILE, MANIFEST_FILE, TENSORS_FILE
from tests.client.reference_model import ReferenceModel, binaries
from tests.client.reference_service import ReferenceService
from tests.fuzz.conversation import HEAD, MARK
from tests.service.asking import GW170817, question
from tests.service.injections import name_of, samples, small_analysis
from tests.service.networks import BINARY, network

FREQUENCIES = np.linspace(20.0, 100.0, 9)
ANALYSIS = small_analysis(f_max=22.0, calibration=Calibration(nodes=4, f_min=20.0, f_max=22.0))
IDENTITY = ModelIdentity(name="default", version="1.0.0", digest=ReferenceModel.description.digest)


def waveform_requests() -> list[bytes]:
    """In MessagePack: every form of a grid, a map of columns, and rows with names."""
    grids = (FREQUENCIES, UniformGrid(f_min=20.0, f_max=40.0, delta_f=2.5), GridDigest(sha256="0" * 64))
    batch = ParameterBatch.coerce(binaries(3))
    options = EvaluationOptions(out_of_domain="flag", below_band="error", above_band="error", alignment="merger")
    ours = [encode_request(WaveformRequest(batch=batch, grid=grid, options=options)) for grid in grids]
    options = msgspec.structs.replace(options, modes=[(2, 2), (3, 3)], reference_frequency=20.0)
    ours.append(encode_request(WaveformRequest(batch=batch, grid=FREQUENCIES, output="modes", options=options)))
    by_hand = question(GW170817 | {"chi_1": [0.0, 0.1]}, output="modes", dtype="complex64", modes=[[2, 2]])
    rows = question([list(GW170817.values())] * 2, {"frequencies": [20.0, 30.0]}, names=list(GW170817))
    return [*ours, msgspec.msgpack.encode(by_hand), msgspec.msgpack.encode(rows)]


def waveform_requests_json() -> list[bytes]:
    """The same in JSON."""
    rows = question([list(GW170817.values())] * 2, {"frequencies": [20.0, 30.0]}, names=list(GW170817))
    return [msgspec.json.encode(message) for message in (question(), rows, question(grid={"sha256": "0" * 64}))]


def likelihood_requests() -> list[bytes]:
    """In MessagePack, with and without calibration errors, complete and with something marginalised."""
    errors = {name: np.zeros((3, 4)) for name in ("H1", "L1")}
    complete = samples(3, calibration_amplitude=errors)
    ours = [encode_likelihood_request(ANALYSIS.digest, batch) for batch in (complete, samples(2))]
    ours.append(encode_likelihood_request(ANALYSIS.digest, samples(2), "draws", np.full((2, 3), 0.5)))
    ours.append(encode_likelihood_request(ANALYSIS.digest, samples(2), "gradients"))
    by_hand = {"parameters": dict.fromkeys(complete_names(), 1.0), "calibration_phase": {"H1": [[0.0] * 4]}}
    return [*ours, msgspec.msgpack.encode(by_hand)]


def likelihood_requests_json() -> list[bytes]:
    """The same in JSON."""
    plain = {"parameters": dict.fromkeys(complete_names(), 1.0)}
    more = ({}, {"output": "products"}, {"output": "gradients"}, {"output": "draws", "uniforms": [[0.5, 0.25, 0.0]]})
    return [msgspec.json.encode(plain | fields) for fields in more]


def umbridge_requests() -> list[bytes]:
    """Of the analysis, by UM-Bridge clients."""
    names = complete_names()
    plain = {"name": f"default/{name_of(ANALYSIS)}", "outWrt": 0, "inWrt": 0, "sens": [1.0]}
    fixed = {"fixed": dict.fromkeys(names, 1.0), "outside": -1e300}
    return [
        msgspec.json.encode(plain | {"input": [[1.0] * (len(names) + 1)], "config": {}}),
        msgspec.json.encode(plain | {"input": [[1.0]], "config": fixed}),
    ]


def complete_names() -> list[str]:
    """The parameters of a likelihood, all but the phase."""
    return [*(name for name in PARAMETER_NAMES if name not in ("reference_phase", "time_shift")), "right_ascension",
            "declination", "polarization_angle", "coalescence_time"]  # fmt: skip


def analyses() -> list[bytes]:
    """Encoded analyses."""
    return [
        b"".join(encode_analysis(ANALYSIS)),
        b"".join(encode_analysis(small_analysis(f_max=21.0, detectors=["V1"]))),
    ]


def grids() -> list[bytes]:
    """Uploads of frequencies."""
    return [FREQUENCIES.tobytes(), np.geomspace(5.0, 2048.0, 64).tobytes()]


def waveform_answers() -> list[bytes]:
    """Bodies of answers to :func:`ask`, small and with arrays that are aligned."""
    model, batch = ReferenceModel(), binaries(2)
    found = model.predict_factored(FREQUENCIES, batch)
    small = {"h": found.h, "plus": found.plus, "cross": found.cross, "status": found.status}
    large = small | {"h": np.zeros((2, 5000), "<c16")}
    return [b"".join(encode_answer(arrays, IDENTITY)) for arrays in (small, large)]


def likelihood_answers() -> list[bytes]:
    """Bodies of answers with log-likelihoods, alone, with products, with draws and with gradients."""
    plain = {"log_likelihood": np.array([1.0, -np.inf]), "status": np.array([0, 2], np.uint8)}
    products = {"d_inner_h": np.ones((2, 2), complex), "h_inner_h": np.ones((2, 2))}
    return [
        b"".join(
            encode_likelihood_answer(
                LikelihoodAnswer(**plain, model=IDENTITY, analysis=ANALYSIS.digest, further=further)
            )
        )
        for further in ({}, products, {"distance_mpc": np.ones(2)}, {"gradient": np.ones((2, 13))})
    ]


def manifests() -> list[bytes]:
    """Of a small model."""
    return [published()[MANIFEST_FILE]]


def tensors() -> list[bytes]:
    """Files of tensors."""
    return [published()[TENSORS_FILE], encode_tensors({})]


def labels() -> list[bytes]:
    """Files of labels."""
    return [published()[LABELS_FILE]]


@cache
def published() -> dict[str, bytes]:
    """The files of a small model, by their names."""
    with tempfile.TemporaryDirectory() as folder:
        arrays = {"weights/0": np.eye(3), "bias": np.arange(3, dtype="<f4"), "flags": np.ones(2, bool)}
        metadata = {"modes": [[2, 2]], "accuracy": {"median": 1e-7}, "citation": None}
        ModelStore([folder]).publish("small", "1.0.0", arrays, metadata)
        return {path.name: path.read_bytes() for path in Path(folder).rglob("*.*") if path.is_file()}


def manifest_of(data: bytes) -> bytes:
    """A manifest that says of a file of tensors what is so: the most that somebody who writes both can do."""
    try:
        arrays = dict(decode_tensors(data))
        return encode_manifest(describe("small", "1.0.0", arrays, data, {}, None))
    except ValueError:
        return encode_manifest(describe("small", "1.0.0", {}, data, {}, None))


def conversations() -> list[bytes]:
    """Everything that a server says to :func:`.conversation.ask`, and some problems."""
    said = spoken_by_the_reference()
    problem = msgspec.json.encode(
        Problem.from_error(InvalidRequest("Row 2: too heavy.", errors=[FieldError("x", row=2)]), 422)
    )
    refusal = HEAD % (b"422", b"application/problem+json") + problem
    busy = b"HTTP/1.1 503 Busy\r\nRetry-After: 1\r\nContent-Length: 0\r\n\r\n"
    unframed = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n0\r\nTrailer: x\r\n\r\n"
    return [MARK.join(answers) for answers in (said, [said[0], refusal], [said[0], busy, unframed, *said[1:]])]


def spoken_by_the_reference() -> list[bytes]:
    """The answers of the reference service, with the marks of :mod:`.conversation` for what depends on them."""
    service, said = ReferenceService(), []

    def answer(request: httpx.Request) -> httpx.Response:
        headers = {name.lower(): value for name, value in request.headers.items()}
        reply = service.respond(request.method, request.url.path, headers, request.content)
        said.append(HEAD % (b"%d" % reply.status, reply.headers["content-type"].encode()) + reply.body)
        return httpx.Response(reply.status, headers=reply.headers, content=reply.body)

    with Model.connect("http://server:1", transport=httpx.MockTransport(answer), parallel=1, chunk_samples=18) as model:
        model.predict(FREQUENCIES, ParametersWithExtrinsic(**GW170817))
        model.predict_batch(FREQUENCIES, binaries(5))
    return said


def networks() -> list[bytes]:
    """In MessagePack: with names alone, and with all that they stand for."""
    f = np.geomspace(10.0, 1000.0, 20)
    own = NetworkDetector("X", (f, 1e-24 * np.ones(20)), np.diag([0.5, -0.5, 0.0]), np.array([0.0, 0.0, 6.37e6]))
    ours = DetectorNetwork([own, NetworkDetector("E1", "ET-D")], 20.0, 900.0, 1187008882.4)
    return [ours.body, msgspec.msgpack.encode(network())]


def networks_json() -> list[bytes]:
    """As somebody writes them."""
    curve = {"frequencies": [10.0, 2000.0], "asd": [1e-24, 1e-24]}
    return [msgspec.json.encode(network()), msgspec.json.encode(network(("H1",), curve, moving=False))]


def forecast_requests() -> list[bytes]:
    """In MessagePack: ours, and by hand."""
    options = ForecastOptions(priors={"chi_1": 0.05}, modes=[(2, 2)])
    ours = encode_forecast_request("sha256:" + "0" * 64, samples(3), options, "root")
    return [ours, msgspec.msgpack.encode({"parameters": BINARY, "output": "errors", "priors": {"chi_2": 0.1}})]


def forecast_requests_json() -> list[bytes]:
    """The same in JSON."""
    return [msgspec.json.encode({"parameters": BINARY, "output": "snr", "priors": {"chi_1": 0.05}, "modes": [[2, 2]]})]


def forecast_answers() -> list[bytes]:
    """Of two binaries in one detector."""
    arrays = {"snr": np.ones(2), "detector_snr": np.ones((2, 1)), "status": np.zeros(2, np.uint8)}
    arrays |= {"root": np.ones((2, 91)), "condition": np.ones(2), "singular": np.zeros(2, np.uint8)}
    answer = ForecastAnswer(model=IDENTITY, network="sha256:1", names=("chi_1",) * 13, arrays=arrays)
    return [b"".join(encode_forecast_answer(answer))]
