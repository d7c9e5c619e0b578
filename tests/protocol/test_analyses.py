"""Analyses on the wire: one form, one digest, and nothing that contradicts itself."""

import dataclasses

import msgpack
import msgspec
import numpy as np
import pytest

from bnserve_protocol import (
    Analysis,
    AnalysisInvalid,
    AnalysisSettings,
    Calibration,
    DistanceMarginalisation,
    TimeGrid,
    TimeMarginalisation,
    UndecodableBody,
    decode_analysis,
    encode_analysis,
    time_steps,
)

SETTINGS = AnalysisSettings(
    kind="roq",
    detectors=("H1", "L1"),
    f_min=20.0,
    f_max=100.0,
    duration=4.0,
    trigger_time=1.2e9,
    sidereal_time=0.5,
    sidereal_rate=7.29e-5,
    prior={"chirp_mass": (1.1, 1.3), "coalescence_time": (-0.1, 0.1)},
    time_grid=TimeGrid(start=-0.2, step=0.01),
)


def arrays(settings=SETTINGS, linear=3, quadratic=2, times=41):
    draw = np.random.default_rng(0)
    found = {}
    if settings.kind != "full":
        found = {
            "linear_nodes": np.linspace(20.0, 100.0, linear),
            "quadratic_nodes": np.linspace(25.0, 90.0, quadratic),
        }
    for name in settings.detectors:
        found[f"response/{name}"] = np.eye(3)
        found[f"location/{name}"] = np.ones(3)
        found[f"linear_weights/{name}"] = draw.normal(size=(times, linear)) + 1j
        found[f"quadratic_weights/{name}"] = draw.normal(size=quadratic)
    return found


def full():
    settings = msgspec.structs.replace(SETTINGS, kind="full", time_grid=None)
    return settings, arrays(settings, linear=321, quadratic=321, times=1)


def body_of(analysis):
    return b"".join(encode_analysis(analysis))


def test_an_analysis_travels_unchanged():
    for settings, values in ((SETTINGS, arrays()), full()):
        analysis = Analysis(settings, values)
        there = decode_analysis(body_of(analysis))
        assert there.settings == analysis.settings
        assert there.digest == analysis.digest
        assert set(there.arrays) == set(values)
        for name, array in values.items():
            assert (there.arrays[name] == array).all()


def test_its_digest_names_the_content_and_not_the_order_or_the_types_it_was_given_in():
    analysis = Analysis(SETTINGS, arrays())
    backwards = Analysis(SETTINGS, dict(reversed(arrays().items())))
    integers = msgspec.structs.replace(SETTINGS, f_min=20, duration=np.float64(4.0), detectors=["H1", "L1"])
    reordered = msgspec.structs.replace(SETTINGS, prior=dict(reversed(SETTINGS.prior.items())))
    for other in (backwards, Analysis(integers, arrays()), Analysis(reordered, arrays())):
        assert other.digest == analysis.digest
    changed = arrays()
    changed["location/L1"] = np.array([1.0, 1.0, 1.0 + 1e-12])
    assert Analysis(SETTINGS, changed).digest != analysis.digest


def test_any_messagepack_library_reads_it():
    message = msgpack.unpackb(body_of(Analysis(SETTINGS, arrays())), strict_map_key=False)
    assert message["settings"]["kind"] == "roq"
    weights = message["arrays"]["linear_weights/H1"]
    assert weights[b"type"] == "<c16"
    assert weights[b"shape"] == [41, 3]


def test_arrays_are_read_only_and_are_not_copied_on_the_wire():
    values = arrays()
    analysis = Analysis(SETTINGS, values)
    array = analysis.arrays["linear_weights/H1"]
    with pytest.raises(ValueError, match="read-only"):
        array[0, 0] = 1.0
    values["linear_weights/H1"][0, 0] = 99.0  # ours to change: the analysis has its own
    assert array[0, 0] != 99.0
    parts = encode_analysis(analysis)
    assert any(
        isinstance(part, memoryview) and np.shares_memory(np.frombuffer(part, np.uint8), array) for part in parts
    )
    with pytest.raises(dataclasses.FrozenInstanceError):
        analysis.digest = "sha256:0"


