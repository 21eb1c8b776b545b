"""Theorems that deny: a false statement fails on a motion, and the premises of a theorem hold on a motion.

The latter shows that the theorem is not vacuous.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction

from workbench.certificates.certified_forms import Certificate, Form
from workbench.certificates.emission.collector import Origin
from workbench.certificates.emission.emitted_nodes import ATOM, Node, NotCertified, flag, single
from workbench.certificates.emission.emitter import Emitter
from workbench.certificates.theorem import Theorem, theorem
from workbench.certificates.values.motion_instances import (
    BASE,
    Instance,
    Quotient,
    instances,
    latest,
    on_polynomials,
    place,
)
from workbench.certificates.values.trigonometric import order, parsed
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import derivative
from workbench.core.integer_instances import instantiate
from workbench.core.reasons import Reason
from workbench.core.terms import Conjunction, IllFormed, Naming
from workbench.core.verdict import Verdict
from workbench.language.printing.printer import to_latex

#: The components of a vector that distinguishes any two operators.
_PROBE = (("1", "2", "-1", "3"), ("2", "-3", "1", "1"), ("3", "1", "2", "-1"))

#: The n at which premises for every n are tried.
_NUMBERS = (2, 3, 4)

HEADER = """From Coq Require Import QArith List.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Forms Facts Fraction Context Steps.
From Kin Require Import Smooth Time Refute Witness.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.
Notation K := smooth_functions.
"""

#: Codes of a statement that fails for some values of its integers.
_OF_AN_INSTANCE = (VerdictCode.FOR, VerdictCode.FOR_BECAUSE, VerdictCode.FOR_THOUGH_HOLDS)


@dataclass
class Denied:
    """`~ forall …`: the negation of the claim that premises contradict each other, or imply the conclusion.

    Attributes:
        conclusions: Empty if the premises are claimed to contradict each other.
        made: The statement that the motion is an instance of.
    """

    name: str
    emitter: Emitter
    conclusions: list[str]
    made: Theorem
    instance: Instance
    last: str  # the rest of the proof
    numbers: Mapping[str, int] = field(default_factory=dict)  # values of integer variables

    @property
    def statement(self) -> str:
        binders = [f"({name} : nat)" for name in self.numbers]
        binders += [f"({name} : {type_})" for name, type_ in self.emitter.binders]
        return "\n  ".join(
            [
                f"Theorem {self.name} : ~ forall {' '.join(binders)},",
                *self._lines(),
                (" /\\ ".join(self.conclusions) or "False") + ".",
            ]
        )

    def read_back_faults(self) -> list[str]:
        """Returns where the denied statement, read back, differs from the terms."""
        return self.made.read_back_faults()

    def _lines(self) -> list[str]:
        shifted = [n for n in self.numbers if n.endswith("_less_1")]
        return [*(f"let {n.removesuffix('_less_1')} := S {n} in" for n in shifted), *self.emitter.statement]

    @property
    def proof(self) -> str:
        emitter = self.made.emitter
        slots = emitter.slots[len(BASE) :]
        more = "; ".join(f"as_slot {flag(d)} {k} {_inside(text)}" for d, k, text in slots)
        shapes = "; ".join(f"({flag(d)}, {k})" for d, k, _ in emitter.slots)
        facts = ["(time_at_ok more)"]
        for node, deep in self._known():
            value = f"@Value {' '.join(place(node))} {deep}"
            facts.append(
                single(
                    value,
                    f"(alike (K := K) (d := {flag(node.dual)}) (k := {node.kind}) {_inside(node.text)})",
                )
            )
        joined = "".join(f"(joined {fact}\n    " for fact in facts) + "(Forall_nil _)" + ")" * len(facts)
        lines = [
            "intros claimed.",
            *self._posed(),
            f"pose (more := [{more}] : list (slot K)).",
            "pose (these := (time_slots ++ more)%list).",
            "pose (here := envK 0 these).",
            f"pose (facts := {joined}).",
        ]
        if emitter.holes:
            lines.append(f"pose (known0 := @premised K [{shapes}] these eq_refl eq_refl _ facts).")
            lines += self._steps()
            lines += [
                f"assert ({name} : {text}). {self._shown(name, text)}" for name, text in self._suppositions()
            ]
        return "\n  ".join(["Proof.", *lines, self.last]) + "\nQed."

    def _known(self) -> Iterator[tuple[Node, str]]:
        """Yields the slots with values that are known before reciprocals and inverses."""
        late = [origin for origin, _ in self._late()]
        for origin in latest(self.made.emitter):
            if origin not in late:
                yield origin.node, self._meaning(origin)

    def _late(self) -> list[tuple[Origin, str]]:
        """Returns reciprocals and inverses, and everything defined after the first of them."""
        origins = latest(self.made.emitter)
        first = next((i for i, o in enumerate(origins) if o.how in ("over", "inverse")), len(origins))
        return [(o, self._meaning(o)) for o in origins[first:] if o.how in ("over", "inverse", "is")]

    def _steps(self) -> list[str]:
        """Returns the proof steps that introduce these, with their divisors."""
        lines, count = [], 0
        for origin, deep in self._late():
            if (one := self.instance.quotients.get(origin)) is not None:
                below = one.below
                computed = f"certify known{count}\n    {below.deep} {one.quadratic}."
                shown = f"apply over_quadratic; [reflexivity |]. {computed}"
                lines.append(
                    f"assert (is_{one.place} : reciprocal {below.at(ATOM)} ({one.text})). {{ {shown} }}"
                )
                made = f"with_reciprocal known{count} {one.place} {below.deep} is_{one.place}"
                lines.append(f"pose (known{(count := count + 1)} := {made}).")
            value = f"{' '.join(place(origin.node))} {deep} (alike {_inside(origin.node.text)})"
            lines.append(f"pose (known{count + 1} := given known{count} {value}).")
            count += 1
        return lines

    @property
    def opened(self) -> tuple[str, str, list[tuple[Quotient, str]]]:
        """Returns the opening and closing of a deep copy that contains these, and the divisors opened
        likewise."""
        opened, quotients = "", []
        for place_, (origin, deep) in enumerate(self._late()):
            if (one := self.instance.quotients.get(origin)) is not None:
                quotients.append((one, f"{opened}{one.below.deep}{')' * place_}"))
            opened += f"(Let {place(origin.node)[2]} {deep} "
        return opened, ")" * len(self._late()), quotients

    def _meaning(self, origin: Origin) -> str:
        known = self.instance.variables.get(origin)
        return known[1] if known else origin.meaning.deep

    def _posed(self) -> Iterator[str]:
        """Yields the variables and the definitions in order of dependence."""
        emitter = self.made.emitter
        said = 0
        for origin, (text, _) in self.instance.variables.items():
            yield from map(self._as_pose, emitter.statement[said : origin.after])
            said = max(said, origin.after)
            yield f"pose ({origin.node.text} := {text} : {origin.node.type})."
        yield from map(self._as_pose, emitter.statement[said:])

    def _as_pose(self, line: str) -> str:
        """Returns a definition of the statement as a line of a proof."""
        found = re.fullmatch(r"let (\S+)(?: : ([^:=]+))? := (.*) in", line, re.DOTALL)
        if found is None:
            solved, _ = self.made.emitter.solved.get(line.removesuffix(" ->"), ("", ""))
            return f"pose ({line.split()[-2]} := {solved})." if solved else "(* a premise *)"
        type_ = f" : {found[2]}" if found[2] else ""
        return f"pose ({found[1]} := {found[3]}{type_})."

    def _suppositions(self) -> Iterator[tuple[str, str]]:
        emitter = self.made.emitter
        yield from ((name, text) for name, text in emitter.binders if name in emitter.holes)
        yield from emitter.premises

    def _shown(self, name: str, text: str) -> str:
        if text in self.made.emitter.solved:
            return f"{{ exact {self.made.emitter.solved[text][1]}. }}"
        known = f"known{len(self._late()) + len(self.instance.quotients)}"
        parts = [f"certify {known}\n    {a}\n    {b}" for a, b in self.made.emitter.holes[name]]
        split = "".join(f"refine (conj _ _); [{part} |]. " for part in parts[:-1])
        return f"{{ {split}{parts[-1]}. }}"

    @property
    def use(self) -> str:
        """The denied statement, applied to this motion."""
        own = self.made.emitter
        numbers = [f"{v - 1 if n.endswith('_less_1') else v}%nat" for n, v in self.numbers.items()]
        given = [
            f"(fun _ => {mine})" if type_.startswith("nat -> ") else mine
            for (_, type_), (mine, _) in zip(self.emitter.binders, own.binders, strict=True)
        ]
        premises = [n for n in own.introduced if n in own.holes]
        return " ".join(["claimed", *numbers, *given, *premises])

    @property
    def text(self) -> str:
        return "".join([*self.made.emitter.before.values(), f"{self.statement}\n{self.proof}\n"])


def _inside(text: str) -> str:
    return text if text.isidentifier() or text[0] == "(" else f"({text})"


def _fails_for(verdict: Verdict) -> set[str]:
    """Returns the values of the integers for which the verdict says that the statement fails."""
    parts = verdict.reason.parts() if isinstance(verdict.reason, Reason) else ()
    return {part.arguments["values"] for part in parts if part.code in _OF_AN_INSTANCE}


def refutation(form: Form, verdict: Verdict) -> Certificate:
    """Returns the certificate. Raises NotCertified with the first obstacle."""
    example = verdict.counterexample
    if example is None:
        raise NotCertified("no rational counterexample")
    claim, definitions = form.claim, form.claim.notation.definitions
    for values in claim.instances:
        place_ = ", ".join(f"{n} = {v}" for n, v in values.items())
        if values and place_ not in _fails_for(verdict):
            continue
        try:
            statement = instantiate(form.statement, values)
            supposed = [instantiate(s, values) for s in claim.supposed]
            if isinstance(statement, Naming) and len(statement.parts) > 1 and not statement.given:
                statement = Conjunction(statement.parts)  # the parts that a membership asserts
        except IllFormed as error:
            raise NotCertified(str(error)) from None
        made = theorem(form.identifier, statement, supposed, definitions, slots=BASE)
        if any(len(goals) != 1 for goals in made.goals):
            raise NotCertified("a counterexample to an equation of matrices")
        return Certificate(form, (_fails(made, example.values),), place_ or None, HEADER)
    raise NotCertified("no instance of the counterexample")


def _fails(made: Theorem, given: Mapping[str, tuple[str, ...]]) -> Denied:
    """Returns the theorem by the judge's counterexample, or by a motion on which the premises hold."""
    emitter = made.emitter
    if emitter.holes:
        tried = instances(emitter)
    else:
        tried = iter([on_polynomials(emitter, {n: _motion(emitter, n, given) for n in emitter.places})])
    for instance in tried:
        for part, ((left, right),) in enumerate(made.goals):
            if not instance.agree_at_zero(left, right):
                denied = Denied(made.name, emitter, made.conclusions, made, instance, "")
                denied.last = _contradicted(denied, part, left, right)
                return denied
    raise NotCertified("a counterexample under suppositions")


