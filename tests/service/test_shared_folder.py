"""What the workers of one server share: a folder for them alone, uploads, counts, and what they serve."""

import errno
import hashlib
import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pytest
from prometheus_client import CollectorRegistry, Counter, Gauge

from bnserve_protocol import AnalysisUnknown, GridUnknown, encode_analysis
from bnserve_service import BackgroundServer, Settings, Token
from bnserve_service.shared.folder import SharedFolder, SharedLoads
from bnserve_service.shared.metrics import SharedMetrics
from bnserve_service.uploads.analyses import AnalysisStore
from bnserve_service.uploads.blobs import BlobStore
from bnserve_service.uploads.bounds import Bounds
from bnserve_service.uploads.grids import GridStore
from tests.architecture.rooms import room_environment
from tests.service.asking import ask, evaluate, question
from tests.service.chirp import ChirpModel, MemorySource, as_it_is
from tests.service.conftest import SMALL_LIMITS
from tests.service.injections import name_of, small_analysis


def digest(body):
    return hashlib.sha256(body).hexdigest()


def grid(start, points=50):
    return np.arange(start, start + points).astype("<f8").tobytes()


@pytest.fixture
def blobs(tmp_path):
    return BlobStore(tmp_path / "blobs", Bounds(max_blobs=3, max_owner_bytes=1000, max_bytes=1500))


ME, YOU = "a" * 64, "b" * 64


class TestFolder:
    def test_nobody_else_can_look_inside(self, tmp_path):
        folder = SharedFolder.create(0, [tmp_path])
        assert folder.path.stat().st_mode & 0o777 == 0o700
        folder.remove()
        folder.close()
        assert list(tmp_path.iterdir()) == []

    def test_what_a_dead_server_left_is_removed_and_what_a_living_one_has_stays(self, tmp_path):
        code = "import sys, pathlib; from bnserve_service.shared.folder import SharedFolder; "
        code += "print(SharedFolder.create(0, [pathlib.Path(sys.argv[1])]).path)"
        command = [sys.executable, "-c", code, str(tmp_path)]
        dead = subprocess.run(command, capture_output=True, text=True, check=True, env=room_environment()).stdout
        assert os.path.isdir(dead.strip())  # noqa: PTH112
        living, other = SharedFolder.create(0, [tmp_path]), SharedFolder.create(0, [tmp_path])
        assert sorted(tmp_path.iterdir()) == sorted([living.path, other.path])
        assert living.remove_if_last()
        assert not SharedFolder(other.path).remove_if_last(), "somebody else has it open"
        for folder in (living, other):
            folder.close()

    def test_it_is_missed_when_it_is_gone_or_another_and_another_is_not_removed(self, tmp_path):
        folder = SharedFolder.create(0, [tmp_path])
        assert folder.is_there()
        shutil.rmtree(folder.path)
        assert not folder.is_there()
        folder.path.mkdir()
        other = SharedFolder(folder.path)
        assert not folder.is_there()
        folder.remove()
        assert other.is_there()
        other.remove()
        assert not folder.path.exists()
        for each in (folder, other):
            each.close()

    def test_it_is_where_there_is_room(self, tmp_path):
        small, large = tmp_path / "small", tmp_path / "large"
        small.mkdir()
        large.mkdir()
        assert SharedFolder.create(0, [small, large]).path.parent == small
        assert SharedFolder.create(2**80, [tmp_path / "missing", large]).path.parent == large
        with pytest.raises(FileNotFoundError, match="/dev/shm"):
            SharedFolder.create(0, [tmp_path / "missing"])


