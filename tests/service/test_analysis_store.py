"""Uploaded analyses: whose they are, how many are kept, and who loses one when there is no room."""

import pytest

from bnserve_protocol import (
    AnalysisInvalid,
    AnalysisUnknown,
    TooLarge,
    UndecodableBody,
    encode_analysis,
)
from bnserve_service import Settings
from bnserve_service.errors import SettingsInvalid
from bnserve_service.settings import load_settings
from bnserve_service.uploads.analyses import AnalysisStore
from tests.service.injections import name_of, small_analysis

ANALYSES = [small_analysis(seed=seed) for seed in range(5)]
BODIES = [b"".join(encode_analysis(analysis)) for analysis in ANALYSES]
NAMES = [name_of(analysis) for analysis in ANALYSES]
SIZE = len(BODIES[0])


def store(own=10 * SIZE, together=20 * SIZE, count=100):
    return AnalysisStore(
        Settings(max_analysis_bytes=SIZE, max_owner_analyses_bytes=own, max_analyses_bytes=together, max_analyses=count)
    )


def put(analyses, owner, *numbers):
    return [analyses.put(owner, NAMES[number], BODIES[number])[1] for number in numbers]


def kept(analyses, owner):
    found = set()
    for number, name in enumerate(NAMES):
        try:
            analyses.get(owner, name)
        except AnalysisUnknown:
            continue
        found.add(number)
    return found


def test_an_analysis_comes_back_as_it_was():
    analyses = store()
    assert put(analyses, "me", 0) == [True]
    assert put(analyses, "me", 0) == [False]
    assert analyses.get("me", NAMES[0]).analysis.digest == ANALYSES[0].digest
    assert analyses.stored_bytes == SIZE


def test_the_analysis_of_one_is_unknown_to_another():
    analyses = store()
    put(analyses, "me", 0)
    for forbidden in (analyses.get, analyses.drop):
        with pytest.raises(AnalysisUnknown):
            forbidden("you", NAMES[0])
    assert kept(analyses, "me") == {0}


@pytest.mark.parametrize("workers", [1, 2])
def test_what_is_listed_is_of_one_owner_and_counts_as_unused(workers, tmp_path):
    """Also what another worker received, which has to be read once."""
    me, you = "1" * 64, "2" * 64
    settings = Settings(max_analysis_bytes=SIZE, max_owner_analyses_bytes=2 * SIZE, max_analyses_bytes=20 * SIZE)
    received = AnalysisStore(settings, tmp_path if workers > 1 else None)
    other = AnalysisStore(settings, tmp_path) if workers > 1 else received
    put(received, me, 0, 1)
    put(received, you, 2)
    assert other.all_bytes_to_read(me) == (2 * SIZE if workers > 1 else 0)
    assert [stored.sha256 for stored in other.all_of(me)] == sorted(NAMES[:2])
    assert other.all_bytes_to_read(me) == 0
    assert other.all_of("3" * 64) == []
    other.get(me, NAMES[0])
    other.all_of(me)
    put(received, me, 3)
    assert kept(received, me) == {0, 3}
    assert {stored.sha256 for stored in other.all_of(me)} == {NAMES[0], NAMES[3]}


def test_two_owners_of_the_same_share_its_memory_and_neither_takes_it_from_the_other():
    analyses = store()
    assert put(analyses, "me", 0) == put(analyses, "you", 0) == [True]
    assert analyses.stored_bytes == SIZE
    assert analyses.get("me", NAMES[0]) is analyses.get("you", NAMES[0])
    analyses.drop("me", NAMES[0])
    assert kept(analyses, "you") == {0}
    analyses.drop("you", NAMES[0])
    assert (len(analyses), analyses.stored_bytes) == (0, 0)


def test_an_owner_over_their_quota_loses_what_they_used_longest_ago():
    analyses = store(own=2 * SIZE)
    put(analyses, "you", 4)
    put(analyses, "me", 0, 1)
    analyses.get("me", NAMES[0])
    put(analyses, "me", 2)
    assert kept(analyses, "me") == {0, 2}
    assert kept(analyses, "you") == {4}


def test_so_does_one_with_too_many():
    analyses = store(count=2)
    put(analyses, "me", 0, 1, 2)
    assert kept(analyses, "me") == {1, 2}


def test_when_all_is_full_whoever_has_most_makes_room():
    analyses = store(own=3 * SIZE, together=4 * SIZE)
    put(analyses, "me", 0, 1, 2)
    put(analyses, "you", 3)
    put(analyses, "you", 4)
    assert kept(analyses, "me") == {1, 2}
    assert kept(analyses, "you") == {3, 4}
    assert analyses.stored_bytes == 4 * SIZE


def test_what_was_just_uploaded_stays():
    analyses = store(own=2 * SIZE, together=2 * SIZE)
    put(analyses, "me", 0)
    put(analyses, "him", 1)
    put(analyses, "you", 2)
    assert kept(analyses, "you") == {2}
    assert len(analyses) == 2


def test_what_is_refused_leaves_nothing_behind():
    analyses = store()
    with pytest.raises(AnalysisInvalid, match=ANALYSES[1].digest):
        analyses.put("me", NAMES[0], BODIES[1])
    with pytest.raises(UndecodableBody):
        analyses.put("me", NAMES[0], BODIES[0][:-1])
    with pytest.raises(TooLarge, match="at most"):
        analyses.put("me", NAMES[0], BODIES[0] + b"\xc0")
    assert (len(analyses), analyses.stored_bytes) == (0, 0)


@pytest.mark.parametrize("smaller", ["max_owner_analyses_bytes", "max_analyses_bytes"])
def test_limits_that_could_not_hold_one_analysis_are_refused(smaller):
    with pytest.raises(SettingsInvalid, match="could not be kept"):
        load_settings(None, {smaller: 2**20})
