"""All pages at both sizes and in both themes: nobody is kept out, and nothing comes from elsewhere."""

import hashlib
import json
import re
import subprocess
import urllib.request

import pytest

from bnserve_service.reference.explorer import PAGES
from tests.integration.conftest import serving

SECRET, OPERATOR = "a token of a guest", "a token of whoever runs it"
SMALLEST = 44.0
"""Pixels, for fingers (WCAG 2.5.5)."""
TARGETS = "button, select, input, summary, nav a, [role=tab], .chip"


@pytest.fixture(scope="module")
def guarded(tmp_path_factory):
    """A server that asks for tokens."""
    folder = tmp_path_factory.mktemp("guarded")
    entries = [(SECRET, "guest", '["evaluate"]'), (OPERATOR, "operator", '["admin", "evaluate"]')]
    text = "".join(
        f'[[tokens]]\nname = "{name}"\nsha256 = "{hashlib.sha256(secret.encode()).hexdigest()}"\nscopes = {scopes}\n'
        for secret, name, scopes in entries
    )
    (folder / "bnserve.toml").write_text(text)
    (folder / "bnserve.toml").chmod(0o600)
    with serving(folder / "server.log", "--config", str(folder / "bnserve.toml"), "--model", "fast@2.0.0") as it:
        yield it


@pytest.mark.parametrize("path", PAGES)
@pytest.mark.parametrize(("size", "theme"), [("desk", "light"), ("phone", "dark")])
def test_everybody_can_use_it_and_nothing_comes_from_elsewhere(visit, server, axe, path, size, theme):
    seen = visit(path, size=size, theme=theme)
    seen.page.evaluate(axe)  # as a command of the browser, which a page's policy does not bind
    found = seen.page.evaluate("async () => (await axe.run()).violations")
    serious = [(one["id"], [node["target"] for node in one["nodes"]]) for one in found
               if one["impact"] in ("serious", "critical")]  # fmt: skip
    assert serious == []
    assert len(seen.requests) > 5
    assert [url for url in seen.requests if not url.startswith((server.address, "data:", "blob:"))] == []
    assert seen.faults == []


@pytest.mark.parametrize("path", PAGES)
def test_on_a_phone_nothing_is_beside_the_screen_and_targets_have_the_size_of_fingers(visit, path):
    seen = visit(path, size="phone")
    assert seen.page.evaluate("document.documentElement.scrollWidth") <= 390
    small = """([targets, least]) => [...document.querySelectorAll(targets)]
        .filter((one) => one.checkVisibility() && !one.matches(".chip input"))
        .map((one) => [one.outerHTML.slice(0, 80), one.getBoundingClientRect().height])
        .filter(([, height]) => height < least)"""
    assert seen.page.evaluate(small, [TARGETS, SMALLEST - 0.5]) == []


@pytest.mark.parametrize("path", PAGES)
def test_without_scripts_it_says_so(visit, path):
    seen = visit(path, java_script_enabled=False, ready=False)
    assert "JavaScript" in seen.page.inner_text("noscript")


def test_who_wants_less_motion_sees_none(visit):
    duration = "() => getComputedStyle(document.getElementById('strain-picture')).transitionDuration"
    assert visit("/", ready=False).page.evaluate(duration) != "0s"
    assert visit("/", ready=False, reduced_motion="reduce").page.evaluate(duration) == "0s"


def test_the_theme_is_the_systems_or_a_chosen_one(visit):
    seen = visit("/docs", theme="dark")
    paper = "() => getComputedStyle(document.body).backgroundColor"
    dark = seen.page.evaluate(paper)
    seen.page.click("#theme")
    assert seen.page.get_attribute("#theme", "aria-label") == "Theme: light"
    light = seen.page.evaluate(paper)
    assert light != dark
    seen.page.reload()
    assert seen.page.evaluate(paper) == light


