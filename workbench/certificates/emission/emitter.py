"""Emitter: typed terms to values of Coq statements."""

from __future__ import annotations

from workbench.certificates.emission import (
    emitted_families,
    emitted_functions,
    emitted_nodes,
    emitted_operators,
    emitted_sums,
    emitted_suppositions,
)
from workbench.certificates.emission.blocks import is_column
from workbench.certificates.emission.collector import Collector, Origin
from workbench.certificates.emission.emitted_fields import curl, divergence
from workbench.certificates.emission.emitted_nodes import KINDS, Node, NotCertified, flag, single
from workbench.core.integer_instances import count
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Counting,
    Derivative,
    DualUnit,
    Identity,
    Integer,
    Number,
    Power,
    Symbol,
    Term,
    Zero,
)
from workbench.language.definitions import Definitions, expand

_UNARY = {
    "skew": ("skew", "Skew", "Tensor"),
    "vect": ("vect", "Vect", "Vector"),
    "symmetric": ("sym", "Sym", "Tensor"),
    "antisymmetric": ("anti", "Anti", "Tensor"),
    "transpose": ("transpose", "Transpose", "Tensor"),
    "adjugate": ("adj", "Adj", "Tensor"),
    "det": ("det", "Det", "Scalar"),
    "trace": ("trace", "Trace", "Scalar"),
}
_BINARY = {
    "dot": ("·", "Dot", "Scalar"),
    "cross": ("×", "Cross", "Vector"),
    "outer": ("⊗", "Outer", "Tensor"),
}

#: Properties of declarations for which the library has no premise.
_BEYOND = {
    "symmetric": "a symmetric tensor",
    "diagonal": "a diagonal tensor",
    "clock": "the time t",
    "of": "a function of other symbols",
    "independent": "a symbol that others are functions of",
}


