"""Which known name an unknown one may mean."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence

_COMPARED = 80
"""Characters of a name; more of it takes seconds and gigabytes for megabytes."""
_CANDIDATES = 8
_ALIKE = 0.5


def nearest_name(name: object, known: Iterable[str]) -> str | None:
    """The known name that an unknown one is by the fewest slips of a finger; None where none is like it.

    A slip is a letter too many, too few, another, or two that changed places. Capitals, and what stands between words,
    count for less than any of them.

    Parameters
    ----------
    name
        Of anybody; no more than its beginning is compared.
    known
        The names there are; of equally near ones the first counts.
    """
    wanted = str(name)[:_COMPARED]
    plain: dict[str, list[tuple[int, str]]] = {}
    for place, there in enumerate(known):
        plain.setdefault(_plain(there), []).append((place, there))
    alike = difflib.get_close_matches(_plain(wanted), plain, n=_CANDIDATES, cutoff=_ALIKE)
    # As many slips in the words are told apart by those between them.
    ranked = [
        (_slips(_plain(wanted), words), _slips(wanted.casefold(), there.casefold()), place, there)
        for words in alike
        for place, there in plain[words]
    ]
    return min(ranked)[3] if ranked else None


def _plain(name: str) -> str:
    return name.casefold().translate(_BETWEEN)


_BETWEEN = str.maketrans("", "", "_- .")


def _slips(one: Sequence[str], other: Sequence[str]) -> int:
    """The distance of Damerau and Levenshtein, in which no letter is changed twice."""
    before: list[int] = []
    last = list(range(len(other) + 1))
    for i, mine in enumerate(one, 1):
        line = [i]
        for j, theirs in enumerate(other, 1):
            slips = min(last[j] + 1, line[-1] + 1, last[j - 1] + (mine != theirs))
            if i > 1 and j > 1 and mine == other[j - 2] and one[i - 2] == theirs:
                slips = min(slips, before[j - 2] + 1)
            line.append(slips)
        before, last = last, line
    return last[-1]
