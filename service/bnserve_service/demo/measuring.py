"""Medians of calls, and bits that are the same."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence

import numpy as np

from bnserve_protocol import ComplexArray, Polarizations


def medians(calls: Sequence[Callable[[], object]], repetitions: int) -> list[float]:
    """Median seconds of each call. They take turns, so that a slow moment of the machine hits all of them."""
    seconds = np.empty((repetitions, len(calls)))
    for row in seconds:
        for column, call in enumerate(calls):
            started = time.perf_counter()
            call()
            row[column] = time.perf_counter() - started
    return [float(value) for value in np.median(seconds, axis=0)]


def identical_numbers(one: Polarizations, other: Polarizations) -> int:
    """How many of the complex numbers of two answers to one question have the same bits."""
    return sum(_identical(*pair) for pair in zip(one, other, strict=True))


def _identical(one: ComplexArray, other: ComplexArray) -> int:
    words = np.ascontiguousarray(one).view(np.uint64) == np.ascontiguousarray(other).view(np.uint64)
    return int(words.reshape(-1, 2).all(axis=1).sum())
