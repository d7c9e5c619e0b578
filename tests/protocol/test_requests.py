"""The waveform request: what our client sends, what users may send, and what is refused."""

import dataclasses
import json
import random

import msgpack
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bnserve_protocol import (
    IN_PLANE_NAMES,
    PARAMETER_NAMES,
    BnserveError,
    EvaluationOptions,
    InvalidFrequencies,
    InvalidParameters,
    InvalidRequest,
    ParameterBatch,
    ParametersWithExtrinsic,
    UndecodableBody,
    UniformGrid,
    grid_digest,
)
from bnserve_protocol.wire import JSON, MSGPACK, GridDigest, WaveformRequest, decode_request, encode_request
from tests.protocol.messages import array_map, read_message

TYPICAL = dataclasses.asdict(ParametersWithExtrinsic.gw170817())
PRECESSING = ParameterBatch(np.full((3, 10), 1.5), np.linspace(0.0, 0.4, 12).reshape(3, 4))
UNIFORM = {"f_min": 20.0, "f_max": 40.0, "delta_f": 0.5}
FREQUENCIES = np.linspace(20.0, 40.0, 5)
BATCH = ParameterBatch(np.random.default_rng(1).uniform(1.0, 2.0, (3, 10)))
GRIDS = {
    "uniform": UniformGrid(20.0, 40.0, 0.5),
    "explicit": FREQUENCIES,
    "uploaded": GridDigest(grid_digest(FREQUENCIES)),
}
WRITERS = {MSGPACK: msgpack.packb, JSON: lambda message: json.dumps(message).encode()}
both = pytest.mark.parametrize("media_type", [MSGPACK, JSON])


def decode(message, media_type=JSON):
    return decode_request(WRITERS[media_type](message), media_type)


def same_grid(one, other):
    return np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other


@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
@pytest.mark.parametrize("output", ["polarizations", "factored", "amplitude_phase", "modes"])
def test_what_our_client_sends_comes_back(grid, output):
    options = EvaluationOptions(
        out_of_domain="flag", below_band="error", above_band="error", alignment="merger", modes=[(3, 3), (2, 2)],
        reference_frequency=20.0,
    )  # fmt: skip  # none of the defaults
    sent = WaveformRequest(batch=BATCH, grid=grid, output=output, dtype="complex64", options=options)
    received = decode_request(encode_request(sent))
    np.testing.assert_array_equal(received.batch.values, BATCH.values)
    assert same_grid(received.grid, grid)
    assert (received.output, received.dtype, received.options) == (output, "complex64", options)


def test_options_travel_only_where_they_are_others():
    """A service of before refuses only what it cannot do."""
    options = {"modes": [(2, 2)], "reference_frequency": 20.0, "alignment": "merger", "out_of_domain": "flag"}
    for name in (None, *options):
        chosen = EvaluationOptions(**({} if name is None else {name: options[name]}))
        body = encode_request(WaveformRequest(batch=BATCH, grid=GRIDS["uniform"], options=chosen))
        sent = msgpack.unpackb(body).keys() - {"parameters", "names", "grid", "output"}
        assert sent == ({name} if name else set())


@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
def test_a_message_that_repeats_but_for_its_numbers_has_its_own(grid):
    """Of one binary, what was read before is looked up."""
    for number, output in enumerate(["factored", "modes", "factored", "factored"]):
        batch = ParameterBatch(np.full((1, 10), 1.0 + number))
        received = decode_request(encode_request(WaveformRequest(batch=batch, grid=grid, output=output)))
        np.testing.assert_array_equal(received.batch.values, batch.values)
        received.batch.values[:] = np.nan  # they are nobody else's
        assert same_grid(received.grid, grid)
        assert received.output == output


