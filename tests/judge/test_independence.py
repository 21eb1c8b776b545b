"""The two engines share nothing but what a statement is about: neither code nor numbers, whatever is imported
first. And what is imported of SymPy and Drake is imported in one place each."""

import os
import subprocess
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest
from test_imports import graph, imported, modules

import proofs
import workbench
from workbench.engines.jet import sympy_gate
from workbench.engines.jet.sympy_gate import QQ, ZZ, lex, polynomial_ring, require_python_integers

ROOT = Path(workbench.__file__).parent
SOURCES = {**modules(ROOT), **modules(Path(proofs.__file__).parent)}

#: What an engine must not know, by the room in which it stands.
FOREIGN = {
    "workbench.engines.polynomial": {"workbench.engines.jet", "sympy", "pydrake"},
    "workbench.engines.jet": {"workbench.engines.polynomial", "workbench.algebra", "flint"},
}
GATES = {"sympy": "workbench.engines.jet.sympy_gate", "pydrake": "workbench.drake.gate"}


def within(name: str, room: str) -> bool:
    return name == room or name.startswith(f"{room}.")


def reached(room: str, sources: dict[str, str]) -> Iterator[str]:
    """What the modules of a room import, and what these import, to the end; a package alone opens no module."""
    edges = graph(sources)
    waiting = [module for module in sources if within(module, room)]
    seen = set(waiting)
    while waiting:
        module = waiting.pop()
        yield from imported(sources[module], module)
        for other in edges[module] - seen:
            seen.add(other)
            waiting.append(other)


@pytest.mark.parametrize("room", FOREIGN)
def test_an_engine_knows_neither_the_other_nor_its_numbers(room):
    found = {name for name in reached(room, SOURCES) for foreign in FOREIGN[room] if within(name, foreign)}
    assert not found


@pytest.mark.parametrize("room", FOREIGN)
def test_a_foreign_import_is_seen_however_deep_it_is(room):
    for foreign in FOREIGN[room]:
        sources = {
            f"{room}.a": "from workbench.language import b\n",
            "workbench.language.b": f"import {foreign}.c\n",
        }
        assert any(within(name, foreign) for name in reached(room, sources))


@pytest.mark.parametrize("package", GATES)
def test_there_is_one_gate(package):
    users = {
        module for module, source in SOURCES.items() for name in imported(source, "") if within(name, package)
    }
    assert users <= {GATES[package]}


def run(code):
    """In a new interpreter, with SymPy free to choose its numbers."""
    environment = {name: value for name, value in os.environ.items() if name != "SYMPY_GROUND_TYPES"}
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=120, env=environment
    )


IDENTITY = r"""
from workbench.language.definitions import Definitions
from workbench.language.reader import read
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.decide.decide import Judge

table = SymbolTable.build({"a": {"kind": "vector"}, "R": {"kind": "rotation"}, "f": {"kind": "scalar"}})
for latex, assume in ((r"R \frac{a}{3 f} = \frac{1}{3 f} R a", r"f \neq 0"), (r"\|3 a\| = 3 \|a\|", r"f \neq 0"),
                      (r"\frac{f}{2} = \frac{1}{3}", r"3 f = 2")):
    (statement,), (given,) = read(latex, table, ()), read(assume, table, ())
    verdict = Judge(Definitions()).judge(statement, (given,))
    assert verdict.outcome == "proved", verdict
    assert any("Python integers" in e.method for e in verdict.evidence)
"""
FLINT_FIRST = "import os; os.environ['SYMPY_GROUND_TYPES'] = 'flint'\nimport sympy; assert type(sympy.QQ(1)).__module__.startswith('flint')\n"
IMPORTED_FIRST = "import sympy\nassert sympy.external.gmpy.GROUND_TYPES == 'flint'\n"
SPY = """
import workbench.engines.jet.sympy_ring as engine
from sympy.external.pythonmpq import PythonMPQ
seen, ring = set(), engine.SympyRing.tops
def tops(self, values):
    found = ring(self, values)
    for p in (*found, *self.relations, *self.denominators, *(x.top for x in self.point.values())):
        seen.update((type(c), type(c.numerator)) for c in p.coeffs())
    return found
engine.SympyRing.tops = tops
over = engine.SympyRing.over_rationals
def over_rationals(self, polynomials):
    found = over(self, polynomials)
    seen.update((type(c), type(c.numerator)) for p in found for c in p.coeffs())
    return found
engine.SympyRing.over_rationals = over_rationals
"""


@pytest.mark.parametrize(
    "before", ["", IMPORTED_FIRST, FLINT_FIRST, "import flint\n"], ids=["first", "later", "flint", "alone"]
)
def test_the_second_engine_computes_with_python_integers(before):
    code = before + SPY + IDENTITY + "assert seen == {(int, int), (PythonMPQ, int)}, seen\n"
    done = run(code)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("numbers", ["ZZ", "QQ"])
def test_with_flint_s_numbers_there_is_no_verdict(numbers):
    """If integers or rationals were SymPy's own, which are FLINT's here, the engine would say so."""
    code = (
        FLINT_FIRST
        + "from workbench.engines.jet import packed_polynomials as packed, sympy_ring\n"
        + f"packed.{numbers} = sympy_ring.{numbers} = sympy.{numbers}\n"
        + IDENTITY
    )
    done = run(code)
    assert done.returncode and "RuntimeError: the second engine computes with flint" in done.stderr


def test_sympy_with_flint_numbers_is_rejected():
    code = FLINT_FIRST + "from workbench.engines.jet.sympy_gate import Matrix\n"
    done = run(code)
    assert "NotExact: SymPy was imported with flint's numbers" in done.stderr
    code = "from workbench.engines.jet.sympy_gate import Matrix, QQ\nassert type(QQ(1, 2).numerator) is int\n"
    assert run(code).returncode == 0


def test_foreign_coefficients_are_detected():
    ring, x = polynomial_ring("x", QQ, lex)
    require_python_integers(x / 3 + 1, ring.zero, polynomial_ring("x", ZZ, lex)[1])
    with pytest.raises(RuntimeError, match="computes with"):
        require_python_integers(x, polynomial_ring("x", sympy_gate.import_module("sympy").RR, lex)[1])


def test_the_field_is_a_field():
    a, b = QQ(3, 4), QQ(-5, 6)
    assert QQ.quo(a, b) * b == a and QQ.exquo(a, b) == a / b
    assert QQ.div(a, b) == (a / b, QQ.zero) and QQ.rem(a, b) == 0


@pytest.mark.parametrize(("name", "home"), sympy_gate.HOMES.items())
def test_a_name_of_the_table_is_sympy_s(name, home):
    assert getattr(sympy_gate, name) is getattr(import_module(home), name)


def test_a_name_that_is_not_in_the_table_is_refused():
    import workbench.drake.gate as drake

    for gate in (sympy_gate, drake):
        with pytest.raises(AttributeError, match="is not among the names"):
            gate.Integral  # noqa: B018