def not_empty(of: Certificate) -> Certificate | None:
    """Returns the certificate that the premises of its theorems can be met; None if they have none.

    Raises:
        NotCertified: No motion was found.
    """
    shown = {}
    for each in of.theorems:
        if isinstance(each, Theorem) and each.emitter.holes:
            met = (
                _met(each) if any(line.endswith("->") for line in each.emitter.statement) else _declared(each)
            )
            shown[met.text] = met
    return (
        Certificate(None, tuple(shown.values()), of.scope, HEADER, title="premises are met")
        if shown
        else None
    )


def _declared(of: Theorem) -> Denied:
    """Returns the theorem for premises that only make symbols rotations, units or constants.

    It is about these symbols alone, so that many theorems share it.
    """
    emitter = Emitter(of.emitter.definitions, BASE)
    for name, type_ in of.emitter.binders:
        if name in of.emitter.holes:
            emitter.symbol(of.emitter.symbol_named(type_.split()[-1]))
    return _instance("premises", emitter, Theorem("premises", emitter), {})


def _met(of: Theorem) -> Denied:
    assert of.source is not None, f"{of.name} is written of no statement"
    statement, assume, integers = of.source
    for number in _NUMBERS if integers else (0,):
        values = dict.fromkeys(integers, number)
        said = [instantiate(s, values) if values else s for s in (statement, *assume)]
        made = theorem(of.name, said[0], said[1:], of.emitter.definitions, slots=BASE)
        own = of.emitter
        numbers = {own.integers[v] + "_less_1" * (v in own.positive): n for v, n in values.items()}
        if _types(of) != _types(made):
            raise NotCertified("no motion for premises about every n")
        with suppress(NotCertified):
            return _instance(f"{of.name}_not_empty", of.emitter, made, numbers)
    raise NotCertified("no motion was found that meets the premises")


