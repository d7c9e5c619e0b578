"""How much a token may keep uploaded: exactly that, whatever comes at once; and nobody loses what he has uploaded."""

import hashlib
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import numpy as np
import pytest

from bnserve_protocol import QuotaExceeded, TooLarge
from bnserve_service import BackgroundServer, Settings, Token
from bnserve_service.uploads import storage_quotas as storage_quotas_module
from bnserve_service.uploads.storage_quotas import StorageQuotas
from tests.service.asking import ask
from tests.service.chirp import ChirpModel, MemorySource, as_it_is
from tests.service.conftest import SMALL_LIMITS
from tests.service.injections import name_of, small_analysis
from tests.service.injections import upload as upload_analysis

LIMITED, OTHER = "a-token-with-a-quota", "a-token-without-one"
NAMES = [hashlib.sha256(bytes([number])).hexdigest() for number in range(4)]


def bearer(text):
    return {"authorization": f"Bearer {text}"}


class Kept:
    """Uploads by owner and digest, or common ones by digest alone."""

    def __init__(self, is_common=False):
        self.there = set()
        self.is_common = is_common

    def put(self, owner, name):
        self.there.add(self._of(owner, name))

    def has(self, owner, name):
        return self._of(owner, name) in self.there

    def discard(self, owner, name):
        self.there.discard(self._of(owner, name))

    def _of(self, owner, name):
        return name if self.is_common else (owner, name)


@pytest.fixture(params=[False, True], ids=["one process", "workers"])
def folder(request, tmp_path):
    return tmp_path if request.param else None


class Case:
    """Two tokens, one with a quota of 2000 bytes, in a server of one process or in any worker of several."""

    def __init__(self, folder, is_common):
        tokens = [Token.of(LIMITED, "limited", max_stored_bytes=2000), Token.of(OTHER, "other")]
        self.limited, self.other = (token.sha256 for token in tokens)
        most = {token.sha256: token.max_stored_bytes for token in tokens}
        self.kept = Kept(is_common)
        uploads = {"grid": self.kept, "analysis": self.kept}
        workers = [StorageQuotas(most.get, uploads, folder) for _ in range(1 if folder is None else 2)]
        self.quotas, self.quotas_elsewhere = workers[0], workers[-1]

    def upload(self, owner, name, size, kind="grid"):
        with self.quotas.room(owner, kind, name, size):
            self.kept.put(owner, name)


@pytest.fixture
def case(folder, monkeypatch):
    def make(is_common=False, kept_seconds=60.0):
        monkeypatch.setattr(storage_quotas_module, "KEPT_SECONDS", kept_seconds)
        return Case(folder, is_common)

    return make


def test_what_was_uploaded_a_moment_ago_stays(case):
    it = case()
    it.upload(it.limited, NAMES[0], 1200)
    it.upload(it.limited, NAMES[0], 1200)
    it.upload(it.limited, NAMES[1], 800, "analysis")
    with pytest.raises(QuotaExceeded) as refused:
        it.upload(it.limited, NAMES[2], 900)
    assert 50.0 < refused.value.retry_after <= 60.0
    with pytest.raises(TooLarge, match="2000"):
        it.upload(it.limited, NAMES[2], 2001)
    it.upload(it.other, NAMES[2], 10**9)


def test_what_was_dropped_for_other_reasons_makes_room(case):
    it = case()
    it.upload(it.limited, NAMES[0], 1200)
    it.kept.there.clear()
    it.upload(it.limited, NAMES[1], 2000)


def test_later_it_makes_room_for_the_next(case):
    it = case(kept_seconds=0.0)
    for name in NAMES:
        it.upload(it.limited, name, 1500)
    assert it.kept.there == {(it.limited, NAMES[-1])}


def test_an_upload_that_is_being_stored_counts(case):
    it = case(kept_seconds=0.0)
    with it.quotas.room(it.limited, "grid", NAMES[0], 1500):
        with pytest.raises(QuotaExceeded) as refused, it.quotas_elsewhere.room(it.limited, "analysis", NAMES[1], 501):
            pytest.fail("nothing may be stored")
        assert refused.value.retry_after >= 1.0
        with it.quotas_elsewhere.room(it.limited, "analysis", NAMES[1], 500):
            pass


def test_one_content_uploaded_several_times_at_once_counts_once(case):
    it = case()
    with (
        it.quotas.room(it.limited, "grid", NAMES[0], 1500),
        it.quotas_elsewhere.room(it.limited, "grid", NAMES[0], 1500),
    ):
        it.kept.put(it.limited, NAMES[0])
    with pytest.raises(QuotaExceeded):
        it.upload(it.limited, NAMES[1], 600)
    it.upload(it.limited, NAMES[1], 500)


def test_an_upload_that_fails_takes_no_room(case):
    it = case()
    with pytest.raises(ValueError, match="no grid"), it.quotas.room(it.limited, "grid", NAMES[0], 1500):
        raise ValueError("no grid")
    it.upload(it.limited, NAMES[1], 2000)


