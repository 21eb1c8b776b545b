"""Detection of circular conditions: a condition that states the conclusion makes any formula hold."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import chain
from random import Random

from workbench.context.claims import Claim, Formula
from workbench.core.statement_parts import concluded
from workbench.core.terms import (
    Apply,
    Conjunction,
    IllFormed,
    Implication,
    Relation,
    Statement,
    Term,
    Zero,
)
from workbench.engines.inventory.addend_expansion import addends
from workbench.language.definitions import Definitions, expand
from workbench.language.printing.printer import to_latex

IS_THE_CONCLUSION = (
    "expected a condition under which the formula holds, got the formula itself (up to definitions, a factor "
    "and the order of its sides); strike it out, or say under `given` what the formula follows from"
)
_SYMMETRIC = frozenset({"=", "≠"})
_ENTRIES = (-5, -3, -2, -1, 1, 2, 3, 7)
#: Signs of an implication that is itself the claim: f = g ⇒ g = f.
_IMPLIES = re.compile(r"\\(?:Rightarrow|Longrightarrow|implies)(?![A-Za-z])|[⇒⟹]")
_POINTS, _TRIES, _SEED = 4, 20, 0
_TOLERANCE = 1e-9


def is_conclusion(condition: Statement, claim: Statement, definitions: Definitions) -> bool:
    """True if the condition, or a part of it, is equivalent to the claim's conclusion or a part of that."""
    concluded = list(_relations(claim))
    return any(_are_same(one, other, definitions) for one in _relations(condition) for other in concluded)


def without_circular(claim: Claim) -> tuple[Claim, tuple[Formula, ...]]:
    """Returns the claim without the conditions beside it that state it anew, and those of them that words
    introduce."""
    said = claim.printed.statement
    if said is None:
        return claim, ()
    beside = claim.ambiguity
    if beside.perhaps or beside.serves:
        perhaps, serves = (
            tuple(each for each in formulas if not restates(each.statement, said))
            for formulas in (beside.perhaps, beside.serves)
        )
        claim = replace(claim, ambiguity=replace(beside, perhaps=perhaps, serves=serves))
    circular = tuple(each for each in claim.assume if restates(each.statement, said))
    if circular:
        claim = replace(claim, assume=tuple(each for each in claim.assume if each not in circular))
    if not _IMPLIES.search(claim.printed.latex):
        stated, premises = _apart_from_premises(said)
        circular += tuple(Formula(to_latex(each), each) for each in premises)
        claim = replace(claim, printed=replace(claim.printed, statement=stated)) if premises else claim
    return claim, circular


def with_definitions_beside(
    conditions: Sequence[Formula], definitions: Sequence[Formula], printed: Formula
) -> tuple[tuple[Formula, ...], tuple[Formula, ...]]:
    """Returns the conditions and the definitions beside a formula; one that states it anew is a condition."""
    circular = [each for each in definitions if restates(each.statement, printed.statement)]
    return (*conditions, *circular), tuple(each for each in definitions if each not in circular)


def _apart_from_premises(said: Statement) -> tuple[Statement, tuple[Statement, ...]]:
    """Returns the statement without the premises that state their conclusion anew, and these premises."""
    match said:
        case Implication(left=left, right=right) if restates(left, right):
            return right, (left,)
        case Conjunction(parts=parts):
            pairs = [_apart_from_premises(part) for part in parts]
            return Conjunction(tuple(part for part, _ in pairs)), tuple(p for _, own in pairs for p in own)
    return said, ()


def restates(condition: Statement | None, claim: Statement | None) -> bool:
    """True if a part of the condition is a part of the claim with its sides swapped or terms moved."""
    if condition is None or claim is None:
        return False
    concluded = [_difference(each) for each in _relations(claim)]
    return any(_difference(each) in concluded for each in _relations(condition))


def _difference(relation: Relation) -> tuple[str, frozenset[object]]:
    """Returns the sign, and the terms of the difference of the sides, up to order and a common sign.

    Terms that cancel are kept: f = 0 is another condition than g + f = g.
    """
    left, right = relation.left, relation.right
    sums = (_counted(chain(_summands(left, own), _summands(right, not own))) for own in (False, True))
    return relation.operator, frozenset(sums)


def _counted(parts: Iterable[object]) -> frozenset[tuple[object, int]]:
    return frozenset(Counter(parts).items())


