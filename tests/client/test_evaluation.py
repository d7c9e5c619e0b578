"""A remote model answers as the local one: bits, shapes, types, errors, whatever the batch and the grid."""

import numpy as np
import pytest

from bnserve_client import EvaluationOptions, OutOfDomain, ParametersWithExtrinsic, TooLarge, UniformGrid
from bnserve_protocol import InvalidFrequencies, InvalidParameters, Limits
from tests.client.conftest import same
from tests.client.reference_model import binaries
from tests.client.reference_service import ReferenceService

FREQUENCIES = np.linspace(20.0, 1024.0, 33)
LONG_GRID = np.geomspace(5.0, 2048.0, 3000)
ONE = ParametersWithExtrinsic.gw170817()
METHODS = ("predict_batch", "predict_factored", "predict_amplitude_phase")
GRIDS = {"explicit": FREQUENCIES, "uniform": UniformGrid(20.0, 128.0, 0.5), "uploaded": LONG_GRID}


@pytest.mark.parametrize("grid", GRIDS.values(), ids=GRIDS)
@pytest.mark.parametrize("rows", [0, 1, 7, 256])
@pytest.mark.parametrize("method", METHODS)
def test_batches_equal_the_local_model(model, local, method, rows, grid):
    batch = binaries(rows)
    assert same(getattr(model, method)(grid, batch), getattr(local, method)(grid, batch))


@pytest.mark.parametrize("method", ["predict", *METHODS])
def test_one_binary_equals_the_local_model(model, local, method):
    assert same(getattr(model, method)(FREQUENCIES, ONE), getattr(local, method)(FREQUENCIES, ONE))


def test_single_precision_and_options_reach_the_service(model, local):
    options = EvaluationOptions(alignment="merger", out_of_domain="flag")
    batch = binaries(5) | {"mass_ratio": np.array([1.0, 0.5, 1.0, 0.1, 2.0])}
    there = model.predict_batch(FREQUENCIES, batch, options=options, dtype="complex64")
    assert same(there, local.predict_batch(FREQUENCIES, batch, options=options, dtype="complex64"))
    assert there.status.tolist() == [0, 2, 0, 2, 0]


def test_the_time_until_merger_equals_the_local_one(model, local):
    assert model.time_until_merger(40.0, ONE) == local.time_until_merger(40.0, ONE)


@pytest.mark.parametrize("method", METHODS)
def test_results_belong_to_the_user(model, method):
    answer = getattr(model, method)(FREQUENCIES, binaries(3))
    arrays = [getattr(answer, name) for name in type(answer).__slots__ if getattr(answer, name) is not None]
    assert all(array.flags.writeable and array.flags.aligned for array in arrays)


def test_a_grid_that_was_changed_in_place_is_another_grid(model, local):
    grid = LONG_GRID.copy()
    model.predict(grid, ONE)
    grid *= 0.5
    assert same(model.predict(grid, ONE), local.predict(grid, ONE))


def test_a_long_grid_is_uploaded_once_and_then_named(server, model):
    for _ in range(3):
        model.predict(LONG_GRID, ONE)
    assert [method for method, *_ in server.service.requests] == ["GET", "POST", "PUT", "POST", "POST", "POST"]


def test_a_short_grid_is_uploaded_when_it_is_used_again(server, model):
    for _ in range(4):
        model.predict(FREQUENCIES, ONE)
    assert [method for method, *_ in server.service.requests] == ["GET", "POST", "POST", "PUT", "POST", "POST", "POST"]
    assert len(server.service.grids) == 1


def test_a_tiny_grid_is_never_uploaded(server, model):
    for _ in range(3):
        model.predict(FREQUENCIES[:16], ONE)
    assert [method for method, *_ in server.service.requests] == ["GET", "POST", "POST", "POST"]


def test_a_short_grid_that_never_arrives_is_not_tried_again_each_time(server, model, local):
    server.service.grids = Forgetful()
    for _ in range(4):
        assert same(model.predict(FREQUENCIES, ONE), local.predict(FREQUENCIES, ONE))
    assert [method for method, *_ in server.service.requests][-2:] == ["POST", "POST"]
    assert len([method for method, *_ in server.service.requests if method == "PUT"]) == 3


def test_a_grid_that_the_service_forgot_is_uploaded_again(server, model, local):
    model.predict(LONG_GRID, ONE)
    server.service.grids.clear()
    assert same(model.predict(LONG_GRID, ONE), local.predict(LONG_GRID, ONE))


