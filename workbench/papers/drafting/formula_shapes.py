"""Definitions inferred from names and from the shape of formulas: columns of components, and Jacobians."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from workbench.core.types import type_of_kind
from workbench.papers.drafting.drafted_definitions import Formula, Proposed
from workbench.papers.drafting.inference.kind_operations import SYMBOL, Operation
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.typefaces import Guess, without_bold

_COMPONENT = re.compile(r"\\?\w+_\{\w\}")
_AXES = {1: (), 2: ("x", "y"), 3: ("x", "y", "z")}


def columns(guesses: Mapping[str, Guess], lines: Mapping[str, int]) -> Iterator[Proposed]:
    """Yields columns of components: a bold θ of θ_1 and θ_2. lines: symbol → line of its first occurrence."""
    scalars = {name for name, guess in guesses.items() if guess.kind == "scalar"}
    for name, guess in guesses.items():
        own = type_of_kind(guess.kind)
        letter = without_bold(name)
        if own is None or own.columns != 1 or own.rows < 2 or own.algebra or (letter == name and "_" in name):
            continue
        for places in (tuple(map(str, range(1, own.rows + 1))), _AXES.get(own.rows, ())):
            parts = [f"{letter}_{{{place}}}" for place in places]
            others = {each for each in scalars if re.fullmatch(rf"{re.escape(letter)}_\{{\w\}}", each)}
            if parts and others == {*parts}:
                body = r"\begin{bmatrix} " + r" \\ ".join(parts) + r" \end{bmatrix}"
                yield Proposed(name, body, lines.get(name, 1), "its components have the same letter", True)


def components_of(body: str) -> list[str]:
    """Returns the components of a definition that is a column of θ_1, θ_2 or similar; else an empty list."""
    match operations_of(body, Walker()):
        case (Operation(op="said", parts=(Operation(op="transpose", parts=(Operation(op="mul") as row,)),)),):
            parts = tuple(each for each in row.walk() if each.op != "mul")  # [θ_1 θ_2]^T
        case (Operation(op="said", parts=(Operation(op="transpose", parts=(column,)),)),):
            parts = _cells(column)
        case (Operation(op="said", parts=(column,)),):
            parts = _cells(column)
        case _:
            return []
    names = [each.text for each in parts if each.op == SYMBOL and _COMPONENT.fullmatch(each.text)]
    return names if len(names) == len(parts) else []


def _cells(column: Operation) -> tuple[Operation, ...]:
    is_column = column.op == "tuple" or (column.op == "matrix" and "1" in column.text.split())
    return column.parts if is_column else ()


def jacobians(
    formulas: Sequence[Formula], columns_of: Mapping[str, Sequence[str]], defined: Mapping[str, Proposed]
) -> Iterator[tuple[Proposed, tuple[str, ...]]]:
    r"""Yields J of \dot{x} = J \dot{q} as the partial derivatives of x by the components of q.

    columns_of: column → its components.
    defined: symbol → its definition.
    """
    walker = Walker()
    rates: dict[int, list[str]] = {}
    for formula in formulas:
        for tree in operations_of(formula.latex, walker):
            if tree.op != "equal":
                continue
            for side in tree.parts:
                if (names := _rates(side, columns_of)) and names[0] in defined:
                    rates.setdefault(id(formula.display), names)
            found = _product_with_rate(tree.parts[1])
            top = rates.get(id(formula.display))
            if found is None or top is None or found[1] not in columns_of:
                continue
            jacobian, column = found
            parts = columns_of[column]
            if jacobian not in defined:
                cells = (
                    " & ".join(rf"\frac{{\partial {name}}}{{\partial {part}}}" for part in parts)
                    for name in top
                )
                body = r"\begin{bmatrix} " + r" \\ ".join(cells) + r" \end{bmatrix}"
                why = f"maps the rates of {column} to those of {', '.join(top)}"
                yield Proposed(jacobian, body, formula.display.line, why, True), tuple(parts)


def _rates(side: Operation, columns_of: Mapping[str, Sequence[str]]) -> list[str]:
    """Returns the symbols of a column of rates."""
    if side.op == "matrix" and side.text.endswith(" 1"):
        inner = [part.parts[0] for part in side.parts if part.op == "rate"]
        names = [each.text for each in inner if each.op == SYMBOL]
        return names if len(names) == len(side.parts) else []
    if side.op == "rate" and side.parts[0].op == SYMBOL:
        return list(columns_of.get(side.parts[0].text, ()))
    return []


def _product_with_rate(side: Operation) -> tuple[str, str] | None:
    r"""Returns J and q of J \dot{q}."""
    if side.op != "mul" or side.parts[1].op != "rate":
        return None
    head, column = side.parts[0].head, side.parts[1].parts[0]
    is_plain = side.parts[0].op == SYMBOL or (
        side.parts[0].op == "apply" and side.parts[0].parts[0].op == SYMBOL
    )
    return (head.text, column.text) if is_plain and column.op == SYMBOL else None
