"""Forecasts through real server processes, which may be several, and may be killed and started again."""

import json
import signal
from contextlib import ExitStack

import h5py
import numpy as np
import pytest

from bnserve_client import Model
from bnserve_inference.fisher import Network, NoiseCurve, as_samples, draw_population, forecast
from bnserve_protocol import ForecastOptions
from tests.integration.conftest import COMMAND, bnserve
from tests.integration.workers import serving_with
from tests.running_server import free_port, is_ready, running
from tests.service.asking import ask
from tests.service.networks import BINARY, network, put
from tests.service.networks import forecast as evaluate

OPTIONS = ForecastOptions(modes=[(2, 2)], priors={"chi_1": 0.05, "chi_2": 0.05})
SAMPLES, TRIGGER = as_samples(draw_population(1000, 1, most_redshift=1.0))
NETWORK = Network(["E1", "E2", "E3"], [NoiseCurve.named("ET-D")] * 3, 5.0, 2048.0, TRIGGER)


@pytest.fixture(scope="module")
def expected(local):
    return forecast(local, NETWORK, SAMPLES, OPTIONS)


def same(found, expected):
    names = ("snr", "detector_snr", "root", "condition", "status")
    return all(getattr(found, name).tobytes() == getattr(expected, name).tobytes() for name in names)


def test_a_server_that_is_killed_and_started_again_is_told_the_network_again(tmp_path, expected):
    port = free_port()
    address = f"http://127.0.0.1:{port}"
    command = [*COMMAND, "serve", "--port", str(port), "--model", "default"]
    with ExitStack() as stack:
        first = stack.enter_context(running(command, tmp_path / "first.log", lambda: is_ready(address)))
        model = stack.enter_context(Model.connect(address, timeout=100.0))
        assert same(model.forecast(NETWORK, SAMPLES, OPTIONS), expected)
        first.send_signal(signal.SIGKILL)
        first.wait()
        stack.enter_context(running(command, tmp_path / "second.log", lambda: is_ready(address)))
        assert same(model.forecast(NETWORK, SAMPLES, OPTIONS), expected)


def test_a_network_is_known_to_every_worker(tmp_path, expected):
    with serving_with(tmp_path / "server.log", 2) as workers:
        answer, sha256 = put(workers.address, network())
        assert answer.status == 201
        asked = {"parameters": BINARY, "modes": [[2, 2]]}
        answers = [evaluate(workers.address, sha256, asked) for _ in range(12)]  # on a connection each
        assert {answer.status for answer in answers} == {200}
        assert len({json.dumps(answer.document["root"]) for answer in answers}) == 1
        with Model.connect(workers.address, parallel=4) as model:
            assert same(model.forecast(NETWORK, SAMPLES, OPTIONS), expected)
        assert workers.value("bnserve_networks") == 2.0
        assert ask(workers.address, "DELETE", f"/v1/networks/{sha256}").status == 204
        assert {evaluate(workers.address, sha256, asked).status for _ in range(12)} == {404}


def test_the_command_asks_a_server(bnserve_server, tmp_path):
    command = ["fisher", "--draw", "200", "--redshift", "1", "--quadrupole", "--network", "ET", "--no-progress"]
    found = []
    for name, more in (("here", ()), ("there", ("--url", bnserve_server.address))):
        output = tmp_path / f"{name}.h5"
        done = bnserve(*command, *more, "--output", str(output), "--work", str(tmp_path / name))
        assert done.returncode == 0, done.stderr
        with h5py.File(output) as file:
            found.append({key: file[key][()] for key in ("snr", "covariance", "sky_area_90", "population/redshift")})
    assert all(np.array_equal(found[0][key], found[1][key], equal_nan=True) for key in found[0])
    assert "Traceback" not in bnserve_server.log.read_text()
