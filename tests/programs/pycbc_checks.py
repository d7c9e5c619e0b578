"""PyCBC as it is on the index, with bnserve as one of its approximants; ``bash tests/programs.sh pycbc`` runs it.

``BNSERVE_URL`` is the address of a server of the shipped models; the local ones are installed beside PyCBC, too.
"""

import dataclasses
import os
import pickle
import subprocess
import sys
import time
from pathlib import Path

import h5py
import lal
import lalsimulation
import numpy as np
import pytest
from pycbc.filter import optimized_match, overlap
from pycbc.inference import models
from pycbc.psd import aLIGOZeroDetHighPower
from pycbc.waveform import (
    NoWaveformError,
    fd_approximants,
    get_fd_waveform,
    get_fd_waveform_sequence,
    get_td_waveform,
    get_waveform_end_frequency,
    get_waveform_filter,
    get_waveform_filter_length_in_time,
    td_approximants,
)
from pycbc.workflow import WorkflowConfigParser

from bnserve_client import InvalidParameters, InvalidRequest, OutOfDomain, ParametersWithExtrinsic
from bnserve_client import Model as RemoteModel
from bnserve_client.pycbc import length
from bnserve_protocol import EvaluationOptions, InvalidFrequencies
from bnserve_surrogate import Model

pytestmark = pytest.mark.filterwarnings("default")  # of PyCBC and what it imports

ADDRESS = os.environ["BNSERVE_URL"]
HERE = Path(__file__).parent
BINARY = {
    "mass1": 1.5, "mass2": 1.3, "spin1z": 0.02, "spin2z": 0.01, "lambda1": 400.0, "lambda2": 450.0,
    "distance": 50.0, "inclination": 0.4, "coa_phase": 0.7, "f_ref": 50.0,
}  # fmt: skip
OURS = ParametersWithExtrinsic(
    mass_ratio=1.5 / 1.3, total_mass=2.8, chi_1=0.02, chi_2=0.01, lambda_1=400.0, lambda_2=450.0,
    distance_mpc=50.0, inclination=0.4,
)  # fmt: skip
GRID = {"f_lower": 20.0, "delta_f": 1.0 / 32.0}
LALS = "IMRPhenomXAS_NRTidalv3"
"""LAL's model that is nearest to ours, and has its merger at zero time."""
QUADRUPOLE = {"mode_array": [(2, 2)]}
"""What LAL's models with tides have."""


def series(approximant="bnserve", **given):
    return get_fd_waveform(**(BINARY | GRID | {"approximant": approximant} | given))


def with_phase(model, frequencies, coa_phase=0.7, f_ref=50.0, parameters=OURS):
    """``Model.predict`` with the orbital phase at the reference frequency."""
    options = EvaluationOptions(alignment="merger", reference_frequency=f_ref)
    return model.predict(frequencies, dataclasses.replace(parameters, reference_phase=2.0 * coa_phase), options=options)


# What a waveform is


def test_pycbc_lists_it():
    assert "bnserve" in fd_approximants()
    assert "bnserve" in td_approximants()


@pytest.mark.parametrize("delta_f", [1.0 / 32.0, 0.1])
def test_a_waveform_has_the_bits_of_predict_here_and_there(delta_f):
    found = series(delta_f=delta_f, f_final=1024.0)
    used = found[0].sample_frequencies.numpy() >= 20.0
    frequencies = found[0].sample_frequencies.numpy()[used]
    assert frequencies[0] == pytest.approx(20.0)
    assert found[0].sample_frequencies.numpy()[-1] == 1024.0
    for model in (Model.default(), RemoteModel.connect(ADDRESS)):
        for part, expected in zip(found, with_phase(model, frequencies), strict=True):
            np.testing.assert_array_equal(part.numpy()[used], expected)
            assert not part.numpy()[~used].any()


def test_a_mode_array_chooses_among_the_models_modes():
    modes = [tuple(mode) for mode in Model.default().description.modes]
    whole, chosen = series(), [series(mode_array=[mode]) for mode in modes]
    for number, part in enumerate(whole):
        total = sum(one[number].numpy() for one in chosen)
        np.testing.assert_allclose(total, part.numpy(), rtol=0.0, atol=1e-9 * abs(part.numpy()).max())


def test_without_an_address_the_model_of_this_process_has_the_same_bits(monkeypatch):
    remote = series()
    monkeypatch.delenv("BNSERVE_URL")
    for here, there in zip(series(), remote, strict=True):
        np.testing.assert_array_equal(here.numpy(), there.numpy())


