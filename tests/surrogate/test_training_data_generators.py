"""Every generator gives h_plus(face-on) = amplitude exp(-i psi) in the baseline's units, or says why it cannot."""

import math

import EOBRun_module
import numpy as np
import pytest

from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from bnserve_surrogate.training.data.chunks import evaluate
from bnserve_surrogate.training.data.generation import make_generator
from bnserve_surrogate.training.data.generators import (
    CallableGenerator,
    LALSimulationGenerator,
    TEOBResumSPA,
    mass_seconds,
)
from bnserve_surrogate.training.data.generators._teobresums import MODE_NUMBERS, start_frequency
from bnserve_surrogate.training.data.residuals import flatten_phase, log_amplitude_ratio, merger_phase, phase_difference
from bnserve_surrogate.training.errors import GeneratorFailure, GeneratorUnknown
from bnserve_surrogate.training.reduction.nodes import smooth_nodes

THETA = np.array([1.3, 0.1, -0.05, 400.0, 600.0])


def newtonian(theta, mf):
    """A user's generator: the leading order."""
    symmetric_mass_ratio = theta[0] / (1 + theta[0]) ** 2
    v = np.cbrt(np.pi * mf)
    return np.sqrt(5 * np.pi / (24 * symmetric_mass_ratio)) * v**-3.5, 3 / (128 * symmetric_mass_ratio) * v**-5


class Constructed:
    """A user's generator that is an object."""

    def __call__(self, theta, mf):
        return newtonian(theta, mf)


@pytest.fixture
def teobresums():
    pytest.importorskip("EOBRun_module")
    return TEOBResumSPA()


@pytest.fixture
def lal():
    pytest.importorskip("lalsimulation")


def test_a_users_function_is_a_generator():
    generator = CallableGenerator(newtonian)
    mf = smooth_nodes(5.0, 2000.0, 50)
    amplitude, psi = evaluate(generator, THETA, mf)
    np.testing.assert_array_equal(amplitude, newtonian(THETA, mf)[0])
    np.testing.assert_array_equal(psi, newtonian(THETA, mf)[1])
    assert "newtonian" in generator.name


def test_an_edited_function_is_another_version():
    assert CallableGenerator(newtonian).version == CallableGenerator(newtonian).version
    assert CallableGenerator(newtonian).version != CallableGenerator(Constructed()).version
    assert CallableGenerator(newtonian, release="7").version == "7"


