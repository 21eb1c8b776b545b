"""A statement as a Coq theorem, with its proof."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from workbench.certificates.emission import (
    blocks,
    emitted_functions,
    emitted_nodes,
    emitted_operators,
    emitted_sums,
)
from workbench.certificates.emission.collector import Summed
from workbench.certificates.emission.emitted_families import general
from workbench.certificates.emission.emitted_nodes import (
    ATOM,
    KINDS,
    Node,
    NotCertified,
    OneInstant,
    flag,
    single,
)
from workbench.certificates.emission.emitter import Emitter
from workbench.certificates.reading.compare import faults_of
from workbench.certificates.values.trial import can_be_certified
from workbench.core.construct import relation as make_relation
from workbench.core.integer_expressions import Linear
from workbench.core.statement_parts import conjuncts
from workbench.core.terms import (
    Apply,
    Conjunction,
    Derivative,
    Extremum,
    Implication,
    Naming,
    Relation,
    Statement,
    Symbol,
    Term,
)
from workbench.core.types import SCALAR
from workbench.language.definitions import Definitions, expand
from workbench.language.goals.goals import Scope
from workbench.prover.goals.sequents import relations_of

HEADER = """From Coq Require Import QArith List.
From Kin Require Import Kin Poly Terms Certify Modulo Symbols Forms Facts Fraction Context Steps.
Import ListNotations.
Open Scope Q_scope. Open Scope kin_scope.
"""


@dataclass
class Theorem:
    """A statement in Coq, and the goals of its proof: pairs of deep copies."""

    name: str
    emitter: Emitter
    conclusions: list[str] = field(default_factory=list)
    goals: list[list[tuple[str, str]]] = field(default_factory=list)
    relations: list[Relation] = field(default_factory=list)  # what the conclusions say
    source: tuple[Statement, Sequence[Statement], Sequence[str]] | None = (
        None  # statement, premises, integers
    )
    stands: dict[str, Linear] = field(default_factory=dict)  # integer of the statement → its value

    def read_back_faults(self) -> list[str]:
        """Returns where the text, read back, differs from the terms, or does not reproduce the text."""
        return faults_of(self.emitter, self.conclusions, self.relations, self._supposed())

    def _supposed(self) -> list[Relation]:
        statement, assume, _ = self.source or (None, (), ())
        premises = [r for s in assume for r in relations(s)]
        while isinstance(statement, Implication):
            premises += relations(statement.left)
            statement = statement.right
        return premises

    @property
    def binders(self) -> list[tuple[str, str]]:
        own = self.emitter
        integers = [f"{name}_less_1" if v in own.positive else name for v, name in own.integers.items()]
        return [*((name, "nat") for name in integers), *own.binders]

    @property
    def lines(self) -> list[str]:
        """Returns the definitions and premises before the conclusion."""
        own = self.emitter
        above_0 = [f"let {n} := S {n}_less_1 in" for v, n in own.integers.items() if v in own.positive]
        return [*above_0, *own.statement]

    @property
    def statement(self) -> str:
        binders = [f"({name} : {type_})" for name, type_ in self.binders]
        head = " ".join([f"Theorem {self.name} (K : diff_ring)", *binders])
        return "\n  ".join([f"{head} :", *self.lines, " /\\ ".join(self.conclusions) + "."])

    @property
    def proof(self) -> str:
        emitter = self.emitter
        introduced = list(emitter.introduced)
        introduced = [*(n for v, n in emitter.integers.items() if v in emitter.positive), *introduced]
        lines = [f"intros {' '.join(introduced)}."] if introduced else []
        lines += emitter.lemmas
        slots = emitter.slots or [(False, "Scalar", "(num 0 : scalar K)")]
        shapes = "; ".join(f"({flag(dual)}, {kind})" for dual, kind, _ in slots)
        values = "; ".join(
            f"as_slot {flag(dual)} {kind} {text if text.isidentifier() or text[0] == '(' else f'({text})'}"
            for dual, kind, text in slots
        )
        premises = [*emitter.facts, *emitter.values]
        proofs = (
            "".join(f"(joined {proof}\n    " for proof in premises) + "(Forall_nil _)" + ")" * len(premises)
        )
        lines.append(f"pose (these := [{values}] : list (slot K)).")
        lines.append("pose (here := envK 0 these).")
        lines.append(f"pose (known0 := @premised K [{shapes}] these eq_refl eq_refl _\n    {proofs}).")
        lines += emitter.steps
        by = f"certify known{len(emitter.steps)}"
        if premises and not emitter.steps:
            lines.append(f"pose (free := @premised K [{shapes}] these eq_refl eq_refl [] (Forall_nil _)).")
            by = "certify_by free known0"
        for index, goals in enumerate(self.goals):
            parts = [f"{by}\n    {left}\n    {right}" for left, right in goals]
            if index < len(self.goals) - 1:
                lines.append("split.")
                lines.append("{ " + _proof_of(parts) + " }")
            else:
                lines.append(_proof_of(parts))
        return "\n  ".join(["Proof.", *lines]) + "\nQed."

    @property
    def text(self) -> str:
        return "".join([*self.emitter.before.values(), f"{self.statement}\n{self.proof}\n"])


class _Emitter(Emitter):
    """An emitter that can write preceding theorems."""

    def shows(self, terms: Sequence[Term], value: Term) -> str:
        said = Conjunction(tuple(make_relation("=", term, value) for term in terms))
        name = f"before_{len(self.before) + 1}"
        lemma = theorem(name, said, (), self.definitions)
        arguments = []
        for own, type_ in lemma.emitter.binders:
            what, _, of = type_.rpartition(" ")
            if own in lemma.emitter.holes:
                of = self.symbol(lemma.emitter.symbol_named(of)).text
                own = next(name for name, said_ in self.binders if said_ == f"{what} {of}")
            else:
                own = self.symbol(lemma.emitter.symbol_named(own)).at(ATOM)
            arguments.append(own)
        self.before[name] = lemma.text
        return f"({' '.join([name, 'K', *arguments])})"


def theorem(
    name: str,
    statement: Statement,
    assume: Sequence[Statement],
    definitions: Definitions,
    integers: Sequence[str] = (),
    slots: Sequence[tuple[bool, str, str]] = (),
    several: bool = False,
    lasting: bool = False,
) -> Theorem:
    """Returns the theorem of a statement. Raises NotCertified with the first obstacle.

    slots: symbols before those of the statement.
    several: accepts families of several indices, whose existence is not shown.
    lasting: the assumptions hold at all times.
    """
    for expands in (False, True):
        cores: Sequence[Summed] = ()
        while True:  # repeated with the common parts of sums, if there are any
            emitter = _Emitter(definitions, slots)
            emitter.several, emitter.expands, emitter.cores = several, expands, cores
            made = _written(emitter, name, statement, assume, integers, lasting)
            if cores or not emitter.met:
                break
            cores = emitted_sums.cores_of(emitter.met)
        if can_be_certified(made):
            break
    return made


def theorem_for_all(
    name: str, statement: Statement, assume: Sequence[Statement], scope: Scope, lasting: bool = False
) -> Theorem:
    """Returns the theorem for all values of the scope's integers that it contains."""
    stands: dict[str, Linear] = {}
    if scope.integers:
        try:
            statement, assume, stands = general(statement, assume)
        except NotCertified as obstacle:
            if str(obstacle) != "no integer variable":
                raise
    made = theorem(name, statement, assume, scope.definitions, list(stands), (), True, lasting)
    made.stands = stands
    return made


