"""What the site has beside the pages of this folder: the reference of Python, changes, and files that pages link to."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page
from pymdownx.slugs import slugify
from rooms import ROOMS  # in this folder

ROOT = Path(__file__).parents[1]
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\((?!https?:|#)([^)#\s]+)(#[^)]*)?\)")
ROLE = re.compile(r":\w+:(<code>)[.~]?")


def public_packages() -> list[str]:
    """Every package with an ``__all__`` that is not empty, in the order of who needs it first."""
    found = []
    for room in ROOMS:
        for file in sorted((ROOT / room).glob("bnserve_*/**/__init__.py"), key=lambda file: len(file.parts)):
            package = file.parent.relative_to(ROOT / room).parts
            names = [
                node.value
                for node in ast.parse(file.read_text()).body
                if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__"
            ]
            if names and ast.literal_eval(names[0]):
                found.append(".".join(package))
    return found


def on_config(config: MkDocsConfig) -> None:
    """Name the pages of folders in the navigation, of the guides those that it does not name."""
    python = [f"reference/python/{package}.md" for package in public_packages()]
    decisions = [f"decisions/{file.name}" for file in sorted((ROOT / "docs/decisions").glob("*.md"))]
    named = (ROOT / "mkdocs.yml").read_text()
    guides = [f"guides/{file.name}" for file in sorted((ROOT / "docs/guides").glob("*.md")) if file.name not in named]
    folders = {"reference/python/": python, "decisions/": decisions, "guides/": guides}

    def opened(item: Any) -> Any:
        if isinstance(item, str):
            return folders.get(item, item)
        if isinstance(item, list):
            parts = [opened(part) for part in item]
            return [one for part in parts for one in (part if isinstance(part, list) else [part])]
        return {title: opened(part) for title, part in item.items()}

    config.nav = opened(config.nav)
    config.mdx_configs["toc"]["slugify"] = slugify(case="lower")  # anchors are those that code hosts make


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the generated pages, and what pages link to outside of this folder."""
    for package in public_packages():
        text = f"# {package}\n\n::: {package}\n"
        files.append(File.generated(config, f"reference/python/{package}.md", content=text))
    files.append(File.generated(config, "changelog.md", content=_changelog()))
    for file in [file for file in files if file.src_uri.endswith(".md")]:
        for _, _, target, _ in LINK.findall(file.content_string):
            path = _outside(file.src_uri, target)
            if path is not None and path.is_file() and files.get_file_from_path(_copied(path)) is None:
                files.append(File.generated(config, _copied(path), abs_src_path=str(path)))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Links out of this folder lead to the copies of files; those to folders are names."""

    def changed(match: re.Match[str]) -> str:
        mark, text, target, _ = match.groups()
        path = _outside(page.file.src_uri, target)
        if path is None:
            return match.group()
        up = "../" * page.file.src_uri.count("/")
        return f"{mark}[{text}]({up}{_copied(path)})" if path.is_file() else text

    return LINK.sub(changed, markdown)


def on_page_content(html: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Docstrings name what they mean by roles of reStructuredText and end a line before code with two colons."""
    return ROLE.sub(r"\1", html).replace("<p>::</p>", "").replace("::</p>", ":</p>")


def _outside(page: str, target: str) -> Path | None:
    """What a link of a page means, if that is outside of this folder."""
    path = (ROOT / "docs" / page).parent.joinpath(target).resolve()
    return None if path.is_relative_to(ROOT / "docs") else path


def _copied(path: Path) -> str:
    return f"files/{path.relative_to(ROOT)}" + (".txt" if path.suffix == ".md" else "")


def _changelog() -> str:
    text = (ROOT / "CHANGELOG.md").read_text()
    return re.sub(r"\]\((?!https?:|#)(docs/)?", lambda match: "](" if match[1] else "](../", text)
