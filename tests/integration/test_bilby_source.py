"""bilby's source model of a binary neutron star, by a running service: what LAL's is, with a model of ours."""

import copy
import multiprocessing
import pickle
import sys

import bilby
import numpy as np
import pytest

from bnserve_client import InvalidRequest, _chosen
from bnserve_client.bilby import binary_neutron_star
from bnserve_client.bilby._arguments import read_choice
from bnserve_client.bilby._waveforms import waveforms_of
from bnserve_protocol import EvaluationOptions, PackageMissing
from tests.architecture.rooms import room_environment, run_python

pytestmark = pytest.mark.filterwarnings("default")  # of bilby and what it imports

QUADRUPOLE = {"mode_array": [[2, 2]]}
"""What LAL's models with tides have."""
DURATION, SAMPLING = 32.0, 2048.0
SIGNAL = {
    "mass_1": 1.5, "mass_2": 1.3, "chi_1": 0.02, "chi_2": 0.02, "luminosity_distance": 50.0, "theta_jn": 0.4,
    "psi": 2.659, "phase": 1.3, "geocent_time": 1126259642.413, "ra": 1.375, "dec": -1.2108,
    "lambda_1": 400.0, "lambda_2": 450.0,
}  # fmt: skip
"""That of bilby's example of a binary neutron star, with whose detectors it has a signal-to-noise ratio of 53."""
CONVERSION = bilby.gw.conversion.convert_to_lal_binary_neutron_star_parameters
GRID = np.arange(int(DURATION * SAMPLING / 2) + 1) / DURATION


def generator(source, **arguments):
    return bilby.gw.WaveformGenerator(
        duration=DURATION, sampling_frequency=SAMPLING, frequency_domain_source_model=source,
        parameter_conversion=CONVERSION, waveform_arguments={"minimum_frequency": 40.0, **arguments},
    )  # fmt: skip


def network(source_of_signal, seed=1, signal=SIGNAL):
    """Three detectors at design sensitivity with the signal in their noise."""
    bilby.core.utils.random.seed(seed)
    interferometers = bilby.gw.detector.InterferometerList(["H1", "L1", "V1"])
    for interferometer in interferometers:
        interferometer.minimum_frequency = 40.0
    interferometers.set_strain_data_from_power_spectral_densities(
        sampling_frequency=SAMPLING, duration=DURATION, start_time=SIGNAL["geocent_time"] + 2.0 - DURATION
    )
    interferometers.inject_signal(parameters=signal, waveform_generator=source_of_signal, raise_error=False)
    return interferometers


@pytest.fixture(scope="module")
def ours(bnserve_server):
    """The source model's arguments."""
    return {"bnserve_url": bnserve_server.address}


def strain(source, given, **arguments):
    return generator(source, **arguments).frequency_domain_strain(SIGNAL | given)


# What a waveform is


def test_a_waveform_is_the_models_with_the_phase_of_the_orbit_at_the_reference_frequency(ours, local):
    found = strain(binary_neutron_star, {}, reference_frequency=50.0, **ours)
    band = GRID >= 40.0
    columns = {"mass_ratio": 1.5 / 1.3, "total_mass": 2.8, "lambda_1": 400.0, "lambda_2": 450.0, "chi_1": 0.02,
               "chi_2": 0.02, "distance_mpc": 50.0, "inclination": 0.4}  # fmt: skip
    options = EvaluationOptions(alignment="merger", reference_frequency=50.0)
    model = local.predict_batch(GRID[band], columns | {"reference_phase": 2.6}, options=options)
    for name, of_model in (("plus", model.plus[0]), ("cross", model.cross[0])):
        assert not found[name][~band].any()
        np.testing.assert_allclose(found[name][band], of_model, rtol=1e-7, atol=1e-9 * np.abs(of_model).max())


DIFFERENCE = {
    "IMRPhenomPv2_NRTidal": 5.0,
    "IMRPhenomPv2_NRTidalv2": 5.0,
    "IMRPhenomD_NRTidalv2": 5.0,
    "IMRPhenomXAS_NRTidalv3": 5.0,
    "IMRPhenomXP_NRTidalv3": 5.0,
    "TaylorF2": 15.0,
}
"""In ln L: mismatches of some 1e-4 (6e-4) at a signal-to-noise ratio of 53, and what noise makes of the difference."""


