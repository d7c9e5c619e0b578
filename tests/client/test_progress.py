"""A progress bar for batches of several chunks."""

import sys

import numpy as np
import pytest

from bnserve_protocol import PackageMissing
from tests.client.reference_model import binaries

FREQUENCIES = np.linspace(20.0, 1024.0, 50)


def test_it_counts_the_waveforms_of_a_large_batch(server, connect, capsys):
    connect(server.address, progress=True, chunk_samples=500).predict_batch(FREQUENCIES, binaries(40))
    assert "40.0/40.0" in capsys.readouterr().err


def test_a_batch_of_one_chunk_shows_none(server, connect, capsys):
    connect(server.address, progress=True).predict_batch(FREQUENCIES, binaries(40))
    assert capsys.readouterr().err == ""


def test_without_tqdm_the_user_is_told_what_to_do(server, connect, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    with pytest.raises(PackageMissing, match=r"pip install '\.\[progress\]'"):
        connect(server.address, progress=True)
