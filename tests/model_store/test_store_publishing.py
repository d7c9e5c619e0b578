"""A version appears whole and at once, or not at all: whoever else publishes, dies, or fills the disk."""

import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from bnserve_protocol import ArtifactCorrupted, BnserveError, InvalidRequest, VersionExists
from bnserve_store import ModelStore

PUBLISHER = Path(__file__).with_name("publisher.py")


def publisher(*arguments, **options):
    command = [*options.pop("prefix", ()), sys.executable, str(PUBLISHER), *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def contents(root):
    """Every file below a folder with its bytes, and every folder."""
    return {str(path.relative_to(root)): path.is_file() and path.read_bytes() for path in root.rglob("*")}


def test_a_published_version_never_changes(store, root, tensors):
    before = contents(root)
    with pytest.raises(VersionExists, match=r"1\.0\.0 of model 'gw' is already published.*new version"):
        store.publish("gw", "1.0.0", tensors(9), {})
    assert contents(root) == before


@pytest.mark.parametrize(
    ("name", "version", "labels", "says"),
    [
        ("gw", "1.0.0", (), "already published"),
        ("g/w", "2.0.0", (), "name of a model"),
        ("gw", "two", (), "not a version"),
        ("gw", "2.0.0", ("9",), "cannot be a label"),
    ],
)
def test_what_publishing_will_refuse_can_be_asked_before(store, root, tensors, name, version, labels, says):
    before = contents(root)
    store.check_publishable("gw", "2.0.0", ["stable"])
    for ask in (
        lambda: store.check_publishable(name, version, labels),
        lambda: store.publish(name, version, tensors(9), {}, labels=labels),
    ):
        with pytest.raises(BnserveError, match=says):
            ask()
    assert contents(root) == before


def test_a_version_of_another_root_is_taken_too(store, root, tmp_path, tensors):
    with pytest.raises(VersionExists):
        ModelStore([tmp_path / "mine", root]).publish("gw", "1.0.0", tensors(9), {})


def test_nothing_but_the_published_files_remains(store, root):
    assert sorted(contents(root)) == [
        "gw",
        "gw/1.0.0",
        "gw/1.0.0/manifest.json",
        "gw/1.0.0/tensors.safetensors",
        "gw/1.1.0",
        "gw/1.1.0/manifest.json",
        "gw/1.1.0/tensors.safetensors",
        "gw/labels.json",
    ]


def test_files_for_people_appear_with_the_version_and_are_no_part_of_it(store, root, tensors):
    told = []

    def beside(manifest):
        told.append(manifest.digest)
        return {"report.html": b"<p>well"}

    plain = store.publish("gw", "2.0.0", tensors(9), {}, labels=())
    other = store.publish("other", "2.0.0", tensors(9), {}, beside=beside)
    assert told == [other.digest]
    assert (root / "other" / "2.0.0" / "report.html").read_bytes() == b"<p>well"
    assert not (root / "gw" / "2.0.0" / "report.html").exists()
    assert other.tensors == plain.tensors
    assert store.verify("other").digest == other.digest


def test_what_cannot_be_put_beside_a_version_stops_its_publishing(store, root, tensors):
    before = contents(root)

    def beside(manifest):
        raise RuntimeError("no report")

    with pytest.raises(RuntimeError, match="no report"):
        store.publish("gw", "2.0.0", tensors(9), {}, beside=beside)
    assert contents(root) == before


def test_published_files_can_be_read_by_other_users(store, root):
    assert all(path.stat().st_mode & 0o044 == 0o044 for path in root.rglob("*"))


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        ({"name": "../gw"}, "name of a model"),
        ({"name": ""}, "name of a model"),
        ({"name": "a" * 65}, "name of a model"),
        ({"version": "latest"}, "not a version"),
        ({"version": "1.0/../../x"}, "not a version"),
        ({"version": "01.0"}, "not a version"),
        ({"labels": ["1.0"]}, "cannot be a label"),
        ({"labels": ["../x"]}, "cannot be a label"),
        ({"metadata": {"x": float("nan")}}, "plain JSON"),
        ({"metadata": {"x": np.arange(3)}}, "plain JSON"),
        ({"metadata": {"x": np.int64(3)}}, "plain JSON"),
        ({"metadata": {"x": "\ud800"}}, "plain JSON"),
        ({"root": "/elsewhere"}, "not one of the roots"),
    ],
)
def test_what_cannot_be_stored_is_refused_before_anything_is_written(store, root, arguments, reason):
    before = contents(root)
    with pytest.raises(InvalidRequest, match=reason):
        store.publish(**({"name": "gw", "version": "2.0", "tensors": {}, "metadata": {}} | arguments))
    assert contents(root) == before


