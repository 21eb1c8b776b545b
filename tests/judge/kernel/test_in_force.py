"""From which n on a definition for all n is in force, for families with members that are defined apart."""

from random import Random

import pytest
from evaluator.identities import TABLE

from workbench.context.index_values import Orders
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definition, read_definitions
from workbench.language.definitions import Definitions
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.families.recurrence_range import exceptions, rewritten, symbolic_members


def defined(entries):
    definitions, table = read_definitions(entries, TABLE)
    return Judge(definitions), table


def by_letter(known):
    return {name.letter: value for name, value in known.items()}


def family(random):
    """A recurrence with a base at `lowest`, members that say the same as it, and members that do not."""
    lowest = random.randrange(2)
    own = random.sample(range(lowest + 1, lowest + 6), random.randrange(4))
    apart = {k for k in own if random.random() < 0.5}
    entries = {f"s_{lowest}": "g", "s_{n+1}": "f s_n"}
    entries |= {f"s_{k}": f"s_{k - 1} + g" if k in apart else f"f s_{k - 1}" for k in own}
    apart |= {lowest} - {0}  # the recurrence would go below the base
    names = list(entries)
    random.shuffle(names)
    return {name: entries[name] for name in names}, lowest, apart


@pytest.mark.parametrize("seed", range(15))
def test_members_that_contradict_the_recurrence_are_exceptions(seed):
    random = Random(seed)
    entries, lowest, apart = family(random)
    judge, table = defined(entries)
    known = exceptions(judge)
    assert by_letter(known.apart) == ({"s": frozenset(apart)} if apart else {})
    assert by_letter(known.first) == {"s": lowest} and not known.tangled
    assert exceptions(judge) is known
    shift = random.randrange(4)
    (claim,) = read(rf"s_{{n+{shift}}} = f s_{{n+{shift + 1}}}", table, ["n"])
    members = symbolic_members(part for side in (claim.left, claim.right) for part in side.walk())
    assert [int(m.index[0] - members[0].index[0]) for m in members] == [0, 1]
    above = max((k + 1 for k in apart), default=0)
    assert known.start(members[:1]) == {"n": max(0, above - shift)}
    assert known.start(members) == known.start(members[:1])
    assert known.begin(members) == {"n": max(0, lowest - shift)}
    assert known.start([]) == known.begin([]) == {}


@pytest.mark.parametrize("seed", range(15))
def test_a_claim_for_all_n_begins_behind_what_is_apart(seed):
    entries, lowest, apart = family(Random(seed))
    judge, table = defined(entries)
    (claim,) = read(r"\frac{d}{dt} s_{n+1} = \frac{d}{dt} (f s_n)", table, ["n"])
    above = max(apart, default=0)
    verdict = judge.judge(claim, orders=Orders.parse(f"n = {above}..{above + 2}"))
    assert verdict.outcome == Outcome.PROVED
    is_base = apart <= {lowest}
    assert verdict.scope == (("all n ≥ 1" if lowest else "all n") if is_base else f"n = {above}..{above + 2}")
    if not is_base:
        below = judge.judge(claim, orders=Orders.parse(f"n = {max(apart) - 1}..{above + 2}"))
        assert below.outcome == Outcome.REFUTED
        assert below.reason.startswith(f"for n = {max(apart) - 1}")


def test_members_of_members_are_rewritten():
    judge, table = defined({"s_0": "f", "s_{n+1}": "g s_n", "k_{m,n}": "s_m s_{n+2}"})
    (claim,) = read(r"k_{n,n+1} = s_{n+1} x \cdot a_n", table, ["n"])
    found = {
        (s.declaration.name.letter, *map(str, s.index))
        for s in rewritten([claim.left, claim.right], judge.definitions)
    }
    numbers = ["n+1", "n+2", "n+3"]
    assert found == {("k", "n", "n+1"), *(("s", number) for number in numbers)}
    parts = [part for side in (claim.left, claim.right) for part in side.walk()]
    assert [s.declaration.name.letter for s in symbolic_members(parts)] == [
        "k",
        "s",
        "a",
    ]
    (free,) = read("s_2 = k_{1,2}", table, ["n"])
    assert not symbolic_members([free.left]) and not list(
        rewritten([free.left, free.right], judge.definitions)
    )


@pytest.mark.parametrize(
    ("entries", "first"),
    [
        ({"s_{n+1}": "f s_n"}, 0),
        ({"s_0": "g", "s_{n+1}": "f s_n"}, 0),
        ({"s_1": "g", "s_{n+1}": "f s_n"}, 1),
        ({"s_2": "g", "s_{n+1}": "f s_n"}, 0),
        ({"s_1": "g", "s_2": "f", "s_{n+2}": "f s_{n+1} + s_n"}, 1),
        ({"s_1": "g", "s_2": "f", "s_{n+3}": "f s_{n+2} + s_{n+1}"}, 1),
        ({"s_2": "g", "s_3": "f", "s_{n+4}": "f s_{n+3} + s_{n+2}"}, 2),
        ({"s_1": "g", "s_{n+1}": "f"}, 0),
        ({"s_1": "g", "s_{n+3}": "f s_n"}, 0),
        ({"s_1": "g", "s_{n+2}": "f s_{n+1} + s_n"}, 0),
    ],
)
def test_where_a_family_begins(entries, first):
    assert by_letter(exceptions(defined(entries)[0]).first) == {"s": first}


@pytest.mark.parametrize(
    ("entries", "tangled"),
    [
        ({"k_{m,n}": "f"}, False),
        ({"k_{0,0}": "f", "k_{m,n}": "f"}, False),
        ({"k_{0,0}": "g", "k_{m,n}": "f"}, True),
        ({"k_{0,n}": "f", "k_{m,n}": "f"}, True),
        ({"k_{0,n}": "f", "k_{m+1,n}": "g"}, False),
        ({"k_{2,n}": "f", "k_{m+1,n}": "g"}, True),
        ({"k_{m,0}": "f", "k_{m,n+1}": "g"}, False),
        ({"k_{0,n}": "f", "k_{1,n}": "g"}, False),
        ({"k_{0,n+1}": "f", "k_{m+1,0}": "g"}, False),
        ({"s_0": "f", "s_{n+1}": "g"}, False),
    ],
)
def test_whether_two_definitions_share_a_member(entries, tangled):
    """The reader refuses those that overlap; whoever makes definitions otherwise gets no proof for all n."""
    apart = [read_definition(key, body, TABLE)[0] for key, body in entries.items()]
    assert exceptions(Judge(Definitions(apart))).tangled == tangled


def test_of_a_tangled_family_each_member_is_judged():
    apart = [read_definition(key, body, TABLE)[0] for key, body in {"k_{0,0}": "g", "k_{m,n}": "f"}.items()]
    judge, (claim,) = Judge(Definitions(apart)), read("k_{n,n+1} = f + 0", TABLE, ["n"])
    found = judge.judge(claim, orders=Orders.parse("n = 0..2"))
    assert (found.outcome, found.scope) == (Outcome.PROVED, "n = 0..2")
    (claim,) = read("k_{n,n} = f + 0", TABLE, ["n"])
    found = judge.judge(claim, orders=Orders.parse("n = 0..2"))
    assert (found.outcome, found.reason) == (Outcome.REFUTED, "for n = 0")
