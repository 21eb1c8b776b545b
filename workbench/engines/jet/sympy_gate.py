"""Where SymPy comes in: the one module that imports it, and sees to it that its numbers are Python's.

SymPy takes FLINT's numbers where python-flint is installed, and settles that when it is first imported,
perhaps by someone else. `ZZ` and `QQ` compute with Python's integers in any case. What else of SymPy is
handed out computes with the numbers that SymPy has settled on, so it is refused where these are not Python's.
"""

from __future__ import annotations

import os
from importlib import import_module
from typing import Any

os.environ.setdefault("SYMPY_GROUND_TYPES", "python")

from sympy.external.gmpy import GROUND_TYPES
from sympy.polys.domains.pythonintegerring import PythonIntegerRing
from sympy.polys.domains.pythonrational import PythonRational
from sympy.polys.domains.pythonrationalfield import PythonRationalField
from sympy.polys.groebnertools import groebner
from sympy.polys.orderings import grevlex, lex
from sympy.polys.rings import PolyElement, PolyRing
from sympy.polys.rings import ring as polynomial_ring

from workbench.engines.inventory.inventory import NotExact

__all__ = [
    "QQ",
    "ZZ",
    "PolyElement",
    "PolyRing",
    "grevlex",
    "groebner",
    "lex",
    "polynomial_ring",
    "require_python_integers",
]

#: What computes with the numbers that SymPy has settled on.
HOMES = {
    **dict.fromkeys(("Matrix", "eye", "symbols", "zeros", "Float", "N", "Rational", "pi", "sqrt"), "sympy"),
    **dict.fromkeys(("sin", "cos", "exp", "acos", "asin", "atan", "atan2"), "sympy"),
    **dict.fromkeys(("factorial", "binomial"), "sympy"),
    "DomainMatrix": "sympy.polys.matrices",
}


class PythonIntegers(PythonIntegerRing):
    """ℤ as Python's integers; SymPy's own class looks for the numbers that SymPy has settled on."""

    tp = int


class PythonRationals(PythonRationalField):
    """ℚ on Python's integers, whatever numbers SymPy has settled on: its own field then divides by FLINT."""

    def from_ZZ(self, a: Any, domain: Any) -> PythonRational:
        """Of an integer of SymPy's own ring, in which it wraps Python's."""
        return PythonRational(int(a))

    from_ZZ_gmpy = from_ZZ_python = from_ZZ

    def quo(self, a: PythonRational, b: PythonRational) -> PythonRational:
        return a / b

    exquo = quo

    def rem(self, a: PythonRational, b: PythonRational) -> PythonRational:
        return self.zero

    def div(self, a: PythonRational, b: PythonRational) -> tuple[PythonRational, PythonRational]:
        return a / b, self.zero


QQ = PythonRationals()
ZZ = PythonIntegers()


def require_python_integers(*polynomials: PolyElement) -> None:
    """Raises RuntimeError if a coefficient is anything but a Python integer or a fraction of two of them."""
    for p in polynomials:
        for c in p.values():
            if type(c) is int:
                continue
            if type(c) is not PythonRational or {type(c.numerator), type(c.denominator)} != {int}:
                raise RuntimeError(f"the second engine computes with {type(c).__module__}.{type(c).__name__}")


def __getattr__(name: str) -> Any:
    if name not in HOMES:
        raise AttributeError(f"{name} is not among the names that the workbench uses of SymPy")
    if GROUND_TYPES != "python":
        raise NotExact(
            f"SymPy was imported with {GROUND_TYPES}'s numbers, so it is no second engine; import workbench "
            "first, or set SYMPY_GROUND_TYPES=python"
        )
    return getattr(import_module(HOMES[name]), name)
