"""What models, versions, labels and tensors may be called, and how versions are ordered.

Names become folder names, so they are restricted to characters that cannot leave the store on any file system.
"""

from __future__ import annotations

import re

from bnserve_protocol import InvalidRequest

NAME_PATTERN = r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}"
LABEL_PATTERN = r"[A-Za-z][A-Za-z0-9_-]{0,63}"
TENSOR_PATTERN = r"[A-Za-z0-9][A-Za-z0-9_./-]{0,199}"
_NUMBER = r"(?:0|[1-9][0-9]{0,8})"
VERSION_PATTERN = rf"{_NUMBER}(?:\.{_NUMBER}){{0,3}}(?:(?:a|b|rc){_NUMBER})?(?:\.post{_NUMBER})?(?:\.dev{_NUMBER})?"
"""Versions in the normal form of PEP 440, without epochs and local parts: ``1.2``, ``1.2.0rc1``, ``2.0.dev3``."""

_NAME = re.compile(NAME_PATTERN)
_LABEL = re.compile(LABEL_PATTERN)
_TENSOR = re.compile(TENSOR_PATTERN)
_VERSION = re.compile(VERSION_PATTERN)
_PARTS = re.compile(r"([0-9.]*[0-9])(?:(a|b|rc)([0-9]+))?(?:\.post([0-9]+))?(?:\.dev([0-9]+))?")


def is_name(text: str) -> bool:
    """Whether ``text`` may be the name of a model."""
    return isinstance(text, str) and _NAME.fullmatch(text) is not None


def is_version(text: str) -> bool:
    """Whether ``text`` may be a version."""
    return isinstance(text, str) and _VERSION.fullmatch(text) is not None


def _check(allowed: re.Pattern[str], text: str, complaint: str) -> None:
    if not isinstance(text, str) or allowed.fullmatch(text) is None:
        raise InvalidRequest(f"'{str(text)[:80]}' {complaint}")


def check_name(name: str) -> None:
    """Refuse a model name that could not be a folder: InvalidRequest."""
    rule = "use up to 64 letters, digits, '_' and '-', beginning with a letter or digit."
    _check(_NAME, name, f"cannot be the name of a model: {rule}")


def check_version(version: str) -> None:
    """Refuse a version that is not numbered: InvalidRequest."""
    _check(_VERSION, version, "is not a version: use numbers, like 1.2.0 or 1.2.0rc1.")


def check_label(label: str) -> None:
    """Refuse a label that could be mistaken for a version or a path: InvalidRequest."""
    rule = "use up to 64 letters, digits, '_' and '-', beginning with a letter."
    _check(_LABEL, label, f"cannot be a label: {rule}")


def check_tensor_name(name: str) -> None:
    """Refuse a tensor name with unusual characters: InvalidRequest."""
    rule = "use up to 200 letters, digits, '_', '-', '.' and '/', beginning with a letter or digit."
    _check(_TENSOR, name, f"cannot be the name of a tensor: {rule}")


def version_key(version: str) -> tuple[tuple[int, ...], tuple[int, int], int, float, str]:
    """Sort key of a version, in the order of PEP 440: 1.0.dev1 < 1.0a1 < 1.0rc1 < 1.0 < 1.0.post1 < 1.0.1 < 1.10.

    The text comes last, so that the equal versions 1.0 and 1.0.0 have an order too.

    Raises
    ------
    InvalidRequest
        It is no version.
    """
    parts = _PARTS.fullmatch(version)
    if parts is None:
        raise InvalidRequest(f"'{version[:80]}' is not a version: use numbers, like 1.2.0 or 1.2.0rc1.")
    release, stage, stage_number, post, dev = parts.groups()
    numbers = [int(number) for number in release.split(".")]
    while numbers and numbers[-1] == 0:
        numbers.pop()
    if stage is not None:
        phase = (("a", "b", "rc").index(stage), int(stage_number))
    else:
        before_everything = dev is not None and post is None
        phase = (-1, 0) if before_everything else (3, 0)
    return tuple(numbers), phase, -1 if post is None else int(post), float("inf") if dev is None else int(dev), version
