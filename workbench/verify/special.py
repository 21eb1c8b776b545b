"""What a formula holds for that is false in general: a unit vector, a rotation, a constant. A text may say so
in words, and its model leave it out. Or vectors that are quaternions without a scalar part: u² = −1."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import chain, product

from workbench.core.verdict_codes import UNLESS_IT_LASTS
from workbench.judge.kernel.families import mapped
from workbench.judge.kernel.judge import Judge
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.subject.inventory import NotExact
from workbench.judge.verdict import EngineDisagreement, Outcome
from workbench.language.definitions import Definitions, replaced
from workbench.language.naming.symbols import UNIT_LETTERS
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
    Zero,
)
from workbench.language.typed.types import Declaration
from workbench.papers.model import Claim
from workbench.papers.said import free_in, terms_of
from workbench.verify.figures import figures, lengths
from workbench.verify.resting import Supposing, at_rest

#: What a formula holds with, perhaps where it is defined at all.
HOLDS = frozenset({Outcome.PROVED, Outcome.CONDITIONAL})

#: By kind: the flags of a declaration that say more of a symbol, and what it is then.
_FLAGS = {
    "tensor": {"rotation": "rotation", "symmetric": "symmetric", "constant": "constant"},
    "vector": {"unit": "unit", "constant": "constant"},
    "quaternion": {"unit": "unit"},
}


def special_case(claim: Claim, said: Sequence[Definition], options: Mapping[str, object]) -> str | None:
    """What a symbol of the formula must be for it to hold: "a unit n". `said`: definitions that the text
    gives."""
    if claim.notation.symbols.has_quaternions and _holds(claim, _of_quaternions, said, options):
        return "vectors that are quaternions without a scalar part"
    if claim.span is None:
        return None
    for unit in _unit_matrices(claim):
        if _holds(claim, _with_terms({unit.declaration.name: identity(unit.type)}), said, options):
            return f"the unit matrix {to_latex(unit)}"
    flags = list(_candidates(claim, said))
    for flag, declarations in flags:
        if _holds(claim, _with_flag(flag, declarations), said, options):
            alone = (each for each in declarations if len(declarations) > 1)
            least = next((e for e in alone if _holds(claim, _with_flag(flag, [e]), said, options)), None)
            return _flagged(flag, [least] if least else declarations)
    if _has_roots(claim, said) and _holds(claim, _of_positive, said, options):
        return "positive numbers"
    free = _free_in(claim, said)
    cases = list(
        chain(
            _conditions(free),
            _spins(claim, _behind(claim, said)),
            figures(claim.printed.statement, free, _behind(claim, said)),
            at_rest(claim, said),
        )
    )
    for (more, besides), (what, special, premises) in product(_beside(free, flags), cases):
        members = [_member(own, term) for own, term in special.items() if isinstance(own, Symbol)]
        known = [*said, *members]
        if _holds(
            claim, lambda term, s=special, b=besides: b(_with_terms(s)(term)), known, options, premises
        ):
            return what + more
    small = [each.declaration for each in _angles(claim, said)]
    is_relation = isinstance(claim.printed.statement, Relation)
    if small and is_relation and _holds(claim, _with_flag("small", small), said, options, approximately=True):
        return f"a small {', '.join(str(each.name) for each in small)}, to first order"
    return None


def _unit_matrices(claim: Claim) -> list[Symbol]:
    """The symbols of the formula by whose letters a unit matrix goes, whatever the model says of them: a text
    that has an inertia I writes R R^T = I all the same."""
    symbols = dict.fromkeys(t for t in terms_of(claim.printed.statement) if isinstance(t, Symbol))
    squares = (each for each in symbols if each.type.kind in ("tensor", "matrix") and each.type.is_square)
    return [
        each
        for each in squares
        if each.declaration.name.letter in UNIT_LETTERS and not (each.declaration.free or each.index)
    ]


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


def _beside(
    free: Sequence[Symbol], flags: Sequence[tuple[str, list[Declaration]]]
) -> Iterator[tuple[str, Callable[[Term], Term]]]:
    """What may hold beside a case: nothing, what is a length, a flag of all symbols of a kind."""
    yield "", lambda term: term
    for what, special, _ in lengths(free):
        yield f" and {what}", _with_terms(special)
    for flag in ("unit", "rotation", "constant"):
        several = [each for own, declarations in flags if own == flag for each in declarations]
        several = [each for each in dict.fromkeys(several) if flag != "unit" or "\\hat" in each.name.styles]
        if several:
            yield f" and {_flagged(flag, several)}", _with_flag(flag, several)


def _flagged(flag: str, several: Sequence[Declaration]) -> str:
    return f"a {_FLAGS[several[0].type.kind][flag]} {', '.join(str(each.name) for each in several)}"


def _with_flag(flag: str, several: Sequence[Declaration]) -> Callable[[Term], Term]:
    """The terms with the flag on the symbols, whatever else is known of these."""
    names = {each.name for each in several}

    def flagged(own: Symbol) -> Term | None:
        is_meant = own.declaration.name in names
        return symbol(replace(own.declaration, **{flag: True}), own.index) if is_meant else None

    return lambda term: replaced(term, flagged)


def _conditions(free: Sequence[Symbol]) -> Iterator[Supposing]:
    """What matrices and numbers may be that have no flag: skew, symmetric or orthogonal matrices, and
    numbers that are a cosine and a sine or the components of something of length 1."""
    squares = [each for each in free if each.type.is_square and each.type.kind in ("tensor", "matrix")]
    squares = [each for each in squares if not (each.declaration.rotation or each.declaration.symmetric)]
    matrices = [each for each in squares if each.type.kind == "matrix"]
    for what, property_of, may in (
        ("skew", _skew, squares),
        ("symmetric", _symmetric, matrices),
        ("orthogonal", _orthogonal, matrices),
    ):
        for several in [may] * bool(may) + [[each] for each in may if len(may) > 1]:
            yield f"{what} {', '.join(map(to_latex, several))}", {}, list(map(property_of, several))
    groups = list(_groups(free))
    premises = [relation("=", apply("add", *map(_square, group)), number(1)) for group in groups]
    names = "; ".join(", ".join(map(to_latex, group)) for group in groups)
    if groups:
        yield f"components of length 1: {names}", {}, premises


def _spins(claim: Claim, free: Sequence[Symbol]) -> Iterator[Supposing]:
    """A vector that is the angular velocity of a declared frame, which no spelling of the model says."""
    for frame, spin in claim.notation.symbols.frames.items():
        for each in free:
            if each.type == spin.type and not isinstance(spin, Zero):
                yield f"the angular velocity {to_latex(each)} of {frame}", {each.declaration.name: spin}, []


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
        is_turn = name.letter in ("c", "s", "C", "S")
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


def _behind(claim: Claim, said: Sequence[Definition]) -> list[Symbol]:
    """All that is free in the formula or in what defines its symbols."""
    known = Definitions([*claim.notation.definitions, *said])
    free = sorted(free_in(terms_of(claim.printed.statement), known), key=lambda each: str(each.name))
    return [symbol(each) for each in free if not (each.free or each.indices or each.parameters)]


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
            together = [each for each in may if flag != "unit" or "\\hat" in each.name.styles]
            if together and flag != "constant":
                yield flag, together
            if flag in ("unit", "constant"):
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
        bodies = (replace(each, body=meaning(each.body)) for each in (*claim.notation.definitions, *said))
        known = Definitions(bodies)
        judge = Judge(known, **options)
        signs = {"=": "≈"} if approximately else {}

        def special(own: Relation) -> Relation:
            return relation(signs.get(own.operator, own.operator), meaning(own.left), meaning(own.right))

        meant = mapped(claim.printed.statement, special)
        supposed = (*(mapped(each, special) for each in claim.supposed), *premises, *known.known_of(meant))
        verdict = judge.judge(meant, supposed, orders=claim.orders)
        return verdict.outcome in HOLDS or verdict.code in UNLESS_IT_LASTS
    return False


def _of_quaternions(term: Term) -> Term:
    """x² = −x·x for each square of a vector."""
    made = rebuild(term, [_of_quaternions(child) for child in term.children]) if term.children else term
    is_square = isinstance(term, Power) and term.base.type.kind == "vector" and term.exponent.is_number
    return apply("neg", made) if is_square and term.exponent.constant % 4 == 2 else made


def _has_roots(claim: Claim, said: Sequence[Definition]) -> bool:
    return any(isinstance(term, Apply) and term.head in ("norm", "root") for term in _written(claim, said))


def _of_positive(term: Term) -> Term:
    """Numbers and their rates, each positive and a symbol of its own."""
    own = term.body if isinstance(term, Derivative) else term
    if not isinstance(own, Symbol) or own.type.kind != "scalar":
        return rebuild(term, [_of_positive(child) for child in term.children]) if term.children else term
    name = replace(own.declaration.name, of=(term,)) if own is not term else own.declaration.name
    return symbol(replace(own.declaration, name=name, positive=True), own.index)


def _member(own: Symbol, body: Term) -> Definition:
    return Definition(own.declaration, own.index, (), body)


def _with_terms(special: Mapping[Name | Symbol, Term]) -> Callable[[Term], Term]:
    return lambda term: replaced(term, lambda own: special.get(own.declaration.name))
