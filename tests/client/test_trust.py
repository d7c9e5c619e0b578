"""Whom a client trusts, and where its token is not to go unseen."""

import ssl
import warnings

import numpy as np
import pytest

from bnserve_client import AsyncModel, ConnectionFailed, InvalidRequest, Model, ParametersWithExtrinsic, TokenInClear
from bnserve_client._addresses import parse_addresses
from bnserve_client._session import Session
from bnserve_client._settings import Token, settings_from
from tests.certificates import certificates
from tests.client.conftest import same
from tests.client.reference_likelihood import LikelihoodReference
from tests.client.reference_model import ReferenceModel

SECRET = "correct-horse-battery-staple"
FREQUENCIES = np.linspace(20.0, 1024.0, 50)
ONE = ParametersWithExtrinsic.gw170817()
RIGHT = ReferenceModel().predict(FREQUENCIES, ONE)


@pytest.fixture
def made(tmp_path):
    return certificates(tmp_path)


@pytest.fixture
def address(start_server, made):
    server = start_server()
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(made.chain, made.key)
    server._server.socket = context.wrap_socket(server._server.socket, server_side=True)
    return server.address.replace("http://", "https://")


@pytest.mark.parametrize("form", [str, lambda path: path], ids=["text", "path"])
def test_an_authority_of_ones_own(address, made, connect, form):
    model = connect(address, verify=form(made.trusted))
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_an_authority_of_the_environment(address, made, connect, monkeypatch):
    monkeypatch.setenv("SSL_CERT_FILE", str(made.trusted))
    assert same(connect(address).predict(FREQUENCIES, ONE), RIGHT)


def test_asynchronous_models_take_it_too(address, made):
    import asyncio

    async def run():
        async with await AsyncModel.connect(address, verify=made.trusted) as model:
            return await model.predict(FREQUENCIES, ONE)

    assert same(asyncio.run(run()), RIGHT)


def test_a_stranger_is_not_trusted_and_what_to_do_is_said(address, monkeypatch):
    monkeypatch.delenv("SSL_CERT_FILE", raising=False)
    with pytest.raises(ConnectionFailed, match=r"is not trusted: .*verify=\.\.\., or with SSL_CERT_FILE"):
        Model.connect(address, retries=0)


def test_whoever_asks_for_it_trusts_everybody(address, connect):
    assert same(connect(address, verify=False).predict(FREQUENCIES, ONE), RIGHT)


def test_what_can_be_no_authority(address, tmp_path):
    (tmp_path / "empty.pem").write_text("")
    for given in (3, tmp_path / "nowhere.pem", tmp_path / "empty.pem"):
        with pytest.raises(InvalidRequest, match="verify"):
            Model.connect(address, verify=given, retries=0)


def warned(address, token=SECRET):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        session = Session(settings_from(address, False, token=Token(token)))
        for _ in range(2):
            session._token_headers()
    return [str(warning.message) for warning in caught if warning.category is TokenInClear]


@pytest.mark.parametrize("address", ["http://bnserve.example.org:8000", "http://10.0.0.1:8000", "http://[fe80::1]:80"])
def test_a_token_in_clear_to_another_machine_is_warned_of_once(address):
    [text] = warned(address)
    assert address in text
    assert "https://" in text
    assert SECRET not in text


@pytest.mark.parametrize(
    "address",
    ["http://localhost:8000", "http://127.0.0.2:80", "http://[::1]:80", "https://bnserve.example.org", "unix:/run/bn"],
)
def test_no_warning_where_nobody_can_listen(address):
    assert warned(address) == []


def test_no_warning_without_a_token(monkeypatch):
    for name in ("BNSERVE_TOKEN", "BNSERVE_TOKEN_FILE"):
        monkeypatch.delenv(name, raising=False)
    assert warned("http://bnserve.example.org:8000", None) == []


def test_every_address_counts():
    [text] = warned("https://one.example.org,http://two.example.org")
    assert "two.example.org" in text
    assert "one.example.org" not in text
    assert len(parse_addresses("https://one.example.org,http://two.example.org")) == 2


def test_a_token_that_is_replaced_in_its_file_is_taken_without_a_failure(start_server, connect, tmp_path):
    file, service = tmp_path / "token", LikelihoodReference(token="the first token")
    file.write_text("the first token")
    model = connect(start_server(service).address, token=file)
    for number in range(3):
        service.token = f"token number {number}"
        file.write_text(service.token)
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)


def test_the_environment_may_name_a_file(start_server, connect, tmp_path, monkeypatch):
    file, service = tmp_path / "token", LikelihoodReference(token=SECRET)
    file.write_text(f"{SECRET}\n")
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)
    monkeypatch.setenv("BNSERVE_TOKEN_FILE", str(file))
    model = connect(start_server(service).address)
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    assert str(file) in repr(model._remote.settings.token)
    service.token = SECRET[::-1]
    file.write_text(SECRET[::-1])
    assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    monkeypatch.setenv("BNSERVE_TOKEN", "counts more than the file")
    with pytest.raises(Exception, match="token"):
        connect(start_server(LikelihoodReference(token=SECRET)).address)
