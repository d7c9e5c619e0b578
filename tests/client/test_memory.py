"""Memory of large answers: used again, aligned, bounded, and never shared by two results that are alive."""

import gc
import threading

import numpy as np
import pytest

from bnserve_client._memory import Memory
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel, binaries

LARGE = (300, 400)
GRID = np.geomspace(20.0, 1000.0, 400)


def address(array):
    return array.__array_interface__["data"][0]


def test_large_blocks_begin_at_a_multiple_of_64_bytes():
    memory = Memory()
    for size in range(2**16, 2**16 + 300, 7):
        assert address(memory.empty((size,), "u1")) % 64 == 0


@pytest.mark.parametrize("dtype", ["<c16", "<c8", "<f8", "|u1"])
def test_it_gives_what_numpy_empty_gives(dtype):
    for shape in [(0,), (5,), (3, 0), LARGE]:
        array = Memory().empty(shape, dtype)
        assert (array.shape, array.dtype, array.flags.c_contiguous) == (shape, np.dtype(dtype), True)
        array[...] = 1


def test_a_block_is_used_again_when_the_last_array_in_it_is_gone():
    memory = Memory()
    array = memory.empty(LARGE, complex)
    where, part = address(array), array[3:, ::2]
    del array
    gc.collect()
    assert memory.kept == 0
    assert address(memory.empty(LARGE, complex)) != where
    del part
    gc.collect()
    assert memory.kept > 0
    assert where in {address(memory.empty(LARGE, complex)), address(memory.empty(LARGE, complex))}


def test_a_block_is_not_wasted_on_something_much_smaller():
    memory = Memory()
    memory.empty(LARGE, complex)
    kept = memory.kept
    small = memory.empty((2**16,), "u1")
    assert memory.kept == kept
    assert len(small) == 2**16


def test_what_is_kept_is_bounded():
    memory = Memory()
    arrays = [memory.empty((2**24,), "u1") for _ in range(8)]
    assert memory.kept == 0
    del arrays
    gc.collect()
    assert 0 < memory.kept <= 2**26


def test_threads_never_share_a_block():
    memory, failures = Memory(), []

    def work(number):
        for _ in range(300):
            array = memory.empty((2**17,), "u1")
            array[:] = number
            if (array != number).any():
                failures.append(number)

    threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


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