def test_samples_are_those_of_a_series():
    points = np.concatenate([[0.0], GRID["delta_f"] * np.unique(np.geomspace(640, 60000, 300).astype(int))])
    found = get_fd_waveform_sequence(approximant="bnserve", sample_points=points, **BINARY)
    for part, expected in zip(found, with_phase(Model.default(), points[1:]), strict=True):
        np.testing.assert_array_equal(part.numpy(), np.append(0.0, expected))


def test_it_ends_with_the_models_band():
    top = get_waveform_end_frequency(approximant="bnserve", **BINARY)
    description = Model.default().description
    assert top == description.training_band[1] * description.reference_mass / 2.8
    assert len(series()[0]) == int(top / GRID["delta_f"]) + 1
    beyond = series(f_final=4096.0)[0]
    assert len(beyond) == 4096 * 32 + 1
    assert np.flatnonzero(beyond.numpy())[-1] == int(top / GRID["delta_f"])


def test_a_search_can_filter_with_it():
    out = np.zeros(32 * 2048 + 1, dtype=np.complex64)
    from pycbc.types import Array

    found = get_waveform_filter(Array(out), approximant="bnserve", **(BINARY | GRID))
    assert found.chirp_length == pytest.approx(161.5, abs=0.5)
    assert abs(found.numpy()).max() > 0.0


# Against LAL


def noise(waveform):
    return aLIGOZeroDetHighPower(len(waveform), waveform.delta_f, GRID["f_lower"])


LEAST_MATCH = {LALS: 0.9998, "IMRPhenomD_NRTidalv2": 0.9995, "TaylorF2": 0.995}
"""Ours differ from these models by 7e-5, 2e-4 and 2e-3 (the median over the box, ET-D)."""


@pytest.mark.parametrize("approximant", LEAST_MATCH)
def test_it_matches_lals_models(approximant):
    ours, theirs = series(f_final=2048.0, **QUADRUPOLE)[0], series(approximant, f_final=2048.0)[0]
    theirs.resize(len(ours))
    found, _ = optimized_match(ours, theirs, psd=noise(ours), low_frequency_cutoff=20.0)
    print(f"match with {approximant}: 1 - {1.0 - found:.2g}")
    assert LEAST_MATCH[approximant] < found <= 1.0 + 1e-9


@pytest.mark.parametrize("given", [{}, {"coa_phase": 2.1}, {"f_ref": 0.0}, {"f_ref": 100.0}, {"inclination": 2.4}])
def test_phase_time_and_signs_are_lals(given):
    """The overlap is not maximised: a tenth of a radian would cost 0.005, a millisecond everything."""
    given = {"f_final": 2048.0, **given}
    for ours, theirs in zip(series(**given, **QUADRUPOLE), series(LALS, **given), strict=True):
        theirs.resize(len(ours))
        assert overlap(ours, theirs, psd=noise(ours), low_frequency_cutoff=20.0) > 0.999
        assert np.linalg.norm(ours[640:3200]) == pytest.approx(np.linalg.norm(theirs[640:3200]), rel=0.01)


def test_the_stars_may_be_in_any_order():
    exchanged = {"mass1": 1.3, "mass2": 1.5, "spin1z": 0.01, "spin2z": 0.02, "lambda1": 450.0, "lambda2": 400.0}
    for one, other in zip(series(), series(**exchanged), strict=True):
        np.testing.assert_array_equal(one.numpy(), other.numpy())
    exchanged["f_final"] = 2048.0
    ours, theirs = series(**exchanged, **QUADRUPOLE)[0], series(LALS, **exchanged)[0]
    theirs.resize(len(ours))
    assert overlap(ours, theirs, psd=noise(ours), low_frequency_cutoff=20.0) > 0.999


def test_in_the_time_domain_the_merger_is_at_zero_as_lals():
    merger = {}
    for approximant in ("bnserve", LALS):
        plus, cross = get_td_waveform(approximant=approximant, delta_t=1.0 / 8192.0, f_lower=30.0, **BINARY)
        envelope = np.abs(plus.numpy() - 1j * cross.numpy())
        merger[approximant] = float(plus.sample_times.numpy()[np.argmax(envelope)])
        assert -1e-3 < merger[approximant] < 1e-3
        assert float(plus.start_time) < -50.0  # all of the signal from 30 Hz on
    assert merger["bnserve"] == pytest.approx(merger[LALS], abs=0.5e-3)


