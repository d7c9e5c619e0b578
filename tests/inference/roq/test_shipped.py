"""The bases that come with the package are for the model that comes with it."""

from pathlib import Path

import pytest

from bnserve_inference.roq import (
    BasisFileInvalid,
    load_shipped_basis,
    read_roq_configuration,
    shipped_bases,
    validate_basis,
)
from bnserve_surrogate import Model

CONFIGS = Path(__file__).parents[3] / "configs"


@pytest.mark.parametrize("name", shipped_bases())
def test_a_shipped_basis_is_what_its_configuration_asks_for(name):
    basis, configuration = load_shipped_basis(name), read_roq_configuration(CONFIGS / f"roq_{name}.toml")
    band = configuration.band
    assert (basis.f_min, basis.f_max, basis.duration, basis.alignment) == (
        band.f_min,
        band.f_max,
        band.duration,
        band.alignment,
    )
    assert dict(basis.prior) == configuration.prior.ranges
    for term in ("linear", "quadratic"):
        tolerance = getattr(configuration, term).tolerance
        validation = basis.diagnostics["validation"][term]
        assert (basis.diagnostics[term]["tolerance"], validation["tolerance"]) == (tolerance, tolerance)
        assert validation["count"] == configuration.validation.count == 500_000
        assert validation["outlier_fraction"] < 1e-3
        assert validation["above_limit"] == 0
        assert basis.diagnostics["edges"][term]["outlier_fraction"] < 1e-3


@pytest.mark.parametrize("name", shipped_bases())
def test_a_shipped_basis_meets_its_tolerance_with_the_shipped_model(name):
    """Fails if the model is replaced: build the basis again, then."""
    for figures in validate_basis(load_shipped_basis(name), Model.default(), 4).values():
        assert figures["outliers"] == 0
        assert 0.0 < figures["max"] < figures["tolerance"]


def test_there_are_two_precisions_for_gw170817():
    assert shipped_bases() == ["gw170817", "gw170817_fine"]


def test_an_unknown_name_lists_those_there_are():
    with pytest.raises(BasisFileInvalid, match="gw170817, gw170817_fine"):
        load_shipped_basis("gw150914")
