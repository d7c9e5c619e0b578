"""An issuer of tokens of our own: an OpenID provider that has keys, says where they are, and signs."""

import json
import threading
import time
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import jwt
from cryptography.hazmat.primitives.asymmetric import ec, rsa

AUDIENCE = "https://bnserve.example.org"


class TestIssuer:
    """Serves its keys over loopback HTTP, until it is down."""

    __test__ = False

    def __init__(self) -> None:
        self.keys, self.asked, self.documents = {}, [], {}
        self.url = ""
        self.add("first")

    def add(self, name, kind="RSA"):
        """A new key, which signs from now on."""
        key = rsa.generate_private_key(65537, 2048) if kind == "RSA" else ec.generate_private_key(ec.SECP256R1())
        self.keys[name] = key
        self.signs = name

    def algorithm(self, name):
        return "RS256" if isinstance(self.keys[name], rsa.RSAPrivateKey) else "ES256"

    def sign(self, subject="alice", seconds=600.0, key=None, algorithm=None, kid=None, secret=None, **claims):
        """A token, with other claims than the usual where they are given; those that are None are left out."""
        name = key or self.signs
        now = int(time.time())
        usual = {"iss": self.url, "aud": AUDIENCE, "sub": subject, "iat": now, "nbf": now, "exp": now + int(seconds),
                 "scope": "bnserve.evaluate bnserve.upload openid"}  # fmt: skip
        told = {claim: value for claim, value in (usual | claims).items() if value is not None}
        algorithm = algorithm or self.algorithm(name)
        return jwt.encode(told, secret or self.keys[name], algorithm, headers={"kid": kid or name})

    def jwks(self):
        made = []
        for name, key in self.keys.items():
            algorithm = jwt.get_algorithm_by_name(self.algorithm(name))
            made.append({**algorithm.to_jwk(key.public_key(), as_dict=True), "kid": name, "use": "sig"})
        return {"keys": made}

    def document(self, path):
        usual = {
            "/.well-known/openid-configuration": {"issuer": self.url, "jwks_uri": f"{self.url}/keys"},
            "/keys": self.jwks(),
        }
        return (usual | self.documents).get(path)

    @contextmanager
    def serving(self, port=0):
        outer = self

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self):
                outer.asked.append(self.path)
                found = outer.document(self.path)
                content = json.dumps(found).encode()
                self.send_response(200 if found is not None else 404)
                self.send_header("content-length", str(len(content)))
                self.end_headers()
                self.wfile.write(content)

            def log_message(self, *_):
                pass

        server = ThreadingHTTPServer(("127.0.0.1", port), Handler)
        self.url = f"http://127.0.0.1:{server.server_port}"
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True)
        thread.start()
        try:
            yield self
        finally:
            server.shutdown()
            server.server_close()
            thread.join()