def test_its_length_is_the_time_from_the_lowest_frequency_to_the_merger():
    found = get_waveform_filter_length_in_time("bnserve", f_lower=20.0, **BINARY)
    assert found == Model.default().time_until_merger(20.0, OURS)
    assert found == pytest.approx(get_waveform_filter_length_in_time("TaylorF2", f_lower=20.0, **BINARY), rel=0.02)


def test_the_default_of_no_tides_is_none():
    """Of a model that begins at zero."""
    found = series(lambda1=None)
    used = found[0].sample_frequencies.numpy() >= 20.0
    frequencies = found[0].sample_frequencies.numpy()[used]
    expected = with_phase(Model.default(), frequencies, parameters=dataclasses.replace(OURS, lambda_1=0.0))
    assert found[0].numpy()[used].tobytes() == expected.plus.tobytes()


# Precession


SPINNING = {"spin1x": 0.3, "spin1y": -0.1, "spin2x": 0.05, "spin2y": 0.2, "f_ref": 20.0}


def test_spins_in_the_orbital_plane_have_the_bits_of_predict():
    found = series(f_final=1024.0, **SPINNING)
    frequencies = found[0].sample_frequencies.numpy()[640:]
    binary = dataclasses.replace(OURS, chi_1x=0.3, chi_1y=-0.1, chi_2x=0.05, chi_2y=0.2)
    for model in (Model.default(), RemoteModel.connect(ADDRESS)):
        for part, expected in zip(found, with_phase(model, frequencies, f_ref=20.0, parameters=binary), strict=True):
            np.testing.assert_array_equal(part.numpy()[640:], expected)
            assert not part.numpy()[:640].any()


def spin_taylor(given):
    """LAL's IMRPhenomXP, with the spins that its SpinTaylor follows, on the grid up to 64 Hz."""
    settings = lal.CreateDict()
    lalsimulation.SimInspiralWaveformParamsInsertPhenomXPrecVersion(settings, 320)
    for insert, name in (("Lambda1", "lambda1"), ("Lambda2", "lambda2")):
        getattr(lalsimulation, f"SimInspiralWaveformParamsInsertTidal{insert}")(settings, given[name])
    spins = [given.get(f"spin{star}{axis}", 0.0) for star in "12" for axis in "xyz"]
    found = lalsimulation.SimInspiralChooseFDWaveform(
        given["mass1"] * lal.MSUN_SI, given["mass2"] * lal.MSUN_SI, *spins, given["distance"] * 1e6 * lal.PC_SI,
        given["inclination"], given["coa_phase"], 0.0, 0.0, 0.0, GRID["delta_f"], GRID["f_lower"], 80.0, given["f_ref"],
        settings, lalsimulation.GetApproximantFromString("IMRPhenomXP_NRTidalv3"),
    )  # fmt: skip
    return np.array([part.data.data[640:2049] for part in found])


@pytest.mark.parametrize("given", [{}, {"inclination": 2.2, "coa_phase": 2.0}, {"mass1": 1.3, "mass2": 1.5}])
def test_a_binary_that_precesses_is_seen_as_by_lal(given):
    """Both polarisations from the reference frequency on, and the phase there; of nearly black holes, whose quadrupoles
    LAL's SpinTaylor has here."""
    given = {**BINARY, **SPINNING, "lambda1": 10.0, "lambda2": 10.0, **given}
    found = np.array([part.numpy()[640:] for part in series(f_final=64.0, **given, **QUADRUPOLE)])
    theirs = spin_taylor(given)
    sizes = [np.linalg.norm(one, axis=0) for one in (found, theirs)]
    along = np.abs((found.conj() * theirs).sum(axis=0)) / (sizes[0] * sizes[1])
    assert np.sqrt(1.0 - np.minimum(along, 1.0) ** 2).max() < 0.01
    np.testing.assert_allclose(sizes[0], sizes[1], rtol=0.01)
    np.testing.assert_allclose(np.angle(found[:, 0] / theirs[:, 0]), 0.0, atol=1e-5)


def test_its_length_is_that_of_the_orbit():
    assert length(**(BINARY | GRID | SPINNING)) == length(**(BINARY | GRID))


# What it refuses


