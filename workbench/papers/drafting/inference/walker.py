"""From the bracket tree of a formula to its operations: symbols, scripts, brackets and fractions."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from workbench.core.names import Name
from workbench.language.elaboration.operators.derivatives_of_maps import has_differentials
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Fraction,
    Given,
    Group,
    Infix,
    Joined,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    both_below,
    core,
    in_a_row,
    is_left_script,
)
from workbench.language.naming.spelling import Scripts, spell, spell_label, under_accent
from workbench.papers.drafting.inference.kind_operations import MARKED, SYMBOL, UNIT, Forest, Operation
from workbench.papers.drafting.inference.rows import RowWalker
from workbench.papers.drafting.typefaces import flat

_FACE = r"(?:\\(?:math(?:bf|bb|ds|rm|cal|sf)|boldsymbol))"
IDENTITY = re.compile(rf"{_FACE}(?:I|1|Id)_?(?:([2-9])(?:\\times\d)?)?|[IE]_([2-9])(?:\\times\d)?|I")
_COUNTS = re.compile(rf"{_FACE}?[IE]_(?:[01ij]|[xyz]{{1,2}})")
ZERO = re.compile(rf"{_FACE}?[0O]_?(?:(\d)(?:\\times(\d))?)?")
_TRANSPOSES = frozenset(("T", "\\mathrmT", "\\mathsfT", "\\mathttT", "-T", "t"))
#: Superscripts that are labels, not powers.
_LABEL = re.compile(
    r"\\math(?:scr|cal|frak|rm|sf|bf)|[A-SU-Z]|\\dagger|[+\-](?![\d\w])"
    r"|\\(?:ominus|oplus|star|prime|flat|sharp)|\("
)
#: Superscripts that are operations.
_OPERATIONS = {
    **dict.fromkeys(_TRANSPOSES, "transpose"),
    "-1": "inverse",
    **dict.fromkeys(("\\wedge", "∧", "\\times", "×", "\\land"), "skew"),
    **dict.fromkeys(("\\vee", "∨", "\\lor"), "vect"),
    **dict.fromkeys(("*", "\\ast", "\\star"), "star"),
}
#: Marks over two letters that make one name: the arrow from A to B.
_OVER_POINTS = ("\\vec", "\\overline", "\\underline")
_CROSSES = ("\\times", "×", "\\wedge", "∧", "x")
#: Relations, and the operations that they state of their sides.
_RELATIONS = {
    **dict.fromkeys(("=", "≈", "≠", ":="), "equal"),
    **dict.fromkeys((">", "≥", "<", "≤"), "compare"),
    **dict.fromkeys(("\\perp", "\\parallel"), "directions"),
}


class Walker(RowWalker):
    """Converts formulas to operations of one forest.

    Attributes:
        marks_over_several: Marks over more than one letter, which are not part of a name.
        labels: Letters with a frame on their left whose superscript T is a label.
        counted: Letters like those of unit tensors whose indices number quantities, as I_1, I_2, I_3.
        labelled: Letters with a frame on their left that have another label.
        transposed: Letters with a frame on their left that have the superscript T.
    """

    def __init__(
        self,
        labels: Collection[str] = (),
        counted: Collection[str] = (),
        has_differentials: bool = False,
        functions: Collection[str] = (),
        maps: Collection[tuple[str, str]] = (),
    ) -> None:
        super().__init__(Forest(), has_differentials, functions, maps)
        self.marks_over_several: set[str] = set()
        self.labels, self.counted = labels, counted
        self.labelled: set[str] = set()
        self.transposed: set[str] = set()

    def statement(self, node: Node) -> list[Operation]:
        """Returns the operations that the relations of a formula state, or its expressions."""
        match node:
            case Lines():
                return [each for line in node.lines for clause in line for each in self.statement(clause)]
            case Conditional() | Joined():
                return [each for part in node.statements for each in self.statement(part)]
            case Given():
                return [each for part in node.conditions for each in self.statement(part)]
            case Chain():
                self.shows_differentials = has_differentials(node)
                pairs = zip(node.relations, node.sides, node.sides[1:], strict=False)
                return [made for (sign, _), *sides in pairs for made in self._related(sign, *sides)]
        return [self.make("said", self.term(node))]

    def _related(self, sign: str, left: Node, right: Node) -> list[Operation]:
        if sign == "∈":
            return [self.make("member", self.term(left), text=flat(plain(right)))]
        match core(left):
            case Product(items=(name, Bracket(kind="(", parts=(at,)))) if sign == "=":
                self.defined_maps.add((latex_of(name), latex_of(at)))
        relation = _RELATIONS.get(sign)
        return [self.make(relation, self.term(left), self.term(right))] if relation else []

    def term(self, node: Node | None) -> Operation:
        """Returns the operation of a node."""
        inner = core(node)
        if inner is None:
            return self.forest.anything()
        if (lettered := self._lettered(inner)) is not None:
            return lettered
        match inner:
            case Leaf(kind="NUMBER"):
                return self.make("number", text=inner.text)
            case Leaf(kind="FUNCTION"):
                return self.forest.symbol(f"\\operatorname{{{inner.name}}}")
            case Sum():
                return self.make("add", *(self.term(each) for _, _, each in inner.addends))
            case Product():
                return self.row(inner.items)
            case Fraction():
                return self._fraction(inner)
            case Binomial():
                return self.make("number", text="n")
            case Matrix():
                return self._matrix(inner)
            case Bracket():
                return self._bracket(inner)
            case Styled() | Accented():
                return self._over_several(inner)
            case Scripted():
                return self.raised(self.term(inner.nucleus), inner)
            case Group(parts=parts) if len(parts) > 1:
                return self.make("tuple", *map(self.term, parts))
        return self.forest.anything()

    def symbol(self, name: str) -> Operation:
        """Returns the symbol of this name; unit and zero tensors are recognized by their letters."""
        bare = flat(name)
        if bare == "I":
            return self.make(UNIT, text=name)
        if IDENTITY.fullmatch(bare) and stem_of(bare) not in self.counted:
            return self.make("identity", text=name)
        if ZERO.fullmatch(bare):
            return self.make("zero", text=bare)
        return self.forest.symbol(name)

    # ------------------------------------------------------------------------------------- one letter

    def _lettered(self, node: Node, left: Scripts | None = None) -> Operation | None:
        """Returns a letter with its marks and scripts as operations on a symbol; None for other nodes."""
        styles: list[str] = []
        scripts, powers, has_dots = left or Scripts(), [], False
        while not isinstance(node, Leaf):
            match node:
                case Group(parts=(part,)):
                    node = part
                case Styled():
                    if node.style in _OVER_POINTS and (pair := under_accent(node)) is not None:
                        return self.forest.symbol(str(pair.name))
                    styles.append(node.style)
                    node = node.body
                case Accented():
                    styles += ["\\tilde"] if node.accent == "~" else []
                    has_dots = has_dots or node.accent != "~"
                    node = node.body
                case Scripted(factorial=False):
                    power = self._power_of(node)
                    powers += [(power, node)] if power else []
                    sup = None if power else node.sup
                    scripts = replace(
                        scripts,
                        sub=both_below(node.sub, scripts.sub),
                        sup=scripts.sup if sup is None else sup,
                        primes=scripts.primes + node.primes,
                    )
                    node = node.nucleus
                case _:
                    return None
        if node.kind not in ("LETTER", "MARK") and not (node.kind == "NUMBER" and styles):
            return None
        return self._marked(node, styles, scripts, powers, has_dots)

    def _marked(
        self,
        letter: Leaf,
        styles: Sequence[str],
        scripts: Scripts,
        powers: Sequence[tuple[str, Scripted]],
        has_dots: bool,
    ) -> Operation:
        if letter.text == "e" and not styles and powers and scripts == Scripts() and powers[0][0] == "power":
            return self.make("exp", self.term(powers[0][1].sup))
        made = self._named(letter.text, styles, scripts)
        if scripts.left_sup is not None:
            bare = str(self._named(letter.text, styles, scripts.without_sup()))
            if scripts.sup is not None:
                self.labelled.add(bare)
            for index, (power, node) in enumerate(powers):
                if power == "transpose" and letter.text.islower():
                    self.transposed.add(bare)
                    if bare in self.labels:
                        rest = [*powers[:index], *powers[index + 1 :]]
                        return self._marked(letter, styles, replace(scripts, sup=node.sup), rest, has_dots)
        mark = next((style for style in styles if style in ("\\tilde", "\\hat")), None)
        if mark is not None and made.op == SYMBOL:
            inner = self._named(letter.text, [style for style in styles if style != mark], scripts)
            made = self.make(MARKED, inner, text=made.text)
        made = self.make("rate", made) if has_dots else made
        for power, node in reversed(powers):
            made = self._powered(made, power, node)
        return made

    def _named(self, letter: str, styles: Sequence[str], scripts: Scripts) -> Operation:
        spelled = spell(Name.styled(styles, letter), scripts, ())
        return self.forest.anything() if spelled is None else self.symbol(str(spelled.exact))

    def prefixed(self, left: Scripted, node: Node) -> Operation | None:
        """Returns the letter with its left scripts as part of its name."""
        return self._lettered(node, Scripts(left_sub=left.sub, left_sup=left.sup))

    # ---------------------------------------------------------------------------------------- scripts

    def _power_of(self, node: Scripted) -> str | None:
        """Returns the operation of a superscript; None for a label, which is part of a name."""
        if node.sup is None:
            return None
        sup = flat(plain(node.sup))
        if sup in _OPERATIONS:
            return _OPERATIONS[sup]
        if re.fullmatch(r"-?\d+(?:/\d+)?", sup):
            return "power"
        is_e = isinstance(node.nucleus, Leaf) and node.nucleus.text == "e"
        if not is_e and (_LABEL.match(sup) or isinstance(core(node.sup), Leaf)):
            return None
        return "power"

    def raised(self, inner: Operation, node: Scripted) -> Operation:
        """Returns a bracket or a function with the operations of its scripts applied."""
        sub = flat(plain(node.sub))
        if isinstance(node.nucleus, Bracket):
            if sub in _CROSSES:
                inner = self.make("skew", self.term(node.nucleus.parts[0]))
            elif re.fullmatch(r"[1-3xyz]{1,2}", sub):
                return self.make("component", inner)
        power = self._power_of(node)
        return inner if power is None else self._powered(inner, power, node)

    def _powered(self, inner: Operation, power: str, node: Scripted) -> Operation:
        text = flat(plain(node.sup)) if power == "power" else ""
        return self.make(power, inner, text=text)

    # ----------------------------------------------------------------------------- brackets, fractions

    def _over_several(self, node: Styled | Accented) -> Operation:
        """Returns the operation of a mark over several letters."""
        body = self.term(node.body)
        mark = ("\\tilde" if node.accent == "~" else "") if isinstance(node, Accented) else node.style
        if mark not in ("\\tilde", "\\hat"):
            return self.make("rate", body) if isinstance(node, Accented) else body
        self.marks_over_several.add(mark)
        return self.make("skew", body)

    def _bracket(self, node: Bracket) -> Operation:
        if len(node.parts) == 1 and (crossed := _before_a_cross(node.parts[0])) is not None:
            return self.make("skew", self.term(crossed))
        parts = tuple(map(self.term, node.parts))
        if node.kind in ("|", "\\|"):
            return self.make("norm", *parts)
        if node.kind == "\\langle" and len(parts) != 3:
            return self.make("inner", *parts)
        if node.kind == "\\{":
            return self.forest.anything(*parts)
        if node.kind == "[" and len(parts) == 1 and parts[0].op in (SYMBOL, MARKED):
            return self.make("bracketed", *parts)
        return parts[0] if len(parts) == 1 else self.make("tuple", *parts)

    def _matrix(self, node: Matrix) -> Operation:
        width = max(map(len, node.rows))
        cells = [
            self.term(row[index]) if index < len(row) else self.make("zero", text="0")
            for row in node.rows
            for index in range(width)
        ]
        return self.make("matrix", *cells, text=f"{len(node.rows)} {width}")

    def _fraction(self, node: Fraction) -> Operation:
        top, bottom = _factors(node.numerator), _factors(node.denominator)
        while top and is_left_script(top[0]):
            top = top[1:]
        if top and len(bottom) > 1 and _is_differential(top[0]) and _is_differential(bottom[0]):
            place = self.row(bottom[1:2])
            if len(top) == 1:
                return self.make("operator", place)
            return self.make("partial", self.row(top[1:]), place)
        return self.make("div", self.term(node.numerator), self.term(node.denominator))


def _before_a_cross(part: Node) -> Node | None:
    """Returns the a of (a ×), and the a + b of [a + b ×]; None for other contents of a bracket."""
    match core(part):
        case Product(items=(*factors, Infix(operator="×"))) if factors:
            return in_a_row(part.at, factors)
        case Sum(addends=(*before, (sign, at, last))) if (inner := _before_a_cross(last)) is not None:
            return Sum(part.at, (*before, (sign, at, inner)))
    return None


def stem_of(name: str) -> str:
    """Returns the name without its index."""
    return flat(name).partition("_")[0]


def counted_letters(names: Iterable[str], inertias: Iterable[str] = ()) -> frozenset[str]:
    """Returns the letters I and E in any face whose indices number quantities, and no sizes.

    So it is if one of the names has an index that is no size, or words say that one is an inertia.
    """
    numbered = (flat(name) for name in names)
    return frozenset(map(stem_of, (*filter(_COUNTS.fullmatch, numbered), *inertias)))


def plain(node: Node | None) -> str:
    """Returns a script as written, without blanks; "?" for parts that no label has."""
    if node is None:
        return ""
    inner = core(node)
    if isinstance(inner, Fraction):
        return f"{plain(inner.numerator)}/{plain(inner.denominator)}"
    if isinstance(inner, Sum):
        return "".join(sign + plain(each) for sign, _, each in inner.addends)
    return spell_label(node) or "?"


def _factors(node: Node) -> list[Node]:
    inner = core(node)
    return list(inner.items) if isinstance(inner, Product) else [] if inner is None else [inner]


def _is_differential(node: Node) -> bool:
    inner = core(node)
    while isinstance(inner, Scripted | Styled):
        inner = core(inner.nucleus if isinstance(inner, Scripted) else inner.body)
    return isinstance(inner, Leaf) and inner.text in ("d", "\\partial", "\\delta", "D")
