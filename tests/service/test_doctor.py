"""``bnserve doctor``: a sound installation has no fault, and each fault that is planted is found and named."""

import json
import os
import resource
import shutil
import socket
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from email.utils import formatdate
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest

import bnserve_store
from bnserve_protocol import __version__
from bnserve_protocol.wire import content_digest
from bnserve_service import BackgroundServer, Settings, Token
from bnserve_service.cli import main
from bnserve_service.doctor.installation import EXTRAS
from tests.architecture.rooms import ROOT, room_environment
from tests.certificates import certificates

TOKEN = "a-long-enough-token"
PUBLIC = {"analyse", "train", "jax", "lal", "roq", "frames", "bilby", "progress", "buckets", "oidc", "otel", "ray"}
"""Extras of the repository for users; the others are for its tests and measurements, or are of the past."""


@pytest.fixture
def doctor(capsys, monkeypatch):
    """Runs it in this process: exit code, and findings by status."""
    monkeypatch.delenv("BNSERVE_TOKEN", raising=False)

    def look(*options):
        status = main(["doctor", "--port", "0", *map(str, options), "--json"])
        report = json.loads(capsys.readouterr().out)
        found = {"ok": {}, "warning": {}, "fault": {}}
        for each in report["findings"]:
            found[each["status"]].setdefault(each["what"], "")
            found[each["status"]][each["what"]] += f"{each['says']} -> {each['do']}\n"
        assert (report["faults"] > 0) == (status == 1)
        return found

    return look


def doctor_in_a_process(*options, code="", environment=None, **subprocess_options):
    """The same as a process of its own, which first runs ``code``."""
    program = f"import sys\n{code}\nfrom bnserve_service.cli import main\nsys.exit(main(sys.argv[1:]))"
    done = subprocess.run(
        [sys.executable, "-c", program, "doctor", "--port", "0", *options], capture_output=True, text=True, check=False,
        env=room_environment() | (environment or {}), timeout=120, **subprocess_options,
    )  # fmt: skip
    assert done.stderr == ""
    return done


@pytest.fixture
def copied_store(tmp_path):
    shutil.copytree(bnserve_store.SHIPPED_MODELS / "fast", tmp_path / "store" / "fast")
    return tmp_path / "store"


@pytest.fixture(scope="module")
def good_server():
    with BackgroundServer(Settings(port=0, tokens=(Token.of(TOKEN),))) as server:
        yield server.address


def test_a_sound_installation_and_server_have_no_fault(doctor, good_server, copied_store):
    found = doctor("--url", good_server.removeprefix("http://"), "--token", TOKEN, "--store", copied_store)
    assert found["fault"] == {}
    looked_at = {"versions", "kernels", "extras", "open files", "clock", "store", "model default", "model fast", "port"}
    assert looked_at <= set(found["ok"])
    assert {"server", "server clock", "digests", "server version", "waveform", "latency"} <= set(found["ok"])
    assert "gives the bits of this installation" in found["ok"]["waveform"]


def test_it_is_one_line_for_each_finding_and_a_sum(capsys):
    assert main(["doctor", "--port", "0"]) == 0
    *lines, empty, last = capsys.readouterr().out.splitlines()
    assert all(line.startswith(("ok      ", "warning ")) for line in lines)
    assert empty == ""
    assert last.startswith("No faults, ")