@both
def test_spins_in_the_orbital_plane_travel_by_their_names(media_type):
    columns = {name: PRECESSING[name].tolist() for name in (*PARAMETER_NAMES, *IN_PLANE_NAMES)}
    sent = encode_request(WaveformRequest(batch=PRECESSING, grid=FREQUENCIES))
    for received in (decode_request(sent), decode({"parameters": columns, "grid": UNIFORM}, media_type)):
        np.testing.assert_array_equal(received.batch.values, PRECESSING.values)
        np.testing.assert_array_equal(received.batch.in_plane, PRECESSING.in_plane)
    assert read_message(sent)["names"] == [*PARAMETER_NAMES, *IN_PLANE_NAMES]


def test_spins_in_the_orbital_plane_that_are_zero_do_not_travel():
    """So a service of before answers whatever it could."""
    aligned = ParameterBatch(BATCH.values, np.zeros((3, 4)))
    with_them, without = (WaveformRequest(batch=batch, grid=FREQUENCIES) for batch in (aligned, BATCH))
    assert encode_request(with_them) == encode_request(without)


def test_what_our_client_sends_is_plain_messagepack():
    message = read_message(encode_request(WaveformRequest(batch=BATCH, grid=FREQUENCIES)))
    np.testing.assert_array_equal(message["parameters"], BATCH.values)
    assert message["names"] == list(PARAMETER_NAMES)
    assert message["output"] == "factored"


@both
def test_a_small_request_is_answered_with_the_documented_defaults(media_type):
    request = decode({"parameters": TYPICAL, "grid": UNIFORM}, media_type)
    assert request.batch.row(0) == ParametersWithExtrinsic.gw170817()
    assert request.grid == GRIDS["uniform"]
    assert (request.output, request.dtype, request.options) == ("polarizations", "complex128", EvaluationOptions())


@both
def test_named_vectors_and_scalars(media_type):
    request = decode({"parameters": TYPICAL | {"chi_1": [0.1, 0.2]}, "grid": UNIFORM}, media_type)
    np.testing.assert_array_equal(request.batch["chi_1"], [0.1, 0.2])
    np.testing.assert_array_equal(request.batch["total_mass"], [TYPICAL["total_mass"]] * 2)


@both
def test_rows_with_names_in_any_order(media_type):
    names = [name for name in reversed(PARAMETER_NAMES) if name != "time_shift"]
    rows = [[TYPICAL[name] for name in names], [TYPICAL[name] + 0.1 for name in names]]
    request = decode({"parameters": rows, "names": names, "grid": UNIFORM}, media_type)
    assert request.batch.row(0) == ParametersWithExtrinsic.gw170817()
    np.testing.assert_array_equal(request.batch["time_shift"], 0.0)


@pytest.mark.parametrize("keys", [str, bytes])
@pytest.mark.parametrize("dtype", ["<f8", "<f4"])
def test_arrays_in_messagepack(keys, dtype):
    columns = {name: array_map(np.full(2, value, dtype), keys) for name, value in TYPICAL.items()}
    grid = {"frequencies": array_map(FREQUENCIES.astype(dtype), keys)}
    request = decode({"parameters": columns, "grid": grid}, MSGPACK)
    np.testing.assert_array_equal(request.batch["mass_ratio"], np.full(2, TYPICAL["mass_ratio"], dtype))
    np.testing.assert_array_equal(request.grid, FREQUENCIES)


@both
def test_integers_count_as_numbers(media_type):
    whole = {name: int(value) + 1 for name, value in TYPICAL.items()} | {"chi_1": [0, 1]}
    request = decode({"parameters": whole, "grid": {"f_min": 20, "f_max": 40, "delta_f": 1}}, media_type)
    assert request.batch["mass_ratio"].dtype == np.float64
    assert len(request.grid) == 21
    rows = {"parameters": [[1] * 10], "names": list(PARAMETER_NAMES), "grid": {"frequencies": [20, 30]}}
    np.testing.assert_array_equal(decode(rows, media_type).grid, [20.0, 30.0])


@both
def test_no_rows_are_a_batch_of_none(media_type):
    names = list(PARAMETER_NAMES)
    assert len(decode({"parameters": [], "names": names, "grid": UNIFORM}, media_type).batch) == 0
    assert len(decode({"parameters": {name: [] for name in names}, "grid": UNIFORM}, media_type).batch) == 0


