"""The public API of each package: ``__all__`` is explicit, importable, sorted, complete and documented."""

import ast
import importlib
import inspect
import re
from types import ModuleType

import pytest

import bnserve_protocol
from tests.architecture.rooms import ROOMS, ROOT, python_files


def public_packages() -> list[str]:
    """The rooms, and every public package in them that offers something itself and not only in its modules."""
    found = set(ROOMS.values())
    for path in python_files(*ROOMS):
        package = path.parent.parts[1:]
        is_public = path.name == "__init__.py" and not any(part.startswith("_") for part in package)
        if is_public and len(ast.parse((ROOT / path).read_text()).body) > 1:  # more than a docstring
            found.add(".".join(package))
    return sorted(found, key=lambda name: (name.count("."), name))


def natural_order(name: str) -> tuple:
    """As ruff sorts: constants, then classes, then the rest; numbers by value."""
    kind = 0 if name.isupper() else 1 if name[:1].isupper() else 2
    return kind, [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def defined_here(module: ModuleType) -> set[str]:
    """Public names of a package that are not submodules and come from its own room."""
    room = module.__name__.partition(".")[0]
    return {
        name
        for name, value in vars(module).items()
        if not name.startswith("_")
        and not inspect.ismodule(value)
        and getattr(value, "__module__", room).partition(".")[0] == room
    }


@pytest.fixture(params=public_packages())
def package(request) -> ModuleType:
    return importlib.import_module(request.param)


def test_all_is_explicit_and_importable(package):
    assert [name for name in package.__all__ if not hasattr(package, name)] == []


def test_all_is_sorted_without_repetition(package):
    assert package.__all__ == sorted(set(package.__all__), key=natural_order)


def test_all_is_complete(package):
    ignored = {"annotations"}
    assert defined_here(package) - ignored - set(package.__all__) == set()


def test_everything_public_is_documented(package):
    public = [getattr(package, name) for name in package.__all__]
    callables = [item for item in public if inspect.isclass(item) or inspect.isfunction(item)]
    assert [item.__qualname__ for item in callables if not (item.__doc__ or "").strip()] == []


def errors_without_a_when(docstring: str) -> list[str]:
    """The lines of a ``Raises`` section that name errors without a line below them that says when."""
    section = re.search(r"^Raises\n-+\n((?:.*\n)*?(?=.+\n-+$|\Z))", docstring + "\n", re.MULTILINE)
    lines = section[1].splitlines() if section else []
    pairs = zip(lines, [*lines, ""][1:], strict=True)
    return [line for line, following in pairs if re.match(r"\w", line) and not following.startswith("    ")]


def test_raises_says_when():
    documented = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
    trees = {path: ast.parse((ROOT / path).read_text()) for path in python_files(*ROOMS)}
    found = {
        f"{path}:{node.lineno}": missing
        for path, tree in trees.items()
        for node in ast.walk(tree)
        if isinstance(node, documented) and (missing := errors_without_a_when(ast.get_docstring(node) or ""))
    }
    assert found == {}


def test_errors_without_a_when_are_found():
    docstring = "Do.\n\nRaises\n------\nTooLarge\nOutOfBand, OutOfDomain\n    It is out.\n\nReturns\n-------\nWhat"
    assert errors_without_a_when(docstring) == ["TooLarge"]


def test_names_that_moved_to_the_wire_are_found_where_they_were_with_a_warning():
    with pytest.warns(DeprecationWarning, match="Import encode_request from bnserve_protocol.wire"):
        from bnserve_protocol import encode_request

    assert encode_request is bnserve_protocol.wire.encode_request
    assert not hasattr(bnserve_protocol, "decode_anything")


@pytest.mark.parametrize("package", ["bnserve_protocol", "bnserve_client"])
def test_the_error_of_a_quota_has_its_former_name_with_a_warning(package):
    with pytest.warns(DeprecationWarning, match="ShareExceeded is QuotaExceeded"):
        former = importlib.import_module(package).ShareExceeded
    assert former is bnserve_protocol.QuotaExceeded


def test_what_imports_the_packages_of_an_extra_has_its_former_names_with_a_warning():
    roq = importlib.import_module("bnserve_inference.roq")
    with pytest.warns(DeprecationWarning, match="RoqPackageMissing is bnserve_protocol.PackageMissing"):
        assert roq.RoqPackageMissing is bnserve_protocol.PackageMissing
    with pytest.warns(DeprecationWarning, match="Import require from bnserve_protocol"):
        former = roq.require
    assert former("json") is importlib.import_module("json")
    with pytest.raises(bnserve_protocol.PackageMissing, match=r"A basis.*no_such_package"):
        former("no_such_package")
