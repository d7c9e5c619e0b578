"""Other programs' interfaces with a model of seven modes: all of it unless some are chosen, with LAL's orbital phase.

The model is synthetic; those modes of the shipped one that IMRPhenomXHM has, too, are compared with it.
"""

import bilby
import msgspec
import numpy as np
import pandas as pd
import pytest
from bilby.core.prior import PowerLaw

from bnserve_client import Model
from bnserve_client._harmonics import mode_factors
from bnserve_client._lal_meaning import read_mode_array
from bnserve_client.bilby import ServiceLikelihood, binary_neutron_star
from bnserve_client.compat.mlgw_bns import Model as Predecessor
from bnserve_client.compat.mlgw_bns import ParametersWithExtrinsic as PredecessorsBinary
from bnserve_protocol import EvaluationOptions, InvalidRequest
from bnserve_store import ModelStore
from tests.integration.conftest import serving
from tests.integration.test_bilby_likelihood import priors, samples
from tests.integration.test_bilby_source import GRID, SIGNAL, generator, network
from tests.surrogate.seven_modes import seven_mode_metadata, seven_mode_tensors

pytestmark = pytest.mark.filterwarnings("default")  # of bilby and what it imports

BAND = GRID >= 40.0
OURS = {"mass_ratio": 1.5 / 1.3, "total_mass": 2.8, "lambda_1": 400.0, "lambda_2": 450.0, "chi_1": 0.02, "chi_2": 0.02,
        "distance_mpc": 50.0, "inclination": 0.4, "reference_phase": 2.0 * SIGNAL["phase"]}  # fmt: skip
"""SIGNAL by our names."""


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    folder = tmp_path_factory.mktemp("seven")
    metadata = msgspec.to_builtins(seven_mode_metadata())
    ModelStore([folder / "models"]).publish("seven", "1.0.0", seven_mode_tensors(), metadata)
    with serving(folder / "log", "--store", str(folder / "models"), "--model", "seven") as server:
        yield server.address


@pytest.fixture(scope="module")
def model(address):
    with Model.connect(address, "seven") as model:
        yield model


@pytest.fixture
def ours(address):
    return {"bnserve_url": address, "bnserve_model": "seven", "reference_frequency": 50.0}


def options(modes=None):
    return EvaluationOptions(alignment="merger", reference_frequency=50.0, modes=modes)


def strain(given=None, **arguments):
    return generator(binary_neutron_star, **arguments).frequency_domain_strain(SIGNAL | (given or {}))


def distance(found, expected):
    return max(np.abs(found[name] - expected[name]).max() / np.abs(expected[name]).max() for name in ("plus", "cross"))


def test_modes_count_in_a_direction_as_in_the_model(model):
    for inclination in (0.0, 0.4, 2.0, np.pi):
        expected = model.predict_modes([100.0], OURS | {"inclination": inclination})
        plus, cross = mode_factors(expected.modes, inclination)
        np.testing.assert_allclose(plus, expected.plus[0], rtol=0.0, atol=1e-14)
        np.testing.assert_allclose(cross, expected.cross[0], rtol=0.0, atol=1e-14)


# bilby


@pytest.mark.parametrize("modes", [None, [(2, 2)], [(3, 3), (2, 1)]])
@pytest.mark.parametrize("given", [{}, {"phase": 4.0}, {"theta_jn": 2.3}])
def test_a_waveform_of_bilby_is_the_models(model, ours, modes, given):
    found = strain(given, mode_array=modes, **ours)
    changed = {"reference_phase": 2.0 * given["phase"]} if "phase" in given else {}
    changed |= {"inclination": given["theta_jn"]} if "theta_jn" in given else {}
    expected = model.predict_batch(GRID[BAND], OURS | changed, options=options(modes))
    for name, of_model in (("plus", expected.plus[0]), ("cross", expected.cross[0])):
        assert not found[name][~BAND].any()
        np.testing.assert_allclose(found[name][BAND], of_model, rtol=0.0, atol=1e-8 * np.abs(of_model).max())


def test_half_a_turn_of_the_orbit_is_seen(ours):
    assert distance(strain({"phase": SIGNAL["phase"] + np.pi}, **ours), strain(**ours)) > 1e-3
    assert distance(strain({"phase": SIGNAL["phase"] + 2.0 * np.pi}, **ours), strain(**ours)) < 1e-9
    quadrupole = [strain({"phase": phase}, mode_array=[[2, 2]], **ours) for phase in (0.3, 0.3 + np.pi)]
    assert distance(*quadrupole) < 1e-9