def _written(
    emitter: Emitter,
    name: str,
    statement: Statement,
    assume: Sequence[Statement],
    integers: Sequence[str],
    lasting: bool,
) -> Theorem:
    definitions = emitter.definitions
    emitter.differentiated = emitted_sums.differentiated(statement)
    for variable in integers:
        emitter.integers[variable] = emitter.fresh(variable)
    made = Theorem(name, emitter, source=(statement, assume, integers))
    premises = [r for s in assume for r in relations(s)]
    for premise in premises:
        if premise.operator == "=" and not lasting and _at_an_instant(premise, statement, definitions):
            raise OneInstant("an assumption that holds at one instant only")
    norms_first(emitter, [s for r in (*premises, *relations_of(statement)) for s in (r.left, r.right)])
    while isinstance(statement, Implication):
        premises += relations(statement.left)
        statement = statement.right
    for premise in premises:
        if premise.operator == "=":
            _suppose(emitter, premise)
    for relation in relations(statement):
        if relation.operator != "=":
            kind = "an inequation" if relation.operator == "≠" else "an approximation"
            raise NotCertified(f"{kind} to be proved")
        _conclude(made, relation)
    return made


def relations(statement: Statement) -> Iterator[Relation]:
    """Yields the equations and disequations of a statement. Raises NotCertified for another part of it."""
    for part in conjuncts(statement):
        if not isinstance(part, Relation) or part.operator not in ("=", "≠"):
            own = {Relation: "an approximation", Extremum: "a minimum or maximum", Naming: "a set or a map"}
            raise NotCertified(own.get(type(part), f"an {type(part).__name__.lower()}"))
        yield part


def norms_first(emitter: Emitter, terms: Sequence[Term]) -> None:
    """Emits the norms first, because their rules must precede quotients."""
    for part in (p for term in terms for p in term.walk()):
        if isinstance(part, Apply) and part.head == "norm" and part.arguments[0].type.kind == "vector":
            real = Apply(SCALAR, None, "norm", (emitted_functions.part("re", part.arguments[0]),))
            emitter.term(real if part.type.dual else part)


