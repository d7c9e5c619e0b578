"""The service on a Ray cluster: the same answers, and a replica that is killed costs none."""

import os
import signal
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

from bnserve_client import Model, OutOfDomain, ParametersWithExtrinsic
from bnserve_service.errors import SettingsInvalid
from bnserve_service.settings import Settings
from bnserve_surrogate import Model as LocalModel
from tests.running_server import free_port

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore")]  # Ray warns about its own modules

FREQUENCIES = np.geomspace(20.0, 2000.0, 1000)
ONE = ParametersWithExtrinsic.gw170817()


@pytest.fixture(scope="module")
def address(ray_cluster):
    """Two replicas, one on each node, behind one of Ray's proxies."""
    from ray import serve

    from bnserve_service.ray_serve import Arguments, app

    port = free_port()
    serve.start(http_options={"port": port, "location": "HeadOnly"})
    serve.run(app(Arguments(max_replicas=2, cpus=0.5, settings={"models": ["default"]})), name="bnserve")
    yield f"http://127.0.0.1:{port}"
    serve.shutdown()


def replicas() -> list[int]:
    """The processes of the replicas that this process' cluster started."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            named = (folder / "cmdline").read_bytes().startswith(b"ray::ServeReplica:bnserve:bnserve")
            parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
            ours = os.getpid() == int(Path(f"/proc/{parent}/stat").read_text().rpartition(")")[2].split()[1])
        except (OSError, ValueError, IndexError):
            continue
        found += [int(folder.name)] if named and ours else []
    return found


def test_answers_are_those_of_the_local_model(address):
    local = LocalModel.default()
    with Model.connect(address) as model:
        for count in (1, 100):
            batch = [ONE] * count
            assert (
                model.predict_batch(FREQUENCIES, batch).plus.tobytes()
                == local.predict_batch(FREQUENCIES, batch).plus.tobytes()
            )
        with pytest.raises(OutOfDomain):
            model.predict(FREQUENCIES, replace(ONE, mass_ratio=50.0))


def test_a_killed_replica_loses_nothing(address):
    right = LocalModel.default().predict_batch(FREQUENCIES, [ONE] * 16).plus.tobytes()
    before = replicas()
    assert len(before) == 2
    with Model.connect(address) as model, ThreadPoolExecutor(4) as threads:
        answers = [threads.submit(model.predict_batch, FREQUENCIES, [ONE] * 16) for _ in range(120)]
        answers[20].result()
        os.kill(before[0], signal.SIGKILL)
        assert [number for number, answer in enumerate(answers) if answer.result().plus.tobytes() != right] == []
        assert before[0] not in replicas()


def test_a_setting_that_is_none_is_refused_before_anything_starts(ray_cluster):
    from bnserve_service.ray_serve import Arguments, app

    with pytest.raises(SettingsInvalid, match="Did you mean 'max_rows'"):
        app(Arguments(settings={"max_row": 3}))


def test_the_configuration_that_ships_is_understood():
    from ray.serve.schema import ServeDeploySchema

    from bnserve_service.ray_serve import Arguments, app

    file = Path(__file__).parents[2] / "deploy" / "ray" / "serve.yaml"
    deployed = ServeDeploySchema.model_validate(yaml.safe_load(file.read_text()))
    (application,) = deployed.applications
    assert application.import_path == f"{app.__module__}:app"
    assert deployed.http_options.keep_alive_timeout_s == Settings().keep_alive
    app(Arguments.model_validate(application.args))
