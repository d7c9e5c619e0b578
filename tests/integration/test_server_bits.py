"""The running server and the local model give the same bits, however the question is put."""

import hashlib
from concurrent.futures import ThreadPoolExecutor

import msgpack
import numpy as np
import pytest

from bnserve_protocol import PARAMETER_NAMES, EvaluationOptions, ParameterBatch, UniformGrid
from bnserve_protocol.wire import decode_answer
from tests.service.asking import MSGPACK, as_array, ask, ask_on, closing_connection, read_msgpack

ALONE = EvaluationOptions(modes=((2, 2),))
BINARIES = 1000
PATH = "/v1/models/default/waveforms"
UNIFORM = UniformGrid(f_min=20.0, f_max=1024.0, delta_f=8.0)
EXPLICIT = np.geomspace(5.0, 2048.0, 131)
EXTRINSIC = {
    "distance_mpc": (10.0, 400.0), "inclination": (0.0, np.pi), "reference_phase": (0.0, 2.0 * np.pi),
    "time_shift": (-0.1, 0.1), "total_mass": (1.0, 6.0),
}  # fmt: skip


@pytest.fixture(scope="module")
def batch(local):
    """Random binaries inside the trained box."""
    generator = np.random.default_rng(20170817)
    described = {entry.name: (entry.minimum, entry.maximum) for entry in local.description.parameters}
    ranges = [EXTRINSIC.get(name, described.get(name)) for name in PARAMETER_NAMES]
    low, high = np.array(ranges, dtype=float).T
    return ParameterBatch(low + (high - low) * generator.random((BINARIES, len(ranges))))


def question(batch, grid, **rest):
    return msgpack.packb({"parameters": as_array(batch.values), "names": list(PARAMETER_NAMES), "grid": grid, **rest})


@pytest.fixture(scope="module")
def grids(bnserve_server):
    """The same three forms that a request may use, with the frequencies they stand for."""
    uploaded = np.linspace(30.0, 500.0, 97)
    digest = hashlib.sha256(uploaded.tobytes()).hexdigest()
    assert ask(bnserve_server.address, "PUT", f"/v1/grids/{digest}", uploaded.tobytes()).status in (200, 201)
    uniform = {"f_min": UNIFORM.f_min, "f_max": UNIFORM.f_max, "delta_f": UNIFORM.delta_f}
    return {
        "explicit": ({"frequencies": as_array(EXPLICIT)}, EXPLICIT),
        "uniform": (uniform, UNIFORM),
        "uploaded": ({"sha256": digest}, uploaded),
    }


@pytest.mark.parametrize("form", ["explicit", "uniform", "uploaded"])
@pytest.mark.parametrize("rows", [1, 7, 256])
def test_a_thousand_binaries(bnserve_server, local, batch, grids, form, rows):
    grid, frequencies = grids[form]
    expected = local.predict_batch(frequencies, batch)
    plus, cross = [], []
    with closing_connection(bnserve_server.address) as connection:
        for part in batch.split(rows):
            answer = ask_on(connection, "POST", PATH, question(part, grid), content_type=MSGPACK)
            assert answer.status == 200, answer.body
            arrays = read_msgpack(answer.body)
            plus.append(arrays["h_plus"])
            cross.append(arrays["h_cross"])
    assert np.concatenate(plus).tobytes() == expected.plus.tobytes()
    assert np.concatenate(cross).tobytes() == expected.cross.tobytes()