def _proof_of(parts: list[str]) -> str:
    """Returns the proof of an equation, or of a matrix equation entry by entry."""
    if len(parts) == 1:
        return f"{parts[0]}."
    return "apart.\n  " + "\n  ".join(f"* {part}." for part in parts)


def _conclude(made: Theorem, relation: Relation) -> None:
    emitter, left, right = made.emitter, relation.left, relation.right
    made.relations.append(relation)
    kinds = {left.type.kind, right.type.kind}
    if any(blocks.made_of_blocks(side, emitter.definitions) for side in (left, right)):
        a, b = blocks.matrix(emitter, left), blocks.matrix(emitter, right)
        made.conclusions.append(f"matrix_equal {len(a.entries)} {a.columns} {a.at(ATOM)} {b.at(ATOM)}")
        made.goals.append(
            [(x, y) for r, s in zip(a.entries, b.entries, strict=True) for x, y in zip(r, s, strict=True)]
        )
        return
    if "operator" in kinds:
        dual = left.type.dual or right.type.dual
        value = emitter.variable(dual, "Vector", emitter.fresh("x"))
        first = emitted_operators.operator(emitter, left, dual, "Vector")(value)
        second = emitted_operators.operator(emitter, right, dual, "Vector")(value)
    else:
        if not kinds <= set(KINDS):
            raise NotCertified(emitted_nodes.named(min(kinds - set(KINDS))))
        first, second = emitted_nodes.together((emitter.term(left), emitter.term(right)))
        if not emitter.binders:  # nothing else determines the ring of the numbers
            first = replace(first, text=f"({first.text} : {first.type})", level=ATOM)
    made.conclusions.append(equation(first, second))
    made.goals.append([(first.deep, second.deep)])


def equation(left: Node, right: Node) -> str:
    left, right = emitted_nodes.together((left, right))
    return f"{left.at(69)} {'≡ε' if left.dual else '≡'} {right.at(69)}"


def _suppose(emitter: Emitter, premise: Relation) -> None:
    """Adds the premise, and the value that it gives to one of its symbols."""
    pivot = _pivot(premise)
    if pivot is not None:
        emitter.pivots[pivot[0]] = True
    left, right = emitted_nodes.together((emitter.term(premise.left), emitter.term(premise.right)))
    known = emitter.suppose(equation(left, right), "premise", [(left.deep, right.deep)])
    if pivot is None:
        place = f"{left.deep} {right.deep}"
        emitter.values.append(single(f"Rule {place}", known))
        return
    symbol, rest, proof = pivot
    if len(rest) == 1:
        emitter.premised[symbol] = rest[0], f"({proof} {known})"
    value = emitter.term(rest[0])
    for other in rest[1:]:
        value = emitted_nodes.minus(value, emitter.term(other))
    value = emitted_nodes.embedded(value, value.dual or symbol.type.dual)
    free = emitter.definitions.lookup(symbol) is None
    emitter.stands_for(emitter.symbol(symbol), value, f"({proof} {known})", by_definition=free)


def _pivot(premise: Relation) -> tuple[Symbol, list[Term], str] | None:
    """Returns a symbol that the premise is solved for, its value (a difference), and the lemma."""
    left, right = premise.left, premise.right
    for side, other, proof in ((left, right, "as_given"), (right, left, "turned")):
        if isinstance(side, Symbol) and _may_stand(side, other):
            return side, [other], proof
    match left:
        case Apply(head="add", arguments=(Symbol() as symbol, rest)):
            if _may_stand(symbol, rest) and not _occurs(symbol, right):
                return symbol, [right, rest], "carried"
    return None


def _may_stand(symbol: Symbol, other: Term) -> bool:
    d = symbol.declaration
    return (
        not (d.rotation or d.unit or d.constant) and not _occurs(symbol, other) and symbol.type.kind in KINDS
    )


def _occurs(symbol: Symbol, term: Term) -> bool:
    return any(part == symbol for part in term.walk())


def _at_an_instant(premise: Relation, statement: Statement, definitions: Definitions) -> bool:
    """True if the statement differentiates a symbol whose value the premise gives."""
    sides = [premise.left, premise.right]
    sides += [
        part for side in sides if isinstance(side, Apply) and side.head == "add" for part in side.arguments
    ]
    given = [side for side in sides if isinstance(side, Symbol)]
    full = [expand(side, definitions) for r in relations(statement) for side in (r.left, r.right)]
    return any(
        isinstance(part, Derivative) and any(_occurs(symbol, part.body) for symbol in given)
        for term in full
        for part in term.walk()
    )
