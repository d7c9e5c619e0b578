"""Regressors: what they represent exactly, how they prune and screen, and that the export is what was fitted."""

import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone
from sklearn.exceptions import ConvergenceWarning
from sklearn.neighbors import KNeighborsRegressor
from sklearn.neural_network import MLPRegressor

from bnserve_protocol import InvalidParameters
from bnserve_surrogate.training.regressors import (
    MLP,
    ChebyshevPolynomial,
    ExportedRegressor,
    NotExportable,
    Sum,
    chebyshev_terms,
    export_regressor,
    weighted_exponents,
)
from tests.surrogate.plain_reference import evaluate_exported

RNG = np.random.default_rng(0)
POINTS = RNG.uniform(-1, 1, size=(900, 5))
SMOOTH = np.stack([np.exp(0.5 * POINTS @ RNG.normal(size=5)), np.tanh(POINTS @ RNG.normal(size=5))], axis=1)


def quick_mlp(**options):
    return MLP(hidden_layer_sizes=(7, 6), max_iter=5, **options)


def fitted(regressor, points=POINTS, outputs=SMOOTH):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)  # Five epochs never converge, and need not.
        return regressor.fit(points, outputs)


# --- the basis


@pytest.mark.parametrize(("degree", "terms"), [(8, 706), (9, 1097)])
def test_the_number_of_terms_of_the_default_weights(degree, terms):
    assert len(weighted_exponents(degree, (1, 0.8, 1, 1.5, 1.5))) == terms


@given(st.integers(0, 5), st.integers(1, 4))
def test_equal_weights_give_total_degree(degree, dimension):
    exponents = weighted_exponents(degree, (1.0,) * dimension)
    assert (exponents.sum(axis=1) <= degree).all()
    assert len(np.unique(exponents, axis=0)) == len(exponents)
    binomial = np.prod([(degree + i) / i for i in range(1, dimension + 1)])
    assert len(exponents) == round(binomial)


def test_terms_are_products_of_cosines():
    angles = RNG.uniform(0, np.pi, size=(20, 3))
    exponents = np.array([[0, 0, 0], [3, 0, 1], [7, 2, 4]], dtype=np.uint8)
    expected = np.cos(angles[:, None, :] * exponents).prod(axis=2).T
    np.testing.assert_allclose(chebyshev_terms(np.cos(angles), exponents), expected, atol=1e-13)


@pytest.mark.parametrize(
    ("degree", "weights"), [(-1, (1.0,)), (3, (0.0, 1.0)), (3, ()), (70, (1.0,)), (np.inf, (1.0,))]
)
def test_impossible_degrees_are_refused(degree, weights):
    with pytest.raises(InvalidParameters, match="degree"):
        weighted_exponents(degree, weights)


# --- polynomials


@given(st.integers(0, 1000), st.floats(0.5, 4.0))
@settings(max_examples=15, deadline=None)
def test_polynomials_within_the_space_are_found_exactly(seed, degree):
    rng = np.random.default_rng(seed)
    exponents = weighted_exponents(degree, (1, 0.8, 1, 1.5, 1.5))
    coefficients = rng.normal(size=(len(exponents), 3))
    outputs = chebyshev_terms(POINTS, exponents).T @ coefficients
    polynomial = ChebyshevPolynomial(degree).fit(POINTS, outputs)
    np.testing.assert_allclose(polynomial.coefficients_, coefficients, atol=1e-11)
    assert not len(polynomial.outliers_)


def test_the_fit_is_the_least_squares_solution():
    polynomial = ChebyshevPolynomial(4, outlier_factor=None).fit(POINTS, SMOOTH)
    terms = chebyshev_terms(POINTS, polynomial.exponents_).T
    expected = np.linalg.lstsq(terms, SMOOTH, rcond=None)[0]
    np.testing.assert_allclose(polynomial.coefficients_, expected, atol=1e-12)


def test_pruning_keeps_exactly_the_terms_that_are_there():
    exponents = weighted_exponents(4, (1, 0.8, 1, 1.5, 1.5))
    present = np.sort(RNG.permutation(len(exponents))[:12])
    coefficients = RNG.normal(size=(12, 2)) + 2.0
    outputs = chebyshev_terms(POINTS, exponents[present]).T @ coefficients + 1e-6 * RNG.normal(size=(900, 2))
    polynomial = ChebyshevPolynomial(4, n_terms=12).fit(POINTS, outputs)
    np.testing.assert_array_equal(polynomial.exponents_, exponents[present])
    np.testing.assert_allclose(polynomial.coefficients_, coefficients, atol=1e-6)