def test_the_batch_can_be_written_to():
    sent = encode_request(WaveformRequest(batch=BATCH, grid=FREQUENCIES))
    decode_request(sent).batch.values[...] = 0.0
    assert sent == encode_request(WaveformRequest(batch=BATCH, grid=FREQUENCIES))


GOOD = {"parameters": TYPICAL, "grid": UNIFORM}
NAMED = {"parameters": [[1.0] * 10], "names": list(PARAMETER_NAMES), "grid": UNIFORM}
REFUSED = {
    "unknown field": (GOOD | {"ouput": "factored"}, UndecodableBody, "ouput"),
    "unknown grid field": (GOOD | {"grid": UNIFORM | {"df": 1.0}}, UndecodableBody, "df"),
    "no parameters": ({"grid": UNIFORM}, UndecodableBody, "parameters"),
    "no grid": ({"parameters": TYPICAL}, UndecodableBody, "grid"),
    "a list": ([GOOD], UndecodableBody, "object"),
    "nothing": (None, UndecodableBody, "object"),
    "unknown output": (GOOD | {"output": "strain"}, UndecodableBody, "strain"),
    "unknown dtype": (GOOD | {"dtype": "float16"}, UndecodableBody, "float16"),
    "unknown option": (GOOD | {"out_of_domain": "ignore"}, UndecodableBody, "ignore"),
    "output of a wrong type": (GOOD | {"output": 1}, UndecodableBody, "output"),
    "text for a number": (GOOD | {"grid": UNIFORM | {"f_min": "20"}}, UndecodableBody, "f_min"),
    "truth for a number": (GOOD | {"grid": UNIFORM | {"f_min": True}}, UndecodableBody, "f_min"),
    "text for a parameter": (GOOD | {"parameters": TYPICAL | {"chi_1": "0"}}, UndecodableBody, "float"),
    "null for a parameter": (GOOD | {"parameters": TYPICAL | {"chi_1": None}}, UndecodableBody, "float"),
    "null in a vector": (GOOD | {"parameters": TYPICAL | {"chi_1": [None]}}, UndecodableBody, "float"),
    "nested vector": (GOOD | {"parameters": TYPICAL | {"chi_1": [[0.0]]}}, UndecodableBody, "float"),
    "map for a parameter": (GOOD | {"parameters": TYPICAL | {"chi_1": {}}}, UndecodableBody, ""),
    "rows without names": (GOOD | {"parameters": [[1.0] * 10]}, UndecodableBody, ""),
    "names of a wrong type": (NAMED | {"names": "mass_ratio"}, UndecodableBody, "names"),
    "columns with names": (GOOD | {"names": list(PARAMETER_NAMES)}, UndecodableBody, ""),
    "misspelt parameter": (
        GOOD | {"parameters": TYPICAL | {"lamda_1": 1.0}},
        InvalidParameters,
        "Did you mean 'lambda_1'",
    ),
    "missing parameters": (GOOD | {"parameters": {"chi_1": 0.0}}, InvalidParameters, "Missing parameters: mass_ratio"),
    "unequal lengths": (
        GOOD | {"parameters": TYPICAL | {"chi_1": [0.0], "chi_2": [0.0, 0.1]}},
        InvalidParameters,
        "same length",
    ),
    "misspelt name": (NAMED | {"names": [*PARAMETER_NAMES[:9], "timeshift"]}, InvalidParameters, "'time_shift'"),
    "repeated name": (NAMED | {"names": ["chi_1"] * 2 + list(PARAMETER_NAMES[2:])}, InvalidParameters, "more than"),
    "names missing": (NAMED | {"names": ["chi_1"]}, InvalidParameters, "Missing"),
    "rows too short": (NAMED | {"parameters": [[1.0] * 9]}, InvalidParameters, r"[N, 10]"),
    "empty rows": (NAMED | {"parameters": [[], []]}, InvalidParameters, r"[N, 10]"),
    "ragged rows": (NAMED | {"parameters": [[1.0] * 10, [1.0] * 9]}, InvalidParameters, "one value for each"),
    "no form of a grid": (GOOD | {"grid": {}}, InvalidFrequencies, "exactly one"),
    "two forms of a grid": (GOOD | {"grid": UNIFORM | {"sha256": "0"}}, InvalidFrequencies, "exactly one"),
    "half a uniform grid": (GOOD | {"grid": {"f_min": 1.0, "f_max": 2.0}}, InvalidFrequencies, "all of"),
    "no step": (GOOD | {"grid": UNIFORM | {"delta_f": 0.0}}, InvalidFrequencies, "'delta_f'"),
    "no frequencies": (GOOD | {"grid": {"frequencies": []}}, InvalidFrequencies, "empty"),
    "unsorted frequencies": (GOOD | {"grid": {"frequencies": [2.0, 1.0]}}, InvalidFrequencies, "number 1"),
    "negative frequency": (GOOD | {"grid": {"frequencies": [-2.0, 1.0]}}, InvalidFrequencies, "not positive"),
    "frequencies of a wrong type": (GOOD | {"grid": {"frequencies": "20"}}, UndecodableBody, ""),
}