def test_a_grid_that_never_arrives_at_the_right_replica_travels_in_full(server, model, local):
    server.service.grids = Forgetful()
    assert same(model.predict(LONG_GRID, ONE), local.predict(LONG_GRID, ONE))


class Forgetful(dict):
    """A replica whose uploads the load balancer sends elsewhere."""

    def __setitem__(self, name, value):
        """Nothing arrives."""


class TestLargeBatches:
    @pytest.fixture
    def server(self, start_server):
        return start_server(ReferenceService(limits=Limits(max_rows=10, max_samples=500)))

    @pytest.mark.parametrize("method", METHODS)
    @pytest.mark.parametrize("parallel", [1, 3])
    def test_they_travel_in_pieces_and_equal_the_local_model(self, server, connect, local, method, parallel):
        model, batch = connect(server.address, parallel=parallel), binaries(64)
        assert same(getattr(model, method)(FREQUENCIES, batch), getattr(local, method)(FREQUENCIES, batch))
        assert max(server.service.evaluations()) <= 10

    def test_the_client_may_choose_smaller_pieces(self, server, connect):
        connect(server.address, chunk_samples=33 * 4).predict_batch(FREQUENCIES, binaries(10))
        assert sorted(server.service.evaluations())[:3] == [2, 4, 4]

    @pytest.mark.parametrize("row", [0, 9, 10, 37])
    def test_errors_name_the_row_of_the_users_batch(self, connect, server, row):
        batch = binaries(64)
        batch["mass_ratio"][row] = 0.5
        with pytest.raises(OutOfDomain, match=f"^Row {row}: ") as raised:
            connect(server.address).predict_batch(FREQUENCIES, batch)
        assert raised.value.errors[0].row == row

    def test_a_batch_with_an_error_is_refused_before_anything_is_evaluated(self, connect, server):
        batch = binaries(64)
        batch["mass_ratio"][63] = 0.5
        with pytest.raises(OutOfDomain):
            connect(server.address).predict_batch(LONG_GRID[:50], batch)
        assert sum(server.service.evaluations()) == 64  # on two frequencies, to check them

    def test_flagged_rows_are_where_the_user_put_them(self, connect, server, local):
        batch, options = binaries(64), EvaluationOptions(out_of_domain="flag")
        batch["mass_ratio"][[3, 40]] = 0.5
        answer = connect(server.address).predict_batch(FREQUENCIES, batch, options=options)
        assert same(answer, local.predict_batch(FREQUENCIES, batch, options=options))

    def test_limits_that_shrank_since_connecting_split_the_batch(self, connect, server, local):
        model, batch = connect(server.address), binaries(10)
        server.service.limits = Limits(max_rows=3)
        assert same(model.predict_batch(FREQUENCIES, batch), local.predict_batch(FREQUENCIES, batch))
        assert max(server.service.evaluations()[-4:]) <= 3

    def test_the_new_limits_are_remembered(self, connect, server):
        model = connect(server.address)
        server.service.limits = Limits(max_rows=5)
        model.predict_batch(FREQUENCIES, binaries(10))
        server.service.requests.clear()
        model.predict_batch(FREQUENCIES, binaries(10))
        assert max(server.service.evaluations()) == 5

    def test_a_grid_that_is_too_large_is_an_error_whatever_the_batch(self, connect, server):
        model = connect(server.address)
        server.service.limits = Limits(max_frequencies=20)
        with pytest.raises(TooLarge, match="at most 20 frequencies"):
            model.predict_batch(FREQUENCIES, binaries(10))


BAD_INPUT = {
    "misspelt": (FREQUENCIES, binaries(2) | {"lamda_1": 3.0}, InvalidParameters),
    "missing": (FREQUENCIES, {"mass_ratio": 1.0}, InvalidParameters),
    "unequal lengths": (FREQUENCIES, binaries(2) | {"chi_2": [0.0, 0.1, 0.2]}, InvalidParameters),
    "empty grid": ([], binaries(2), InvalidFrequencies),
    "unsorted grid": ([30.0, 20.0], binaries(2), InvalidFrequencies),
    "NaN in the grid": ([20.0, np.nan], binaries(2), InvalidFrequencies),
}


@pytest.mark.parametrize(("grid", "batch", "kind"), BAD_INPUT.values(), ids=BAD_INPUT)
def test_what_no_model_could_accept_is_refused_without_asking(server, model, local, grid, batch, kind):
    asked = len(server.service.requests)
    with pytest.raises(kind) as here:
        model.predict_batch(grid, batch)
    with pytest.raises(kind) as there:
        local.predict_batch(grid, batch)
    assert str(here.value) == str(there.value)
    assert len(server.service.requests) == asked