def test_bounds_and_widths_that_are_the_default_are_not_written():
    """So messages and digests from before there were any are what they were: this one is."""
    calibration = Calibration(nodes=10, f_min=20.0, f_max=100.0)
    before = Analysis(msgspec.structs.replace(SETTINGS, calibration=calibration), arrays())
    assert before.digest == "sha256:04ac6c1ee681a363ef501064e38d2a87754adaa31033f44528120ce384b7296c"
    assert (before.settings.calibration.amplitude_width, before.settings.calibration.phase_width) == (0.05, 0.05)
    stated = msgspec.structs.replace(calibration, amplitude_width=0.1 / 2, phase_width=0.1 / 2)
    again = Analysis(msgspec.structs.replace(SETTINGS, calibration=stated, error_bound=0.1 / 2), arrays())
    assert again.digest == decode_analysis(body_of(again)).digest == before.digest


def test_other_bounds_and_widths_travel():
    calibration = Calibration(nodes=10, f_min=20.0, f_max=100.0, amplitude_width=0.02, phase_width=0.03)
    analysis = Analysis(msgspec.structs.replace(SETTINGS, calibration=calibration, error_bound=0.2), arrays())
    there = decode_analysis(body_of(analysis))
    assert there.digest == analysis.digest
    assert (there.settings.calibration, there.settings.error_bound) == (calibration, 0.2)


def test_the_nodes_of_a_full_analysis_are_its_grid():
    settings, values = full()
    analysis = Analysis(settings, values)
    assert (analysis.linear_nodes == np.arange(80, 401) / 4.0).all()
    assert analysis.nbytes == sum(array.nbytes for array in values.values())


BAD_ARRAYS = {
    "missing": ({"location/L1": None}, "'location/L1' of the analysis is missing"),
    "unknown": ({"location/V1": np.ones(3)}, "'location/V1' of the analysis is unknown"),
    "shape": ({"response/H1": np.eye(2)}, r"float64 of shape \(3, 3\); got float64 \(2, 2\)"),
    "other nodes": ({"linear_weights/H1": np.ones((41, 4), complex)}, r"shape \(T, 3\)"),
    "real weights": ({"linear_weights/H1": np.ones((41, 3))}, "must be complex128"),
    "complex noise": ({"quadratic_weights/H1": np.ones(2, complex)}, "must be float64"),
    "not finite": ({"linear_weights/H1": np.full((41, 3), np.nan + 0j)}, "NaN or infinite"),
    "too few times": ({"linear_weights/H1": np.ones((20, 3), complex)}, "covers arrivals from"),
    "no times": ({"linear_weights/H1": np.ones((0, 3), complex)}, "covers arrivals from"),
    "unsorted nodes": ({"linear_nodes": np.array([20.0, 50.0, 40.0])}, "increasing frequencies"),
    "nodes beyond the band": ({"quadratic_nodes": np.array([50.0, 101.0])}, "between f_min"),
    "no nodes": ({"quadratic_nodes": np.zeros(0)}, "increasing frequencies"),
    "a detector at the Moon": ({"location/H1": np.array([3.8e8, 0.0, 0.0])}, "beyond the surface of the Earth"),
    "a detector in kilometres": ({"location/H1": np.array([0.0, 6378.0, 0.0])}, "give its location in metres"),
    "words": ({"linear_nodes": np.array(["a", "b", "c"])}, "must hold numbers"),
}


@pytest.mark.parametrize("case", BAD_ARRAYS)
def test_arrays_that_do_not_fit_are_refused(case):
    change, reason = BAD_ARRAYS[case]
    values = {name: array for name, array in (arrays() | change).items() if array is not None}
    with pytest.raises(AnalysisInvalid, match=reason):
        Analysis(SETTINGS, values)


FAR = DistanceMarginalisation(minimum=10.0, maximum=75.0)
AGES = TimeMarginalisation(minimum=-9e5, maximum=9e5)
ENDLESS = TimeMarginalisation(minimum=-1e308, maximum=1e308)


