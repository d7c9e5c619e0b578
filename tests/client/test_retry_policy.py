"""When it is tried again, and where: the policy without a network."""

from contextlib import suppress

import pytest

from bnserve_client._addresses import parse_addresses
from bnserve_client._replicas import Replicas
from bnserve_client._session import RetryPolicy
from bnserve_client._settings import Settings
from bnserve_protocol import (
    AnswerCorrupted,
    ConnectionFailed,
    DigestUnknown,
    InternalError,
    NotBnserve,
    OutOfDomain,
    Overloaded,
    QuotaExceeded,
)


def retry_policy(addresses="http://a, http://b", **settings):
    chosen = Settings(addresses=parse_addresses(addresses), **settings)
    return RetryPolicy(chosen, Replicas(chosen.addresses))


@pytest.mark.parametrize("error", [ConnectionFailed("gone"), Overloaded("full", retry_after=9.0), AnswerCorrupted("x")])
def test_another_replica_is_asked_at_once(error):
    trying = retry_policy()
    first = trying.address
    assert trying.pause_after(error) == 0.0
    assert trying.address != first


def test_when_all_replicas_have_failed_there_is_a_pause():
    trying = retry_policy()
    assert trying.pause_after(ConnectionFailed("gone")) == 0.0
    assert trying.pause_after(ConnectionFailed("gone")) > 0.0


def test_a_callers_own_excess_is_waited_for_even_where_there_are_other_replicas():
    trying = retry_policy()
    first = trying.address
    assert trying.pause_after(QuotaExceeded("slow down", retry_after=2.0)) >= 2.0
    assert trying.address == first


def test_retry_after_is_a_lower_bound_with_jitter():
    pauses = {retry_policy("http://a").pause_after(Overloaded("full", retry_after=4.0)) for _ in range(20)}
    assert all(4.0 <= pause <= 5.0 for pause in pauses)
    assert len(pauses) == 20


def test_pauses_grow_to_a_limit():
    trying = retry_policy("http://a")
    pauses = [trying.pause_after(ConnectionFailed("gone")) for _ in range(30)]
    assert pauses[0] <= 0.1
    assert all(2.5 <= pause <= 5.0 for pause in pauses[10:])


@pytest.mark.parametrize("error", [OutOfDomain("no"), InternalError("no")])
def test_what_cannot_get_better_is_raised(error):
    with pytest.raises(type(error)):
        retry_policy().pause_after(error)


@pytest.mark.parametrize("error", [AnswerCorrupted("x"), NotBnserve("x")])
def test_answers_that_cannot_be_trusted_are_given_six_chances(error):
    trying = retry_policy()
    for _ in range(5):
        trying.pause_after(error)
    with pytest.raises(type(error)):
        trying.pause_after(error)


def test_retries_are_counted():
    trying = retry_policy(retries=2)
    for _ in range(2):
        trying.pause_after(ConnectionFailed("gone"))
    with pytest.raises(ConnectionFailed):
        trying.pause_after(ConnectionFailed("gone"))


def test_a_pause_beyond_the_deadline_is_not_begun():
    with pytest.raises(Overloaded):
        retry_policy("http://a", timeout=3.0).pause_after(Overloaded("full", retry_after=4.0))


def test_a_quota_is_waited_for_to_the_fraction_of_a_second():
    pauses = [retry_policy("http://a").pause_after(QuotaExceeded("slow down", retry_after=0.012)) for _ in range(20)]
    assert all(0.012 <= pause <= 0.015 for pause in pauses)


def test_a_quota_without_a_time_is_waited_for_longer_and_longer():
    trying = retry_policy("http://a")
    pauses = [trying.pause_after(QuotaExceeded("slow down", retry_after=0.0)) for _ in range(12)]
    assert 0.0 < pauses[0] <= 0.1
    assert pauses[-1] >= 2.5


def test_a_replica_without_the_pinned_artifact_is_passed_over_and_believed_in_the_end():
    trying = retry_policy()
    first = trying.address
    assert trying.pause_after(DigestUnknown("not here")) == 0.0
    assert trying.address != first
    said = 1
    with suppress(DigestUnknown):
        while said < 20:
            trying.pause_after(DigestUnknown("not here"))
            said += 1
    assert 3 <= said < 20
