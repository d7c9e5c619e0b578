"""A Ray cluster of two nodes on this machine."""

import gc
import os
import warnings

import pytest

from tests.architecture.rooms import ROOT, room_environment

ENVIRONMENT = {
    "RAY_USAGE_STATS_ENABLED": "0",
    "RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO": "0",  # or it warns
    "RAY_prestart_worker_first_driver": "0",  # workers are started when they are needed, which is less work
    "RAY_enable_worker_prestart": "0",
}
NODE = {"num_cpus": 2, "object_store_memory": 100 * 2**20, "include_dashboard": False}


def two_nodes():
    """A cluster that has started: Ray gives a node half a minute, which a very busy machine may exceed."""
    from ray.cluster_utils import Cluster

    for attempts_left in (2, 1, 0):
        cluster = Cluster()
        try:
            for _ in range(2):
                cluster.add_node(**NODE)
        except Exception:
            cluster.shutdown()
            if not attempts_left:
                raise
        else:
            return cluster


@pytest.fixture(scope="package")
def ray_cluster():
    """Two nodes with two processors each, to which this process is connected."""
    path = os.pathsep.join([str(ROOT), room_environment()["PYTHONPATH"]])
    with pytest.MonkeyPatch.context() as patch, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name, value in (ENVIRONMENT | {"PYTHONPATH": path}).items():  # which the workers inherit
            patch.setenv(name, value)
        import ray

        cluster = two_nodes()
        ray.init(address=cluster.address, log_to_driver=False)
    yield cluster
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        ray.shutdown()
        cluster.shutdown()
        gc.collect()  # now, or what Ray leaves open is held against a later test