@both
@pytest.mark.parametrize(("message", "kind", "says"), REFUSED.values(), ids=REFUSED)
def test_what_is_wrong_is_said_alike_in_both_media_types(message, kind, says, media_type):
    with pytest.raises(InvalidRequest) as raised:
        decode(message, media_type)
    assert type(raised.value) is kind
    assert says in raised.value.detail


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_frequencies_that_are_not_finite_are_refused_in_messagepack(value):
    for grid in ({"frequencies": [20.0, value]}, {"frequencies": array_map(np.array([20.0, value]))}):
        with pytest.raises(InvalidFrequencies, match="number 1"):
            decode(GOOD | {"grid": grid}, MSGPACK)


@pytest.mark.parametrize("dtype", ["<c16", "<c8", "|u1"])
def test_parameters_and_frequencies_are_real(dtype):
    array = array_map(np.ones(2, dtype))
    for message in (GOOD | {"grid": {"frequencies": array}}, GOOD | {"parameters": TYPICAL | {"chi_1": array}}):
        with pytest.raises(UndecodableBody, match="<f8 or <f4"):
            decode(message, MSGPACK)


def test_an_array_map_means_nothing_in_json():
    array = {"nd": True, "type": "<f8", "kind": "", "shape": [1], "data": "AAAAAAAA8D8="}
    with pytest.raises(UndecodableBody):
        decode(GOOD | {"grid": {"frequencies": array}}, JSON)


GRID = b"\xa4grid" + msgpack.packb({"f_min": 20.0, "f_max": 30.0, "delta_f": 1.0})
NAMES = b"\x83\xa5names" + msgpack.packb(list(TYPICAL)) + b"\xaaparameters"
ONE_COLUMN = b"\x82\xaaparameters" + msgpack.packb(TYPICAL)[:-9]
HOSTILE = {
    "empty": b"",
    "text": b"hello",
    "nested lists": (b"\x91" * 100_000, b"[" * 100_000),
    "nested maps": (b"\x81\xa1a" * 100_000, b'{"a":' * 100_000),
    "nested parameters": (
        b"\x82\xaaparameters" + b"\x81\xa1a" * 50_000 + b"\xc0\xa4grid\x80",
        b'{"parameters":' + b'{"a":' * 50_000 + b"1" + b"}" * 50_000 + b',"grid":{}}',
    ),
    "a lying map": b"\xdf\xff\xff\xff\xff",
    "a lying list": b"\xdd\xff\xff\xff\xff",
    "a lying binary": b"\x82\xaaparameters\xc6\xff\xff\xff\xff",
    "not UTF-8": (b"\x82\xaaparameters\x81\xa1\xff\x01\xa4grid\x80", b'{"parameters":{"\xff":1},"grid":{}}'),
    "number out of range": b'{"parameters":{},"grid":{"f_min":1e999}}',
    "NaN in JSON": b'{"parameters":{},"grid":{"f_min":NaN}}',
    "very many parameters": b"\x82\xaaparameters\xdf" + (2**20).to_bytes(4, "big") + b"\xa1a\x90" * 2**20 + GRID,
    "very many rows": NAMES + b"\xdd" + (2**22).to_bytes(4, "big") + b"\x90" * 2**22 + GRID,
    "very many numbers": ONE_COLUMN + b"\xdd" + (2**22).to_bytes(4, "big") + b"\x01" * 2**22 + GRID,
    "trailing bytes": (msgpack.packb(GOOD) + b"\xc0", json.dumps(GOOD).encode() + b"{}"),
}


