"""Premises from declarations of symbols: constants, unit vectors, rotations; and their use in proofs."""

from __future__ import annotations

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.collector import Collector
from workbench.certificates.emission.emitted_nodes import ATOM, KINDS, Node, flag, single
from workbench.core.properties import PROPERTIES, properties_of
from workbench.core.terms import Symbol
from workbench.core.types import Declaration


def predicate(name: str, dual: bool, kind: str) -> str:
    """Returns the library's predicate for a property of the table."""
    words = PROPERTIES[name].coq
    assert words is not None, f"the library has no {name}"
    return words.format(dual="dual_" * dual, d=flag(dual), k=kind)


def variable(emitter: Collector, symbol: Symbol, kind: str, name: str) -> Node:
    """Returns a free symbol as a variable of the theorem, with the premises of its declaration."""
    declaration, dual = symbol.declaration, symbol.type.dual
    said = [row.name for row in properties_of(declaration) if row.coq]
    node = emitter.variable(dual, kind, name, " ".join(said) or "free")
    if declaration.rotation:
        rotation(emitter, node)
    if declaration.unit:
        _unit(emitter, node, declaration.constant)
    elif declaration.constant:
        emitter.facts.append(_rate(node, _still(emitter, node)))
    return node


def supposed(emitter: Collector, node: Node, what: str, says: list[tuple[str, str]]) -> str:
    """Adds a premise on a variable, and returns its name. says: its equations, as deep copies."""
    name = emitter.fresh(f"{node.text}_{what.split()[0]}")
    emitter.binders.append((name, f"{what} {node.text}"))
    emitter.holes[name] = says
    return name


def index(node: Node) -> str:
    return node.deep.split()[-1].rstrip(")")


def rotation(emitter: Collector, node: Node, known: str | None = None) -> None:
    """Adds the facts of a rotation. known: the proof that it is one, if that is a premise already."""
    says = [
        (f"(Prod {node.deep} (Transpose {node.deep}))", emitted_nodes.identity(node.dual).deep),
        (f"(Det {node.deep})", emitted_nodes.number(1, node.dual).deep),
    ]
    if not node.dual:
        known = known or supposed(emitter, node, predicate("rotation", False, node.kind), says)
        spin = emitter.slot(False, "Vector", f"(spin {node.at(ATOM)})")
        places = f"{index(node)} {index(spin)}"
        emitter.facts.append(f"(@rotation_at_ok K here {places} {known} eq_refl)")
        return
    known = known or supposed(emitter, node, predicate("rotation", True, node.kind), says)
    text = node.at(ATOM)
    real = emitter.slot(False, "Tensor", f"(real_part {text} : tensor K)")
    spin = emitter.slot(False, "Vector", f"(spin (real_part {text} : tensor K))")
    moved = emitter.slot(False, "Vector", f"(shift {text})")
    places = " ".join(map(index, (node, real, spin, moved)))
    emitter.facts.append(f"(@dual_rotation_at_ok K here {places} {known} eq_refl eq_refl eq_refl)")


def _unit(emitter: Collector, node: Node, constant: bool) -> None:
    says = [(f"(Dot {node.deep} {node.deep})", emitted_nodes.number(1, node.dual).deep)]
    known = supposed(emitter, node, predicate("unit", node.dual, node.kind), says)
    still = _still(emitter, node) if constant else None
    if not node.dual:
        spin = emitter.slot(False, "Vector", f"({node.text} × D {node.text})")
        places = f"{index(node)} {index(spin)}"
        emitter.facts.append(f"(@unit_at_ok K here {places} {known} eq_refl)")
        if still:
            emitter.facts.append(_rate(node, still))
        return
    real_text = f"(real_part {node.text} : vector K)"
    real = emitter.slot(False, "Vector", real_text)
    spin = emitter.slot(False, "Vector", f"({real_text} × D {real_text})")
    moment = emitter.slot(False, "Vector", f"(moment {node.text})")
    places = " ".join(map(index, (node, real, spin, moment)))
    emitter.facts.append(f"(@dual_unit_at_ok K here {places} {known} eq_refl eq_refl eq_refl)")
    if still:
        # the symbol itself was replaced by u + ε m × u before
        emitter.facts.append(_rate(real, f"(still_real {still})"))
        emitter.facts.append(_rate(moment, f"(still_moment {still})"))


def _still(emitter: Collector, node: Node) -> str:
    says = [(f"(DD {node.deep})", emitted_nodes.zero(node.dual, node.kind).deep)]
    return supposed(emitter, node, predicate("constant", node.dual, node.kind), says)


def _rate(node: Node, known: str) -> str:
    place = f"{flag(node.dual)} {node.kind} {index(node)}"
    return single(f"@Rate {place} {emitted_nodes.zero(node.dual, node.kind).deep}", known)


def conditions(own: Declaration, name: str) -> list[str]:
    """Returns the conditions for a member of the declared set, in the library's words, in a fixed order."""
    rows = (row.name for row in properties_of(own) if row.coq)
    return [f"{predicate(row, own.type.dual, KINDS[own.type.kind])} {name}" for row in rows]
