"""Memory of large results: used again, aligned, bounded, and never shared by two results that are alive."""

import gc
import threading

import numpy as np
import pytest

from bnserve_protocol.wire import ResultMemory, address_of

LARGE = (300, 400)


def address(array):
    return array.__array_interface__["data"][0]


def test_large_blocks_begin_at_a_multiple_of_64_bytes():
    memory = ResultMemory()
    for size in range(2**16, 2**16 + 300, 7):
        assert address(memory.empty((size,), "u1")) % 64 == 0


@pytest.mark.parametrize("dtype", ["<c16", "<c8", "<f8", "|u1"])
def test_it_gives_what_numpy_empty_gives(dtype):
    for shape in [(0,), (5,), (3, 0), LARGE]:
        array = ResultMemory().empty(shape, dtype)
        assert (array.shape, array.dtype, array.flags.c_contiguous) == (shape, np.dtype(dtype), True)
        array[...] = 1


def test_a_block_is_used_again_when_the_last_array_in_it_is_gone():
    memory = ResultMemory()
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
    memory = ResultMemory()
    memory.empty(LARGE, complex)
    kept = memory.kept
    small = memory.empty((2**16,), "u1")
    assert memory.kept == kept
    assert len(small) == 2**16


def test_what_is_kept_can_be_given_back_while_results_live_on():
    memory = ResultMemory()
    alive, gone = memory.empty(LARGE, complex), memory.empty(LARGE, complex)
    alive[...] = 7.0
    del gone
    gc.collect()
    assert memory.kept > 0
    memory.give_back()
    assert memory.kept == 0
    assert (alive == 7.0).all()
    del alive
    gc.collect()
    assert memory.kept > 0


def test_what_is_kept_is_bounded():
    memory = ResultMemory()
    arrays = [memory.empty((2**24,), "u1") for _ in range(12)]
    assert memory.kept == 0
    del arrays
    gc.collect()
    assert 0 < memory.kept <= 2**27


def test_what_nobody_asks_for_again_makes_room():
    """A process that went on to larger results does not touch fresh memory for each because of the smaller ones."""
    memory = ResultMemory()
    early = [memory.empty((2**24,), "u1") for _ in range(8)]
    del early
    gc.collect()
    late = memory.empty((3 * 2**25,), "u1")
    del late
    gc.collect()
    before = memory.kept
    assert before <= 2**27
    again = memory.empty((3 * 2**25,), "u1")
    assert before - memory.kept >= len(again)


def test_threads_never_share_a_block():
    memory, failures = ResultMemory(), []

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


@pytest.mark.parametrize(
    "array",
    [
        np.empty(3),
        np.empty((3, 4), complex),
        np.empty(0),
        np.zeros(8)[::2],
        np.empty((3, 4))[:, :2],
        np.empty((3, 4), order="F"),
        np.empty((2, 277), np.complex64)[1],
        np.frombuffer(b"abcdefgh", np.uint8),
    ],
    ids=["vector", "matrix", "empty", "gaps", "columns", "fortran", "row", "read-only"],
)
def test_the_address_of_any_array(array):
    assert address_of(array) == array.__array_interface__["data"][0]
