"""No code from data: nothing in the rooms can run what it loads."""

import ast
from collections.abc import Iterator

import pytest

from tests.architecture.rooms import ROOMS, ROOT, python_files

BANNED_IMPORTS = {
    "pickle", "_pickle", "cPickle", "cloudpickle", "dill", "marshal", "shelve", "msgpack_numpy"
}  # fmt: skip
BANNED_CALLS = {
    "eval", "exec", "compile", "__import__",
    "joblib.load", "joblib.dump", "torch.load", "pandas.read_pickle",
    "yaml.load", "yaml.load_all", "yaml.full_load", "yaml.unsafe_load",
}  # fmt: skip


def dotted(node: ast.expr) -> str:
    """``a.b.c`` of an attribute chain, or an empty string."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute) and (stem := dotted(node.value)):
        return f"{stem}.{node.attr}"
    return ""


def imported(node: ast.AST) -> Iterator[str]:
    """The full names that an import statement makes available, relative ones left out."""
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
        yield from (f"{node.module}.{alias.name}" for alias in node.names)


def violations(source: str) -> list[tuple[int, str]]:
    """Line and reason of everything banned in a piece of source."""
    found = []
    for node in ast.walk(ast.parse(source)):
        for name in imported(node):
            if name.partition(".")[0] in BANNED_IMPORTS or name in BANNED_CALLS:
                found.append((node.lineno, f"import of {name}"))
        if isinstance(node, ast.Call):
            if dotted(node.func) in BANNED_CALLS:
                found.append((node.lineno, f"call of {dotted(node.func)}"))
            for keyword in node.keywords:
                if keyword.arg == "allow_pickle" and not is_false(keyword.value):
                    found.append((node.lineno, "allow_pickle"))
    return found


def is_false(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value is False


@pytest.mark.parametrize("path", python_files(*ROOMS, "examples", "benchmarks"), ids=str)
def test_nothing_banned_is_used(path):
    assert violations((ROOT / path).read_text()) == []


@pytest.mark.parametrize(
    "text",
    [
        "import pickle",
        "from cloudpickle import loads",
        "import joblib\njoblib.load('model')",
        "from joblib import load",
        "import numpy as np\nnp.load(path, allow_pickle=True)",
        "np.load(path, allow_pickle=flag)",
        "import yaml\nyaml.load(text)",
        "value = eval(text)",
        "def deep():\n    if True:\n        exec(text)",
        "__import__(name)",
    ],
)
def test_a_violation_is_found(text):
    assert violations(text) != []


@pytest.mark.parametrize("harmless", ["model.load(path)", "np.load(path, allow_pickle=False)", "re.compile(text)"])
def test_harmless_code_passes(harmless):
    assert violations(harmless) == []