def test_pruning_beats_a_lower_degree_with_as_many_terms():
    few = ChebyshevPolynomial(3, outlier_factor=None).fit(POINTS[:700], SMOOTH[:700])
    pruned = ChebyshevPolynomial(5, n_terms=len(few.exponents_), outlier_factor=None).fit(POINTS[:700], SMOOTH[:700])
    assert len(pruned.exponents_) == len(few.exponents_)
    errors = [np.mean((model.predict(POINTS[700:]) - SMOOTH[700:]) ** 2) for model in (few, pruned)]
    assert errors[1] < 0.7 * errors[0]


def test_removing_one_term_removes_the_one_that_costs_least():
    weights = np.array([1.0, 100.0])
    full = ChebyshevPolynomial(2, outlier_factor=None).fit(POINTS[:80], SMOOTH[:80])
    terms = chebyshev_terms(POINTS[:80], full.exponents_).T

    def loss(kept):
        residual = SMOOTH[:80] - terms[:, kept] @ np.linalg.lstsq(terms[:, kept], SMOOTH[:80], rcond=None)[0]
        return np.sum(residual**2 @ weights)

    everything = np.arange(terms.shape[1])
    cheapest = min(everything, key=lambda term: loss(np.delete(everything, term)))
    pruned = ChebyshevPolynomial(2, n_terms=len(everything) - 1, output_weights=weights, outlier_factor=None)
    pruned.fit(POINTS[:80], SMOOTH[:80])
    np.testing.assert_array_equal(pruned.exponents_, np.delete(full.exponents_, cheapest, axis=0))


def test_failed_waveforms_are_screened_and_reported():
    exponents = weighted_exponents(3, (1, 0.8, 1, 1.5, 1.5))
    good = chebyshev_terms(POINTS, exponents).T @ RNG.normal(size=(len(exponents), 2))
    good += 1e-3 * RNG.normal(size=good.shape)
    outputs = good.copy()
    outputs[[17, 400]] += [[3.0, -2.0], [0.0, 400.0]]  # The second hides the first until it is gone.
    clean = ChebyshevPolynomial(4, outlier_factor=None).fit(
        np.delete(POINTS, [17, 400], 0), np.delete(good, [17, 400], 0)
    )
    screened = ChebyshevPolynomial(4).fit(POINTS, outputs)
    assert screened.outliers_.tolist() == [17, 400]
    np.testing.assert_allclose(screened.coefficients_, clean.coefficients_, atol=1e-12)


def test_no_more_than_the_stated_fraction_is_screened():
    outputs = SMOOTH.copy()
    outputs[::10] += 50.0 * RNG.normal(size=outputs[::10].shape)
    screened = ChebyshevPolynomial(2, outlier_factor=2.0, max_outlier_fraction=0.01).fit(POINTS, outputs)
    assert 0 < len(screened.outliers_) <= 9


def test_a_coordinate_that_does_not_vary_is_no_obstacle():
    points = POINTS.copy()
    points[:, 3:] = 0.0
    outputs = np.exp(points @ [0.3, -0.2, 0.1, 0, 0])
    polynomial = ChebyshevPolynomial(5, n_terms=40).fit(points, outputs)
    np.testing.assert_allclose(polynomial.predict(points), outputs, atol=1e-4)


def test_too_few_samples_and_failed_waveforms_are_refused():
    with pytest.raises(InvalidParameters, match="706 terms cannot be determined by 100 samples"):
        ChebyshevPolynomial(8).fit(POINTS[:100], SMOOTH[:100])
    with pytest.raises(ValueError, match="finite"):
        ChebyshevPolynomial(1).fit(POINTS, np.full(900, np.nan))
    with pytest.raises(ValueError, match=r"\(N, 5\)"):
        ChebyshevPolynomial(1).fit(POINTS[:, :4], SMOOTH)


# --- all of them


