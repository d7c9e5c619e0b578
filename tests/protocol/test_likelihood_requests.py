"""Likelihood requests in both media types, and what both sides agree on about their work."""

import json

import msgpack
import numpy as np
import pytest

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    AnalysisInvalid,
    InvalidParameters,
    InvalidRequest,
    LikelihoodBatch,
    ModelIdentity,
    OutOfDomain,
    RowStatus,
    TimeMarginalisation,
    TooLarge,
    UndecodableBody,
    check_model_of,
    decode_analysis,
    encode_analysis,
    likelihood_nodes,
    likelihood_samples,
    refuse_rows,
)
from bnserve_protocol.wire import (
    JSON,
    MSGPACK,
    LikelihoodAnswer,
    decode_likelihood_answer,
    decode_likelihood_request,
    encode_likelihood_answer,
    encode_likelihood_answer_json,
    encode_likelihood_request,
)
from tests.service.asking import as_array
from tests.service.injections import SIGNAL, columns, samples, small_analysis

BATCH = samples(5, calibration_phase={"H1": np.full((5, 4), 0.25)})
MODEL = ModelIdentity(name="chirp", version="1.0.0", digest="sha256:0")


def same(batch, other=BATCH):
    return batch.values.tobytes() == other.values.tobytes() and all(
        getattr(batch, name)["H1"].tobytes() == getattr(other, name)["H1"].tobytes()
        for name in ("calibration_amplitude", "calibration_phase")
    )


def test_what_is_written_is_read():
    request = decode_likelihood_request(encode_likelihood_request("sha256:1", BATCH))
    assert same(request.batch)
    assert request.analysis == "sha256:1"
    assert request.batch.values.flags.writeable


def test_what_was_left_out_stays_out():
    batch = LikelihoodBatch.coerce({name: value for name, value in SIGNAL.items() if name != "distance_mpc"})
    assert decode_likelihood_request(encode_likelihood_request("x", batch)).batch.absent == {"distance_mpc"}


@pytest.mark.parametrize("media_type", [MSGPACK, JSON])
def test_plain_numbers_in_both_media_types(media_type):
    pack = msgpack.packb if media_type == MSGPACK else lambda message: json.dumps(message).encode()
    errors = {"calibration_phase": {"H1": BATCH.calibration_phase["H1"].tolist()}}
    for form in (
        {"parameters": columns(BATCH)},
        {"parameters": BATCH.values.tolist(), "names": list(LIKELIHOOD_NAMES)},
    ):
        assert same(decode_likelihood_request(pack(form | errors), media_type).batch)


WRONG = {
    "ragged rows": ({"parameters": [[1.0] * 13, [1.0]], "names": list(LIKELIHOOD_NAMES)}, UndecodableBody),
    "a column too few": ({"parameters": [[1.0] * 12], "names": list(LIKELIHOOD_NAMES)}, InvalidParameters),
    "a column of rows": ({"parameters": SIGNAL | {"chi_1": [[1.0]]}}, InvalidParameters),
    "a name twice": ({"parameters": [[1.0] * 14], "names": [*LIKELIHOOD_NAMES, "chi_1"]}, InvalidParameters),
    "a field too many": ({"parameters": SIGNAL, "grid": {}}, UndecodableBody),
    "errors that are one vector": ({"parameters": SIGNAL, "calibration_phase": {"H1": [0.0] * 4}}, InvalidParameters),
    "errors of other rows": (
        {"parameters": SIGNAL, "calibration_phase": {"H1": [[0.0] * 4] * 2}}, InvalidParameters,
    ),
    "more rows than are taken": ({"parameters": SIGNAL | {"chi_1": [0.0] * 9}}, TooLarge),
    "text": ({"parameters": SIGNAL | {"chi_1": "fast"}}, UndecodableBody),
    "an output that is none": ({"parameters": SIGNAL, "output": "phases"}, UndecodableBody),
    "draws of nothing": ({"parameters": SIGNAL, "output": "draws"}, InvalidRequest),
    "numbers without draws": ({"parameters": SIGNAL, "uniforms": [[0.5] * 3]}, InvalidRequest),
    "numbers for more": ({"parameters": SIGNAL, "output": "draws", "uniforms": [[0.5] * 3] * 2}, InvalidParameters),
    "numbers beyond one": ({"parameters": SIGNAL, "output": "draws", "uniforms": [[0.5, 1.0, 0.5]]}, InvalidParameters),
}  # fmt: skip


@pytest.mark.parametrize(("message", "kind"), WRONG.values(), ids=WRONG)
def test_what_is_wrong_is_refused_alike_in_both_media_types(message, kind):
    for body, media_type in ((msgpack.packb(message), MSGPACK), (json.dumps(message).encode(), JSON)):
        with pytest.raises(kind):
            decode_likelihood_request(body, media_type, max_rows=8)


def test_what_is_asked_for_travels_and_is_left_out_where_it_is_the_log_likelihood_alone():
    numbers = np.random.default_rng(1).random((5, 3))
    for output, uniforms in (("products", None), ("gradients", None), ("draws", numbers)):
        request = decode_likelihood_request(encode_likelihood_request("sha256:1", BATCH, output, uniforms))
        assert request.output == output
        assert same(request.batch)
    assert request.uniforms.tobytes() == numbers.tobytes()
    plain = encode_likelihood_request("sha256:1", BATCH)
    assert b"output" not in plain  # as servers from before read it
    assert b"uniforms" not in plain
    assert decode_likelihood_request(plain).output == "log_likelihood"


