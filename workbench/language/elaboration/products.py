"""What stands in a row: factors, functions and what they take, d/dt, and the signs · × ⊗ ∘ between them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from workbench.language import construct
from workbench.language.declarations import key_spelling
from workbench.language.elaboration.determinants import of_vectors
from workbench.language.elaboration.infixes import infix
from workbench.language.elaboration.letters import letter, raised
from workbench.language.elaboration.quotients import Rate, divided, quotient, rate, slope, value_of
from workbench.language.elaboration.spelled import spelled_out
from workbench.language.elaboration.summations import summation
from workbench.language.errors import Fault, Misfit, SpecError
from workbench.language.integers import Linear
from workbench.language.operators import GRADIENTS, OF_ANGLES, OF_TENSORS, word_of
from workbench.language.scope import Scope
from workbench.language.spelling import Scripts, linear
from workbench.language.syntax import (
    Accented,
    Bracket,
    Fraction,
    Group,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    Summation,
    in_a_row,
    is_left_script,
)
from workbench.language.terms import (
    Apply,
    Derivative,
    IllFormed,
    Integer,
    Number,
    Symbol,
    Term,
    TimeOperator,
    is_accented_symbol,
    is_rate,
)

_DIFFERENTIATE = GRADIENTS | {"d/dt", "the operator"}


def product(scope: Scope, items: Sequence[Node]) -> Term:
    """Factors and infix signs. Juxtaposition binds tighter than signs; \\sum takes all that follows."""
    rows: list[list[Node]] = [[]]
    signs: list[Infix] = []
    for place, item in enumerate(items := spelled_out(scope, items)):
        if isinstance(item, Infix):
            if not rows[-1]:
                raise Fault(f"nothing before {item.operator}", item.at)
            signs.append(item)
            rows.append([])
        elif isinstance(item, Summation):
            rows[-1].append(Product(item.at, tuple(items[place:])))
            break
        else:
            rows[-1].append(item)
    if not rows[-1]:
        raise Fault(f"nothing after {signs[-1].operator}", signs[-1].at)
    if any(sign.operator == "/" for sign in signs):
        return _solidus(scope, rows, signs)
    return _joined(scope, [_Row(scope, row) for row in rows], signs)


def _joined(scope: Scope, rows: Sequence[_Row], signs: list[Infix]) -> Term:
    operands = [row.term() for row in rows]
    for row, sign, operand in zip(rows, signs, operands[1:], strict=False):
        _refuse_reach(row, sign, operand)
    while signs and _is_vect_of_product(rows[0].items, operands, signs[0]):
        inside = scope.apply(signs[0].at, "mul", *operands[0].children, operands.pop(1))
        operands[0] = scope.apply(signs.pop(0).at, "vect", inside)
    return infix(scope, operands, signs)


def _solidus(scope: Scope, rows: Sequence[Sequence[Node]], signs: Sequence[Infix]) -> Term:
    """a b/c with nothing behind c: whichever of the factors is divided, it is the same."""
    *others, solidus = signs
    if solidus.operator != "/" or any(sign.operator == "/" for sign in others):
        raise Fault("what is divided by what? write \\frac{…}{…}", solidus.at)
    *above, below = rows
    if not others:
        fraction = Fraction(above[0][0].at, in_a_row(above[0][0].at, above[0]), in_a_row(below[0].at, below))
        numerals = all(isinstance(part, Leaf) and _is_numeral(part) for part in (*above[0], *below))
        if numerals or rate(scope, fraction) is not None:
            return _Row(scope, [fraction]).term()
    dividend, divisor = [_Row(scope, row) for row in above], _Row(scope, below)
    numerator, denominator = _joined(scope, dividend, others), divisor.term()
    is_one = divisor.factor(0).end == len(below) and (len(below) < 3 or not divisor.open_head)
    if dividend[-1].open_head or not is_one:
        raise Fault("how far does / reach? write \\frac{…}{…}", solidus.at)
    return divided(scope, (solidus.at, below[0].at), numerator, denominator)


def _refuse_reach(row: _Row, sign: Infix, operand: Term) -> None:
    """d/dt a × b, curl a × b, det A · B: whatever takes a may also take a × b, unless a is bracketed."""
    head = row.open_head
    takes_tensors = head in OF_TENSORS - {"vect"} and sign.operator == "·" and operand.type.kind == "tensor"
    takes_parts = head in ("re", "du") and operand.type.dual
    if takes_tensors or takes_parts or head in _DIFFERENTIATE:
        raise Fault(f"how far does {word_of(head)} reach? bracket its argument", row.items[0].at)


def _is_vect_of_product(row: Sequence[Node], operands: Sequence[Term], sign: Infix) -> bool:
    """Whether vect A · B is meant as vect (A · B): with a tensor B it has no other meaning."""
    unbracketed = isinstance(row[0], Leaf) and row[0].text == "vect" and not isinstance(row[1], Bracket)
    is_vect = isinstance(operands[0], Apply) and operands[0].head == "vect"
    return unbracketed and is_vect and sign.operator == "·" and operands[1].type.kind == "tensor"


@dataclass(slots=True)
class _Factor:
    term: Term
    at: int
    end: int  # the item after it
    node: Node


class _Row:
    """Factors in juxtaposition."""

    def __init__(self, scope: Scope, items: Sequence[Node]) -> None:
        self.scope = scope
        self.items = items
        self.known: dict[int, _Factor] = {}
        self.open_head = ""  # what ends the row with an argument that is not bracketed

    def term(self) -> Term:
        factors, place = [], 0
        while place < len(self.items):
            factor = self.factor(place)
            factors.append(factor)
            place = factor.end
        return self.multiply(factors)

    def multiply(self, factors: Sequence[_Factor]) -> Term:
        result = factors[0].term
        for place, factor in enumerate(factors[1:], start=1):
            term = factor.term
            if _is_numeral(factors[place - 1].node) and _is_numeral(factor.node):
                raise Fault("two numbers side by side are printed as one; write \\cdot", factor.at)
            is_fraction = isinstance(factor.node, Fraction) and isinstance(term, Number)
            if _is_numeral(factors[place - 1].node) and is_fraction:
                raise Fault("a mixed number or a product? write \\cdot for the product", factor.at)
            if result.type.kind == "operator" and term.type.kind not in ("operator", "scalar"):
                self.operand(factor, factors[place + 1 :])
            if place == 1 and _is_integer(factors[0]) and isinstance(term, Integer) and _is_bare(factor.node):
                result = construct.integer(term.value * int(result.value))
            else:
                result = self.scope.apply(factor.at, "mul", result, term)
        return result

    def operand(self, factor: _Factor, more: Sequence[_Factor]) -> None:
        """An operator acts on the factor; refused where it may act on more than that."""
        if isinstance(factor.node, Bracket):
            return
        if any(other.term.type.kind != "scalar" for other in more):
            raise Misfit(IllFormed("how far does the operator reach? bracket what it acts on"), factor.at)
        self.open_head = "the operator"
        if factor.term.type.kind == "tensor":
            self.scope.tensor_operand = factor.at

    def factor(self, place: int) -> _Factor:
        """The factor that begins at an item: read once, however often it is looked at."""
        if place not in self.known:
            with self.scope.nested(self.items[place].at):
                self.known[place] = self._factor(place)
        return self.known[place]

    def _factor(self, place: int) -> _Factor:
        item = self.items[place]
        if (term := self.scope.written(item)) is not None:
            return _Factor(term, item.at, place + 1, item)
        match item:
            case Product(items=(Summation() as head, *rest)):
                term = summation(self.scope, head, lambda: self._body(head, rest))
                return _Factor(term, item.at, place + 1, item)
            case Summation():
                raise Fault("the sum has no body", item.at)
            case Leaf(kind="FUNCTION") | Scripted(nucleus=Leaf(kind="FUNCTION")):
                return self.function(place)
            case Fraction():
                found = rate(self.scope, item)
                if found is not None:
                    return self.derivative(place, found)
                return _Factor(quotient(self.scope, item), item.at, place + 1, item)
            case Scripted(nucleus=Group(parts=())):
                return self.with_left_scripts(place)
            case Leaf(kind="LETTER") | Styled() | Accented() | Scripted():
                return self.name(place, item, Scripts())
        return _Factor(self.scope.term(item), item.at, place + 1, item)

    def _body(self, head: Summation, rest: Sequence[Node]) -> Term:
        if not rest:
            raise Fault("the sum has no body", head.at)
        return product(self.scope, rest)

    def with_left_scripts(self, place: int) -> _Factor:
        left = self.items[place]
        following = self.items[place + 1] if place + 1 < len(self.items) else None
        if isinstance(following, Fraction) and left.sup is not None and left.sub is None:
            found = rate(self.scope, following)
            if found is not None and found.frame is None:
                return self.derivative(place + 1, found._replace(frame=left.sup))
        if place + 1 == len(self.items) or not isinstance(
            self.items[place + 1], Leaf | Styled | Accented | Scripted
        ):
            raise Fault("left scripts must stand before a symbol", left.at)
        return self.name(place + 1, self.items[place + 1], Scripts(left.sub, left.sup))

    def name(self, place: int, item: Node, scripts: Scripts) -> _Factor:
        """A symbol; if it is a function symbol, with its arguments. x(t) is x, P(D) is P."""
        scope = self.scope
        following = self.items[place + 1] if place + 1 < len(self.items) else None
        bracket = following.nucleus if isinstance(following, Scripted) else following
        if not (isinstance(bracket, Bracket) and bracket.kind == "("):
            bracket = None
        plain = not scripts.left_sub and not scripts.left_sup
        if plain and (value := scope.integer_expression(item)) is not None:
            return _Factor(value, item.at, place + 1, item)
        term, sup, takes_bracket = letter(scope, item, scripts, bracket)
        end = place + 1
        if takes_bracket or (bracket is not None and self.is_own_variable(bracket, term)):
            if isinstance(following, Scripted):
                raise Fault("scripts on the argument of a function; bracket the whole", following.at)
            end += 1
        if sup is not None:
            term = raised(scope, term, sup)
        return _Factor(term, item.at, end, item)

    def is_own_variable(self, bracket: Bracket, term: Term) -> bool:
        """Whether the bracket says only what the symbol depends on: x(t), and P(D) for an operator."""
        function = term
        while isinstance(function, Derivative):
            function = function.body
        if isinstance(function, Symbol) and function.declaration.of:
            if all(
                self.is_argument(part) or self.scope.term(part) in function.declaration.of
                for part in bracket.parts
            ):
                return True
            raise Fault(
                "a function at another place than its argument; a product needs no bracket", bracket.at
            )
        if len(bracket.parts) > 1:
            return all(self.scope.is_time(part) or self.is_argument(part) for part in bracket.parts)
        if not bracket.parts:
            return False
        (part,) = bracket.parts
        if term.type.kind == "operator":
            return isinstance(part, Styled) and isinstance(self.scope.term(part), TimeOperator)
        if self.is_argument(part):
            return term.type.kind != "scalar" or self.scope.term(part).type.kind != "scalar"
        if self.scope.is_time(part):
            return True
        lone = is_accented_symbol(term) and isinstance(part, Leaf | Styled | Accented | Scripted)
        if lone and "scalar" in (term.type.kind, self.scope.term(part).type.kind):
            raise Fault(
                "a function of what is in the bracket, or a product? a product needs no bracket", bracket.at
            )
        return False

    def is_argument(self, part: Node) -> bool:
        """Whether the paper says that f(x) is f, which depends on x."""
        if not self.scope.table.arguments:
            return False
        try:
            spelling = key_spelling(part, "")
        except SpecError:
            return False
        return not self.scope.table.arguments.isdisjoint({spelling.exact, spelling.declared()[0]})

    def function(self, place: int) -> _Factor:
        """det, sym, vect … take the run of tensors that follows, the others take one factor."""
        item = self.items[place]
        leaf = item.nucleus if isinstance(item, Scripted) else item
        head = leaf.text
        if (
            leaf.bare
            and leaf.name not in self.scope.table.bare_functions
            and all(self.scope.knows(letter) for letter in leaf.name)
        ):
            message = f"a function and a product of symbols; write \\operatorname{{{leaf.name}}}"
            raise Fault(f"{leaf.name} is {message}", leaf.at)
        if place + 1 == len(self.items):
            raise Fault(f"{word_of(head)} of nothing", leaf.at)
        if head in ("quaternion", "atan2"):
            return self.of_two(leaf, place)
        if head == "root":
            return self.root(leaf, place)
        if head == "det" and item is leaf and (found := of_vectors(self.scope, self.items[place + 1])):
            return _Factor(found, leaf.at, place + 2, item)
        argument, end = self.argument(head, leaf, place + 1)
        if head == "skew" and argument.type.kind == "tensor":
            head = "antisymmetric"
        term = self.scope.build(leaf.at, value_of, head, argument)
        if isinstance(item, Scripted):
            exponent = None if item.sup is None else linear(item.sup, self.scope.variables)
            if item.sub is not None or item.primes or item.factorial or exponent is None:
                raise Fault(f"only a power may stand on {word_of(head)}", item.at)
            if exponent.is_number and exponent.constant < 0:
                raise Fault("an inverse function or an inverse value? bracket the value", item.at)
            term = self.scope.build(item.at, construct.power, term, exponent)
        return _Factor(term, leaf.at, end, item)

    def root(self, leaf: Leaf, place: int) -> _Factor:
        item = self.items[place + 1]
        if not isinstance(item, Group) or self.items[place] is not leaf:
            raise Fault("expected a square root, \\sqrt{x}", leaf.at)
        return _Factor(self.scope.apply(leaf.at, "root", self.scope.term(item)), leaf.at, place + 2, leaf)

    def of_two(self, leaf: Leaf, place: int) -> _Factor:
        """quat(s, x): a scalar part and a vector part; atan2(y, x)."""
        item = self.items[place + 1]
        if not (isinstance(item, Bracket) and len(item.parts) == 2) or self.items[place] is not leaf:
            what = {"atan2": "two scalars, \\operatorname{atan2}(y, x)"}.get(
                leaf.text, "a scalar and a vector, \\operatorname{quat}(s, x)"
            )
            raise Fault(f"expected {what}", leaf.at)
        parts = [self.scope.term(part) for part in item.parts]
        return _Factor(self.scope.apply(leaf.at, leaf.text, *parts), leaf.at, place + 2, leaf)

    def argument(self, head: str, leaf: Leaf, place: int) -> tuple[Term, int]:
        item = self.items[place]
        if isinstance(item, Bracket):
            return self.scope.term(item), place + 1
        if isinstance(item, Scripted) and isinstance(item.nucleus, Bracket | Fraction):
            raise Fault("a power of the function or of its argument? bracket it", item.at)
        first = self.factor(place)
        run, end = [first], first.end
        name = word_of(head)
        self.open_head = head
        if head in OF_TENSORS:
            while end < len(self.items) and first.term.type.kind == "tensor":
                following = self.factor(end)
                if following.term.type.kind != "tensor":
                    break
                run.append(following)
                end = following.end
            return self.multiply(run), end
        numeric = isinstance(first.term, Number | Integer) and head in OF_ANGLES | {"exp"}
        if numeric and end < len(self.items):
            run.append(self.factor(end))
            end = run[-1].end
        if end < len(self.items):
            following = self.factor(end)
            own = isinstance(following.node, Leaf | Scripted) and _is_function(following.node)
            mixes = head not in OF_ANGLES or following.term.type.kind == "scalar"
            if mixes and not own:
                raise Fault(f"how far does {name} reach? bracket its argument", leaf.at)
        return self.multiply(run), end

    def derivative(self, place: int, found: Rate) -> _Factor:
        scope, item = self.scope, self.items[place]
        if found.by:
            return self.differentiated(place, found, lambda body: slope(scope, item.at, found, body, product))
        orders = [
            scope.integer(o) if o is not None else Linear(1) for o in (found.order_above, found.order_below)
        ]
        if orders[0] != orders[1]:
            intent = "one order above and below, \\frac{d^k}{dt^k}"
            fault = IllFormed(f"d/dt of order {orders[0]} above and {orders[1]} below", intent)
            raise Misfit(fault, item.at)
        if place + 1 == len(self.items) and not found.behind:
            if found.frame is not None:
                raise Fault("the derivative in a frame, of what?", item.at)
            operator = construct.time_operator()
            if orders[0] != Linear(1):
                operator = construct.power(operator, orders[0])
            return _Factor(operator, item.at, place + 1, item)
        return self.differentiated(
            place, found, lambda body: scope.rate(item.at, body, orders[0], found.frame)
        )

    def differentiated(self, place: int, found: Rate, rate: Callable[[Term], Term]) -> _Factor:
        """What stands behind the upper d, all of it, or else the factor behind the fraction."""
        item = self.items[place]
        if found.behind:
            lone = len(found.behind) == (2 if is_left_script(found.behind[0]) else 1) or (
                isinstance(found.behind[-1], Bracket) and is_rate(product(self.scope, found.behind))
            )
            if not lone and (not found.upright or isinstance(found.behind[0], Bracket)):
                raise Fault("how far does d/dt reach? bracket what it differentiates", item.at)
            return _Factor(rate(product(self.scope, found.behind)), item.at, place + 1, item)
        if place + 1 == len(self.items):
            raise Fault("the partial derivative of what?", item.at)
        following = self.items[place + 1]
        if isinstance(following, Scripted) and isinstance(following.nucleus, Bracket):
            raise Fault("a power of the derivative or of its argument? bracket it", following.at)
        factor = self.factor(place + 1)
        if not isinstance(following, Bracket):
            self.open_head = "d/dt"
        if factor.end < len(self.items) and not isinstance(following, Bracket):
            raise Fault("how far does d/dt reach? bracket what it differentiates", item.at)
        return _Factor(rate(factor.term), item.at, factor.end, item)


def _is_function(node: Node) -> bool:
    leaf = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(leaf, Leaf) and leaf.kind == "FUNCTION"


def _is_integer(factor: _Factor) -> bool:
    literal = isinstance(factor.node, Leaf) and isinstance(factor.term, Number)
    return literal and factor.term.value.denominator == 1


def _is_numeral(node: Node) -> bool:
    leaf = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(leaf, Leaf) and leaf.kind == "NUMBER"


def _is_bare(node: Node) -> bool:
    return isinstance(node, Leaf | Scripted)
