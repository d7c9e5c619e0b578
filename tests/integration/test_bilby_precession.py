"""Spins in the orbital plane by bilby's angles: LAL's components of them, and LAL's polarisations."""

import bilby
import lal
import lalsimulation
import numpy as np
import pytest
from bilby.core.prior import DeltaFunction, Sine, Uniform

from bnserve_client import InvalidRequest, OutOfBand
from bnserve_client._lal_precession import components
from bnserve_client.bilby import ServiceLikelihood, binary_neutron_star
from bnserve_client.bilby._arguments import read_choice
from bnserve_client.bilby._waveforms import waveforms_of
from bnserve_protocol import EvaluationOptions
from bnserve_service import BackgroundServer, Settings
from tests.integration.test_bilby_likelihood import priors
from tests.integration.test_bilby_source import QUADRUPOLE, SIGNAL, generator, network
from tests.service.chirp import MemorySource, as_it_is
from tests.service.modes_chirp import ModesModel

pytestmark = [
    pytest.mark.filterwarnings("default"),  # of bilby and what it imports
    pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning"),
]

GRID = np.arange(64 * 512) / 64.0
NEAR = (GRID >= 20.0) & (GRID <= 60.0)
"""Some ten turns of precession from the reference frequency on."""
AT_20_HZ = {"reference_frequency": 20.0, "minimum_frequency": 20.0, "maximum_frequency": 400.0}
SPINNING = {
    "mass_1": 1.6, "mass_2": 1.3, "luminosity_distance": 50.0, "a_1": 0.4, "tilt_1": 1.1, "phi_12": 0.7, "a_2": 0.3,
    "tilt_2": 2.0, "phi_jl": 2.0, "theta_jn": 1.0, "phase": 0.4, "lambda_1": 10.0, "lambda_2": 10.0,
}  # fmt: skip
"""Nearly black holes, because LAL's SpinTaylor there knows the quadrupoles of those alone."""
OTHERS = {
    "as it is": {},
    "orbital phase": {"phase": 2.9}, "azimuth of L": {"phi_jl": 5.0}, "azimuth between": {"phi_12": 3.3},
    "from below": {"theta_jn": 2.5}, "one spin": {"a_2": 0.0}, "down": {"tilt_1": 2.6},
    "the lighter star first": {"mass_1": 1.3, "mass_2": 1.6},
}  # fmt: skip
OTHER_BINARIES = [
    ({"phi_jl": 2.5}, "azimuth"), ({"phi_12": 1.2}, "azimuth"), ({"theta_jn": 1.2}, "direction"),
    ({"tilt_1": 0.0, "tilt_2": 0.0}, "no precession"),
]  # fmt: skip


@pytest.fixture(scope="module")
def ours(bnserve_server):
    return {"bnserve_url": bnserve_server.address, **AT_20_HZ}


def waveform(given, **arguments):
    return binary_neutron_star(GRID, **(SPINNING | given), **arguments)


def of_lal(given, approximant="IMRPhenomXP_NRTidalv3", **more):
    arguments = AT_20_HZ | {"waveform_approximant": approximant} | more
    return bilby.gw.source.lal_binary_neutron_star(GRID, **(SPINNING | given), **arguments)


def apart(ours, theirs, band=NEAR):
    """The largest angle between both polarisations as a vector, whatever its phase; and that of their sizes."""
    one, other = (np.array([strain["plus"][band], strain["cross"][band]]) for strain in (ours, theirs))
    sizes = [np.linalg.norm(each, axis=0) for each in (one, other)]
    along = np.abs((one.conj() * other).sum(axis=0)) / (sizes[0] * sizes[1])
    return np.sqrt(1.0 - np.minimum(along, 1.0) ** 2).max(), np.abs(sizes[0] / sizes[1] - 1.0).max()


def test_components_are_those_of_lal():
    random = np.random.default_rng(1)
    for _ in range(200):
        angles = {name: float(value) for name, value in zip(
            ("mass_1", "mass_2", "a_1", "a_2", "tilt_1", "tilt_2", "phi_12", "phi_jl", "theta_jn"),
            [*random.uniform(1.0, 2.0, 2), *random.uniform(0.0, 0.9, 2), *np.arccos(random.uniform(-1.0, 1.0, 2)),
             *random.uniform(0.0, 2.0 * np.pi, 2), np.arccos(random.uniform(-1.0, 1.0))], strict=True)}  # fmt: skip
        reference, phase = random.uniform(5.0, 100.0), random.uniform(0.0, 6.0)
        found = components(angles, reference, phase)
        expected = lalsimulation.SimInspiralTransformPrecessingNewInitialConditions(
            *(angles[name] for name in ("theta_jn", "phi_jl", "tilt_1", "tilt_2", "phi_12", "a_1", "a_2")),
            angles["mass_1"] * lal.MSUN_SI, angles["mass_2"] * lal.MSUN_SI, reference, phase,
        )  # fmt: skip
        names = ("inclination", "chi_1x", "chi_1y", "chi_1", "chi_2x", "chi_2y", "chi_2")
        np.testing.assert_allclose([found[name] for name in names], expected, rtol=0.0, atol=1e-8)  # the solar mass's


