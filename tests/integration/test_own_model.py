"""A user's own model, from a copied configuration to a running server: ``docs/guides/own_model.md`` in short."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from bnserve_client import Model as RemoteModel
from bnserve_protocol import ModelUnknown, OutOfDomain
from bnserve_surrogate import Model, ParametersWithExtrinsic
from tests.integration.conftest import bnserve, serving
from tests.integration.test_server_process import until

pytestmark = pytest.mark.slow
pytest.importorskip("EOBRun_module")

CONFIGURATION = Path(__file__).parents[2] / "configs" / "default.toml"
CHANGES = {
    'name = "default"': 'name = "mine"',
    'version = "2.0.0"': 'version = "1.0.0"',
    "mass_ratio = [1.0, 3.0]": "mass_ratio = [1.0, 1.5]",
    "frequency_band = [5.0,": "frequency_band = [20.0,",
    "count = 170 #": "count = 60 #",
    "count = 16384": "count = 250",
    "edge_count = 1024 #": "edge_count = 30 #",
    "components = 27": "components = 10",
    "degree = 10\n": "degree = 4.5\n",
    "terms = 760": "terms = 80",
    "degree = 6, terms = 120": "degree = 3, terms = 12",
    "degree = 7, terms = 200": "degree = 3, terms = 12",
    "\ncount = 1024\nedge_count = 1024": "\ncount = 8\nedge_count = 4",
}
"""What is changed in the copy; the guide changes the first two, the number of waveforms, and of those to measure on."""
FREQUENCIES = np.geomspace(20.0, 1500.0, 60)
BINARY = ParametersWithExtrinsic(mass_ratio=1.3, chi_1=0.1, chi_2=-0.2, lambda_1=300.0, lambda_2=900.0,
                                 distance_mpc=40.0, inclination=0.4, total_mass=2.9)  # fmt: skip


@pytest.fixture
def configuration(tmp_path):
    """A copy of ``configs/default.toml``, edited line by line as a user would."""
    text = CONFIGURATION.read_text()
    for old, new in CHANGES.items():
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path = tmp_path / "mine.toml"
    path.write_text(text)
    return path


def test_the_running_server_serves_what_was_just_trained(tmp_path, configuration):
    store = tmp_path / "models"
    store.mkdir()
    with (
        serving(tmp_path / "log", "--store", str(store)) as server,
        RemoteModel.connect(server.address, "default") as other,
    ):
        with pytest.raises(ModelUnknown):
            RemoteModel.connect(server.address, "mine").close()

        trained = bnserve(
            "train", str(configuration), "--store", str(store), "--work", str(tmp_path / "runs"), "--no-progress"
        )
        assert trained.returncode == 0, trained.stderr
        assert "Published mine 1.0.0" in trained.stdout
        until(lambda: "mine 1.0.0" in server.log.read_text(), "the server has seen the new model")

        with RemoteModel.connect(server.address, "mine") as mine:
            local = Model.load("mine", store=store)
            assert mine.description.digest == local.description.digest
            served, expected = mine.predict(FREQUENCIES, BINARY), local.predict(FREQUENCIES, BINARY)
            np.testing.assert_array_equal(served.plus, expected.plus)
            np.testing.assert_array_equal(served.cross, expected.cross)
            with pytest.raises(OutOfDomain, match="mass_ratio"):
                mine.predict(FREQUENCIES, replace(BINARY, mass_ratio=1.6))
        assert other.predict(FREQUENCIES, BINARY).plus.shape == FREQUENCIES.shape  # all the while