def tabulated(*entries, count=10):
    table = (*entries, *[0.0] * (count - len(entries)))
    return DistanceMarginalisation(minimum=10.0, maximum=75.0, table=table)


BAD_SETTINGS = {
    "no detectors": ({"detectors": ()}, "1 to 16 detectors"),
    "a detector twice": ({"detectors": ("H1", "H1")}, "distinct names"),
    "a detector with a slash": ({"detectors": ("H1", "../L1")}, "distinct names"),
    "band": ({"f_min": 200.0}, "not a grid"),
    "NaN": ({"f_min": float("nan")}, "'f_min' of the analysis must be positive"),
    "trigger": ({"trigger_time": float("inf")}, "'trigger_time' of the analysis must be finite"),
    "unknown parameter": ({"prior": SETTINGS.prior | {"mass": (1.0, 2.0)}}, "Unknown parameter 'mass'"),
    "range": ({"prior": SETTINGS.prior | {"chirp_mass": (2.0, 1.0)}}, "range of 'chirp_mass'"),
    "no time prior": ({"prior": {}}, "range of 'coalescence_time'"),
    "no time grid": ({"time_grid": None}, "needs a time grid"),
    "time step": ({"time_grid": TimeGrid(start=0.0, step=0.0)}, "'time_grid.step'"),
    "times": ({"time_marginalisation": TimeMarginalisation(minimum=0.1, maximum=0.0, step=1e-3)}, "minimum < maximum"),
    "many times": ({"time_marginalisation": TimeMarginalisation(minimum=0.0, maximum=0.1, step=1e-9)}, "more than"),
    "distance": ({"distance_marginalisation": DistanceMarginalisation(minimum=0.0, maximum=10.0)}, "0 < minimum"),
    "a short table": ({"distance_marginalisation": tabulated(0.0, count=7)}, "has 8 to 1024 entries; got 7"),
    "a long table": ({"distance_marginalisation": tabulated(0.0, count=1025)}, "length <= 1024"),
    "a table of anything": ({"distance_marginalisation": tabulated(0.0, 101.0)}, "finite logarithms"),
    "a table with NaN": ({"distance_marginalisation": tabulated(0.0, float("nan"))}, "finite logarithms"),
    "a table without end": ({"distance_marginalisation": tabulated(0.0, float("-inf"))}, "finite logarithms"),
    "calibration": ({"calibration": Calibration(nodes=2, f_min=20.0, f_max=100.0)}, "'calibration.nodes'"),
    "a width of calibration errors": (
        {"calibration": Calibration(nodes=4, f_min=20.0, f_max=100.0, phase_width=float("nan"))},
        "'calibration.phase_width'",
    ),
    "a reference frequency of nothing": ({"reference_frequency": 0.0}, "'reference_frequency'"),
    "a reference frequency without end": ({"reference_frequency": float("inf")}, "'reference_frequency'"),
    "an error bound": ({"error_bound": 0.0}, "'error_bound'"),
    "a mass ratio from zero": ({"prior": SETTINGS.prior | {"mass_ratio": (0.0, 3.0)}}, "heavier mass over the lighter"),
    "a mass of nothing": ({"prior": SETTINGS.prior | {"total_mass": (0.0, 3.0)}}, "masses are positive"),
    "a negative tide": ({"prior": SETTINGS.prior | {"lambda_1": (-1.0, 3.0)}}, "not negative"),
    "a spin beyond one": ({"prior": SETTINGS.prior | {"chi_2": (-1.5, 1.0)}}, "no spin exceeds one"),
    "a distance before here": ({"prior": SETTINGS.prior | {"distance_mpc": (-1.0, 9.0)}}, "distances are positive"),
    "a reversed range of times": ({"prior": {"coalescence_time": (0.1, -0.1)}}, "finite and increasing"),
    "NaN for a range of times": ({"prior": {"coalescence_time": (float("nan"), 0.1)}}, "finite and increasing"),
    "a distance prior beside an integral": (
        {"prior": SETTINGS.prior | {"distance_mpc": (10.0, 75.0)}, "distance_marginalisation": FAR},
        "'prior' states a range of 'distance_mpc' as well",
    ),
    "a phase prior beside an integral": (
        {"prior": SETTINGS.prior | {"reference_phase": (0.0, 1.0)}, "phase_marginalisation": True},
        "over the whole circle",
    ),
    "distances without end": (
        {"distance_marginalisation": DistanceMarginalisation(minimum=1e-9, maximum=1e9)},
        "more than a factor",
    ),
    "a range of times that no band resolves": (
        {"prior": {"coalescence_time": (-1e6, 1e6)}, "time_marginalisation": AGES, "f_max": 1e4},
        "asks for .* times",
    ),
    "GPS times for times": ({"prior": {"coalescence_time": (1.1e9, 1.2e9)}}, "in seconds from the trigger"),
    "kilohertz in millihertz": ({"f_max": 2e6}, "'f_max' of the analysis is at most"),
    "the sidereal time in GPS seconds": ({"sidereal_time": 1.2e9}, "'sidereal_time' of the analysis is at most"),
    "a range of times without end": (
        {"prior": SETTINGS.prior, "time_marginalisation": ENDLESS},
        "minimum < maximum",
    ),
    "no modes": ({"kind": "relative_binning", "modes": ()}, "at least one"),
    "a mode twice": ({"kind": "relative_binning", "modes": ((2, 2), (2, 2))}, "distinct pairs"),
    "a mode of no harmonic": ({"kind": "relative_binning", "modes": ((2, 3),)}, r"1 <= m <= l; got \(2, 3\)"),
    "a mode below the horizon": ({"kind": "relative_binning", "modes": ((2, -2),)}, r"1 <= m <= l; got \(2, -2\)"),
    "a monopole": ({"kind": "relative_binning", "modes": ((1, 1),)}, r"2 <= l .*; got \(1, 1\)"),
    "modes of a quadrature": ({"modes": ((2, 2), (3, 3))}, r"holds the \(2, 2\) mode alone"),
    "half the circle of odd modes": (
        {
            "kind": "relative_binning",
            "modes": ((2, 2), (3, 3)),
            "prior": SETTINGS.prior | {"reference_phase": (0.0, 2.0 * np.pi)},
            "phase_marginalisation": True,
        },
        "over the whole circle, 4 pi of 'reference_phase'",
    ),
    "kind": ({"kind": "guess"}, "do not fit their schema"),
    "type": ({"f_min": "20"}, "do not fit their schema"),
}