@pytest.mark.parametrize(
    "regressor",
    [
        ChebyshevPolynomial(3, n_terms=40),
        quick_mlp(),
        quick_mlp(activation="relu"),
        quick_mlp(activation="logistic"),
        Sum(ChebyshevPolynomial(2), quick_mlp()),
        Sum(quick_mlp(), ChebyshevPolynomial(2)),
        Sum(ChebyshevPolynomial(1), ChebyshevPolynomial(3)),
        MLPRegressor(hidden_layer_sizes=(5,), activation="tanh", max_iter=5, random_state=0),
    ],
    ids=repr,
)
@pytest.mark.parametrize("outputs", [SMOOTH, SMOOTH[:, :1]], ids=["two outputs", "one"])
def test_exported_arrays_give_the_predictions_to_rounding(regressor, outputs):
    if isinstance(regressor, MLPRegressor) and outputs.shape[1] == 1:
        outputs = outputs[:, 0]
    regressor = fitted(clone(regressor), outputs=outputs)
    exported = export_regressor(regressor)
    values = evaluate_exported(exported.arrays, POINTS, exported.metadata.get("mlp_activation", "tanh"))
    expected = regressor.predict(POINTS)
    np.testing.assert_allclose(values, expected.reshape(values.shape), atol=1e-12 * max(1.0, np.abs(expected).max()))
    for name, array in exported.arrays.items():
        assert array.flags.c_contiguous, name
        assert array.dtype == (np.uint8 if name == "polynomial_exponents" else np.float64)


@pytest.mark.parametrize("regressor", [ChebyshevPolynomial(2), quick_mlp(), Sum(ChebyshevPolynomial(1), quick_mlp())])
def test_estimators_keep_scikit_learns_contract(regressor):
    before = repr(regressor.get_params(deep=False))
    model = clone(regressor)
    assert fitted(model) is model
    assert repr(model.get_params(deep=False)) == before
    again = fitted(clone(regressor))
    np.testing.assert_array_equal(model.predict(POINTS), again.predict(POINTS))
    assert model.score(POINTS, SMOOTH) == pytest.approx(again.score(POINTS, SMOOTH))
    vector = fitted(clone(regressor), outputs=SMOOTH[:, 0])
    assert vector.predict(POINTS).shape == (900,)
    column = fitted(clone(regressor), outputs=SMOOTH[:, :1])
    assert column.predict(POINTS).shape == (900, 1)


def test_the_papers_hyper_parameters_are_the_defaults():
    mlp = MLP()
    assert (mlp.hidden_layer_sizes, mlp.activation) == ((82, 95), "tanh")
    assert (mlp.alpha, mlp.batch_size, mlp.learning_rate_init) == (1e-4, 162, 1.2e-3)
    assert (mlp.validation_fraction, mlp.tol, mlp.n_iter_no_change) == (0.075, 2e-15, 91)


def test_the_mlp_is_scikit_learns_on_standardised_inputs():
    points = POINTS * [1, 10, 100, 1, 1] + [0, 5, 0, 0, 0]
    ours = fitted(quick_mlp(), points)
    standardised = (points - points.mean(axis=0)) / points.std(axis=0)
    options = ours.network_.get_params()
    theirs = fitted(MLPRegressor(**options), standardised)
    np.testing.assert_allclose(ours.predict(points), theirs.predict(standardised), atol=1e-12)


def test_a_sum_improves_on_its_first_part():
    first = ChebyshevPolynomial(1)
    both = Sum(first, ChebyshevPolynomial(3)).fit(POINTS, SMOOTH)
    alone = clone(first).fit(POINTS, SMOOTH)
    assert np.mean((both.predict(POINTS) - SMOOTH) ** 2) < 0.1 * np.mean((alone.predict(POINTS) - SMOOTH) ** 2)
    assert both.residual_scale_ == pytest.approx(np.sqrt(np.mean((alone.predict(POINTS) - SMOOTH) ** 2)))


def test_a_sum_on_an_exact_first_part_has_nothing_to_add():
    outputs = POINTS @ np.ones((5, 2))
    both = Sum(ChebyshevPolynomial(2), ChebyshevPolynomial(1)).fit(POINTS, outputs)
    np.testing.assert_allclose(both.predict(POINTS), outputs, atol=1e-12)


def test_other_estimators_train_and_are_refused_at_export():
    neighbours = Sum(ChebyshevPolynomial(1), KNeighborsRegressor()).fit(POINTS, SMOOTH)
    assert neighbours.predict(POINTS).shape == SMOOTH.shape
    with pytest.raises(NotExportable, match="KNeighborsRegressor"):
        export_regressor(neighbours)
    with pytest.raises(NotExportable, match="two networks"):
        export_regressor(fitted(Sum(quick_mlp(), quick_mlp())))
    with pytest.raises(NotExportable, match="identity"):
        export_regressor(fitted(quick_mlp(activation="identity")))


def test_an_estimator_of_ones_own_exports_through_its_export_method():
    class Constant:
        def export(self):
            return ExportedRegressor.of_polynomial(np.zeros((1, 5), dtype=np.uint8), np.array([[4.0, 2.0]]))

    exported = export_regressor(Constant())
    np.testing.assert_array_equal(evaluate_exported(exported.arrays, POINTS[:3]), [[4, 2]] * 3)