@pytest.mark.parametrize("approximant", DIFFERENCE)
def test_phase_and_time_mean_what_they_mean_in_lals_model_that_is_named(ours, approximant):
    """At the parameters of an injection by a model of LAL, ln L is that model's, up to the models' difference.

    The signal has 1,400: a radian of phase costs a thousand, a millisecond hundreds.
    """
    arguments = {"waveform_approximant": approximant, "reference_frequency": 50.0}
    lals = generator(bilby.gw.source.lal_binary_neutron_star, **arguments)
    interferometers = network(lals)
    without = {"reference_frequency": 50.0}
    values = [
        bilby.gw.GravitationalWaveTransient(interferometers, waveforms).log_likelihood_ratio(SIGNAL)
        for waveforms in (lals, *(generator(binary_neutron_star, **more, **ours) for more in (arguments, without)))
    ]
    print(f"{approximant}: {values[0]:.1f}; of bnserve with its name {values[1]:.1f}, without {values[2]:.0f}")
    assert values[0] > 1200.0
    assert values[1] == pytest.approx(values[0], abs=DIFFERENCE[approximant])


@pytest.mark.parametrize("given", [{"phase": 0.1}, {"theta_jn": 2.5}, {"luminosity_distance": 75.0}])
def test_orientation_distance_and_phase_act_as_in_lal(ours, given):
    arguments = {"waveform_approximant": "IMRPhenomD_NRTidalv2"}
    for name in ("plus", "cross"):
        one, other = (
            strain(source, given, **arguments, **more)[name][2000]
            / strain(source, {}, **arguments, **more)["plus"][2000]
            for source, more in (
                (bilby.gw.source.lal_binary_neutron_star, {}),
                (binary_neutron_star, ours | QUADRUPOLE),
            )
        )
        assert other == pytest.approx(one, rel=1e-9)


def test_the_reference_frequency_is_lals(ours):
    """The same binary in the same place at 20 Hz and at 100 Hz: the phases differ by what LAL's do."""

    def turned(source, **more):
        two = [strain(source, {}, waveform_approximant="IMRPhenomD_NRTidalv2", reference_frequency=f, **more)["plus"]
               for f in (20.0, 100.0)]  # fmt: skip
        return two[1][3000] / two[0][3000]

    lals, found = turned(bilby.gw.source.lal_binary_neutron_star), turned(binary_neutron_star, **ours | QUADRUPOLE)
    assert np.angle(found / lals) == pytest.approx(
        0.0, abs=0.02
    )  # the two models' phases part by so much from 20 Hz on


SWAPPED = {"mass_1": 1.2, "mass_2": 1.6, "chi_1": 0.1, "chi_2": -0.2, "lambda_1": 700.0, "lambda_2": 200.0}
EXCHANGED = {"mass_1": 1.6, "mass_2": 1.2, "chi_1": -0.2, "chi_2": 0.1, "lambda_1": 200.0, "lambda_2": 700.0}


def test_the_lighter_star_may_come_first_as_in_lal(ours):
    """Exchanged together with its spin and tide; the models of LAL say the same of it."""
    one, other = (strain(binary_neutron_star, given, **ours) for given in (SWAPPED, EXCHANGED))
    np.testing.assert_array_equal(one["plus"], other["plus"])
    np.testing.assert_array_equal(one["cross"], other["cross"])
    lals = [
        strain(bilby.gw.source.lal_binary_neutron_star, given, waveform_approximant="TaylorF2")["plus"]
        for given in (SWAPPED, EXCHANGED)
    ]
    np.testing.assert_allclose(lals[0], lals[1], rtol=1e-6, atol=0.0)
    named = strain(binary_neutron_star, SWAPPED, waveform_approximant="TaylorF2", **ours)["plus"]
    apart = np.angle(named / np.where(lals[0] == 0.0, 1.0, lals[0]))[(GRID > 50.0) & (GRID < 200.0)]
    assert np.abs(apart).max() < 0.2


def test_outside_the_models_range_there_is_none(ours):
    for outside in ({"lambda_1": -1.0}, {"lambda_2": -3.0}, {"mass_1": 4.0}, {"chi_1": 0.9}, {"mass_1": np.nan}):
        assert strain(binary_neutron_star, outside, **ours) is None


def test_the_default_prior_can_be_drawn_from(ours):
    """Every draw is a waveform or None, and more than one in a hundred is a waveform."""
    bilby.core.utils.random.seed(3)
    draws = bilby.gw.prior.BNSPriorDict().sample(200)
    waveforms = generator(binary_neutron_star, **ours)
    found = [
        waveforms.frequency_domain_strain(SIGNAL | {name: float(draws[name][row]) for name in draws})
        for row in range(200)
    ]
    assert 2 < sum(one is not None for one in found) < 200


