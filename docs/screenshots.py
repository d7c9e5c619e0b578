"""The pictures of the pages in docs/images, at two sizes and in two themes.

    python docs/screenshots.py            # starts a server of the shipped models, and Chromium without a window

Needs `playwright` (extra `test`) and Debian's `chromium`, which tests/run.sh installs.
"""

from __future__ import annotations

import contextlib
import io
import json
import shutil
import tempfile
import threading
import urllib.request
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, sync_playwright

from tests.integration.conftest import serving

IMAGES = Path(__file__).parent / "images"
SIZES = {"wide": (1280, 800), "phone": (390, 844)}
SEEN = ["mass_ratio=1.6", "inclination=1.1"]
COMPARED = "&".join(
    ["model=default@2.0.0", *SEEN, "b.model=default@2.0.0", *("b." + one for one in SEEN), "b.lambda_2=1100"]
)
PICTURES = {
    ("explorer", "wide", "light"): "",
    ("explorer", "wide", "dark"): f"#{COMPARED}&against=pinned",
    ("explorer", "phone", "light"): "",
    ("explorer", "phone", "dark"): "#model=default@2.0.0&inclination=1.4&mass_ratio=2",
    ("models", "wide", "light"): "models",
    ("models", "phone", "dark"): "models",
    ("state", "wide", "dark"): "state",
    ("state", "phone", "light"): "state",
    ("docs", "wide", "light"): "docs#post-v1-models-name-waveforms",
    ("docs", "phone", "dark"): "docs",
}
"""Page, size and theme: the address below that of the server."""
WAIT = 180_000.0
"""Milliseconds, for a busy machine."""
COLOURS = 256
"""Of one picture, which makes it half as large; fewer are seen in the lines."""


def take(browser: Browser, address: str, size: str, theme: str) -> Image.Image:
    """What a visitor sees."""
    width, height = SIZES[size]
    context = browser.new_context(viewport={"width": width, "height": height}, color_scheme=theme)  # type: ignore[arg-type]
    context.set_default_timeout(WAIT)
    page = context.new_page()
    page.goto(address)
    page.wait_for_function("() => document.documentElement.dataset.drawn")
    if size == "phone" and theme == "dark" and "mass_ratio" in address:
        page.fill("#n-lambda_1", "9000")  # what an error looks like
    page.wait_for_timeout(15_000 if address.endswith("/state") else 500)  # the state has a past to show
    taken = Image.open(io.BytesIO(page.screenshot()))
    context.close()
    return taken


def ask_now_and_then(address: str, ended: threading.Event) -> None:
    """What the page of the state has to show: batches of waveforms, and a refusal among them."""
    binary = {"mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0, "chi_2": 0, "distance_mpc": 40}
    count = 0
    while not ended.wait(0.15):
        count += 1
        rows = 1 + count % 7
        body = {"parameters": binary | {"inclination": [0.1] * rows, "total_mass": 2.8 if count % 20 else 500},
                "grid": {"f_min": 20, "f_max": 1020, "delta_f": 1}}  # fmt: skip
        headers = {"content-type": "application/json", "accept": "application/msgpack"}
        request = urllib.request.Request(f"{address}/v1/models/default/waveforms", json.dumps(body).encode(), headers)
        with contextlib.suppress(OSError):
            urllib.request.urlopen(request, timeout=10).close()


def main() -> None:
    """Take them all."""
    log, ended = Path(tempfile.mkdtemp()) / "server.log", threading.Event()
    with serving(log) as server, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        asking = threading.Thread(target=ask_now_and_then, args=(server.address, ended))
        asking.start()
        try:
            for (name, size, theme), path in PICTURES.items():
                target = IMAGES / f"page-{name}-{size}-{theme}.png"
                taken = take(browser, f"{server.address}/{path}", size, theme).convert("RGB")
                taken.quantize(COLOURS, kmeans=2, dither=Image.Dither.NONE).save(target, optimize=True)
                print(f"{target.name}: {target.stat().st_size:,} bytes")
        finally:
            ended.set()
            asking.join()
            browser.close()


if __name__ == "__main__":
    main()
