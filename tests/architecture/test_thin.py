"""What an import brings in, and what it must not: each import in an interpreter of its own."""

import pytest

from tests.architecture.rooms import room_environment, run_python

SERVING = {"fastapi", "pydantic", "starlette", "uvicorn"}
TRAINING = {
    "EOBRun_module",
    "jax",
    "joblib",
    "lal",
    "lalsimulation",
    "matplotlib",
    "numba",
    "optuna",
    "ray",
    "scipy",
    "sklearn",
}
NUMERICS = {"llvmlite", "safetensors"}
OTHER_ROOMS = {
    "bnserve_inference", "bnserve_jax", "bnserve_posterior", "bnserve_service", "bnserve_store", "bnserve_surrogate",
}  # fmt: skip

EVALUATE_DEFAULT_MODEL = """
from bnserve_surrogate import Model, ParametersWithExtrinsic
Model.default().predict([20.0, 30.0], ParametersWithExtrinsic.gw170817())
"""

EVALUATE_A_LIKELIHOOD = """
from bnserve_inference import likelihood
from tests.service.chirp import ChirpModel
from tests.service.injections import samples, small_analysis
likelihood(ChirpModel(), small_analysis()).log_likelihood(samples(3))
"""

BANNED = {
    "import bnserve_protocol": SERVING | TRAINING | NUMERICS | OTHER_ROOMS | {"bnserve_client", "httpx"},
    "import bnserve_store": SERVING | TRAINING | {"httpx", "bnserve_surrogate"},
    "import bnserve_client": SERVING | TRAINING | NUMERICS | OTHER_ROOMS | {"bilby", "pycbc"},
    "import bnserve_client.compat.mlgw_bns": SERVING | TRAINING | NUMERICS | OTHER_ROOMS,
    "import bnserve_client.gwfish": SERVING | TRAINING | NUMERICS | OTHER_ROOMS | {"GWFish"},
    "import bnserve_client.pycbc": SERVING | TRAINING | NUMERICS | OTHER_ROOMS | {"bilby", "pycbc"},
    "import bnserve_surrogate": SERVING | TRAINING | {"bnserve_client", "bnserve_service", "httpx"},
    "import bnserve_service": TRAINING,
    EVALUATE_DEFAULT_MODEL: SERVING | TRAINING | {"bnserve_client", "bnserve_service", "httpx"},
}


def modules_after(code: str) -> set[str]:
    """The top-level modules that are loaded after running ``code``."""
    return set(run_python(f"{code}\nimport sys\nprint(*{{name.partition('.')[0] for name in sys.modules}})").split())


@pytest.mark.parametrize("code", BANNED, ids=[code.strip().splitlines()[-1] for code in BANNED])
def test_an_import_brings_in_nothing_heavy(code):
    assert modules_after(code) & BANNED[code] == set()


def test_the_check_sees_what_an_import_brings_in():
    assert {"bnserve_surrogate", "llvmlite"} <= modules_after("import bnserve_surrogate")


def run_without(absent: set[str], code: str, **options) -> None:
    """Run code where the import of some modules fails, as if they were not installed."""
    run_python(f"import sys; sys.modules.update(dict.fromkeys({sorted(absent)}))\n{code}", **options)


def test_the_client_needs_no_room_but_the_protocol():
    absent = OTHER_ROOMS | SERVING | TRAINING | NUMERICS
    run_without(absent, "import bnserve_client", env=room_environment("protocol", "client"))


@pytest.mark.parametrize(
    "code",
    ["import bnserve_service", EVALUATE_DEFAULT_MODEL, EVALUATE_A_LIKELIHOOD],
    ids=["service", "evaluation", "likelihood"],
)
def test_serving_needs_nothing_of_training(code):
    run_without(TRAINING, code)


def test_an_absent_module_is_absent():
    with pytest.raises(AssertionError, match="scipy"):
        run_without({"scipy"}, "import scipy")
