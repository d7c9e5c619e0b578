"""Tokens that others issue: who is let in, what he may do, and what happens when their issuer is not there."""

import base64
import json
import logging

import jwt
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_service import Settings, Token
from bnserve_service.admission import issuer_keys
from bnserve_service.admission.issuers import Issuer
from bnserve_service.settings import load_settings
from tests.certificates import certificates
from tests.issuer import AUDIENCE, TestIssuer
from tests.service.asking import ask, evaluate, question
from tests.service.chirp import ChirpModel, QuickChirpModel, until

SECRET = "a token of the settings"


@pytest.fixture(autouse=True)
def soon(monkeypatch):
    """What is fetched again is fetched at once."""
    monkeypatch.setattr(issuer_keys, "_AGAIN", 0.0)


@pytest.fixture
def issuer():
    with TestIssuer().serving() as it:
        yield it


@pytest.fixture(params=[ChirpModel, QuickChirpModel], ids=["in threads", "fast path"])
def model(request):
    return request.param()


@pytest.fixture
def serving(start, issuer, model):
    """A server that knows the issuer, with its keys."""

    def serve(tokens=(), model=model, **options):
        trusted = Issuer(issuer=issuer.url, audience=(AUDIENCE,), **options)
        server = start(model, issuers=(trusted,), tokens=tokens)
        until(lambda: status(server, issuer.sign()) in (200, 401, 403), "it has the keys")
        return server

    return serve


def bearer(text):
    return {"authorization": f"Bearer {text}"}


def asked(server, text):
    for _ in range(2):  # the second is for the fast path
        answer = evaluate(server.address, question(), **bearer(text))
    return answer


def status(server, text):
    return asked(server, text).status


def test_who_has_a_token_of_the_issuer_is_let_in_and_does_what_its_scopes_say(serving, issuer):
    server = serving()
    assert status(server, issuer.sign()) == 200
    reads = issuer.sign("prometheus", scope="bnserve.metrics")
    assert ask(server.address, "GET", "/metrics", **bearer(reads)).status == 200
    assert status(server, reads) == 403
    assert ask(server.address, "POST", "/v1/reload", **bearer(reads)).status == 403
    runs = issuer.sign("operator", scope=None, scp=["bnserve.admin"])
    assert ask(server.address, "POST", "/v1/reload", **bearer(runs)).status == 200
    none = issuer.sign("nobody", scope="openid profile")
    assert ask(server.address, "GET", "/v1/models", **bearer(none)).status == 200
    assert status(server, none) == 403


def test_a_key_of_an_elliptic_curve(serving, issuer):
    issuer.add("curve", "EC")
    assert status(serving(), issuer.sign()) == 200


def test_tokens_of_the_settings_count_beside_them(serving, issuer):
    server = serving(tokens=(Token.of(SECRET),))
    assert [status(server, text) for text in (SECRET, issuer.sign(), "neither of them")] == [200, 200, 401]


WRONG = {
    "ended": (lambda it: it.sign(seconds=-60.0), "has ended"),
    "not yet": (lambda it: it.sign(nbf=2**33), "not valid: ImmatureSignatureError"),
    "for another": (lambda it: it.sign(aud="https://other.example.org"), f"not for this server, which is '{AUDIENCE}'"),
    "for any": (lambda it: it.sign(aud="ANY"), "not for this server"),
    "for nobody": (lambda it: it.sign(aud=None), "not valid: MissingRequiredClaimError"),
    "for ever": (lambda it: it.sign(exp=None), "not valid: MissingRequiredClaimError"),
    "of nobody": (lambda it: it.sign(sub=None), "not valid: MissingRequiredClaimError"),
    "of another issuer": (lambda it: it.sign(iss="https://evil.example.org"), "needs a token"),
    "signed by another": (lambda it: TestIssuer().sign(iss=it.url), "InvalidSignatureError"),
    "signed with the public key": (lambda it: shared_key(it), "not valid: "),
    "not signed": (lambda it: unsigned(it), "not valid: "),
    "changed": (lambda it: changed(it), "InvalidSignatureError"),
}


def shared_key(issuer):
    """What a verifier takes that lets the token choose the algorithm."""
    return issuer.sign(secret="the public key, which everybody knows", algorithm="HS256")


def unsigned(issuer):
    return ".".join([part(head(issuer.sign()) | {"alg": "none"}), issuer.sign().split(".")[1], ""])


