"""Which integers are looked at: those behind the numbers of a formula, and those of indices that may be any."""

from collections import namedtuple
from itertools import product

import pytest
from judge.test_judge import TABLE, defined

from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions
from workbench.language.reader import read, read_term
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.families.orders_past_literals import integer_past_literals, values_past_literals
from workbench.prover.decide.families.unbounded_indices import Distinct, judge_addends, ranges_apart

FREE = Definitions()


class Ranges(namedtuple("Ranges", "ranges generic endless", defaults=((), frozenset()))):
    """The values of each variable, those that may be any and those that have no end."""

    def assignments(self):
        for chosen in product(*self.ranges.values()):
            yield dict(zip(self.ranges, chosen, strict=True))


def term(latex, integers="mn", table=TABLE):
    return read_term(latex, table, frozenset(integers))


@pytest.mark.parametrize(
    ("latex", "largest"),
    [
        ("f", 0),
        ("f^{n+7}", 7),
        ("f^n a^{(n+5)}", 5),
        (r"a^{(n-1)} \cdot b^{(n+11)}", 11),
        (r"\sum_{k=3}^{n} f^k", 3),
        (r"\sum_{k=0}^{n+9} f^k", 9),
        (r"\sum_{k+l=4} f^k g^l", 4),
        (r"n f + (n - 6) g", 6),
        (r"C_{n+8}^{2} f", 8),
        (r"\Phi_n", 1),
        (r"\Phi_{n+3}", 3),
        ("f + 12 f^{n+12}", 12),
    ],
)
def test_the_largest_literal_includes_those_of_definitions(latex, largest):
    definitions, table = defined(**{r"\Phi_1": r"\tilde{a}", r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1"})
    assert integer_past_literals([term(latex, table=table)], definitions) == largest + 1
    assert integer_past_literals([term("g"), term(latex, table=table)], definitions) == largest + 1
    for name, last in (("n", 4), ("n", 0)):
        orders = Ranges({name: range(last + 1)}, endless=frozenset(name))
        further = [n for n in (largest, largest + 1) if n > last]
        found = list(values_past_literals([term(latex, table=table)], definitions, orders))
        assert found == [{name: n} for n in further]


def test_a_definition_is_looked_into_all_the_way_down():
    definitions, table = defined(**{"p_2": "f", "h": "f^{3} p_2", "k": "h g^5"})
    for latex, expected in (("k", 6), ("h", 4), ("p_2", 1), ("a^{(2)}", 3)):
        assert integer_past_literals([term(latex, "", table)], definitions) == expected


def test_large_numbers_are_no_places():
    terms = [term("f^{n+13}"), term("f^{n+2}")]
    assert integer_past_literals(terms, FREE) is None and integer_past_literals([], FREE) == 1
    orders = Ranges({"n": range(2)}, endless=frozenset("n"))
    assert list(values_past_literals(terms, FREE, orders)) == [{"n": 2}, {"n": 3}]


def test_only_what_has_no_end_goes_on():
    """The first values of the others stay, and the first values of all are no news."""
    orders = Ranges({"m": range(1, 4), "n": range(2)}, endless=frozenset("n"))
    assert list(values_past_literals([term("f^{n+m+4}")], FREE, orders)) == [
        {"m": 1, "n": 4},
        {"m": 1, "n": 5},
    ]
    both = Ranges({"m": range(2), "n": range(4)}, endless=frozenset("mn"))
    found = [(v["m"], v["n"]) for v in values_past_literals([term("f^{n+m+3}")], FREE, both)]
    assert found == [(0, 4), (3, 0), (3, 4), (4, 0), (4, 4)]
    assert not list(values_past_literals([term("f^{n}")], FREE, both._replace(endless=frozenset())))


def lasts_of(latex, generic, table=TABLE):
    (said,) = read(latex, table, frozenset("ijn"))
    orders = Ranges({name: range(1, 3) for name in generic}, tuple(generic))
    found = ranges_apart(orders, said, [said.left, said.right], FREE)
    assert all(each.orders is orders and (each.generic, each.endless) == ((), frozenset()) for each in found)
    return [dict(each.lasts) for each in found]


def test_how_long_sums_must_be_to_refute():
    assert lasts_of("f^i = g^i", "i") == [{}]
    short = r"\sum_{k=1}^{n} f^k = \sum_{k=1}^{n} g^k"
    assert lasts_of(short, "n") == [{"n": 2}, {"n": 3}]
    assert lasts_of(short, "nij") == [{"n": length} for length in (2, 3, 4, 5)]
    assert lasts_of(short.replace("g^k", "g^{k+6}"), "n") == [{"n": length} for length in range(2, 8)]
    assert lasts_of(short.replace("g^k", "g^{k+13}"), "n") == []
    assert lasts_of(r"\sum_{k=1}^{n} f^k = g", "n") == []
    assert lasts_of(r"f = \sum_{k=1}^{n} g^k", "n") == []
    assert lasts_of(r"\sum_{k=1}^{3} f^k = \sum_{k=1}^{3} g^k", "n") == [{}]


def test_distinct_indices_respect_the_bounds_of_sums():
    orders = Ranges({name: range(1, 3) for name in "ijn"}, tuple("ijn"))
    found = list(Distinct(orders, {"n": 7}).assignments())
    assert found == [{"i": 1, "j": 2, "n": 7}, {"i": 2, "j": 1, "n": 7}]
    found = list(Distinct(orders._replace(generic=tuple("ij")), {}).assignments())
    assert [(v["i"], v["j"], v["n"]) for v in found] == [(1, 2, 1), (1, 2, 2), (2, 1, 1), (2, 1, 2)]


def test_a_proof_by_addends_is_named_in_the_evidence():
    (said,) = read(r"\sum_{k=i}^{n} (f + g)^2 = \sum_{k=i}^{n} (f^2 + 2 f g + g^2)", TABLE, frozenset("in"))
    found = judge_addends(Judge(FREE), said)
    assert (found.outcome, found.scope) == (Outcome.PROVED, "all i, n")
    last = found.evidence[-1]
    assert (last.method, last.outcome) == ("all n at once", "addend by addend, each a free function")
    assert len(found.evidence) > 1
    for wrong in (r"\sum_{k=i}^{n} f = \sum_{k=i}^{n} g", r"f = \sum_{k=i}^{n} g", r"f \neq g"):
        assert judge_addends(Judge(FREE), read(wrong, TABLE, frozenset("in"))[0]) is None
    (both,) = read(r"f = g \Leftrightarrow g = f", TABLE)
    assert judge_addends(Judge(FREE), both) is None
    assert judge_addends(Judge(FREE, second_engine=False), said) is None
