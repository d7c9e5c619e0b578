"""Forecasts are the same, to the bit, wherever they are asked for."""

import dataclasses
from contextlib import closing

import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_inference.fisher import ForecastOptions, Network, NoiseCurve, forecast, signal_to_noise
from bnserve_protocol import (
    AnalysisInvalid,
    DetectorNetwork,
    InvalidParameters,
    InvalidRequest,
    NetworkDetector,
    PathUnknown,
    TooLarge,
)
from bnserve_service import BackgroundServer, Settings
from bnserve_surrogate import Model as LocalModel
from tests.contract.models import Blocking, Forked
from tests.contract.test_waveform_model import failure

TRIGGER = 1187008882.4
CURVE = NoiseCurve.of(np.geomspace(5.0, 3000.0, 300), np.geomspace(1e-23, 1e-24, 300))
NETWORK = Network(["E1", "H1", "CE40"], [CURVE, NoiseCurve.named("ET-D"), CURVE], 15.0, 1024.0, TRIGGER)
OPTIONS = {
    "one mode": ForecastOptions(modes=[(2, 2)]),
    "several": ForecastOptions(priors={"chi_1": 0.05}),
    "one of several": ForecastOptions(modes=[(3, 3)], alignment="post_newtonian", reference_frequency=100.0),
}


def binaries(rows):
    random = np.random.default_rng(3)
    return {
        "mass_ratio": random.uniform(1.0, 2.0, rows), "lambda_1": random.uniform(100.0, 500.0, rows),
        "lambda_2": random.uniform(100.0, 900.0, rows), "chi_1": random.uniform(-0.1, 0.1, rows),
        "chi_2": random.uniform(-0.1, 0.1, rows), "total_mass": random.uniform(2.5, 3.5, rows),
        "distance_mpc": random.uniform(40.0, 400.0, rows), "inclination": np.arccos(random.uniform(-1.0, 1.0, rows)),
        "right_ascension": random.uniform(0.0, 6.0, rows), "declination": random.uniform(-1.0, 1.0, rows),
        "polarization_angle": random.uniform(0.0, 3.0, rows), "coalescence_time": random.uniform(0.0, 8e4, rows),
    }  # fmt: skip


def bits(found):
    return {
        field.name: value.tobytes() if isinstance(value := getattr(found, field.name), np.ndarray) else value
        for field in dataclasses.fields(found)
    }


@pytest.fixture(scope="module")
def address():
    """The shipped models; a request has one binary of the seven modes, or some of one mode."""
    with BackgroundServer(Settings(port=0, max_samples=2**21)) as server:
        yield server.address


@pytest.fixture(scope="module", params=["remote", "asynchronous", "forked"])
def model(request, address):
    with RemoteModel.connect(address) as remote:
        ways = {"remote": lambda: remote, "asynchronous": lambda: Blocking(address), "forked": lambda: Forked(remote)}
        reached = ways[request.param]()
        if request.param == "asynchronous":
            with closing(reached):
                yield reached
        else:
            yield reached


@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS)
def test_the_same_bits(model, options):
    local, rows = LocalModel.default(), binaries(7)
    assert bits(model.forecast(NETWORK, rows, options)) == bits(forecast(local, NETWORK, rows, options))
    assert bits(model.signal_to_noise(NETWORK, rows, options)) == bits(signal_to_noise(local, NETWORK, rows, options))


def test_in_many_pieces_with_rows_that_are_flagged(model):
    rows, options = binaries(100), OPTIONS["one mode"]
    rows["mass_ratio"][50], rows["declination"][7] = 99.0, np.nan
    ours, here = model.forecast(NETWORK, rows, options), forecast(LocalModel.default(), NETWORK, rows, options)
    assert bits(ours) == bits(here)
    assert np.flatnonzero(ours.status).tolist() == [7, 50]
    assert np.isnan(ours.root[50]).all()
    assert ours.covariance.tobytes() == here.covariance.tobytes()
    assert bits(model.forecast(NETWORK, {name: column[:0] for name, column in rows.items()}, options)) == bits(
        forecast(LocalModel.default(), NETWORK, {name: column[:0] for name, column in rows.items()}, options)
    )


