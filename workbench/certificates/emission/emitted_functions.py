"""Quotients, inverses, sines, cosines and exponentials: by their defining equations as premises."""

from __future__ import annotations

from typing import TYPE_CHECKING

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.blocks import is_column
from workbench.certificates.emission.collector import Collector
from workbench.certificates.emission.emitted_nodes import APPLICATION, ATOM, Node, NotCertified, flag, single
from workbench.core.terms import Apply, DualUnit, Head, Number, Symbol, Term
from workbench.core.types import SCALAR
from workbench.engines.inventory import NoDefinitions
from workbench.engines.inventory.rodrigues import angle_and_axis

if TYPE_CHECKING:
    from collections.abc import Callable


def quotient(emitter: Collector, term: Apply) -> Node:
    above, below = term.arguments
    if isinstance(below, Number):
        return emitted_nodes.times(emitted_nodes.number(1 / below.value), emitter.term(above))
    return emitted_nodes.times(reciprocal(emitter, below), emitter.term(above))


def reciprocal(emitter: Collector, below: Term) -> Node:
    """Returns 1/x as a scalar y with x • y ≡ 1; for a dual number by the reciprocal of its real part."""
    key = Apply(below.type, None, "reciprocal", (below,))
    if key not in emitter.helpers:
        value = emitter.term(below)
        if value.kind != "Scalar":
            raise NotCertified("a reciprocal of anything but a number")
        if value.dual:
            y = reciprocal(emitter, part("re", below))
            square = f"(Scale (Scale {y.deep} {y.deep}) (Du {value.deep}))"
            deep = f"(Minus (Emb {y.deep}) (Scale Eps (Emb {square})))"
            text = f"dual_over {value.at(ATOM)} {y.at(ATOM)}"
            emitter.helpers[key] = Node(True, "Scalar", text, APPLICATION, deep)
            return emitter.helpers[key]
        name, place = emitter.fresh("over"), emitter.place()
        made = emitter.helper(Node(False, "Scalar", name, ATOM, f"(Var false Scalar {place})"), "over", value)
        says = [(f"(Scale {value.deep} {made.deep})", emitted_nodes.number(1).deep)]
        known = emitter.suppose(f"reciprocal {value.at(ATOM)} {name}", f"{name}_is", says)
        emitter.step(f"with_reciprocal {{}} {place} {value.deep} {known}")
        emitter.read_back[name] = key
        emitter.helpers[key] = made
    return emitter.helpers[key]


def inverse(emitter: Collector, term: Apply) -> Node:
    """Returns A⁻¹ as a tensor X with A X ≡ I and X A ≡ I; the proof computes with (1/det A) adj A."""
    if term not in emitter.helpers:
        value = emitter.term(term.arguments[0])
        if value.dual or value.kind != "Tensor":
            raise NotCertified("the inverse of anything but a real tensor")
        name = emitter.fresh(
            f"inverse_{value.text}" if value.level == ATOM and value.text.isidentifier() else "inverse_of_it"
        )
        one, two = emitter.place(), emitter.place()
        made = emitter.helper(
            Node(False, "Tensor", name, ATOM, f"(Var false Tensor {two})"), "inverse", value
        )
        unit = emitted_nodes.identity(False).deep
        says = [(f"(Prod {value.deep} {made.deep})", unit), (f"(Prod {made.deep} {value.deep})", unit)]
        known = emitter.suppose(f"inverse {value.at(ATOM)} {name}", f"{name}_is", says)
        emitter.step(f"with_reciprocal {{}} {one} (Det {value.deep}) (inverse_det {known})")
        adjugate = f"(Scale (Var false Scalar {one}) (Adj {value.deep}))"
        emitter.step(f"given {{}} false Tensor {two} {adjugate} (inverse_adj {known})")
        emitter.read_back[name] = term
        emitter.helpers[term] = made
    return emitter.helpers[term]


def cosine(emitter: Collector, term: Apply) -> Node:
    return circle(emitter, term.arguments[0])[0]


def sine(emitter: Collector, term: Apply) -> Node:
    return circle(emitter, term.arguments[0])[1]


def circle(emitter: Collector, angle: Term) -> tuple[Node, Node]:
    """Returns cos and sin as scalars c, s with c² + s² = 1, ċ = −s α̇, ṡ = c α̇; for a dual angle by its real
    part."""
    key = Apply(angle.type, None, "turn", (angle,))
    if key not in emitter.circles:
        value = emitter.term(angle)
        if not value.text.isidentifier():
            raise NotCertified("the sine or cosine of anything but one angle")
        real = _real_angle(emitter, angle) if value.dual else None
        c, s = circle(emitter, real) if real is not None else _turn(emitter, value, angle)
        if value.dual:
            names = f"{value.text} {c.text} {s.text}"
            emitter.circles[key] = (
                _dual(f"dual_cos {names}", "Minus", value, c, s),
                _dual(f"dual_sin {names}", "Plus", value, s, c),
            )
        else:
            emitter.circles[key] = (c, s)
    return emitter.circles[key]


def _real_angle(emitter: Collector, angle: Term) -> Term | None:
    """Returns α of an angle that is defined as α + ε d."""
    body = emitter.definitions.lookup(angle) if isinstance(angle, Symbol) else None
    match body:
        case Apply(head="add", arguments=(Symbol() as real, Apply(head="mul", arguments=(DualUnit(), d)))):
            return real if not (real.type.dual or d.type.dual) else None
    return None