def _summands(term: Term, negative: bool = False) -> Iterator[tuple[bool, object]]:
    """Yields the keys of the addends that are not 0, each with whether it is subtracted."""
    for is_subtracted, addend in addends(term, negative):
        if not isinstance(addend, Zero):
            yield is_subtracted, _unordered(addend)


def _unordered(term: Term) -> object:
    """Returns a key of the term in which the order of sums and of commutative products does not count."""
    if not isinstance(term, Apply):
        return term
    if term.head in ("add", "neg"):
        return _counted(_summands(term))
    parts = [_unordered(part) for part in term.arguments]
    is_commutative = term.head == "dot" or all(part.type.kind == "scalar" for part in term.arguments)
    if term.head in ("dot", "mul") and is_commutative:
        return term.head, _counted(parts)
    return term.head, tuple(parts)


def _relations(statement: Statement) -> Iterator[Relation]:
    return (part for part in concluded(statement) if isinstance(part, Relation))


def _are_same(one: Relation, other: Relation, definitions: Definitions) -> bool:
    if one.operator != other.operator or one.left.type.kind == "operator":
        return False
    with suppress(IllFormed):
        mine, yours = (
            [expand(side, definitions) for side in (each.left, each.right)] for each in (one, other)
        )
        if mine == yours or (one.operator in _SYMMETRIC and mine == yours[::-1]):
            return True
    is_alike = one.operator in _SYMMETRIC and "operator" not in (one.left.type.kind, other.left.type.kind)
    return is_alike and any(_are_proportional(one, other, definitions, hold) for hold in (False, True))


def _are_proportional(one: Relation, other: Relation, definitions: Definitions, hold: bool) -> bool:
    """True if the differences of both equations' sides have the same nonzero ratio at random points.

    hold: whether constants keep their values over all points, so that the ratio may depend on them. Some
    other symbol must then vary.
    """
    from workbench.engines.inventory import NotExact

    with suppress(NotExact, IllFormed, ZeroDivisionError):
        points = _differences(one, other, definitions, hold)
        if any(len(mine) != len(yours) for mine, yours in points):
            return False
        if hold and all(_is_close(mine, points[0][0]) for mine, _ in points):
            return False
        pairs = [pair for mine, yours in points for pair in zip(mine, yours, strict=True)]
        mine, yours = max(pairs, key=lambda pair: abs(pair[1]))
        is_some = min(max(map(abs, values)) for values in zip(*pairs, strict=True)) > _TOLERANCE
        return is_some and _is_close([a * yours for a, _ in pairs], [b * mine for _, b in pairs])
    return False


def _is_close(one: Sequence[float], other: Sequence[float]) -> bool:
    size = 1 + max(map(abs, (*one, *other)))
    return all(abs(a - b) < _TOLERANCE * size for a, b in zip(one, other, strict=True))


def _differences(
    one: Relation, other: Relation, definitions: Definitions, hold: bool
) -> list[list[list[float]]]:
    """Returns, for each of some random points, the differences of the sides of both equations.

    Raises:
        NotExact: A side cannot be evaluated.
    """
    from workbench.engines.inventory import NotExact
    from workbench.engines.inventory.inventory import take_inventory
    from workbench.engines.inventory.parameters import Parameter
    from workbench.engines.jet.jets import JetEngine
    from workbench.engines.jet.rings import FloatRing, PointSource, RationalRing, sample

    inventory = take_inventory((one.left, one.right, other.left, other.right), definitions)
    random = Random(_SEED)
    fixed: dict[Parameter, float] = {}
    found: list[list[list[float]]] = []
    for _ in range(_TRIES):
        drawn = sample(inventory, RationalRing(_ENTRIES), random)
        point = {each: float(value) for each, value in drawn.items()} | fixed
        if hold and not fixed:
            fixed = {each: value for each, value in point.items() if _is_constant(each.symbol)}
        with suppress(ZeroDivisionError):
            engine = JetEngine(PointSource(FloatRing(), point), definitions)
            found.append([list(engine.differences(each.left, each.right)) for each in (one, other)])
        if len(found) == _POINTS:
            return found
    raise NotExact("no point at which all of it is defined")


def _is_constant(symbol: object) -> bool:
    declaration = getattr(symbol, "declaration", None)
    return declaration is not None and declaration.constant