@pytest.mark.parametrize("given", OTHERS.values(), ids=OTHERS)
def test_near_the_reference_frequency_a_binary_is_seen_as_by_lal(ours, given):
    """By LAL's spins (SpinTaylor) in IMRPhenomXP: both polarisations, and at that frequency the phase."""
    found = waveform(given, **ours, **QUADRUPOLE)
    theirs = of_lal(given, PhenomXPrecVersion=320)
    direction, size = apart(found, theirs)
    assert direction < 0.01
    assert size < 0.006
    there = int(np.argmax(NEAR))
    for name in ("plus", "cross"):
        assert found[name][there] / abs(found[name][there]) == pytest.approx(
            theirs[name][there] / abs(theirs[name][there]), abs=1e-5
        )


@pytest.mark.parametrize(("given", "what"), OTHER_BINARIES)
def test_another_binary_is_seen_otherwise(ours, given, what):
    """So that the test above can fail: half a radian of an azimuth is told apart."""
    direction, size = apart(waveform(given, **ours, **QUADRUPOLE), of_lal({}, PhenomXPrecVersion=320))
    assert direction > 0.02 or size > 0.012, what


@pytest.mark.parametrize("approximant", ["IMRPhenomXP_NRTidalv3", "IMRPhenomPv2_NRTidal"])
def test_a_named_model_of_lal_has_its_phase_and_the_same_spins(ours, approximant):
    """LAL's own angles are less exact, so that there is less to compare."""
    found = waveform({}, waveform_approximant=approximant, **ours, **QUADRUPOLE)
    theirs = of_lal({}, approximant)
    there = (GRID >= 20.0) & (GRID <= 21.0)
    assert max(apart(found, theirs, there)) < 0.03
    for name in ("plus", "cross"):
        turn = np.angle(found[name][there] / theirs[name][there])
        assert np.abs(turn).max() < 0.1


def test_a_waveform_is_the_models_with_lals_components(ours, local):
    found = waveform({}, **ours)
    seen = components(SPINNING, 20.0, SPINNING["phase"])
    columns = {"mass_ratio": 1.6 / 1.3, "total_mass": 2.9, "lambda_1": 10.0, "lambda_2": 10.0, "distance_mpc": 50.0,
               "reference_phase": 0.8, **seen}  # fmt: skip
    options = EvaluationOptions(alignment="merger", reference_frequency=20.0)
    band = (GRID >= 20.0) & (GRID <= 400.0)
    expected = local.predict_batch(GRID[band], columns, options=options)
    for name in ("plus", "cross"):
        np.testing.assert_allclose(found[name][band], getattr(expected, name)[0], rtol=1e-8, atol=0.0)
        assert not found[name][~band].any()


def test_as_spins_become_aligned_so_does_the_waveform(ours):
    """On both sides of what counts as aligned."""
    aligned = waveform({"tilt_1": 0.0, "tilt_2": 0.0}, **ours)
    for tilt in (2e-5, 2e-4):
        found = waveform({"tilt_1": tilt, "tilt_2": 0.0}, **ours)
        for name in ("plus", "cross"):
            assert np.abs(found[name] - aligned[name]).max() < tilt * np.abs(aligned[name]).max()


def test_outside_the_models_range_there_is_none(ours):
    nonsense = {"theta_jn": np.nan}, {"a_1": np.nan}, {"phi_jl": np.inf}, {"mass_2": 0.0}, {"mass_1": -1.4}
    for outside in ({"a_1": 1.2}, {"lambda_1": -1.0}, {"mass_1": 5.0}, *nonsense):
        assert waveform(outside, **ours) is None
    named = {"waveform_approximant": "IMRPhenomXP_NRTidalv3"}
    assert waveform({"lambda_1": -1.0}, **named, **ours) is None


def test_what_cannot_be_at_this_reference_frequency_is_an_error_and_not_a_likelihood_of_nothing(ours):
    with pytest.raises(OutOfBand, match="turns"):
        waveform({}, **ours | {"reference_frequency": 1e-3})
    with pytest.raises(InvalidRequest, match="end below the 'reference_frequency' of 9000 Hz"):
        waveform({}, **ours | {"reference_frequency": 9000.0})