class TestBlobStore:
    def test_a_file_comes_back_as_it_was_for_its_owner_alone(self, blobs):
        assert blobs.put(ME, digest(b"x"), b"x")
        assert bytes(blobs.read(ME, digest(b"x"))) == b"x"
        assert blobs.read(YOU, digest(b"x")) is None
        assert blobs.use(ME, digest(b"x"))
        assert not blobs.use(YOU, digest(b"x"))

    @pytest.mark.parametrize("name", ["../../etc/passwd", "", "A" * 64, "a" * 63, "a" * 65, f"{'a' * 64}\n"])
    def test_only_digests_become_paths(self, blobs, name):
        for owner, wrong in ((ME, name), (name or "/", digest(b"x"))):
            with pytest.raises(FileNotFoundError):
                blobs.put(owner, wrong, b"x")
        assert blobs.read(ME, name) is None
        assert not blobs.drop(ME, name)
        assert blobs.usage() == (0, 0)

    @pytest.mark.parametrize("other", [ME, YOU])
    def test_what_is_dropped_while_it_is_uploaded_again_is_kept(self, blobs, monkeypatch, other):
        """By another worker, between the look at what is there and the link to it: the folder is not gone."""
        blobs.put(other, digest(b"x"), b"x")
        look = BlobStore._blobs

        def looked(self):
            found = look(self)
            self.drop(other, digest(b"x"))
            return found

        with monkeypatch.context() as patch:
            patch.setattr(BlobStore, "_blobs", looked)
            assert blobs.put(ME, digest(b"x"), b"x")
        blobs.put(ME, digest(b"x"), b"x")
        assert bytes(blobs.read(ME, digest(b"x"))) == b"x"

    def test_owners_of_the_same_share_it_and_neither_takes_it_from_the_other(self, blobs):
        body = b"x" * 900
        assert blobs.put(ME, digest(body), body)
        assert blobs.put(YOU, digest(body), body)
        assert blobs.usage() == (1, 900)
        assert blobs.drop(ME, digest(body))
        assert not blobs.drop(ME, digest(body))
        assert blobs.has(YOU, digest(body))

    def test_what_was_used_longest_ago_makes_room(self, blobs):
        bodies = [bytes([number]) * 10 for number in range(4)]
        for body in bodies[:3]:
            blobs.put(ME, digest(body), body)
        blobs.use(ME, digest(bodies[0]))
        blobs.put(ME, digest(bodies[3]), bodies[3])
        assert [blobs.has(ME, digest(body)) for body in bodies] == [True, False, True, True]

    def test_when_all_is_full_whoever_has_most_makes_room(self, blobs):
        mine, yours, more = b"m" * 900, b"y" * 500, b"z" * 400
        blobs.put(ME, digest(mine), mine)
        blobs.put(YOU, digest(yours), yours)
        blobs.put(YOU, digest(more), more)
        assert not blobs.has(ME, digest(mine))
        assert blobs.usage() == (2, 900)

    def test_a_full_disk_is_a_smaller_bound(self, tmp_path, monkeypatch):
        blobs = BlobStore(tmp_path / "blobs", Bounds(100, 2**20, 2**20))
        write = Path.write_bytes

        def write_if_it_fits(path, body):
            if blobs.usage()[1] + len(body) > 3000:
                raise OSError(errno.ENOSPC, "full")
            return write(path, body)

        monkeypatch.setattr(Path, "write_bytes", write_if_it_fits)
        bodies = [bytes([number]) * 900 for number in range(3)]
        assert all(blobs.put(ME, digest(body), body) for body in bodies)
        assert blobs.put(YOU, digest(b"y" * 1500), b"y" * 1500)
        assert [blobs.has(ME, digest(body)) for body in bodies] == [False, False, True]
        assert not blobs.put(YOU, digest(b"y" * 4000), b"y" * 4000)

    def test_what_is_mapped_outlives_being_dropped(self, blobs):
        blobs.put(ME, digest(b"abc"), b"abc")
        content = blobs.read(ME, digest(b"abc"))
        blobs.drop(ME, digest(b"abc"))
        assert bytes(content) == b"abc"

    def test_many_at_once(self, blobs):
        bodies = [bytes([number]) * 100 for number in range(30)]
        threads = [threading.Thread(target=blobs.put, args=(ME, digest(body), body)) for body in bodies]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert blobs.usage() == (3, 300)


