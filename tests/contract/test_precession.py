"""Binaries that precess: every way to reach a model gives the local one's bits and errors."""

import dataclasses

import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_protocol import EvaluationOptions, InvalidRequest, OutOfBand, OutOfDomain, ParameterBatch, RowStatus
from bnserve_service import BackgroundServer, Settings
from tests.contract.test_waveform_model import ONE, SHORT, binaries, bits, failure
from tests.service.chirp import MemorySource, as_it_is
from tests.service.modes_chirp import ModesModel

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")

AT_20_HZ = EvaluationOptions(reference_frequency=20.0)
PRECESSING = dataclasses.replace(ONE, chi_1x=0.2, chi_1y=-0.1, chi_2x=0.05)


def precessing(rows):
    """Binaries of which the first does not precess."""
    random = np.random.default_rng(5)
    in_plane = random.uniform(-0.4, 0.4, (rows, 4))
    in_plane[0] = 0.0
    return ParameterBatch(binaries(rows).values, in_plane)


@pytest.mark.parametrize("dtype", ["complex128", "complex64"])
@pytest.mark.parametrize("rows", [1, 2, 9, 40])
def test_batches_are_equal_in_bits(model, local, rows, dtype):
    asked = {"options": AT_20_HZ, "dtype": dtype}
    batch = precessing(rows)
    assert bits(model.predict_batch(SHORT, batch, **asked)) == bits(local.predict_batch(SHORT, batch, **asked))


def test_one_binary_is_equal_in_bits(model, local):
    ours, theirs = (each.predict(SHORT, PRECESSING, options=AT_20_HZ) for each in (model, local))
    assert bits(ours) == bits(theirs)
    assert np.abs(ours.plus - local.predict(SHORT, ONE, options=AT_20_HZ).plus).max() > 0.0


def test_rows_that_are_refused_are_flagged(model, local):
    batch = ParameterBatch(binaries(4).values, [[0.1] * 4, [np.nan, 0.0, 0.0, 0.0], [0.9, 0.9, 0.0, 0.0], [0.2] * 4])
    options = EvaluationOptions(reference_frequency=20.0, out_of_domain="flag")
    ours = model.predict_batch(SHORT, batch, options=options)
    assert ours.status.tolist() == [RowStatus.OK, RowStatus.NOT_FINITE, RowStatus.OUT_OF_DOMAIN, RowStatus.OK]
    assert np.isnan(ours.plus).all(axis=1).tolist() == [False, True, True, False]
    assert bits(ours) == bits(local.predict_batch(SHORT, batch, options=options))


def test_the_time_until_merger_is_that_of_the_orbit(model, local):
    assert model.time_until_merger(30.0, PRECESSING) == local.time_until_merger(30.0, ONE)


def test_a_model_that_does_not_say_that_it_precesses_is_not_asked_to():
    source = MemorySource().add(ModesModel())
    with (
        BackgroundServer(Settings(port=0), source=source, factory=as_it_is) as server,
        RemoteModel.connect(server.address, "modes") as model,
        pytest.raises(InvalidRequest, match="does not say that it has precession"),
    ):
        model.predict(SHORT, PRECESSING, options=AT_20_HZ)


ERRORS = {
    "no reference frequency": (
        lambda it: it.predict(SHORT, PRECESSING), InvalidRequest, "EvaluationOptions\\(reference_frequency=20.0\\)",
    ),
    "too large": (
        lambda it: it.predict(SHORT, dataclasses.replace(ONE, chi_2y=1.1), options=AT_20_HZ), OutOfDomain, "star 2",
    ),
    "modes": (
        lambda it: it.predict_modes(SHORT, PRECESSING, options=AT_20_HZ), InvalidRequest, "predict_batch",
    ),
    "an amplitude": (
        lambda it: it.predict_amplitude_phase(SHORT, PRECESSING, options=AT_20_HZ), InvalidRequest, "predict_batch",
    ),
    "too low": (
        lambda it: it.predict(np.array([0.01, 20.0]), PRECESSING, options=AT_20_HZ), OutOfBand, "turns are followed",
    ),
    "above the band": (
        lambda it: it.predict(SHORT, PRECESSING, options=EvaluationOptions(reference_frequency=6000.0)),
        OutOfBand, "above the model's band",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("call", "kind", "words"), ERRORS.values(), ids=ERRORS)
def test_errors_are_the_same(model, local, call, kind, words):
    assert failure(lambda: call(model)) == failure(lambda: call(local))
    with pytest.raises(kind, match=words):
        call(model)
