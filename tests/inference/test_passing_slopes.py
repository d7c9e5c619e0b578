"""How the times at which modes pass a whole grid change with the binary: by differences, and what that leaves."""

import numpy as np
import pytest

from bnserve_inference import likelihood
from bnserve_inference._gradients import Gradients
from bnserve_inference._passing import passing_times
from bnserve_protocol import DERIVATIVE_NAMES, LikelihoodBatch, ParameterBatch
from bnserve_surrogate import Model
from tests.inference.networks import columns, full, network
from tests.inference.test_likelihood_gradients import CENTRAL

STEPS = {"mass_ratio": 1e-5, "lambda_1": 2.0, "lambda_2": 2.0, "chi_1": 1e-4, "chi_2": 1e-4, "total_mass": 1e-6}


@pytest.fixture(scope="module")
def bound():
    model = Model.default()
    return likelihood(model, full(network(model, response="moving"), response="moving"))


def by_differences(gradients, batch, frequencies):
    """Of the times themselves by the parameters, of fourth order: ``(N, G, 6, M)``."""
    found = []
    for name in DERIVATIVE_NAMES:
        total = 0.0
        for place, weight in CENTRAL:
            moved = ParameterBatch(batch.waveform_batch().values.copy())
            moved[name][:] += place * STEPS[name]
            how = gradients._modes, gradients._settings.alignment
            total = total + weight / STEPS[name] * passing_times(
                gradients._differentiate.__self__, moved, frequencies, *how
            )
        found.append(total)
    return np.stack(found, axis=2)


def test_the_gradient_is_that_of_slopes_by_the_parameters_themselves(bound, monkeypatch):
    """To 1e-10, because what the Earth turns by is a millionth of a gradient; the slopes are off at the band's ends."""
    batch = LikelihoodBatch.coerce(columns(4, width=0.25))
    own, add, held = bound.gradients(batch), Gradients._add_passing, {}

    def instead(self, found, bars, waves):
        alone = np.zeros_like(waves)
        add(self, found, bars, alone)
        held["ours"] = found.pull_back(alone)
        held["exact"] = np.einsum("ngm,ngpm->np", bars, by_differences(self, batch, found.frequencies))

    monkeypatch.setattr(Gradients, "_add_passing", instead)
    without = bound.gradients(batch)
    assert np.abs(held["ours"] - held["exact"]).max() <= 1e-5 * np.abs(held["exact"]).max()
    for place, name in enumerate(DERIVATIVE_NAMES):
        ours, none = (each.gradient[:, own.names.index(name)] for each in (own, without))
        expected = none + held["exact"][:, place]
        assert np.abs(ours - expected).max() <= 1e-10 * np.abs(expected).max(), name
        assert np.abs(none - expected).max() > 1e3 * np.abs(ours - expected).max(), name
