"""The site of docs/ is built without a warning, has every public name of all rooms, and asks nothing of other hosts."""

import importlib
import os
import re
import subprocess
import sys

import pytest

from tests.architecture.rooms import ROOT
from tests.architecture.test_public_api import public_packages
from tests.architecture.test_reference import loaded

pytestmark = pytest.mark.slow

OTHERS = re.compile(
    r"<(?:script|img|iframe|link)\b[^>]*\b(?:src|href)=[\"']?(?:https?:)?//[^\"'>\s]+|@import[^;]*//|url\(https?:"
)
"""What a browser would fetch from elsewhere."""


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The pages, built as the command of the guide builds them."""
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", str(folder)]
    environment = os.environ | {"NO_MKDOCS_2_WARNING": "1"}  # news of its makers
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False, timeout=600)
    assert (done.returncode, done.stderr) == (0, "")
    return folder


def test_every_public_package_has_a_page():
    assert set(loaded("hooks").public_packages()) == {
        name for name in public_packages() if getattr(importlib.import_module(name), "__all__", ())
    }


def test_every_public_name_has_a_place(site):
    missing = {}
    for package in loaded("hooks").public_packages():
        page = (site / "reference" / "python" / f"{package}.html").read_text()
        places = set(re.findall(r"id=\"?([\w.]+)", page))
        names = [name for name in importlib.import_module(package).__all__ if f"{package}.{name}" not in places]
        if names:
            missing[package] = names
    assert missing == {}


def test_parameters_units_and_errors_of_docstrings_are_there(site):
    page = (site / "reference" / "python" / "bnserve_client.html").read_text()
    for words in ("retries", "1/Hz", "OutOfDomain"):
        assert words in page


def test_no_page_asks_other_hosts(site):
    found = {
        str(file.relative_to(site)): match.group()
        for kind in ("*.html", "*.css")
        for file in site.rglob(kind)
        if (match := OTHERS.search(file.read_text()))
    }
    assert found == {}


def test_pages_link_to_copies_of_what_is_outside_of_their_folder(site):
    page = (site / "guides" / "samplers.html").read_text()
    assert "files/examples/samplers/problem.py" in page
    assert (site / "files" / "examples" / "samplers" / "problem.py").exists()