def test_a_generator_can_be_named_in_a_configuration(tmp_path, monkeypatch):
    (tmp_path / "users_waveforms.py").write_text(
        "class Model:\n    def __call__(self, theta, mf):\n        return 1.0 + 0 * mf, -mf\n\nNUMBER = 3\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    generator = make_generator("callable", path="users_waveforms:Model", release="1")
    amplitude, psi = evaluate(generator, THETA, np.array([0.1, 0.2]))
    assert amplitude.tolist() == [1.0, 1.0]
    assert psi.tolist() == [-0.1, -0.2]
    for wrong in ("users_waveforms", "users_waveforms:Nothing", "no_such_module:f", "users_waveforms:NUMBER"):
        with pytest.raises(GeneratorUnknown, match=wrong.split(":")[0]):
            make_generator("callable", path=wrong)


def test_unknown_generators_and_options_are_refused_with_a_hint():
    with pytest.raises(GeneratorUnknown, match="Did you mean 'teobresums'"):
        make_generator("teobresum")
    with pytest.raises(GeneratorUnknown, match="postadiabatic_dr"):
        make_generator("teobresums", step=0.1)


@pytest.mark.parametrize(
    ("function", "reason"),
    [
        (lambda theta, mf: (mf[:-1], mf), "shapes"),
        (lambda theta, mf: (np.ones_like(mf), np.full_like(mf, np.nan)), "phase is not a finite"),
        (lambda theta, mf: (np.full_like(mf, np.inf), mf), "amplitude is not a finite"),
        (lambda theta, mf: (0.0 * mf, mf), "amplitude is not positive"),
        (lambda theta, mf: 1 / 0, "ZeroDivisionError"),
        (lambda theta, mf: "nothing", "raised ValueError"),
    ],
)
def test_unusable_waveforms_are_failures_with_a_reason(function, reason):
    with pytest.raises(GeneratorFailure, match=reason):
        evaluate(CallableGenerator(function, label="broken"), THETA, np.array([0.01, 0.02]))


def test_teobresums_amplitude_and_phase_are_its_conjugated_strain(teobresums):
    """Dense enough to unwrap: the phase computed without unwrapping equals the strain's, at any sparsity."""

    mf = np.linspace(40.0, 400.0, 40) * mass_seconds()
    amplitude, psi = evaluate(teobresums, THETA, mf)
    request = {**teobresums._request(THETA, mf, [MODE_NUMBERS[2, 2]]), "arg_out": "no"}
    _, real, imaginary, *_ = EOBRun_module.EOBRunPy(request)
    strain = np.conj(real + 1j * imaginary)
    np.testing.assert_allclose(amplitude * np.exp(-1j * psi), strain, rtol=1e-6)
    dense = np.linspace(mf[0], mf[-1], 20_000)
    np.testing.assert_allclose(np.interp(mf, dense, evaluate(teobresums, THETA, dense)[1]), psi, atol=0.05)


def test_teobresums_approaches_the_baseline_at_low_frequency(teobresums):
    """Sign of the phase, order of the stars and normalisation at once: no other choice comes near."""
    mf = smooth_nodes(5.0, 60.0, 30)
    theta = np.array([2.5, 0.4, -0.3, 50.0, 3000.0])
    amplitude, psi = evaluate(teobresums, theta, mf)
    assert np.abs(log_amplitude_ratio(theta, mf, amplitude)[0]) < 1e-4
    assert np.abs(flatten_phase(mf, phase_difference(theta, mf, psi)[None]).residual).max() < 0.3
    wrong = theta[[0, 2, 1, 3, 4]]
    assert np.abs(flatten_phase(mf, phase_difference(wrong, mf, psi)[None]).residual).max() > 10.0


def test_teobresums_is_aligned_at_its_merger(teobresums):
    """The phase is stationary after the merger: there t(f) = (1/2 pi) d psi / d f vanishes."""
    mf = np.linspace(0.036, 0.04, 20)
    _, psi = evaluate(teobresums, THETA, mf)
    assert np.abs(np.gradient(psi, mf) / (2 * np.pi)).max() < 30.0
    _, early = evaluate(teobresums, THETA, np.array([20.0, 20.001]) * mass_seconds())
    assert np.diff(early)[0] < 0.0


@pytest.mark.usefixtures("teobresums")
def test_teobresums_starts_low_enough():
    """A start 10 % below changes the first decade by less than 1e-6 rad once a shift of time and phase is removed."""
    first = 20.0 * mass_seconds()
    nodes = np.geomspace(first, 10 * first, 60)
    early, late = (TEOBResumSPA(first_mf=start) for start in (0.9 * first, first))
    difference = evaluate(early, THETA, nodes)[1] - evaluate(late, THETA, nodes)[1]
    trend = np.polynomial.Polynomial.fit(nodes, difference, 1)
    assert np.abs(difference - trend(nodes)).max() < 2e-5
    for start in (3.57, 5.0, 20.0, 100.0):
        assert start_frequency(start * mass_seconds(), 0.2) <= (start - 0.06) * mass_seconds() * (1 + 1e-12)


@pytest.mark.parametrize("theta", [[1.3, 0, 0, 1.0, 600], [1.3, 0, 0, 400, 0.5], [0.9, 0, 0, 400, 600]])
def test_teobresums_refuses_black_holes_and_swapped_masses(teobresums, theta):
    with pytest.raises(GeneratorFailure):
        evaluate(teobresums, np.array(theta, dtype=float), smooth_nodes(20.0, 1000.0, 10))


def test_teobresums_gives_the_same_bits_twice(teobresums):
    mf = smooth_nodes(20.0, 2000.0, 20)
    first, second = evaluate(teobresums, THETA, mf), evaluate(teobresums, THETA, mf)
    np.testing.assert_array_equal(first, second)


def test_teobresums_refuses_what_is_below_its_start(teobresums):
    with pytest.raises(GeneratorFailure, match="lower first_mf"):
        evaluate(teobresums, THETA, smooth_nodes(3.0, 1000.0, 10))
    low = TEOBResumSPA(first_mf=3.0 * mass_seconds())
    assert np.isfinite(evaluate(low, THETA, smooth_nodes(3.0, 1000.0, 10))).all()


APPROXIMANTS = ["TaylorF2", "IMRPhenomD_NRTidalv2", "IMRPhenomXAS_NRTidalv2", "IMRPhenomXAS_NRTidalv3"]
GENERATORS = {
    **{name: lambda name=name: LALSimulationGenerator(name) for name in APPROXIMANTS},
    "TEOBResumSPA": TEOBResumSPA,
    "a user's function": lambda: CallableGenerator.from_path("examples.own_generator:resonant_tides"),
    "of the tests": lambda: CallableGenerator.from_path("tests.surrogate.smooth_waveforms:waveform"),
}
WHOLE = smooth_nodes(5.0, 1200.0, 161)
PARTS = {
    "cut at the top": WHOLE[:60],
    "cut at the bottom": WHOLE[60:],
    "cut at both ends": WHOLE[50:70],
    "coarser": WHOLE[::8],
    "finer": np.union1d(WHOLE, np.linspace(WHOLE[0], WHOLE[-1], 3000)),
    "beyond": np.append(WHOLE, 1.05 * WHOLE[-1]),
    "two frequencies": WHOLE[[40, 41]],
}


def generator_called(name):
    if name == "TEOBResumSPA":
        pytest.importorskip("EOBRun_module")
    elif name in APPROXIMANTS:
        pytest.importorskip("lalsimulation")
    return GENERATORS[name]()


@pytest.mark.parametrize("name", GENERATORS)
@pytest.mark.parametrize("theta", [THETA, [1.0, 0.0, 0.0, 1200.0, 1200.0], [2.4, -0.3, 0.2, 30.0, 900.0]], ids=str)
def test_a_waveform_does_not_depend_on_the_grid_asked_for(name, theta):
    """Amplitude, time and constant at common frequencies."""
    generator, theta = generator_called(name), np.array(theta)
    amplitude, psi = evaluate(generator, theta, WHOLE)
    for part in PARTS.values():
        others = evaluate(generator, theta, part)
        _, first, second = np.intersect1d(WHOLE, part, return_indices=True)
        assert len(first) >= min(len(part) - 1, len(WHOLE), 2)
        np.testing.assert_allclose(others[0][second], amplitude[first], rtol=1e-9)
        np.testing.assert_allclose(others[1][second], psi[first], rtol=0.0, atol=1e-6)


@pytest.mark.parametrize("name", GENERATORS)
def test_the_constant_of_the_phase_is_continuous_over_the_parameters(name):
    """Steps of 1e-4 of a box change it by less than a tenth of a radian, many turns within the box or not."""
    generator = generator_called(name)
    theta = THETA + np.multiply.outer(np.linspace(0.0, 1e-2, 101), [2.0, 1.0, 1.0, 1000.0, 1000.0])
    mf = smooth_nodes(20.0, 300.0, 12)
    start = getattr(generator, "phase_start", 0.0)
    psi = [evaluate(generator, row, mf)[1] for row in theta]
    left = np.array([phase_difference(row, mf, own) for row, own in zip(theta, psi, strict=True)])
    constant = left[:, 0] + (merger_phase(theta, start) if start else 0.0)
    assert np.abs(np.diff(constant)).max() < 0.1


@pytest.mark.usefixtures("lal")
@pytest.mark.parametrize("approximant", APPROXIMANTS)
def test_the_time_of_an_approximant_is_that_of_its_whole_waveform(approximant):
    """On a grid that ends at 300 Hz IMRPhenomXAS_NRTidalv3 itself would be 107 ms late."""
    import lal
    import lalsimulation

    options = lal.CreateDict()
    lalsimulation.SimInspiralWaveformParamsInsertTidalLambda1(options, THETA[3])
    lalsimulation.SimInspiralWaveformParamsInsertTidalLambda2(options, THETA[4])
    lalsimulation.SimInspiralSetQuadMonParamsFromLambdas(options)
    frequencies = lal.CreateREAL8Vector(4)
    frequencies.data = np.array([20.0, 99.99, 100.01, 8192.0])
    masses = 2.8 * lal.MSUN_SI * np.array([THETA[0], 1.0]) / (1.0 + THETA[0])
    number = lalsimulation.GetApproximantFromString(approximant)
    spins = (0.0, 0.0, THETA[1], 0.0, 0.0, THETA[2])
    plus, _ = lalsimulation.SimInspiralChooseFDWaveformSequence(
        0.0, *masses, *spins, 20.0, 1e22, 0.0, options, number, frequencies
    )
    step = np.angle(plus.data.data[1] / plus.data.data[2])
    _, psi = evaluate(LALSimulationGenerator(approximant), THETA, np.array([99.99, 100.01]) * mass_seconds())
    turns = (np.diff(psi)[0] - step) / (2.0 * np.pi)
    assert turns == pytest.approx(np.round(turns), abs=1e-5)  # half a microsecond of 20 mHz


@pytest.mark.usefixtures("lal")
@pytest.mark.parametrize("options", [{"reference_mf": 0.0}, {"reference_mf": 0.5}, {"total_mass": -1.0}], ids=str)
def test_lalsimulation_refuses_options_that_make_no_sense(options):
    with pytest.raises(GeneratorUnknown, match=next(iter(options))):
        make_generator("lalsimulation", approximant="TaylorF2", **options)


@pytest.mark.usefixtures("lal")
@pytest.mark.parametrize("approximant", ["TaylorF2", "IMRPhenomXAS_NRTidalv3"])
def test_lalsimulation_gives_its_strain_with_a_continuous_phase(approximant):
    """Against the baseline at low frequency, and the same phase whether the nodes are sparse or dense."""
    generator = LALSimulationGenerator(approximant)
    sparse, dense = smooth_nodes(10.0, 900.0, 12), smooth_nodes(10.0, 900.0, 4096)
    amplitude, psi = evaluate(generator, THETA, sparse)
    assert np.abs(log_amplitude_ratio(THETA, sparse, amplitude)[0]) < 1e-2
    residual = phase_difference(THETA, sparse, psi)
    reference = phase_difference(THETA, dense, evaluate(generator, THETA, dense)[1])
    assert np.abs(np.diff(reference)).max() < 1.0
    np.testing.assert_allclose(np.interp(sparse, dense, reference), residual, atol=1e-2)


@pytest.mark.usefixtures("lal")
def test_lalsimulation_does_not_depend_on_the_total_mass_it_is_called_at():
    mf = smooth_nodes(20.0, 900.0, 30)
    light, heavy = (evaluate(LALSimulationGenerator("TaylorF2", total_mass=mass), THETA, mf) for mass in (2.0, 4.0))
    np.testing.assert_allclose(light[0], heavy[0], rtol=1e-10)
    np.testing.assert_allclose(light[1], heavy[1], atol=1e-6)


@pytest.mark.usefixtures("lal")
def test_lalsimulation_refuses_what_it_cannot_do():
    with pytest.raises(GeneratorUnknown, match="NoSuchModel"):
        make_generator("lalsimulation", approximant="NoSuchModel")
    with pytest.raises(GeneratorUnknown, match="frequency-domain"):
        make_generator("lalsimulation", approximant="TaylorT4")
    with pytest.raises(GeneratorFailure, match="zero from M f"):
        evaluate(LALSimulationGenerator("IMRPhenomD_NRTidalv2"), THETA, smooth_nodes(20.0, 2926.0, 20))


def test_smooth_nodes_are_uniform_in_their_coordinate():
    nodes = smooth_nodes(3.57, 2926.0, 80) / mass_seconds()
    assert nodes[[0, -1]] == pytest.approx([3.57, 2926.0], rel=1e-14)
    steps = np.diff(np.log(nodes) + nodes / 600.0)
    np.testing.assert_allclose(steps, steps.mean(), rtol=1e-9)
    with pytest.raises(ValueError, match="f_min"):
        smooth_nodes(10.0, 5.0, 20)


def test_flattening_keeps_what_it_removes():
    mf = smooth_nodes(5.0, 2000.0, 60)
    column = np.column_stack([THETA, THETA])
    baseline = taylorf2_phase(mf, *column) + 0 * taylorf2_amplitude(mf, *column[:3])
    shift, constant = np.array([300.0, -50.0]), np.array([1.0, -2.0])
    curved = (mf / mf[-1]) ** 2 + 2 * np.pi * mf * shift[:, None] + constant[:, None]
    flat = flatten_phase(mf, curved)
    np.testing.assert_allclose(
        flat.residual + flat.constant[:, None] + 2.0 * np.pi * flat.time_shift[:, None] * mf, curved, atol=1e-12
    )
    upper = np.argmin(np.abs(mf - 40.0 * mass_seconds()))
    np.testing.assert_allclose(flat.residual[:, [0, upper]], 0.0, atol=1e-12)
    np.testing.assert_allclose(flat.residual[0], flat.residual[1], atol=1e-9)
    assert np.diff(flat.time_shift)[0] == pytest.approx(-350.0)
    assert np.isfinite(baseline).all()


def spherical_harmonics(degree: int, order: int, inclination: float) -> tuple[float, float]:
    """Of spin weight -2 at azimuth zero, for m and -m, by Wigner's sum."""

    def one(m: int) -> float:
        fact, total = math.factorial, 0.0
        for k in range(max(0, m - 2), min(degree + m, degree - 2) + 1):
            root = math.sqrt(fact(degree + m) * fact(degree - m) * fact(degree + 2) * fact(degree - 2))
            below = fact(degree + m - k) * fact(degree - 2 - k) * fact(k) * fact(k + 2 - m)
            half = 0.5 * inclination
            total += (
                (-1) ** k
                * root
                / below
                * math.cos(half) ** (2 * degree + m - 2 - 2 * k)
                * math.sin(half) ** (2 * k + 2 - m)
            )
        return total * math.sqrt((2 * degree + 1) / (4.0 * math.pi))

    return one(order), one(-order)


@pytest.mark.parametrize("inclination", [0.4, 2.0])
def test_modes_sum_to_minus_the_polarisations_that_teobresums_gives_a_quarter_of_a_turn_away(
    inclination: float,
) -> None:
    generator = TEOBResumSPA()
    theta = np.array([1.7, 0.2, -0.1, 400.0, 600.0])
    mf = np.geomspace(2.0 * generator.first_mf, 0.03, 64)
    modes = generator.modes(theta, dict.fromkeys(MODE_NUMBERS, mf))
    plus, cross = np.zeros(64, complex), np.zeros(64, complex)
    for (degree, order), (amplitude, psi) in modes.items():
        up, down = spherical_harmonics(degree, order, inclination)
        parity = (-1) ** degree
        strain = -((-1j) ** order) * amplitude * np.exp(-1j * psi) / np.sqrt(5.0 / (4.0 * np.pi))
        plus += strain * (up + parity * down)
        cross += -1j * strain * (up - parity * down)
    request = generator._request(theta, mf, sorted(MODE_NUMBERS.values()))
    answer = EOBRun_module.EOBRunPy(request | {"inclination": inclination})
    theirs = [np.asarray(answer[2 * i + 1]) - 1j * np.asarray(answer[2 * i + 2]) for i in (0, 1)]
    # Their time is shifted by the merger's, which ours is not: a common factor of both.
    turn = theirs[0] / plus
    assert np.abs(np.abs(turn) - 1.0).max() < 1e-6
    np.testing.assert_allclose(theirs[1], cross * turn, rtol=0.0, atol=1e-6 * np.abs(plus).max())


def test_a_mode_starts_at_its_share_of_the_first_frequency() -> None:
    generator, theta = TEOBResumSPA(), np.array([1.7, 0.2, -0.1, 400.0, 600.0])
    with pytest.raises(GeneratorFailure, match="below 2 times first_mf"):
        generator.modes(theta, {(4, 4): np.geomspace(generator.first_mf, 0.02, 8)})
    with pytest.raises(GeneratorFailure, match=r"no mode \(5, 5\)"):
        generator.modes(theta, {(5, 5): np.geomspace(generator.first_mf, 0.02, 8)})


@pytest.mark.parametrize("theta", [[1.7, 0.2, -0.1, 400.0, 600.0], [3.0, -0.5, 0.5, 5.0, 5000.0]], ids=str)
def test_a_signal_that_begins_lower_may_have_its_phase_zero_where_another_has(theta: list[float]) -> None:
    """Of all modes, as one orbital phase; the merger is at zero in both."""
    first = TEOBResumSPA().first_mf
    usual, lower = TEOBResumSPA(), TEOBResumSPA(first_mf=0.5 * first, zero_mf=first)
    assert lower.phase_start == usual.phase_start
    assert "zero_mf" not in usual.settings
    mf = dict.fromkeys(MODE_NUMBERS, np.geomspace(2.0 * first, 0.03, 20))
    ours, theirs = (generator.modes(np.array(theta), mf) for generator in (lower, usual))
    for mode in MODE_NUMBERS:
        allowed = mode[1] * 2.5e-4 + 2.0 * np.pi * mf[mode] * 0.08  # mergers are at the same time to a microsecond
        assert (np.abs(ours[mode][1] - theirs[mode][1]) < allowed).all()
    elsewhere = TEOBResumSPA(first_mf=0.5 * first).modes(np.array(theta), mf)
    assert abs(elsewhere[2, 2][1][0] - theirs[2, 2][1][0]) > 1e5
    with pytest.raises(GeneratorUnknown, match="zero_mf lies between first_mf"):
        TEOBResumSPA(zero_mf=0.5 * first)
