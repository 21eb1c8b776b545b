"""Bracket structure to typed terms: names, accents, scripts, fractions, brackets, sums."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import contextmanager
from fractions import Fraction as Rational
from typing import TypeVar

from workbench.language import construct
from workbench.language.errors import Fault, Misfit
from workbench.language.integers import Linear
from workbench.language.names import (
    INDEX_LETTERS,
    Scripts,
    base_name,
    linear,
    literal,
    spell,
    variable_name,
)
from workbench.language.products import product
from workbench.language.signatures import agree
from workbench.language.symbols import SymbolTable
from workbench.language.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Fraction,
    Group,
    Infix,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
)
from workbench.language.terms import IllFormed, Integer, Number, Term, Zero
from workbench.language.types import COVECTOR, TENSOR, VECTOR

Result = TypeVar("Result")

#: How deep terms may nest; a longer product than this counts as nesting too.
DEEPEST_TERM = 120
_LONGEST_NUMBER = 100
_ZEROS = {("3", "3"): TENSOR, ("3", "1"): VECTOR, ("1", "3"): COVECTOR}
_COUNTING = ("C", "\\mathbf{C}", "\\mathrm{C}")


class Elaborator:
    """Reads the nodes of one formula. `variables` are the integer variables in scope."""

    def __init__(self, table: SymbolTable, variables: frozenset[str]) -> None:
        self.table = table
        self.variables = variables
        self.depth = 0

    def build(self, at: int, make: Callable[..., Result], *arguments) -> Result:
        """make(*arguments), with the place `at` put on what does not fit."""
        try:
            return make(*arguments)
        except IllFormed as fault:
            raise Misfit(fault, at) from None

    def apply(self, at: int, head: str, *arguments: Term) -> Term:
        return self.build(at, construct.apply, head, *arguments)

    @contextmanager
    def bound(self, names: Sequence[str], at: int):
        for name in names:
            if name in self.variables or names.count(name) > 1:
                raise Fault(f"the summation variable {name} already has a meaning here", at)
        outer, self.variables = self.variables, self.variables.union(names)
        yield
        self.variables = outer

    def term(self, node: Node) -> Term:
        self.depth += 1
        if self.depth > DEEPEST_TERM:
            raise Fault(f"the formula nests deeper than {DEEPEST_TERM}", node.at)
        result = self._term(node)
        self.depth -= 1
        return result

    def _term(self, node: Node) -> Term:
        value = self.integer_expression(node)
        if value is not None:
            return value
        match node:
            case Sum():
                return self.sum(node)
            case Product():
                return product(self, node.items)
            case Leaf(kind="NUMBER"):
                return self.number(node)
            case Leaf(kind="FUNCTION") | Scripted(nucleus=Leaf(kind="FUNCTION")) | Summation():
                return product(self, (node,))
            case Leaf() | Styled() | Accented() | Scripted():
                term, sup = self.named(node, Scripts())
                return term if sup is None else self.raised(term, sup)
            case Group(parts=(part,)):
                return self.term(part)
            case Group():
                raise Fault("expected one expression in the braces", node.at)
            case Bracket():
                return self.bracket(node)
            case Fraction():
                return self.fraction(node)
            case Binomial():
                top, bottom = self.integer(node.top), self.integer(node.bottom)
                return construct.counting("binomial", top, bottom)
            case Matrix():
                rows = [[self.term(entry) for entry in row] for row in node.rows]
                return self.build(node.at, construct.block, rows)
            case Chain(relations=((sign, at), *_)):
                raise Fault(f"a relation ({sign}) inside an expression", at)
            case Chain() | Conditional() | Lines():
                raise Fault("expected an expression, not a statement", node.at)
        raise Fault("a sign without its operands", node.at)

    # integers and numbers

    def integer_expression(self, node: Node) -> Term | None:
        """n, n+1, 2k − 1 as one integer; numbers alone are left to `number` and `sum`."""
        if isinstance(node, Leaf | Scripted | Sum | Product):
            value = _linear_or_none(node, self.variables)
            if value is not None and not value.is_number:
                for name in value.variables:
                    if name in self.table.symbols:
                        raise Fault(f"{name} is an integer variable and a declared symbol", node.at)
                return construct.integer(value)
        return None

    def integer(self, node: Node) -> Linear:
        value = linear(node, self.variables)
        if value is None:
            raise Fault(f"expected an integer expression{self.hint(node)}", node.at)
        return value

    def hint(self, node: Node) -> str:
        known = ", ".join(sorted(self.variables)) or "none"
        return f"; integer variables known here: {known}"

    def number(self, node: Leaf) -> Term:
        if len(node.text) > _LONGEST_NUMBER:
            raise Fault(f"a number of {len(node.text)} digits; at most {_LONGEST_NUMBER}", node.at)
        value = Rational(node.text)
        return construct.number(value) if value else construct.zero()

    # sums and brackets

    def sum(self, node: Sum) -> Term:
        addends, places = [], []
        for sign, at, addend in node.addends:
            term = self.term(addend)
            if sign == "-":
                literal_number = isinstance(term, Number) and not isinstance(addend, Bracket | Group)
                if not addends and literal_number:
                    term = construct.number(-term.value)
                elif not addends and isinstance(term, Integer):
                    term = construct.integer(-term.value)
                else:
                    term = self.apply(at, "neg", term)
            addends.append(term)
            places.append(at)
        if len(addends) == 1:
            return addends[0]
        try:
            return construct.apply("add", *addends)
        except IllFormed as fault:
            raise Misfit(fault, places[_first_that_differs(addends)]) from None

    def bracket(self, node: Bracket) -> Term:
        terms = [self.term(part) for part in node.parts]
        if node.kind in ("|", "\\|") and len(terms) == 1:
            return self.apply(node.at, "norm", terms[0])
        if len(terms) == 1 and node.kind != "\\langle":
            return terms[0]
        if len(terms) == 3 and node.kind in ("(", "\\langle"):
            return self.apply(node.at, "triple", *terms)
        raise Fault(f"{len(terms)} expressions between brackets; a triple product has three", node.at)

    def fraction(self, node: Fraction) -> Term:
        numerator, denominator = self.term(node.numerator), self.term(node.denominator)
        if isinstance(numerator, Number | Zero) and isinstance(denominator, Number) and _literals(node):
            top = numerator.value if isinstance(numerator, Number) else 0
            return construct.number(Rational(top) / denominator.value) if top else construct.zero()
        if isinstance(denominator, Zero):
            raise Fault("division by zero", node.denominator.at)
        return self.apply(node.at, "div", numerator, denominator)

    # names, accents and scripts

    def named(self, node: Node, scripts: Scripts, bracket: Bracket | None = None) -> tuple[Term, Node | None]:
        """The term of a letter under accents and fonts, and the superscript that is no part of its name."""
        return self._named(node, scripts, (), bracket)

    def _named(self, node, scripts: Scripts, styles, bracket) -> tuple[Term, Node | None]:
        match node:
            case Leaf():
                return self.symbol(node, styles, scripts, bracket)
            case Styled():
                return self._named(node.body, scripts, (*styles, node.style), bracket)
            case Accented():
                term, sup = self._named(node.body, scripts, styles, bracket)
                return self.accent(node, term), sup
            case Scripted(factorial=True):
                return self.factorial(node), scripts.sup
            case Scripted():
                return self._scripted(node, scripts, styles, bracket)
            case Group(parts=(part,)) if _is_name(part) or styles:
                return self._named(part, scripts, styles, bracket)
        if styles:
            raise Fault(f"{styles[-1]} of more than one symbol", node.at)
        if scripts.sub is not None or scripts.left_sub is not None or scripts.left_sup is not None:
            raise Fault("a subscript on an expression; indices belong to symbols", node.at)
        if scripts.primes:
            raise Fault("a prime on an expression", node.at)
        return self.term(node), scripts.sup

    def _scripted(self, node: Scripted, outer: Scripts, styles, bracket) -> tuple[Term, Node | None]:
        if node.sub is not None and outer.sub is not None:
            raise Fault("a second subscript", outer.sub.at)
        scripts = Scripts(
            outer.left_sub,
            outer.left_sup,
            node.sub if node.sub is not None else outer.sub,
            node.sup if node.sup is not None else outer.sup,
            node.primes + outer.primes,
        )
        term, sup = self._named(node.nucleus, scripts, styles, bracket)
        if node.sup is not None and outer.sup is not None:
            return (term if sup is None else self.raised(term, sup)), outer.sup
        return term, sup

    def symbol(self, leaf: Leaf, styles, scripts: Scripts, bracket) -> tuple[Term, Node | None]:
        base = base_name(styles, leaf.text)
        for sup, tried in ((None, scripts), (scripts.sup, scripts.without_sup())):
            pieces = spell(base, tried, self.variables)
            if pieces is None:
                continue
            if bracket is not None and (found := self.table.find(pieces, function=True)) is not None:
                arguments = [self.term(part) for part in bracket.parts]
                return self.build(leaf.at, construct.symbol, *found, arguments), sup
            if (found := self.table.find(pieces)) is not None:
                return self.build(leaf.at, construct.symbol, *found), sup
        builtin = self.builtin(base, scripts)
        if builtin is not None:
            return builtin
        if leaf.kind == "MARK":
            raise Fault(f"{leaf.text} cannot stand here", leaf.at)
        raise Fault(self.unknown(base, scripts), leaf.at)

    def builtin(self, base: str, scripts: Scripts) -> tuple[Term, Node | None] | None:
        """I, 0, ε, D, e^x and C_n^k, where the paper declares no symbol of that name."""
        if scripts.left_sub or scripts.left_sup or scripts.primes:
            return None
        if base in _COUNTING and scripts.sub is not None and scripts.sup is not None:
            return self.combinations(scripts), None
        if base.endswith("{0}") or base.endswith("{0}}"):
            return self.zero(scripts), scripts.sup
        if scripts.sub is not None:
            return None
        match base:
            case "\\mathbf{I}" | "\\underline{\\mathbf{I}}" | "\\boldsymbol{I}":
                return construct.identity(), scripts.sup
            case "\\varepsilon":
                return construct.dual_unit(), scripts.sup
            case "\\mathbf{D}":
                return construct.time_operator(), scripts.sup
            case "e" | "\\mathrm{e}" if scripts.sup is not None:
                return self.apply(scripts.sup.at, "exp", self.term(scripts.sup)), None
        return None

    def zero(self, scripts: Scripts) -> Term:
        """𝟎 is the zero vector; 𝟎_{3×3} is the zero tensor. Beside other terms it takes their kind."""
        if scripts.sub is None:
            return construct.zero(VECTOR)
        match scripts.sub:
            case Group(parts=(Product(items=(Leaf() as rows, Infix(operator="×"), Leaf() as columns)),)):
                kind = _ZEROS.get((rows.text, columns.text))
                if kind is not None:
                    return construct.zero(kind)
        raise Fault("expected the shape of the zero as 3\\times 3 or 1\\times 3", scripts.sub.at)

    def unknown(self, base: str, scripts: Scripts) -> str:
        pieces = spell(base, scripts, self.variables) or spell(base, scripts.without_sup(), self.variables)
        if pieces is None:
            return f"unknown symbol {base}"
        guessed = spell(base, scripts, INDEX_LETTERS | self.variables)
        if guessed is None or self.table.find(guessed) is None:
            guessed = spell(base, scripts.without_sup(), INDEX_LETTERS | self.variables)
        if guessed is not None and self.table.find(guessed) is not None:
            letters = set().union(*(g.variables for g in guessed if isinstance(g, Linear))) - self.variables
            return f"the integer variable {', '.join(sorted(letters))} in {literal(guessed)} has no range here"
        return self.table.unknown(pieces)

    def accent(self, node: Accented, term: Term) -> Term:
        if node.accent != "~":
            return self.build(node.at, construct.derivative, term, int(node.accent))
        if term.type.kind != "tensor":
            return self.apply(node.at, "skew", term)
        intent = "the tilde over a whole product T x, \\widetilde{T x}"
        raise Misfit(IllFormed("expected a vector under the tilde, got a tensor", intent), node.at)

    def factorial(self, node: Scripted) -> Term:
        if node.sub is not None or node.sup is not None:
            if node.sup is not None or variable_name(_plain(node)) is None:
                raise Fault("the factorial of what? bracket it", node.at)
            return construct.counting("factorial", self.integer(_plain(node)))
        return construct.counting("factorial", self.integer(node.nucleus))

    def combinations(self, scripts: Scripts) -> Term:
        top = self.integer(scripts.sub)
        parts = scripts.sup.parts if isinstance(scripts.sup, Group) else (scripts.sup,)
        lower = [self.integer(part) for part in parts]
        return construct.counting("binomial" if len(lower) == 1 else "multinomial", top, *lower)

    def raised(self, term: Term, sup: Node) -> Term:
        """term^sup: transpose, adjugate, inverse, derivative of an order, or power."""
        inner = sup.parts[0] if isinstance(sup, Group) and len(sup.parts) == 1 else sup
        match inner:
            case Leaf(kind="LETTER" | "MARK", text="T"):
                return self.apply(sup.at, "transpose", term)
            case Leaf(kind="MARK", text="*"):
                return self.apply(sup.at, "adjugate", term)
            case Bracket(kind="(", parts=(order,)):
                return self.build(sup.at, construct.derivative, term, self.integer(order))
        exponent = linear(inner, self.variables)
        if exponent is None:
            known = "an integer, -1, T, *, or an order in round brackets"
            raise Fault(f"expected {known} as superscript{self.hint(inner)}", sup.at)
        if exponent.is_number and exponent.constant < 0:
            base = term if exponent.constant == -1 else self.build(sup.at, construct.power, term, -exponent)
            return self.apply(sup.at, "inverse", base)
        return self.build(sup.at, construct.power, term, exponent)

    # sums over integers

    def summation(self, node: Summation, body: Callable[[], Term]) -> Term:
        """Σ_{k=a}^{b} or Σ_{k₁+k₂=k} of the body, which is read with the variables in scope."""
        lower = node.lower.parts[0] if isinstance(node.lower, Group) and node.lower.parts else node.lower
        if not isinstance(lower, Chain) or [sign for sign, _ in lower.relations] != ["="]:
            raise Fault("expected the bounds of the sum, as in \\sum_{k=0}^{n}", node.at)
        left, right = lower.sides
        single = variable_name(left)
        if single is not None:
            if node.upper is None:
                raise Fault("the sum has no upper bound", node.at)
            names, start, end = [single], self.integer(right), self.upper_bound(node.upper)
        else:
            if node.upper is not None:
                raise Fault("a sum over k_1 + k_2 + … = k has no upper bound", node.upper.at)
            names, start, end = self.parts_of(left), None, self.integer(right)
        with self.bound(names, node.at):
            term = body()
        return self.build(node.at, construct.big_sum, names, start, end, term)

    def upper_bound(self, node: Node) -> Linear:
        inner = node.parts[0] if isinstance(node, Group) and len(node.parts) == 1 else node
        if isinstance(inner, Leaf) and inner.text == "∞":
            raise Fault("an infinite sum; sums have integer bounds", node.at)
        return self.integer(node)

    def parts_of(self, node: Node) -> list[str]:
        names = [variable_name(addend) for _, _, addend in node.addends] if isinstance(node, Sum) else [None]
        if None in names or any(sign == "-" for sign, _, _ in node.addends):
            raise Fault("expected summation variables, as in k_1 + k_2 = k", node.at)
        return names


def _linear_or_none(node: Node, variables: frozenset[str]) -> Linear | None:
    try:
        return linear(node, variables)
    except Fault:
        return None


def _literals(node: Fraction) -> bool:
    """Whether both parts are written as numbers, so that the fraction is one."""
    top, bottom = (
        part.parts[0] if isinstance(part, Group) and len(part.parts) == 1 else part
        for part in (node.numerator, node.denominator)
    )
    if isinstance(top, Sum) and len(top.addends) == 1:
        top = top.addends[0][2]
    return isinstance(top, Leaf) and isinstance(bottom, Leaf)


def _is_name(node: Node) -> bool:
    return isinstance(node, Leaf | Styled | Accented | Scripted) and not (
        isinstance(node, Leaf) and node.kind != "LETTER"
    )


def _plain(node: Scripted) -> Scripted:
    return Scripted(node.at, node.nucleus, node.sub)


def _first_that_differs(addends: Sequence[Term]) -> int:
    for count in range(2, len(addends) + 1):
        try:
            agree(addends[:count], "the addends")
        except IllFormed:
            return count - 1
    return 0
