"""The reference says what there is: pages made from the code are those of the code, and nothing is in no page.

``python docs/generate.py`` renews them.
"""

import importlib.util
import re
import tomllib
from pathlib import Path

import pytest

from bnserve_service import Settings, load_settings
from tests.architecture.rooms import ROOMS, ROOT, python_files

REFERENCE = ROOT / "docs" / "reference"


def loaded(name: str):
    spec = importlib.util.spec_from_file_location(name, ROOT / "docs" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


generate = loaded("generate")
PAGES = generate.pages()


def stated(page: str) -> set[str]:
    """What stands in the first column of the tables of a page."""
    text = (REFERENCE / f"{page}.md").read_text()
    return {name for line in text.splitlines() if line.startswith("| ") for name in re.findall("`([^`]+)`", line)}


@pytest.mark.parametrize("path", sorted(map(str, PAGES)))
def test_a_page_says_what_the_code_says(path):
    assert (ROOT / path).read_text() == PAGES[Path(path)], "run: python docs/generate.py"


def test_every_setting_says_why():
    assert set(loaded("settings_pages").reasons(Settings)) == set(Settings.model_fields)
    assert set(Settings.model_fields) <= stated("settings")


def test_every_metric_that_is_named_in_the_code_is_there():
    text = "".join((ROOT / path).read_text() for path in python_files("service"))
    named = {name for name in re.findall(r'"(bnserve_[a-z_]+)"', text) if name not in ROOMS.values()}
    shown = {re.sub("_(total|info)$", "", name) for name in stated("metrics")}
    assert {re.sub("_info$", "", name) for name in named} <= shown


def test_every_option_of_the_command_line_is_there():
    text = "".join((ROOT / path).read_text() for path in python_files("service") if "/cli/" in str(path))
    options = set(re.findall(r'"(--[a-z][a-z-]+)"', text))
    page = (REFERENCE / "commands.md").read_text()
    assert {
        option for option in options - {"--version"} if f"`{option}" not in page and f", {option}" not in page
    } == set()


def test_every_code_of_an_error_is_there():
    text = "".join((ROOT / path).read_text() for path in python_files(*ROOMS))
    codes = set(re.findall(r'^    code(?:: ClassVar\[str\])? = "([a-z-]+)"', text, re.MULTILINE))
    assert codes - stated("errors") == set()


# The sample of settings


def test_the_sample_is_what_holds_without_it():
    assert load_settings(ROOT / "examples" / "bnserve.toml") == Settings()


def test_the_sample_has_every_setting_and_what_it_leaves_out_is_valid(tmp_path):
    text = (ROOT / "examples" / "bnserve.toml").read_text()
    assert {name for name in Settings.model_fields if not re.search(rf"^(# )?\W*{name}\b", text, re.MULTILINE)} == set()
    everything = re.sub(r"^# (?=[a-z_0-9]+ = |\[\[)", "", text, flags=re.MULTILINE)
    assert set(tomllib.loads(everything)) == set(Settings.model_fields)
    file = tmp_path / "bnserve.toml"
    file.write_text(
        re.sub(r"^(tokens_file|token_list) = .*$", "", everything, flags=re.MULTILINE)
    )  # there are none here
    file.chmod(0o600)
    assert load_settings(file).tokens[0].name == "alice"