def test_a_spin_that_is_zero_may_point_anywhere(ours):
    assert strain(binary_neutron_star, {"chi_1": 0.0}, **ours) is not None  # bilby's tilt is then pi / 2


# What it is told


def test_a_program_may_insist_on_an_approximant(ours):
    named = strain(binary_neutron_star, {}, waveform_approximant="bnserve", pn_spin_order=None, **ours)
    np.testing.assert_array_equal(named["plus"], strain(binary_neutron_star, {}, **ours)["plus"])


@pytest.mark.parametrize("approximant", ["IMRPhenomPv2", "nonsense"])
def test_an_approximant_without_tides_has_no_phase_to_take(ours, approximant):
    with pytest.raises(InvalidRequest, match=f"LAL has no waveform by '{approximant}' with tides"):
        strain(binary_neutron_star, {}, waveform_approximant=approximant, **ours)


def test_lals_phase_and_time_are_not_guessed_from_the_lowest_frequencies(ours):
    with pytest.raises(InvalidRequest, match="cannot be found from frequencies up to 30 Hz alone"):
        strain(binary_neutron_star, {}, waveform_approximant="TaylorF2", frequencies=np.array([20.0, 30.0]), **ours)


def test_without_lal_an_approximant_says_what_to_install(ours, monkeypatch):
    monkeypatch.setitem(sys.modules, "lalsimulation", None)
    with pytest.raises(PackageMissing, match=r"needs the package 'lalsimulation'.*pip install '\.\[bilby\]'"):
        strain(binary_neutron_star, {"lambda_1": 402.0}, waveform_approximant="TaylorF2", **ours)


def test_a_waveform_argument_that_is_none_is_refused(ours):
    with pytest.raises(InvalidRequest, match="'bnserve_ulr': did you mean 'bnserve_url'"):
        strain(binary_neutron_star, {}, bnserve_ulr="http://127.0.0.1:1")
    with pytest.raises(InvalidRequest, match=r"no mode \(5, 5\); it has \(2, 2\)"):
        strain(binary_neutron_star, {}, mode_array=[[2, 2], [5, 5]], **ours)
    with pytest.raises(InvalidRequest, match="'reference_frequency' of 10000 Hz; take a lower one"):
        strain(binary_neutron_star, {}, reference_frequency=1e4, **ours)


def test_the_address_may_stand_in_the_environment(ours, monkeypatch):
    expected = strain(binary_neutron_star, {}, **ours)
    monkeypatch.setenv("BNSERVE_URL", ours["bnserve_url"])
    np.testing.assert_array_equal(strain(binary_neutron_star, {})["plus"], expected["plus"])


def test_an_address_in_the_environment_may_change(ours, monkeypatch):
    """Within a process, as in a notebook: the next waveform is that of the next server."""
    for address in (ours["bnserve_url"], ours["bnserve_url"].replace("127.0.0.1", "localhost")):
        monkeypatch.setenv("BNSERVE_URL", address)
        model = waveforms_of(read_choice({}))._model
        assert model is _chosen.chosen_model(address)


@pytest.mark.parametrize(
    "given", [{"bnserve_timeout": "soon"}, {"minimum_frequency": "low"}, {"pn_spin_order": "all"},
              {"reference_frequency": [50.0, 60.0]}],
)  # fmt: skip
def test_what_is_no_number_is_refused_in_a_sentence(ours, given):
    name, value = next(iter(given.items()))
    with pytest.raises(InvalidRequest, match=f"'{name}' is a number, .*; got .*{value[0]}"):
        strain(binary_neutron_star, {}, **ours | given)


def test_a_number_may_be_a_text(ours):
    """As a configuration has them."""
    found = strain(binary_neutron_star, {}, **ours | {"minimum_frequency": "60", "bnserve_timeout": "20"})
    np.testing.assert_array_equal(found["plus"] != 0.0, GRID >= 60.0)


def test_there_may_be_several_addresses(ours):
    one = strain(binary_neutron_star, {}, **ours)
    several = strain(binary_neutron_star, {}, bnserve_url=[ours["bnserve_url"]] * 2, maximum_frequency=None)
    np.testing.assert_array_equal(several["plus"], one["plus"])


def test_without_an_address_the_model_of_this_process_answers_with_the_same_bits(ours, monkeypatch):
    monkeypatch.delenv("BNSERVE_URL", raising=False)
    remote = strain(binary_neutron_star, {}, **ours)
    for name, values in strain(binary_neutron_star, {}).items():
        np.testing.assert_array_equal(values, remote[name])