def changed(issuer):
    first, claims, signature = issuer.sign().split(".")
    told = json.loads(base64.urlsafe_b64decode(claims + "=="))
    return ".".join([first, part(told | {"scope": "bnserve.evaluate bnserve.admin"}), signature])


def head(text):
    return jwt.get_unverified_header(text)


def part(told):
    return base64.urlsafe_b64encode(json.dumps(told).encode()).decode().rstrip("=")


def test_a_token_that_is_wrong_is_refused_with_the_reason(serving, issuer):
    server = serving(model=ChirpModel())
    for name, (make, says) in WRONG.items():
        answer = asked(server, make(issuer))
        assert (name, answer.status, answer.code) == (name, 401, "unauthorized")
        assert says in answer.document["detail"], name
    assert status(server, issuer.sign()) == 200


def test_what_looks_like_one_and_is_none(serving):
    server = serving(model=ChirpModel())
    for text in ("a.b.c", "...", "eyJhbGciOiJSUzI1NiJ9.e30.x", "x" * 5000, "\u00e9.b.c".encode().decode("latin-1")):
        assert status(server, text) == 401, text


SCITOKEN = {"ver": "scitoken:2.0", "scope": "bnserve.evaluate:/ gwdata.read:/frames"}


def test_scitokens_may_be_for_any_audience_and_have_paths(serving, issuer):
    server = serving(profile="scitokens", scopes={"bnserve.evaluate": ["evaluate"], "gwdata.read": ["upload"]})
    assert status(server, issuer.sign(**SCITOKEN)) == 200
    assert status(server, issuer.sign(**SCITOKEN, aud="ANY")) == 200
    assert status(server, issuer.sign(**SCITOKEN, aud=["https://other.example.org", AUDIENCE])) == 200
    wlcg = {"wlcg.ver": "1.0", "scope": "bnserve.evaluate", "aud": "https://wlcg.cern.ch/jwt/v1/any"}
    assert status(server, issuer.sign(**wlcg)) == 200
    assert status(server, issuer.sign(**SCITOKEN, aud="https://other.example.org")) == 401
    plain = asked(server, issuer.sign())
    assert (plain.status, "it has neither" in plain.document["detail"]) == (401, True)
    part_of_it = issuer.sign(**SCITOKEN | {"scope": "bnserve.evaluate:/some"})
    assert status(server, part_of_it) == 403, "there are no parts"
    assert ask(server.address, "PUT", f"/v1/grids/{'0' * 64}", b"", **bearer(issuer.sign(**SCITOKEN))).status == 403


def test_a_new_key_is_fetched_when_a_token_has_it_and_an_old_one_ends(serving, issuer, monkeypatch):
    server = serving()
    old = issuer.sign()
    assert status(server, old) == 200
    issuer.add("second")
    new = issuer.sign()
    answer = evaluate(server.address, question(), **bearer(new))
    assert (answer.status, "retry-after" in answer.headers) == (503, True), "our client asks again"
    until(lambda: status(server, new) == 200, "the key is there")
    assert status(server, old) == 200
    del issuer.keys["first"]
    issuer.add("third")
    until(lambda: status(server, issuer.sign()) == 200, "the key is there")
    monkeypatch.setattr(issuer_keys, "_AGAIN", 1000.0)  # or it might be a newer one still
    assert status(server, old) == 401, "also if it was verified before"


def test_keys_that_nobody_has_are_not_asked_for_again_and_again(serving, issuer, monkeypatch):
    server = serving(model=ChirpModel())
    monkeypatch.setattr(issuer_keys, "_AGAIN", 1000.0)
    asked_before = len(issuer.asked)
    assert {status(server, issuer.sign(kid=f"invented {number}")) for number in range(5)} == {401}
    assert len(issuer.asked) == asked_before


def test_when_the_issuer_is_down_its_last_keys_count_for_the_time_that_is_set(start, caplog):
    with TestIssuer().serving() as issuer:
        trusted = Issuer(issuer=issuer.url, audience=(AUDIENCE,), refresh_seconds=1.0, keys_seconds=6.0)
        server = start(QuickChirpModel(), issuers=(trusted,))
        until(lambda: status(server, issuer.sign()) == 200, "it has the keys")
    until(lambda: "cannot be fetched" in caplog.text, "it is told")
    assert status(server, issuer.sign()) == 200
    until(lambda: status(server, issuer.sign()) == 503, "the time is over")
    with issuer.serving(int(issuer.url.rpartition(":")[2])):
        until(lambda: status(server, issuer.sign()) == 200, "it is back")