@pytest.mark.parametrize("bodies", HOSTILE.values(), ids=HOSTILE)
def test_hostile_bodies_are_refused(bodies):
    for body in bodies if isinstance(bodies, tuple) else (bodies,):
        for media_type in (MSGPACK, JSON):
            with pytest.raises(UndecodableBody):
                decode_request(body, media_type)


def accepted(body, media_type=MSGPACK):
    """Accepted, or refused by an error that is the caller's."""
    try:
        decode_request(body, media_type)
    except InvalidRequest:
        return False
    return True


@pytest.mark.parametrize("media_type", WRITERS)
def test_every_truncation_is_refused(media_type):
    body = WRITERS[media_type](GOOD)
    assert accepted(body, media_type)
    assert not any(accepted(body[:length], media_type) for length in range(len(body)))


def test_mutations_are_refused_or_read():
    generator = random.Random(7)
    body = encode_request(WaveformRequest(batch=BATCH, grid=FREQUENCIES))
    outcomes = set()
    for _ in range(4_000):
        mutated = bytearray(body)
        for _ in range(generator.randint(1, 3)):
            mutated[generator.randrange(len(mutated))] = generator.randrange(256)
        outcomes.add(accepted(bytes(mutated)))
    assert outcomes == {True, False}


@given(st.binary(max_size=100), st.sampled_from([MSGPACK, JSON]))
def test_random_bytes_are_refused(body, media_type):
    assert not accepted(body, media_type)


JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**63), 2**63) | st.floats() | st.text(max_size=4),
    lambda children: st.lists(children, max_size=3) | st.dictionaries(st.text(max_size=8), children, max_size=3),
    max_leaves=8,
)


@settings(max_examples=200)
@given(
    parameters=JSON_VALUES | st.fixed_dictionaries(dict.fromkeys(TYPICAL, JSON_VALUES)),
    grid=JSON_VALUES | st.fixed_dictionaries({}, optional=dict.fromkeys([*UNIFORM, "frequencies"], JSON_VALUES)),
    names=JSON_VALUES,
)
def test_messages_of_anything_are_refused_or_read(parameters, grid, names):
    message = {"parameters": parameters, "grid": grid}
    for variant in (message, message | {"names": names}):
        accepted(msgpack.packb(variant), MSGPACK)
        accepted(json.dumps(variant).encode(), JSON)


def test_a_request_that_was_damaged_is_refused_or_another_one():
    binary = ParameterBatch.one(ParametersWithExtrinsic.gw170817())
    message = encode_request(WaveformRequest(batch=binary, grid=UniformGrid(20.0, 40.0, 2.5)))
    expected = decode_request(message)
    for position in range(len(message)):
        damaged = message[:position] + bytes([message[position] ^ 1]) + message[position + 1 :]
        try:
            read = decode_request(damaged)
        except BnserveError:
            continue
        same = np.array_equal(read.batch.values, expected.batch.values) and read.grid == expected.grid
        asked = (expected.output, expected.dtype, expected.options)
        assert not same or (read.output, read.dtype, read.options) != asked
    np.testing.assert_array_equal(decode_request(message).batch.values, expected.batch.values)
