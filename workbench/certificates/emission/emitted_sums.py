"""Sums over k and n-th derivatives of compound terms: symbols of the proof with their defining equations.

A sum is split into the common part of all sums with similar addends and the remaining addends. x⁽ⁿ⁾ of a sum
or a product is expanded by its parts. `coq/Orders.v` has the lemmas.
"""

from __future__ import annotations

from collections.abc import Sequence

from workbench.certificates.emission import emitted_families, emitted_nodes
from workbench.certificates.emission.collector import Collector, Summed
from workbench.certificates.emission.emitted_nodes import (
    APPLICATION,
    ATOM,
    KINDS,
    Node,
    NotCertified,
    flag,
    single,
)
from workbench.core.construct import apply, big_sum, counting, derivative, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.terms import Apply, BigSum, Derivative, Head, IllFormed, Statement, Symbol, Term, Zero
from workbench.prover.goals.sequents import relations_of

_ANY = "·"  # stands for the summation variable
_SHIFTS = (0, 1, -1, 2, -2)


def differentiated(statement: Statement) -> set[BigSum]:
    """Returns the sums under a dot."""
    return {
        inner
        for one in relations_of(statement)
        for side in (one.left, one.right)
        for part in side.walk()
        if isinstance(part, Derivative)
        for inner in part.body.walk()
        if isinstance(inner, BigSum)
    }


def cores_of(met: Sequence[Summed]) -> list[Summed]:
    cores: list[Summed] = []
    for one in met:
        for index, core in enumerate(cores):
            common = _in_common(one.total, core.total)
            if common is not None:
                cores[index] = Summed(common, core.differentiated or one.differentiated)
                break
        else:
            cores.append(one)
    return cores


def _in_common(total: BigSum, core: BigSum) -> BigSum | None:
    """Returns the sum over the intersection of the ranges, if the addends are alike."""
    shift = _shift(total, core)
    if shift is None:
        return None
    lower, upper = _lower(total) + shift - _lower(core), total.upper + shift - core.upper
    if not (lower.is_number and upper.is_number):
        return None
    first, last = _lower(core) + max(lower.constant, 0), core.upper + min(upper.constant, 0)
    return big_sum(core.variables, first, last, core.body)


def _shift(total: BigSum, core: BigSum) -> int | None:
    """Returns the index shift by which the addends of one sum are those of the other."""
    wanted = _addend(total, Linear.variable(_ANY))
    return next((s for s in _SHIFTS if _addend(core, Linear.variable(_ANY) + s) == wanted), None)


def _addend(total: BigSum, index: Linear) -> Term | None:
    try:
        return instantiate(total.body, {total.variables[0]: index})
    except IllFormed:
        return None


def _end(total: BigSum, index: Linear) -> Term:
    """Returns the addend at an end of the range. Raises NotCertified if it is ill-formed."""
    addend = _addend(total, index)
    if addend is None:
        raise NotCertified("a sum with an addend that is ill-formed")
    return addend


def _lower(total: BigSum) -> Linear:
    """Returns the lower bound; a sum over several indices has none and is not certified."""
    assert total.lower is not None, f"a sum over {', '.join(total.variables)}"
    return total.lower


def count(total: BigSum) -> Linear:
    return total.upper - _lower(total) + 1


def of_sum(emitter: Collector, total: BigSum) -> Node:
    """Returns Σ as the common part with other sums, plus the rest."""
    if total.lower is None or len(total.variables) != 1:
        raise NotCertified("a sum over several indices")
    if emitter.bounds:
        return _written(emitter, total)
    emitter.composed = True
    emitter.met.append(Summed(total, total in emitter.differentiated))
    if total in emitter.differentiated:
        emitter.met.append(Summed(_rate(total), False))
    for core in emitter.cores:
        shift = _shift(total, core.total)
        if shift is not None and _in_common(total, core.total) == core.total:
            return _with_ends(emitter, total, core, shift)
    return _slot(emitter, total)