def test_a_server_starts_without_its_issuer(start):
    issuer = TestIssuer()
    with issuer.serving():
        port = int(issuer.url.rpartition(":")[2])
    server = start(ChirpModel(), issuers=(Issuer(issuer=issuer.url, audience=(AUDIENCE,)),))
    assert asked(server, issuer.sign()).status == 503
    with issuer.serving(port):
        until(lambda: status(server, issuer.sign()) == 200, "it has the keys")


def test_an_issuer_that_says_it_is_another_is_not_believed(start, issuer, caplog):
    issuer.documents["/.well-known/openid-configuration"] = {
        "issuer": "https://x.org",
        "jwks_uri": f"{issuer.url}/keys",
    }
    server = start(ChirpModel(), issuers=(Issuer(issuer=issuer.url, audience=(AUDIENCE,)),))
    until(lambda: "it says that it is another issuer" in caplog.text, "it is told")
    assert status(server, issuer.sign()) == 503


def test_nobody_is_asked_but_whom_the_settings_name(start, issuer, caplog):
    issuer.documents["/.well-known/openid-configuration"] = {
        "issuer": issuer.url, "jwks_uri": "http://169.254.169.254/latest"
    }  # fmt: skip
    start(ChirpModel(), issuers=(Issuer(issuer=issuer.url, audience=(AUDIENCE,)),))
    until(lambda: "is no address of an issuer" in caplog.text, "it is told")
    for wrong in ("http://issuer.example.org", "issuer.example.org", "file:///etc/passwd"):
        with pytest.raises(ValueError, match="is no address of an issuer"):
            Issuer(issuer=wrong, audience=("x",))


def test_limits_are_those_of_each_caller_however_often_his_token_is_issued(serving, issuer):
    server = serving(rows_per_day=4, model=QuickChirpModel())  # one row is for finding out that it has the keys
    for number in range(2):
        evaluate(server.address, question(), **bearer(issuer.sign("bob", jti=str(number))))
        evaluate(server.address, question(), **bearer(issuer.sign("bob", jti=f"{number} again")))
    refused = asked(server, issuer.sign("bob", jti="last"))
    assert (refused.status, refused.code) == (429, "share-exceeded")
    assert refused.headers["ratelimit"].startswith('"day";r=0;')
    assert status(server, issuer.sign("carol")) == 200


def test_the_log_names_the_caller_and_shows_no_token(start, issuer, caplog):
    caplog.set_level(logging.INFO)
    server = start(ChirpModel(), issuers=(Issuer(issuer=issuer.url, audience=(AUDIENCE,)),), access_log=True)
    text = issuer.sign("alice\nINFO forged")
    until(lambda: status(server, text) == 200, "it has the keys")
    until(lambda: "caller=alice?INFO?forged@127.0.0.1" in caplog.text, "it is written")
    assert text not in caplog.text
    assert text.split(".")[2] not in caplog.text


def test_our_client_takes_its_token_from_a_file_that_is_renewed(serving, issuer, tmp_path):
    server, file = serving(model=QuickChirpModel()), tmp_path / "bearer"
    file.write_text(issuer.sign(seconds=-29.0))  # it counts for a second: clocks may differ by 30
    with Model.connect(server.address, "chirp", token=file) as model:
        first = model.predict([20.0, 30.0], one()).plus.tobytes()
        until(lambda: status(server, file.read_text()) == 401, "it has ended")
        file.write_text(issuer.sign())
        assert model.predict([20.0, 30.0], one()).plus.tobytes() == first


def one():
    return ParametersWithExtrinsic.gw170817()


def test_settings_in_a_file(tmp_path, issuer):
    made = certificates(tmp_path)
    path = tmp_path / "bnserve.toml"
    path.write_text(f"""
[[issuers]]
issuer = "https://cilogon.org/igwn"
audience = ["{AUDIENCE}"]
profile = "scitokens"
ca_file = "{made.trusted}"
[issuers.scopes]
"gwdata.read" = ["evaluate", "upload"]
""")
    [found] = load_settings(path).issuers
    assert found.scopes == {"gwdata.read": ("evaluate", "upload")}
    assert load_settings(path).asks_for_tokens
    assert Settings.model_validate_json(load_settings(path).model_dump_json()) == load_settings(path)
