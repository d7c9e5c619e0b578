"""Gradients of likelihoods through a service: by other names, and without our client."""

import httpx

from bnserve_client import Model as RemoteModel
from bnserve_inference import likelihood
from bnserve_protocol import LIKELIHOOD_NAMES
from tests.service.injections import SIGNAL, samples, small_analysis


def test_a_table_by_the_names_of_bilby(address, local):
    analysis, batch = small_analysis(local, f_max=64.0), samples(3)
    table = {name: batch[name] for name in LIKELIHOOD_NAMES if name not in ("total_mass", "distance_mpc")}
    table |= {"luminosity_distance": batch["distance_mpc"], "chirp_mass": 0.43 * batch["total_mass"]}
    here = likelihood(local, analysis).gradients(table)
    with RemoteModel.connect(address) as model:
        found = model.likelihood(analysis).gradients(table)
    assert found.names == here.names == tuple(table)
    assert found.gradient.tobytes() == here.gradient.tobytes()


def test_without_our_client(address, local):
    analysis = small_analysis(local, f_max=64.0)
    parameters = SIGNAL | {"mass_ratio": [1.2, 9.0]}
    here = likelihood(local, analysis).gradients(parameters)
    with RemoteModel.connect(address) as model:  # which uploads it
        assert model.likelihood(analysis).gradients(parameters).gradient.tobytes() == here.gradient.tobytes()
    url = f"{address}/v1/models/default/likelihoods/{analysis.digest.removeprefix('sha256:')}"
    asked = {"parameters": parameters, "output": "gradients"}
    told = httpx.post(url, json=asked, headers={"Accept": "application/json"}).json()
    assert tuple(told["gradient_names"]) == here.names
    assert told["gradient"] == [here.gradient[0].tolist(), [None] * len(here.names)]
    assert told["log_likelihood"] == [here.log_likelihood[0], None]