def _written(emitter: Collector, total: BigSum) -> Node:
    """Returns the sum as text."""
    (variable,) = total.variables
    emitted_families.prepare(emitter, total.body)
    inner = emitter.inside(variable, total.body, variable)
    emitter.forget(name := inner.integers[variable])
    inner.integers = {**emitter.integers, variable: name}
    inner.bounds = {**emitter.bounds, variable: (_lower(total), total.upper)}
    body = inner.term(total.body)
    emitter.positive |= inner.positive
    if inner.statement or inner.binders:
        raise NotCertified("a sum over what has definitions of its own")
    first, many = (emitted_families.numeral(emitter, place) for place in (_lower(total), count(total)))
    text = f"sum_from {first} {many} (fun {name} => {body.text})"
    return Node(body.dual, body.kind, text, APPLICATION, "?")


def _slot(emitter: Collector, total: BigSum) -> Node:
    written = _written(emitter, total)
    return emitter.slot(written.dual, written.kind, written.text, APPLICATION)


def _with_ends(emitter: Collector, total: BigSum, core: Summed, shift: int) -> Node:
    middle = _middle(emitter, core)
    before = int(_lower(core.total) - _lower(total) - shift)
    after = int(total.upper + shift - core.total.upper)
    node = _slot(emitter, total)
    if node.text == middle.text:
        return middle
    value = middle
    last = core.total.upper - shift
    for place in range(1, after + 1):
        end = emitter.term(_end(total, last + place))
        value = emitted_nodes.plus(value, end)
    for place in reversed(range(before)):
        end = emitter.term(_end(total, _lower(total) + place))
        value = emitted_nodes.plus(end, value)
    script = ["apply first_of; [indices|]."] * before + ["apply last_of; [indices|]."] * after
    fact = emitter.shown(node, value, " ".join([*script, "apply like; indices."]))
    emitter.stands_for(node, value, fact)
    return node


def _middle(emitter: Collector, core: Summed) -> Node:
    if core.total not in emitter.middles:
        node = _slot(emitter, core.total)
        emitter.middles[core.total] = node
        if core.differentiated:
            rate = _rate(core.total)
            value = emitter.term(rate)
            left = emitted_nodes.derivative(node)
            fact = emitter.shown(left, value, "apply D_sum; indices.")
            place = f"{flag(node.dual)} {node.kind} {node.deep.split()[-1].rstrip(')')}"
            emitter.values.append(single(f"@Rate {place} {value.deep}", fact))
            _follows(emitter, node, rate, value)
    return emitter.middles[core.total]


def _rate(total: BigSum) -> BigSum:
    match total.body:
        case Derivative(body=body, order=order):
            rate = derivative(body, order + 1)
        case body:
            rate = derivative(body, Linear(1))
    return big_sum(total.variables, total.lower, total.upper, rate)


def _follows(emitter: Collector, node: Node, rate: BigSum, value: Node) -> None:
    """Records the common part of the sums of the derivatives by the derivative of this sum."""
    common = next(c for c in (_in_common(rate, core.total) for core in emitter.cores) if c in emitter.middles)
    middle = emitter.middles[common]
    said = next((o.value for o in emitter.origins if o.node == value and o.value), value)
    rest = said.deep.replace(middle.deep, emitted_nodes.zero(middle.dual, middle.kind).deep)
    emitter.rates[middle.deep] = f"(Minus (DD {node.deep}) {rest})"


