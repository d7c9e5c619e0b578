"""Amplitudes and phases of single modes, and the phase at a reference frequency."""

import numpy as np
import pytest

from bnserve_protocol import (
    PARAMETER_NAMES,
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    InvalidRequest,
    OutOfBand,
    OutOfDomain,
    ParameterBatch,
    ParametersWithExtrinsic,
    RowStatus,
)
from bnserve_surrogate import Model
from bnserve_surrogate._artifact import MODES
from tests.surrogate.conftest import random_batch
from tests.surrogate.seven_modes import chosen, seven_mode_metadata, seven_mode_model

ALL = tuple(MODES.values())
BAND = np.geomspace(15.0, 2048.0, 300)


@pytest.fixture(scope="module")
def metadata():
    return seven_mode_metadata()


@pytest.fixture(scope="module")
def model(metadata):
    return seven_mode_model(metadata)


@pytest.mark.parametrize("mode", ALL)
@pytest.mark.parametrize("alignment", ["post_newtonian", "merger"])
def test_amplitude_and_phase_of_a_mode_are_those_of_its_strain(model, mode, alignment):
    values, f = random_batch(6, seed=9), np.geomspace(3.0, 2600.0, 400)
    options = chosen(mode, alignment=alignment)
    amplitude, phase = model.predict_amplitude_phase(f, ParameterBatch(values), options=options)
    h = model.predict_factored(f, ParameterBatch(values), options=options).h
    np.testing.assert_allclose(amplitude * np.exp(1j * phase), h, atol=1e-8 * np.abs(h).max())


@pytest.mark.parametrize("mode", [(2, 1), (3, 3), (4, 4)])
def test_the_phase_of_a_mode_is_continuous_and_the_same_on_every_grid(model, mode):
    values = random_batch(6, seed=9)
    f = np.geomspace(20.0, 1500.0, 6000)
    _, phase = model.predict_amplitude_phase(f, ParameterBatch(values), options=chosen(mode))
    _, carrier = model.predict_amplitude_phase(2.0 * f / mode[1], ParameterBatch(values), options=chosen((2, 2)))
    assert np.abs(np.diff(phase - 0.5 * mode[1] * carrier, axis=1)).max() < 1.0
    some = np.sort(np.random.default_rng(0).choice(6000, 5, replace=False))
    _, few = model.predict_amplitude_phase(f[some], ParameterBatch(values), options=chosen(mode))
    np.testing.assert_allclose(few, phase[:, some], atol=1e-6)


@pytest.mark.parametrize("mode", ALL)
def test_above_the_band_the_phase_of_a_mode_goes_on(model, metadata, mode):
    row = random_batch(1, seed=3)
    end = metadata.mf_band[1] / (row[0, 7] * SOLAR_MASS_SECONDS)
    f = np.linspace(0.98, 1.02, 401) * end
    amplitude, phase = model.predict_amplitude_phase(f, ParameterBatch(row), options=chosen(mode))
    assert (amplitude[0, 202:] == 0.0).all()
    slope = np.diff(phase[0])
    assert np.abs(np.diff(slope)).max() < 0.02 * np.abs(slope).max()


@pytest.mark.parametrize("method", ["predict_factored", "predict_amplitude_phase"])
def test_what_belongs_to_one_mode_is_refused_for_several(model, method):
    for options in (EvaluationOptions(), chosen((2, 2), (3, 3))):
        with pytest.raises(InvalidRequest, match=r"modes=\[\(2, 2\)\]"):
            getattr(model, method)(BAND, ParameterBatch(random_batch(1)), options=options)


def test_an_unknown_mode_is_refused_with_those_that_there_are(model):
    for method in (model.predict_batch, model.predict_modes, model.predict_factored, model.predict_amplitude_phase):
        with pytest.raises(InvalidRequest, match=r"no mode \(5, 5\); it has \(2, 2\), \(2, 1\)"):
            method(BAND, ParameterBatch(random_batch(1)), options=chosen((5, 5)))


@pytest.mark.parametrize("f_ref", [5.0, 20.0, 123.4, 1900.0])
@pytest.mark.parametrize("alignment", ["post_newtonian", "merger"])
def test_at_the_reference_frequency_the_2_2_has_the_phase_that_lal_gives_it(model, f_ref, alignment):
    values = random_batch(5, seed=10)
    values[:, 9] = 0.0
    options = EvaluationOptions(modes=((2, 2),), reference_frequency=f_ref, alignment=alignment)
    _, phase = model.predict_amplitude_phase([f_ref], ParameterBatch(values), options=options)
    turns = (phase[:, 0] - values[:, 8] - 5.0 * np.pi / 4.0) / (4.0 * np.pi)
    np.testing.assert_allclose(turns, np.round(turns), atol=1e-9)
    modes = model.predict_modes(
        BAND, ParameterBatch(values), options=EvaluationOptions(reference_frequency=f_ref, alignment=alignment)
    )
    plain = model.predict_modes(BAND, ParameterBatch(values), options=EvaluationOptions(alignment=alignment))
    values[:, 8] = 0.0
    alone = EvaluationOptions(modes=((2, 2),), alignment=alignment)
    unturned = model.predict_amplitude_phase([f_ref], ParameterBatch(values), options=alone).phase[:, 0]
    turn = 5.0 * np.pi / 4.0 - unturned
    for k, (_, order) in enumerate(modes.modes):
        expected = np.broadcast_to(np.exp(0.5j * order * turn)[:, None], (5, 300))
        # The slope above the carrier's end is that of a polynomial through rounded values.
        np.testing.assert_allclose(modes.h[:, k] / plain.h[:, k], expected, atol=1e-5)


def test_a_reference_frequency_leaves_bad_rows_bad(model):
    values = random_batch(4)
    values[1, 0], values[2, 6] = 0.5, np.nan
    flagged = model.predict_batch(
        BAND, ParameterBatch(values), options=EvaluationOptions(reference_frequency=20.0, out_of_domain="flag")
    )
    assert flagged.status.tolist() == [0, RowStatus.OUT_OF_DOMAIN, RowStatus.NOT_FINITE, 0]
    with pytest.raises(OutOfDomain, match="mass_ratio"):
        model.predict_batch(
            BAND, ParameterBatch(np.delete(values, 2, axis=0)), options=EvaluationOptions(reference_frequency=20.0)
        )
    with pytest.raises(InvalidRequest, match="higher one"):
        model.predict_batch(BAND, ParameterBatch(random_batch(1)), options=EvaluationOptions(reference_frequency=1e-6))


def test_a_reference_frequency_above_the_band_is_refused_for_the_rows_that_are_evaluated():
    """There the phase is a line on which nothing was learnt."""
    model, one = Model.default(), ParametersWithExtrinsic.gw170817()
    top = model.description.mf_band[1] / (one.total_mass * SOLAR_MASS_SECONDS)
    model.predict(BAND, one, options=EvaluationOptions(reference_frequency=top))
    with pytest.raises(OutOfBand, match=r"Row 0: reference_frequency = .* is above the model's band, which ends at"):
        model.predict(BAND, one, options=EvaluationOptions(reference_frequency=1.01 * top))
    values = ParameterBatch.coerce([one, one]).values.copy()
    values[1, PARAMETER_NAMES.index("total_mass")] = 1e6
    flagged = EvaluationOptions(reference_frequency=0.99 * top, out_of_domain="flag")
    assert model.predict_batch(BAND, ParameterBatch(values), options=flagged).status.tolist() == [0, 2]
