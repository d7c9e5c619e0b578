"""Roots behind fsspec: the same verification, read-only."""

import subprocess
import sys

import pytest

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete, InvalidRequest, ModelUnknown, StoreUnknown
from bnserve_store import ModelStore


@pytest.fixture
def bucket(store, root):
    """The store of the other tests, copied into fsspec's bucket in memory."""
    fsspec = pytest.importorskip("fsspec", reason="buckets are an extra")
    files = fsspec.filesystem("memory")
    files.put(str(root), "/models", recursive=True)
    yield files
    files.rm("/models", recursive=True)


def test_a_bucket_reads_like_a_directory(bucket, store):
    remote = ModelStore(["memory://models"])
    assert remote.names() == ["gw"]
    assert remote.versions("gw") == store.versions("gw")
    assert remote.labels("gw") == store.labels("gw")
    assert remote.verify("gw") == store.verify("gw")
    with pytest.raises(ModelUnknown):
        remote.load("other")


def test_a_bucket_is_verified_like_a_directory(bucket):
    remote = ModelStore(["memory://models"])
    path = "/models/gw/1.0.0/tensors.safetensors"
    data = bytearray(bucket.cat(path))
    data[-1] ^= 1
    bucket.pipe(path, bytes(data))
    with pytest.raises(ArtifactCorrupted, match=r"gw/1\.0\.0/tensors\.safetensors"):
        remote.load("gw")
    bucket.rm(path)
    with pytest.raises(ArtifactIncomplete, match="is missing"):
        remote.load("gw")
    with pytest.raises(StoreUnknown, match="memory://nowhere"):
        ModelStore(["memory://nowhere"]).names()
    with pytest.raises(StoreUnknown, match="nosuchprotocol://x"):
        ModelStore(["nosuchprotocol://x"])


def test_a_bucket_is_not_published_to(bucket, tensors):
    with pytest.raises(InvalidRequest, match="buckets have no atomic rename"):
        ModelStore(["memory://models"]).publish("gw", "2.0", tensors(1), {})


def test_without_fsspec_a_url_says_what_to_install(tmp_path):
    """fsspec is hidden by an empty package of that name, whatever is installed."""
    (tmp_path / "fsspec").mkdir()
    (tmp_path / "fsspec" / "__init__.py").touch()
    code = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n"
        "from bnserve_store import ModelStore\n"
        "from bnserve_protocol import StoreUnknown\n"
        "try:\n    ModelStore(['s3://x/y'])\n"
        "except StoreUnknown as error:\n    print(error.detail)\n"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "pip install '.[buckets]'" in answer.stdout


def test_importing_the_store_brings_in_nothing_heavy():
    code = "import sys, bnserve_store; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert {"fsspec", "scipy", "sklearn", "numba", "fastapi", "torch"}.isdisjoint(loaded)
    assert "bnserve_surrogate" not in loaded
