"""Calls in processes of their own: their answers are those of calls here, and each can be ended."""

import gc
import os
import signal
import subprocess
import sys
import threading
from dataclasses import dataclass, replace
from functools import partial
from time import monotonic, sleep

import pytest
from hypothesis import given
from hypothesis import strategies as st
from repair.damage import right_claims

from workbench import check
from workbench.app.pipeline.judge_claims import PaperJudge, judge_paper
from workbench.core.verdict import EngineDisagreement, Outcome
from workbench.papers import PaperError, find_paper, load_paper
from workbench.prover.decide.decide import Judge
from workbench.repair.propose.candidate_judge import verdict_or_none
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits
from workbench.runtime import Budget, OutOfBudget, Workers, interruptible


@pytest.fixture(scope="module")
def right():
    return right_claims(find_paper())


@dataclass(frozen=True)
class Endless(Judge):
    def judge(self, *args, **kwargs):
        while True:
            sleep(1)


def spin(item):
    while True:
        item = item


def is_gone(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return True
    return False


def or_spin(item):
    return spin(item) if item < 0 else item * item


def whose(seconds):
    sleep(seconds)
    return os.getpid()


def of_its_kind(item):
    sleep(item[1])
    return item[0], os.getpid()


def test_neighbours_that_are_alike_are_for_one_process():
    items = [(kind, 0.01) for kind, count in {"a": 6, "b": 12, "c": 40}.items() for _ in range(count)]
    with Workers(of_its_kind, None, 2, alike=lambda item: item[0]) as workers:
        answers = list(workers.map(items))
    one, other, last = ({pid for told, pid in answers if told == kind} for kind in "abc")
    assert len(one) == len(other) == 1 and one != other
    assert last == one | other  # in the end both have a part in it


def test_who_has_nothing_left_takes_the_last_of_anothers_run():
    with Workers(whose, None, 2) as workers:
        answers = list(workers.map([0.5, *[0.001] * 31]))
        assert len(set(answers)) == 2
        assert set(answers[1:]) == {answers[-1]} != {answers[0]}
        assert len(set(workers.map([0.01] * 17))) == 2  # and nothing is left of it


def ended(seconds):
    sleep(seconds)
    return monotonic()


def test_meanwhile_is_while_all_are_at_work():
    begun = []
    with Workers(ended, None, 2) as workers:
        ends = list(workers.map([0.5, 0.5], meanwhile=lambda: begun.append(monotonic())))
    assert len(begun) == 1 and begun[0] < min(ends)


@pytest.mark.parametrize("count", [1, 2, 5])
def test_answers_come_in_order(count):
    with Workers(or_spin, Budget(60), count) as workers:
        assert list(workers.map(range(20))) == [n * n for n in range(20)]
        assert list(workers.map([])) == []


def test_the_verdict_is_that_of_the_judge_here(right):
    for claim, formula in right[::40]:
        judge = Judge(claim.notation.definitions)
        with Workers(partial(verdict_or_none, claim, judge), Budget()) as workers:
            there = list(workers.map([formula.statement] * 2))
        assert there == [judge.judge(formula.statement, assume=claim.supposed, orders=claim.orders)] * 2


@pytest.mark.parametrize("count", [1, 2])
def test_only_the_call_past_its_processor_time_is_ended(count):
    with Workers(or_spin, Budget(seconds=0.3), count) as workers:
        answers = list(workers.map([1, -1, 2, -1, 3]))
        assert answers[::2] == [1, 4, 9]
        for answer in answers[1::2]:
            assert isinstance(answer, OutOfBudget) and "0.3 s of processor time" in str(answer)
        with pytest.raises(OutOfBudget, match=r"0\.3 s"):
            workers.call(-1)
        assert workers.call(5) == 25


def test_the_time_is_that_of_one_call():
    def work(_):
        end = monotonic() + 0.2
        while monotonic() < end:
            pass

    with Workers(work, Budget(seconds=0.7)) as workers:
        assert list(workers.map([0] * 6)) == [None] * 6


def test_a_call_that_waits_is_ended_by_the_clock():
    with Workers(lambda item: sleep(60), Budget()) as workers:
        start = monotonic()
        with pytest.raises(OutOfBudget):
            workers.call(0, seconds=0.2)
        assert 0.2 <= monotonic() - start < 5


def test_past_its_memory_a_call_is_ended():
    def take(megabytes):
        return len(bytearray(megabytes * 1_000_000)) // 1_000_000

    with Workers(take, Budget(megabytes=200)) as workers:
        answers = list(workers.map([20, 500, 30]))
        assert [answers[0], answers[2]] == [20, 30]
        assert isinstance(answers[1], OutOfBudget) and "200 MB of memory" in str(answers[1])


def test_a_process_that_ends_itself_is_no_answer():
    with Workers(lambda item: os.kill(os.getpid(), signal.SIGKILL) if item else 7, Budget()) as workers:
        first, second = workers.map([1, 0])
        assert isinstance(first, OutOfBudget) and second == 7


def test_a_defect_is_raised_here_in_its_turn():
    def broken(item):
        if item == 2:
            raise EngineDisagreement("on purpose")
        return item

    with Workers(broken, Budget(), 2) as workers:
        answers = workers.map(range(5))
        assert [next(answers), next(answers)] == [0, 1]
        with pytest.raises(EngineDisagreement, match="on purpose"):
            next(answers)


def test_no_process_is_left():
    with Workers(lambda item: os.getpid(), None, 2) as workers:
        pids = set(workers.map(range(8)))
        assert os.getpid() not in pids
    assert all(map(is_gone, pids))
    workers.call(0)
    workers.close()


def test_child_processes_of_a_call_end_with_it():
    def inner(n):
        with Workers(or_spin, Budget(0.3)) as workers:
            return [str(answer) for answer in workers.map([n, -1])]

    with Workers(inner, None, 2) as workers:
        for n, answers in enumerate(workers.map(range(3))):
            assert answers == [str(n * n), "not decided within 0.3 s of processor time"]


def test_a_program_that_does_not_close_them_ends_all_the_same():
    code = "import os\nfrom workbench.runtime import Workers\nw = Workers(lambda n: os.getpid(), None)\nprint(w.call(0))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and is_gone(int(done.stdout))


def test_processes_of_deleted_workers_end():
    workers = Workers(lambda n: os.getpid(), None)
    pid = workers.call(0)
    del workers
    gc.collect()
    assert is_gone(pid)


def test_calls_of_a_closed_map_end():
    workers = Workers(lambda item: sleep(item) or os.getpid(), None, 2)
    answers = workers.map([0, 60, 60])
    pid, start = next(answers), monotonic()
    answers.close()
    assert monotonic() - start < 5
    workers.close()
    assert is_gone(pid)


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
    judge = Judge(claim.notation.definitions)
    try:
        with Workers(partial(verdict_or_none, claim, judge), Budget()) as workers:
            assert workers.call(formula.statement) is not None
    finally:
        done.set()
        thread.join()


def test_a_repair_ends_in_time_though_no_judgement_does(right):
    claim = next(claim for claim in find_paper().claims if claim.id == "70.div")
    start = monotonic()
    found = repair(claim, Limits(seconds=1.5, judgement=0.5), judge=Endless(claim.notation.definitions))
    assert monotonic() - start < 6
    assert not found.complete and not found.proposals


#: True, and nobody expands it in a tenth of a second.
DEAR = r"\det ((T S T + S T S) (T + S T)) = \det (T S T + S T S) \det (T + S T)"
TENSORS = {"T": "tensor", "S": "tensor"}


def test_a_formula_past_its_budget_is_unchecked():
    checked = check(DEAR, TENSORS, seconds=0.2)
    assert checked.outcome == Outcome.UNCHECKED and "0.2 s of processor time" in checked.verdict.reason
    assert check("T S = T S + S - S", TENSORS, seconds=20).holds


@pytest.mark.parametrize(
    ("name", "value"), [("seconds", 0), ("seconds", -1), ("megabytes", 0), ("seconds", "much")]
)
def test_a_budget_is_positive(name, value):
    with pytest.raises(ValueError, match=f"{name}: expected a positive number, got"):
        check("T = S", TENSORS, **{name: value})


PAPER = """title = "Dear"
{budget}
[symbols]
T = {{ kind = "tensor" }}
S = {{ kind = "tensor" }}
[[claim]]
id = "1"
printed = 'T + S = S + T'
[[claim]]
id = "2"
printed = '{dear}'
[[claim]]
id = "3"
printed = 'T - S = -S + T'
"""


def paper(tmp_path, budget):
    path = tmp_path / "dear.toml"
    path.write_text(PAPER.format(budget=budget, dear=DEAR))
    return load_paper(path)


def test_a_paper_says_what_a_judgement_may_cost(tmp_path):
    found = paper(tmp_path, "budget = { seconds = 0.5 }")
    assert found.budget == Budget(seconds=0.5)
    outcomes = [result.verdict.outcome for result in judge_paper(found, motions=False)]
    assert outcomes == [Outcome.PROVED, Outcome.UNCHECKED, Outcome.PROVED]
    assert PaperJudge(found).budget == Budget(seconds=0.5)
    assert PaperJudge(found, budget=Budget(3)).budget == Budget(3)
    assert PaperJudge(replace(found, budget=None)).budget == Budget()


@pytest.mark.parametrize(
    ("budget", "message"),
    [
        ("budget = 3", "budget: expected"),
        ("budget = { hours = 3 }", "hours"),
        ("budget = { seconds = -3 }", "budget: seconds: expected a positive number, got -3"),
        ("budget = { megabytes = '3' }", "budget: megabytes: expected a positive number, got '3'"),
    ],
)
def test_a_budget_that_says_nothing_is_refused_with_its_place(tmp_path, budget, message):
    with pytest.raises(PaperError, match=message) as refused:
        paper(tmp_path, budget)
    assert refused.value.line == 2


class _Obsolete(Exception):
    """What a caller raises that does not need the answer any more."""


@pytest.mark.parametrize("count", [1, 2])
def test_a_caller_stops_waiting_for_an_answer(count):
    asked = []

    def check():
        asked.append(monotonic())
        if len(asked) == 3:
            raise _Obsolete

    start = monotonic()
    with Workers(or_spin, None, count) as workers:
        with interruptible(check), pytest.raises(_Obsolete):
            list(workers.map([-1]))
        assert monotonic() - start < 20 and workers.call(5) == 25, "the pool goes on"


@given(st.just(0.3))
def test_case_that_waits_for_the_processor_is_no_failure(seconds: float) -> None:
    sleep(seconds)
