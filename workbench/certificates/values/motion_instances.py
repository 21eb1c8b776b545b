"""Motions on which the premises of a statement hold: each variable as a term in cos t, sin t and t.

Such a motion shows that the premises can be met, so that a theorem is not vacuous. If the conclusion fails on
it, it is a counterexample.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.collector import Collector, Origin
from workbench.certificates.emission.emitted_nodes import ATOM, Node, NotCertified, flag, rational
from workbench.certificates.values import trigonometric
from workbench.certificates.values.trigonometric import Values, flat, value

#: The symbols before those of a statement.
BASE = ((False, "Scalar", "cosine"), (False, "Scalar", "sine"), (False, "Scalar", "time"))
_C, _S, _T = (f"(Var false Scalar {i})" for i in range(3))

#: The number of random motions tried; the last one makes every free vector a spiral.
_ATTEMPTS = 60

#: The first index of quotients, above those of statements.
_QUOTIENTS = 2000

#: The order to which quotients are expanded at t = 0 when motions are compared.
_KNOWN = 6


def _number(value: int | Fraction) -> str:
    value = Fraction(value)
    return f"(Num false ({value.numerator} # {value.denominator}))"


def _triad(*parts: str) -> str:
    return f"(Triad {' '.join(parts)})"


def _turned(axis: int) -> str:
    """Returns Rodrigues' formula for the angle t about an axis."""
    skew = f"(Skew (Axis false {axis}))"
    rest = f"(Scale (Minus {_number(1)} {_C}) (Prod {skew} {skew}))"
    return f"(Plus (Plus (Idt false) (Scale {_S} {skew})) {rest})"


_VECTORS = (
    _triad(_C, _S, _number(1)),
    _triad(_number(1), _T, _number(0)),
    _triad(_T, _number(2), _S),
    _triad(_number(0), _number(1), _number(-1)),
    "(Zer false Vector)",
)
_SLOW = f"(Scale {_number(Fraction(1, 4))} {_T})"
_AHEAD = f"(Minus {_SLOW} {_number(1)})"
_SPIRAL = _triad(
    f"(Minus {_C} (Scale {_AHEAD} {_S}))", f"(Plus {_S} (Scale {_AHEAD} {_C}))", _SLOW
)  # its det Φ₃ is a quadratic without roots
_FIXED = (_triad(_number(1), _number(2), _number(-1)), "(Axis false 0)", "(Axis false 2)")
_CHOICES = {
    ("Scalar", "free"): (_T, _C, _number(2)),
    ("Scalar", "constant"): (_number(2), _number(-1)),
    ("Vector", "free"): _VECTORS,
    ("Vector", "constant"): _FIXED,
    ("Vector", "unit"): (_triad(_C, _S, _number(0)), "(Axis false 0)"),
    ("Vector", "unit constant"): (
        "(Axis false 0)",
        _triad(_number(Fraction(3, 5)), _number(Fraction(4, 5)), _number(0)),
    ),
    ("Tensor", "free"): (f"(Plus (Idt false) (Skew {_VECTORS[0]}))", f"(Outer {_VECTORS[0]} {_VECTORS[1]})"),
    ("Tensor", "constant"): (f"(Plus (Idt false) (Skew {_FIXED[0]}))",),
    ("Tensor", "rotation"): (f"(Prod {_turned(2)} {_turned(0)})", _turned(2), "(Idt false)"),
    ("Tensor", "rotation constant"): ("(Idt false)",),
}


@dataclass(frozen=True)
class Quotient:
    """1/x on a motion where x is p + q t + r t² and never 0, as a symbol with its own index. below: x."""

    place: str
    below: Node
    coefficients: tuple[Fraction, Fraction, Fraction]

    @property
    def text(self) -> str:
        return f"quadratic_over {' '.join(map(rational, self.coefficients))}"

    @property
    def quadratic(self) -> str:
        p, q, r = map(_number, self.coefficients)
        return f"(Plus (Plus {p} (Scale {q} {_T})) (Scale {r} (Scale {_T} {_T})))"

    @property
    def value(self) -> trigonometric.Wave:
        """The known terms of its series."""
        p, q, r = self.coefficients
        series = [1 / p, -q / p**2]
        for _ in range(_KNOWN - 1):
            series.append(-(q * series[-1] + r * series[-2]) / p)
        return trigonometric.Wave({(0, 0, k): x for k, x in enumerate(series)})


@dataclass(frozen=True)
class Instance:
    """The motion: text and deep copy of each variable, and all values."""

    variables: dict[Origin, tuple[str, str]]
    values: Values
    quotients: dict[Origin, Quotient] = field(default_factory=dict)

    def agree(self, left: str, right: str) -> bool:
        return flat(value(left, self.values)) == flat(value(right, self.values))

    def agree_at_zero(self, left: str, right: str) -> bool:
        sides = [[w.at_zero for w in flat(value(side, self.values))] for side in (left, right)]
        return sides[0] == sides[1]


def place(node: Node) -> tuple[str, str, str]:
    return flag(node.dual), node.kind, node.deep.split()[-1].rstrip(")")


def latest(emitter: Collector) -> list[Origin]:
    """Returns the meanings of the symbols; a premise may replace an earlier one."""
    last = {place(origin.node): origin for origin in emitter.origins}
    return [origin for origin in emitter.origins if last[place(origin.node)] is origin]


