"""Sockets of a service manager: which they are, and what a server says of those that it cannot use."""

import os
import re
import socket
import subprocess
import sys

import pytest

from bnserve_service import Settings
from bnserve_service.process.given_sockets import GivenSockets, opened
from bnserve_service.process.output import tell_service_manager

FIRST = 3
"""Where the protocol puts them; in a process of its own, so that nothing else is there."""


def in_a_process(given: list, code: str, **environment: str) -> str:
    """What ``code`` prints in a process that was given these sockets; ``found`` are those that it sees."""
    files = [it.fileno() for it in given]
    script = f"""
import os, sys
os.environ["LISTEN_PID"] = os.environ.get("LISTEN_PID") or str(os.getpid())
from bnserve_service.process.given_sockets import GivenSockets
from bnserve_service.process.listening import CannotListen
try:
    found = GivenSockets.of(os.environ)
except CannotListen as error:
    print(error.detail)
else:
    {code}
"""
    mover = (
        "import fcntl, os, sys\n"
        "far = [fcntl.fcntl(int(number), fcntl.F_DUPFD, 100) for number in sys.argv[1].split()]\n"
        f"for place, number in enumerate(far): os.dup2(number, {FIRST} + place)\n"
        "os.execv(sys.executable, [sys.executable, '-c', sys.argv[2]])"
    )
    done = subprocess.run(
        [sys.executable, "-c", mover, " ".join(map(str, files)), script],
        env=os.environ | {"LISTEN_FDS": str(len(files))} | environment,
        pass_fds=files,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


@pytest.fixture
def listener():
    with socket.create_server(("127.0.0.1", 0)) as made:
        yield made


def test_without_a_service_manager_there_are_none():
    assert GivenSockets.of({}) is None


def test_those_of_another_process_are_not_ours_and_nobody_hears_of_them_from_us():
    environment = {"LISTEN_PID": "1", "LISTEN_FDS": "1", "LISTEN_FDNAMES": "bnserve.socket", "HOME": "/"}
    assert GivenSockets.of(environment) is None
    assert environment == {"HOME": "/"}


def test_the_address_is_that_of_the_socket_whatever_the_settings_say(listener):
    port = listener.getsockname()[1]
    shown = in_a_process([listener], "print(found.settings())", LISTEN_FDNAMES="bnserve.socket")
    assert shown == str({"uds": None, "host": "127.0.0.1", "port": port})


def test_a_second_socket_may_be_for_the_metrics_by_its_name(listener):
    with socket.create_server(("127.0.0.1", 0)) as metrics:
        shown = in_a_process([metrics, listener], "print(found.settings())", LISTEN_FDNAMES="metrics:bnserve.socket")
        assert str({"metrics_host": "127.0.0.1", "metrics_port": metrics.getsockname()[1]})[1:-1] in shown
        assert str({"port": listener.getsockname()[1]})[1:-1] in shown


def test_a_unix_socket_is_one_of_the_settings_too(tmp_path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(str(tmp_path / "socket"))
        made.listen()
        shown = in_a_process([made], "print(found.settings())")
    assert shown == str({"uds": str(tmp_path / "socket")})


def test_several_for_one_purpose_are_refused(listener):
    said = in_a_process([listener, listener], "print(found)", LISTEN_FDNAMES="a.socket:b.socket")
    assert re.search(r"gave 2 sockets \(a.socket:b.socket\).*FileDescriptorName=metrics", said)


def test_one_for_the_metrics_alone_is_refused(listener):
    assert "none for requests" in in_a_process([listener], "print(found)", LISTEN_FDNAMES="metrics")


def test_a_connection_is_refused(listener):
    with socket.create_connection(listener.getsockname()) as made:
        said = in_a_process([made], "print(found)")
    assert "does not listen" in said
    assert "Accept=no" in said


def test_what_is_no_socket_is_refused(tmp_path):
    with (tmp_path / "file").open("w") as file:
        assert "Descriptor 3 of the service manager is no socket" in in_a_process([file], "print(found)")


def test_the_file_of_a_unix_socket_stays_because_its_owner_needs_it(tmp_path):
    path = tmp_path / "socket"
    made = socket.socket(socket.AF_UNIX)
    made.bind(str(path))
    made.listen()
    with opened(Settings(uds=path), GivenSockets(made)) as (listener, metrics):
        assert (listener, metrics) == (made, None)
    assert path.exists()


@pytest.mark.parametrize("abstract", [False, True])
def test_a_service_manager_that_wants_to_know_hears_that_it_is_ready(tmp_path, monkeypatch, abstract):
    name = f"bnserve-{os.getpid()}" if abstract else str(tmp_path / "notify")
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind("\0" + name if abstract else name)
        manager.settimeout(10)
        monkeypatch.setenv("NOTIFY_SOCKET", "@" + name if abstract else name)
        tell_service_manager("READY=1")
        assert manager.recv(100) == b"READY=1"


def test_one_that_is_gone_need_not_know(tmp_path, monkeypatch):
    monkeypatch.setenv("NOTIFY_SOCKET", str(tmp_path / "gone"))
    tell_service_manager("READY=1")
