"""What 0.1 pickled is read, although it is in another module now."""

import pickle

import numpy as np
import pytest

from bnserve_protocol import LikelihoodBatch, ParameterBatch, RowStatus

BATCHES = [
    (ParameterBatch(np.ones((2, 10))), b"_batches", b"_parameters"),
    (LikelihoodBatch(np.ones((2, 13))), b"_likelihood_batches", b"_likelihood_parameters"),
]


@pytest.mark.parametrize(("batch", "now", "before"), BATCHES)
def test_a_batch_that_was_pickled_by_0_1_is_read(batch, now, before):
    pickled = pickle.dumps(batch, protocol=2)
    module = b"bnserve_protocol."
    assert pickled.count(module + now + b"\n") == 1
    read = pickle.loads(pickled.replace(module + now + b"\n", module + before + b"\n"))
    assert type(read) is type(batch)
    np.testing.assert_array_equal(read.values, batch.values)


def test_a_status_that_was_pickled_by_0_1_is_read():
    assert pickle.loads(b"cbnserve_protocol._model\nRowStatus\n(I2\ntR.") is RowStatus.OUT_OF_DOMAIN
