"""What a formula holds for that is false in general: a unit vector, a rotation, a constant. A text may say so
in words, and its model leave it out. Or vectors that are quaternions without a scalar part: u² = −1."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.judge.kernel.families import mapped
from workbench.judge.kernel.judge import Judge
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.subject.inventory import NotExact
from workbench.judge.verdict import EngineDisagreement, Outcome
from workbench.language.definitions import Definitions, replaced
from workbench.language.printing.printer import to_latex
from workbench.language.typed.construct import apply, identity, number, rebuild, relation, symbol
from workbench.language.typed.integers import Linear
from workbench.language.typed.names import Name
from workbench.language.typed.operators import CIRCULAR
from workbench.language.typed.terms import (
    Apply,
    Definition,
    Derivative,
    IllFormed,
    Power,
    Relation,
    Symbol,
    Term,
)
from workbench.language.typed.types import Declaration
from workbench.papers.model import Claim
from workbench.papers.said import terms_of
from workbench.verify.resting import at_rest

#: By kind: the flags of a declaration that say more of a symbol, and what it is then.
_FLAGS = {
    "vector": {"unit": "unit", "constant": "constant"},
    "quaternion": {"unit": "unit"},
    "tensor": {"rotation": "rotation", "symmetric": "symmetric", "constant": "constant"},
}


def special_case(claim: Claim, said: Sequence[Definition], options: Mapping[str, object]) -> str | None:
    """What a symbol of the formula must be for it to hold: "a unit n". `said`: definitions that the text
    gives."""
    statement = claim.printed.statement
    if claim.notation.symbols.has_quaternions and _holds(claim, _of_quaternions, said, options):
        return "vectors that are quaternions without a scalar part"
    if claim.span is None or not isinstance(statement, Relation):
        return None
    for flag, declarations in _candidates(claim, said):
        special = {each.name: replace(each, **{flag: True}) for each in declarations}
        if _holds(claim, _with(special), said, options):
            for name, declaration in special.items():
                if len(special) > 1 and _holds(claim, _with({name: declaration}), said, options):
                    special = {name: declaration}
                    break
            names = ", ".join(str(name) for name in special)
            return f"a {_FLAGS[declarations[0].type.kind][flag]} {names}"
    for what, premises in _conditions(_free_in(claim, said)):
        if _holds(claim, lambda term: term, said, options, premises):
            return what
    for what, special, premises in at_rest(claim, said):
        if _holds(claim, _with_terms(special), said, options, premises):
            return what
    small = {each.declaration.name: replace(each.declaration, small=True) for each in _angles(claim, said)}
    if small and _holds(claim, _with(small), said, options, approximately=True):
        return f"a small {', '.join(map(str, small))}, to first order"
    return None


def _angles(claim: Claim, said: Sequence[Definition]) -> list[Symbol]:
    """The free numbers and vectors that a sine or an exponential is taken of."""
    heads = CIRCULAR | {"exp"}
    turns = [term for term in _written(claim, said) if isinstance(term, Apply) and term.head in heads]
    within = {part for turn in turns for part in turn.walk() if isinstance(part, Symbol)}
    return [
        each
        for each in _free_in(claim, said)
        if each in within and each.type.kind in ("scalar", "vector")
        if not (each.declaration.unit or each.declaration.clock or each.declaration.of)
    ]


def _conditions(free: Sequence[Symbol]) -> Iterator[tuple[str, list[Relation]]]:
    """What matrices and numbers may be that have no flag: symmetric or orthogonal matrices, and numbers that
    are a cosine and a sine or the components of something of length 1."""
    squares = [each for each in free if each.type.is_square and each.type.kind in ("tensor", "matrix")]
    squares = [each for each in squares if not (each.declaration.rotation or each.declaration.symmetric)]
    matrices = [each for each in squares if each.type.kind == "matrix"]
    for what, property_of, may in (
        ("skew", _skew, squares),
        ("symmetric", _symmetric, matrices),
        ("orthogonal", _orthogonal, matrices),
    ):
        for several in [may] * bool(may) + [[each] for each in may if len(may) > 1]:
            yield f"{what} {', '.join(map(to_latex, several))}", list(map(property_of, several))
    groups = list(_groups(free))
    premises = [relation("=", apply("add", *map(_square, group)), number(1)) for group in groups]
    names = "; ".join(", ".join(map(to_latex, group)) for group in groups)
    if groups:
        yield f"components of length 1: {names}", premises


def _skew(matrix: Symbol) -> Relation:
    return relation("=", apply("transpose", matrix), apply("neg", matrix))


def _symmetric(matrix: Symbol) -> Relation:
    return relation("=", apply("transpose", matrix), matrix)


def _orthogonal(matrix: Symbol) -> Relation:
    return relation("=", apply("mul", matrix, apply("transpose", matrix)), identity(matrix.type))


def _groups(free: Sequence[Symbol]) -> Iterator[list[Symbol]]:
    """c and s with the same scripts; numbers of one letter, or x, y, z and perhaps w; a number and a vector
    alone."""
    scalars = [each for each in free if each.type.kind == "scalar"]
    vectors = [each for each in free if each.type.kind == "vector"]
    families: dict[object, list[Symbol]] = {}
    for each in scalars:
        name = each.declaration.name
        is_turn = name.letter in ("c", "s", "C", "S") and (name.sub or name.sup)
        key = (name.letter.lower() in "cs", name.sub, name.sup) if is_turn else name.letter
        families.setdefault(
            "xyzw" if name.letter in ("w", "x", "y", "z") and not name.sub else key, []
        ).append(each)
    yield from (group for group in families.values() if 1 < len(group) < 5)
    if len(scalars) == len(vectors) == 1:
        yield [*scalars, *vectors]


def _square(term: Term) -> Term:
    return apply("dot", term, term) if term.type.kind == "vector" else apply("mul", term, term)


def _written(claim: Claim, said: Sequence[Definition]) -> list[Term]:
    bodies = (term for definition in said for term in definition.body.walk())
    return [*terms_of(claim.printed.statement), *bodies]


def _free_in(claim: Claim, said: Sequence[Definition]) -> list[Symbol]:
    """The symbols of which nothing in force speaks."""
    known = claim.notation.definitions
    defined = {each.declaration.name for each in (*known, *said)}
    bodies = [term for definition in known for term in definition.body.walk()]
    bodies += [term for supposed in claim.supposed for term in terms_of(supposed)]
    fixed = {term.declaration for term in bodies if isinstance(term, Symbol)}
    symbols = dict.fromkeys(term for term in _written(claim, said) if isinstance(term, Symbol))
    return [
        each
        for each in symbols
        if each.declaration.name not in defined
        and not (each.declaration in fixed or each.declaration.free)
        and not (each.arguments or each.type.dual)
    ]


def _candidates(claim: Claim, said: Sequence[Definition]) -> Iterator[tuple[str, list[Declaration]]]:
    """A flag, and the free symbols that may have it: tensors may be rotations together, all else singly."""
    terms = _written(claim, said)
    moving = {term.body for term in terms if isinstance(term, Derivative)}
    is_moving = any(isinstance(term, Derivative) for term in terms)
    free = [each for each in _free_in(claim, said) if not each.index]
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
    meaning: Callable[[Term], Term],
    said: Sequence[Definition],
    options: Mapping[str, object],
    premises: Sequence[Relation] = (),
    approximately: bool = False,
) -> bool:
    """Whether it does if all of its terms, and those of what the text says, have the meaning."""
    with suppress(Unsatisfiable, RecursionError, IllFormed, NotExact, EngineDisagreement):
        known = [replace(each, body=meaning(each.body)) for each in (*claim.notation.definitions, *said)]
        judge = Judge(Definitions(known), **options)
        signs = {"=": "≈"} if approximately else {}
        meant = mapped(
            claim.printed.statement,
            lambda r: relation(signs.get(r.operator, r.operator), meaning(r.left), meaning(r.right)),
        )
        supposed = (*claim.supposed, *premises)
        return judge.judge(meant, supposed, orders=claim.orders).outcome is Outcome.PROVED
    return False


def _of_quaternions(term: Term) -> Term:
    """x² = −x·x for each square of a vector."""
    made = rebuild(term, [_of_quaternions(child) for child in term.children]) if term.children else term
    is_square = isinstance(term, Power) and term.base.type.kind == "vector" and term.exponent.is_number
    return apply("neg", made) if is_square and term.exponent.constant % 4 == 2 else made


def _with(special: Mapping[Name, Declaration]) -> Callable[[Term], Term]:
    def given(own: Symbol) -> Term | None:
        declared = special.get(own.declaration.name)
        return None if declared is None else symbol(declared, own.index)

    return lambda term: replaced(term, given)


def _with_terms(special: Mapping[Name, Term]) -> Callable[[Term], Term]:
    return lambda term: replaced(term, lambda own: special.get(own.declaration.name))
