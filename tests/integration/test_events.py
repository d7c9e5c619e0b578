"""An event whose likelihood a server evaluates: the posterior is that of a model in this process."""

import bilby
import numpy as np
import pytest

from bnserve_service.cli import main
from tests.posterior.networks import TOML


@pytest.mark.filterwarnings("ignore:.*Global meta data:UserWarning")
def test_a_server_and_this_process_have_one_posterior(bnserve_server, tmp_path):
    found = []
    for name, model in (("here", ""), ("there", f'[model]\nurl = "{bnserve_server.address}"\n')):
        path = tmp_path / f"{name}.toml"
        path.write_text(TOML.replace("checks = 50", "checks = 0").replace("[sampler]", f"{model}[sampler]"))
        folder = tmp_path / name
        assert main(["analyse", str(path), "--output", str(folder), "--no-report", "--no-progress"]) == 0
        found.append(bilby.gw.result.CBCResult.from_json(str(folder / f"{name}_result.json")))
    here, there = found
    assert there.log_bayes_factor == pytest.approx(here.log_bayes_factor, abs=1e-6)
    assert np.allclose(there.posterior["luminosity_distance"], here.posterior["luminosity_distance"])
