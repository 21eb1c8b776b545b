"""div and curl: the field as a function over dual numbers, ∂/∂ρ along an axis as its dual part."""

from __future__ import annotations

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.collector import Collector
from workbench.certificates.emission.emitted_nodes import APPLICATION, ATOM, Node, NotCertified
from workbench.core.terms import Term
from workbench.language.definitions import expand


def divergence(emitter: Collector, field: Term) -> Node:
    text, along = _field(emitter, field)
    deep = "(Plus (Plus {} {}) {})".format(*(_part(along, i, i) for i in range(3)))
    return Node(False, "Scalar", f"divergence {text}", APPLICATION, deep)


def curl(emitter: Collector, field: Term) -> Node:
    """Returns the curl by its components along the axes; curl f = Σ (∂ᵢ fⱼ − ∂ⱼ fᵢ) eₖ has no deep copy of
    its own."""
    text, along = _field(emitter, field)
    components = [f"(Minus {_part(along, j, k)} {_part(along, k, j)})" for j, k in ((1, 2), (2, 0), (0, 1))]
    return Node(False, "Vector", f"curl {text}", APPLICATION, "(Triad {} {} {})".format(*components))


def _part(along: list[str], axis: int, component: int) -> str:
    return f"(Comp {component} {along[axis]})"


def _field(emitter: Collector, field: Term) -> tuple[str, list[str]]:
    """Returns the field over its coordinate as text, and the derivative along each axis."""
    if emitter.coordinate is not None or field.type.dual:
        raise NotCertified("a field of a dual quantity, or of a derivative of a field")
    full = expand(field, emitter.definitions)
    found = {p for p in full.symbols() if p.declaration.coordinate}
    if len(found) != 1:
        raise NotCertified("a field of no coordinate, or of several")
    coordinate = emitter.symbol(found.pop())
    name = emitter.fresh("r")
    place = coordinate.deep
    texts = []
    for axis in range(3):
        moved = f"(Plus (Emb {place}) (Scale Eps (Emb (Axis false {axis}))))"
        emitter.coordinate = Node(True, "Vector", name, ATOM, moved)
        try:
            made = emitted_nodes.embedded(emitter.term(field))
        finally:
            emitter.coordinate = None
        texts.append((made.text, f"(Du {made.deep})"))
    text = f"(fun {name} => {texts[0][0]}) {coordinate.at(ATOM)}"
    return text, [deep for _, deep in texts]
