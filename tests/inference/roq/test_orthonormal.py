"""The iterated modified Gram-Schmidt procedure keeps orthogonality where one pass loses it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_inference.roq._interpolation import orthogonality_loss, orthonormalised, projection_errors


def unit(rng, size, kind):
    vector = rng.normal(size=size) + (1j * rng.normal(size=size) if kind is complex else 0.0)
    return vector / np.linalg.norm(vector)


def close_vectors(rng, count, size, kind, distance):
    """Unit vectors, all within ``distance`` of one of them."""
    first = unit(rng, size, kind)
    vectors = [first]
    for _ in range(count - 1):
        vector = first + distance * unit(rng, size, kind)
        vectors.append(vector / np.linalg.norm(vector))
    return vectors


def basis_of(vectors):
    rows = np.zeros((0, len(vectors[0])), dtype=vectors[0].dtype)
    for vector in vectors:
        rows = np.vstack([rows, orthonormalised(vector, rows)[0]])
    return rows


def one_pass(vectors):
    rows = []
    for vector in vectors:
        rest = vector
        for row in rows:
            rest = rest - np.vdot(row, rest) * row
        rows.append(rest / np.linalg.norm(rest))
    return np.array(rows)


@given(seed=st.integers(0, 1000), kind=st.sampled_from([float, complex]), exponent=st.integers(0, 10))
def test_rows_are_orthonormal_however_close_the_vectors(seed, kind, exponent):
    vectors = close_vectors(np.random.default_rng(seed), 12, 40, kind, 10.0**-exponent)
    assert orthogonality_loss(basis_of(vectors)) < 1e-13


def test_a_single_pass_would_not_do():
    vectors = close_vectors(np.random.default_rng(1), 12, 40, complex, 1e-10)
    assert orthogonality_loss(one_pass(vectors)) > 1e-8


@pytest.mark.parametrize("kind", [float, complex])
def test_the_vector_is_rebuilt_from_its_direction_and_distance(kind):
    rng = np.random.default_rng(2)
    rows = basis_of([unit(rng, 30, kind) for _ in range(5)])
    vector = unit(rng, 30, kind)
    direction, distance = orthonormalised(vector, rows)
    np.testing.assert_allclose(rows.conj() @ vector @ rows + distance * direction, vector, atol=1e-14)
    (error,) = projection_errors(vector[None], rows)
    assert error == pytest.approx(distance**2, abs=1e-14)


def test_inputs_are_left_alone():
    rng = np.random.default_rng(3)
    rows, vector = basis_of([unit(rng, 10, complex) for _ in range(3)]), unit(rng, 10, complex)
    before = rows.copy(), vector.copy()
    orthonormalised(vector, rows)
    np.testing.assert_array_equal(rows, before[0])
    np.testing.assert_array_equal(vector, before[1])
