"""Polynomials in D = d/dt as functions of a value."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.collector import Collector
from workbench.certificates.emission.emitted_nodes import APPLICATION, ATOM, PRODUCT, SUM, Node, NotCertified
from workbench.core.terms import Apply, Identity, Power, Symbol, Term, TimeOperator, Zero


@dataclass(frozen=True)
class Operator:
    """An operator as text with its precedence level, and a function from a value's deep copy to the
    result's."""

    text: str
    level: int
    acts: Callable[[str], str]

    def at(self, level: int) -> str:
        return self.text if self.level <= level else f"({self.text})"

    def __call__(self, value: Node) -> Node:
        text = f"{self.at(ATOM)} {value.at(ATOM)}"
        return Node(value.dual, value.kind, text, APPLICATION, self.acts(value.deep))


def operator(emitter: Collector, term: Term, dual: bool, kind: str) -> Operator:
    """Returns the operator that acts on values of this kind."""
    if term.type.kind == "tensor":
        value = emitted_nodes.embedded(emitter.term(term), dual)
        deep = {"Vector": "Act", "Tensor": "Prod"}[kind]
        return Operator(f"times {value.at(ATOM)}", APPLICATION, lambda x: f"({deep} {value.deep} {x})")
    if term.type.kind == "scalar":
        value = emitted_nodes.embedded(emitter.term(term), dual)
        return Operator(f"scale {value.at(ATOM)}", APPLICATION, lambda x: f"(Scale {value.deep} {x})")
    read = lambda part: operator(emitter, part, dual, kind)  # noqa: E731
    match term:
        case TimeOperator():
            return Operator("D", ATOM, lambda x: f"(DD {x})")
        case Identity():
            return Operator("unit_op", ATOM, lambda x: x)
        case Zero():
            empty = emitted_nodes.zero(dual, kind)
            return Operator(f"(fun _ => {empty.text})", ATOM, lambda x: empty.deep)
        case Symbol():
            return _defined(emitter, term, dual, kind)
        case Power():
            if not term.exponent.is_number:
                raise NotCertified("a power of symbolic exponent")
            base, exponent = read(term.base), int(term.exponent)
            return Operator(
                f"power_op {base.at(ATOM)} {exponent}",
                APPLICATION,
                lambda x: _iterated(base.acts, exponent, x),
            )
        case Apply(head="neg", arguments=(a,)):
            inner = read(a)
            return Operator(f"neg_op {inner.at(ATOM)}", APPLICATION, lambda x: f"(Neg {inner.acts(x)})")
        case Apply(head="add"):
            return _sum([read(a) for a in term.arguments])
        case Apply(head="mul" | "compose", arguments=(left, right)):
            outer, inner = read(left), read(right)
            text = f"{outer.at(PRODUCT)} ⊚ {inner.at(PRODUCT - 1)}"
            return Operator(text, PRODUCT, lambda x: outer.acts(inner.acts(x)))
    raise NotCertified(f"an operator made by {type(term).__name__}")


def _iterated(acts: Callable[[str], str], count: int, value: str) -> str:
    for _ in range(count):
        value = acts(value)
    return value


def _sum(parts: list[Operator]) -> Operator:
    return reduce(_plus, parts)


def _plus(left: Operator, right: Operator) -> Operator:
    text = f"{left.at(SUM)} ⊕ {right.at(SUM - 1)}"
    return Operator(text, SUM, lambda x: f"(Plus {left.acts(x)} {right.acts(x)})")


def _defined(emitter: Collector, symbol: Symbol, dual: bool, kind: str) -> Operator:
    key = (symbol, dual, kind)
    if key not in emitter.operators:
        body = emitter.definitions.lookup(symbol)
        if body is None:
            raise NotCertified("an operator that nothing defines")
        meaning = operator(emitter, body, dual, kind)
        name = emitter.name(symbol)
        type_ = emitted_nodes.type_name(dual, kind)
        emitter.statement.append(f"let {name} : {type_} -> {type_} := {meaning.text} in")
        emitter.introduced.append(name)
        emitter.read_back[name] = symbol
        emitter.operators[key] = Operator(name, ATOM, meaning.acts)
    return emitter.operators[key]
