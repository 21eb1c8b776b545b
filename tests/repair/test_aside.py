"""A judge in a process of its own: its verdicts are those of the judge here, and it can be ended."""

import os
import sys
import threading
from dataclasses import dataclass
from time import monotonic, sleep

import pytest
from repair.damage import right_claims

from workbench.judge.judge import Judge
from workbench.judge.verdict import EngineDisagreement
from workbench.papers import find_paper
from workbench.repair.aside import JudgeAside, OutOfTime
from workbench.repair.limits import Limits
from workbench.repair.repair import repair


@pytest.fixture(scope="module")
def right():
    return right_claims(find_paper())


@dataclass(frozen=True)
class Endless(Judge):
    def judge(self, *args, **kwargs):
        while True:
            sleep(1)


@dataclass(frozen=True)
class Broken(Judge):
    def judge(self, *args, **kwargs):
        raise EngineDisagreement("on purpose")


def test_the_verdict_is_that_of_the_judge_here(right):
    for claim, formula in right[::40]:
        judge = Judge(claim.notation.definitions, motions=False)
        assume = claim.supposed
        aside = JudgeAside(judge, assume, claim.orders)
        there = [aside.verdict(formula.statement, 60) for _ in range(2)]
        aside.close()
        assert there == [judge.judge(formula.statement, assume=assume, orders=claim.orders)] * 2, claim.id


def test_an_endless_judgement_is_ended_and_its_process_is_gone(right):
    claim, formula = right[0]
    aside = JudgeAside(Endless(claim.notation.definitions))
    for _ in range(2):
        start = monotonic()
        with pytest.raises(OutOfTime):
            aside.verdict(formula.statement, 0.2)
        assert 0.2 <= monotonic() - start < 5
        assert aside._process is None


def test_a_defect_of_the_judge_is_raised_here(right):
    claim, formula = right[0]
    aside = JudgeAside(Broken(claim.notation.definitions))
    with pytest.raises(EngineDisagreement, match="on purpose"):
        aside.verdict(formula.statement, 60)
    pid = aside._process.pid
    aside.close()
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_it_needs_no_lock_that_another_thread_holds(right):
    claim, formula = right[0]
    held, done = threading.Event(), threading.Event()

    def hold():
        with threading.Lock(), sys.stdout.lock if hasattr(sys.stdout, "lock") else threading.Lock():
            held.set()
            done.wait(60)

    thread = threading.Thread(target=hold)
    thread.start()
    held.wait()
    aside = JudgeAside(Judge(claim.notation.definitions, motions=False))
    try:
        assert aside.verdict(formula.statement, 60) is not None
    finally:
        done.set()
        thread.join()
        aside.close()


def test_a_repair_ends_in_time_though_no_judgement_does(right):
    claim = next(claim for claim in find_paper().claims if claim.id == "70.div")
    start = monotonic()
    found = repair(claim, Limits(seconds=1.5, judgement=0.5), judge=Endless(claim.notation.definitions))
    assert monotonic() - start < 6
    assert not found.complete and not found.proposals