def test_tensors_that_are_damaged(doctor, copied_store):
    tensors = copied_store / "fast" / "1.0.0" / "tensors.safetensors"
    content = bytearray(tensors.read_bytes())
    content[len(content) // 2] ^= 1
    tensors.write_bytes(content)
    found = doctor("--store", copied_store)
    assert "1.0.0: " in found["fault"]["model fast"]
    assert "model default" in found["ok"]


def test_a_label_without_its_version(doctor, copied_store):
    (copied_store / "fast" / "labels.json").write_text('{"stable": "3.0.0"}')
    assert "3.0.0, which is not in the store" in doctor("--store", copied_store)["fault"]["model fast"]


def test_a_store_that_is_not_there(doctor, tmp_path):
    found = doctor("--store", tmp_path / "nowhere")
    assert "nowhere" in found["fault"]["store"]
    assert "model default" in found["ok"]  # the others are looked at nevertheless


def test_a_version_that_is_to_be_served_and_is_not_there(doctor, tmp_path):
    (tmp_path / "bnserve.toml").write_text('models = ["default@9.9.9"]')
    assert "there are 1.0.0" in doctor("--config", tmp_path / "bnserve.toml")["fault"]["models"]


def test_settings_that_cannot_be(doctor, tmp_path):
    (tmp_path / "bnserve.toml").write_text("prot = 8000")
    found = doctor("--config", tmp_path / "bnserve.toml")
    assert "Did you mean 'port'?" in found["fault"]["settings"]
    assert "kernels" in found["ok"]


def test_a_port_that_another_program_has(doctor):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert f"Port {port} on 127.0.0.1 is in use" in doctor("--port", port)["fault"]["port"]


def test_a_port_that_a_bnserve_has(doctor, good_server):
    found = doctor("--port", good_server.rpartition(":")[2])
    assert f"a bnserve answers at {good_server}" in found["warning"]["port"]
    assert found["fault"] == {}


def test_a_shared_folder_without_room(doctor, tmp_path):
    much = 2**60
    (tmp_path / "bnserve.toml").write_text(f"max_grid_bytes = {much}")
    found = doctor("--config", tmp_path / "bnserve.toml")
    assert "uploads may take" in found["warning"]["/dev/shm"]
    assert "max_grid_bytes" in found["warning"]["memory"]


def test_a_folder_that_cannot_be_written():
    """Where the system refuses files to root as well."""
    code = """
import tempfile
from pathlib import Path
import bnserve_service.shared.folder as folder
folder._IN_MEMORY, tempfile.tempdir = Path("/dev/null"), "/proc"
"""
    done = doctor_in_a_process(code=code)
    assert done.returncode == 1
    assert "fault   shared folder: no place for it can be written" in done.stdout
    assert "warning /proc: cannot be written" in done.stdout


@pytest.mark.parametrize(("files", "status"), [(128, "fault"), (512, "warning")])
def test_a_low_limit_of_open_files(files, status):
    hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    done = doctor_in_a_process(code=f"import resource; resource.setrlimit(resource.RLIMIT_NOFILE, ({files}, {hard}))")
    assert f"{status:8}open files: this process may open {files} files" in done.stdout
    assert "LimitNOFILE" in done.stdout
    assert done.returncode == (status == "fault")


def test_more_threads_than_processors(doctor, tmp_path):
    (tmp_path / "bnserve.toml").write_text("threads = 512")
    found = doctor("--config", tmp_path / "bnserve.toml", "--workers", "3")
    assert "3 worker(s) with 512 thread(s)" in found["warning"]["processors"]


def test_rooms_of_several_versions(tmp_path):
    other = tmp_path / "bnserve_store-0.0.1.dist-info"
    other.mkdir()
    (other / "METADATA").write_text("Metadata-Version: 2.1\nName: bnserve-store\nVersion: 0.0.1\n")
    done = doctor_in_a_process(code=f"sys.path.insert(0, {str(tmp_path)!r})")
    assert done.returncode == 1
    assert f"bnserve-store is 0.0.1, bnserve_protocol is {__version__}" in done.stdout
    assert "pip install ." in done.stdout


def test_an_extra_that_is_missing():
    code = """
class Blocker:
    def find_spec(self, name, *_):
        if name.partition(".")[0] == "matplotlib":
            raise ImportError(f"no {name} here")
sys.meta_path.insert(0, Blocker())
"""
    done = doctor_in_a_process(code=code)
    assert done.returncode == 0
    for extra in ("demo", "train", "roq"):
        assert f"warning extra {extra}: not there (matplotlib" in done.stdout
    assert "pip install '.[train]'" in done.stdout


def test_settings_that_need_an_extra(doctor, tmp_path, monkeypatch):
    settings = tmp_path / "bnserve.toml"
    settings.write_text('issuers = [{ issuer = "https://a.example", audience = ["b"] }]\n')
    assert "packages" in doctor("--config", settings)["ok"]
    monkeypatch.setitem(sys.modules, "jwt", None)
    assert "pip install '.[oidc]'" in doctor("--config", settings)["fault"]["packages"]


def test_a_kernel_that_does_not_load():
    code = (
        "import bnserve_inference.kernel._contraction as c; from pathlib import Path; c.ASSEMBLY = Path('/nowhere.ll')"
    )
    done = doctor_in_a_process(code=code)
    assert done.returncode == 1
    assert "fault   kernels: cannot be looked at: FileNotFoundError" in done.stdout


def test_extras_are_those_of_the_repository():
    import tomllib

    declared = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    assert set(declared) >= PUBLIC
    assert set(EXTRAS) - {"demo", "completion"} == PUBLIC
    assert set(declared) - PUBLIC == {"detectors", "benchmarks", "docs", "test", "dev"}


def test_an_address_where_nobody_is(doctor):
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    found = doctor("--url", f"http://127.0.0.1:{port}")
    assert "Connection refused" in found["fault"]["server"]
    assert "bnserve serve" in found["fault"]["server"]


@pytest.mark.parametrize("url", ["ftp://host", "http://host:port", "unix:/nowhere", "http://"])
def test_an_address_that_is_none(doctor, url):
    assert "server" in doctor("--url", url)["fault"]


@pytest.mark.parametrize(
    "token", [[], ["--token", "another-long-token"], ["--token", "caf\u00e9-caf\u00e9-caf\u00e9-caf\u00e9"]]
)
def test_a_token_that_is_wrong_or_missing(doctor, good_server, token):
    found = doctor("--url", good_server, *token)
    [(what, says)] = found["fault"].items()
    assert what in ("token", "server")
    assert "token" in says


def test_a_server_that_drains(doctor):
    with BackgroundServer(Settings(port=0, drain_grace=600.0)) as server:
        server._server.stop_from_thread()
        deadline = time.monotonic() + 30.0
        while server.app.parts.health.reason_unready() is None:
            assert time.monotonic() < deadline
            time.sleep(0.01)
        found = doctor("--url", server.address)
        server._server.stop_from_thread()
    assert "not ready: This server is shutting down." in found["fault"]["server"]
    assert "waveform" in found["ok"]  # it still answers


@contextmanager
def pretender(answers, date=None):
    """Something that speaks HTTP: by path, status, headers and body."""

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            status, headers, body = answers.get(self.path, (404, {}, b"nothing here"))
            self.send_response_only(status)
            for name, value in ({"Date": formatdate(date, usegmt=True), "Content-Length": len(body)} | headers).items():
                self.send_header(name, str(value))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_):
            pass

    with HTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02})
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()


