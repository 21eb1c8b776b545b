"""The only module that imports SymPy. It ensures that SymPy computes with Python's integers.

SymPy uses FLINT's numbers if python-flint is installed, and chooses at its first import, which may be
elsewhere. `ZZ` and `QQ` always compute with Python's integers. Other parts of SymPy compute with the numbers
that SymPy chose, so this module refuses to hand them out if these are not Python's.
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

from workbench.engines.inventory import NotExact

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

#: Functions that compute with the numbers that SymPy chose → their modules.
HOMES = {
    **dict.fromkeys(
        ("Matrix", "Symbol", "eye", "symbols", "zeros", "Float", "N", "Rational", "pi", "sqrt"), "sympy"
    ),
    **dict.fromkeys(("sin", "cos", "exp", "acos", "asin", "atan", "atan2"), "sympy"),
    **dict.fromkeys(("factorial", "binomial"), "sympy"),
    "DomainMatrix": "sympy.polys.matrices",
}


class PythonIntegers(PythonIntegerRing):
    """ℤ as Python integers; SymPy's own class uses the numbers that SymPy chose."""

    tp = int


class PythonRationals(PythonRationalField):
    """ℚ on Python integers, regardless of SymPy's choice: its own field would divide by FLINT."""

    def from_ZZ(self, a: Any, domain: Any) -> PythonRational:
        """Returns an integer of SymPy's own ring, which wraps Python integers, as a rational."""
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
    """Raises RuntimeError if a coefficient is not a Python integer or a fraction of two Python integers."""
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