def test_without_an_address_and_a_model_it_says_what_to_install(monkeypatch):
    monkeypatch.delenv("BNSERVE_URL", raising=False)
    monkeypatch.setattr(_chosen, "entry_points", lambda **_: [])
    _chosen.local_part.cache_clear()
    try:
        with pytest.raises(PackageMissing, match=r"pip install ./protocol ./model_store ./surrogate$"):
            _chosen.chosen_model(None, "a model that nobody asked for before")
    finally:
        _chosen.local_part.cache_clear()


def test_the_import_brings_in_neither_models_nor_builders_of_analyses():
    code = (
        "import bnserve_client.bilby, sys\nprint(*sorted(name for name in sys.modules if name.startswith('bnserve_')))"
    )
    rooms = {name.partition(".")[0] for name in run_python(code, env=room_environment()).split()}
    assert rooms == {"bnserve_client", "bnserve_protocol"}


# Other grids than that of the data


def test_relative_binning_of_bilby_works_with_it(ours):
    waveforms = generator(
        binary_neutron_star, waveform_approximant="IMRPhenomD_NRTidalv2", **ours | QUADRUPOLE
    )  # sums of modes do not bin well
    interferometers = network(waveforms)
    full = bilby.gw.GravitationalWaveTransient(interferometers, waveforms)
    binned = bilby.gw.likelihood.RelativeBinningGravitationalWaveTransient(
        interferometers, copy.deepcopy(waveforms), fiducial_parameters=SIGNAL, epsilon=0.05
    )
    near = SIGNAL | {"lambda_1": 500.0, "phase": 1.4}
    assert binned.log_likelihood_ratio(near) == pytest.approx(full.log_likelihood_ratio(near), abs=0.2)


def test_nodes_of_a_quadrature_and_frequencies_in_a_sequence_are_those_of_the_grid(ours):
    linear, quadratic = GRID[[2000, 1400, 9000]], GRID[[1400, 5000]]
    whole = strain(binary_neutron_star, {}, **ours)
    nodes = strain(binary_neutron_star, {}, frequency_nodes_linear=linear, frequency_nodes_quadratic=quadratic, **ours)
    combined = strain(
        binary_neutron_star, {}, frequency_nodes=GRID[[1400, 2000, 5000, 9000]], linear_indices=np.array([1, 0, 3]),
        quadratic_indices=np.array([0, 2]), **ours,
    )  # fmt: skip
    sequence = strain(binary_neutron_star, {}, frequencies=GRID[[1400, 5000]], **ours)
    for name in ("plus", "cross"):
        for found in (nodes, combined):
            np.testing.assert_allclose(found["linear"][name], whole[name][[2000, 1400, 9000]], rtol=1e-7, atol=0.0)
            np.testing.assert_allclose(found["quadratic"][name], whole[name][[1400, 5000]], rtol=1e-7, atol=0.0)
        np.testing.assert_allclose(sequence[name], whole[name][[1400, 5000]], rtol=1e-7, atol=0.0)


# How it lives


class CountingModel:
    """A model that counts how often it is asked."""

    def __init__(self, model):
        self.model, self.asked, self.description = model, 0, model.description

    def predict_factored(self, *given, **options):
        self.asked += 1
        return self.model.predict_factored(*given, **options)

    def predict_modes(self, *given, **options):
        self.asked += 1
        return self.model.predict_modes(*given, **options)


def test_another_distance_orientation_or_phase_of_the_last_binary_costs_no_evaluation(ours):
    source = waveforms_of(read_choice({"minimum_frequency": 40.0, "reference_frequency": 47.0, **ours}))
    source._model = counting = CountingModel(source._model)
    for given in ({}, {"phase": 0.3}, {"theta_jn": 1.0, "luminosity_distance": 10.0}, {"geocent_time": 3.0}):
        strain(binary_neutron_star, given, reference_frequency=47.0, **ours)
    assert counting.asked == 1
    strain(binary_neutron_star, {"lambda_1": 401.0}, reference_frequency=47.0, **ours)
    assert counting.asked == 2


def value_of(likelihood):
    return likelihood.log_likelihood_ratio(SIGNAL)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_a_likelihood_of_bilby_with_it_is_the_same_in_other_processes(ours, method):
    waveforms = generator(binary_neutron_star, **ours)
    likelihood = bilby.gw.GravitationalWaveTransient(network(waveforms), waveforms)
    expected = value_of(likelihood)
    assert value_of(pickle.loads(pickle.dumps(likelihood))) == value_of(copy.deepcopy(likelihood)) == expected
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map(value_of, [likelihood] * 2) == [expected] * 2
