"""Results in memory that is used again stay what they are."""

import numpy as np

from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel, binaries

GRID = np.geomspace(20.0, 1000.0, 400)


def test_results_keep_their_values_while_others_come_and_go(model):
    expected = {rows: ReferenceModel().predict_batch(GRID, binaries(rows)) for rows in (40, 41, 42)}
    results = [(rows, model.predict_batch(GRID, binaries(rows))) for rows in (40, 41, 42, 40, 41, 42)]
    for rows, result in results:
        assert same(result, expected[rows])
        result.plus[...] = 0.0  # they are the user's, to write to as well
        result.cross[...] = 1.0
    del results, result
    again = model.predict_batch(GRID, binaries(41))
    assert same(again, expected[41])
    assert again.plus.flags.aligned
    assert not np.shares_memory(again.plus, again.cross)
    factored = model.predict_factored(GRID, binaries(42))
    assert same(factored, ReferenceModel().predict_factored(GRID, binaries(42)))
    factored.h[...] = 0.0
