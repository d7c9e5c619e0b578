"""Likelihoods of a model of several modes: the remote ones equal the local one in bits and errors."""

import sys

import msgspec
import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_inference import likelihood
from bnserve_protocol import Analysis, AnalysisInvalid, LikelihoodBatch, likelihood_samples
from bnserve_surrogate import Model as LocalModel
from tests.contract.test_likelihood import DETECTORS, FAR, SUMS, batch_for, with_nodes
from tests.running_server import free_port, is_ready, running
from tests.service.injections import small_analysis

ALONE = ((2, 2),)


@pytest.fixture(scope="module")
def local():
    """The shipped default model."""
    return LocalModel.default()


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    """A server of it, in a process of its own."""
    port = free_port()
    where = f"http://127.0.0.1:{port}"
    command = [sys.executable, "-m", "bnserve_service", "serve", "--port", str(port)]
    log = tmp_path_factory.mktemp("contract") / "server.log"
    with running(command, log, lambda: is_ready(where)):
        yield where


@pytest.fixture(scope="module")
def remote(address):
    with RemoteModel.connect(address, "default") as model:
        yield model


def with_orders(model, **settings):
    """As :func:`with_nodes`, of all modes of the model: of each order its weights, and of each pair of orders."""
    modes = tuple(sorted(model.description.modes))
    orders = len({order for _, order in modes})
    assert orders > 1
    one = with_nodes("relative_binning")
    random, arrays = np.random.default_rng(6), dict(one.arrays)
    nodes = arrays["quadratic_nodes"] = arrays["linear_nodes"]
    for name in DETECTORS:
        parts = random.normal(size=(2, 31, orders * len(nodes))) * 1e23
        arrays[f"linear_weights/{name}"] = parts[0] + 1j * parts[1]
        parts = random.uniform(0.5, 1.0, (2, orders * (orders + 1) // 2, len(nodes))) * 1e45
        arrays[f"quadratic_weights/{name}"] = parts[0] + 1j * parts[1]
    return Analysis(settings=msgspec.structs.replace(one.settings, modes=modes, **settings), arrays=arrays)


ANALYSES = {
    "bins": with_orders,
    "bins, phase and distance": lambda model: with_orders(
        model, phase_marginalisation=True, distance_marginalisation=FAR
    ),
    "bins and time": lambda model: with_orders(model, time_marginalisation=SUMS),
    "bins of before": lambda _: with_nodes("relative_binning"),
    "full grid": lambda _: small_analysis(detectors=DETECTORS, f_max=256.0),
    "full grid and phase": lambda _: small_analysis(f_max=256.0, phase_marginalisation=True),
    "some modes of the full grid": lambda _: small_analysis(f_max=256.0, modes=((2, 1), (2, 2), (3, 3))),
    "one mode of the full grid": lambda _: small_analysis(f_max=256.0, modes=ALONE),
}


@pytest.fixture(params=ANALYSES.values(), ids=ANALYSES)
def analysis(request, local):
    return request.param(local)


def test_values_are_equal_in_bits_and_finite(local, remote, analysis):
    batch = batch_for(analysis)
    here, there = (likelihood(model, analysis).evaluate(batch) for model in (local, remote))
    assert there.log_likelihood.tobytes() == here.log_likelihood.tobytes()
    assert there.status.tobytes() == here.status.tobytes()
    assert np.isfinite(here.log_likelihood).all()


def test_a_row_has_the_same_bits_alone_and_in_a_batch(remote, analysis):
    batch, bound = batch_for(analysis), likelihood(remote, analysis)
    together = bound.log_likelihood(batch)
    assert (np.concatenate([bound.log_likelihood(row) for row in batch.split(5)]) == together).all()


def test_all_modes_of_the_full_grid_are_more_than_one(local):
    batch = batch_for(small_analysis())
    everything, alone = (likelihood(local, small_analysis(modes=modes)).log_likelihood(batch) for modes in
                         (tuple(local.description.modes), ALONE))  # fmt: skip
    unnamed = likelihood(local, small_analysis()).log_likelihood(batch)
    np.testing.assert_allclose(unnamed, everything, rtol=1e-12)
    assert np.abs(unnamed - alone).max() > 1e-6


def test_a_mode_that_the_model_lacks_is_the_same_error(local, remote):
    analysis = small_analysis(modes=((2, 2), (5, 5)))
    said = []
    for model in (local, remote):
        with pytest.raises(AnalysisInvalid, match=r"modes that default .* lacks: \(5, 5\)") as error:
            likelihood(model, analysis)
        said.append((error.value.detail, error.value.errors))
    assert said[0] == said[1]


def test_named_modes_count_in_what_one_request_may_ask_for(remote):
    """A batch that is too large for one request is split by the client, whose count is the server's."""
    analysis = small_analysis(f_max=1024.0, modes=((2, 1), (2, 2), (3, 3)))
    assert likelihood_samples(analysis) == 3 * likelihood_samples(small_analysis(f_max=1024.0, modes=ALONE))
    rows = 2 + 2**24 // likelihood_samples(analysis)
    batch = LikelihoodBatch(np.repeat(batch_for(analysis, 1).values, rows, axis=0))
    values = likelihood(remote, analysis).log_likelihood(batch)
    assert (values == values[0]).all()
