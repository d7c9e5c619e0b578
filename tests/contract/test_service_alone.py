"""What only a remote model can meet, against the real server."""

import contextlib
import socket
import threading

import pytest

from bnserve_client import Model, ModelUnknown, NotBnserve, TooLarge, UniformGrid
from bnserve_protocol import ParametersWithExtrinsic

ONE = ParametersWithExtrinsic.gw170817()


@pytest.mark.parametrize(("name", "version"), [("defualt", "stable"), ("default", "99.0.0")])
def test_an_unknown_model_or_version_is_named(address, name, version):
    with pytest.raises(ModelUnknown):
        Model.connect(address, name, version=version)


def test_a_grid_that_is_too_large_is_refused_with_the_limit(remote):
    with pytest.raises(TooLarge, match="at most"):
        remote.predict_batch(UniformGrid(20.0, 2000.0, 1e-4), [ONE] * 3)


def test_the_version_behind_a_label_is_pinned(remote, local):
    assert remote.description.version == local.description.version
    assert remote.description.digest == local.description.digest


def test_a_port_that_speaks_another_protocol_is_said_to_be_no_bnserve():
    with socket.create_server(("127.0.0.1", 0)) as listener:

        def greet():
            with contextlib.suppress(OSError):  # it has been shut down
                while True:
                    connection, _ = listener.accept()
                    with connection:
                        connection.sendall(b"220 mail.example.org ESMTP\r\n")
                        connection.recv(65536)

        thread = threading.Thread(target=greet)
        thread.start()
        with pytest.raises(NotBnserve, match="is not bnserve"):
            Model.connect(f"http://127.0.0.1:{listener.getsockname()[1]}")
        listener.shutdown(socket.SHUT_RDWR)
        thread.join()
