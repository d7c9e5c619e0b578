"""Batches sized by the limits a service states."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_protocol import Limits


@pytest.mark.parametrize(
    ("frequencies", "rows"), [(0, 100), (1, 100), (10, 100), (11, 90), (500, 2), (501, 1), (1000, 1), (5000, 1)]
)
def test_rows_per_request(frequencies, rows):
    assert Limits(max_rows=100, max_samples=1000).rows_per_request(frequencies) == rows


@given(st.integers(1, 10**6), st.integers(1, 10**9), st.integers(1, 10**7))
def test_the_largest_batch_within_every_limit(max_rows, max_samples, frequencies):
    rows = Limits(max_rows=max_rows, max_samples=max_samples).rows_per_request(frequencies)
    assert rows == 1 or (rows <= max_rows and rows * frequencies <= max_samples)
    assert rows == max_rows or (rows + 1) * frequencies > max_samples


def test_an_older_client_reads_the_limits_of_a_newer_service():
    assert msgspec.json.decode(b'{"max_rows": 3, "max_moons": 7}', type=Limits) == Limits(max_rows=3)