def test_a_mode_array_is_of_pairs_with_either_sign():
    assert read_mode_array([[2, -2], (2, 2), np.array([3, 3])]) == ((2, 2), (3, 3))
    assert read_mode_array(None) is None
    for wrong in ([[2]], [2, 2], "22", [], [[2.5, 2]]):
        with pytest.raises(InvalidRequest, match="pairs"):
            read_mode_array(wrong)


def test_a_mode_that_the_model_lacks_is_refused_with_those_that_it_has(ours):
    with pytest.raises(InvalidRequest, match=r"no mode \(5, 5\); it has \(2, 2\), \(2, 1\)"):
        strain(mode_array=[[2, 2], [5, 5]], **ours)


def test_the_lighter_star_may_come_first_as_in_lal(ours):
    """LAL exchanges the stars and turns nothing, neither here nor in the next test."""
    one = {"mass_1": 1.6, "mass_2": 1.2, "chi_1": -0.2, "chi_2": 0.1, "lambda_1": 200.0, "lambda_2": 700.0}
    other = {"mass_1": 1.2, "mass_2": 1.6, "chi_1": 0.1, "chi_2": -0.2, "lambda_1": 700.0, "lambda_2": 200.0}
    assert distance(strain(other, **ours), strain(one, **ours)) == 0.0


XHM = [(2, 2), (2, 1), (3, 3), (4, 4)]
"""Those of IMRPhenomXHM that mix with no others."""


@pytest.mark.parametrize("order", [("1", "2"), ("2", "1")], ids=["heavier first", "lighter first"])
def test_each_mode_has_lals_sign_and_phase(bnserve_server, order):
    """At the instant of the reference frequency, of stars with hardly any tides. LAL wants (l, -m) to be named."""
    known = [tuple(mode) for mode in Model.connect(bnserve_server.address).description.modes]
    for mode in set(XHM) & set(known):
        first = dict(zip(order, ((1.8, 0.1), (1.2, -0.05)), strict=True))
        given = {f"mass_{star}": mass for star, (mass, _) in first.items()}
        given |= {f"chi_{star}": chi for star, (_, chi) in first.items()} | {"lambda_1": 10.0, "lambda_2": 10.0}
        given |= {"theta_jn": 1.1}
        common = {"mode_array": [[mode[0], mode[1]], [mode[0], -mode[1]]], "reference_frequency": 80.0}
        found = strain(given, bnserve_url=bnserve_server.address, **common)
        lals = generator(bilby.gw.source.lal_binary_black_hole, waveform_approximant="IMRPhenomXHM", **common)
        lals.parameter_conversion = bilby.gw.conversion.convert_to_lal_binary_black_hole_parameters
        theirs = lals.frequency_domain_strain({name: value for name, value in (SIGNAL | given).items()
                                               if "lambda" not in name})  # fmt: skip
        at = int(80.0 * 32.0 * mode[1] / 2)
        for name in ("plus", "cross"):
            assert abs(found[name][at] / theirs[name][at]) == pytest.approx(1.0, abs=0.02)
            assert np.angle(found[name][at] / theirs[name][at]) == pytest.approx(0.0, abs=0.4), mode


def test_a_named_model_of_lal_turns_all_modes_by_one_orbit_and_one_time(ours):
    """To the nearer one of two opposite orbits: phase at the reference frequency within half a turn of the wave."""
    named = {"waveform_approximant": "IMRPhenomD_NRTidalv2"}
    turns = {}
    for mode in ((2, 2), (3, 3), (4, 4)):
        own, theirs = (strain(mode_array=[mode], **ours, **more)["plus"] for more in ({}, named))
        turns[mode] = np.angle(theirs / np.where(own == 0.0, 1.0, own))[int(50.0 * 32.0 * mode[1] / 2)]
    for (_, order), turn in turns.items():
        apart = turn - 0.5 * order * turns[2, 2]
        assert np.abs(np.remainder(apart + np.pi, 2.0 * np.pi) - np.pi) < 1e-6


def test_the_phase_of_all_modes_is_integrated_and_drawn(ours):
    arguments = ours | {"minimum_frequency": 40.0}
    data = network(generator(binary_neutron_star, **arguments))
    sampled, integrated = (
        ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments, phase_marginalization=marginalised)
        for marginalised in (False, True)
    )
    phases = np.linspace(0.0, 2.0 * np.pi, 4096, endpoint=False)
    values = sampled.log_likelihood_ratios(SIGNAL | {"phase": phases})
    mean = values.max() + np.log(np.exp(values - values.max()).mean())
    assert integrated.log_likelihood_ratio(SIGNAL) == pytest.approx(mean, abs=0.01)
    bilby.core.utils.random.seed(1)
    drawn = integrated.reconstructed(pd.DataFrame([SIGNAL] * 50))["phase"]
    weights = np.exp(values - values.max())
    moment = (weights * np.exp(1j * phases)).sum() / weights.sum()
    assert np.mean(np.exp(1j * np.array(drawn))) == pytest.approx(moment, abs=0.3)
    assert min(values[np.searchsorted(phases, phase) - 1] for phase in drawn) > values.max() - 15.0
    one = integrated.generate_phase_sample_from_marginalized_likelihood(parameters=SIGNAL)
    assert sampled.log_likelihood_ratio(SIGNAL | {"phase": one}) > values.max() - 15.0


