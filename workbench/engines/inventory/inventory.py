"""Inventory of a statement before any arithmetic: its free symbols and the orders of their derivatives.

Both engines allocate their indeterminates from this list. It also shows a check that would test nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from workbench.core.construct import apply, derivative, number
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.terms import Apply, BigSum, Derivative, Power, Symbol, Term, TimeOperator, heads_in
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.engines.inventory.angle_combinations import angles_of, is_free_angle
from workbench.engines.inventory.partial_derivatives import require_known_dependence, seeds
from workbench.language.printing.printer import to_latex


@dataclass
class Inventory:
    """orders: free symbol → highest time derivative that occurs.   angles: free ones under sin, cos or exp.
    circles: other terms there, such as ω t or ‖x‖ → the part of it that has its own sine and cosine.
    reciprocals, norms: the number of divisions (or inverses) and of norms, including those in definitions.
    has_roots: True if there is a norm or a root other than the angle ‖x‖ of exp x̃, which is smooth at x = 0.
    """

    orders: dict[Symbol, int] = field(default_factory=dict)
    angles: dict[Symbol, None] = field(default_factory=dict)
    circles: dict[Term, Term] = field(default_factory=dict)
    reciprocals: int = 0
    norms: int = 0
    has_roots: bool = False


def take_inventory(terms: Iterable[Term], definitions: Lookup, slopes: bool = True) -> Inventory:
    """Returns the inventory of all terms together. Raises NotExact if an integer variable is unbound.

    slopes: whether a slope of a function counts as a rate of it; it does in an engine, but ∂H/∂q has no rate.
    """
    survey = _Survey(definitions, slopes)
    for term in terms:
        for symbol, order in survey.orders(term).items():
            known = survey.inventory.orders.get(symbol, 0)
            survey.inventory.orders[symbol] = max(known, order)
    survey.add_coordinates()
    survey.add_roots_of_factors()
    return survey.inventory


def has_gradient(terms: Iterable[Term]) -> bool:
    """True if the terms, as written, contain a div, curl or partial derivative."""
    heads = GRADIENTS | PARTIALS
    return not all(heads.isdisjoint(heads_in(term)) for term in terms)


class _Survey:
    def __init__(self, definitions: Lookup, slopes: bool) -> None:
        self.definitions = definitions
        self.slopes = slopes
        self.inventory = Inventory()
        self._known: dict[Term, dict[Symbol, int]] = {}
        self._sizes: dict[Term, int] = {}
        self._turning: Term | None = None  # the angle ‖x‖ of exp x̃
        self._factors = 0  # number of factors under roots, such as the m and r of √(m r)

    def orders(self, term: Term) -> dict[Symbol, int]:
        if isinstance(term, Apply) and term.head in ("norm", "root") and term is not self._turning:
            self.inventory.has_roots = True
        if term not in self._known:
            self._known[term] = self._survey(term)
        return self._known[term]

    def _survey(self, term: Term) -> dict[Symbol, int]:
        if isinstance(term, Symbol):
            body = self.definitions.lookup(term)
            self._factors += term.declaration.positive
            return {term: 0} if body is None else self.orders(body)
        if isinstance(term, BigSum):
            raise NotExact("a sum whose bounds are not numbers")
        if isinstance(term, Power) and not term.exponent.is_number:
            raise NotExact(f"a power with the exponent {term.exponent}")
        shift = 0
        if isinstance(term, Derivative):
            if not term.order.is_number:
                raise NotExact(f"a derivative of order {term.order}")
            shift = term.order.constant
        if isinstance(term, Apply):
            self._count(term)
        merged: dict[Symbol, int] = {}
        for place, child in enumerate(term.children):
            raised = shift + self._raised(term, place)
            for symbol, order in self.orders(child).items():
                merged[symbol] = max(merged.get(symbol, 0), order + raised)
        if isinstance(term, Apply) and term.head in GRADIENTS:
            _require_known_places(term, merged)
        if isinstance(term, Apply) and term.head in PARTIALS:
            body, by = term.arguments
            if term.head == "total" and self._holds_rates(body):
                raise NotExact("a time derivative under d/dx; it may change with x")
            by_what = seeds(by, self.definitions)
            differentiated = self.orders(_without_slopes(body))
            require_known_dependence(term.head, by_what, differentiated, self._moving(body))
            for symbol in merged:
                merged[symbol] += self.slopes and bool(symbol.declaration.of)
        return merged

    def add_coordinates(self) -> None:
        """Adds the coordinates of functions, with the same orders of derivatives as the functions."""
        known = self.inventory.orders
        waiting = list(known)
        while waiting:
            function = waiting.pop()
            for argument in function.declaration.of:
                for symbol, own in self.orders(argument).items():
                    if known.get(symbol, -1) < own + known[function]:
                        known[symbol] = own + known[function]
                        waiting.append(symbol)

    def add_roots_of_factors(self) -> None:
        """Adds a root for each factor, since √(m r) is √m √r."""
        if self.inventory.norms:
            self.inventory.norms += self._factors
            self.inventory.reciprocals += self._factors

    def _holds_rates(self, term: Term) -> bool:
        return any(isinstance(part, Derivative | TimeOperator) for part in reached(self.definitions, term))

    def _moving(self, term: Term) -> set[Symbol]:
        """Returns the free symbols under a time derivative in the term."""
        found: set[Symbol] = set()
        for part in reached(self.definitions, term):
            if isinstance(part, Derivative | TimeOperator):
                found |= self.orders(part.body if isinstance(part, Derivative) else term).keys()
        return found

    def _raised(self, term: Term, place: int) -> int:
        """Returns how often operators to the left differentiate the child with this index."""
        if isinstance(term, Power):
            return max(0, int(term.exponent) - 1) * self.degree(term.base)
        if isinstance(term, Apply) and term.head in ("mul", "compose") and place == 1:
            return self.degree(term.arguments[0])
        return 0

    def degree(self, term: Term) -> int:
        """Returns the power of D in an operator; 0 for other terms."""
        if term.type.kind != "operator":
            return 0
        match term:
            case TimeOperator():
                return 1
            case Symbol():
                body = self.definitions.lookup(term)
                return 0 if body is None else self.degree(body)
            case Power():
                return int(term.exponent) * self.degree(term.base)
            case Apply(head="mul" | "compose"):
                return sum(self.degree(a) for a in term.arguments)
        return max((self.degree(child) for child in term.children), default=0)

    def _count(self, term: Apply) -> None:
        if term.head in ("div", "inverse"):
            # a triangular matrix is inverted entry by entry
            self.inventory.reciprocals += term.type.rows if term.type.kind == "matrix" else 1
        elif term.head in ("norm", "root"):
            # a dual norm also divides by the real one, see Eq. (74)
            self.inventory.norms += 1
            self.inventory.reciprocals += 1
        elif term.head in ("sin", "cos", "exp"):
            self.inventory.reciprocals += term.type.kind == "matrix"  # sin α/α
            for angle, part in angles_of(term, self.definitions).items():
                if is_free_angle(angle):
                    self.inventory.angles[angle] = None
                else:
                    self._circle(angle, part)

    def _circle(self, angle: Term, part: Fraction) -> None:
        self._sizes[angle] = lcm(self._sizes.get(angle, 1), part.denominator)
        size = number(Fraction(1, self._sizes[angle]))
        if size.value == 1 and isinstance(angle, Symbol):
            self.inventory.angles[angle] = None
            return
        if isinstance(angle, Symbol):
            self.inventory.angles.pop(angle, None)
        self.inventory.circles[angle] = angle if size.value == 1 else apply("mul", size, angle)
        if angle not in self._known:
            self._turning = angle
            self.orders(angle)
            self._turning = None
            if isinstance(angle, Apply) and angle.head == "norm":
                self.inventory.reciprocals += 1  # sin ‖x‖/‖x‖


def _without_slopes(term: Term) -> Term:
    """Returns H for ∂²H/∂P∂Q, whose dependence is that of H."""
    while isinstance(term, Apply) and term.head in PARTIALS:
        term = term.arguments[0]
    return term


def _require_known_places(gradient: Apply, orders: Mapping[Symbol, int]) -> None:
    """Raises NotExact unless all symbols under div or curl have a declared dependence on the position.

    Nothing is uniform in space unless it is declared so: the velocity ρ̇ of the point at ρ is not.
    """
    for symbol, order in orders.items():
        if symbol.declaration.coordinate and order:
            rate = to_latex(derivative(symbol, order))
            where = f"{rate} in the {gradient.head}"
            raise NotExact(
                f"{where} depends on the place as the motion says; a formula for it makes it a field"
            )
        if not (symbol.declaration.uniform or symbol.declaration.coordinate):
            where = f"{symbol.declaration.name} in the {gradient.head}"
            raise NotExact(f"{where} may depend on the place; if not, declare uniform = true")
