"""Kinds of a text's symbols: all formulas are solved together, with marks and functions as one choice."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.papers.drafting.inference.differential_letters import has_differentials
from workbench.papers.drafting.inference.kind_operations import SYMBOL, Operation
from workbench.papers.drafting.inference.kind_search import Formula, Search
from workbench.papers.drafting.inference.kind_signatures import QUATERNION, SCALAR, TENSOR, VECTOR, Kind
from workbench.papers.drafting.inference.notation_marks import (
    Rewriter,
    applied_letters,
    marks_of_exponents,
    said_to_be_skew,
    skew_marks,
)
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.priors import MAP_OF_TWISTS, Priors, components_in
from workbench.papers.drafting.inference.walker import Walker, counted_letters
from workbench.papers.drafting.words_on_symbols import Prose

#: Sizes that any text may use, and the greatest size that a literal matrix suggests.
_USUAL, _LARGEST = (1, 2, 3, 4), 12
#: A kind is doubtful if the next best costs at most this much more.
_CLOSE = 3
#: Operations on twists.
_OF_TWISTS = re.compile(
    r"\btwist|\bwrench|spatial (?:velocit|acceleration|force|vector)|\bscrew", re.IGNORECASE
)
#: Words of texts on joint spaces, whose dimension n no formula determines.
_OF_JOINTS = re.compile(
    r"\bjoint|generali[sz]ed (?:coordinate|velocit|force)|degrees? of freedom|manipulator|\bJacobian"
)
#: M(q) q̈: a joint-space matrix and the joint accelerations.
_JOINT_SPACE = re.compile(r"[A-Z]\s*\}?\s*\(\s*(\\?[A-Za-z]+)\s*\)\s*\\ddot\s*\{?\s*\1(?![A-Za-z])")
#: i j k = -1, or the sum of a quaternion's parts.
_UNITS = re.compile(r"(?<![\\A-Za-z])i\s*j\s*k\s*=|i\s*j\s*=\s*k|\bi\s*\+[^=+]*j\s*\+[^=+]*k(?![A-Za-z])")


#: Operations that only quaternions have.
_OF_QUATERNIONS = frozenset(("scalar part", "vector part", "conjugate"))


@dataclass(frozen=True)
class Source:
    """A formula of a text: its LaTeX, its line, whether it stands in a sentence, and its section."""

    latex: str
    line: int = 0
    inline: bool = False
    section: str = ""


@dataclass(frozen=True)
class Inferred:
    """The kind of one symbol.

    Attributes:
        margin: The additional cost of the next best kind, in tenths.
        because: The lines of the formulas that cost more with it.
    """

    kind: Kind
    margin: int
    others: tuple[tuple[Kind, int], ...]
    because: tuple[int, ...] = ()


@dataclass(frozen=True)
class TypeMismatch:
    """A formula with an operation that no likely kinds satisfy.

    Attributes:
        names: The symbols of the operation.
        cured_by: The symbols with other kinds that suit the formula and that no other evidence contradicts.
        gives_entries: Whether the operation equates a letter and a matrix of other extents.
        has_blocks: Whether a matrix in it has entries that are no numbers; their sizes are guesses.
        operation: Its name in `SIGNATURES`.
    """

    latex: str
    names: tuple[str, ...]
    cured_by: tuple[str, ...]
    gives_entries: bool = False
    operation: str = ""
    has_blocks: bool = False


@dataclass(frozen=True)
class Thin:
    """A symbol whose kind rests on one formula only, and its kind without that formula.

    Attributes:
        alone: Whether no other formula has the symbol.
    """

    name: str
    latex: str
    kind: Kind
    other: Kind
    alone: bool


@dataclass(frozen=True)
class Inference:
    r"""The result of the inference for a text.

    Attributes:
        skew_marks: \hat and \tilde, if they make skew tensors.
        thin: Kinds that rest on one formula only.
        orthogonal: Matrices with A Aᵀ = 1, det A = 1 or in a set of such matrices.
        moving: Symbols with a rate.
        firm: Symbols whose kinds words or a typeface state.
        first: The first formula with a relation that has a symbol.
        dotted: Numbers that stand only before and behind the dot of a product of two symbols.
    """

    kinds: Mapping[str, Inferred]
    skew_marks: tuple[str, ...]
    misfits: tuple[TypeMismatch, ...]
    thin: tuple[Thin, ...]
    orthogonal: frozenset[str]
    moving: frozenset[str]
    firm: frozenset[str]
    first: Mapping[str, str]
    dotted: frozenset[str] = frozenset()

    def doubtful(self, latex: str) -> set[str]:
        """Returns the symbols whose kinds are doubtful for judging a formula.

        These occur in other formulas that do not fit, or another kind would suit them as well; the dot may
        be that of vectors.
        """
        spoilt = {name for each in self.misfits if each.latex != latex for name in each.names}
        return spoilt | self.dotted | {name for name, own in self.kinds.items() if own.margin < _CLOSE}

    def is_square(self, name: str) -> bool:
        """True if a symbol is a square matrix."""
        kind = self.kinds[name].kind
        return isinstance(kind, tuple) and kind[0] == kind[1] != 1


def infer(sources: Sequence[Source], prose: Prose, functions: Collection[str] = ()) -> Inference:
    """Returns the kinds of all symbols of the formulas. Inline formulas count if a display shares a
    symbol.

    functions: letters that are functions before brackets.
    """
    has_signs = has_differentials(each.latex for each in sources if not each.inline)
    walker = Walker((), (), has_signs, functions)
    read = [(each, operations_of(each.latex, walker)) for each in sources]
    labels = walker.labelled & walker.transposed
    counted = _counted([tree for _, trees in read for tree in trees], prose)
    maps = walker.open_maps & walker.defined_maps
    if labels or counted or maps:
        walker = Walker(labels, counted, has_signs, functions, maps)
        read = [(each, operations_of(each.latex, walker)) for each in sources]
    shown = {name for each, trees in read if not each.inline for tree in trees for name in tree.names}
    read = [(each, trees) for each, trees in read if not each.inline or _counts(trees, shown)]
    skews = said_to_be_skew(tree for _, trees in read for tree in trees)
    sure_marks = walker.marks_over_several
    if not prose.has_quaternions:
        sure_marks |= marks_of_exponents(tree for _, trees in read for tree in trees)
    rewriter = Rewriter(walker, skews=skews, skew_marks=sure_marks)
    formulas = [Formula(rewriter.all(trees), each.line, each.inline, each.section) for each, trees in read]
    has_units = any(_UNITS.search(each.latex) for each in sources)
    has_joints = bool(_OF_JOINTS.search(prose.text)) or any(
        _JOINT_SPACE.search(each.latex) for each in sources
    )
    search = _search(formulas, prose, has_units, has_joints)
    search.run()
    votes, (functions, products) = skew_marks(search), applied_letters(search)
    marks = sure_marks | {mark for mark, is_skew in votes.items() if is_skew}
    if votes or functions or products:
        names = {mark for mark, is_skew in votes.items() if not is_skew}
        rewriter = Rewriter(
            walker, frozenset(marks), frozenset(names), functions=functions, products=products
        )
        formulas = [replace(each, trees=rewriter.all(each.trees)) for each in formulas]
        search = _search(formulas, prose, has_units, has_joints, search)
        search.run()
    sources = [each for (each, _), formula in zip(read, formulas, strict=True) if formula.trees]
    misfits = tuple(
        TypeMismatch(
            source.latex,
            operation.names,
            tuple(search.cured_by(place)),
            _gives_entries(operation),
            operation.op,
            _has_blocks(operation, search),
        )
        for place, source in enumerate(sources)
        for operation in _misfits(search, search.formulas[place])
    )
    thin = tuple(
        Thin(name, sources[place].latex, search.kinds[name], other, len(search.users[name]) == 1)
        for name, place, other in search.needed_once()
    )
    kinds = {name: _inferred(search, name) for name in search.users}
    trees = [tree for formula in search.formulas for tree in formula.trees]
    return Inference(
        kinds,
        tuple(sorted(marks)),
        misfits,
        thin,
        frozenset(_orthogonal(trees)),
        frozenset(_moving(trees)),
        frozenset(filter(search.is_firm, search.users)),
        _first(sources, search.formulas),
        frozenset(name for name in _dotted(trees) if kinds[name].kind == SCALAR and not search.is_firm(name)),
    )


def _counted(trees: Iterable[Operation], prose: Prose) -> frozenset[str]:
    leaves = {each.text for tree in trees for each in tree.walk() if each.op in (SYMBOL, "identity")}
    return counted_letters(leaves, (name for name in leaves if prose.is_inertia(name)))


def _maps(trees: Iterable[Operation]) -> Iterable[str]:
    """Yields the T of a × (T a) and of aᵀ T a, which authors do not write for a scalar."""
    for tree in trees:
        one: Operation | None
        match tree:
            case Operation(op="cross", parts=(one, Operation(op="mul", parts=(factor, other)))):
                pass
            case Operation(op="mul", parts=(Operation(op="mul", parts=(row, factor)), other)):
                one = _transposed(row)
            case _:
                continue
        if one is other:
            yield from (factor.parts[0] if factor.op == "apply" else factor).names


def _transposed(row: Operation) -> Operation | None:
    """Returns the a of aᵀ and of s aᵀ."""
    last = row.parts[-1] if row.op == "mul" else row
    return last.parts[0] if last.op == "transpose" else None


def _orthogonal(trees: Iterable[Operation]) -> Iterable[str]:
    for tree in trees:
        if tree.op == "member" and re.search(r"S[OE]", tree.text):
            yield from tree.names
        if tree.op == "equal" and len(set(tree.names) - {"I"}) == 1:
            left, right = tree.parts
            is_product = left.op == "mul" and right.op in ("identity", "unit")
            if is_product or (left.op == "det" and (right.op, right.text) == ("number", "1")):
                yield from tree.names


def _dotted(trees: Iterable[Operation]) -> set[str]:
    """Returns the symbols that stand only in products of two symbols with a dot."""
    inside: Counter[str] = Counter()
    everywhere: Counter[str] = Counter()
    for tree in trees:
        for each in tree.walk():
            if each.op == SYMBOL:
                everywhere[each.text] += 1
            elif each.op == "dot" and all(part.op == SYMBOL for part in each.parts):
                inside.update(part.text for part in each.parts)
    return {name for name, count in inside.items() if count == everywhere[name]}


def _moving(trees: Iterable[Operation]) -> Iterable[str]:
    for tree in trees:
        for each in tree.walk():
            if each.op in ("rate", "operator", "partial"):
                yield from each.names


def _counts(trees: Sequence[Operation], shown: set[str]) -> bool:
    return any(not shown.isdisjoint(tree.names) and tree.op != "said" for tree in trees)


def _search(
    formulas: Sequence[Formula],
    prose: Prose,
    has_units: bool,
    has_joints: bool,
    before: Search | None = None,
) -> Search:
    trees = [each for formula in formulas for tree in formula.trees for each in tree.walk()]
    heads = {each.parts[0].text for each in trees if each.op == "apply" and each.parts[0].op == SYMBOL}
    units = ("i", "j", "k") if has_units else ()
    parted = {name for tree in trees if tree.op in _OF_QUATERNIONS for name in tree.names}
    speaks = prose.has_quaternions or bool(units) or bool(parted)
    sizes = _sizes(trees, prose, has_joints) + ([QUATERNION] if speaks else [])
    names = {name for tree in trees for name in tree.names}
    priors = Priors(prose, sizes, heads, units, parted, {*_maps(trees)}, components_in(names))
    if before is None:
        return Search(formulas, priors)
    return Search(formulas, priors, before.kinds, before.costs)


def _sizes(trees: Iterable[Operation], prose: Prose, has_joints: bool) -> list[Kind]:
    """Returns the sizes that symbols may have.

    These are columns, rows and squares of the usual extents and of those of literal matrices, and other
    matrices if the text has one.
    """
    extents, has_blocks = {*_USUAL}, False
    if _OF_TWISTS.search(prose.text):
        extents.add(6)
    for tree in trees:
        if tree.op == SYMBOL and MAP_OF_TWISTS.search(tree.text):
            extents.add(6)
        if tree.op == "matrix":
            own = [*map(int, tree.text.split())]
            has_blocks = has_blocks or min(own) > 1
            extents.update(extent for extent in own if extent <= _LARGEST)
            extents.update((6,) if 2 in own else (6, 8) if 3 in own else ())
        if tree.op == "tuple" and len(tree.parts) <= _LARGEST:
            extents.add(len(tree.parts))
    found: list[Kind] = [
        (rows, columns)
        for rows in sorted(extents)
        for columns in sorted(extents)
        if has_blocks or rows == columns or 1 in (rows, columns)
    ]
    if has_joints:
        found += [(0, 1), (0, 0), *((rows, 0) for rows in sorted(extents) if rows in (1, 2, 3, 6))]
    return found


def _first(sources: Iterable[Source], formulas: Iterable[Formula]) -> dict[str, str]:
    first: dict[str, str] = {}
    for source, formula in zip(sources, formulas, strict=True):
        for name in (name for tree in formula.trees if tree.op != "said" for name in tree.names):
            first.setdefault(name, source.latex)
    return first


def _gives_entries(operation: Operation) -> bool:
    sides = [each.parts[0] if each.op == "transpose" else each for each in operation.parts]
    return operation.op == "equal" and {each.op for each in sides} == {SYMBOL, "matrix"}


def _has_blocks(operation: Operation, search: Search) -> bool:
    """True if other sizes of the blocks of a matrix may suit; no size makes a column a number."""
    kinds = search.kinds
    tables = (search.costs.table(each, kinds) for each in operation.parts)
    if operation.op in ("equal", "add") and any(min(each, key=each.__getitem__) == SCALAR for each in tables):
        return False
    matrices = (each for each in operation.walk() if each.op == "matrix")
    names = {name for matrix in matrices for cell in matrix.parts for name in _factors_of(cell)}
    return any(kinds.get(name, SCALAR) != SCALAR for name in names)


def _factors_of(cell: Operation) -> Iterable[str]:
    """Yields the symbols whose sizes are that of a cell: not those in a scalar product, say."""
    if cell.op == SYMBOL:
        yield cell.text
    elif cell.op in ("mul", "add", "neg", "rate", "transpose", "apply"):
        for part in cell.parts:
            yield from _factors_of(part)


def _misfits(search: Search, formula: Formula) -> Iterable[Operation]:
    return [each for tree in formula.trees for each in search.costs.misfits(tree, search.kinds)]


def _inferred(search: Search, name: str) -> Inferred:
    others = search.others(name)
    margin = others[0][1] if others else 1000
    because: list[int] = []
    if others:
        change = {name: others[0][0]}
        because = [
            search.formulas[place].line
            for place in search.users[name]
            if search.cost(place, change) > search.cost(place)
        ]
    return Inferred(search.kinds[name], margin, tuple(others), tuple(dict.fromkeys(because)))


def kind_name(kind: Kind) -> str:
    """Returns the name of a kind in a model."""
    if isinstance(kind, str):
        return "hamilton quaternion"
    usual = {SCALAR: "scalar", VECTOR: "vector", TENSOR: "tensor"}
    return usual.get(kind) or f"matrix {kind[0] or 'n'}×{kind[1] or 'n'}"
