"""Signals in time: those of a remote model equal the local one in bits and errors, whatever limits a service has."""

import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_protocol import EvaluationOptions, InvalidRequest, OutOfBand, TimeSeries, predict_time_domain
from bnserve_service import BackgroundServer, Settings
from tests.contract.test_waveform_model import FLAG, ONE, bits, failure, with_values
from tests.service.chirp import MemorySource, as_it_is
from tests.service.modes_chirp import ModesModel

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")

HOW = {
    "from a frequency": {"f_min": 80.0, "sampling_rate": 4096.0},
    "for a duration": {"duration": 2.0},
    "of chosen modes": {"f_min": 80.0, "options": EvaluationOptions(modes=[(2, 2)], alignment="merger")},
}


@pytest.mark.parametrize("how", HOW.values(), ids=HOW)
@pytest.mark.parametrize(
    "parameters", [ONE, [ONE], with_values(3, mass_ratio=2.0)], ids=["one", "a batch of one", "a batch"]
)
def test_signals_are_equal_in_bits(model, local, parameters, how):
    there = model.predict_time_domain(parameters, **how)
    assert type(there) is TimeSeries
    assert there.plus.shape == (() if parameters is ONE else (len(there.status),)) + there.times.shape
    assert bits(there) == bits(local.predict_time_domain(parameters, **how))


def test_flagged_rows_are_equal_in_bits(model, local):
    batch, how = with_values(3, mass_ratio=0.5), {"f_min": 80.0, "options": FLAG}
    assert bits(model.predict_time_domain(batch, **how)) == bits(local.predict_time_domain(batch, **how))


@pytest.mark.parametrize(
    "how", [{}, {"f_min": 1e4}, {"f_min": 80.0, "sampling_rate": 10.0}, {"duration": 1e-3}], ids=str
)
def test_what_cannot_be_is_the_same_error(model, local, how):
    there = failure(lambda: model.predict_time_domain(ONE, **how))
    assert there == failure(lambda: local.predict_time_domain(ONE, **how))
    assert there[0] in (InvalidRequest, OutOfBand)


def test_no_question_exceeds_the_limits_of_the_service():
    """Of a service that takes 500 frequencies, or 900 samples, at a time; of three modes."""
    local, how = ModesModel(), {"f_min": 200.0, "sampling_rate": 4096.0}
    expected = predict_time_domain(local, ONE, **how)
    source = MemorySource().add(local)
    for limits in ({"max_frequencies": 500}, {"max_samples": 900, "max_frequencies": 900}):
        with (
            BackgroundServer(Settings(port=0, **limits), source=source, factory=as_it_is) as server,
            RemoteModel.connect(server.address, "modes") as remote,
        ):
            found = remote.predict_time_domain(ONE, **how)
            np.testing.assert_allclose(found.plus, expected.plus, atol=1e-12 * np.abs(expected.plus).max())