def test_an_upload_of_a_worker_that_died_takes_no_room_for_long(case, monkeypatch):
    it = case()
    it.quotas.room(it.limited, "grid", NAMES[0], 1500).__enter__()
    monkeypatch.setattr(storage_quotas_module, "LEFT_BEHIND", 0.0)
    it.upload(it.limited, NAMES[1], 2000)


def test_what_others_have_uploaded_too_is_only_lost_when_the_last_of_them_loses_it(case):
    it = case(is_common=True, kept_seconds=0.0)
    for owner in (it.other, it.limited):
        it.upload(owner, NAMES[0], 1500)
    it.upload(it.limited, NAMES[1], 1500)
    it.upload(it.limited, NAMES[2], 1500)
    assert it.kept.there == {NAMES[0], NAMES[2]}


def test_what_another_is_about_to_upload_is_not_dropped_under_him(case):
    it = case(is_common=True, kept_seconds=0.0)
    it.upload(it.limited, NAMES[0], 1500)
    with it.quotas_elsewhere.room(it.other, "grid", NAMES[0], 1500):  # which finds it there already
        it.upload(it.limited, NAMES[1], 1500)
    assert it.kept.there == {NAMES[0], NAMES[1]}


@pytest.mark.parametrize("name", ["", "..", "x" * 64, "*", "a-b-c", "0" * 63])
def test_a_name_that_is_no_digest_leaves_nothing_behind(case, folder, name):
    it = case()
    with it.quotas.room(it.limited, "grid", name, 1500):
        pass
    it.upload(it.limited, NAMES[1], 2000)
    if folder is not None:
        assert [path.name for path in folder.rglob("grid-*")] == [f"grid-{NAMES[1]}-2000"]


def grid(first, points):
    body = np.linspace(first, 900.0, points).tobytes()
    return f"/v1/grids/{hashlib.sha256(body).hexdigest()}", body


def put(address, what, token=LIMITED):
    path, body = what
    return ask(address, "PUT", path, body, content_type="application/octet-stream", **bearer(token))


def test_over_its_stored_bytes_a_token_is_refused(start):
    server = start(ChirpModel(), tokens=(Token.of(LIMITED, max_stored_bytes=2000), Token.of(OTHER)))
    assert put(server.address, grid(20.0, 150)).status == 201
    assert put(server.address, grid(20.0, 150)).status == 200
    answer = put(server.address, grid(30.0, 150))
    assert (answer.status, answer.code) == (429, "share-exceeded")
    assert 0 < int(answer.headers["retry-after"]) <= 61
    assert put(server.address, grid(30.0, 150), OTHER).status == 201
    assert put(server.address, grid(40.0, 300)).status == 413


@contextmanager
def two_workers(tmp_path, **settings):
    """Two servers that share what workers share."""
    source = MemorySource().add(ChirpModel())
    one, other = (
        BackgroundServer(
            Settings(**(SMALL_LIMITS | settings)), source=source, factory=as_it_is, shared=tmp_path, worker=number
        )
        for number in range(2)
    )
    with one, other:
        yield [one.address, other.address]


def test_ten_uploads_at_once_store_no_more_than_ten_one_after_the_other(tmp_path):
    limits = {"max_frequencies": 2**17, "max_grids": 64}
    tokens = (Token.of(LIMITED, max_stored_bytes=800_000), Token.of(OTHER))
    with two_workers(tmp_path, tokens=tokens, **limits) as addresses, ThreadPoolExecutor(10) as callers:
        together = threading.Barrier(10)

        def upload(number):
            together.wait()
            return put(addresses[number % 2], grid(20.0 + number, 48_000))

        statuses = [answer.status for answer in callers.map(upload, range(10))]
        assert sorted(statuses) == [201] * 2 + [429] * 8, "384,000 bytes each"


def test_a_limited_token_cannot_take_the_grid_of_another(start, monkeypatch):
    monkeypatch.setattr(storage_quotas_module, "KEPT_SECONDS", 0.0)
    server = start(ChirpModel(), tokens=(Token.of(LIMITED, max_stored_bytes=2000), Token.of(OTHER)))
    shared = grid(20.0, 150)
    assert put(server.address, shared, OTHER).status == 201
    assert put(server.address, shared).status == 200, "it owns it, too"
    for first in (30.0, 40.0):
        assert put(server.address, grid(first, 150)).status == 201, "in place of what it had"
    assert ask(server.address, "HEAD", shared[0], **bearer(OTHER)).status == 200


def test_nor_its_analysis(start, monkeypatch):
    monkeypatch.setattr(storage_quotas_module, "KEPT_SECONDS", 0.0)
    analyses = [small_analysis(seed=seed) for seed in range(2)]
    tokens = (Token.of(LIMITED, max_stored_bytes=12_000), Token.of(OTHER))
    server = start(ChirpModel(), tokens=tokens)
    for token in (OTHER, LIMITED):
        assert upload_analysis(server.address, analyses[0], **bearer(token)).status == 201
    assert upload_analysis(server.address, analyses[1], **bearer(LIMITED)).status == 201
    at = f"/v1/analyses/{name_of(analyses[0])}"
    found = [ask(server.address, "HEAD", at, **bearer(token)).status for token in (LIMITED, OTHER)]
    assert found == [404, 200]
