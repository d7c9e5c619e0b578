"""Forecasts: derivatives of signals are those of the signals, integrals are those of a dense grid, and what cannot be
measured is said."""

import dataclasses

import numpy as np
import pytest

from bnserve_inference import Detector, detector_strain
from bnserve_inference._modes import orders
from bnserve_inference.fisher import COORDINATES, ForecastOptions, Network, NoiseCurve, forecast, signal_to_noise
from bnserve_inference.fisher._factorisation import Factorisation
from bnserve_inference.fisher._forecasting import NAMES, _jacobian
from bnserve_inference.fisher._gauss import gauss, slopes
from bnserve_inference.fisher._matrix import condition
from bnserve_inference.fisher._nodes import Nodes, nodes_of
from bnserve_protocol import (
    AnalysisInvalid,
    EvaluationOptions,
    InvalidRequest,
    LikelihoodBatch,
    LikelihoodParameters,
    RowStatus,
    decode_network,
)
from bnserve_surrogate import Model
from tests.service.chirp import ChirpModel

TRIGGER = 1187008882.4
BINARY = LikelihoodParameters(
    mass_ratio=1.3, lambda_1=300.0, lambda_2=700.0, chi_1=0.05, chi_2=-0.02, inclination=0.7, total_mass=2.8,
    right_ascension=1.1, declination=0.4, polarization_angle=0.6, distance_mpc=100.0, coalescence_time=0.01,
    reference_phase=1.2,
)  # fmt: skip
STEPS = {
    "mass_ratio": 4e-7, "lambda_1": 0.5, "lambda_2": 0.5, "chi_1": 1e-5, "chi_2": 1e-5, "distance_mpc": 0.1,
    "inclination": 1e-3, "total_mass": 2e-7, "reference_phase": 1e-2, "coalescence_time": 1e-6,
    "right_ascension": 1e-3, "declination": 1e-3, "polarization_angle": 1e-3,
}  # fmt: skip


@pytest.fixture(scope="module")
def model():
    return Model.load("default", "2.0.0")


def curve(low=2.0, high=4000.0):
    """Something like the Einstein Telescope's, smooth."""
    f = np.geomspace(low, high, 3000)
    x = f / 100.0
    return NoiseCurve.of(f, 3e-25 * (1.0 + (6.0 / f) ** 8 + 0.3 / x + 0.1 * x))


def network(detectors=("E1", "E2", "E3"), f_min=10.0, f_max=1900.0, moving=True):
    return Network(list(detectors), [curve()] * len(detectors), f_min, f_max, TRIGGER, moving)


def panels_of(own, f, weights):
    """Frequencies as panels of eight, together; all detectors have one curve."""
    [noise] = own.curves
    places = np.arange(len(f)).reshape(-1, 8)
    count = len(places)
    scaled = (weights / noise.at(f) ** 2).reshape(-1, 8)
    return Nodes(f, places, scaled, np.zeros(count, np.int64), np.zeros(count, bool))


def factored(model, own, modes, nodes, batch, **options):
    """Triangles and whitened derivatives in the parameters themselves."""
    found = model.predict_derivatives(
        nodes.frequencies, batch.waveform_batch(), options=EvaluationOptions(alignment="merger", modes=modes)
    )
    same = np.broadcast_to(np.eye(len(NAMES)), (len(batch), len(NAMES), len(NAMES)))
    return Factorisation(own, nodes, modes)(found, batch, same, **options)


def of_signals(model, own, modes, at):
    """Derivatives of signals in each detector before they are whitened, ``(13, D, K)``."""
    nodes = panels_of(own, at, np.ones(len(at)))
    whitened = factored(model, own, modes, nodes, LikelihoodBatch.coerce(BINARY), whitened=True).whitened[0]
    real, imaginary = np.moveaxis(whitened.reshape(-1, len(own.sites), 2, len(NAMES), 8), 2, 0)
    shaped = np.moveaxis(real + 1j * imaginary, 0, 2).reshape(len(own.sites), len(NAMES), len(at)).swapaxes(0, 1)
    return shaped / np.sqrt(4.0 * nodes.weights.ravel()) * np.exp(-2j * np.pi * at * BINARY.coalescence_time)


def by_differences(model, detector, at, name, modes, response):
    def strain(value):
        given = dataclasses.replace(BINARY, **{name: value})
        return detector_strain(detector, at, model, given, trigger_time=TRIGGER, modes=modes, response=response)

    middle, step = getattr(BINARY, name), STEPS[name]
    near, far = (strain(middle + k * step) - strain(middle - k * step) for k in (1, 2))
    return (8.0 * near - far) / (12.0 * step)


