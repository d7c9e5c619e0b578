"""Empirical interpolation: exact on the span, exact at unique nodes, the same for elements and their residuals."""

import numpy as np
import pytest

from bnserve_inference.roq import ConstructionFailed
from bnserve_inference.roq._interpolation import (
    interpolation_errors,
    lebesgue_constant,
    orthonormalised,
    residuals,
    with_node,
)


@pytest.fixture(scope="module")
def elements():
    """Chirps of different rates: ``(9, 300)``."""
    x = np.linspace(1.0, 2.0, 300)
    return np.exp(1j * np.linspace(0.0, 20.0, 9)[:, None] * x**-1.5) * x ** (-7 / 6)


def interpolated(elements):
    rows = np.zeros((0, elements.shape[1]), dtype=elements.dtype)
    nodes = np.zeros(0, dtype=np.int64)
    for element in elements:
        rows, nodes = with_node(rows, nodes, element)
    return rows, nodes


def test_the_rows_are_one_at_their_node_and_zero_at_the_others(elements):
    rows, nodes = interpolated(elements)
    np.testing.assert_allclose(rows[:, nodes], np.eye(9), atol=1e-12)


def test_the_nodes_are_unique(elements):
    _, nodes = interpolated(elements)
    assert len(set(nodes.tolist())) == 9


def test_combinations_of_the_elements_are_reproduced(elements):
    rows, nodes = interpolated(elements)
    combined = np.random.default_rng(1).normal(size=(4, 9)) @ elements
    errors = interpolation_errors(combined, rows, nodes, np.ones(300))
    assert errors.max() < 1e-20 * (np.abs(combined) ** 2).sum(axis=1).max()


def test_it_is_the_textbook_interpolant(elements):
    rows, nodes = interpolated(elements)
    direct = np.linalg.solve(elements[:, nodes], elements)
    np.testing.assert_allclose(rows, direct, atol=1e-9)


def test_what_lies_outside_the_span_is_missed(elements):
    rows, nodes = interpolated(elements[:5])
    assert interpolation_errors(elements[6:7], rows, nodes, np.ones(300))[0] > 1e-6


def test_residuals_of_gram_schmidt_give_the_same_nodes_and_rows(elements):
    basis = np.zeros((0, 300), dtype=complex)
    for element in elements:
        direction, _ = orthonormalised(element / np.linalg.norm(element), basis)
        basis = np.vstack([basis, direction])
    rows, nodes = interpolated(elements)
    orthonormal_rows, orthonormal_nodes = interpolated(basis)
    np.testing.assert_array_equal(nodes, orthonormal_nodes)
    np.testing.assert_allclose(rows, orthonormal_rows, atol=1e-9)


def test_a_new_row_changes_residuals_by_its_multiple(elements):
    """What the enrichment cycles rely on."""
    rows, nodes = interpolated(elements[:5])
    more_rows, more_nodes = with_node(rows, nodes, elements[5])
    missed = residuals(elements, rows, nodes)
    updated = missed - missed[:, more_nodes[-1], None] * more_rows[-1]
    np.testing.assert_allclose(updated, residuals(elements, more_rows, more_nodes), atol=1e-11)


def test_a_repeated_element_is_refused(elements):
    rows, nodes = interpolated(elements[:5])
    with pytest.raises(ConstructionFailed, match="larger tolerance"):
        with_node(rows, nodes, elements[:5].sum(axis=0))


def test_the_lebesgue_constant_is_at_least_one(elements):
    rows, _ = interpolated(elements)
    assert 1.0 <= lebesgue_constant(rows) < 100.0
