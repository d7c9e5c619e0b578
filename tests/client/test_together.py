"""A pool whose threads ask together: in as few requests as there are rounds, and nobody waits for ever."""

import numpy as np
import pytest

from bnserve_client import Together


def test_questions_of_all_threads_are_one_request():
    pool = Together(lambda questions: np.array(questions) * 2.0, size=4)
    assert pool.map(pool.log_likelihood, range(8)) == [2.0 * number for number in range(8)]
    assert pool.requests == 2
    pool.close()
    pool.join()


@pytest.mark.parametrize("wrong", [lambda questions: [1.0], lambda questions: ["none"] * len(questions)])
def test_too_few_values_or_what_is_no_number_are_an_error_for_all(wrong):
    pool = Together(wrong, size=4)
    outcomes = []

    def ask(number):
        try:
            pool.log_likelihood(number)
        except ValueError as error:
            outcomes.append(error)

    pool.map(ask, range(4))
    assert len(outcomes) == 4
    pool.close()
    pool.join()
