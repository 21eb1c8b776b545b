"""The table of signatures says what the typed layer does: row by row, and the other way round."""

from __future__ import annotations

from itertools import product

import pytest

from workbench.core.construct import apply, relation, symbol
from workbench.core.names import Name
from workbench.core.operations import OPERATORS
from workbench.core.terms import IllFormed, Term, Unsupported
from workbench.core.types import QUATERNION as QUATERNION_TYPE
from workbench.core.types import Declaration, Type
from workbench.papers.drafting.inference.kind_signatures import (
    MISFIT,
    QUATERNION,
    SIGNATURES,
    Kind,
    rows,
    values,
)

SIZES = (1, 2, 3, 4, 6)
KINDS: tuple[Kind, ...] = (
    (1, 1),
    (2, 1),
    (3, 1),
    (4, 1),
    (6, 1),
    (1, 2),
    (1, 3),
    (2, 2),
    (3, 3),
    (4, 4),
    (6, 6),
    (2, 3),
    (3, 2),
    QUATERNION,
)

#: The operations of the table that the typed layer has, by its heads; a function of a scalar by the sine.
HEADS = {op: head for op in SIGNATURES if (head := "sin" if op == "function" else op) in OPERATORS}
#: Plain rows of signs that are no operation of a term.
#: What the typed layer takes and a text rarely means: the table refuses it, or wants a convention.
STRICTER = {("inverse", ((1, 1),)), ("det", ((1, 1),)), ("trace", ((1, 1),)), ("cross", ((1, 1), (1, 1)))}


def term(kind: Kind, letter: str) -> Term:
    own = QUATERNION_TYPE if isinstance(kind, str) else Type(*kind)
    return symbol(Declaration(Name(letter), own))


def kind_of(value: Term) -> Kind:
    return QUATERNION if value.type.kind == "quaternion" else (value.type.rows, value.type.columns)


def instances(patterns: tuple[str, ...]) -> set[tuple[Kind, ...]]:
    """The kinds of parts that fit the patterns of a row."""
    return {parts for parts in product(KINDS, repeat=len(patterns)) if _fit(patterns, parts)}


def _fit(patterns: tuple[str, ...], parts: tuple[Kind, ...]) -> bool:
    known: dict[str, object] = {}
    for pattern, kind in zip(patterns, parts, strict=True):
        if pattern == "_":
            continue
        if pattern in ("A", "B"):
            if known.setdefault(pattern, kind) != kind or (pattern == "B" and kind[1:] == (1,) != kind[:1]):
                return False
        elif pattern in ("s", "q"):
            if kind != ((1, 1) if pattern == "s" else QUATERNION):
                return False
        elif (
            isinstance(kind, str)
            or (pattern[0].isupper() and kind == (1, 1))
            or any(
                str(size) != letter if letter.isdigit() else known.setdefault(letter.lower(), size) != size
                for letter, size in zip(pattern.split("x"), kind, strict=True)
            )
        ):
            return False
    return True


PLAIN = [(op, patterns) for op in HEADS for patterns, _, cost in rows(op) if not cost]


@pytest.mark.parametrize(("op", "patterns"), PLAIN, ids=[f"{op} {' '.join(p)}" for op, p in PLAIN])
def test_a_plain_row_is_what_the_typed_layer_does(op: str, patterns: tuple[str, ...]) -> None:
    for parts in instances(patterns):
        given = dict(values(op, parts))
        if op == "dot" and (1, 1) in parts:
            continue  # the reader makes a product of it
        if op == "adjugate" and parts != ((3, 3),):
            continue
        if op == "partial" and (QUATERNION in parts or parts[1] == (1, 1)):
            continue  # the typed layer wants its terms to be functions of the symbol
        try:
            made = kind_of(apply(HEADS[op], *(term(kind, "abc"[at]) for at, kind in enumerate(parts))))
        except (IllFormed, Unsupported) as refused:
            pytest.fail(f"{op} of {parts}: {refused}")
        assert given.get(made) == 0, (op, parts, made)


PAIRS = [op for op, head in HEADS.items() if op not in ("partial", "quaternion", "atan2", "diag", "compose")]


@pytest.mark.parametrize("op", PAIRS)
def test_well_typed_operations_are_no_misfits(op: str) -> None:
    count = len(rows(op)[0][0])
    for parts in product(KINDS, repeat=count):
        try:
            made = kind_of(apply(HEADS[op], *(term(kind, "abc"[at]) for at, kind in enumerate(parts))))
        except (IllFormed, Unsupported):
            continue
        if (op, parts) not in STRICTER:
            assert dict(values(op, parts)).get(made, MISFIT) < MISFIT // 2, (op, parts, made)


@pytest.mark.parametrize(("one", "other"), [*product(KINDS, repeat=2)])
def test_sides_of_an_equation_have_one_kind(one: Kind, other: Kind) -> None:
    cost = min(cost for _, cost in values("equal", (one, other)))
    try:
        relation("=", term(one, "a"), term(other, "b"))
    except (IllFormed, Unsupported):
        assert cost >= MISFIT // 2
    else:
        assert cost == 0 or (QUATERNION in (one, other) and cost < MISFIT // 2)


def test_every_row_names_as_many_parts_as_its_operation_has() -> None:
    for op in SIGNATURES:
        assert len({len(patterns) for patterns, _, _ in rows(op)}) == 1, op
