"""Models of several modes: the remote ones equal the local one in bits, types and errors, mode by mode."""

from contextlib import closing

import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_protocol import (
    EvaluationOptions,
    InvalidRequest,
    Modes,
    OutOfDomain,
    UniformGrid,
)
from bnserve_service import BackgroundServer, Settings
from bnserve_surrogate import Model as LocalModel
from tests.contract.models import Blocking
from tests.contract.test_waveform_model import FLAG, ONE, binaries, bits, failure, with_values
from tests.service.chirp import MemorySource, as_it_is
from tests.service.modes_chirp import MODES, ModesModel

GRIDS = {
    "explicit": np.geomspace(20.0, 1500.0, 77),
    "uniform": UniformGrid(20.0, 120.0, 0.5),
    "uploaded": np.geomspace(6.0, 2000.0, 2000),
    "one frequency": [100.0],
}
SHORT = GRIDS["explicit"]
CHOICES = {
    "all": None,
    "all of a user's, named": MODES,
    "some, in another order": [(2, 1), (2, 2)],
    "one": [(3, 3)],
    "(2, 2) alone": [(2, 2)],
}
OF_SEVERAL = ("predict", "predict_batch", "predict_modes")
OF_ONE = ("predict_factored", "predict_amplitude_phase")


@pytest.fixture(scope="module", params=["of a user", "the default one"])
def local(request):
    return ModesModel() if request.param == "of a user" else LocalModel.default()


@pytest.fixture(scope="module")
def address(local):
    source = MemorySource().add(local)
    with BackgroundServer(Settings(port=0), source=source, factory=as_it_is) as server:
        yield server.address


@pytest.fixture(scope="module", params=["remote", "remote in small chunks", "asynchronous"])
def model(request, address, local):
    name = local.description.name
    ways = {
        "remote": lambda: RemoteModel.connect(address, name),
        "remote in small chunks": lambda: RemoteModel.connect(address, name, chunk_samples=700),
        "asynchronous": lambda: closing(Blocking(address, name)),
    }
    with ways[request.param]() as reached:
        yield reached


@pytest.mark.parametrize("modes", CHOICES.values(), ids=CHOICES)
@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
@pytest.mark.parametrize("method", OF_SEVERAL)
def test_modes_are_equal_in_bits(model, local, method, grid, modes):
    options, batch = EvaluationOptions(modes=modes), ONE if method == "predict" else binaries(7)
    there = getattr(model, method)(grid, batch, options=options)
    assert bits(there) == bits(getattr(local, method)(grid, batch, options=options))


@pytest.mark.parametrize("method", OF_ONE)
def test_one_of_them_is_equal_in_bits(model, local, method):
    options = EvaluationOptions(modes=[(3, 3)], alignment="merger")
    for batch in (ONE, binaries(7)):
        there = getattr(model, method)(SHORT, batch, options=options)
        assert bits(there) == bits(getattr(local, method)(SHORT, batch, options=options))


@pytest.mark.parametrize("rows", [0, 1, 64])
def test_modes_of_a_batch_belong_to_the_user(model, local, rows):
    there = model.predict_modes(SHORT, binaries(rows), dtype="complex64")
    assert type(there) is Modes
    modes = tuple(local.description.modes)
    assert there.modes == modes
    assert there.h.shape == (rows, len(modes), len(SHORT))
    assert there.plus.shape == there.cross.shape == (rows, len(modes))
    assert bits(there) == bits(local.predict_modes(SHORT, binaries(rows), dtype="complex64"))
    assert all(array.flags.writeable for array in (*there, there.status, there.estimated_mismatch))


def test_flagged_rows_are_nan_in_every_mode(model, local):
    batch = with_values(40, mass_ratio=0.5)
    there = model.predict_modes(SHORT, batch, options=FLAG)
    assert bits(there) == bits(local.predict_modes(SHORT, batch, options=FLAG))
    assert there.status.tolist() == [0, 2, *[0] * 38]
    assert np.isnan(there.h[1]).all()


def test_a_bad_row_is_the_same_error(model, local):
    batch = with_values(3, mass_ratio=0.5)
    there = failure(lambda: model.predict_modes(SHORT, batch))
    assert there == failure(lambda: local.predict_modes(SHORT, batch))
    assert there[0] is OutOfDomain


@pytest.mark.parametrize("method", OF_SEVERAL + OF_ONE)
@pytest.mark.parametrize("modes", [[(5, 5)], [(2, 2), (3, -3)]])
def test_a_mode_that_is_not_there_is_the_same_error(model, local, method, modes):
    options = EvaluationOptions(modes=modes)
    there = failure(lambda: getattr(model, method)(SHORT, ONE, options=options))
    assert there == failure(lambda: getattr(local, method)(SHORT, ONE, options=options))
    assert there[0] is InvalidRequest
    assert f"it has {', '.join(map(str, local.description.modes))}." in there[2]


@pytest.mark.parametrize("method", OF_ONE)
@pytest.mark.parametrize("modes", [None, [(2, 2), (2, 1)]])
def test_what_belongs_to_one_mode_is_the_same_error_for_several(model, local, method, modes):
    options = EvaluationOptions(modes=modes)
    there = failure(lambda: getattr(model, method)(SHORT, ONE, options=options))
    assert there == failure(lambda: getattr(local, method)(SHORT, ONE, options=options))
    assert "modes=[(2, 2)]" in there[2]


def test_a_chunk_holds_as_many_rows_of_modes_as_fit():
    local = ModesModel()
    source = MemorySource().add(local)
    with (
        BackgroundServer(Settings(port=0), source=source, factory=as_it_is) as server,
        RemoteModel.connect(server.address, "modes", chunk_samples=2 * 3 * len(SHORT)) as model,
    ):
        asked = []
        evaluate = local.predict_modes
        local.predict_modes = lambda grid, batch, **options: (
            asked.append(len(batch)) or evaluate(grid, batch, **options)
        )
        try:
            model.predict_modes(SHORT, binaries(6), options=FLAG)
        finally:
            del local.predict_modes
    assert sum(asked) == 6
    assert max(asked) <= 4  # the two under way may be evaluated together


def test_more_modes_than_fit_a_request_come_in_smaller_ones():
    local = ModesModel()
    source = MemorySource().add(local)
    with (
        BackgroundServer(
            Settings(port=0, max_samples=1000, max_frequencies=900), source=source, factory=as_it_is
        ) as server,
        RemoteModel.connect(server.address, local.description.name) as model,
    ):
        grid = UniformGrid(20.0, 120.0, 0.5)
        assert bits(model.predict_modes(grid, binaries(5))) == bits(local.predict_modes(grid, binaries(5)))


def test_the_time_until_merger_is_that_of_the_2_2_mode(model, local):
    assert model.time_until_merger(40.0, ONE) == local.time_until_merger(40.0, ONE) > 0.0
