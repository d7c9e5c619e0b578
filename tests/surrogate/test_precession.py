"""Spins that precess: followed as their equations say, and modes seen from the turning orbit."""

import dataclasses

import numpy as np
import pytest

from bnserve_protocol import InvalidRequest, OutOfBand, ParameterBatch, ParametersWithExtrinsic
from bnserve_surrogate.kernel._loader import DIGEST_PREFIX
from bnserve_surrogate.kernel.build import source_digest
from bnserve_surrogate.precession import twist
from bnserve_surrogate.precession._twist import ASSEMBLY
from bnserve_surrogate.precession.build import sources
from tests.surrogate.precession_reference import polarizations

MODES = ((2, 1), (3, 1), (2, 2), (3, 2), (3, 3), (4, 3), (4, 4))
F = np.geomspace(16.0, 1600.0, 301)
REFERENCE = 20.0
BINARY = ParametersWithExtrinsic(
    mass_ratio=1.4, lambda_1=400.0, lambda_2=1200.0, chi_1=0.2, chi_2=-0.1, distance_mpc=40.0, inclination=1.1,
    total_mass=2.8, reference_phase=0.7, chi_1x=0.3, chi_1y=0.1, chi_2x=-0.2, chi_2y=0.35,
)  # fmt: skip
OTHERS = {
    "wide": dataclasses.replace(BINARY, mass_ratio=5.0, chi_1=-0.6, chi_1x=0.5, inclination=2.6),
    "black holes": dataclasses.replace(BINARY, lambda_1=0.0, lambda_2=0.0, reference_phase=-2.0),
    "equal": dataclasses.replace(BINARY, mass_ratio=1.0, inclination=0.0),
    "one spin": dataclasses.replace(BINARY, chi_2=0.0, chi_2x=0.0, chi_2y=0.0, inclination=np.pi),
}


def some_modes(rows=1, points=301):
    random = np.random.default_rng(1)
    shape = rows, len(MODES), points
    return random.normal(size=shape) + 1j * random.normal(size=shape)


def random_batch(rows, size=0.4):
    random = np.random.default_rng(2)
    columns = dataclasses.asdict(BINARY)
    columns["mass_ratio"] = random.uniform(1.0, 3.0, rows)
    columns["total_mass"] = random.uniform(2.0, 4.0, rows)
    columns["inclination"] = random.uniform(0.0, np.pi, rows)
    for name in ("chi_1", "chi_2", "chi_1x", "chi_1y", "chi_2x", "chi_2y"):
        columns[name] = random.uniform(-size, size, rows)
    return ParameterBatch.coerce(columns)


@pytest.mark.parametrize("binary", [BINARY, *OTHERS.values()], ids=["typical", *OTHERS])
def test_polarizations_are_those_of_the_equations_and_the_sum_over_rotated_harmonics(binary):
    h = some_modes()
    for ours, expected in zip(
        twist(F, MODES, h, ParameterBatch.one(binary), REFERENCE),
        polarizations(F, MODES, h[0], binary, REFERENCE),
        strict=True,
    ):
        np.testing.assert_allclose(ours[0], expected, atol=2e-4 * np.abs(expected).max())


@pytest.mark.parametrize("reference", [8.0, 16.0, 800.0])
def test_spins_may_be_given_at_any_frequency(reference):
    h = some_modes()
    ours = twist(F, MODES, h, ParameterBatch.one(BINARY), reference)
    expected = polarizations(F, MODES, h[0], BINARY, reference)
    np.testing.assert_allclose(ours[0][0], expected[0], atol=4e-4 * np.abs(expected[0]).max())