class TestUploads:
    def test_a_grid_is_known_to_every_worker(self, tmp_path):
        one, other = (GridStore(Settings(), tmp_path) for _ in range(2))
        body = grid(1.0)
        assert one.put(ME, digest(body), body)[1]
        assert not other.put(YOU, digest(body), body)[1]
        frequencies = other.get(YOU, digest(body))
        assert frequencies.tobytes() == body
        assert not frequencies.flags.writeable
        assert other.get(ME, digest(body)) is frequencies
        assert (len(other), other.stored_bytes) == (1, 400)

    def test_one_that_another_worker_dropped_is_gone(self, tmp_path):
        one, other = (GridStore(Settings(max_grids=2), tmp_path) for _ in range(2))
        bodies = [grid(start) for start in (1.0, 2.0, 3.0)]
        one.put(ME, digest(bodies[0]), bodies[0])
        one.get(ME, digest(bodies[0]))
        for body in bodies[1:]:
            other.put(ME, digest(body), body)
        with pytest.raises(GridUnknown):
            one.get(ME, digest(bodies[0]))

    @pytest.mark.parametrize("wrong", [grid(9.0), b"short", b""])
    def test_a_file_that_is_not_what_its_name_says_is_refused_and_removed(self, tmp_path, wrong):
        (one, other), body = (GridStore(Settings(), tmp_path) for _ in range(2)), grid(1.0)
        one.put(ME, digest(body), body)
        (tmp_path / "grids" / "everybody" / digest(body)).write_bytes(wrong)
        with pytest.raises(GridUnknown):
            other.get(ME, digest(body))
        assert not one.has(ME, digest(body))

    def test_an_analysis_is_known_to_every_worker_for_its_owner_alone(self, tmp_path):
        analysis = small_analysis(seed=1)
        body, name = b"".join(encode_analysis(analysis)), name_of(analysis)
        one, other = (AnalysisStore(Settings(), tmp_path) for _ in range(2))
        assert one.put(ME, name, body)[1]
        assert other.bytes_to_read(ME, name) == len(body)
        assert other.get(ME, name).analysis.digest == analysis.digest
        assert other.bytes_to_read(ME, name) == 0
        with pytest.raises(AnalysisUnknown):
            other.get(YOU, name)
        assert not other.put(ME, name, body)[1]
        one.drop(ME, name)
        other.tidy()
        for worker in (one, other):
            with pytest.raises(AnalysisUnknown):
                worker.get(ME, name)
            with pytest.raises(AnalysisUnknown):
                worker.drop(ME, name)
            assert (len(worker), worker.stored_bytes) == (0, 0)

    def test_a_damaged_analysis_is_unknown(self, tmp_path):
        analysis = small_analysis(seed=1)
        body, name = b"".join(encode_analysis(analysis)), name_of(analysis)
        one, other = (AnalysisStore(Settings(), tmp_path) for _ in range(2))
        one.put("", name, body)
        damaged = bytearray(body)
        damaged[-9] ^= 1
        (tmp_path / "analyses" / "everybody" / name).write_bytes(damaged)
        with pytest.raises(AnalysisUnknown):
            other.get("", name)


class Process:
    """The metrics of one worker process."""

    def __init__(self, folder, place):
        self.registry = CollectorRegistry()
        self.rows = Counter("rows", "Rows", ["model"], registry=self.registry)
        self.queue = Gauge("queue", "Queue", registry=self.registry)
        self.known = Gauge("known", "Known", registry=self.registry)
        self.shared = SharedMetrics(folder, place)

    def publish(self):
        self.shared.publish(self.registry.collect())

    def told(self):
        metrics = self.shared.merged(largest=["known"])
        return {(sample.name, *sample.labels.values()): sample.value for metric in metrics for sample in metric.samples}


