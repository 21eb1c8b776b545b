"""Rules about sums to a symbolic n: the goals that they require, each with its proof."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from workbench.core.construct import apply, counting, relation, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.names import Name
from workbench.core.terms import BigSum, Relation, Term
from workbench.core.types import Declaration
from workbench.language.goals.goals import All, AllFrom, Atom, Goal, Scope, Variable
from workbench.language.goals.proofs import BinomialInduction, Kernel, Proof, SumCongruence
from workbench.language.reader import read_term
from workbench.prover.goals.sequents import NotShown, Sequent, integers_of
from workbench.prover.goals.substitution import Substitution, at_integer

Asked = Iterator[tuple[Sequent, Proof]]


def pascal(sequent: Sequent, goal: AllFrom, proof: BinomialInduction) -> Asked:
    """Returns the goals for ∀ n ≥ 0 : Gₙ = Σ_{k=0}^{n} C(n, k) F(n−k, k), by induction on n with Pascal's
    rule.

    They are G₀ = F(0, 0), Gₙ₊₁ = L Gₙ, L F(j, k) = F(j+1, k) + F(j, k+1), and L is additive.
    """
    n, scope = goal.integer, sequent.scope
    left, total = _sum_on_the_right(goal)
    if goal.least != 0 or total.lower != Linear(0) or total.upper != Linear.variable(n):
        raise NotShown(f"expected a sum from 0 to {n}, for all {n} from 0 on")
    if not sequent.lasts:
        raise NotShown("a premise at one instant may not be differentiated")
    j, k = "j", "k"
    if n in (j, k):
        raise NotShown(f"{n} is an integer already; take another letter")
    term = read_term(proof.term, scope.table, {*scope.integers, j, k})
    J, K = Linear.variable(j), Linear.variable(k)

    def at(first: Linear | int, second: Linear | int) -> Term:
        return instantiate(term, {j: first, k: second})

    def asked(said: Relation, *integers: str, by: Proof) -> tuple[Sequent, Proof]:
        inner: Goal = Atom(said)
        for integer in integers:
            inner = AllFrom(integer, 0, inner)
        return sequent.of(inner), by

    addend = instantiate(total.body, {n: J + K, total.variables[0]: K})
    yield asked(relation("=", addend, apply("mul", counting("binomial", J + K, K), term)), j, k, by=Kernel())
    yield asked(relation("=", instantiate(left, {n: 0}), at(0, 0)), by=proof.begin)
    step = _Step(proof.step, left, scope)
    following = instantiate(left, {n: Linear.variable(n) + 1})
    yield asked(relation("=", following, step.of(left)), n, by=proof.follow)
    grown = apply("add", at(J + 1, K), at(J, K + 1))
    yield asked(relation("=", step.of(term), grown), j, k, by=proof.grow)
    yield sequent.of(step.is_additive()), Kernel()


class _Step:
    """The operator L, an expression in Y."""

    def __init__(self, latex: str, like: Term, scope: Scope) -> None:
        if any(letter in scope.table for letter in ("Y", "Z")):
            raise NotShown("Y or Z is a symbol already")
        self.variables = tuple(Variable(Declaration(Name(letter), like.type)) for letter in ("Y", "Z"))
        self.scope = scope
        self.image = read_term(latex, scope.with_variables(self.variables[:1]).table, scope.integers)

    def of(self, term: Term) -> Term:
        return Substitution({self.variables[0]: term}, self.scope.definitions).as_written(self.image)

    def is_additive(self) -> Goal:
        one, other = (symbol(variable.declaration) for variable in self.variables)
        both = apply("add", self.of(one), self.of(other))
        return All(self.variables, Atom(relation("=", self.of(apply("add", one, other)), both)))


def termwise(sequent: Sequent, said: Relation, proof: SumCongruence) -> Asked:
    """Returns the goals for Σ_{k=a}^{n+c} f(n, k) = Σ_{k=a}^{n+c} g(n, k).

    They are f(k+j−c, k) = g(k+j−c, k) for all k ≥ a and j ≥ 0 for which the premises hold with n = k+j−c.
    """
    one, other = said.left, said.right
    if not (isinstance(one, BigSum) and isinstance(other, BigSum)):
        raise NotShown("expected one sum on either side")
    if (one.lower, one.upper) != (other.lower, other.upper):
        raise NotShown("expected two sums over the same range")
    if one.lower is None or not one.lower.is_number or int(one.lower) < 0:
        raise NotShown("expected sums that begin with a number")
    if [coefficient for _, coefficient in one.upper.coefficients] != [1]:
        raise NotShown("expected sums to n, or to n plus a number")
    ((n, _),) = one.upper.coefficients
    k, j = proof.letter, "j" if proof.letter != "j" else "l"
    K = Linear.variable(k)
    values = {n: K + Linear.variable(j) - one.upper.constant}
    bodies = [instantiate(s.body, {**values, s.variables[0]: K}) for s in (one, other)]
    goal = AllFrom(k, int(one.lower), AllFrom(j, 0, Atom(relation("=", *bodies))))
    premises = tuple(
        replace(p, goal=at_integer(p.goal, n, values[n])) if n in integers_of(p.goal) else p
        for p in sequent.premises
    )
    yield replace(sequent, goal=goal, premises=premises), proof.then


def _sum_on_the_right(goal: AllFrom) -> tuple[Term, BigSum]:
    """Returns the left side of the equation, and the sum on the right. Raises NotShown."""
    match goal.body:
        case Atom(Relation("=", left, BigSum() as total)):
            return left, total
    raise NotShown("expected one equation with a sum on its right side")