@pytest.mark.parametrize("given", [{"lambda1": None}, {"lambda2": 0.0}])
def test_the_default_of_no_tides_is_refused_with_the_smallest_that_there_is(given, monkeypatch):
    """By a model that begins above zero; the server has another one alone."""
    monkeypatch.delenv("BNSERVE_URL")
    name = next(iter(given))
    with pytest.raises(InvalidParameters, match=f"'{name}' is 0, .* 'paper' is 5: give {name}=5 or more") as caught:
        series(bnserve_model="paper", **given)
    assert not isinstance(caught.value, NoWaveformError)  # which a likelihood would take for an impossible binary


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"eccentricity": 0.1}, "The model has no 'eccentricity', and got 0.1: leave it out"),
        ({"dquad_mon1": 3.0}, "no 'dquad_mon1'"),
        ({"phase_order": 7}, "no 'phase_order'"),
        ({"mode_array": [(5, 5)]}, r"no mode \(5, 5\); it has \(2, 2\)"),
        ({"f_ref": 1e4}, "'f_ref' of 10000 Hz"),
        ({"bnserve_ulr": ADDRESS}, "'bnserve_ulr': did you mean 'bnserve_url'"),
    ],
)
def test_what_the_model_does_not_have_is_refused_in_a_sentence(given, said):
    with pytest.raises(InvalidRequest, match=said):
        series(**given)


def test_an_empty_band_is_refused():
    with pytest.raises(InvalidFrequencies, match=r"'f_lower' \(20 Hz\) and 'f_final' \(10 Hz\)"):
        series(f_final=10.0)


@pytest.mark.parametrize("outside", [{"lambda1": 6000.0}, {"mass1": 5.0}, {"spin2z": -0.9}, {"lambda1": -2.0}])
def test_outside_the_models_range_it_is_no_waveform_in_pycbcs_word_and_in_ours(outside):
    with pytest.raises(NoWaveformError, match="no waveform of this binary") as caught:
        series(**outside)
    assert isinstance(caught.value, OutOfDomain)
    assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)
    with pytest.raises(NoWaveformError):
        length(**(BINARY | GRID | outside))


# pycbc_inference


SIGNAL = {
    "tc": 1187008882.42, "mchirp": (1.5 * 1.3) ** 0.6 / 2.8**0.2, "q": 1.5 / 1.3, "lambda1": 400.0, "lambda2": 450.0,
    "distance": 60.0, "coa_phase": 1.5,
}  # fmt: skip
"""That of pycbc_injection.ini."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """With both configurations, LAL's and ours, and the signal."""
    folder = tmp_path_factory.mktemp("inference")
    text = (HERE / "pycbc_inference.ini").read_text()
    assert text.count(LALS) == 1
    (folder / "lal.ini").write_text(text)
    (folder / "bnserve.ini").write_text(text.replace(LALS, "bnserve"))
    program("pycbc_create_injections", "--config-files", HERE / "pycbc_injection.ini", "--ninjections", 1, "--seed", 1,
            "--output-file", folder / "injection.hdf", folder=folder)  # fmt: skip
    return folder


def program(name, *arguments, folder):
    command = [Path(sys.executable).parent / name, *map(str, arguments)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]


def inference_model(folder, name, *changes, monkeypatch):
    monkeypatch.chdir(folder)
    return models.read_from_config(WorkflowConfigParser([f"{name}.ini"], overrideTuples=list(changes)))


def log_ratio(model, **given):
    model.update(**(SIGNAL | given))
    return model.loglr


def seconds_of_one(model):
    """The least of a few; no binary is asked for twice."""
    found = []
    for repeat in range(10):
        start = time.perf_counter()
        log_ratio(model, lambda2=451.0 + repeat)
        found.append(time.perf_counter() - start)
    return min(found)


def test_the_likelihood_of_a_signal_by_lals_model_is_nearly_as_high_with_ours(folder, monkeypatch):
    """Phase and time mean the same: ln L at the parameters of the signal is LAL's, up to the models' difference."""
    lals, ours = (inference_model(folder, name, monkeypatch=monkeypatch) for name in ("lal", "bnserve"))
    assert log_ratio(lals) > 200.0
    assert log_ratio(ours) == pytest.approx(log_ratio(lals), abs=10.0)
    assert log_ratio(ours, lambda1=6000.0) == -np.inf
    for name, model in (("LAL's", lals), ("ours", ours)):
        print(f"ln L/L0 with {name}: {log_ratio(model):.1f}; {1e3 * seconds_of_one(model):.3g} ms")


def test_pycbc_inference_samples_with_the_name_changed_alone(folder):
    program("pycbc_inference", "--config-files", "bnserve.ini", "--output-file", "out.hdf", "--seed", 1, folder=folder)
    with h5py.File(folder / "out.hdf") as result:
        values = result["samples/loglikelihood"][()]
        assert len(values) >= 250
        assert np.isfinite(values).mean() > 0.9