class Emitter(Collector):
    """Converts terms to nodes."""

    def term(self, term: Term) -> Node:
        if term not in self._made or self.coordinate is not None:
            made = self._term(term)
            if self.coordinate is not None:
                return made
            self._made[term] = made
        return self._made[term]

    def _term(self, term: Term) -> Node:
        if term.type.kind not in KINDS:
            raise NotCertified(emitted_nodes.named(term.type.kind))
        match term:
            case Number() | Integer() | Counting():
                return self._number(term)
            case BigSum():
                return emitted_sums.of_sum(self, term)
            case Zero():
                return emitted_nodes.zero(False, KINDS[term.type.kind])
            case Identity():
                return emitted_nodes.identity(False)
            case DualUnit():
                return emitted_nodes.DUAL_UNIT
            case Symbol():
                return self.symbol(term)
            case Derivative():
                return self._derivative(term)
            case Power():
                if not term.exponent.is_number:
                    raise NotCertified("a power of symbolic exponent")
                return emitted_nodes.raised(self.term(term.base), int(term.exponent))
            case Block(entries=entries) if is_column(term):
                return emitted_nodes.column(*(self.term(entry) for (entry,) in entries))
            case Apply():
                return self._apply(term)
        raise NotCertified(type(term).__name__)

    def _number(self, term: Number | Integer | Counting) -> Node:
        """A number, or one that depends on n."""
        match term:
            case Number():
                return emitted_nodes.number(term.value)
            case Integer(value=value) if value.is_number:
                return emitted_nodes.number(int(value))
            case Integer(value=value):
                return self.whole(f"whole {emitted_families.numeral(self, value)}")
        if _numeric(term):
            return self.term(count(term.name, term.arguments))
        if term.name != "binomial":
            raise NotCertified(f"a {term.name} that depends on n")
        numbers = " ".join(emitted_families.numeral(self, a) for a in term.arguments)
        return self.whole(f"whole (choose {numbers})")

    def _derivative(self, term: Derivative) -> Node:
        if not term.order.is_number:
            return emitted_sums.of_symbolic_order(self, term)
        body = self.term(term.body)
        if any(h.head == "norm" for h in self.helpers if isinstance(h, Apply)):
            full = expand(term.body, self.definitions)
            if any(isinstance(p, Apply) and p.head == "norm" for p in full.walk()):
                raise NotCertified("the derivative of a norm")
        return emitted_nodes.derivative(body, int(term.order))

    def whole(self, text: str) -> Node:
        """Returns a number that depends on n."""
        node = self.slot(False, "Scalar", text, emitted_nodes.APPLICATION)
        self.origins.append(Origin(node, "constant", len(self.statement)))
        place = f"{flag(False)} Scalar {emitted_suppositions.index(node)}"
        self.facts.append(single(f"@Rate {place} {emitted_nodes.number(0).deep}", "(@D_whole K false _)"))
        return node

    def _apply(self, term: Apply) -> Node:
        head, arguments = term.head, term.arguments
        if head == "mul" and arguments[0].type.kind == "operator":
            value = self.term(arguments[1])
            acting = emitted_operators.operator(
                self, arguments[0], value.dual or arguments[0].type.dual, value.kind
            )
            return acting(emitted_nodes.embedded(value, value.dual or arguments[0].type.dual))
        if head in emitted_functions.HEADS:
            return emitted_functions.HEADS[head](self, term)
        if head == "divergence":
            return divergence(self, arguments[0])
        if head == "curl":
            return curl(self, arguments[0])
        if head == "add":
            total = self.term(arguments[0])
            for addend in arguments[1:]:
                if isinstance(addend, Apply) and addend.head == "neg":
                    total = emitted_nodes.minus(total, self.term(addend.arguments[0]))
                else:
                    total = emitted_nodes.plus(total, self.term(addend))
            return total
        made = [self.term(a) for a in arguments]
        if head in _UNARY:
            return emitted_nodes.call(*_UNARY[head], *made)
        if head in _BINARY:
            left, right = made
            return emitted_nodes.infix(*_BINARY[head], left, right)
        match head:
            case "neg":
                return emitted_nodes.neg(made[0])
            case "mul":
                return emitted_nodes.times(*made)
            case "triple":
                return emitted_nodes.call("triple", "Triple", "Scalar", *made)
            case "re":
                return emitted_nodes.half("real_part", "Re", made[0])
            case "du":
                return emitted_nodes.half("dual_part", "Du", made[0])
        raise NotCertified(head)

    def symbol(self, symbol: Symbol) -> Node:
        if self.coordinate is not None:
            return self._in_a_field(symbol, self.coordinate)
        if symbol not in self._symbols:
            self._symbols[symbol] = self._new(symbol)
        return self._symbols[symbol]

    def _in_a_field(self, symbol: Symbol, coordinate: Node) -> Node:
        """Returns the symbol, expanded if it depends on the coordinate ρ of ∂/∂ρ."""
        if symbol.declaration.coordinate:
            return coordinate
        body = self.definitions.lookup(symbol)
        if body is not None and _has_coordinate(body, self.definitions):
            return self.term(body)
        self.coordinate = None
        try:
            return self.symbol(symbol)
        finally:
            self.coordinate = coordinate

    def _new(self, symbol: Symbol) -> Node:
        kind = KINDS.get(symbol.type.kind)
        if kind is None:
            raise NotCertified(emitted_nodes.named(symbol.type.kind))
        for said, obstacle in _BEYOND.items():
            if getattr(symbol.declaration, said):
                raise NotCertified(obstacle)
        body = self.definitions.lookup(symbol)
        if any(not index.is_number for index in symbol.index):
            return emitted_families.member(self, symbol, kind, body)
        if body is None:
            if symbol.arguments:
                raise NotCertified("a function that nothing defines")
            name = self.name(symbol)
            self.read_back[name] = symbol
            return emitted_suppositions.variable(self, symbol, kind, name)
        value = self.term(body)
        value = emitted_nodes.embedded(value, symbol.type.dual or value.dual)
        name = self.name(symbol)
        self.read_back[name] = symbol
        if symbol in self.pivots:
            self.statement.append(f"let {name} := {value.text} in")
            self.introduced.append(name)
            node = self.slot(value.dual, value.kind, name)
            self.origins.append(Origin(node, "is", len(self.statement), value))
            return node
        return self.defined(name, value)


def _has_coordinate(term: Term, definitions: Definitions) -> bool:
    for part in term.walk():
        if isinstance(part, Symbol):
            if part.declaration.coordinate:
                return True
            body = definitions.lookup(part)
            if body is not None and not _recurs(part, body) and _has_coordinate(body, definitions):
                return True
    return False


def _recurs(symbol: Symbol, body: Term) -> bool:
    return any(p.declaration.name == symbol.declaration.name for p in body.symbols())


def _numeric(term: Counting) -> bool:
    return all(a.is_number for a in term.arguments)
