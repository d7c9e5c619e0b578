"""Derivatives are the same, to the bit, wherever they are asked for."""

from contextlib import closing

import httpx
import msgpack
import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_protocol import EvaluationOptions, InvalidRequest, OutOfDomain, UniformGrid
from bnserve_service import BackgroundServer, Settings
from bnserve_surrogate import Model as LocalModel
from tests.contract.models import Blocking
from tests.contract.test_waveform_model import FLAG, ONE, binaries, bits, failure, with_values
from tests.service.chirp import ChirpModel, MemorySource, as_it_is

GRIDS = {
    "explicit": np.geomspace(20.0, 1500.0, 77),
    "uniform": UniformGrid(20.0, 120.0, 0.5),
    "uploaded": np.geomspace(6.0, 2000.0, 2000),
    "one frequency": [100.0],
}


@pytest.fixture(scope="module")
def several():
    """The shipped models, of seven modes."""
    with BackgroundServer(Settings(port=0)) as server:
        yield server.address


@pytest.fixture(scope="module", params=["remote", "remote in small chunks", "asynchronous"])
def of_several(request, several):
    ways = {
        "remote": lambda: RemoteModel.connect(several),
        "remote in small chunks": lambda: RemoteModel.connect(several, chunk_samples=20_000),
        "asynchronous": lambda: closing(Blocking(several)),
    }
    with ways[request.param]() as model:
        yield model


@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
def test_of_one_mode(model, local, grid):
    batch = binaries(5)
    assert bits(model.predict_derivatives(grid, batch)) == bits(local.predict_derivatives(grid, batch))


@pytest.mark.parametrize("modes", [None, [(3, 3)], [(2, 1), (2, 2)]], ids=str)
def test_of_several(of_several, modes):
    local, batch = LocalModel.default(), binaries(7)
    options = EvaluationOptions(modes=modes, alignment="merger", reference_frequency=50.0)
    ours = of_several.predict_derivatives(GRIDS["explicit"], batch, options=options)
    assert bits(ours) == bits(local.predict_derivatives(GRIDS["explicit"], batch, options=options))
    mine, other = (
        ours.polarizations(),
        local.predict_derivatives(GRIDS["explicit"], batch, options=options).polarizations(),
    )
    assert [part.tobytes() for part in mine] == [part.tobytes() for part in other]


def test_flagged_rows(model, local):
    batch = with_values(3, mass_ratio=99.0)
    ours = model.predict_derivatives(GRIDS["explicit"], batch, options=FLAG)
    assert np.isnan(ours.derivatives[1]).all()
    assert bits(ours) == bits(local.predict_derivatives(GRIDS["explicit"], batch, options=FLAG))


@pytest.mark.parametrize("modes", [None, [(2, 2)]], ids=str)
def test_nobodys_are_none(of_several, modes):
    options = EvaluationOptions(modes=modes, reference_frequency=50.0)
    found = of_several.predict_derivatives(GRIDS["explicit"], binaries(2).rows(slice(0, 0)), options=options)
    assert found.derivatives.shape == (0, 1 if modes else 7, 6, 77)


def test_errors_are_the_same(model, local):
    batch = with_values(3, mass_ratio=99.0)
    call = lambda it: it.predict_derivatives(GRIDS["explicit"], batch)  # noqa: E731
    assert failure(lambda: call(model)) == failure(lambda: call(local))
    assert failure(lambda: call(model))[0] is OutOfDomain


def test_a_model_whose_regressor_is_a_network_has_them(several):
    with RemoteModel.connect(several, "paper") as paper:
        found = paper.predict_derivatives(GRIDS["explicit"], ONE)
    assert bits(found) == bits(LocalModel.load("paper").predict_derivatives(GRIDS["explicit"], ONE))


def test_a_model_of_a_user_is_refused(several):
    with (
        BackgroundServer(Settings(port=0), source=MemorySource().add(ChirpModel()), factory=as_it_is) as server,
        RemoteModel.connect(server.address, "chirp") as chirp,
        pytest.raises(InvalidRequest, match="does not say that it has derivatives"),
    ):
        chirp.predict_derivatives(GRIDS["explicit"], ONE)


def test_without_our_client(several):
    names = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination", "total_mass")
    asked = {
        "parameters": {name: getattr(ONE, name) for name in names}, "grid": {"f_min": 20, "f_max": 24, "delta_f": 2},
        "output": "derivatives", "modes": [[2, 2]],
    }  # fmt: skip
    url = f"{several}/v1/models/default/waveforms"
    plain = httpx.post(url, json=asked, headers={"Accept": "application/json"}).json()
    assert {"h_22", "plus_22", "cross_22", "plus_slope_22", "cross_slope_22", "h_22_mass_ratio", "h_22_total_mass"} <= (
        plain.keys()
    )
    packed = msgpack.unpackb(
        httpx.post(url, json=asked, headers={"Accept": "application/msgpack"}).content, strict_map_key=False
    )
    assert packed["h_22_chi_1"]["shape"] == [1, 3]
    narrow = httpx.post(url, json=asked | {"dtype": "complex64"})
    assert narrow.status_code == 422
    assert "complex128" in narrow.json()["detail"]
