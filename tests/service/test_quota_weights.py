"""What a row of each question counts as in the quotas of a token."""

import json
import re

import pytest

from bnserve_service import Token
from bnserve_surrogate import Model
from tests.service.asking import GW170817, JSON, ask
from tests.service.injections import SIGNAL, name_of, small_analysis, upload
from tests.service.networks import BINARY, network, put

ANALYSIS = small_analysis(phase_marginalisation=True)
MINE = {"authorization": "Bearer the-token-of-mine"}
LIKELIHOOD = {name: value for name, value in SIGNAL.items() if name != "reference_phase"}
WAVEFORM = {"parameters": GW170817, "grid": {"frequencies": [50.0, 100.0]}}
FISHER = {"parameters": BINARY, "modes": [[2, 2]]}


@pytest.fixture
def address(start):
    server = start(Model.default(), tokens=(Token.of("the-token-of-mine", rows_per_day=10_000),), max_samples=2**24)
    assert upload(server.address, ANALYSIS, **MINE).status == 201
    return server.address


def charged(address, path, asked):
    """Rows of the day that a question takes."""
    left = []
    for body in (WAVEFORM, asked):
        at = "/v1/models/default/waveforms" if body is WAVEFORM else path
        answer = ask(address, "POST", at, json.dumps(body), content_type=JSON, **MINE)
        assert answer.status == 200, answer.body
        left.append(int(re.search(r'"day";r=(\d+)', answer.headers["ratelimit"])[1]))
    return left[0] - left[1]


def test_what_costs_more_than_a_waveform_counts_as_several(address):
    of_waveforms = "/v1/models/default/waveforms"
    assert charged(address, of_waveforms, WAVEFORM) == 1
    three = WAVEFORM | {"parameters": GW170817 | {"total_mass": [2.7, 2.8, 2.9]}}
    assert charged(address, of_waveforms, three) == 3
    assert charged(address, of_waveforms, three | {"output": "derivatives"}) == 21
    of_likelihoods = f"/v1/models/default/likelihoods/{name_of(ANALYSIS)}"
    pair = LIKELIHOOD | {"distance_mpc": [40.0, 41.0]}
    assert charged(address, of_likelihoods, {"parameters": pair}) == 2
    assert charged(address, of_likelihoods, {"parameters": pair, "output": "gradients"}) == 8
    assert charged(address, of_likelihoods, {"parameters": pair | {"reference_phase": 0.1}, "output": "products"}) == 4
    one = {"name": f"default/{name_of(ANALYSIS)}", "input": [list(LIKELIHOOD.values())]}
    assert charged(address, "/v1/umbridge/Evaluate", one) == 1
    assert charged(address, "/v1/umbridge/Gradient", one | {"outWrt": 0, "inWrt": 0, "sens": [1.0]}) == 4


def test_forecasts_count_by_their_work(address):
    """One row for every 4,096 samples of it, or part of them: the figures of the guide."""
    answer, sha256 = put(address, network(f_min=5.0, f_max=2048.0), **MINE)
    assert answer.status == 201
    path = f"/v1/models/default/forecasts/{sha256}"
    rows = FISHER | {"parameters": BINARY | {"distance_mpc": [40.0, 41.0]}}
    assert charged(address, path, rows) == 2 * 6
    assert charged(address, path, rows | {"output": "snr"}) == 2 * 3
    assert charged(address, path, {"parameters": BINARY}) == 50
    assert charged(address, path, {"parameters": BINARY, "output": "snr"}) == 20