def of_symbolic_order(emitter: Collector, term: Derivative) -> Node:
    """Returns x⁽ⁿ⁺ᶜ⁾ as the c-th derivative of a new symbol x⁽ⁿ⁾."""
    body, order = term.body, term.order
    if body.type.kind not in KINDS:
        raise NotCertified("a derivative of symbolic order of a matrix")
    more = max(order.constant, 0)
    key = (body, order - more)
    if key not in emitter.orders:
        emitter.composed |= not _names_a_symbol(emitter, body)
        value = emitter.term(body)
        text = f"der {emitted_families.numeral(emitter, key[1])} {value.at(ATOM)}"
        node = emitter.slot(value.dual, value.kind, text, APPLICATION)
        emitter.orders[key] = node
        parts = _expanded(emitter, *key) if emitter.expands and not emitter.bounds else None
        if parts is not None:
            meaning = emitted_nodes.embedded(emitter.term(parts[0]), node.dual)
            emitter.stands_for(node, meaning, emitter.shown(node, meaning, parts[1]))
    return emitted_nodes.derivative(emitter.orders[key], more)


def _names_a_symbol(emitter: Collector, term: Term) -> bool:
    while isinstance(term, Symbol) and (meaning := emitter.definitions.lookup(term)) is not None:
        term = meaning
    return isinstance(term, Symbol) and term not in emitter.premised


def _expanded(emitter: Collector, body: Term, order: Linear) -> tuple[Term, str] | None:
    """Returns x⁽ⁿ⁾ in terms of derivatives of the parts of x, with the Coq proof."""
    match body:
        case Symbol() if body in emitter.premised:
            value, known = emitter.premised[body]
            return derivative(value, order), f"apply der_ext; exact {known}."
        case Symbol() if (meaning := emitter.definitions.lookup(body)) is not None:
            return derivative(meaning, order), "reflexivity."
        case Apply(head="skew" | "vect" as head, arguments=(part,)):
            return apply(head, derivative(part, order)), f"apply der_{head}."
        case Derivative(body=inner, order=more) if more.is_number:
            return derivative(derivative(inner, order), more), f"exact (@every_der _ _ _ _ {more} _)."
        case Apply(head="add" | "neg" as head, arguments=parts) if len({p.type.dual for p in parts}) == 1:
            return apply(head, *(derivative(part, order) for part in parts)), "linear."
        case Apply(head="mul", arguments=(Zero(type=kind), _)) if kind.kind == "scalar":
            return zero(body.type), "apply der_nothing, zero_scale."
        case Apply(head="mul" | "dot" | "cross" | "outer" as head, arguments=(left, right)):
            return _product(emitter, head, left, right, order)
        case BigSum(variables=variables, lower=lower, upper=upper, body=inner):
            return big_sum(variables, lower, upper, derivative(inner, order)), "apply der_sum."
    return None


def _product(
    emitter: Collector, head: Head, left: Term, right: Term, order: Linear
) -> tuple[Term, str] | None:
    """Returns the derivative of a product by Leibniz' rule; a constant factor is moved outside."""
    if right.type.kind == "scalar" and left.type.kind != "scalar":
        left, right = right, left
    kinds = left.type.kind, right.type.kind
    if left.type.dual != right.type.dual or not set(kinds) <= set(KINDS):
        return None
    acting = {"scalar": f"scale_{kinds[1][0]}", "tensor": "act" if kinds[1] == "vector" else "prod"}
    rule = acting[kinds[0]] if head == "mul" else head
    still = _still(emitter, right) if rule == "act" else None
    if still is not None:
        return apply(head, derivative(left, order), right), f"apply still_act; exact {still}."
    name = next(v for v in "ljkipq" if v not in emitter.integers)
    index = Linear.variable(name)
    factors = apply(head, derivative(left, order - index), derivative(right, index))
    addend = apply("mul", counting("binomial", order, index), factors)
    return big_sum((name,), 0, order, addend), f"apply leibniz_{rule}."


def _still(emitter: Collector, term: Term) -> str | None:
    """Returns the premise that the symbol is constant; None if there is none."""
    if not isinstance(term, Symbol) or not term.declaration.constant or term.declaration.unit:
        return None
    text = emitter.term(term).at(ATOM)
    return next(
        (name for name, what in emitter.binders if what.startswith("constant ") and what.split()[-1] == text),
        None,
    )
