"""Priors as bilby writes them, ``Uniform(minimum=0, maximum=2 * np.pi)``, read without running anything.

bilby evaluates what a file says as Python. Here a prior is a call of one of bilby's classes with numbers, texts, lists
and other priors, and nothing else.
"""

from __future__ import annotations

import ast
import math
import operator
import warnings
from typing import Any

from bnserve_posterior.events import EventInvalid
from bnserve_protocol import nearest_name

_MODULES = ("bilby.core.prior", "bilby.gw.prior")
_NAMES = {
    "pi": math.pi,
    "np.pi": math.pi,
    "inf": math.inf,
    "np.inf": math.inf,
    "math.pi": math.pi,
    "math.inf": math.inf,
}
_OPERATORS = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
}  # fmt: skip
_LONGEST = 100_000
"""Characters of one prior: a table of some thousand numbers."""


def parse_prior(name: str, text: str) -> Any:
    """One of bilby's priors.

    Parameters
    ----------
    name
        Of the parameter.
    text
        A call of a class of bilby, with keyword arguments, or a number.

    Raises
    ------
    EventInvalid
        It is no such call, the class is none of bilby's, or does not take these arguments.
    """
    from bilby.core.prior import DeltaFunction

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # '$M_{\odot}$' is no escape sequence that Python knows
            node = ast.parse(text[:_LONGEST].strip(), mode="eval").body
        value = _value(node)
    except (SyntaxError, ValueError, TypeError, ArithmeticError, RecursionError, MemoryError) as error:
        raise EventInvalid(f"The prior of '{name}', {text[:80]!r}, is none that bilby writes: {error}.") from error
    if isinstance(value, int | float):
        return DeltaFunction(peak=float(value), name=name)
    if not _is_prior(value):
        raise EventInvalid(f"The prior of '{name}' must be a prior of bilby or a number; got {text[:80]!r}.")
    value.name = name
    return value


def read_prior_file(path: str) -> dict[str, Any]:
    """The priors of one of bilby's files, by name; ``#`` begins a comment.

    Raises
    ------
    EventInvalid
        Not readable, or a line that is no prior.
    """
    try:
        with open(path, encoding="utf-8") as file:  # noqa: PTH123  (a name that may be a short one of the user's)
            lines = file.read().splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise EventInvalid(f"Cannot read the priors in {path}: {error}.") from error
    found: dict[str, Any] = {}
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if not text or text.startswith("#"):
            continue
        name, separator, value = text.partition("=")
        if not separator:
            raise EventInvalid(f"Line {number} of {path} is no prior, NAME = PRIOR: {text[:80]!r}.")
        found[name.strip()] = parse_prior(name.strip(), value.strip())
    return found


def _value(node: ast.expr) -> Any:
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float | str | None):
        return node.value
    if isinstance(node, ast.Name | ast.Attribute):
        dotted = ast.unparse(node)
        if dotted in _NAMES:
            return _NAMES[dotted]
        raise ValueError(f"there is nothing called {dotted}")
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -_value(node.operand)
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        return _OPERATORS[type(node.op)](_number(node.left), _number(node.right))
    if isinstance(node, ast.List | ast.Tuple):
        return [_value(item) for item in node.elts]
    if isinstance(node, ast.Call):
        return _call(node)
    raise ValueError(f"{ast.unparse(node)[:40]} is neither a number nor a prior")


def _number(node: ast.expr) -> float:
    value = _value(node)
    if not isinstance(value, int | float):
        raise TypeError(f"{ast.unparse(node)[:40]} is no number")
    return value


def _call(node: ast.Call) -> Any:
    if node.args or any(keyword.arg is None for keyword in node.keywords):
        raise ValueError("its arguments must have names, minimum=0, maximum=1")
    arguments = {str(keyword.arg): _value(keyword.value) for keyword in node.keywords}
    return _class(ast.unparse(node.func))(**arguments)


def _class(dotted: str) -> Any:
    """One of bilby's priors by its name, with its module or without."""
    import bilby

    module, _, name = dotted.rpartition(".")
    known: dict[str, Any] = {}
    for place in (bilby.core.prior, bilby.gw.prior):
        known.update({key: value for key, value in vars(place).items() if _is_prior_class(value)})
    if name in known and (not module or module.startswith(_MODULES)):
        return known[name]
    near = nearest_name(name, known)
    raise ValueError(f"bilby has no prior {dotted}" + ("" if near is None else f"; did you mean {near}?"))


def _is_prior_class(value: Any) -> bool:
    from bilby.core.prior import Prior

    return isinstance(value, type) and issubclass(value, Prior) and value is not Prior


def _is_prior(value: Any) -> bool:
    from bilby.core.prior import Prior

    return isinstance(value, Prior)
