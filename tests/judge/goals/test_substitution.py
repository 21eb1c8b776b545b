"""Terms put in the place of bound letters: in every place of every kind of goal, what makes it sound is asked."""

import pytest

from tests.judge.goals.test_goals import SYMBOLS, outcome, scope
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definitions
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import GoalError
from workbench.language.goals.proofs import Congruence, Instance, Introductions, Kernel
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term
from workbench.prover.goals.sequents import integers_of
from workbench.prover.goals.substitution import Substitution, at_integer, is_constant

#: Goals with a letter c ∈ V₃ at some place, that stands for itself as {}.
PLACES = [
    r"{} = b",
    r"b = {}",
    r"{} = b = a",
    r"b = a = {}",
    r"b = b \wedge a = {}",
    r"\Big( {} = b \Leftrightarrow a = b \Big)",
    r"\Big( a = b \Leftrightarrow b = {} \Big)",
    r"\Big( {} = b \Rightarrow a = b \Big)",
    r"\Big( a = b \Rightarrow {} = b \Big)",
    r"\Big( a = b \Longrightarrow {} = b \Big)",
    r"\Big( \forall e \in V_3 : e \times {} = b \Big)",
    r"\Big( \exists e \in V_3 : e \times {} = b \Big)",
    r"\Big( \exists! e \in V_3 : e \times {} = b \Big)",
    r"\Big( \forall m \geq 1 : F_m {} = b \Big)",
    r"\Big( \forall m < 3 : m {} = b \Big)",
    r"{} \cdot b \geqslant 0",
    r"0 \geqslant {} \cdot b",
    r"{} = b \text{ for } a = b",
    r"a = b \text{ for } {} = b",
    r"{} = b \iff a = b",
    r"b = a \iff b = {}",
    r"\min_{z \in V_3} (z - {})^2 = 0",
    r"\min_{z \in V_3} (z - a)^2 = {} \cdot b",
]


def put(template, letter="c", kind="V_3", **terms):
    """The goal with terms for its letter, which is bound by ∀."""
    where = scope()
    goal = read_goal(rf"\forall {letter} \in {kind} : {template}", where)
    inner = where.with_variables(goal.variables)
    integers = inner
    for name in terms.pop("integers", ()):
        integers = integers.with_integer(name, 0)
    (variable,) = goal.variables
    return Substitution({variable: integers.term(terms[letter])}, where.definitions).goal(goal.body)


@pytest.mark.parametrize("place", PLACES)
def test_a_term_stands_where_the_letter_stood(place):
    where = scope()
    said = rf"a = b \Rightarrow {place}"
    assert put(said.replace("{}", "c"), c="2 s") == read_goal(said.replace("{}", "[2 s]"), where)


@pytest.mark.parametrize("place", PLACES)
def test_a_moving_symbol_is_not_constant_in_claims_for_all_times(place):
    """∀ c : P(c) ⟹ Q(c) says nothing of P(a(t)) at all times."""
    said = place.replace("{}", "c")
    for goal in (rf"{said} \Longrightarrow a = b", rf"a = b \Longrightarrow {said}"):
        with pytest.raises(GoalError, match="constant under a derivative"):
            put(goal, c="a")
        assert put(goal, c="2 s") and put(goal, kind=r"V_3^\mathbb{R}", c="a")
    assert put(rf"a = b \Rightarrow {said.replace('Longr', 'R')}", c="a")


@pytest.mark.parametrize("rate", [r"\frac{d}{dt}[T c]", r"[(\mathbf{D} + T) c]"])
@pytest.mark.parametrize("place", PLACES)
def test_moving_terms_cannot_replace_constants_in_derivatives(place, rate):
    said = r"a = b \Rightarrow " + place.replace("{}", rate)
    with pytest.raises(GoalError, match="constant under a derivative"):
        put(said, c="a")
    assert put(said, c="s") and put(said, kind=r"V_3^\mathbb{R}", c="a")


