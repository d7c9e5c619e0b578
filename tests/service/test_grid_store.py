"""Uploaded grids: checked, bounded, the least recently used dropped first."""

import hashlib

import numpy as np
import pytest

from bnserve_protocol import GridUnknown, InvalidFrequencies
from bnserve_service import Settings
from bnserve_service.uploads.grids import GridStore
from tests.service.asking import ask


def upload(cache, frequencies):
    body = np.asarray(frequencies, dtype="<f8").tobytes()
    digest = hashlib.sha256(body).hexdigest()
    cache.put("", digest, body)
    return digest


def test_a_grid_comes_back_as_it_was_and_read_only():
    cache = GridStore(Settings(max_frequencies=100))
    digest = upload(cache, [10.0, 20.0])
    frequencies = cache.get("", digest)
    assert frequencies.tolist() == [10.0, 20.0]
    assert not frequencies.flags.writeable
    assert cache.get("", digest) is frequencies, "the model recognises a grid it has seen"


def test_the_least_recently_used_is_dropped():
    cache = GridStore(Settings(max_grids=2, max_frequencies=100))
    first, second = upload(cache, [1.0]), upload(cache, [2.0])
    cache.get("", first)
    third = upload(cache, [3.0])
    with pytest.raises(GridUnknown):
        cache.get("", second)
    assert [len(cache.get("", digest)) for digest in (first, third)] == [1, 1]
    assert cache.stored_bytes == 16


def test_memory_is_bounded_too():
    cache = GridStore(Settings(max_grid_bytes=2**20))
    digests = [upload(cache, np.arange(start, start + 2.0**16)) for start in (1.0, 2.0, 3.0)]
    assert len(cache) == 2
    assert cache.stored_bytes == 2**20
    with pytest.raises(GridUnknown):
        cache.get("", digests[0])


def test_a_bad_grid_leaves_nothing_behind():
    cache = GridStore(Settings(max_grids=2, max_frequencies=100))
    for frequencies in ([2.0, 1.0], [0.0, 1.0], [np.nan]):
        with pytest.raises(InvalidFrequencies):
            upload(cache, frequencies)
    assert len(cache) == 0


def test_uploading_twice_is_no_new_grid(server):
    body = np.linspace(11.0, 13.0, 7).tobytes()
    path = f"/v1/grids/{hashlib.sha256(body).hexdigest()}"
    assert ask(server.address, "HEAD", path).status == 404
    first = ask(server.address, "PUT", path, body, content_type="application/octet-stream")
    assert first.status == 201
    assert first.document == {"sha256": path.rpartition("/")[2], "frequencies": 7}
    assert first.headers["x-request-digest"] == path.rpartition("/")[2]
    assert ask(server.address, "PUT", path, body).status == 200
    assert ask(server.address, "HEAD", path).status == 200