@pytest.mark.parametrize("case", BAD_SETTINGS)
def test_settings_that_contradict_themselves_are_refused(case):
    change, reason = BAD_SETTINGS[case]
    with pytest.raises(AnalysisInvalid, match=reason):
        Analysis(msgspec.structs.replace(SETTINGS, **change), arrays())


def test_the_whole_circle_beside_an_integral_over_the_phase_is_nothing_said_twice():
    circle = SETTINGS.prior | {"reference_phase": (0.0, 2.0 * np.pi)}
    Analysis(msgspec.structs.replace(SETTINGS, prior=circle, phase_marginalisation=True), arrays())


def test_modes_have_one_order_and_one_way_to_say_nothing():
    settings, given = full()
    plain = Analysis(settings, given)
    assert plain.settings.modes is msgspec.UNSET
    assert "modes" not in msgpack.unpackb(body_of(plain), strict_map_key=False)["settings"]
    some = Analysis(msgspec.structs.replace(settings, modes=((3, 3), (2, 2))), given)
    assert some.settings.modes == ((2, 2), (3, 3))
    assert decode_analysis(body_of(some)).digest == some.digest != plain.digest
    assert Analysis(msgspec.structs.replace(settings, modes=((2, 2), (3, 3))), given).digest == some.digest
    alone = Analysis(msgspec.structs.replace(SETTINGS, modes=((2, 2),)), arrays())
    assert alone.digest == Analysis(SETTINGS, arrays()).digest


BINNED = msgspec.structs.replace(SETTINGS, kind="relative_binning", modes=((2, 1), (2, 2), (3, 2), (3, 3)))