@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
def test_every_output(bnserve_server, local, batch, dtype):
    few = batch.split(5)[0]
    grid = {"frequencies": as_array(EXPLICIT)}
    answers = {}
    for output in ("polarizations", "factored", "amplitude_phase", "modes"):
        one = {"modes": [[2, 2]]} if output in ("factored", "amplitude_phase") else {}
        body = question(few, grid, output=output, dtype=dtype, **one)
        answers[output] = read_msgpack(ask(bnserve_server.address, "POST", PATH, body, content_type=MSGPACK).body)
    factored = local.predict_factored(EXPLICIT, few, options=ALONE, dtype=dtype)
    curves = local.predict_amplitude_phase(EXPLICIT, few, options=ALONE)
    modes = local.predict_modes(EXPLICIT, few, dtype=dtype)
    both = local.predict_batch(EXPLICIT, few, dtype=dtype)
    pairs = [
        (answers["factored"]["h"], factored.h),
        (answers["factored"]["plus"], factored.plus),
        (answers["factored"]["cross"], factored.cross),
        *((answers["modes"][f"h_{degree}{m}"], modes.h[:, k]) for k, (degree, m) in enumerate(modes.modes)),
        (answers["amplitude_phase"]["amplitude"], curves.amplitude),
        (answers["amplitude_phase"]["phase"], curves.phase),
        (answers["polarizations"]["h_plus"], both.plus),
        (answers["polarizations"]["h_cross"], both.cross),
    ]
    for remote, here in pairs:
        assert (remote.dtype, remote.shape, remote.tobytes()) == (here.dtype, here.shape, here.tobytes())


def test_under_load_the_bits_are_the_same(bnserve_server, local, batch):
    """Many callers at once, so that the server evaluates them in groups of every size."""
    expected = local.predict_factored(UNIFORM, batch, options=ALONE).h
    grid = {"f_min": UNIFORM.f_min, "f_max": UNIFORM.f_max, "delta_f": UNIFORM.delta_f}

    def one(index):
        row = ParameterBatch(batch.values[index : index + 1])
        body = question(row, grid, output="factored", modes=[[2, 2]])
        answer = ask(bnserve_server.address, "POST", PATH, body, content_type=MSGPACK)
        return read_msgpack(answer.body)["h"].tobytes() == expected[index : index + 1].tobytes()

    with ThreadPoolExecutor(16) as callers:
        assert all(callers.map(one, range(400)))


def test_the_answer_names_the_model_that_ships(bnserve_server, local, batch):
    body = question(batch.split(1)[0], {"frequencies": [100.0]})
    model = read_msgpack(ask(bnserve_server.address, "POST", PATH, body, content_type=MSGPACK).body)["model"]
    description = local.description
    assert model == {"name": description.name, "version": description.version, "digest": description.digest}


@pytest.mark.parametrize(
    ("change", "status", "code"),
    [
        ({"mass_ratio": 0.5}, 422, "out-of-domain"),
        ({"mass_ratio": float("nan")}, 422, "parameters-invalid"),
        ({"distance_mpc": float("inf")}, 422, "parameters-invalid"),
        ({"lambda_1": 1e9}, 422, "out-of-domain"),
        ({"total_mass": 400.0}, 422, "out-of-domain"),
    ],
)
def test_what_the_local_model_refuses_the_server_refuses(bnserve_server, local, change, status, code):
    from bnserve_protocol import ERRORS_BY_CODE, ParametersWithExtrinsic
    from tests.service.asking import GW170817

    parameters = GW170817 | change
    with pytest.raises(ERRORS_BY_CODE[code]) as refused:
        local.predict([100.0], ParametersWithExtrinsic(**parameters))
    body = msgpack.packb({"parameters": parameters, "grid": {"frequencies": [100.0]}})
    answer = ask(bnserve_server.address, "POST", PATH, body, content_type=MSGPACK)
    assert (answer.status, answer.code) == (status, code)
    assert answer.document["detail"] == refused.value.detail


def test_a_grid_above_the_band(bnserve_server):
    from tests.service.asking import GW170817

    question = {"parameters": GW170817, "grid": {"frequencies": [50_000.0, 60_000.0]}}
    answer = ask(bnserve_server.address, "POST", PATH, msgpack.packb(question), content_type=MSGPACK)
    assert answer.status == 200
    assert not decode_answer(answer.body).arrays["h_plus"].any()
    forbidden = msgpack.packb(question | {"above_band": "error"})
    answer = ask(bnserve_server.address, "POST", PATH, forbidden, content_type=MSGPACK)
    assert (answer.status, answer.code) == (422, "out-of-band")