def instances(emitter: Collector) -> Iterator[Instance]:
    """Yields motions on which all premises hold, as far as exact values can tell."""
    divides = {name for name, text in emitter.premises if text.startswith(("inverse ", "reciprocal "))}
    for attempt in range(_ATTEMPTS + 1):
        made = _attempt(emitter, random.Random(attempt), attempt)
        if made is not None and all(
            made.agree(*pair)
            for name, pairs in emitter.holes.items()
            if not (made.quotients and name in divides)
            for pair in pairs
        ):
            yield made


def on_polynomials(emitter: Collector, given: Mapping[str, list[list[Fraction]]]) -> Instance:
    """Returns the motion on which the components of each variable have the given derivatives at t = 0."""
    values, variables = _base(), {}
    for origin in latest(emitter):
        if origin.how == "is":
            meaning = origin.meaning.deep
        else:
            meaning = _assembled(origin.node, [_polynomial(c) for c in given[origin.node.text]])
            variables[origin] = (f"made {meaning}", meaning)
        values[place(origin.node)] = value(meaning, values)
    return Instance(variables, values)


def _polynomial(derivatives: list[Fraction]) -> str:
    """Returns c₀ + t (c₁ + t/2 (c₂ + …))."""
    made = _number(derivatives[-1]) if derivatives else _number(0)
    for k in range(len(derivatives) - 1, 0, -1):
        step = f"(Scale (Scale {_number(Fraction(1, k))} {_T}) {made})"
        made = f"(Plus {_number(derivatives[k - 1])} {step})"
    return made


def _assembled(node: Node, entries: list[str]) -> str:
    """Returns a symbol composed of its components, real parts before dual parts."""
    if node.dual:
        half = len(entries) // 2
        real, dual = (_assembled(replace(node, dual=False), e) for e in (entries[:half], entries[half:]))
        return f"(Plus (Emb {real}) (Scale Eps (Emb {dual})))"
    match node.kind:
        case "Scalar":
            return entries[0]
        case "Vector":
            return _triad(*entries)
    rows = [f"(Outer (Axis false {i}) {_triad(*entries[3 * i : 3 * i + 3])})" for i in range(3)]
    return f"(Plus (Plus {rows[0]} {rows[1]}) {rows[2]})"


def _base() -> Values:
    waves = (trigonometric.COSINE, trigonometric.SINE, trigonometric.TIME)
    return {("false", "Scalar", str(i)): wave for i, wave in enumerate(waves)}


def _attempt(emitter: Collector, chance: random.Random, attempt: int) -> Instance | None:
    angles = {origin.meaning.deep for origin in emitter.origins if origin.how == "cos"}
    made = Instance({}, _base(), {})
    for origin in latest(emitter):
        said = (f"made {_T}", _T) if origin.node.deep in angles else _meaning(origin, made, chance, attempt)
        if said is None:
            return None
        try:
            made.values[place(origin.node)] = value(said[1], made.values)
        except KeyError:
            return None
        if origin.node.text in emitter.places:
            made.variables[origin] = said
    return made


def _over(origin: Origin, below: Node, made: Instance) -> Node | None:
    """Returns 1/x on the motion, if x is a number there or a quadratic without roots."""
    terms = dict(value(below.deep, made.values).terms)
    p, q, r = coefficients = tuple(terms.pop((0, 0, k), Fraction(0)) for k in range(3))
    if terms or (not p if not (q or r) else 4 * p * r <= q * q):
        return None
    if not (q or r):
        return emitted_nodes.number(1 / p)
    one = Quotient(str(_QUOTIENTS + len(made.quotients)), below, coefficients)
    made.quotients[origin] = one
    made.values["false", "Scalar", one.place] = one.value
    return Node(False, "Scalar", one.text, emitted_nodes.APPLICATION, f"(Var false Scalar {one.place})")


def _meaning(origin: Origin, made: Instance, chance: random.Random, attempt: int) -> tuple[str, str] | None:
    match origin.how:
        case "is":
            return origin.meaning.text, origin.meaning.deep
        case "over":
            over = _over(origin, origin.meaning, made)
            return None if over is None else (over.text, over.deep)
        case "inverse":
            of = origin.meaning
            over = _over(origin, emitted_nodes.call("det", "Det", "Scalar", of), made)
            if over is None:
                return None
            return f"{over.text} • adj {of.at(ATOM)}", f"(Scale {over.deep} (Adj {of.deep}))"
        case "cos":
            return "cosine", _C
        case "sin":
            return "sine", _S
    node = origin.node
    chosen = (_dual if node.dual else _chosen)(node.kind, origin.how, chance, attempt)
    return f"made {chosen}", chosen


def _chosen(kind: str, how: str, chance: random.Random, attempt: int) -> str:
    if (kind, how, attempt) == ("Vector", "free", _ATTEMPTS):
        return _SPIRAL
    choices = _CHOICES.get((kind, how))
    if choices is None:
        raise NotCertified(f"no motion of a {how} {kind.lower()}")
    return choices[0] if attempt == 0 else chance.choice(choices)


def _dual(kind: str, how: str, chance: random.Random, attempt: int) -> str:
    real = _chosen(kind, how, chance, attempt)
    if "rotation" in how:
        moved = _chosen("Vector", "constant" if "constant" in how else "free", chance, attempt)
        return f"(Prod (Plus (Idt true) (Scale Eps (Skew (Emb {moved})))) (Emb {real}))"
    if "unit" in how:
        moment = _chosen("Vector", "constant", chance, attempt)
        return f"(Plus (Emb {real}) (Scale Eps (Emb (Cross {moment} {real}))))"
    return f"(Plus (Emb {real}) (Scale Eps (Emb {_chosen(kind, how, chance, attempt)})))"
