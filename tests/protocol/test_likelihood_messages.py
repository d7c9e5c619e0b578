"""Likelihood parameters in every accepted form, and on the wire."""

import msgpack
import numpy as np
import pytest

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    InvalidParameters,
    LikelihoodBatch,
    LikelihoodParameters,
    ModelIdentity,
    UndecodableBody,
)
from bnserve_protocol.wire import (
    LikelihoodAnswer,
    decode_likelihood_answer,
    decode_likelihood_request,
    encode_likelihood_answer,
    encode_likelihood_request,
)

ROW = LikelihoodParameters(
    mass_ratio=1.2,
    lambda_1=400.0,
    lambda_2=600.0,
    chi_1=0.01,
    chi_2=0.0,
    inclination=2.5,
    total_mass=2.76,
    right_ascension=3.4,
    declination=-0.4,
    polarization_angle=0.7,
    distance_mpc=40.0,
    coalescence_time=0.002,
    calibration_amplitude={"H1": [0.1, 0.2]},
)
COLUMNS = {name: getattr(ROW, name) for name in LIKELIHOOD_NAMES}


def there_and_back(batch):
    return decode_likelihood_request(encode_likelihood_request("sha256:1", batch))


def test_all_forms_of_a_batch_are_one():
    of_rows = LikelihoodBatch.coerce([ROW, ROW])
    vectors = {name: np.full(2, value) for name, value in COLUMNS.items()}
    of_columns = LikelihoodBatch.coerce(vectors | {"calibration_amplitude": {"H1": [0.1, 0.2]}})
    scalars = LikelihoodBatch.coerce(
        COLUMNS | {"mass_ratio": [1.2, 1.2], "calibration_amplitude": {"H1": [[0.1, 0.2]] * 2}}
    )
    for batch in (of_columns, scalars, LikelihoodBatch.coerce(of_rows)):
        assert (batch.values == of_rows.values).all()
        assert (batch.calibration_amplitude["H1"] == of_rows.calibration_amplitude["H1"]).all()
        assert (batch.calibration_phase["H1"] == 0.0).all()
    assert len(LikelihoodBatch.coerce(ROW)) == 1


def test_a_batch_travels_unchanged():
    batch = LikelihoodBatch.coerce([ROW, ROW, ROW])
    request = there_and_back(batch)
    assert request.analysis == "sha256:1"
    assert (request.batch.values == batch.values).all()
    assert request.batch.absent == frozenset()
    for ours, theirs in (
        (batch.calibration_amplitude, request.batch.calibration_amplitude),
        (batch.calibration_phase, request.batch.calibration_phase),
    ):
        assert (ours["H1"] == theirs["H1"]).all()


def test_what_was_left_out_stays_left_out():
    fewer = {name: value for name, value in COLUMNS.items() if name not in ("distance_mpc", "coalescence_time")}
    batch = LikelihoodBatch.coerce(fewer)
    assert batch.absent == {"distance_mpc", "coalescence_time"}
    assert there_and_back(batch).batch.absent == batch.absent
    given = LikelihoodBatch.coerce(COLUMNS | {"distance_mpc": np.nan})  # a value like any other
    assert there_and_back(given).batch.absent == frozenset()


def test_pieces_of_a_batch_are_its_rows():
    batch = LikelihoodBatch.coerce(
        COLUMNS | {"mass_ratio": np.arange(5.0), "calibration_phase": {"L1": np.ones((5, 3))}}
    )
    pieces = batch.split(2)
    assert [len(piece) for piece in pieces] == [2, 2, 1]
    assert pieces[1]["mass_ratio"].tolist() == [2.0, 3.0]
    assert pieces[2].calibration_phase["L1"].shape == (1, 3)


def test_the_waveform_has_its_own_part():
    waveform = LikelihoodBatch.coerce(ROW).waveform_batch(distance_mpc=100.0)
    assert waveform["distance_mpc"].tolist() == [100.0]
    assert waveform["total_mass"].tolist() == [2.76]
    assert waveform["time_shift"].tolist() == [0.0]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"declinatoin": 1.0}, "Did you mean 'declination'"),
        ({"time_shift": 1.0}, "Unknown parameter 'time_shift'"),
        ({"mass_ratio": [1.0, 2.0], "chi_1": [0.0, 0.0, 0.0]}, "same length"),
        ({"mass_ratio": "heavy"}, "must be a number"),
        ({"mass_ratio": [[1.0]]}, "number or a vector"),
        ({"calibration_phase": 3.0}, "maps detectors to arrays"),
        ({"mass_ratio": [1.0, 2.0], "calibration_phase": {"H1": np.ones((3, 2))}}, r"arrays \(2, nodes\)"),
        ({"calibration_phase": {"H1": [1.0, 2.0]}, "calibration_amplitude": {"H1": [1.0]}}, "alike"),
    ],
)
def test_names_and_shapes_that_do_not_fit_are_refused(change, reason):
    with pytest.raises(InvalidParameters, match=reason):
        LikelihoodBatch.coerce(COLUMNS | change)


def test_missing_parameters_are_named():
    with pytest.raises(InvalidParameters, match="Missing parameter: declination"):
        LikelihoodBatch.coerce({name: value for name, value in COLUMNS.items() if name != "declination"})
    with pytest.raises(InvalidParameters, match="LikelihoodParameters"):
        LikelihoodBatch.coerce([1.0])
    with pytest.raises(InvalidParameters, match=r"shape \(N, 13\)"):
        LikelihoodBatch(np.ones((2, 3)))


def test_an_answer_travels_unchanged():
    answer = LikelihoodAnswer(
        log_likelihood=np.array([1.5, -np.inf]),
        status=np.array([0, 4], dtype=np.uint8),
        model=ModelIdentity("default", "1.0.0", "sha256:2"),
        analysis="sha256:1",
    )
    body = b"".join(encode_likelihood_answer(answer))
    there = decode_likelihood_answer(body)
    assert (there.log_likelihood == answer.log_likelihood).all()
    assert (there.status == answer.status).all()
    assert there.model == answer.model
    assert there.analysis == answer.analysis
    assert msgpack.unpackb(body, strict_map_key=False)["model"]["name"] == "default"


@pytest.mark.parametrize("body", [b"", b"\x80", b"\xc1", msgpack.packb({"analysis": 3}), b"\x91" * 5000])
def test_what_is_not_a_message_is_not_decoded(body):
    with pytest.raises(UndecodableBody):
        decode_likelihood_request(body)
    with pytest.raises(UndecodableBody):
        decode_likelihood_answer(body)