def _turn(emitter: Collector, angle: Node, angle_term: Term) -> tuple[Node, Node]:
    if emitter.steps:
        raise NotCertified("an angle after a quotient")
    real = emitted_nodes.half("real_part", "Re", angle) if angle.dual else angle
    pair = []
    for what in ("cos", "sin"):
        name = emitter.fresh(f"{what}_{angle.text}")
        pair.append(emitter.helper(emitter.slot(False, "Scalar", name), what, real))
        emitter.read_back[name] = Apply(angle_term.type, None, what, (angle_term,))
    c, s = pair
    rate = f"(DD {real.deep})"
    says = [
        (f"(Plus (Scale {c.deep} {c.deep}) (Scale {s.deep} {s.deep}))", emitted_nodes.number(1).deep),
        (f"(DD {c.deep})", f"(Neg (Scale {s.deep} {rate}))"),
        (f"(DD {s.deep})", f"(Scale {c.deep} {rate})"),
    ]
    known = emitter.suppose(f"turn {real.at(ATOM)} {c.text} {s.text}", f"{angle.text}_turns", says)
    places = " ".join(n.deep.split()[-1].rstrip(")") for n in pair)
    emitter.values.append(f"(@turn_at_ok K here {real.deep} {places} {known})")
    return c, s


def _dual(text: str, sign: str, angle: Node, main: Node, other: Node) -> Node:
    deep = f"({sign} (Emb {main.deep}) (Scale Eps (Emb (Scale (Du {angle.deep}) {other.deep}))))"
    return Node(True, "Scalar", text, APPLICATION, deep)


def exponential(emitter: Collector, term: Apply) -> Node:
    """Returns exp(ε X) = I + ε X, since the series ends, or exp(α ũ) for a unit vector u by Rodrigues'
    formula."""
    argument = term.arguments[0]
    turn = angle_and_axis(argument, NoDefinitions())
    if turn is not None and (not isinstance(turn[1], Symbol) or term.type.kind == "quaternion"):
        raise NotCertified("the exponential of a quaternion, or of an angle about an axis in numbers")
    if turn is not None:
        angle, axis = turn
        c, s, u = emitted_nodes.together((*circle(emitter, angle), emitter.term(axis)))
        text = f"rodrigues {c.at(ATOM)} {s.at(ATOM)} {u.at(ATOM)}"
        skew = f"(Skew {u.deep})"
        sine_part = f"(Plus (Idt {flag(u.dual)}) (Scale {s.deep} {skew}))"
        rest = f"(Scale (Minus {emitted_nodes.number(1, u.dual).deep} {c.deep}) (Prod {skew} {skew}))"
        return Node(u.dual, "Tensor", text, APPLICATION, f"(Plus {sine_part} {rest})")
    inner = _over_epsilon(argument)
    if inner is None:
        raise NotCertified("the exponential of anything but ε X or α ũ")
    value = emitter.term(inner)
    if value.dual:
        raise NotCertified("the exponential of ε times a dual tensor")
    deep = f"(Plus (Idt true) (Scale Eps (Emb {value.deep})))"
    return Node(True, "Tensor", f"exp_eps {value.at(ATOM)}", APPLICATION, deep)


def _over_epsilon(argument: Term) -> Term | None:
    """Returns X of ε X, and −X of −ε X."""
    match argument:
        case Apply(head="mul", arguments=(DualUnit(), inner)):
            return inner
        case Apply(head="neg", arguments=(body,)):
            over = _over_epsilon(body)
            return None if over is None else Apply(over.type, over.weight, "neg", (over,))
    return None


def norm(emitter: Collector, term: Apply) -> Node:
    """Returns ‖a‖ as a scalar n with n • n ≡ a · a, which may not be differentiated.

    The norm of a dual vector is given by that of its real part.
    """
    if term not in emitter.helpers:
        (inner,) = term.arguments
        if any(map(is_column, inner.walk())):  # Coq's division cannot handle such a number
            raise NotCertified("the norm of what is made of a column of numbers")
        value = emitter.term(inner)
        if value.kind != "Vector":
            raise NotCertified("a norm of anything but a vector")
        if value.dual:
            real = Apply(SCALAR, None, "norm", (part("re", inner),))
            n, y = norm(emitter, real), reciprocal(emitter, real)
            product = f"(Dot (Re {value.deep}) (Du {value.deep}))"
            deep = f"(Plus (Emb {n.deep}) (Scale Eps (Emb (Scale {y.deep} {product}))))"
            text = f"dual_length {value.at(ATOM)} {n.at(ATOM)} {y.at(ATOM)}"
            emitter.helpers[term] = Node(True, "Scalar", text, APPLICATION, deep)
            return emitter.helpers[term]
        if emitter.steps:
            raise NotCertified("a norm after a quotient")
        name = emitter.fresh("length")
        made = emitter.helper(emitter.slot(False, "Scalar", name), "length", value)
        square = emitted_nodes.raised(value, 2)
        says = [(f"(Scale {made.deep} {made.deep})", square.deep)]
        known = emitter.suppose(f"{name} • {name} ≡ {square.text}", f"{name}_is", says)
        emitter.values.append(single(f"Rule {says[0][0]} {says[0][1]}", known))
        emitter.read_back[name] = term
        emitter.helpers[term] = made
    return emitter.helpers[term]


def part(head: Head, term: Term) -> Term:
    """Returns the real or the dual part of a dual term."""
    return Apply(term.type.with_dual(False), None, head, (term,))


HEADS: dict[str, Callable[[Collector, Apply], Node]] = {
    "div": quotient,
    "inverse": inverse,
    "cos": cosine,
    "sin": sine,
    "exp": exponential,
    "norm": norm,
}