def test_as_spins_become_aligned_the_limit_is_that_of_aligned_spins():
    """In proportion: what a spin in the plane of 1e-12 changes is 1e-12."""
    h = some_modes()
    aligned = dataclasses.replace(BINARY, chi_1x=1e-300, chi_1y=0.0, chi_2x=0.0, chi_2y=0.0)
    limit = twist(F, MODES, h, ParameterBatch.one(aligned), REFERENCE)
    for size in (1e-3, 1e-6, 1e-9, 1e-12):
        spins = {name: size * getattr(BINARY, name) for name in ("chi_1x", "chi_1y", "chi_2x", "chi_2y")}
        ours = twist(F, MODES, h, ParameterBatch.one(dataclasses.replace(aligned, **spins)), REFERENCE)
        for one, other in zip(ours, limit, strict=True):
            assert np.abs(one - other).max() < 4.0 * size + 1e-14
    assert np.abs(ours[0] - limit[0]).max() > 0.0


@pytest.mark.parametrize("size", [1, 3, 8, 16])
def test_a_row_has_the_same_bits_in_every_batch(size):
    batch, h = random_batch(16), some_modes(16)
    together = twist(F, MODES, h, batch, REFERENCE)
    for start in range(0, 16, size):
        part = slice(start, start + size)
        for one, all_of_them in zip(twist(F, MODES, h[part], batch.rows(part), REFERENCE), together, strict=True):
            np.testing.assert_array_equal(one, all_of_them[part])


def test_what_stands_at_a_frequency_hardly_depends_on_the_others():
    """To rounding: precession is followed in the same steps from the reference frequency, wherever the grid ends."""
    h = some_modes()
    whole = twist(F, MODES, h, ParameterBatch.one(BINARY), REFERENCE)
    for part in (slice(0, 3), slice(100, 260), slice(300, 301)):
        some = twist(F[part], MODES, h[:, :, part], ParameterBatch.one(BINARY), REFERENCE)
        np.testing.assert_allclose(some[0], whole[0][:, part], rtol=1e-11, atol=1e-11)


def test_the_order_of_modes_does_not_matter():
    h, batch = some_modes(), ParameterBatch.one(BINARY)
    turned = twist(F, MODES[::-1], h[:, ::-1], batch, REFERENCE)
    for one, other in zip(turned, twist(F, MODES, h, batch, REFERENCE), strict=True):
        np.testing.assert_array_equal(one, other)


def test_stars_that_change_names_are_the_same_binary():
    """By LAL's meaning: x points to the star named first, so that all in the plane turns by half a turn."""
    equal = dataclasses.replace(BINARY, mass_ratio=1.0)
    swapped = dataclasses.replace(
        equal, lambda_1=equal.lambda_2, lambda_2=equal.lambda_1, chi_1=equal.chi_2, chi_2=equal.chi_1,
        chi_1x=-equal.chi_2x, chi_1y=-equal.chi_2y, chi_2x=-equal.chi_1x, chi_2y=-equal.chi_1y,
        reference_phase=equal.reference_phase + 2.0 * np.pi,
    )  # fmt: skip
    h = some_modes()
    # The modes of the pair with other names: h_lm at the same orbital phase of the same star.
    for one, other in zip(
        twist(F, MODES, h, ParameterBatch.one(equal), REFERENCE),
        twist(F, MODES, h, ParameterBatch.one(swapped), REFERENCE),
        strict=True,
    ):
        np.testing.assert_allclose(one, other, atol=1e-9)


def test_no_more_turns_are_followed_than_there_is_memory_for():
    with pytest.raises(OutOfBand, match="begin at a higher frequency"):
        twist(np.array([0.01, 20.0]), MODES, some_modes(1, 2), ParameterBatch.one(BINARY), REFERENCE)


def test_spins_are_given_before_the_merger():
    with pytest.raises(InvalidRequest, match="has merged"):
        twist(F, MODES, some_modes(), ParameterBatch.one(BINARY), 6000.0)


def test_modes_without_a_formula_are_refused():
    with pytest.raises(InvalidRequest, match=r"\(5, 5\)"):
        twist(F, ((5, 5),), some_modes()[:, :1], ParameterBatch.one(BINARY), REFERENCE)


def test_the_shipped_code_is_that_of_its_sources():
    first_line = ASSEMBLY.read_text().splitlines()[0]
    assert first_line == DIGEST_PREFIX + source_digest(sources()), "run: python -m bnserve_surrogate.precession.build"
