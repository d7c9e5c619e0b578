"""The explorer, as somebody uses it: every control changes what depends on it, and what is wrong is said."""

import dataclasses
import re

import numpy as np
import pytest
from matplotlib.image import imread

from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic, predict_time_domain
from bnserve_surrogate.training.data.noise import einstein_telescope_d

ALL = {"strain", "spectrum", "track", "difference"}
CHANGES = {
    "total_mass": ALL, "mass_ratio": ALL, "lambda_1": ALL, "lambda_2": ALL, "chi_1": ALL, "chi_2": ALL,
    "distance_mpc": {"strain", "spectrum"}, "inclination": {"strain", "spectrum"}, "reference_phase": {"strain"},
    "time_shift": {"strain"}, "chi_1x": {"strain", "spectrum"}, "chi_1y": {"strain", "spectrum"},
    "chi_2x": {"strain", "spectrum"}, "chi_2y": {"strain", "spectrum"}, "reference_frequency": {"strain", "spectrum"},
}  # fmt: skip
"""Which pictures depend on which parameter; the last is looked at with spins in the plane, which it belongs to."""
ONE = ParametersWithExtrinsic.gw170817()


def pictures(seen):
    return {name: seen.picture(name) for name in ALL}


def test_each_slider_changes_each_picture_that_depends_on_it(visit):
    seen = visit()
    before = pictures(seen)
    for name, expected in CHANGES.items():
        seen.slide(name, 0.45 if name == "total_mass" else 0.7)
        after = pictures(seen)
        assert {picture for picture in ALL if after[picture] != before[picture]} >= expected, name
        assert float(seen.page.input_value(f"#n-{name}")) != 0.0
        before = after
    assert seen.faults == []


def test_on_a_phone_the_picture_stays_in_sight_while_any_slider_is_moved(visit):
    seen = visit(size="phone")
    moved = {"strain": "time_shift", "spectrum": "inclination", "track": "chi_2", "difference": "lambda_2"}
    for picture, name in moved.items():
        seen.page.tap(f"[aria-controls={picture}-picture]")
        seen.page.eval_on_selector(f"#r-{name}", "(slider) => slider.scrollIntoView({ block: 'end' })")
        before = seen.picture(picture)
        seen.slide(name, 0.8)
        assert seen.picture(picture) != before
        box = seen.page.locator(f"#{picture}-picture canvas").bounding_box()
        slider = seen.page.locator(f"#r-{name}").bounding_box()
        assert box["y"] >= 0.0
        assert box["y"] + box["height"] <= slider["y"] <= 844.0


@pytest.mark.parametrize("size", ["desk", "phone"])
def test_what_a_model_does_not_know_is_said_over_a_grey_picture_and_at_the_field(visit, size):
    seen = visit(size=size)
    seen.set("lambda_1", 9000)
    alert = seen.page.locator("#why")
    assert alert.get_attribute("role") == "alert"
    assert re.search(r"not trained.*Λ₁ = 9000 is outside \[0, 5000\]", alert.inner_text())
    box = alert.bounding_box()
    if size == "desk":
        assert box["y"] > 0.0
        assert box["y"] + box["height"] < 800.0
    seen.page.wait_for_function("() => getComputedStyle(document.getElementById('strain-picture')).opacity < 0.5")
    assert seen.page.inner_text("#e-lambda_1") == "Outside [0, 5000]."
    assert seen.page.get_attribute("#n-lambda_1", "aria-invalid") == "true"
    seen.set("lambda_1", 800)
    assert not alert.inner_text()
    assert not seen.page.is_visible("#e-lambda_1")
    assert seen.page.get_attribute("#n-lambda_1", "aria-invalid") is None


def test_an_emptied_field_is_no_zero(visit):
    seen = visit()
    asked = sum("waveforms" in url for url in seen.requests)
    seen.set("chi_1", "")
    assert "has no number" in seen.page.inner_text("#why")
    assert seen.page.inner_text("#e-chi_1") == "Give a number."
    assert sum("waveforms" in url for url in seen.requests) == asked
    seen.set("chi_1", 0)
    assert not seen.page.inner_text("#why")


def test_modes_can_be_left_out_and_what_is_left_out_is_not_drawn(visit, local):
    seen = visit()
    with_all = pictures(seen)
    seen.page.uncheck("#modes input[value='33']")
    seen.settle()
    assert seen.picture("strain") != with_all["strain"]
    assert seen.picture("spectrum") != with_all["spectrum"]
    for mode in ("22", "21", "44", "32", "31", "43"):
        seen.page.uncheck(f"#modes input[value='{mode}']")
    seen.settle()
    assert "No mode is chosen" in seen.page.inner_text("#why")