def test_what_else_was_asked_for_comes_back_in_both_media_types():
    further = {"d_inner_h": np.array([[1.0 + 2.0j, np.nan]] * 2), "h_inner_h": np.array([[4.0, np.nan]] * 2)}
    plain = {"log_likelihood": np.array([1.5, -np.inf]), "status": np.array([0, 4], np.uint8)}
    answer = LikelihoodAnswer(**plain, model=MODEL, analysis="sha256:1", further=further)
    back = decode_likelihood_answer(b"".join(encode_likelihood_answer(answer)))
    assert {name: array.tobytes() for name, array in back.further.items()} == {
        name: array.tobytes() for name, array in further.items()
    }
    told = json.loads(encode_likelihood_answer_json(answer))
    assert told["d_inner_h"] == {"re": [[1.0, None]] * 2, "im": [[2.0, 0.0]] * 2}
    assert told["h_inner_h"] == [[4.0, None]] * 2
    drawn = LikelihoodAnswer(**plain, model=MODEL, analysis="x", further={"distance_mpc": np.array([40.0, np.nan])})
    assert decode_likelihood_answer(b"".join(encode_likelihood_answer(drawn))).further["distance_mpc"][0] == 40.0
    sloped = LikelihoodAnswer(
        **plain, model=MODEL, analysis="x", further={"gradient": np.array([[1.0, 2.0], [np.nan] * 2])},
        gradient_names=("mass_ratio", "chi_1"),
    )  # fmt: skip
    back = decode_likelihood_answer(b"".join(encode_likelihood_answer(sloped)))
    assert back.gradient_names == ("mass_ratio", "chi_1")
    assert back.further["gradient"][0].tolist() == [1.0, 2.0]
    told = json.loads(encode_likelihood_answer_json(sloped))
    assert (told["gradient"], told["gradient_names"]) == ([[1.0, 2.0], [None] * 2], ["mass_ratio", "chi_1"])
    assert b"gradient" not in b"".join(encode_likelihood_answer(answer))
    for wrong in (
        {"distance_mpc": np.zeros(3)},
        {"gradient": np.zeros(2)},
        {"h_inner_h": np.zeros(2)},
        {"d_inner_h": np.zeros((2, 2))},
    ):
        answer = LikelihoodAnswer(**plain, model=MODEL, analysis="x", further=wrong)
        with pytest.raises(UndecodableBody, match="do not fit together"):
            decode_likelihood_answer(b"".join(encode_likelihood_answer(answer)))


def test_arrays_that_are_not_real_are_refused():
    with pytest.raises(UndecodableBody, match="<f8"):
        decode_likelihood_request(msgpack.packb({"parameters": SIGNAL | {"chi_1": as_array(np.zeros(2, complex))}}))


def test_an_answer_in_json_says_null_for_minus_infinity():
    answer = LikelihoodAnswer(
        log_likelihood=np.array([1.5, -np.inf]), status=np.array([0, 4], np.uint8), model=MODEL, analysis="sha256:1"
    )
    told = json.loads(encode_likelihood_answer_json(answer))
    assert told["log_likelihood"] == [1.5, None]
    assert told["status"] == [0, 4]
    back = decode_likelihood_answer(b"".join(encode_likelihood_answer(answer)))
    assert back.log_likelihood.tolist() == [1.5, -np.inf]
    assert (back.model, back.analysis) == (MODEL, "sha256:1")


def test_arrays_of_an_analysis_are_aligned_wherever_they_were_in_the_body():
    body = b"".join(encode_analysis(small_analysis()))
    for offset in range(8):
        arrays = decode_analysis(memoryview(bytes(offset) + body)[offset:]).arrays
        assert all(array.flags.aligned and not array.flags.writeable for array in arrays.values())


def test_work_is_counted_in_nodes_detectors_and_times():
    analysis = small_analysis()
    assert likelihood_nodes(analysis) == 177
    assert likelihood_samples(analysis) == 177 * 3
    sums = TimeMarginalisation(minimum=-0.05, maximum=0.05, step=1e-3)
    assert likelihood_samples(small_analysis(time_marginalisation=sums)) == 177 * 3 + 2 * 101


def test_an_analysis_for_one_model_is_refused_by_another():
    check_model_of(small_analysis(), MODEL)
    check_model_of(small_analysis(model_digest="sha256:0"), MODEL)
    with pytest.raises(AnalysisInvalid, match=r"sha256:1.*chirp 1\.0\.0"):
        check_model_of(small_analysis(model_digest="sha256:1"), MODEL)


def test_refused_rows_are_named():
    refuse_rows(np.zeros(3, np.uint8))
    refuse_rows(np.zeros(0, np.uint8))
    with pytest.raises(OutOfDomain, match=r"^Row 1 is outside the model's trained range; 99 of 100 rows") as raised:
        refuse_rows(np.array([0] + [RowStatus.OUT_OF_DOMAIN] * 99, np.uint8))
    assert [problem.row for problem in raised.value.errors] == list(range(1, 65))
