"""Grids that come again are known again, and never mistaken for others."""

import numpy as np

from bnserve_surrogate.kernel._evaluate import GridCache

FREQUENCIES = np.linspace(20.0, 1000.0, 99)


def unchangeable(frequencies):
    return np.frombuffer(frequencies.tobytes())


def test_equal_frequencies_are_prepared_once():
    cache = GridCache()
    prepared = cache.prepare(FREQUENCIES)
    assert cache.prepare(FREQUENCIES.copy()) is prepared
    assert cache.prepare(FREQUENCIES).powers is prepared.powers


def test_an_array_that_nothing_can_change_is_known_by_itself_from_the_second_time_on():
    cache = GridCache()
    prepared = cache.prepare(FREQUENCIES)
    grid = unchangeable(FREQUENCIES)
    second = cache.prepare(grid)
    assert second.powers is prepared.powers
    assert second.source is grid
    assert cache.prepare(grid) is second


def test_an_array_changed_in_place_is_another_grid():
    cache = GridCache()
    grid = FREQUENCIES.copy()
    before = cache.prepare(grid).powers
    grid[3] += 0.25  # neither the first, the middle nor the last
    after = cache.prepare(grid)
    assert after.powers is not before
    assert after.frequencies[3] == grid[3]


def test_only_the_grids_used_last_are_kept():
    cache = GridCache(max_grids=2)
    first = cache.prepare(FREQUENCIES)
    for shift in (1.0, 2.0):
        cache.prepare(FREQUENCIES + shift)
    assert cache.prepare(FREQUENCIES) is not first
