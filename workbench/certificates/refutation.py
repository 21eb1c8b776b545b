"""A counterexample as a theorem: not for all smooth motions. The motion is a polynomial in time with the
counterexample's derivatives at t = 0, where the two sides differ."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from workbench.certificates.emitter import Emitter
from workbench.certificates.forms import Certificate, Form
from workbench.certificates.nodes import NotCertified, flag, rational
from workbench.certificates.theorem import Theorem, theorem
from workbench.judge.verdict import Verdict
from workbench.language.construct import derivative
from workbench.language.instances import instantiate
from workbench.language.printer import to_latex
from workbench.language.terms import IllFormed

#: Of a vector on which an operator acts: any that tells two operators apart.
_PROBE = (("1", "2", "-1", "3"), ("2", "-3", "1", "1"), ("3", "1", "2", "-1"))

_HEADER = """From Coq Require Import QArith List.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Forms Facts Smooth Refute.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.
Notation K := smooth_functions.
"""


@dataclass
class Refutation(Theorem):
    """The same statement, denied, for all motions of the real numbers."""

    motions: Mapping[str, str] = field(default_factory=dict)

    @property
    def statement(self) -> str:
        binders = " ".join(f"({name} : {type_})" for name, type_ in self.emitter.binders)
        return "\n  ".join(
            [
                f"Theorem {self.name} : ~ forall {binders},",
                *self.emitter.statement,
                " /\\ ".join(self.conclusions) + ".",
            ]
        )

    @property
    def proof(self) -> str:
        emitter = self.emitter
        ((left, right),) = self.goals[0]
        slots = emitter.slots
        values = [f"motion_of {self.motions[s]} {flag(d)} {k}" for d, k, s in slots if s in self.motions]
        listed = "; ".join(f"({flag(d)}, {k}, {self.motions.get(s, '[]')})" for d, k, s in slots)
        opened = "".join(f"(Let {index} {deep} " for index, deep in emitter.lets)
        closed = ")" * len(emitter.lets)
        return (
            "\n  ".join(
                [
                    "Proof.",
                    "intros claimed.",
                    f"specialize (claimed {' '.join(f'({v})' for v in values)}).",
                    f"revert claimed. refine (@refuted [{listed}] _ _",
                    f"  {opened}{left}{closed}",
                    f"  {opened}{right}{closed} _).",
                    "vm_cast_no_check (@eq_refl bool true).",
                ]
            )
            + "\nQed."
        )


def refutation(form: Form, verdict: Verdict) -> Certificate:
    """Raises NotCertified with the first obstacle."""
    example = verdict.counterexample
    if example is None:
        raise NotCertified("no rational counterexample")
    claim, definitions = form.claim, form.claim.notation.definitions
    for values in claim.instances:
        try:
            statement = instantiate(form.formula.statement, values)
            supposed = [instantiate(s, values) for s in claim.supposed]
        except IllFormed as error:
            raise NotCertified(str(error)) from None
        place = ", ".join(f"{n} = {v}" for n, v in values.items())
        if values and f"for {place}" not in (verdict.reason or ""):
            continue
        made = theorem(form.identifier, statement, supposed, definitions)
        emitter = made.emitter
        if emitter.facts or emitter.steps or len(made.goals) != 1 or len(made.goals[0]) != 1:
            raise NotCertified("a counterexample under suppositions, or of a statement of several parts")
        motions = {name: _motion(emitter, name, example.values) for name, _ in emitter.binders}
        if [text for _, _, text in emitter.slots if text in motions] != list(motions):
            raise NotCertified("a family in a counterexample")
        denied = Refutation(made.name, emitter, made.conclusions, made.goals, made.relations, motions)
        return Certificate(form, (denied,), place or None, _HEADER)
    raise NotCertified("no instance of the counterexample")


def _motion(emitter: Emitter, name: str, values: Mapping[str, tuple[str, ...]]) -> str:
    """The derivatives of each component at t = 0."""
    symbol = emitter.read_back.get(name)
    if symbol is None:
        components = [list(c) for c in _PROBE]
    else:
        given = []
        order = 0
        while (found := values.get(to_latex(derivative(symbol, order) if order else symbol))) is not None:
            given.append(found)
            order += 1
        components = [list(c) for c in zip(*given, strict=True)]
    return (
        "[" + "; ".join("[" + "; ".join(rational(Fraction(c)) for c in row) + "]" for row in components) + "]"
    )
