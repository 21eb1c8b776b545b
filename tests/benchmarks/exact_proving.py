"""How long the exact engine takes to prove det Φₙ = det Sₙ + tₙ·Sₙtₙ, Eq. (53), beside SymPy on the same residual.

    uv run python tests/benchmarks/exact_proving.py [--largest N]

Prints seconds and ratios, every engine in this one run: FLINT (the first engine), the second engine over SymPy's
PolyRing and over Drake's polynomials, and `sympy.expand` of the residual as a person would type it.
"""

from __future__ import annotations

import argparse
from time import perf_counter

import sympy

from workbench.engines.inventory.assumptions import Assumptions
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.jet.consequences import recheck
from workbench.engines.jet.drake_ring import recheck_by_drake
from workbench.engines.jet.sympy_engine import SympyEngine
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.language.definition_entries import read_definition
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read


def acceleration_tensors():
    table = SymbolTable.build({r"\omega": {"kind": "vector", "weight": 1}})
    found = []
    for key, body in ((r"\Phi_1", r"\tilde{\omega}"), (r"\Phi_{n+1}", r"\dot{\Phi}_n + \Phi_n \Phi_1")):
        definition, table = read_definition(key, body, table)
        found.append(definition)
    return Definitions(found), table


def seconds(work, least=0.2):
    """The shortest of several runs, and what the last one returned."""
    shortest, spent, result = float("inf"), 0.0, None
    while spent < least:
        start = perf_counter()
        result = work()
        elapsed = perf_counter() - start
        shortest, spent = min(shortest, elapsed), spent + elapsed
    return shortest, result


def sympy_residual(n):
    """The same residual from symbols for the components of ω, ω̇, …; not expanded."""
    omegas = [sympy.Matrix(sympy.symbols(f"w{k}_:3")) for k in range(n)]
    t = sympy.Symbol("t")
    functions = [sympy.Function(f"w{i}")(t) for i in range(3)]
    names = {sympy.diff(f, t, k) if k else f: omegas[k][i] for i, f in enumerate(functions) for k in range(n)}
    skew = sympy.Matrix(
        [[0, -functions[2], functions[1]], [functions[2], 0, -functions[0]], [-functions[1], functions[0], 0]]
    )
    phi = skew
    for _ in range(n - 1):
        phi = (sympy.diff(phi, t) + phi * skew).expand()
    phi = phi.xreplace(names)
    s = (phi + phi.T) / 2
    a = (phi - phi.T) / 2
    vect = sympy.Matrix([a[2, 1], a[0, 2], a[1, 0]])
    return phi.det(method="berkowitz") - s.det(method="berkowitz") - (vect.T * s * vect)[0]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--largest", type=int, default=5, help="largest order n (SymPy's expand stops at 4)")
    largest = parser.parse_args().largest
    definitions, table = acceleration_tensors()
    print(
        f"{'n':>2} {'terms':>7} {'FLINT s':>9} {'PolyRing':>9} {'Drake':>9} {'expand':>9}   as multiples of FLINT"
    )
    for n in range(2, largest + 1):
        (statement,) = read(
            rf"\det \Phi_{n} = \det \operatorname{{sym}} \Phi_{n} + \operatorname{{vect}} \Phi_{n} \cdot "
            rf"(\operatorname{{sym}} \Phi_{n}) \operatorname{{vect}} \Phi_{n}",
            table,
        )
        inventory = take_inventory([statement.left, statement.right], definitions)

        def flint(statement=statement, inventory=inventory):
            engine = ExactEngine(inventory, definitions)
            assert all(p == 0 for p in engine.residuals(statement))
            return len(engine.value(statement.left)[0][0])

        base, terms = seconds(flint)
        row = [f"{n:>2} {terms:>7} {base:9.4f}"]
        polyring, agreed = seconds(
            lambda s=statement, i=inventory: recheck(s, SympyEngine(i, definitions), Assumptions(())), 0.0001
        )
        assert agreed
        row.append(f"{polyring / base:8.0f}×")
        drake, agreed = seconds(lambda s=statement, i=inventory: recheck_by_drake(s, i, definitions), 0.0001)
        row.append("        –" if agreed is None else f"{drake / base:8.0f}×")
        if n <= 4:
            residual = sympy_residual(n)
            expanding, zero = seconds(lambda r=residual: sympy.expand(r), 0.0001)
            assert zero == 0
            row.append(f"{expanding / base:8.0f}×")
        print(" ".join(row))


if __name__ == "__main__":
    main()
