"""The first page is short, begins with two commands, and has no figure that is not on the page behind it."""

import re

import pytest

from tests.architecture.rooms import ROOT

PAGE = (ROOT / "README.md").read_text()
MOST_WORDS = 900
NUMBER = re.compile(r"\d[\d,]*(?:\.\d+)?(?:e-\d+)?")


def plain(text: str) -> str:
    """Numbers without commas between thousands, and exponents without zeros before them."""
    return re.sub(r"e-0(?=\d)", "e-", re.sub(r"(?<=\d),(?=\d{3})", "", text))


def rows(heading: str) -> list[str]:
    """The rows of the first table below a heading, without its own heading."""
    table = re.search(r"\|.*?(?=\n\n)", PAGE.partition(f"{heading}\n")[2], re.DOTALL)
    return table.group().splitlines()[2:]


def unknown(row: str, *pages: str) -> list[str]:
    """The figures of a row that are on none of the pages."""
    without_links = re.sub(r"\]\([^)]*\)|`[^`]*`", "", row)
    known = plain(" ".join((ROOT / page).read_text() for page in pages))
    found = NUMBER.findall(plain(without_links))
    return [number for number in found if not re.search(rf"(?<![\d.]){re.escape(number)}", known)]


def test_it_can_be_read_in_a_few_minutes():
    assert len([word for word in PAGE.split() if re.search(r"\w", word)]) <= MOST_WORDS


def test_it_begins_with_the_main_job_and_the_tests():
    commands = re.findall(r"^    (\S.*)", PAGE, re.MULTILINE)
    assert commands[0] == "python3 -m venv .venv && .venv/bin/pip install . && .venv/bin/bnserve demo"
    assert commands[1] == "bash tests/run.sh"


@pytest.mark.parametrize("row", rows("# bnserve"), ids=lambda row: re.search(r"\w+", row).group())
def test_its_comparisons_are_on_the_page_that_they_name(row):
    page = re.search(r"\]\((docs/[\w/]+\.md)", row).group(1)
    assert re.search(r"`(python -m benchmarks\.\w+|bnserve analyse )", row)
    assert unknown(row, page) == []


@pytest.mark.parametrize(
    ("heading", "page"),
    [("## How accurate it is", "docs/explanations/accuracy.md"), ("## How fast it is", "docs/explanations/speed.md")],
)
def test_its_other_figures_are_on_the_page_behind_them(heading, page):
    assert [(row, missing) for row in rows(heading) if (missing := unknown(row, page))] == []


def test_an_invented_figure_is_found():
    assert unknown("| 3.33e-07 and 5.1e-9 |", "docs/explanations/accuracy.md") == ["3.33e-7"]


def test_its_links_lead_somewhere():
    links = re.findall(r"\]\((?!https?:)([^)#]+)", PAGE)
    assert [link for link in links if not (ROOT / link).exists()] == []


def test_the_index_names_every_page():
    docs = ROOT / "docs"
    pages = {str(path.relative_to(docs)) for path in docs.glob("[!d]*/*.md")} | {"tutorial.md"}
    assert pages - set(re.findall(r"\]\(([^)#]+)", (docs / "index.md").read_text())) == set()