SITES = {
    "short": ["E1", "H1"],
    "with arms": [Detector.named("CE40", finite_arms=True), Detector.named("H1", finite_arms=True)],
}


@pytest.mark.parametrize("response", ["moving", "static"])
@pytest.mark.parametrize("sites", SITES.values(), ids=SITES)
def test_derivatives_are_those_of_the_signal(model, sites, response):
    at = np.geomspace(10.0, 1500.0, 160)
    modes = tuple(sorted({tuple(mode) for mode in model.description.modes}))
    own = network(sites, moving=response == "moving")
    ours = of_signals(model, own, modes, at)
    for place, name in enumerate(NAMES):
        for d, detector in enumerate(own.sites):
            expected = by_differences(model, detector, at, name, modes, response)
            error = np.abs(ours[place, d] - expected).max() / np.abs(expected).max()
            # With a response that moves, by what differences of a spline of passing times are off.
            assert error < (5e-5 if response == "moving" else 5e-6), name


def matrix_on(model, own, modes, nodes):
    [root] = factored(model, own, modes, nodes, LikelihoodBatch.coerce(BINARY)).root
    return root.T @ root


@pytest.mark.parametrize("modes", [((2, 2),), ((2, 1), (2, 2), (3, 3), (4, 4))], ids=["one", "several"])
def test_integrals_are_those_of_a_dense_grid(model, modes):
    """Of products of different modes, too: the largest of any, to a part in a million of what both have alone.

    The noise has a wall, as on the ground: a sharp edge of the band is seen by products of modes, which turn.
    """
    smooth = curve()
    walled = NoiseCurve.of(smooth.frequencies, smooth.asd * (1.0 + (28.0 / smooth.frequencies) ** 20))
    own = Network(["E1", "E2", "E3"], [walled] * 3, 22.0, 1900.0, TRIGGER)
    f = np.geomspace(22.0, 1900.0, 160_000)
    weights = np.gradient(f)
    weights[[0, -1]] = 0.5 * np.abs(np.diff(f)[[0, -1]])
    expected = matrix_on(model, own, modes, panels_of(own, f, weights))
    found = matrix_on(model, own, modes, nodes_of(own, orders(modes)))
    scale = np.sqrt(np.diag(expected))
    assert np.abs((found - expected) / np.outer(scale, scale)).max() < 1e-6


def test_panels_integrate_what_is_smooth_over_noise_that_is_not():
    """Lines, a notch and a knot inside of a panel: polynomials of degree 15 in log f, against a fine sum."""
    f = np.geomspace(10.0, 40.0, 400)
    lines = NoiseCurve.of(f, 1e-24 * (1.0 + 300.0 * (np.arange(400) % 37 == 5) + (np.abs(f - 23.0) < 0.4) * 1e8))
    edges = np.geomspace(10.0, 40.0, 8)
    places, weights = gauss(edges, lambda at: lines.at(at) ** -2.0, f)
    assert (np.diff(places.ravel()) > 0.0).all()
    fine, own = gauss(
        np.unique(np.concatenate([edges, np.geomspace(10.0, 40.0, 9001)])), lambda at: lines.at(at) ** -2.0, f
    )
    for power in range(16):
        x, y = (np.log(it / 20.0) ** power for it in (places, fine))
        assert (weights * x).sum() == pytest.approx((own * y).sum(), rel=1e-9), power


def test_slopes_of_panels_are_those_of_polynomials():
    x = np.sort(np.random.default_rng(3).uniform(-1.0, 1.0, (5, 8)), axis=1)
    for power in range(1, 8):
        np.testing.assert_allclose((slopes(x) @ (x**power)[..., None])[..., 0], power * x ** (power - 1), atol=1e-9)


@pytest.mark.parametrize("moving", [True, False], ids=["moving", "static"])
@pytest.mark.parametrize("modes", [((2, 2),), None], ids=["one", "all"])
def test_signal_to_noise_ratios_alone_are_those_of_forecasts(model, modes, moving):
    """In detectors of two noise curves; a row out of the model's range, too."""
    values = LikelihoodBatch.coerce(BINARY).values.repeat(3, axis=0)
    batch = LikelihoodBatch(values.copy())
    batch["mass_ratio"][:] = [1.3, 99.0, 1.9]
    own = Network(["E1", "E2", "H1"], [curve(), curve(), curve(15.0, 900.0)], 10.0, 1900.0, TRIGGER, moving)
    options = ForecastOptions(modes=modes)
    alone, whole = signal_to_noise(model, own, batch, options), forecast(model, own, batch, options)
    assert alone.status.tolist() == whole.status.tolist()
    np.testing.assert_allclose(alone.detector_snr, whole.detector_snr, rtol=1e-6)
    np.testing.assert_allclose(alone.snr, whole.snr, rtol=1e-6)
    assert np.isnan(alone.snr[1])
    assert len(signal_to_noise(model, own, LikelihoodBatch(np.zeros((0, 13))), options).snr) == 0