READY = (200, {"Content-Type": "application/json"}, b'{"ready":true}')


def manifest(software=__version__, models=()):
    body = json.dumps({"software": {"bnserve": software}, "models": [*models]}).encode()
    return 200, {"Content-Digest": content_digest([body])}, body


@pytest.mark.parametrize(("off", "status"), [(30.0, "warning"), (3600.0, "fault"), (-3600.0, "fault")])
def test_a_clock_that_is_off(doctor, off, status):
    with pretender({"/v2/health/ready": READY, "/v1/manifest": manifest()}, date=time.time() + off) as url:
        found = doctor("--url", url)
    assert "differ by" in found[status]["server clock"]


def test_a_server_of_another_version(doctor):
    with pretender({"/v2/health/ready": READY, "/v1/manifest": manifest("9.9")}) as url:
        found = doctor("--url", url)
    assert f"it is bnserve 9.9, and here is {__version__}" in found["warning"]["server version"]


def test_answers_that_are_changed_on_their_way(doctor):
    status, headers, body = manifest()
    with pretender({"/v2/health/ready": READY, "/v1/manifest": (status, headers, body + b" ")}) as url:
        assert "digests" in doctor("--url", url)["fault"]


def test_another_model_of_the_same_name_and_version(doctor):
    other = {"name": "default", "version": "1.0.0", "digest": "sha256:0"}
    with pretender({"/v2/health/ready": READY, "/v1/manifest": manifest(models=[other])}) as url:
        assert "its default 1.0.0 is another than the one here" in doctor("--url", url)["fault"]["server models"]