class TestMetrics:
    def test_counters_and_gauges_add_up_and_what_is_common_does_not(self, tmp_path):
        one, other = Process(tmp_path, 0), Process(tmp_path, 1)
        one.rows.labels("a").inc(2)
        other.rows.labels("a").inc(3)
        other.rows.labels("b").inc(5)
        for number, process in enumerate((one, other)):
            process.queue.set(10 + number)
            process.known.set(7)
            process.publish()
        expected = {("rows_total", "a"): 5.0, ("rows_total", "b"): 5.0, ("queue",): 21.0, ("known",): 7.0}
        assert one.told() == other.told() == expected

    def test_whoever_takes_the_place_of_a_dead_one_goes_on_counting(self, tmp_path):
        for _ in range(3):
            process = Process(tmp_path, 0)
            process.rows.labels("a").inc(2)
            process.queue.set(4)
            process.publish()
            process.publish()
        newcomer = Process(tmp_path, 0)
        newcomer.publish()
        assert newcomer.told() == {("rows_total", "a"): 6.0, ("queue",): 0.0, ("known",): 0.0}

    def test_of_a_dead_one_the_counters_stay_and_the_gauges_go(self, tmp_path):
        (tmp_path / "supervisor.json").write_text('{"places": [1], "families": []}')
        gone, here = Process(tmp_path, 0), Process(tmp_path, 1)
        for process in (gone, here):
            process.rows.labels("a").inc()
            process.queue.set(1)
            process.publish()
        assert here.told() == {("rows_total", "a"): 2.0, ("queue",): 1.0, ("known",): 0.0}

    def test_what_is_not_whole_is_left_out(self, tmp_path):
        process = Process(tmp_path, 0)
        process.publish()
        (tmp_path / "metrics-1.json").write_text('{"families": [')
        assert process.told() == {("queue",): 0.0, ("known",): 0.0}


def test_the_least_busy_worker_is_found(tmp_path):
    loads = SharedLoads(tmp_path, places=3)
    assert loads.least() == 0
    other = SharedLoads(tmp_path)
    loads.say(0, 5)
    other.say(2, 3)
    assert loads.least() == other.least() == 3
    other.leave(2)
    assert loads.least() == 5
    loads.close()
    other.close()


class TestWithoutIt:
    """Somebody has removed what the workers share, as systemd does when a user logs out."""

    @pytest.fixture(params=[{}, {"tokens": [Token.of("a token of a sampler", max_stored_bytes=10_000)]}])
    def worker(self, request, tmp_path):
        folder = tmp_path / "shared"
        folder.mkdir()
        settings = Settings(**(SMALL_LIMITS | request.param))
        source = MemorySource().add(ChirpModel())
        with BackgroundServer(settings, source=source, factory=as_it_is, shared=folder) as server:
            yield server, folder, {"authorization": "Bearer a token of a sampler"}

    def test_a_worker_is_unready_and_asks_to_be_asked_again(self, worker):
        server, folder, token = worker
        body = grid(30.0)
        path, by_digest = f"/v1/grids/{digest(body)}", question(grid={"sha256": digest(body)})
        assert ask(server.address, "PUT", path, body, **token).status == 201
        assert evaluate(server.address, by_digest, **token).status == 200
        shutil.rmtree(folder)
        for answer in (
            ask(server.address, "GET", "/v2/health/ready"),
            ask(server.address, "PUT", path, body, **token),
            ask(server.address, "HEAD", path, **token),
            evaluate(server.address, by_digest, **token),
        ):
            assert (answer.status, answer.headers["retry-after"]) == (503, "1")
        assert evaluate(server.address, question(), **token).status == 200
        assert b"bnserve_ready 0.0" in server.app.parts.metrics.exposition()

    def test_a_part_of_it_is_made_again(self, worker):
        server, folder, token = worker
        body = grid(30.0)
        shutil.rmtree(folder / "grids")
        assert ask(server.address, "PUT", f"/v1/grids/{digest(body)}", body, **token).status == 201
        assert ask(server.address, "GET", "/v2/health/ready").status == 200


def test_uploads_while_they_are_dropped_are_answered_as_uploads(tmp_path):
    """By threads that are all as fast as they can: an upload that somebody drops at once was here."""
    settings = Settings(**SMALL_LIMITS)
    body, failures = grid(20.0), []
    stores = [GridStore(settings, tmp_path) for _ in range(2)]

    def upload(store):
        try:
            for _ in range(300):
                found, _ = store.put("", digest(body), body)
                assert len(found) == 50
        except Exception as error:
            failures.append(error)

    def drop(store):
        for _ in range(900):
            store.discard("", digest(body))

    threads = [threading.Thread(target=work, args=(store,)) for store in stores for work in (upload, drop)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert failures == []