def _types(of: Theorem) -> list[str]:
    return [t.removeprefix("nat -> ") for _, t in of.emitter.binders if t.endswith(" K")]


def _instance(name: str, emitter: Emitter, made: Theorem, numbers: Mapping[str, int]) -> Denied:
    for instance in instances(made.emitter):
        denied = Denied(name, emitter, [], made, instance, "", numbers)
        denied.last = f"exact ({denied.use})."
        return denied
    raise NotCertified("no motion was found that meets the premises")


def _contradicted(denied: Denied, part: int, left: str, right: str) -> str:
    """Returns the proof that the conclusion, or a part of it, is false at t = 0."""
    orders: dict[tuple[str, str, str], int] = {}
    opened, closed, quotients = denied.opened
    for one, _ in quotients:
        orders["false", "Scalar", one.place] = 0
    for node, deep in [*denied._known(), *((o.node, deep) for o, deep in denied._late())]:
        orders[place(node)] = order(parsed(deep), orders)
    known = max(order(parsed(side), orders) for side in (left, right)) + 1
    divided = "; ".join(f"({q.place}%nat, {below}, {q.text})" for q, below in quotients)
    such = (
        "".join(f"(conj is_{q.place} " for q, _ in quotients) + "I" + ")" * len(quotients) + " "
        if quotients
        else ""
    )
    lemma = f"@refuted_over {known} here _ [{divided}]" if quotients else f"@refuted {known} here _"
    said = " /\\ ".join(denied.conclusions)
    taken = ["apply proj2 in found."] * part
    if part < len(denied.conclusions) - 1:
        taken.append("apply proj1 in found.")
    return "\n  ".join(
        [
            f"assert (found : {said}) by exact ({denied.use}).",
            *taken,
            f"revert found. refine ({lemma} _ _",
            f"    {opened}{left}{closed}",
            f"    {opened}{right}{closed} eq_refl eq_refl eq_refl facts {such}_).",
            "vm_cast_no_check (@eq_refl bool true).",
        ]
    )


def _motion(emitter: Emitter, name: str, values: Mapping[str, tuple[str, ...]]) -> list[list[Fraction]]:
    """Returns the derivatives of each component at t = 0."""
    symbol = emitter.read_back.get(name)
    if symbol is None:
        return [[Fraction(x) for x in component] for component in _PROBE]
    given: list[tuple[str, ...]] = []
    while (found := values.get(to_latex(derivative(symbol, len(given)) if given else symbol))) is not None:
        given.append(found)
    return [[Fraction(x) for x in component] for component in zip(*given, strict=True)]
