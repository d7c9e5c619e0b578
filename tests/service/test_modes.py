"""Models of several modes: which are asked for, how they come back, and what they cost."""

import threading
from concurrent.futures import ThreadPoolExecutor

import jsonschema
import numpy as np
import pytest

from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic, UniformGrid
from bnserve_service import BackgroundServer, Settings
from tests.service.asking import GRID, GW170817, ask, evaluate, evaluate_json, question, read_msgpack
from tests.service.chirp import ChirpModel, MemorySource, as_it_is, until
from tests.service.conftest import SMALL_LIMITS
from tests.service.modes_chirp import MODES, ModesModel, QuickModesModel
from tests.service.test_reference import schema
from tests.service.test_waveform_answers import COLUMNS, ROWS, same_bits

LOCAL = ModesModel()
FREQUENCIES = UniformGrid(**GRID).frequencies()
ALWAYS = {"model", "status", "estimated_mismatch"}


@pytest.fixture(scope="module", params=[ModesModel, QuickModesModel], ids=["in threads", "fast path"])
def server(request):
    source = MemorySource().add(request.param()).add(ChirpModel())
    with BackgroundServer(Settings(**SMALL_LIMITS), source=source, factory=as_it_is) as it:
        yield it


def asked(server, **fields):
    return evaluate(server.address, question(COLUMNS, **fields), model="modes")


def test_polarizations_are_the_sum_of_all(server):
    answer = read_msgpack(asked(server).body)
    assert same_bits(answer["h_plus"], LOCAL.predict_batch(FREQUENCIES, ROWS).plus)
    assert answer["estimated_mismatch"].tolist() == [1e-9 * 3] * 3


@pytest.mark.parametrize("modes", [[(2, 2)], [(3, 3), (2, 2)], [(2, 1)]])
def test_polarizations_of_some(server, modes):
    answer = read_msgpack(asked(server, modes=modes).body)
    options = EvaluationOptions(modes=modes)
    assert same_bits(answer["h_cross"], LOCAL.predict_batch(FREQUENCIES, ROWS, options=options).cross)


@pytest.mark.parametrize("modes", [None, [(3, 3), (2, 2)], [(2, 1)]])
@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
def test_modes_come_one_by_one_with_their_factors(server, modes, dtype):
    answer = read_msgpack(
        asked(server, output="modes", dtype=dtype, **({} if modes is None else {"modes": modes})).body
    )
    expected = LOCAL.predict_modes(FREQUENCIES, ROWS, options=EvaluationOptions(modes=modes), dtype=dtype)
    names = [f"{degree}{order}" for degree, order in modes or MODES]
    assert set(answer) == ALWAYS | {f"{kind}_{name}" for kind in ("h", "plus", "cross") for name in names}
    for place, name in enumerate(names):
        assert same_bits(answer[f"h_{name}"], expected.h[:, place])
        assert same_bits(answer[f"plus_{name}"], expected.plus[:, place])
        assert same_bits(answer[f"cross_{name}"], expected.cross[:, place])


@pytest.mark.parametrize("output", ["factored", "amplitude_phase"])
def test_what_belongs_to_one_mode_needs_one(server, output):
    for modes, says in ((None, "this model has 3"), ([(2, 2), (3, 3)], "you chose 2")):
        answer = asked(server, output=output, **({} if modes is None else {"modes": modes}))
        assert (answer.status, answer.code) == (422, "request-invalid")
        assert says in answer.document["detail"]
        assert "modes=[(2, 2)]" in answer.document["detail"]
    one = read_msgpack(asked(server, output=output, modes=[(3, 3)]).body)
    options = EvaluationOptions(modes=[(3, 3)])
    if output == "factored":
        assert same_bits(one["h"], LOCAL.predict_factored(FREQUENCIES, ROWS, options=options).h)
    else:
        assert same_bits(one["phase"], LOCAL.predict_amplitude_phase(FREQUENCIES, ROWS, options=options).phase)


BAD = {
    "not there": ([(2, 2), (4, 4)], 422, "no mode (4, 4); it has (2, 2), (3, 3), (2, 1)"),
    "the mirror image": ([(2, -2)], 422, "(2, 2) stands for it"),
    "twice": ([(2, 2), (2, 2)], 422, "twice"),
    "none": ([], 422, "got none"),
    "no pairs": ([2, 2], 400, "modes"),
    "triples": ([[2, 2, 2]], 400, "modes"),
    "fractions": ([[2.5, 2]], 400, "modes"),
    "very many": ([[2, 2]] * 10_000, 400, "length"),
    "huge": ([[2**63, 2]], 422, "no mode"),
    "text": ("22", 400, "modes"),
}