def test_the_local_function_asks_a_remote_model(address):
    with RemoteModel.connect(address) as remote:
        rows, options = binaries(3), OPTIONS["one mode"]
        assert bits(forecast(remote, NETWORK, rows, options)) == bits(remote.forecast(NETWORK, rows, options))
        ratios = signal_to_noise(remote, NETWORK, rows, options)
        assert bits(ratios) == bits(remote.signal_to_noise(NETWORK, rows, options))


def test_without_detectors_or_curves_of_ones_own(address):
    """What the client alone can write: names that the server knows."""
    described = DetectorNetwork(
        [NetworkDetector("E1", "ET-D"), NetworkDetector("H1", (CURVE.frequencies, CURVE.asd))], 15.0, 1024.0, TRIGGER
    )
    here = Network(["E1", "H1"], [NoiseCurve.named("ET-D"), CURVE], 15.0, 1024.0, TRIGGER)
    with RemoteModel.connect(address) as remote:
        ours = remote.forecast(described, binaries(3), OPTIONS["one mode"])
        assert bits(ours) == bits(forecast(LocalModel.default(), here, binaries(3), OPTIONS["one mode"]))


@pytest.mark.parametrize(
    ("change", "options", "error"),
    [
        ({"colour": 1.0}, {}, InvalidParameters),
        ({"distance_mpc": None}, {}, InvalidParameters),
        ({}, {"priors": {"mass": 1.0}}, InvalidRequest),
        ({}, {"coordinates": ("mass_ratio",) * 10}, InvalidRequest),
        ({}, {"modes": [(5, 5)]}, AnalysisInvalid),
    ],
)
def test_errors_are_the_same(model, change, options, error):
    rows = {name: value for name, value in (binaries(2) | change).items() if value is not None}
    how = ForecastOptions(**({"modes": [(2, 2)]} | options))
    ours = failure(lambda: model.forecast(NETWORK, rows, how))
    assert ours == failure(lambda: forecast(LocalModel.default(), NETWORK, rows, how))
    assert ours[0] is error


def test_what_is_forgotten_is_uploaded_again(address):
    import httpx  # as somebody else would

    with RemoteModel.connect(address) as remote:
        first = remote.forecast(NETWORK, binaries(2), OPTIONS["one mode"])
        path = f"{address}/v1/networks/{NETWORK.description.digest.removeprefix('sha256:')}"
        assert httpx.delete(path).status_code == 204
        assert bits(remote.forecast(NETWORK, binaries(2), OPTIONS["one mode"])) == bits(first)


def test_what_the_client_refuses_itself(address):
    with RemoteModel.connect(address) as remote, pytest.raises(InvalidRequest, match="got dict"):
        remote.forecast({"detectors": []}, binaries(1))
    with pytest.raises(AnalysisInvalid, match="1 to 16"):
        DetectorNetwork([], 15.0, 1024.0, TRIGGER)
    with pytest.raises(AnalysisInvalid, match="got 'E1' 2 times"):
        DetectorNetwork([NetworkDetector("E1", "ET-D"), NetworkDetector("E1", "CE40")], 15.0, 1024.0, TRIGGER)
    with (
        BackgroundServer(Settings(port=0, max_network_bytes=2048)) as small,
        RemoteModel.connect(small.address) as remote,
        pytest.raises(TooLarge, match="fewer frequencies"),
    ):
        remote.forecast(NETWORK, binaries(1))


def test_a_server_from_before_has_no_such_path(address):
    with RemoteModel.connect(address) as remote:
        remote._remote.evaluator._path = "/v1/before"  # where nothing is
        with pytest.raises(PathUnknown):
            remote.forecast(NETWORK, binaries(1))