def test_a_time_without_a_zone_is_refused(store):
    from datetime import datetime

    with pytest.raises(InvalidRequest, match="time zone"):
        store.publish("gw", "2.0", {}, {}, created=datetime(2026, 1, 1))


def test_one_label_may_be_given_as_text(store, tensors):
    store.publish("gw", "2.0", tensors(3), {}, labels="newest")
    assert store.resolve("gw", "newest") == "2.0"


def test_the_shipped_models_are_not_written_unless_named(tensors):
    with pytest.raises(InvalidRequest, match="name a store directory"):
        ModelStore.default().publish("gw", "1.0", tensors(1), {})


def test_nothing_is_written_through_a_link_out_of_the_store(store, root, tmp_path, tensors):
    (tmp_path / "outside").mkdir()
    (root / "other").symlink_to(tmp_path / "outside")
    with pytest.raises(ArtifactCorrupted, match="leads out of the store"):
        store.publish("other", "1.0", tensors(1), {})
    assert contents(tmp_path / "outside") == {}


def test_damaged_labels_stop_the_publication_before_it_begins(store, root, tensors):
    (root / "gw" / "labels.json").write_text("{")
    with pytest.raises(ArtifactCorrupted, match=r"labels\.json"):
        store.publish("gw", "2.0", tensors(1), {})
    assert store.versions("gw") == ["1.0.0", "1.1.0"]


def test_of_many_publishers_of_one_version_one_wins(tmp_path):
    processes = [publisher(tmp_path, "1.0.0", seed) for seed in range(6)]
    answers = [process.communicate() for process in processes]
    assert sorted(out.split()[0] for out, _ in answers) == ["VersionExists"] * 5 + ["published"], answers
    winner = next(seed for seed, (out, _) in enumerate(answers) if out.startswith("published"))
    assert ModelStore([tmp_path]).load("gw").manifest.metadata == {"seed": winner}


def test_publishers_of_different_versions_lose_no_label(tmp_path):
    processes = [publisher(tmp_path, f"{seed}.0", seed, f"label-{seed}") for seed in range(6)]
    assert all(process.communicate()[0].startswith("published") for process in processes)
    expected = {f"label-{seed}": f"{seed}.0" for seed in range(6)}
    assert ModelStore([tmp_path]).labels("gw") == expected


def test_the_rename_alone_decides_even_where_locks_do_not_work(root, store, tensors, monkeypatch):
    """A version that appears between the first look and the rename is not replaced."""
    from bnserve_store import _publishing

    original = _publishing.read_artifact

    def lose_the_race(*arguments, **options):
        shutil.copytree(root / "gw" / "1.0.0", root / "gw" / "2.0")
        return original(*arguments, **options)

    monkeypatch.setattr(_publishing, "read_artifact", lose_the_race)
    with pytest.raises(VersionExists):
        store.publish("gw", "2.0", tensors(3), {})
    assert contents(root / "gw" / "2.0") == contents(root / "gw" / "1.0.0")
    assert store.labels("gw")["stable"] == "1.0.0"


def test_killed_at_any_step_nothing_half_written_is_ever_seen(store, root, tensors):
    """kill -9 before each system call that matters; the next publisher cleans up."""
    good = store.load("gw", "1.0.0").manifest
    seen, step = set(), 0
    while True:
        step += 1
        version = f"2.{step}"
        process = publisher(root, version, step, "--die-at", step)
        _, errors = process.communicate()
        assert store.load("gw", "1.0.0").manifest == good
        store.labels("gw")
        visible = version in store.versions("gw")
        if visible:
            assert store.load("gw", version).manifest.metadata == {"seed": step}
        if process.returncode == 0:
            break
        assert process.returncode == -signal.SIGKILL, errors
        seen.add(visible)
    assert seen == {False, True}
    assert step > 8
    assert not list((root / "gw").glob(".*")), "the last publisher left or overlooked temporary files"
    assert store.resolve("gw") == version


