"""Random values of parameters modulo the prime, in FLINT."""

from __future__ import annotations

from random import Random

from flint import nmod

from workbench.core.terms import Symbol
from workbench.engines.inventory.parameters import SPHERES, Parameter
from workbench.engines.jet.rings import PRIME
from workbench.language.printing.printer import to_latex


class FlintResidueRing:
    """The integers modulo PRIME in FLINT. It only screens, so it need not be independent of the first
    engine."""

    def __init__(self) -> None:
        self.took_roots = False

    def constant(self, numerator: int, denominator: int) -> nmod:
        return nmod(numerator, PRIME) / nmod(denominator, PRIME)

    def divide(self, a: nmod, b: nmod) -> nmod:
        if not b:
            raise ZeroDivisionError("division by zero modulo the prime")
        return nmod(int(a), PRIME) / b

    def root(self, square: nmod) -> nmod:
        """Returns one of the two roots, always the same.

        The other root would serve equally in identities that hold for either sign of norms; the judge rejects
        others.
        """
        self.took_roots = True
        root = square ** ((PRIME + 1) // 4)
        if root * root != square:
            raise ZeroDivisionError("no root modulo the prime at this point")
        return root


class RandomPoint(dict):
    """A point with a random value for each parameter, drawn at first use."""

    def __init__(self, seed: int) -> None:
        super().__init__()
        self._seed = seed

    def __missing__(self, parameter: Parameter) -> nmod:
        symbol = parameter.symbol
        place = to_latex(symbol)  # the angle of a circle may also be a product or a norm
        if isinstance(symbol, Symbol):
            place = f"{symbol.declaration.name} {symbol.index} {symbol.arguments or ''}"
        key = f"{self._seed} {place} {parameter.part}"
        if parameter.part in SPHERES:
            self._put_on_sphere(parameter, Random(key))
        else:
            place = f"{key} {parameter.order} {parameter.component}"
            self[parameter] = nmod(Random(place).randrange(1, PRIME), PRIME)
        return self[parameter]

    def _put_on_sphere(self, parameter: Parameter, random: Random) -> None:
        """Sets a random point on a sphere by stereographic projection."""
        slopes = [nmod(random.randrange(1, PRIME), PRIME) for _ in range(SPHERES[parameter.part] - 1)]
        square = sum((t * t for t in slopes), start=nmod(0, PRIME))
        for index, x in enumerate([1 - square, *(t + t for t in slopes)]):
            self[Parameter(parameter.symbol, parameter.part, 0, index)] = x / (1 + square)
