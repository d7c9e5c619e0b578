"""A network for the components and a polynomial for the scalars beside them; components of comparable variance."""

import numpy as np
import pytest

from bnserve_surrogate.training.reduction.reductions import PaperReduction
from bnserve_surrogate.training.regressors import (
    MLP,
    Beside,
    ChebyshevPolynomial,
    NotExportable,
    export_regressor,
)
from tests.surrogate.plain_reference import evaluate_exported

POINTS = np.random.default_rng(1).uniform(-1.0, 1.0, (200, 5))
COMPONENTS = np.column_stack([POINTS[:, 0] * POINTS[:, 1], POINTS[:, 2], np.sin(POINTS[:, 3])])
SCALARS = 1e4 * np.column_stack([POINTS[:, 0] ** 2, POINTS[:, 4] - 3.0])


def beside(first=None):
    network = MLP((8,), batch_size=20, max_iter=30, tol=1.0, n_iter_no_change=25)
    return Beside(first or network, ChebyshevPolynomial(degree=2.0, weights=(1.0,) * 5), n_first=3)


def test_large_scalars_do_not_change_what_the_network_learns():
    fitted = beside().fit(POINTS, np.hstack([COMPONENTS, SCALARS]))
    alone = beside().first.fit(POINTS, COMPONENTS)
    np.testing.assert_array_equal(fitted.predict(POINTS)[:, :3], alone.predict(POINTS))
    np.testing.assert_allclose(fitted.predict(POINTS)[:, 3:], SCALARS, rtol=0, atol=1e-7)


def test_the_exported_arrays_give_the_same_outputs():
    fitted = beside().fit(POINTS, np.hstack([COMPONENTS, SCALARS]))
    arrays = export_regressor(fitted).arrays
    np.testing.assert_allclose(evaluate_exported(arrays, POINTS), fitted.predict(POINTS), rtol=1e-12, atol=1e-9)


def test_two_networks_cannot_be_exported():
    both = Beside(beside().first, beside().first, n_first=3).fit(POINTS, np.hstack([COMPONENTS, POINTS[:, :2]]))
    with pytest.raises(NotExportable):
        export_regressor(both)


def test_there_must_be_outputs_for_both():
    with pytest.raises(ValueError, match="more than 3 outputs"):
        beside().fit(POINTS, COMPONENTS)


def test_the_papers_components_have_comparable_size_before_the_power_of_their_eigenvalue():
    sizes = np.array([1e3, 1.0, 1e-3])
    residuals = (COMPONENTS * sizes) @ np.linalg.qr(np.random.default_rng(2).normal(size=(10, 3)))[0].T
    plain = PaperReduction(3, 0.0).fit(residuals[:, :4], residuals[:, 4:])
    np.testing.assert_allclose(np.abs(plain.transform(residuals[:, :4], residuals[:, 4:]).components).max(axis=0), 1.0)
    scaled = PaperReduction(3, 0.37).fit(residuals[:, :4], residuals[:, 4:])
    largest = np.abs(scaled.transform(residuals[:, :4], residuals[:, 4:]).components).max(axis=0)
    np.testing.assert_allclose(largest, scaled.principal_components_.eigenvalues_**0.37)
