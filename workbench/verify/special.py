"""What a formula holds for that is false in general: a unit vector, a rotation, a constant. A text may say so
in words, and its model leave it out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.judge.kernel.judge import Judge
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.verdict import Outcome
from workbench.language.definitions import Definitions, replaced
from workbench.language.typed.construct import symbol
from workbench.language.typed.integers import Linear
from workbench.language.typed.names import Name
from workbench.language.typed.terms import Definition, Derivative, IllFormed, Relation, Symbol, Term
from workbench.language.typed.types import Declaration
from workbench.papers.model import Claim
from workbench.papers.said import terms_of

#: By kind: the flags of a declaration that say more of a symbol, and what it is then.
_FLAGS = {
    "vector": {"unit": "unit", "constant": "constant"},
    "quaternion": {"unit": "unit"},
    "tensor": {"rotation": "rotation", "symmetric": "symmetric", "constant": "constant"},
}


def special_case(claim: Claim, said: Sequence[Definition], options: Mapping[str, object]) -> str | None:
    """What a symbol of the text's formula must be for it to hold: "a unit n". `said`: definitions that the
    text gives."""
    statement = claim.printed.statement
    if claim.span is None or not isinstance(statement, Relation):
        return None
    for flag, declarations in _candidates(claim, said):
        special = {each.name: replace(each, **{flag: True}) for each in declarations}
        if _holds(claim, special, said, options):
            for name, declaration in special.items():
                if len(special) > 1 and _holds(claim, {name: declaration}, said, options):
                    special = {name: declaration}
                    break
            names = ", ".join(str(name) for name in special)
            return f"a {_FLAGS[declarations[0].type.kind][flag]} {names}"
    return None


def _candidates(claim: Claim, said: Sequence[Definition]) -> Iterator[tuple[str, list[Declaration]]]:
    """A flag, and the free symbols that may have it: tensors may be rotations together, all else singly."""
    statement, known = claim.printed.statement, claim.notation.definitions
    defined = {each.declaration.name for each in (*known, *said)}
    bodies = [term for definition in known for term in definition.body.walk()]
    bodies += [term for supposed in claim.supposed for term in terms_of(supposed)]
    fixed = {term.declaration for term in bodies if isinstance(term, Symbol)}
    terms = [*terms_of(statement), *(term for definition in said for term in definition.body.walk())]
    moving = {term.body for term in terms if isinstance(term, Derivative)}
    is_moving = any(isinstance(term, Derivative) for term in terms)
    symbols = dict.fromkeys(term for term in terms if isinstance(term, Symbol))
    free = [
        each
        for each in symbols
        if each.declaration.name not in defined
        and not (each.declaration in fixed or each.declaration.free)
        and not (each.index or each.arguments or each.type.dual)
    ]
    for kind, flags in _FLAGS.items():
        for flag in flags:
            may = [
                each.declaration
                for each in free
                if each.type.kind == kind
                and not getattr(each.declaration, flag)
                and not each.declaration.rotation
                and not (flag == "constant" and (each in moving or not is_moving))
                and each.declaration.weight in (None, Linear(0))
            ]
            if flag in ("rotation", "symmetric"):
                yield from [(flag, may)] if may else []
            else:
                yield from ((flag, [each]) for each in may)


def _holds(
    claim: Claim,
    special: Mapping[Name, Declaration],
    said: Sequence[Definition],
    options: Mapping[str, object],
) -> bool:
    statement = claim.printed.statement
    with suppress(Unsatisfiable, RecursionError, IllFormed):
        known = [*claim.notation.definitions]
        known += [replace(each, body=_with(each.body, special)) for each in said]
        meant = replace(statement, left=_with(statement.left, special), right=_with(statement.right, special))
        verdict = Judge(Definitions(known), **options).judge(meant, claim.supposed, orders=claim.orders)
        return verdict.outcome is Outcome.PROVED
    return False


def _with(term: Term, special: Mapping[Name, Declaration]) -> Term:
    def given(own: Symbol) -> Term | None:
        declared = special.get(own.declaration.name)
        return None if declared is None else symbol(declared, own.index)

    return replaced(term, given)