def test_what_is_measured_and_what_is_not(model):
    samples = LikelihoodBatch.coerce(BINARY)
    three = forecast(model, network(), samples)
    assert three.names == (*COORDINATES, "right_ascension", "declination", "polarization_angle")
    assert not three.singular[0]
    assert three.snr[0] == pytest.approx(np.sqrt((three.detector_snr[0] ** 2).sum()))
    errors = three.errors()
    assert errors["log_chirp_mass"][0] < 1e-4
    assert 0.0 < three.sky_area(np.array([0.4]))[0] < 1e4
    units = np.sqrt(np.diag(three.matrix[0]))
    product = (three.covariance[0] * np.outer(units, units)) @ (three.matrix[0] / np.outer(units, units))
    np.testing.assert_allclose(product, np.eye(13), atol=1e-6)
    # One detector that stands still sees a complex number: distance, orientation and place are one another.
    one = forecast(model, network(["E1"], moving=False), samples, ForecastOptions(modes=[(2, 2)]))
    assert one.singular[0]
    assert np.isnan(one.covariance).all()
    assert np.isfinite(one.snr).all()
    wide = {"inclination": 0.5, "log_distance": 1.0, "right_ascension": 1.0, "declination": 1.0,
            "polarization_angle": 1.0, "reference_phase": 3.0}  # fmt: skip
    with_priors = forecast(model, network(["E1"], moving=False), samples, ForecastOptions(modes=[(2, 2)], priors=wide))
    assert not with_priors.singular[0]
    assert with_priors.errors()["inclination"][0] <= 0.5


def test_errors_do_not_depend_on_where_the_phase_is_held(model):
    samples = LikelihoodBatch.coerce(BINARY)
    one, other = (
        forecast(model, network(), samples, ForecastOptions(reference_frequency=f)).errors() for f in (40.0, 150.0)
    )
    for name in ("log_chirp_mass", "lambda_tilde", "chi_1", "log_distance", "right_ascension"):
        assert one[name][0] == pytest.approx(other[name][0], rel=1e-4)


def test_louder_is_better_in_proportion(model):
    near, far = (
        forecast(model, network(), LikelihoodBatch.coerce(dataclasses.replace(BINARY, distance_mpc=d)))
        for d in (50.0, 100.0)
    )
    assert near.snr[0] == pytest.approx(2.0 * far.snr[0])
    assert near.errors()["chi_1"][0] == pytest.approx(0.5 * far.errors()["chi_1"][0], rel=1e-5)


def test_rows_that_are_none_are_flagged(model):
    values = LikelihoodBatch.coerce(BINARY).values.repeat(3, axis=0)
    batch = LikelihoodBatch(values.copy())
    batch["mass_ratio"][:] = [1.3, 99.0, 1.3]
    found = forecast(model, network(), batch)
    assert found.status.tolist() == [RowStatus.OK, RowStatus.OUT_OF_DOMAIN, RowStatus.OK]
    assert np.isnan(found.snr[1])
    assert np.isnan(found.covariance[1]).all()
    assert found.snr[0] == found.snr[2]


def test_directions_that_leave_the_model_are_said(model):
    found = forecast(model, network(), LikelihoodBatch.coerce(dataclasses.replace(BINARY, distance_mpc=4000.0)))
    assert found.beyond[0, found.names.index("chi_1")]


def test_what_is_no_network_or_prior_is_refused(model):
    with pytest.raises(AnalysisInvalid, match="a noise curve for each"):
        Network(["E1", "E2"], [curve()], 5.0, 100.0, TRIGGER)
    with pytest.raises(AnalysisInvalid, match="0 < f_min < f_max"):
        network(f_min=100.0, f_max=10.0)
    with pytest.raises(AnalysisInvalid, match="no detector 'X9'"):
        network(["X9"])
    with pytest.raises(AnalysisInvalid, match="has data in the band"):
        Network(["E1"], [curve(5000.0, 6000.0)], 5.0, 100.0, TRIGGER)
    with pytest.raises(AnalysisInvalid, match="PSD"):
        NoiseCurve.of([1.0, 2.0], [1e-46, 1e-47])
    with pytest.raises(InvalidRequest, match="positive width"):
        forecast(model, network(), BINARY, ForecastOptions(priors={"mass_ratio": 1.0}))
    with pytest.raises(InvalidRequest, match="none of them"):
        forecast(model, network(), BINARY, ForecastOptions(coordinates=("chirp", *COORDINATES[1:])))