@pytest.mark.parametrize("more", [{}, {"mode_array": [[2, 2]]}, {"mode_array": [[2, 2], [4, 4]]}])
def test_time_phase_and_distance_of_any_modes_are_drawn_together(ours, more):
    """The likelihood at what was drawn is that which was drawn: names, zero points and circles are the same."""
    arguments = ours | {"minimum_frequency": 40.0} | more
    data = network(generator(binary_neutron_star, **arguments))
    sampled, integrated = (
        ServiceLikelihood.from_bilby(
            data, priors(luminosity_distance=PowerLaw(2.0, 20.0, 100.0)), waveform_arguments=arguments,
            phase_marginalization=all_of_them, time_marginalization=all_of_them, distance_marginalization=all_of_them,
        )
        for all_of_them in (False, True)
    )  # fmt: skip
    rows = pd.DataFrame([SIGNAL] * 8)
    bilby.core.utils.random.seed(3)
    drawn = integrated.reconstructed(rows)
    assert set(drawn) == {"geocent_time", "phase", "luminosity_distance"}
    values = sampled.log_likelihood_ratios(rows.assign(**drawn))
    bilby.core.utils.random.seed(3)
    numbers = bilby.core.utils.random.rng.random((8, 4))[:, :3].copy()
    columns = integrated._columns(rows)
    expected = integrated.likelihood.draw_marginalised(columns, seed=numbers).log_likelihood
    np.testing.assert_allclose(values, expected, atol=0.05)  # of 0.2 us in a GPS time
    assert values.min() > values.max() - 20.0
    one = integrated.generate_posterior_sample_from_marginalized_likelihood(SIGNAL)
    assert abs(one["luminosity_distance"] - SIGNAL["luminosity_distance"]) < 15.0
    assert np.ptp(drawn["phase"]) > np.pi  # both halves of a turn, or all that is possible where modes are odd


@pytest.mark.parametrize("fiducial", [None, SIGNAL], ids=["full grid", "relative binning"])
@pytest.mark.parametrize("more", [{}, {"mode_array": [(2, 2), (3, 3)]}, {"waveform_approximant": "TaylorF2"}])
def test_a_services_likelihood_has_the_modes_of_the_source_model(ours, fiducial, more):
    arguments = ours | {"minimum_frequency": 40.0} | more
    waveforms = generator(binary_neutron_star, **arguments)
    data = network(waveforms)
    theirs = bilby.gw.GravitationalWaveTransient(data, waveforms)
    found = ServiceLikelihood.from_bilby(data, priors(), waveform_arguments=arguments, fiducial_parameters=fiducial)
    rows = [row | {"phase": row["phase"] + turn} for row, turn in zip(samples(6), np.arange(6), strict=True)]
    expected = [theirs.log_likelihood_ratio(row) for row in rows]
    np.testing.assert_allclose(found.log_likelihood_ratios(rows), expected, rtol=0.0, atol=0.05)


# mlgw_bns


def test_the_predecessors_names_have_all_modes_unless_some_are_chosen(address, model, monkeypatch):
    monkeypatch.setenv("BNSERVE_URL", address)
    frequencies, named = np.arange(30.0, 500.0), Predecessor.default("seven")
    binary = PredecessorsBinary(1.3, 300.0, 800.0, 0.1, -0.1, 40.0, 1.0, 2.8, 0.7, 0.002)
    whole = np.array(named.predict(frequencies, binary))
    named.modes = [(2, 2)]
    quadrupole = np.array(named.predict(frequencies, binary))
    amplitude, phase = named.predict_amplitude_phase(frequencies, binary)
    np.testing.assert_allclose(
        quadrupole[0], 0.5 * (1.0 + np.cos(1.0) ** 2) * amplitude * np.exp(1j * phase), rtol=1e-6, atol=0.0
    )
    assert np.abs(whole - quadrupole).max() > 1e-3 * np.abs(whole).max()
    rest = set(model.description.modes) - {(2, 2)}
    named.modes = sorted(rest)
    np.testing.assert_allclose(
        named.predict(frequencies, binary), whole - quadrupole, rtol=0.0, atol=1e-9 * np.abs(whole).max()
    )
    named.modes = [(5, 5)]
    with pytest.raises(InvalidRequest, match=r"no mode \(5, 5\)"):
        named.predict(frequencies, binary)
