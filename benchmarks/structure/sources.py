"""What can be counted by reading: lines, functions, classes, folders, circles of imports."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import grimp

from benchmarks.workers import ROOT
from tests.architecture.rooms import ROOMS

LONG_FUNCTION, LARGE_CLASS = 40, 15
"""Lines, and methods whose names are not dunders; what is above is counted."""


def modules(folder: str | None = None) -> dict[Path, str]:
    """Path and text of every module of the product, or of one folder."""
    places = [ROOT / folder] if folder else [ROOT / room / package for room, package in ROOMS.items()]
    return {path: path.read_text() for place in places for path in sorted(place.rglob("*.py"))}


def lines(sources: dict[Path, str]) -> list[int]:
    """Lines of every module."""
    return sorted(len(text.splitlines()) for text in sources.values())


def _nodes(sources: dict[Path, str]) -> Iterator[tuple[Path, ast.AST]]:
    for path, text in sources.items():
        for node in ast.walk(ast.parse(text)):
            yield path.relative_to(ROOT), node


def long_functions(sources: dict[Path, str]) -> list[str]:
    """Functions of more than :data:`LONG_FUNCTION` lines, decorators and docstrings not counted."""
    found = []
    for path, node in _nodes(sources):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            own = node.body[0]
            documented = isinstance(own, ast.Expr) and isinstance(own.value, ast.Constant)
            docstring = (own.end_lineno or 0) - own.lineno + 1 if documented else 0
            length = (node.end_lineno or 0) - node.lineno + 1 - docstring
            if length > LONG_FUNCTION:
                found.append(f"{path}:{node.lineno} {node.name} ({length})")
    return found


def large_classes(sources: dict[Path, str]) -> list[str]:
    """Classes with more than :data:`LARGE_CLASS` methods."""
    found = []
    for path, node in _nodes(sources):
        if isinstance(node, ast.ClassDef):
            methods = [part.name for part in node.body if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef)]
            count = sum(not (name.startswith("__") and name.endswith("__")) for name in methods)
            if count > LARGE_CLASS:
                found.append(f"{path}:{node.lineno} {node.name} ({count})")
    return found


def folder_sizes(package: Path) -> Counter[Path]:
    """Python files directly in each folder of a package."""
    return Counter(path.parent.relative_to(package.parent) for path in package.rglob("*.py"))


def circles() -> list[str]:
    """Packages some of whose direct children import each other in a circle; imports for types alone count."""
    graph = grimp.build_graph(*ROOMS.values(), cache_dir=None)
    parents = sorted(name for name in graph.modules if graph.find_children(name))
    return [name for name in parents if graph.nominate_cycle_breakers(name)]