def test_a_row_that_coordinates_cannot_tell_from_others_is_named_by_its_place_in_the_whole_batch(model):
    """Rows before it that are not evaluated, and blocks before its own, count."""
    batch = LikelihoodBatch(np.repeat(LikelihoodBatch.coerce(BINARY).values, 1030, axis=0))
    batch["total_mass"][:3] = 9.0
    batch["mass_ratio"][1027] = 1.0
    options = ForecastOptions(coordinates=("log_chirp_mass", "symmetric_mass_ratio", *COORDINATES[2:]), modes=((2, 2),))
    with pytest.raises(InvalidRequest, match="Row 1027: ") as caught:
        forecast(model, network(["E1"], 400.0, 500.0), batch, options)
    assert [error.row for error in caught.value.errors] == [1027]


ALL = ((2, 1), (2, 2), (3, 1), (3, 2), (3, 3), (4, 3), (4, 4))


@pytest.mark.parametrize("modes", [((2, 2),), ALL], ids=["one", "all"])
@pytest.mark.parametrize("detectors", [["H1"], ["E1", "E2", "E3", "H1", "L1", "V1"]], ids=len)
def test_triangles_are_those_of_a_qr_factorisation(model, modes, detectors):
    """With orders apart and together; of more detectors than are folded at once, too."""
    own, batch = network(detectors), LikelihoodBatch.coerce(BINARY)
    found = factored(model, own, modes, nodes_of(own, orders(modes)), batch, whitened=True)
    rows = found.whitened[0].swapaxes(1, 2).reshape(-1, len(NAMES))
    scale = np.sqrt((rows**2).sum(axis=0))
    expected = np.abs(np.linalg.qr(rows / scale, mode="r"))
    np.testing.assert_allclose(np.abs(found.root[0] / scale), expected, rtol=1e-6, atol=1e-13)
    assert (np.diag(found.root[0]) >= 0.0).all()
    assert (np.tril(found.root[0], -1) == 0.0).all()


def test_priors_are_rows_more(model):
    own, batch = network(), LikelihoodBatch.coerce(BINARY)
    plain, narrow = (
        forecast(model, own, batch, ForecastOptions(priors=priors))
        for priors in (None, {"lambda_tilde": 3.0, "inclination": 0.1})
    )
    more = np.zeros(len(NAMES))
    more[[plain.names.index(name) for name in ("lambda_tilde", "inclination")]] = 1.0 / 9.0, 100.0
    np.testing.assert_allclose(narrow.matrix[0], plain.matrix[0] + np.diag(more), rtol=1e-9)


def test_a_row_is_the_same_bits_in_any_batch(model):
    values = LikelihoodBatch.coerce(BINARY).values.repeat(9, axis=0)
    batch = LikelihoodBatch(values.copy())
    batch["mass_ratio"][:] = np.linspace(1.0, 2.0, 9)
    own = network(["E1", "H1"])
    whole, alone = forecast(model, own, batch), signal_to_noise(model, own, batch)
    for row in (0, 4, 8):
        [one] = batch.rows(slice(row, row + 1)).split(1)
        assert forecast(model, own, one).root.tobytes() == whole.root[row].tobytes()
        assert signal_to_noise(model, own, one).detector_snr.tobytes() == alone.detector_snr[row].tobytes()


