"""From rows of factors to operations: functions and their arguments, products, and infix signs."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from workbench.core.names import PREFIXES
from workbench.core.operations import FUNCTIONS, OF_ANGLES
from workbench.language.elaboration.operators.derivatives_of_maps import applied, without_brackets
from workbench.language.elaboration.operators.differentials import is_differential_sign, takes_differential
from workbench.language.elaboration.operators.integrals import parts_of_integral
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Bracket,
    Extremal,
    Infix,
    Integration,
    Leaf,
    Node,
    Scripted,
    Sum,
    Summation,
    core,
    is_function,
    is_left_script,
)
from workbench.language.naming.spelling import in_bracket, prefixed
from workbench.papers.drafting.inference.kind_operations import SYMBOL, Forest, Operation

#: The operations that words denote, in addition to those of the language.
_WORDS = {
    **{"trace": "trace", "Exp": "exp", "Log": "log", "ln": "log", "log": "log", "vex": "vect"},
    **dict.fromkeys(("sgn", "sign", "sinc"), "function"),
    "diag": "diag",
}
#: The operations that infix signs denote.
_SIGNS = {"·": "dot", "×": "cross", "⊗": "outer", "∘": "compose", "∧": "wedge", "∨": "wedge", "*": "compose"}
#: The infix signs with the highest precedence.
_TIGHT = frozenset("×⊗∧∨")
#: Words for matrices that act on the bracket after them, as Ad_g(x).
_MATRICES = frozenset(("Ad", "ad"))
#: Operations whose values are numbers.
_NUMBERS = frozenset(("number", "function"))
_TIMES = frozenset(("t", "\\tau"))


class RowWalker:
    """Walks rows of factors; `Walker` interprets each factor."""

    def __init__(
        self,
        forest: Forest,
        has_differentials: bool,
        functions: Collection[str] = (),
        maps: Collection[tuple[str, str]] = (),
    ) -> None:
        self.forest, self.make = forest, forest.make
        #: letters that are functions before brackets
        self.functions = functions
        #: whether an italic d before a letter or a bracket is the sign of a differential
        self.has_differentials = has_differentials
        #: whether a differential stands in the formula, besides derivatives of maps
        self.shows_differentials = False
        #: f and x of the equations that say what f(x) is, of those seen so far, and of what may be D f(x)
        self.maps, self.defined_maps = maps, set[tuple[str, str]]()
        self.open_maps: set[tuple[str, str]] = set()

    def term(self, node: Node | None) -> Operation:
        raise NotImplementedError

    def prefixed(self, left: Scripted, node: Node) -> Operation | None:
        raise NotImplementedError

    def raised(self, inner: Operation, node: Scripted) -> Operation:
        raise NotImplementedError

    def row(self, items: Sequence[Node]) -> Operation:
        """Returns the product of the items; a function takes the factor after it."""
        parts: list[Operation | str] = []
        items, place = without_brackets(items), 0
        while place < len(items):
            part, place = self._part(items, place)
            parts.append(part)
        return self._joined(parts)

    def _part(self, items: Sequence[Node], place: int) -> tuple[Operation | str, int]:
        """Returns the part of a product that begins at a position, and where the next part begins."""
        node, behind = items[place], items[place + 1] if place + 1 < len(items) else None
        inner = core(node)
        if isinstance(node, Infix):
            return node.operator, place + 1
        if isinstance(node, Integration) and (found := parts_of_integral(items[place + 1 :])) is not None:
            body, _, after = found
            made = self.row(body) if body else self.make("number", text="1")
            return made, len(items) - len(after)
        if isinstance(node, Summation | Extremal):
            rest = self.row(items[place + 1 :]) if behind is not None else self.forest.anything()
            return rest, len(items)
        if inner is not None and is_function(inner):
            return self._function(inner, behind), place + 1 + (behind is not None)
        if (along := self._along_direction(items[place:])) is not None:
            return along[0], place + along[1]
        if behind is not None and (pair := self._with_next(node, behind)) is not None:
            return pair, place + 2
        return self._alone(node), place + 1

    def _along_direction(self, items: Sequence[Node]) -> tuple[Operation, int] | None:
        """Returns the operation of D f(x)[v], the derivative of f along v, and how many items it has; None
        for other items. Without square brackets, an equation must say what f(x) is."""
        for found, along, count in applied(items):
            is_bracketed = found.items == 3 and isinstance(items[3], Bracket) and items[3].kind == "["
            pair = (latex_of(found.body), latex_of(core(found.at)))
            is_differential = found.letter == "d" and self.shows_differentials
            if is_bracketed or (pair in self.maps and not is_differential):
                self.make("add", self.term(found.at), self.term(along))
                return self.make("rate", self.term(found.body)), count
            self.open_maps.add(pair)
        return None

    def _with_next(self, node: Node, behind: Node) -> Operation | None:
        """Returns the operation of two items together: a letter with left scripts, or a function of a
        bracket."""
        if is_left_script(node) and isinstance(node, Scripted):
            return self.prefixed(node, behind) or self.term(behind)
        inner, bracket = core(node), core(behind)
        is_sure = self.has_differentials or not isinstance(inner, Leaf)
        if is_differential_sign(node) and takes_differential(behind) and is_sure:
            return self.make("rate", self.term(behind))
        if isinstance(inner, Leaf) and inner.text in PREFIXES and (both := prefixed(inner, behind)):
            return self.term(both)
        if isinstance(bracket, Bracket) and bracket.kind in ("(", "["):
            return self._applied(node, bracket)
        if isinstance(bracket, Scripted) and bracket.sub is None:  # J(q)^T
            held = core(bracket.nucleus)
            if isinstance(held, Bracket) and held.kind == "(":
                made = self._applied(node, held)
                return made if made is None else self.raised(made, bracket)
        return None

    def _alone(self, node: Node) -> Operation:
        inner = core(node)
        if isinstance(inner, Bracket) and inner.kind == "[" and len(inner.parts) == 1:
            if (pair := in_bracket(inner)) is not None:
                return self.make("either", self.forest.symbol(str(pair.name)), self.term(inner))
            return self.term(inner)
        return self.term(node)

    def _function(self, node: Node, behind: Node | None) -> Operation:
        """Returns the value of a function at the item after it."""
        leaf = node.nucleus if isinstance(node, Scripted) else node
        assert isinstance(leaf, Leaf)
        name, inner = leaf.name, self.term(behind)
        head = _WORDS.get(name) or FUNCTIONS.get(name)
        if head in OF_ANGLES or head == "function":
            return self.make("function", inner)
        if head is not None:
            return self.make(head, *(inner.parts if head == "quaternion" else (inner,)))
        word = self.term(
            replace(node, nucleus=_letter(leaf)) if isinstance(node, Scripted) else _letter(leaf)
        )
        if name in _MATRICES and isinstance(node, Scripted) and node.sub is not None:
            return self.make("mul", word, inner)
        return self.make("apply", word, inner, text="sure")

    def _applied(self, node: Node, bracket: Bracket) -> Operation | None:
        """Returns a letter before a bracket as a function of its contents, if it may be one; None for a
        product."""
        head = self.term(node)
        letter = head
        while letter.op in ("rate", "transpose", "inverse", "power", "star"):
            letter = letter.parts[0]
        if letter.op != SYMBOL:
            return None
        parts = tuple(map(self.term, bracket.parts))
        how = "sure" if letter.text in self.functions else _how(parts, bracket)
        inner = parts[0] if len(parts) == 1 else self.make("tuple", *parts)
        return None if how == "product" else self.make("apply", head, inner, text=how)

    def _joined(self, parts: list[Operation | str]) -> Operation:
        """Returns the product: juxtaposition binds first, then × and similar signs, then the other signs."""
        groups: list[Operation | str] = []
        for part in parts:
            if isinstance(part, str) or not groups or isinstance(groups[-1], str):
                groups.append(part)
            else:
                groups[-1] = self._times(groups[-1], part)
        for signs in (_TIGHT, None):
            done: list[Operation | str] = []
            for part in groups:
                sign = done[-1] if len(done) > 1 else None
                left = done[-2] if len(done) > 1 else None
                is_pair = isinstance(part, Operation) and isinstance(left, Operation)
                if is_pair and isinstance(sign, str) and (signs is None or sign in signs):
                    done[-2:] = [self._signed(sign, left, part)]  # type: ignore[arg-type]
                else:
                    done.append(part)
            groups = done
        found = [part for part in groups if isinstance(part, Operation)]
        return found[0] if len(found) == 1 else self.forest.anything(*found)

    def _signed(self, sign: str, left: Operation, right: Operation) -> Operation:
        is_of_numbers = sign == "×" and not _NUMBERS.isdisjoint((left.op, right.op))  # 2 × 3
        return self.make("mul" if is_of_numbers else _SIGNS.get(sign, "any"), left, right)

    def _times(self, left: Operation, right: Operation) -> Operation:
        """Returns a product; q p q⁻¹ is one operation."""
        if left.op == "mul" and right.op in ("inverse", "star") and right.parts[0] is left.parts[0]:
            return self.make("sandwich", *left.parts)
        return self.make("mul", left, right)


def _letter(leaf: Leaf) -> Leaf:
    return Leaf(leaf.at, "LETTER", f"\\operatorname{{{leaf.name}}}")


def _how(parts: Sequence[Operation], bracket: Bracket) -> str:
    """Returns the shape of a bracket after a letter, which determines how likely it holds arguments."""
    is_lone = all(_is_symbol(part) for part in parts)
    if len(parts) > 1:
        return "sure" if is_lone and bracket.kind == "(" else "tuple"
    if bracket.kind == "[":
        return "skewed" if is_lone else "product"
    if is_lone:
        return "time" if parts[0].text in _TIMES else "lone"
    return "product" if isinstance(core(bracket.parts[0]), Sum) else "unclear"


def _is_symbol(part: Operation) -> bool:
    return part.op == SYMBOL or (part.op == "rate" and part.parts[0].op == SYMBOL)