def binned_arrays(pairs=6, orders=3, **changes):
    """Of modes of three orders, at four nodes."""
    found = arrays(linear=4, quadratic=4) | {"quadratic_nodes": np.linspace(20.0, 100.0, 4)}
    for name in BINNED.detectors:
        found[f"linear_weights/{name}"] = np.ones((41, 4 * orders), complex)
        found[f"quadratic_weights/{name}"] = np.ones((pairs, 4), complex)
    return found | changes


def test_bins_have_weights_for_every_order_and_every_pair_of_orders():
    one = Analysis(SETTINGS, arrays())
    several = Analysis(BINNED, binned_arrays())
    assert decode_analysis(body_of(several)).digest == several.digest
    assert several.samples == 4 * (4 + 4) * (1 + 2)  # of four modes
    assert one.samples == (3 + 2) * (1 + 2)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"orders": 2}, r"'linear_weights/H1' .* of shape \(T, 12\)"),
        ({"pairs": 5}, r"'quadratic_weights/H1' .* complex128 of shape \(6, 4\)"),
        ({"quadratic_nodes": np.linspace(21.0, 100.0, 4)}, "are the same"),
    ],
)
def test_bins_of_several_modes_that_do_not_fit_are_refused(change, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        Analysis(BINNED, binned_arrays(**change))


def test_the_step_between_times_is_chosen_by_the_band_and_travels():
    times = TimeMarginalisation(minimum=-0.05, maximum=0.05)
    analysis = Analysis(msgspec.structs.replace(SETTINGS, time_marginalisation=times), arrays())
    stated = analysis.settings.time_marginalisation.step
    assert time_steps(analysis.settings) == (pytest.approx(0.1 / stated), stated)
    assert 0.1 / stated == pytest.approx(np.ceil(0.1 * 10.0 * 80.25))
    message = msgpack.unpackb(body_of(analysis), strict_map_key=False)
    assert message["settings"]["time_marginalisation"]["step"] == stated
    again = msgspec.structs.replace(times, step=stated)
    assert Analysis(msgspec.structs.replace(SETTINGS, time_marginalisation=again), arrays()).digest == analysis.digest


@pytest.mark.parametrize(("step", "steps"), [(None, 81), (1.0, 81), (1.0 / 2048.0, 205), (1e-4, 1000)])
def test_a_step_that_the_band_does_not_allow_is_shortened(step, steps):
    times = TimeMarginalisation(minimum=-0.05, maximum=0.05, step=step)
    assert time_steps(msgspec.structs.replace(SETTINGS, time_marginalisation=times)) == (steps, 0.1 / steps)


@pytest.mark.parametrize("body", [b"", b"\x80", b"\xc1", msgpack.packb({"settings": {}, "arrays": {}}), b"\x91" * 5000])
def test_what_is_not_an_analysis_is_not_decoded(body):
    with pytest.raises(UndecodableBody):
        decode_analysis(body)


def test_unknown_settings_and_narrow_arrays_are_refused():
    message = msgpack.unpackb(body_of(Analysis(SETTINGS, arrays())), strict_map_key=False)
    with pytest.raises(UndecodableBody, match="schema"):
        decode_analysis(msgpack.packb(message | {"settings": message["settings"] | {"secret": 1}}))
    narrow = message["arrays"]["location/H1"] | {b"type": "<f4", b"data": bytes(12)}
    with pytest.raises(AnalysisInvalid, match="travels as <f8"):
        decode_analysis(msgpack.packb(message | {"arrays": message["arrays"] | {"location/H1": narrow}}))


def test_a_table_of_distances_travels_and_is_not_written_where_there_is_none():
    def analysis(distances):
        return Analysis(msgspec.structs.replace(SETTINGS, distance_marginalisation=distances), arrays())

    plain, written = analysis(FAR), b"".join(encode_analysis(analysis(FAR)))
    assert b"table" not in written  # so that digests are those from before
    assert b"reference_frequency" not in written
    other = analysis(tabulated(0.5))
    back = decode_analysis(b"".join(encode_analysis(other)))
    assert back.settings.distance_marginalisation.table == (0.5, *[0.0] * 9)
    assert back.digest == other.digest != plain.digest