def test_other_grids_have_the_same_waveform(ours):
    whole = waveform({}, **ours)
    some = np.array([1400, 2000, 9000])
    sequence = waveform({}, frequencies=GRID[some], **ours)
    nodes = waveform({}, frequency_nodes_linear=GRID[some], frequency_nodes_quadratic=GRID[some[:2]], **ours)
    for name in ("plus", "cross"):
        for found in (sequence[name], nodes["linear"][name]):
            np.testing.assert_allclose(found, whole[name][some], rtol=1e-7, atol=0.0)
        np.testing.assert_allclose(nodes["quadratic"][name], whole[name][some[:2]], rtol=1e-7, atol=0.0)


class CountingModel:
    """A model that counts how often it is asked."""

    def __init__(self, model):
        self.model, self.asked, self.description = model, 0, model.description

    def predict_batch(self, *given, **options):
        self.asked += 1
        return self.model.predict_batch(*given, **options)


def test_another_distance_of_the_last_binary_costs_no_evaluation(ours):
    source = waveforms_of(read_choice(ours | {"reference_frequency": 21.0}))
    source._model = counting = CountingModel(source._model)
    more = ours | {"reference_frequency": 21.0}
    one, other = (waveform({"luminosity_distance": distance}, **more) for distance in (50.0, 100.0))
    np.testing.assert_allclose(other["plus"], 0.5 * one["plus"], rtol=1e-14, atol=0.0)
    assert counting.asked == 1
    waveform({"phase": 0.5}, **more)
    assert counting.asked == 2


def test_bilbys_likelihood_of_a_binary_that_precesses_is_highest_at_the_signal(ours):
    """By way of bilby's own generator, conversion and detectors."""
    arguments = ours | {"minimum_frequency": 40.0, "maximum_frequency": 1024.0, "reference_frequency": 50.0}
    spinning = {name: value for name, value in SPINNING.items() if name not in ("mass_1", "mass_2", "phase")}
    signal = {name: value for name, value in SIGNAL.items() if not name.startswith("chi_")} | spinning
    waveforms = generator(binary_neutron_star, **arguments)
    data = network(waveforms, signal=signal)
    likelihood = bilby.gw.GravitationalWaveTransient(data, waveforms)
    there = likelihood.log_likelihood_ratio(signal)
    assert there > 500.0
    for other in ({"tilt_1": 0.0, "tilt_2": 0.0}, {"phi_jl": 4.0}, {"phi_12": 3.7}):
        assert likelihood.log_likelihood_ratio(signal | other) < there - 3.0


def test_a_model_that_does_not_precess_says_so_in_a_sentence():
    source = MemorySource().add(ModesModel())
    with (
        BackgroundServer(Settings(port=0), source=source, factory=as_it_is) as server,
        pytest.raises(InvalidRequest, match="'modes' does not say that it has precession: leave out chi_1x"),
    ):
        waveform({}, bnserve_url=server.address, bnserve_model="modes", **AT_20_HZ)


ALIGNED = [{"a_1": Uniform(0.0, 0.05), "tilt_1": tilt} for tilt in (0.0, np.pi, DeltaFunction(0.0))]
ALIGNED.append({"a_1": 0.0, "tilt_1": Sine()})
TILTED = [
    {"a_1": Uniform(0.0, 0.05), "tilt_1": Sine()}, {"a_1": Uniform(0.0, 0.05), "tilt_1": 0.3},
    {"a_1": 0.1, "cos_tilt_1": Uniform(-1.0, 1.0)}, {"chi_1": 0.02, "chi_1_in_plane": Uniform(0.0, 0.1)},
]  # fmt: skip


@pytest.fixture(scope="module")
def likelihood_arguments(bnserve_server):
    return {"bnserve_url": bnserve_server.address, "minimum_frequency": 40.0}


@pytest.fixture(scope="module")
def data(likelihood_arguments):
    return network(generator(binary_neutron_star, **likelihood_arguments))


def prior_of_spins(given):
    prior = priors()
    del prior["chi_1"]
    prior.update(given)
    return prior


@pytest.mark.parametrize("given", TILTED, ids=lambda given: " ".join(given))
def test_a_likelihood_in_the_service_takes_aligned_spins(data, likelihood_arguments, given):
    with pytest.raises(InvalidRequest, match=rf"'{list(given)[-1]}'.*chi_1 and chi_2, as in .*BNSPriorDict\(\)"):
        ServiceLikelihood.from_bilby(data, prior_of_spins(given), waveform_arguments=likelihood_arguments)


@pytest.mark.parametrize("given", ALIGNED)
def test_spins_that_are_aligned_may_have_angles_there(data, likelihood_arguments, given):
    found = ServiceLikelihood.from_bilby(data, prior_of_spins(given), waveform_arguments=likelihood_arguments)
    sample = {name: value for name, value in SIGNAL.items() if name != "chi_1"} | {"a_1": 0.02, "tilt_1": 0.0}
    assert found.log_likelihood_ratio(sample) == found.log_likelihood_ratio(SIGNAL)
