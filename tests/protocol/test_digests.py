"""Digests as RFC 9530 writes them, over any pieces of the body."""

import base64
import hashlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_protocol.wire import content_digest, request_digest


def test_the_published_check_values():
    assert content_digest([b"123456789"], "crc32c") == "crc32c=:4waSgw==:"  # 0xE3069283
    assert content_digest([b'{"hello": "world"}']) == "sha-256=:X48E9qOokqqrvdts8nOJRJN3OWDUoyWxBf7kbu9DBPE=:"
    assert request_digest(b"") == hashlib.sha256(b"").hexdigest()


@pytest.mark.parametrize("algorithm", ["crc32c", "sha-256"])
@given(st.binary(max_size=200), st.integers(0, 200))
def test_pieces_do_not_matter(algorithm, body, cut):
    assert content_digest([body[:cut], memoryview(body)[cut:]], algorithm) == content_digest([body], algorithm)


@pytest.mark.parametrize("algorithm", ["crc32c", "sha-256"])
@given(st.binary(min_size=1, max_size=200), st.data())
def test_every_flipped_bit_is_seen(algorithm, body, data):
    flipped = bytearray(body)
    flipped[data.draw(st.integers(0, len(body) - 1))] ^= 1 << data.draw(st.integers(0, 7))
    assert content_digest([bytes(flipped)], algorithm) != content_digest([body], algorithm)


def test_a_crc_is_four_bytes():
    text = content_digest([b"abc"], "crc32c")
    assert len(base64.b64decode(text.removeprefix("crc32c=:").removesuffix(":"))) == 4
