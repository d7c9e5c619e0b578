"""A small search on toy waveforms, for the tests of the search."""

from bnserve_surrogate.training.config import parse_configuration
from bnserve_surrogate.training.search.trials import Search, run_search

WAVEFORMS = 400

POLYNOMIAL = {"kind": "polynomial", "coordinates": "physical"}
SUM = {"kind": "sum", "coordinates": "physical", "polynomial": {"degree": 3}, "network": {"max_iter": 30}}
NETWORK = {"kind": "network", "coordinates": "raw", "network": {"max_iter": 30}}


def table(regressor=None, **changes):
    """A configuration as nested dictionaries."""
    regressor = regressor or POLYNOMIAL
    reduction = "metric" if regressor["coordinates"] == "physical" else "paper"
    return {
        "name": "toy",
        "version": "1.0.0",
        "generator": {"name": "callable", "options": {"path": "tests.surrogate.toy_waveforms:toy", "release": "1"}},
        "ranges": {"frequency_band": [20.0, 1000.0]},
        "nodes": {"count": 40},
        "dataset": {"count": WAVEFORMS},
        "reduction": {"kind": reduction, "components": 10},
        "regressor": regressor,
        **changes,
    }


def toy_search(study, regressor=None, **changes):
    return Search(parse_configuration(table(regressor, **changes)), study)


def run(search, work, **options):
    """Returns the lines it said."""
    said = []
    run_search(search, work, n_jobs=1, backend="sequential", progress=False, say=said.append, **options)
    return [line for line in said if line.startswith("Trial")]