def test_an_interrupted_publication_leaves_nothing(store, root, tensors, monkeypatch):
    before = contents(root)
    from bnserve_store import _publishing

    def interrupt(*arguments, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr(_publishing, "read_artifact", interrupt)
    with pytest.raises(KeyboardInterrupt):
        store.publish("gw", "2.0", tensors(1), {})
    assert contents(root) == before


def test_what_is_not_on_the_disk_as_written_is_not_published(store, root, tensors, monkeypatch):
    from bnserve_store import _publishing

    honest = _publishing.write_durably
    monkeypatch.setattr(_publishing, "write_durably", lambda path, data: honest(path, data.replace(b"\0\0", b"\0\1")))
    before = contents(root)
    with pytest.raises(ArtifactCorrupted):
        store.publish("gw", "2.0", tensors(1), {})
    assert contents(root) == before


def _may_mount():
    probe = ["unshare", "--mount", "mount", "-t", "tmpfs", "none", "/mnt"]
    return shutil.which("unshare") is not None and subprocess.run(probe, capture_output=True).returncode == 0


@pytest.mark.skipif(not _may_mount(), reason="a small disk needs the right to mount one; the next test needs none")
def test_a_full_disk_is_said_and_nothing_is_half_written(tmp_path):
    """The child mounts a 256 KiB disk that nobody else sees, fills it, and looks at what is left."""
    mount = ("unshare", "--mount", "sh", "-c", f'mount -t tmpfs -o size=256k none {tmp_path} && exec "$0" "$@"')
    out, errors = publisher(tmp_path, "1.0.0", 1, "--then-huge", prefix=mount).communicate()
    assert "the disk is full: free some space and try again" in out, errors
    assert "before is untouched" in out
    assert (
        out.splitlines()[-1] == "left: gw gw/1.0.0 gw/1.0.0/manifest.json gw/1.0.0/tensors.safetensors gw/labels.json"
    )


def test_a_file_size_limit_is_said_and_nothing_is_half_written(tmp_path):
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

    out, errors = publisher(tmp_path, "1.0.0", 1, "--then-huge", preexec_fn=limit).communicate()
    assert "Publishing gw 9.0 failed, the file is larger than the limit on file sizes" in out, errors
    assert (
        out.splitlines()[-1] == "left: gw gw/1.0.0 gw/1.0.0/manifest.json gw/1.0.0/tensors.safetensors gw/labels.json"
    )


@contextmanager
def unprivileged():
    """Act as an ordinary user, because permissions do not stop root."""
    if os.geteuid() != 0:
        yield
        return
    os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(0)


@pytest.fixture
def read_only(tensors):
    """A store that may be read and not written."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder, "store")
        ModelStore([root]).publish("gw", "1.0.0", tensors(1), {})
        folders = [Path(folder), root, root / "gw", root / "gw" / "1.0.0"]
        for path in folders:
            path.chmod(0o555)
        yield ModelStore([root])
        for path in folders:
            path.chmod(0o755)


def test_a_read_only_store_serves_and_refuses_to_be_written(read_only, tensors):
    with unprivileged():
        assert read_only.load("gw").manifest.version == "1.0.0"
        with pytest.raises(BnserveError, match=r"Publishing gw 2\.0 failed, the store may not be written"):
            read_only.publish("gw", "2.0", tensors(2), {})
        with pytest.raises(BnserveError, match=r"Setting label 'x' of gw failed, the store may not be written"):
            read_only.set_label("gw", "x", "1.0.0")
        assert read_only.versions("gw") == ["1.0.0"]


def test_whether_a_store_can_be_written_can_be_asked_before(read_only, store, root, tmp_path):
    before = contents(root)
    store.check_publishable("gw", "2.0", room=1000)
    with pytest.raises(BnserveError, match=r"Publishing gw 2\.0 failed, the disk is full"):
        store.check_publishable("gw", "2.0", room=2**60)
    assert contents(root) == before
    ModelStore([tmp_path / "not" / "yet"]).check_publishable("gw", "2.0", room=1000)
    assert not (tmp_path / "not").exists()
    read_only.check_publishable("gw", "2.0")
    with unprivileged(), pytest.raises(BnserveError, match=r"Publishing gw 2\.0 failed, the store may not be written"):
        read_only.check_publishable("gw", "2.0", room=1)


def test_what_may_not_be_read_is_said(read_only):
    root = Path(read_only.roots[0])
    (root / "gw" / "1.0.0" / "manifest.json").chmod(0)
    with unprivileged(), pytest.raises(BnserveError, match=r"manifest\.json cannot be read \(Permission denied\)"):
        read_only.load("gw")
    root.chmod(0)
    with unprivileged(), pytest.raises(BnserveError, match="cannot be read"):
        read_only.names()


def test_a_file_in_place_of_a_folder_is_said(tmp_path, tensors):
    (tmp_path / "gw").touch()
    with pytest.raises(BnserveError, match=r"Publishing gw 1\.0 failed"):
        ModelStore([tmp_path]).publish("gw", "1.0", tensors(1), {})
    with pytest.raises(BnserveError, match=r"Publishing gw 1\.0 failed"):
        ModelStore([tmp_path / "gw" / "store"]).publish("gw", "1.0", tensors(1), {})
