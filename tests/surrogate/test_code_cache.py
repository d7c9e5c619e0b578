"""Machine code that was made before is used again if it is whole, ours and for the same question."""

import os
import stat
import threading

import pytest

from bnserve_surrogate.kernel._loader import _MOST_FILES, cache_folder, cached_code
from tests.architecture.rooms import run_python

CODE = b"machine code" * 100


@pytest.fixture
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "caches"))
    return tmp_path / "caches" / "bnserve"


class Compiler:
    def __init__(self, code=CODE):
        self.code, self.calls = code, 0

    def __call__(self):
        self.calls += 1
        return self.code


def only_file(cache):
    [file] = cache.iterdir()
    return file


def test_code_is_made_once_for_each_key(cache):
    compiler = Compiler()
    assert [cached_code(key, compiler) for key in (b"a", b"b", b"a", b"b")] == [CODE] * 4
    assert compiler.calls == 2


def test_nobody_else_may_write_what_is_kept(cache):
    cached_code(b"key", Compiler())
    assert stat.S_IMODE(cache.stat().st_mode) == 0o700
    assert stat.S_IMODE(only_file(cache).stat().st_mode) == 0o600


def cut(file):
    file.write_bytes(file.read_bytes()[:-1])


def flip(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


def empty(file):
    file.write_bytes(b"")


def open_to_all(file):
    file.chmod(0o666)


def belonging_to_another(file):
    os.chown(file, 12345, 12345)


def link(file):
    file.rename(file.with_suffix(".elsewhere"))
    file.symlink_to(file.with_suffix(".elsewhere"))


def pipe(file):
    file.unlink()
    os.mkfifo(file)


@pytest.mark.parametrize("damage", [cut, flip, empty, open_to_all, belonging_to_another, link, pipe])
def test_what_cannot_be_trusted_is_made_again(cache, damage):
    if damage is belonging_to_another and os.geteuid() != 0:
        pytest.skip("only root can give a file away")
    cached_code(b"key", Compiler())
    damage(only_file(cache))
    compiler = Compiler()
    assert cached_code(b"key", compiler) == CODE
    assert compiler.calls == 1
    assert cached_code(b"key", compiler) == CODE
    assert compiler.calls == 1


def test_code_of_another_key_is_not_taken_for_ours(cache):
    cached_code(b"theirs", Compiler(b"theirs"))
    file = only_file(cache)
    cached_code(b"ours", Compiler())
    for other in cache.iterdir():
        if other != file:
            file.replace(other)
    assert cached_code(b"ours", Compiler()) == CODE


def test_old_code_goes(cache):
    for number in range(_MOST_FILES + 12):
        cached_code(b"%d" % number, Compiler())
        os.utime(max(cache.iterdir(), key=lambda file: file.stat().st_ctime_ns), (number, number))
    assert len(list(cache.iterdir())) == _MOST_FILES
    compiler = Compiler()
    cached_code(b"%d" % (_MOST_FILES + 11), compiler)
    assert compiler.calls == 0


def test_without_a_place_for_it_code_is_made_every_time(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    compiler = Compiler()
    assert [cached_code(b"key", compiler) for _ in range(2)] == [CODE] * 2
    assert compiler.calls == 2


def test_a_user_without_a_home_has_no_cache(monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", "")
    monkeypatch.delenv("HOME", raising=False)
    monkeypatch.setattr("pwd.getpwuid", lambda uid: (_ for _ in ()).throw(KeyError(uid)))
    assert cache_folder() is None
    assert cached_code(b"key", Compiler()) == CODE


def test_relative_paths_count_as_not_given(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", "caches")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cache_folder() == tmp_path / ".cache" / "bnserve"


def test_a_failed_compilation_leaves_nothing(cache):
    def fail():
        raise ValueError("no such processor")

    with pytest.raises(ValueError, match="no such processor"):
        cached_code(b"key", fail)
    assert not cache.exists()


def test_many_at_once_agree(cache):
    results = []
    threads = [threading.Thread(target=lambda: results.append(cached_code(b"key", Compiler()))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == [CODE] * 8
    assert only_file(cache).suffix == ".o"


WAVEFORM = """
import hashlib
import numpy as np
from bnserve_surrogate import Model, ParametersWithExtrinsic
import bnserve_surrogate.kernel._loader as loader

compiled = []
compile = loader._compile
loader._compile = lambda *arguments: compiled.append(1) or compile(*arguments)
plus, cross = Model.default().predict(np.linspace(20.0, 2048.0, 3000), ParametersWithExtrinsic.gw170817())
print(len(compiled), hashlib.sha256(plus.tobytes() + cross.tobytes()).hexdigest())
"""


def test_kept_code_gives_the_bits_of_fresh_code(cache):
    (first, fresh), (second, kept) = (run_python(WAVEFORM).split() for _ in range(2))
    assert (first, second) == ("1", "0")
    assert fresh == kept
