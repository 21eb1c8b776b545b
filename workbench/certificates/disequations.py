"""Certificates of disequations (≠) at an instant of a motion over the real numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from random import Random

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.emission.emitter import Emitter
from workbench.certificates.reading.read_back import expression
from workbench.certificates.theorem import Theorem, equation
from workbench.certificates.values.motion_instances import BASE, Instance, instances, on_polynomials
from workbench.certificates.values.trigonometric import flat, value
from workbench.core.terms import Equivalence, Implication, Relation, Statement
from workbench.language.definitions import Definitions

HEADER = """From Coq Require Import QArith List.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Forms Facts Fraction Context Steps.
From Kin Require Import Smooth Moment Instant.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.
"""


@dataclass
class Unequal(Theorem):
    """The theorem a ≠ b ⇔ c ≠ d at any instant, or ⇒.

    Attributes:
        ratio: The ratio of the differences, or of the first one and the square of the second.
        conclusions: The two equations that are negated.
    """

    word: str = "<->"
    ratio: Fraction = Fraction(1)
    lemma: str = "unequal_scaled"
    swapped: bool = False  # the squared difference comes first

    @property
    def statement(self) -> str:
        emitter = self.emitter
        binders = " ".join(f"({name} : {type_})" for name, type_ in emitter.binders)
        sides = [f"~ equal_at now {_sides(c)}" for c in self.conclusions]
        return "\n  ".join(
            [
                f"Theorem {self.name} (now : instant) {binders} :",
                *emitter.statement,
                f" {self.word} ".join(sides) + ".",
            ]
        )

    @property
    def proof(self) -> str:
        ((left, right),) = self.goals[0]
        known = super().proof.partition("  certify")[0].removeprefix("Proof.\n").strip()
        if self.word == "->":
            way = "proj2" if self.swapped else "proj1"
        else:
            way = "iff_sym" if self.swapped else ""
        ratio = f"({self.ratio.numerator} # {self.ratio.denominator})"
        return (
            "\n  ".join(
                [
                    "Proof.",
                    known,
                    f"refine ({way} (@{self.lemma} now {ratio} _ _ _ _ _ _)).",
                    "{ intros no; discriminate no. }",
                    f"certify known{len(self.emitter.steps)}\n    {left}\n    {right}.",
                ]
            )
            + "\nQed."
        )


def _sides(conclusion: str) -> str:
    return " ".join(expression(side).at(0) for side in conclusion.split(" ≡ "))


def denies(statement: Statement) -> bool:
    """True if the statement concludes a disequation."""
    if isinstance(statement, Equivalence):
        return True
    return isinstance(statement, Implication) and getattr(statement.right, "operator", "=") == "≠"


def unequal(
    name: str, statement: Statement, assume: Sequence[Statement], definitions: Definitions
) -> Unequal:
    """Returns the theorem. Raises NotCertified with the first obstacle."""
    if not isinstance(statement, Equivalence | Implication) or assume:
        raise NotCertified("an inequation to be proved")
    sides = (statement.left, statement.right)
    relations = [side for side in sides if isinstance(side, Relation) and side.operator == "≠"]
    if len(relations) != len(sides):
        raise NotCertified("an equivalence of anything but inequations")
    emitter = Emitter(definitions)
    made = Unequal(name, emitter, word="<->" if isinstance(statement, Equivalence) else "->")
    differences = []
    for relation in relations:
        left, right = emitted_nodes.together((emitter.term(relation.left), emitter.term(relation.right)))
        if left.dual or left.kind == "Tensor":
            raise NotCertified("an inequation of dual quantities or tensors")
        made.conclusions.append(equation(left, right))
        made.relations.append(relation)
        differences.append(emitted_nodes.minus(left, right))
    if emitter.steps or emitter.holes.keys() & set(emitter.introduced):
        raise NotCertified("an inequation with quotients or angles")
    made.swapped = differences[0].kind == "Vector"
    first, second = reversed(differences) if made.swapped else differences
    if first.kind == "Vector":
        raise NotCertified("an equivalence of inequations between vectors")
    if second.kind == "Vector":
        made.lemma, second = "unequal_square", emitted_nodes.dot(second, second)
    made.ratio = _ratio(relations, made.swapped, definitions)
    made.goals.append([(first.deep, f"(Scale {emitted_nodes.number(made.ratio).deep} {second.deep})")])
    return made


def _any(emitter: Emitter) -> Iterator[Instance]:
    """Yields arbitrary polynomial motions, if there are no premises."""
    chance = Random(0)
    for _ in range(0 if emitter.holes else 5):
        sizes = {
            name: len(flat(value(emitted_nodes.zero(n.dual, n.kind).deep, {})))
            for name, n in emitter.places.items()
        }
        given = {
            n: [[Fraction(chance.randint(-3, 3)) for _ in range(4)] for _ in range(k)]
            for n, k in sizes.items()
        }
        yield on_polynomials(emitter, given)


def _ratio(relations: Sequence[Relation], swapped: bool, definitions: Definitions) -> Fraction:
    """Returns the ratio of the differences, on a motion on which the second one is not 0."""
    emitter = Emitter(definitions, BASE)
    sides = [emitted_nodes.together((emitter.term(r.left), emitter.term(r.right))) for r in relations]
    differences = [emitted_nodes.minus(*side).deep for side in sides]
    for motion in chain(instances(emitter), _any(emitter)):
        first, second = (
            [w.at_zero for w in flat(value(d, motion.values))]
            for d in (reversed(differences) if swapped else differences)
        )
        below = second[0] if len(second) == 1 else sum(x * x for x in second)
        if below and first[0]:
            return first[0] / below
    raise NotCertified("inequations whose differences are not proportional")
