"""Files are written whole or not at all."""

import pytest

from bnserve_store import replacing


def test_a_file_appears_whole(tmp_path):
    path = tmp_path / "numbers"
    path.write_text("old")
    with replacing(path) as temporary:
        temporary.write_text("new")
        assert path.read_text() == "old"
    assert path.read_text() == "new"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("written", [True, False])
def test_what_fails_leaves_what_was_there(tmp_path, written):
    path = tmp_path / "numbers"
    path.write_text("old")
    with pytest.raises(KeyboardInterrupt), replacing(path) as temporary:  # noqa: PT012  (the block is what is tested)
        if written:
            temporary.write_text("half")
        raise KeyboardInterrupt
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_what_is_not_written_replaces_nothing(tmp_path):
    path = tmp_path / "numbers"
    path.write_text("old")
    with pytest.raises(FileNotFoundError), replacing(path):
        pass
    assert path.read_text() == "old"


def test_two_writers_do_not_meet(tmp_path):
    path = tmp_path / "numbers"
    with replacing(path) as first, replacing(path) as second:
        first.write_text("first")
        second.write_text("second")
    assert path.read_text() == "first"