def test_the_question_for_a_token_explains_itself(visit, guarded):
    seen = visit("/", address=guarded.address, ready=False)
    seen.page.wait_for_selector("#token")
    assert "bnserve tokens new" in seen.page.inner_text("#token-why")
    assert seen.page.evaluate("document.activeElement.id") == "token"
    seen.page.fill("#token", "something else")
    seen.page.keyboard.press("Enter")
    seen.page.wait_for_selector("[role=alert] >> text=needs a token")
    seen.page.fill("#token", SECRET)
    seen.page.keyboard.press("Enter")
    seen.settle()
    assert not seen.page.is_visible("#token")
    assert "BNSERVE_TOKEN" in seen.page.inner_text("#code")
    assert SECRET not in seen.page.content()
    seen.page.goto(f"{guarded.address}/models")  # the same tab
    seen.settle()
    assert seen.page.inner_text("h1") == "fast 2.0.0"


def test_the_state_is_for_those_who_run_the_service(visit, guarded):
    seen = visit("/state", address=guarded.address, ready=False)
    seen.page.fill("#token", SECRET)
    seen.page.keyboard.press("Enter")
    seen.page.wait_for_selector("text=scope “metrics” or “admin”")
    seen.page.fill("#token", OPERATOR)
    seen.page.keyboard.press("Enter")
    seen.settle()
    assert re.search(r"guest\s+\d", seen.page.inner_text("#tokens"))
    assert "forbidden" in seen.page.inner_text("#codes")


def test_the_state_is_live(visit, server):
    seen = visit("/state")
    assert "yes" in seen.page.inner_text("#tiles")
    looks = int(seen.page.evaluate("document.documentElement.dataset.drawn"))
    waveforms = seen.page.inner_text("#routes")
    body = {"parameters": {"mass_ratio": 9.0}, "grid": {"frequencies": [20.0]}}
    request = urllib.request.Request(
        f"{server.address}/v1/models/default/waveforms", json.dumps(body).encode(), {"content-type": "application/json"}
    )
    with pytest.raises(urllib.error.HTTPError):
        urllib.request.urlopen(request, timeout=60)
    seen.page.wait_for_function("(looks) => +document.documentElement.dataset.drawn > looks + 1", arg=looks)
    assert "parameters-invalid" in seen.page.inner_text("#codes")
    assert seen.page.inner_text("#routes") != waveforms
    assert seen.faults == []


def test_models_are_shown_with_what_they_say_of_themselves(visit, server):
    seen = visit("/models#wide@1.0.0")
    with urllib.request.urlopen(f"{server.address}/v1/models/wide", timeout=60) as answer:
        known = json.load(answer)
    text = seen.page.inner_text("#model")
    for part in (
        "wide 1.0.0",
        known["digest"],
        "stable",
        "TEOBResumSPA",
        known["provenance"]["dataset_digest"],
        "0.2 to 100",
    ):
        assert part in text
    panels = seen.page.locator(".panels canvas")
    assert panels.count() == len(known["accuracy"]["by_parameter"])
    for panel in panels.all():
        assert (
            panel.evaluate("(canvas) => new Set(canvas.getContext('2d').getImageData(0, 0, 200, 200).data).size") > 10
        )
    seen.page.click("text=default 1.0.0")
    seen.page.wait_for_selector("h1 >> text=default 1.0.0")
    seen.page.click("text=Open in the explorer")
    seen.settle()
    assert seen.page.input_value("#model") == "default@1.0.0"


def test_the_interface_has_anchors_curls_and_forms(visit):
    seen = visit("/docs#post-v1-models-name-waveforms")
    place = seen.page.locator("#post-v1-models-name-waveforms")
    assert place.get_attribute("open") is not None
    curl = place.locator("pre").first.inner_text()
    answer = subprocess.run(["bash", "-c", curl], capture_output=True, text=True, check=True, timeout=60).stdout
    assert "h_plus" in json.loads(answer)
    assert seen.page.evaluate("[...document.querySelectorAll('.operation[id]')].length") > 30
    assert (
        seen.page.evaluate(
            "[...document.querySelectorAll('#paths .operation')].filter((one) => !one.querySelector('pre')).length"
        )
        == 0
    )
    place.locator("text=Send").click()
    seen.page.wait_for_selector("#post-v1-models-name-waveforms >> text=200 in")
    assert '"h_plus"' in place.locator("pre").nth(1).inner_text()
    place.locator("textarea").fill("{}")
    place.locator("text=Send").click()
    seen.page.wait_for_selector("#post-v1-models-name-waveforms >> text=400 in")
