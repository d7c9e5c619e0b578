"""Addresses: what is one, and what is said about everything else."""

import numpy as np
import pytest

from bnserve_client import BnserveError, InvalidRequest, Model, ModelUnknown
from bnserve_client._addresses import parse_addresses

GOOD = {
    "http://host": "http://host",
    "http://host:8000/prefix/": "http://host:8000/prefix",
    "https://my_service.internal.": "https://my_service.internal.",
    "http://[::1]:8000": "http://[::1]:8000",
    "http://[fe80::1%eth0]": "http://[fe80::1%eth0]",
    "http://bücher.example": "http://xn--bcher-kva.example",
    "http://a。b": "http://a.b",  # as browsers read it
    "unix:/run/ü.sock": "http://localhost",
}


@pytest.mark.parametrize(("text", "url"), GOOD.items())
def test_an_address_is_sent_in_ascii(text, url):
    [address] = parse_addresses(text)
    assert (address.base_url, address.text) == (url, text)


@pytest.mark.parametrize("several", ["http://a,http://b", ["http://a", "http://b"], np.array(["http://a", "http://b"])])
def test_several_addresses_in_every_form(several):
    assert [address.host for address in parse_addresses(several)] == ["a", "b"]


BAD = {
    "an empty label": ("http://a..b", "'a..b' in the address 'http://a..b' is not the name of a host"),
    "nothing but a dot": ("http://.", "is not the name of a host"),
    "a label that is too long": (f"http://{'a' * 64}.example", "is not the name of a host"),
    "a space in the name": ("http://a b", "is not the name of a host"),
    "half a pair": ("http://\ud800", r"'\ud800' in the address"),
    "a name that is coded twice": ("http://xn--zz-ü", "is not the name of a host"),
    "an escape": ("http://host\x1b]0;x", r"\x1b"),
    "a path that is not ASCII": ("http://host/ü", "must be percent-encoded ASCII"),
    "a path with a space": ("http://host/a b", "must be percent-encoded ASCII"),
    "a path with an escape": ("http://host/\x1b[31m", "must be percent-encoded ASCII"),
    "a socket with a null": ("unix:/run/\0", "is written 'unix:/path/to/socket'"),
    "bytes": (b"http://host", "An address is a string"),
    "nothing": (None, "An address is a string"),
    "a list of other things": (["http://host", 8000], "An address is a string"),
}


@pytest.mark.parametrize(("text", "says"), BAD.values(), ids=BAD)
def test_anything_else_is_an_error_that_says_so(text, says):
    with pytest.raises(InvalidRequest) as raised:
        Model.connect(text)
    assert says in raised.value.detail
    assert raised.value.detail.isprintable()


@pytest.mark.parametrize("text", ["http://256.256.256.256", "http://[::ffff]:1", "http://%00", f"unix:/{'x' * 300}"])
def test_an_address_of_nobody_is_no_answer(text):
    """Never an error that is none of ours."""
    with pytest.raises(BnserveError):
        Model.connect(text, retries=0, timeout=2.0)


@pytest.mark.parametrize("name", ["", None, 7, "\ud800", "a\nb", b"default"])
def test_a_name_that_is_none_is_an_unknown_model(server, name):
    with pytest.raises(ModelUnknown, match="A model has a name and a version"):
        Model.connect(server.address, name)
    with pytest.raises(ModelUnknown, match="A model has a name and a version"):
        Model.connect(server.address, version=name)