def test_errors_are_those_of_extended_precision(model):
    """Against columns that are made orthogonal three times in extended precision, coordinates first."""
    own, batch, modes = network(), LikelihoodBatch.coerce(BINARY), ((2, 2),)
    rows = factored(model, own, modes, nodes_of(own, orders(modes)), batch, whitened=True).whitened[0]
    options = ForecastOptions(modes=modes)
    ours = forecast(model, own, batch, options)
    jacobian = _jacobian(model, batch, options)[0][0].astype(np.longdouble)
    columns = rows.swapaxes(1, 2).reshape(-1, len(NAMES)).astype(np.longdouble) @ jacobian
    scale = np.sqrt((columns**2).sum(axis=0))
    columns, root = columns / scale, np.zeros((len(NAMES), len(NAMES)), np.longdouble)
    for k in range(len(NAMES)):
        for _ in range(3):
            for j in range(k):
                along = columns[:, j] @ columns[:, k]
                root[j, k] += along
                columns[:, k] -= along * columns[:, j]
        root[k, k] = np.sqrt(columns[:, k] @ columns[:, k])
        columns[:, k] /= root[k, k]
    inverse = np.linalg.inv(root.astype(float)).astype(np.longdouble)
    for _ in range(3):
        inverse = inverse @ (2.0 * np.eye(len(NAMES)) - root @ inverse)
    expected = np.sqrt((inverse**2).sum(axis=1)) / scale
    np.testing.assert_allclose(list(ours.errors().values()), expected.astype(float)[:, None], rtol=1e-9)


def test_a_direction_that_changes_nothing_has_no_condition():
    assert np.isinf(condition(np.zeros((1, 3, 3)))[0])
    assert condition(np.eye(3)[None])[0] == pytest.approx(1.0)


@pytest.mark.parametrize(("name", "best"), [("ET-D", 3.19e-25), ("CE40", 7.76e-26), ("CE20", 1.74e-25)])
def test_curves_come_with_the_package(name, best):
    assert NoiseCurve.named(name).asd.min() == pytest.approx(best, rel=0.01, abs=0.0)


def test_curves_are_read(tmp_path):
    file = tmp_path / "curve.txt"
    file.write_text("# Hz, ASD\n10 1e-23\n20 1e-24\n")
    assert NoiseCurve.read(file).asd.tolist() == [1e-23, 1e-24]
    file.write_text("nothing")
    with pytest.raises(AnalysisInvalid, match="is no text file of two columns"):
        NoiseCurve.read(file)
    with pytest.raises(AnalysisInvalid, match="no noise curve 'ET-E'; known are ET-D"):
        NoiseCurve.named("ET-E")


def test_what_leaves_the_range_of_numbers_or_the_band_is_flagged(model):
    rows = [dataclasses.replace(BINARY, distance_mpc=distance) for distance in (100.0, 1e-300)]
    heavy = dataclasses.replace(BINARY, total_mass=95.0)
    own, options = network(), ForecastOptions(modes=[(2, 2)], reference_frequency=300.0)
    found = forecast(model, own, [*rows, heavy], options)
    assert found.status.tolist() == [RowStatus.OK, RowStatus.NOT_FINITE, RowStatus.OUT_OF_BAND]
    assert np.isnan(found.snr[1:]).all()
    assert np.isfinite(found.root[0]).all()
    assert signal_to_noise(model, own, [*rows, heavy], options).status.tolist() == [0, RowStatus.NOT_FINITE, 0]


def test_priors_and_references_that_are_no_numbers_of_use_are_refused(model):
    for width in (0.0, -1.0, np.inf, np.nan):
        with pytest.raises(InvalidRequest, match="positive width"):
            forecast(model, network(), BINARY, ForecastOptions(priors={"chi_1": width}))
    for reference in (0.0, 1e-300, 1e10, np.nan):
        with pytest.raises(InvalidRequest, match="reference frequency"):
            forecast(model, network(), BINARY, ForecastOptions(reference_frequency=reference))


def test_signals_that_last_for_longer_than_can_be_integrated_are_refused(model):
    low = Network(["E1"], [NoiseCurve.of([1e-6, 1e5], [1e-24, 1e-24])], 0.01, 2048.0, TRIGGER)
    with pytest.raises(AnalysisInvalid, match="higher f_min"):
        forecast(model, low, BINARY)


def test_nobodys_forecasts_are_none(model):
    found = forecast(model, network(), LikelihoodBatch(np.empty((0, 13))))
    assert found.root.shape == (0, 13, 13)
    assert found.covariance.shape == (0, 13, 13)
    assert found.detector_snr.shape == (0, 3)


def test_a_network_is_what_its_description_says():
    arms = Detector.named("CE40", finite_arms=True)
    own = network([arms, "H1"], moving=False)
    again = Network.of(decode_network(own.description.body))
    assert again.description.digest == own.description.digest
    assert [site.name for site in again.sites] == ["CE40", "H1"]
    assert again.sites[0].arms.tolist() == arms.arms.tolist()
    assert not again.moving


def test_a_model_without_derivatives_is_refused():
    with pytest.raises(InvalidRequest, match=r"does not say that it has derivatives.*ask for signal-to-noise ratios"):
        forecast(ChirpModel(), network(), [BINARY])