@pytest.mark.parametrize(
    "models", [["x"], [{"name": "a\r\nX: y", "version": "1"}], {}, [{"name": "../..", "version": "1"}]]
)
@pytest.mark.parametrize("software", [[], {"bnserve": "\x1b[2J"}])
def test_a_server_that_means_ill_gets_no_further(doctor, models, software):
    body = json.dumps({"software": software, "models": models, "detail": "\x1b[2J"}).encode()
    answer = 200, {"Content-Digest": content_digest([body])}, body
    with pretender({"/v2/health/ready": READY, "/v1/manifest": answer}) as url:
        found = doctor("--url", url)
    assert found["fault"] == {}
    assert "\x1b" not in str(found)
    assert "server version" in found["warning"]


def test_a_waveform_that_is_none(doctor):
    strange = {"name": "strange", "version": "1", "digest": "sha256:0"}
    with pretender({"/v2/health/ready": READY, "/v1/manifest": manifest(models=[strange])}) as url:
        found = doctor("--url", url)
    assert "strange 1" in found["fault"]["waveform"]
    assert "latency" in found["ok"]


def test_something_else_that_speaks_http(doctor):
    with pretender({}) as url:
        assert "is no bnserve (status 404)" in doctor("--url", url)["fault"]["server"]


def test_a_token_may_come_from_the_environment(doctor, good_server, monkeypatch):
    monkeypatch.setitem(os.environ, "BNSERVE_TOKEN", TOKEN)
    assert doctor("--url", good_server)["fault"] == {}


@pytest.fixture
def encrypted_server(tmp_path):
    made = certificates(tmp_path)
    with BackgroundServer(Settings(port=0, tokens=(Token.of(TOKEN),), **made.settings)) as server:
        yield server.address, made


def test_a_server_with_tls(doctor, encrypted_server, monkeypatch):
    address, made = encrypted_server
    found = doctor("--url", address, "--token", TOKEN)
    assert "not trusted here" in found["fault"]["certificate"]
    assert "SSL_CERT_FILE" in found["fault"]["certificate"]
    monkeypatch.setenv("SSL_CERT_FILE", str(made.trusted))
    (made.folder / "token").write_text(f"{TOKEN}\n")
    monkeypatch.setenv("BNSERVE_TOKEN_FILE", str(made.folder / "token"))
    found = doctor("--url", address)
    assert found["fault"] == {}
    assert "TLSv1.3, trusted, for " in found["ok"]["certificate"]
    assert "server" in found["ok"]


def test_a_server_without_tls_that_is_asked_for_it(doctor, good_server):
    found = doctor("--url", good_server.replace("http://", "https://"), "--token", TOKEN)
    assert "speaks no TLS" in found["fault"]["certificate"]


def test_a_certificate_that_soon_ends(doctor, encrypted_server, monkeypatch):
    address, made = encrypted_server
    monkeypatch.setenv("SSL_CERT_FILE", str(made.trusted))
    monkeypatch.setattr("bnserve_service.doctor.encryption.SOON_SECONDS", 1e12)
    assert "see that it is renewed" in doctor("--url", address, "--token", TOKEN)["warning"]["certificate"]


def test_a_token_in_clear(doctor):
    found = doctor("--url", "http://203.0.113.1:9", "--token", TOKEN)  # documentation's: nobody is there
    assert "in clear" in found["warning"]["encryption"]


def test_a_certificate_of_the_settings_with_the_key_of_another(doctor, tmp_path):
    made = certificates(tmp_path)
    (tmp_path / "bnserve.toml").write_text(f'tls_cert = "{made.chain}"\ntls_key = "{made.key}"\n')
    assert "belong together" in doctor("--config", tmp_path / "bnserve.toml")["ok"]["certificate"]
    old = made.key.read_bytes()
    made.renew()
    made.key.write_bytes(old)
    assert "cannot be used" in doctor("--config", tmp_path / "bnserve.toml")["fault"]["certificate"]
