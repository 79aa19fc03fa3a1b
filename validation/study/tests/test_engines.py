"""Whatever an adapter does, a case has a reply, and the next case a right one."""

from __future__ import annotations

import itertools
import time
from pathlib import Path

import pytest
from study.engines import Adapter, Limits, NotHere, listing

FAULTY = Path(__file__).with_name("faulty_adapter")
ONE = [(0.0, 0.0, 1.0, 0.1)]
TWO = [*ONE, (0.0, 1.0, 1.0, 0.0)]
LIMITS = Limits(seconds=0.5, start_seconds=5, memory=1 << 30)


def adapter(how: str) -> Adapter:
    return Adapter(FAULTY, how, LIMITS)


@pytest.mark.parametrize(
    ("how", "ending", "message"),
    [
        ("throws", "error", "Sorry: no"),
        ("dies", "crash", "SIGABRT"),
        ("exits", "crash", "exit code 7: had enough"),
        ("hangs", "timeout", "after 0.5 s"),
        ("eats memory", "memory", "MemoryError"),
        ("is killed", "memory", "SIGKILL"),
        ("tells of memory", "memory", "OutOfMemoryError: Java heap space"),
        ("garbage", "crash", "not of the protocol: no JSON"),
        ("another case", "crash", "not of the protocol: case 2 was asked"),
        ("no model", "crash", "neither a model nor an error"),
        ("a list", "crash", "case 2 was asked"),
    ],
)
def test_a_failure_is_told_and_the_next_case_answered(how: str, ending: str, message: str) -> None:
    with adapter(how) as a:
        assert a.ask(ONE).ending == "model"
        reply = a.ask(TWO)
        assert (reply.ending, message in reply.message) == (ending, True), reply
        after = a.ask(ONE)
        assert after.model == {"V": [[0.0, 0.0], [1.0, 0.1]], "EV": [[0, 1]]}
        assert after.seconds == 0.5


def test_numbers_arrive_as_the_doubles_that_they_are() -> None:
    row = (0.1, 1e-300, -1.7976931348623157e308, 2.0**-1074)
    with adapter("throws") as a:
        reply = a.ask([row])
    assert reply.model is not None and [*itertools.chain(*reply.model["V"])] == [*row]


def test_a_case_larger_than_a_pipe_is_answered() -> None:
    many = [(float(i), 0.1, 0.2, 0.3) for i in range(50_000)]
    with Adapter(FAULTY, "garbage", LIMITS) as a:
        assert a.ask(many).message.startswith("not of the protocol: no JSON")


def test_an_answer_before_the_case_is_none() -> None:
    with adapter("answers first") as a:
        time.sleep(0.2)
        assert a.ask([ONE[0]] * 200_000).ending == "crash"


def test_what_an_adapter_says_unasked_is_not_taken_for_an_answer() -> None:
    with adapter("talks on") as a:
        assert a.ask(ONE).ending == "model"
        replies = [a.ask(ONE).ending for _ in range(3)]
    assert set(replies) <= {"crash", "model"}
    assert all(reply != "error" for reply in replies)


def test_an_engine_that_is_not_here_is_no_failure() -> None:
    with pytest.raises(NotHere, match="no such engine"):
        listing(FAULTY)
    with pytest.raises(NotHere, match="no such engine"), adapter("not here") as a:
        a.ask(ONE)
    with pytest.raises(NotHere):
        listing(FAULTY.with_name("nothing"))
