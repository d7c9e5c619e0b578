"""The code that the explorer offers, copied and run: exactly the numbers that the page saves."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

from tests.browser.conftest import columns

BINARIES = {
    "all modes": "",
    "chosen modes": "model=fast@2.0.0&mass_ratio=1.6&inclination=1.1&reference_phase=1&modes=22_33_21&chi_1=-0.2",
    "precession": "mass_ratio=1.4&chi_1x=0.3&chi_2y=-0.1&inclination=0.9&time_shift=0.002&modes=22_33",
}


def saved(seen):
    """h_plus and h_cross of the page's file, at all frequencies."""
    with seen.page.expect_download() as download:
        seen.page.click("#save-waveform")
    f, *parts = np.array(columns(download.value.path().read_text()))
    np.testing.assert_array_equal(f, np.arange(20.0, 2048.1, 0.25))
    return np.array([parts[0] + 1j * parts[1], parts[2] + 1j * parts[3]])


def copied(seen, language):
    """The text that a visitor has after choosing a language and copying."""
    seen.page.click(f"#tab-{language}")
    seen.page.click("#copy")
    seen.page.wait_for_function("() => document.getElementById('copied').textContent")
    return seen.page.evaluate("navigator.clipboard.readText()")


def run(command, text="", **environment):
    done = subprocess.run(
        command, input=text, capture_output=True, text=True, check=False, timeout=300, env=os.environ | environment
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def of_json(body):
    parts = [(np.array(body[name]["re"][0]), np.array(body[name]["im"][0])) for name in ("h_plus", "h_cross")]
    return np.array([re + 1j * im for re, im in parts])


@pytest.mark.parametrize("address", BINARIES.values(), ids=BINARIES)
def test_python_curl_and_javascript_have_exactly_its_numbers(visit, tmp_path, address):
    seen = visit(f"/#{address}")
    expected = saved(seen)
    assert np.abs(expected).max() > 1e-25
    after = f"\nimport numpy\nnumpy.save({str(tmp_path / 'h.npy')!r}, [h.plus, h.cross])\n"
    run([sys.executable, "-W", "error", "-c", copied(seen, "python") + after])
    np.testing.assert_array_equal(np.load(tmp_path / "h.npy"), expected)
    found = of_json(json.loads(run(["bash", "-c", copied(seen, "curl")])))
    np.testing.assert_array_equal(found, expected)
    script = tmp_path / "waveform.mjs"
    script.write_text(copied(seen, "javascript") + "console.log(JSON.stringify({ h_plus, h_cross }));\n")
    found = of_json(json.loads(run(["node", script]).splitlines()[1]))
    np.testing.assert_array_equal(found, expected)


def test_bilby_has_its_numbers(visit, tmp_path):
    pytest.importorskip("bilby")
    seen = visit(f"/#{BINARIES['precession'].replace('time_shift', 'unshifted')}")  # bilby has the time apart
    after = f'\nimport numpy\nnumpy.save({str(tmp_path / "h.npy")!r}, [h["plus"][inside], h["cross"][inside]])\n'
    run([sys.executable, "-W", "ignore", "-c", copied(seen, "bilby") + after])
    expected = saved(seen)
    # It takes two masses for the total mass and the ratio, and angles: other last bits, times a phase of 10^4 rad.
    np.testing.assert_allclose(np.load(tmp_path / "h.npy"), expected, atol=1e-9 * np.abs(expected).max())
