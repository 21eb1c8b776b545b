"""Steps as lemmas about any differential ring, and about equality at an instant."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import replace

from workbench.certificates.emission.emitted_nodes import KINDS, NotCertified
from workbench.certificates.reading.read_back import expression
from workbench.certificates.theorem import Theorem
from workbench.core.construct import relation, symbol, with_children
from workbench.core.integer_instances import free_integers
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    BigSum,
    Counting,
    Derivative,
    DualUnit,
    Identity,
    Integer,
    Number,
    Relation,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions


def at_an_instant(lemma: Theorem) -> str:
    """Returns the lemma with equality at an instant in its premises and its conclusion."""
    own = lemma.emitter
    binders = " ".join(f"({name} : {type_})" for name, type_ in lemma.binders)
    lines = [_agreeing(line) for line in lemma.lines]
    given = []
    for name, type_ in lemma.binders:
        if type_.startswith("forall "):
            places, said = type_.removeprefix("forall ").split(" : nat, ")
            given.append(f"(fun {places} => {said.split()[0]}_now K agreed _ ({name} {places}))")
            continue
        if name not in own.holes:
            given.append(name)
            continue
        word = ("dual_" if "(d := true)" in type_ else "") + type_.split()[0]
        given.append(f"({word}_now K agreed {'_ _' if 'constant' in word else f'_ {name}'})")
    (said_,) = lemma.conclusions
    return "\n  ".join(
        [
            f"Theorem {lemma.name}_now (K : diff_ring) (agreed : agreement K) {binders} :",
            *lines,
            f"{_agreeing(said_)}.",
            f"Proof. vm_cast_no_check (@{lemma.name} (still agreed) {' '.join(given)}). Qed.\n",
        ]
    )


def _agreeing(line: str) -> str:
    if line.startswith("let "):
        return line
    if line.startswith(("turn ", "reciprocal ")):
        word, _, rest = line.partition(" ")
        return f"@{word} (still agreed) {rest}"
    text, arrow = line.removesuffix(" ->"), " ->" if line.endswith(" ->") else ""
    dual = "(d := true) " if "≡ε" in text else ""
    both = " ".join(expression(side).at(0) for side in re.split(r" (?:≡ε|≡) ", text))
    return f"equal_in agreed {dual}{both}{arrow}"


def only_now(term: Term) -> bool:
    """True if the term has parts that are defined at the instant only."""
    return any(
        isinstance(part, Apply)
        and (
            part.head in ("norm", "reciprocal")
            or (part.head == "div" and not isinstance(part.arguments[1], Number))
            or (
                part.head in ("cos", "sin")
                and part.arguments[0].type.kind == "scalar"
                and isinstance(part.arguments[0], Symbol)
                and part.arguments[0].declaration.constant
            )
        )
        for part in term.walk()
    )


def without_derivatives(
    said_: Sequence[Relation], definitions: Definitions, plain: bool
) -> tuple[list[Relation], dict[Term, Term]]:
    """Returns the equations with a symbol for each derivative, and what these stand for.

    plain: also replaces each symbol by a plain one.
    """
    stand: dict[Term, Term] = {}

    def other(term: Term, declaration: Declaration) -> Term:
        known = next((s for s, t in stand.items() if t == term), None)
        if known is None:
            known = symbol(declaration)
            stand[known] = term
        return known

    def bare(term: Term) -> Term:
        if isinstance(term, TimeOperator):
            raise NotCertified("an operator at an instant")
        if isinstance(term, Derivative) or (plain and _special(term)):
            return other(term, Declaration(Name(f"q_{len(stand) + 1}"), term.type))
        if isinstance(term, Symbol) and term.declaration.constant:
            own = replace(term.declaration, name=Name(f"c_{len(stand) + 1}"))
            return other(term, own.with_flags(constant=False))
        if isinstance(term, Symbol):
            body = definitions.lookup(term)
            new = None if body is None else bare(body)
            return term if new is None or new == body else new
        return with_children(term, bare)

    return [relation(r.operator, bare(r.left), bare(r.right)) for r in said_], stand


def of_letters(image: Term, letters: Collection[Symbol]) -> tuple[Term, dict[Term, Term]]:
    """Returns the term with a symbol for each part without these letters, and what these symbols stand
    for."""
    stand: dict[Term, Term] = {}

    def bare(term: Term) -> Term:
        if term in letters or isinstance(term, Number | Zero | Identity | DualUnit):
            return term
        if term.type.kind in KINDS and not any(part in letters for part in term.walk()):
            known = next((s for s, t in stand.items() if t == term), None)
            known = known or symbol(Declaration(Name(f"q_{len(stand) + 1}"), term.type))
            stand[known] = term
            return known
        return with_children(term, bare)

    return bare(image), stand


def restored(term: Term, stand: dict[Term, Term]) -> Term:
    if term in stand:
        return stand[term]
    if isinstance(term, Apply):
        return replace(term, arguments=tuple(restored(c, stand) for c in term.arguments))
    return with_children(term, lambda child: restored(child, stand))


def _special(term: Term) -> bool:
    """True if the term is more special than any quantity of its kind, or has premises of its own."""
    if isinstance(term, Apply) and term.head in ("cos", "sin", "exp"):
        return True
    if free_integers(term) and term.type.kind in KINDS:
        return isinstance(term, Symbol | BigSum | Counting | Integer)
    own = term.declaration if isinstance(term, Symbol) else None
    return own is not None and (own.rotation or own.unit or own.constant)
