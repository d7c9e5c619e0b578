"""Which of a model's derivatives are taken, and what is said of a model that has none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from bnserve_protocol import InvalidRequest, ModelDescription


class _Described(Protocol):
    @property
    def description(self) -> ModelDescription: ...


def differentiates(model: _Described, *methods: str, advice: str) -> Callable[..., Any]:
    """The first of some methods that a model has.

    Raises
    ------
    InvalidRequest
        It has none; the ``advice`` says what to do.
    """
    for method in methods:
        if (found := getattr(model, method, None)) is not None:
            return found
    raise InvalidRequest(f"The model '{model.description.name}' does not say that it has derivatives{advice}.")
