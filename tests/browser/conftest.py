"""A real Chromium that looks at a real server of the shipped models."""

import re
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, field

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, sync_playwright

from bnserve_surrogate import Model
from tests.integration.conftest import ServerProcess, serving

DESK, PHONE = (1280, 800), (390, 844)
SIZES = {"desk": DESK, "phone": PHONE}
WAIT = 180_000.0
"""Milliseconds until something that does not happen counts as broken; on a busy machine pictures take a second."""


@pytest.fixture(scope="session")
def local() -> Model:
    """The shipped model in this process."""
    return Model.default()


@pytest.fixture(scope="session")
def server(tmp_path_factory) -> Iterator[ServerProcess]:
    """A server of the shipped models."""
    with serving(tmp_path_factory.mktemp("server") / "server.log") as it:
        yield it


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Debian's Chromium, without a window.

    Of one file: while it is there an event loop counts as running in this thread, and tests of asyncio have their own.
    """
    program = shutil.which("chromium")
    assert program, "chromium is not installed (tests/run.sh does)"
    with sync_playwright() as playwright:
        # Without its sandbox, which needs more than the root of a container may do: it sees our own pages alone.
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@dataclass
class Visit:
    """One page that is looked at, and what it did meanwhile."""

    page: Page
    context: BrowserContext
    requests: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)

    def settle(self) -> None:
        """Wait until the pictures are those of what was chosen last."""
        self.page.wait_for_function(
            "() => { const d = document.documentElement.dataset; return d.drawn && d.drawn === (d.wanted || d.drawn) }"
        )

    def set(self, name: str, value: float | str) -> None:
        """Write a number into a field, as somebody who types it."""
        self.page.fill(f"#n-{name}", str(value))
        self.settle()

    def slide(self, name: str, part: float) -> None:
        """Move a slider to a part of its way."""
        move = """(slider, part) => {
            slider.value = +slider.min + part * (slider.max - slider.min);
            slider.dispatchEvent(new Event("input", { bubbles: true }));
        }"""
        self.page.eval_on_selector(f"#r-{name}", move, part)
        self.settle()

    def picture(self, name: str) -> str:
        """All pixels of a picture."""
        return self.page.eval_on_selector(f"#{name}-picture canvas", "(canvas) => canvas.toDataURL()")

    def csv(self, name: str) -> list[list[float]]:
        """The columns of a picture's numbers, as its button gives them."""
        with self.page.expect_download() as download:
            self.page.eval_on_selector(f"[data-csv={name}]", "(button) => button.click()")
        return columns(download.value.path().read_text())


def columns(text: str) -> list[list[float]]:
    rows = [re.split(",", line) for line in text.splitlines()[1:]]
    return [[float(cell) for cell in column if cell] for column in zip(*rows, strict=True)]


@pytest.fixture
def visit(browser, server):
    """Open a page: `visit("/", size="phone", theme="dark")`."""
    contexts = []

    def open_page(path="/", size="desk", theme="light", address=server.address, ready=True, **options) -> Visit:
        width, height = SIZES[size]
        context = browser.new_context(
            viewport={"width": width, "height": height}, color_scheme=theme, has_touch=size == "phone",
            is_mobile=size == "phone", permissions=["clipboard-read", "clipboard-write"], **options,
        )  # fmt: skip
        contexts.append(context)
        context.set_default_timeout(WAIT)
        page = context.new_page()
        seen = Visit(page, context)
        page.on("request", lambda request: seen.requests.append(request.url))
        page.on("pageerror", lambda error: seen.faults.append(str(error)))
        page.on("console", lambda message: message.type == "error" and seen.faults.append(message.text))
        page.goto(address + path)
        if ready:
            seen.settle()
        return seen

    yield open_page
    for context in contexts:
        context.close()


@pytest.fixture(scope="session")
def axe(tmp_path_factory) -> str:
    """The script of axe-core, which finds what keeps people out."""
    folder = tmp_path_factory.mktemp("axe")
    options = ["--silent", "--no-audit", "--no-fund", "--ignore-scripts", "--prefix", str(folder)]
    subprocess.run(["npm", "install", *options, "axe-core"], check=True, timeout=300)
    return (folder / "node_modules" / "axe-core" / "axe.min.js").read_text(encoding="utf-8")