@pytest.mark.parametrize(
    ("goal", "terms", "why"),
    [
        (r"\forall s \in V_3 : c = s", {"c": "s"}, "s is bound again"),
        (r"\forall s \in V_3 : c = s", {"c": "x"}, "s is bound again"),  # x = a + T s
        (r"\exists e \in V_3 : a = b \Rightarrow \forall s \in V_3 : e = c", {"c": "x"}, "s is bound again"),
        (r"\forall c \in V_3 : c = b", {"c": "2 s"}, "c is bound again"),
        (r"\min_{c \in V_3} (s - c)^2 = 0", {"c": "2 s"}, "c varies where a term with it"),
        (r"\forall n \geq 1 : c = F_n b", {"c": "F_n a", "integers": ("n",)}, "n is bound again"),
        (r"\forall n < 3 : c = n b", {"c": "n a", "integers": ("n",)}, "n is bound again"),
        (r"\sum_{n=1}^{3} F_n c = b", {"c": "F_n a", "integers": ("n",)}, "n is summed over"),
        (r"\min_{s \in V_3} (s - c)^2 = 0", {"c": "s"}, "s varies where a term with it"),
        (r"\min_{s \in V_3} (s - c)^2 = 0", {"c": "x"}, "s varies where a term with it"),
    ],
)
def test_no_letter_of_a_term_is_bound_by_the_goal(goal, terms, why):
    with pytest.raises(GoalError, match=why):
        put(goal, **terms)


@pytest.mark.parametrize("place", PLACES)
def test_a_letter_of_a_premise_is_not_any_member_of_its_set(place):
    premise = place.replace("{}", "c")
    found = outcome(
        rf"\forall c \in V_3 : {premise} \Rightarrow \forall c \in V_3 : c = b", Introductions(Kernel())
    )
    assert found.outcome == Outcome.UNCHECKED and "c stands in a premise already" in found.reason


def test_letters_bound_by_a_premise_are_arbitrary():
    goal = r"\Big( \forall c \in V_3 : c = a \Big) \Rightarrow \forall c \in V_3 : c = a"
    assert outcome(goal, Introductions(Congruence("Y", Y=Instance(0, {"c": "c"})))).outcome == Outcome.PROVED


def test_definitions_that_use_a_letter_are_expanded():
    assert put("x = b", letter="s", s="3 s") == read_goal("a + T [3 s] = b", scope())
    assert put("x = b", letter="e", e="3 s") == read_goal("x = b", scope())


@pytest.mark.parametrize("place", PLACES)
def test_an_integer_stands_where_its_letter_stood(place):
    where = scope().with_integer("n", 1)
    of_n, of_4 = (read_goal("a = b ; " + place.replace("{}", f"F_{n} a"), where) for n in ("n", "4"))
    assert at_integer(of_n, "n", 4) == of_4 != of_n


@pytest.mark.parametrize(
    ("goal", "integers"),
    [
        ("F_n = F_m", {"m", "n"}),
        (r"n \geqslant 0", {"n"}),
        (r"0 \geqslant n", {"n"}),
        (r"\forall k \geq 1 : F_k = F_n", {"n"}),
        (r"\forall k < n : k a = m b", {"m", "n"}),
        (r"\forall k < n : k a = b \Rightarrow a = b", {"n"}),
        (r"F_n = T \Leftrightarrow \Big( F_m = T ; a = b \Big)", {"m", "n"}),
    ],
)
def test_the_integers_of_a_goal(goal, integers):
    where = scope().with_integer("n", 1).with_integer("m", 1)
    read = read_goal(goal, where)
    assert integers_of(read) == integers
    assert integers_of(at_integer(read, "n", 2)) == integers - {"n"}
    assert integers_of(at_integer(read, "m", as_linear(1))) == integers - {"m"}


def test_no_integer_is_bound_by_what_it_was_not_meant_for():
    where = scope().with_integer("n", 1)
    goal = read_goal(r"\forall k \geq 1 : F_k = F_n", where)
    for name, value in (("k", 2), ("n", Linear.variable("k")), ("n", Linear.variable("k") + 1)):
        with pytest.raises(GoalError, match="k is bound twice"):
            at_integer(goal, name, value)


@pytest.mark.parametrize(
    ("latex", "constant"), [("m", True), ("M_3", True), ("q(s)", True), ("w", False), ("q(a)", False)]
)
def test_symbols_defined_by_constants_are_constant(latex, constant):
    defined = {"m": "2 s", "w": "a + s", "M_0": "s", "M_{n+1}": "2 M_n", "q(z)": "2 z"}
    definitions, table = read_definitions(defined, SymbolTable.build({**SYMBOLS, "z": {"kind": "vector"}}))
    assert is_constant(read_term(latex, table, {}), definitions) == constant
