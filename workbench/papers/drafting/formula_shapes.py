"""Definitions inferred from names and from the shape of formulas: columns, components, and Jacobians."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence

from workbench.core.types import type_of_kind
from workbench.papers.drafting.drafted_definitions import Formula, Proposed
from workbench.papers.drafting.inference.kind_operations import SYMBOL, Operation
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.typefaces import Guess, without_bold

_COMPONENT = re.compile(r"\\?\w+_\{\w\}")
#: A letter of an axis under a hat, in any font.
_HAT = re.compile(
    r"((?:\\(?:mathbf|boldsymbol|mathrm)\{)?\\hat\{(?:\\(?:mathbf|boldsymbol|mathrm)\{)?)([a-z])(\}+)"
)
_QUATERNIONS, _TENSORS = ("hamilton quaternion",), ("tensor", "rotation")
#: The labels of the vector part of a quaternion, and those of its scalar part.
_COMPLETE = (("1", "2", "3"), ("x", "y", "z"))
SCALAR_PARTS = ("0", "w", "s", "r", "4")
_AXES = {1: (), 2: ("x", "y"), 3: ("x", "y", "z")}


def columns(
    guesses: Mapping[str, Guess], lines: Mapping[str, int], defined: Collection[str] = ()
) -> Iterator[Proposed]:
    """Yields columns of components: a bold θ of θ_1 and θ_2.

    lines: symbol → line of its first occurrence.   defined: symbols with another definition.
    """
    scalars = {name for name, guess in guesses.items() if guess.kind == "scalar"}
    for name, guess in guesses.items():
        own = type_of_kind(guess.kind)
        letter = without_bold(name)
        if own is None or own.columns != 1 or own.rows < 2 or own.algebra or (letter == name and "_" in name):
            continue
        if guess.unit or name in defined:  # what it is determines its components
            continue
        numbered = (tuple(map(str, range(first, own.rows + first))) for first in (0, 1))
        for places in (*numbered, _AXES.get(own.rows, ())):
            parts = [f"{letter}_{{{place}}}" for place in places]
            others = {each for each in scalars if re.fullmatch(rf"{re.escape(letter)}_\{{\w\}}", each)}
            if parts and others == {*parts}:
                body = r"\begin{bmatrix} " + r" \\ ".join(parts) + r" \end{bmatrix}"
                yield Proposed(name, body, lines.get(name, 1), "its components have the same letter", True)


def matrices(
    guesses: Mapping[str, Guess], lines: Mapping[str, int], defined: Collection[str] = ()
) -> Iterator[Proposed]:
    """Yields square matrices of their entries: an M of M_11, M_12, M_22, which is symmetric then.

    lines: symbol → line of its first occurrence.   defined: symbols with another definition.
    """
    for name, guess in guesses.items():
        own = type_of_kind(guess.kind)
        if own is None or own.columns != own.rows or own.rows < 2 or own.algebra or name in defined:
            continue
        places = range(1, own.rows + 1)
        entry = {(i, j): f"{without_bold(name)}_{{{i}{j}}}" for i in places for j in places}
        for (i, j), part in entry.items():
            if part not in guesses and entry[j, i] in guesses:
                entry[i, j] = entry[j, i]
        if all(part in guesses and guesses[part].kind == "scalar" for part in entry.values()):
            rows = (" & ".join(entry[i, j] for j in places) for i in places)
            body = r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"
            yield Proposed(name, body, lines.get(name, 1), "its entries have the same letter", True)


def axes(
    guesses: Mapping[str, Guess], lines: Mapping[str, int], defined: Collection[str], moving: Collection[str]
) -> Iterator[Proposed]:
    """Yields unit vectors with hats and the letters x, y, z or i, j, k as the fixed axes.

    moving: symbols whose rates the text writes.   lines, defined: as in `columns`.
    """
    vectors = {name for name, guess in guesses.items() if guess.kind == "vector"}
    for letters in ("xyz", "ijk"):
        for first in (name for name in vectors if (own := _HAT.fullmatch(name)) and own[2] == letters[0]):
            names = [_HAT.sub(rf"\g<1>{letter}\g<3>", first) for letter in letters]
            known = [name for name in names if name in vectors]
            if len(known) < 2 or {*known} & ({*defined} | {*moving}):
                continue
            for at, name in enumerate(names):
                if name in known:
                    body = r" \\ ".join(str(int(at == row)) for row in range(3))
                    why = "the axes of fixed coordinates"
                    yield Proposed(
                        name, rf"\begin{{bmatrix}} {body} \end{{bmatrix}}", lines.get(name, 1), why, True
                    )


def components(
    guesses: Mapping[str, Guess], lines: Mapping[str, int], defined: Collection[str] = ()
) -> Iterator[tuple[Proposed, str]]:
    """Yields each component of a quaternion, a tensor or a known vector of the same letter, and its whole.

    Known are unit vectors, and vectors that are defined.

    These are q_0 or q_w for the scalar part of q, q_1 or q_x for a component of its vector part, n_1 or n_x
    for a component of n, and R_{12} or R_{1,2} for an entry of R. A letter whose components are not all named
    by such labels has none.
    """
    wholes = [
        guess
        for guess in guesses.values()
        if guess.kind in (*_QUATERNIONS, *_TENSORS)
        or (guess.kind == "vector" and (guess.unit or guess.name in defined))
    ]
    for whole in wholes:
        letter = without_bold(whole.name)
        pattern = re.compile(rf"{re.escape(letter)}_\{{(\w) ?,? ?(\w?)\}}")
        parts = {
            name: found.groups()
            for name, guess in guesses.items()
            if guess.kind == "scalar" and (found := pattern.fullmatch(name)) is not None
        }
        labels = [tuple(filter(None, label)) for label in parts.values()]
        fits: Callable[[Sequence[tuple[str, ...]]], bool]
        part: Callable[..., str]
        if whole.kind in _QUATERNIONS:
            fits, part = _are_quaternion, _part
        else:
            fits, part = (_are_entries, _entry) if whole.kind in _TENSORS else (_are_axes, _coordinate)
        if len(parts) > 1 and fits(labels):
            for name, label in zip(parts, labels, strict=True):
                body = part(whole.name, *label)
                yield (
                    Proposed(name, body, lines.get(name, 1), f"a component of {whole.name}", True),
                    whole.name,
                )


def _are_quaternion(labels: Sequence[tuple[str, ...]]) -> bool:
    """True if labels are those of the four parts of a quaternion."""
    found = {label[0] for label in labels if len(label) == 1}
    return len(found) == len(labels) == 4 and any(
        found == {scalar, *axes} for axes in _COMPLETE for scalar in SCALAR_PARTS
    )


def _are_entries(labels: Sequence[tuple[str, ...]]) -> bool:
    return all(len(label) == 2 and set(label) <= set("123") for label in labels)


def _are_axes(labels: Sequence[tuple[str, ...]]) -> bool:
    """True if labels are those of the three components of a vector."""
    return {label[0] for label in labels if len(label) == 1} in map(set, _COMPLETE) and len(labels) == 3


def _coordinate(whole: str, label: str) -> str:
    return rf"{_unit(label, ' & ')} {whole}"


def _part(whole: str, label: str) -> str:
    if label in SCALAR_PARTS:
        return rf"\operatorname{{Sc}} {whole}"
    return rf"{_unit(label, ' & ')} \operatorname{{Vec}} {whole}"


def _entry(whole: str, row: str, column: str) -> str:
    return rf"{_unit(row, ' & ')} {whole} {_unit(column, chr(92) * 2)}"


def _unit(label: str, sign: str) -> str:
    """Returns the unit row or column of an axis."""
    cells = (str(int(label in axes)) for axes in ("1x", "2y", "3z"))
    return rf"\begin{{bmatrix}} {sign.join(cells)} \end{{bmatrix}}"


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


def quaternion_parts(value: Operation) -> tuple[str, ...]:
    """Returns the symbols that a formula lists as the parts of a quaternion; none for other formulas.

    (s, v), [q_0, q_1, q_2, q_3]^T, a column, s + v and q_0 + q_1 i + q_2 j + q_3 k list them.
    """
    match value:
        case Operation(op="transpose", parts=(row,)):
            return quaternion_parts(row)
        case Operation(op="tuple" | "matrix" | "add", parts=cells):
            parts = tuple(_part_in(cell) for cell in cells)
        case Operation(op="mul"):
            parts = tuple(each.text if each.op == SYMBOL else "" for each in value.walk() if each.op != "mul")
        case _:
            return ()
    return parts if len(parts) in (2, 4) and all(parts) else ()


def _part_in(cell: Operation) -> str:
    """Returns the symbol of v, v^T, or the product of a symbol and a unit i, j or k; "" for other cells."""
    match cell:
        case (
            Operation(op="symbol", text=name)
            | Operation(op="transpose", parts=(Operation(op="symbol", text=name),))
        ):
            return name
        case Operation(op="mul", parts=(Operation(op="symbol") as one, Operation(op="symbol") as other)):
            names = [each.text for each in (one, other) if without_bold(each.text) not in ("i", "j", "k")]
            return names[0] if len(names) == 1 else ""
    return ""


def _cells(column: Operation) -> tuple[Operation, ...]:
    is_column = column.op == "tuple" or (column.op == "matrix" and "1" in column.text.split())
    return column.parts if is_column else ()


def coordinates(formulas: Sequence[Formula]) -> set[str]:
    r"""Returns the symbols by which formulas differentiate: q of \partial L/\partial\dot{q}."""
    walker = Walker()
    found = set()
    for formula in formulas:
        if "\\partial" in formula.latex:
            for each in (part for tree in operations_of(formula.latex, walker) for part in tree.walk()):
                if each.op in ("partial", "operator"):
                    place = each.parts[-1]
                    place = place.parts[0] if place.op == "rate" else place
                    found |= {place.text} if place.op == SYMBOL else set()
    return found


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