@pytest.mark.parametrize(("modes", "status", "says"), BAD.values(), ids=BAD)
@pytest.mark.parametrize("model", ["modes", "chirp"])
def test_bad_modes_are_refused(server, model, modes, status, says):
    answer = evaluate(server.address, question(modes=modes), model=model)
    assert answer.status == status
    assert answer.code == {400: "body-undecodable", 422: "request-invalid"}[status]
    assert says in answer.document["detail"] or model == "chirp"


@pytest.mark.parametrize("value", [0.0, -20.0, np.inf, np.nan])
def test_a_reference_frequency_that_is_none_is_refused(server, value):
    answer = asked(server, reference_frequency=value)
    assert (answer.status, answer.code) == (422, "request-invalid")
    assert "reference_frequency" in answer.document["detail"]


def test_a_model_of_one_mode_says_it_in_the_same_words(server):
    plain = evaluate(server.address, question(output="modes")).body
    assert evaluate(server.address, question(output="modes", modes=[(2, 2)])).body == plain
    answer = evaluate(server.address, question(modes=[(3, 3)]))
    assert answer.document["detail"] == "This model has no mode (3, 3); it has (2, 2)."


def test_json_holds_every_mode(server):
    answer = evaluate_json(server.address, question(output="modes"), model="modes").document
    expected = LOCAL.predict_modes(FREQUENCIES, ParametersWithExtrinsic(**GW170817))
    assert np.array_equal(np.array(answer["h_33"]["re"]) + 1j * np.array(answer["h_33"]["im"]), expected.h[:, 1])
    assert answer["plus_33"] == expected.plus[:, 1].tolist()
    document = ask(server.address, "GET", "/openapi.json").document
    jsonschema.validate(answer, schema(document, "WaveformAnswer"))


def test_every_mode_that_comes_back_counts_towards_the_samples(server):
    grid = {"f_min": 20.0, "f_max": 2019.0, "delta_f": 1.0}
    modes = question(GW170817 | {"chi_1": [0.0] * 44}, grid=grid, output="modes")
    answer = evaluate(server.address, modes, model="modes")  # 264,000 of 262,144
    assert (answer.status, answer.code) == (413, "too-large")
    assert "times modes" in answer.document["detail"]
    assert "at most 43 rows" in answer.document["detail"]
    fewer = question(GW170817 | {"chi_1": [0.0] * 43}, grid=grid, output="modes")
    assert evaluate(server.address, fewer, model="modes").status == 200
    assert evaluate(server.address, modes | {"output": "polarizations"}, model="modes").status == 200
    in_json = question(grid={"f_min": 20.0, "f_max": 353.0, "delta_f": 1.0}, output="modes")
    assert evaluate_json(server.address, in_json, model="modes").status == 413  # 1,002 of 1,000
    assert evaluate_json(server.address, in_json | {"output": "polarizations"}, model="modes").status == 200


def test_every_mode_counts_towards_the_queue_and_the_memory(start):
    gate, work = threading.Event(), (21 + 1000) * 2

    class Gated(ModesModel):
        def predict_modes(self, *given, **options):
            assert gate.wait(30.0)
            return super().predict_modes(*given, **options)

    server = start(Gated(), threads=1)
    message = question(grid={"f_min": 20.0, "f_max": 40.0, "delta_f": 1.0}, output="modes")
    with ThreadPoolExecutor(1) as caller:
        waiting = caller.submit(evaluate, server.address, message, model="modes")
        until(lambda: server.app.parts.evaluation.queue.cost > 0, "it is there")
        assert server.app.parts.evaluation.queue.cost == work + 10_000
        assert server.app.parts.evaluation.answer_bytes == 21 * 3 * 16
        gate.set()
        assert waiting.result().status == 200


def test_the_largest_request_fits_the_queue_whatever_its_modes(start):
    server = start(ModesModel(), max_samples=2**18, max_rows=16, max_frequencies=2**18, queue_samples=2**18 + 26_000)
    message = question(grid={"f_min": 1.0, "f_max": float(2**18), "delta_f": 1.0})
    assert evaluate(server.address, message, model="modes").status == 200


def test_questions_about_all_modes_are_one_question(server):
    """Naming all modes in their order is naming none: such requests are evaluated together."""
    body = asked(server, output="modes").body
    assert asked(server, output="modes", modes=list(MODES)).body == body