def test_the_strain_is_that_of_the_library(visit, local):
    seen = visit()
    times, cross, plus = seen.csv("strain")
    rate = (len(times) - 1) / (times[-1] - times[0])
    expected = predict_time_domain(
        local, ONE, sampling_rate=rate, duration=0.5, options=EvaluationOptions(reference_frequency=20.0)
    )
    inside = slice(np.searchsorted(expected.times, times[0] - 0.5 / rate), None)
    count = min(len(times), len(expected.times[inside]))
    largest = np.abs(expected.plus).max()
    # Here the signal fades in over frequencies, there over a time: what is left of that in the last 50 ms.
    np.testing.assert_allclose(plus[:count], expected.plus[inside][:count], atol=2e-3 * largest)
    np.testing.assert_allclose(cross[:count], expected.cross[inside][:count], atol=2e-3 * largest)


def test_signal_to_noise_ratios_are_those_of_a_fine_grid(visit, local):
    seen = visit("/#noise=et")
    found = float(re.search(r"Einstein Telescope: SNR (\d+)", seen.page.inner_text("#spectrum-picture .legend"))[1])
    f = np.arange(3.7, 2960.0, 0.05)
    h = local.predict(f, ONE, options=EvaluationOptions(alignment="merger", reference_frequency=20.0)).plus
    expected = np.sqrt(4.0 * np.trapezoid(np.abs(h) ** 2 / einstein_telescope_d(f), f))
    assert found == pytest.approx(expected, rel=0.01)


def test_the_track_leads_to_the_merger_without_a_hook(visit, local):
    seen = visit("/#lambda_1=5000&lambda_2=5000")
    until, frequencies = seen.csv("track")
    assert (np.diff(until) < 0.0).all()
    assert (np.diff(frequencies) > 0.0).all()
    assert until[-1] < 3e-3
    stiff = dataclasses.replace(ONE, lambda_1=5000.0, lambda_2=5000.0)
    for i in (100, 400, 700):
        assert until[i] == pytest.approx(local.time_until_merger(frequencies[i], stiff), rel=1e-3)


def test_two_waveforms_are_compared(visit):
    seen = visit()
    seen.page.click("#keep")
    seen.settle()
    assert "mismatch 0" in seen.page.inner_text("#difference-picture .legend")
    seen.slide("lambda_2", 0.5)
    assert "B" in seen.page.inner_text("#track-picture .legend")
    found = float(re.search(r"mismatch ([\d.]+)", seen.page.inner_text("#difference-picture .legend"))[1])
    assert 1e-4 < found < 0.2
    seen.page.select_option("#pinned select", "fast@2.0.0")
    seen.page.click("text=Swap with A")
    seen.settle()
    assert seen.page.input_value("#model") == "fast@2.0.0"
    seen.page.check("[name=against][value=none]")
    seen.settle()
    assert seen.page.is_visible("#difference-picture .none")


def test_the_address_keeps_what_is_shown(visit):
    seen = visit()
    seen.slide("inclination", 0.3)
    seen.page.click("text=Edge-on, unequal")
    seen.settle()
    seen.page.uncheck("#modes input[value='31']")
    seen.page.select_option("[name=window]", "0.2")
    seen.settle()
    seen.page.click("#keep")
    seen.settle()
    seen.slide("chi_1", 0.9)
    before, hidden = pictures(seen), seen.page.evaluate("document.documentElement.dataset.drawn")
    again = visit(f"/#{hidden}")
    assert pictures(again) == before
    assert again.page.evaluate("document.documentElement.dataset.drawn") == hidden


def test_values_appear_under_the_pointer(visit):
    seen = visit()
    box = seen.page.locator("#spectrum-picture canvas").bounding_box()
    seen.page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    values = seen.page.inner_text("#spectrum-picture .values")
    assert re.match(r"[\d.]+ Hz", values)
    assert "Advanced LIGO" in values
    assert "(3, 3)" in values


def test_values_stay_where_a_finger_was(visit):
    seen = visit(size="phone")
    box = seen.page.locator("#strain-picture canvas").bounding_box()
    seen.page.touchscreen.tap(box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"])
    assert re.match("\u22120\\.0[\\d.]+ s", seen.page.inner_text("#strain-picture .values"))


def test_a_picture_is_a_file(visit, tmp_path):
    seen = visit()
    with seen.page.expect_download() as download:
        seen.page.click("[data-png=spectrum]")
    pixels = imread(download.value.path(), format="png")[..., :3]
    assert pixels.shape[1] > pixels.shape[0] > 200
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 100


def test_the_chirp_can_be_heard(visit):
    """There is no loudspeaker here: the sound is made, plays, and can be ended."""
    seen = visit("/#total_mass=40")
    seen.page.click("#listen")
    assert seen.page.inner_text("#listen") == "Stop"
    seen.page.wait_for_timeout(500)
    seen.page.click("#listen")
    seen.page.wait_for_function("() => document.getElementById('listen').textContent === 'Listen'")
    assert seen.page.inner_text("#why") == ""


def test_an_address_of_what_is_not_served_shows_what_is(visit):
    seen = visit("/#model=nothing@9&b.model=default@stable&b.lambda_1=900&against=pinned")
    assert seen.page.input_value("#model") == "default@2.0.0"
    assert seen.page.input_value("#pinned select") == "default@2.0.0"
    assert seen.page.inner_text("#why") == ""
