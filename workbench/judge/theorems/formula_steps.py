"""Steps of an argument that are formulas: read from LaTeX, proved by both engines of the judge.

    letters = Letters({r"\\mathbf{R}": {"kind": "rotation"}, "a": {"kind": "vector"}})
    letters.step("rotations keep lengths", r"(\\mathbf{R} a)^2 = a^2", but_not=r"(\\mathbf{R} a)^2 = 2 a^2")

`but_not` is the step's control: a formula that is false, and that the engines must not find true.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, partial
from itertools import product
from typing import Any

from workbench.judge.theorems.arguments import Engine, Step, Way, vanishing
from workbench.judge.theorems.controls import is_another_sign_of
from workbench.language.defining import read_definitions
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_formula
from workbench.language.typed.instances import instantiate
from workbench.language.typed.terms import Conjunction, Relation, Statement

Orders = Mapping[str, Iterable[int]]


@dataclass(frozen=True)
class Letters:
    """What the letters of an argument's formulas are: [symbols] and [definitions] as in a paper file."""

    symbols: Mapping[str, Mapping[str, Any]]
    definitions: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def _notation(self) -> tuple[Definitions, SymbolTable]:
        return read_definitions(self.definitions, SymbolTable.build(self.symbols))

    def step(self, shown: str, *formulas: str, but_not: str, orders: Orders | None = None) -> Step:
        """The step that the formulas hold for all values of their letters; a denominator must not be 0.

        orders: the values of integer variables, for which each formula is checked one by one.
        Raises ReadError or IllFormedAt for a formula that cannot be read, ValueError for one that is not
        an equation (or a chain of them), or for a control that differs from a formula by signs alone.
        """
        said = [relation for formula in formulas for relation in self._relations(formula, orders)]
        denied = list(self._relations(but_not, orders))
        if all(any(is_another_sign_of(wrong, right) for right in said if right != wrong) for wrong in denied):
            raise ValueError(
                f"step {shown!r}: expected a control without a premise or a factor, one that differs by"
                f" more than signs; got {but_not}"
            )
        return Step(
            shown,
            *(
                Way(
                    engine,
                    vanishing(partial(residuals, self, said)),
                    vanishing(partial(residuals, self, denied)),
                )
                for engine, residuals in ((Engine.FLINT, _by_flint), (Engine.SYMPY, _by_sympy))
            ),
        )

    def refutation(self, shown: str, formula: str, but_not: str) -> Step:
        """The step that the equation does not hold for all values; its control is one that does."""
        said, true = (list(self._relations(f, None)) for f in (formula, but_not))
        engines = ((Engine.FLINT, _by_flint), (Engine.SYMPY, _by_sympy))
        checks = [(engine, partial(_differs, residuals, self)) for engine, residuals in engines]
        return Step(shown, *(Way(engine, partial(f, said), partial(f, true)) for engine, f in checks))

    def _relations(self, formula: str, orders: Orders | None) -> Iterator[Relation]:
        orders = orders or {}
        for statement in read_formula(formula, self._notation[1], orders).statements:
            for values in product(*orders.values()):
                yield from _equations(instantiate(statement, dict(zip(orders, values, strict=True))))


def _differs(
    residuals: Callable[[Letters, Iterable[Relation]], Iterator[Any]],
    letters: Letters,
    relations: Iterable[Relation],
) -> Iterator[bool]:
    yield not all(vanishing(partial(residuals, letters, relations))())


def _equations(statement: Statement) -> Iterator[Relation]:
    match statement:
        case Relation(operator="="):
            yield statement
        case Conjunction(parts=parts):
            for part in parts:
                yield from _equations(part)
        case _:
            raise ValueError("expected an equation, got another statement")


def _by_flint(letters: Letters, relations: Iterable[Relation]) -> Iterator[Any]:
    from workbench.judge.first.exact import ExactEngine
    from workbench.judge.subject.inventory import take_inventory

    definitions = letters._notation[0]
    for relation in relations:
        engine = ExactEngine(take_inventory((relation.left, relation.right), definitions), definitions)
        yield from engine.residuals(relation)


def _by_sympy(letters: Letters, relations: Iterable[Relation]) -> Iterator[Any]:
    from workbench.judge.second.jets import JetEngine
    from workbench.judge.second.rings import PointSource
    from workbench.judge.second.sympy_ring import SympyRing
    from workbench.judge.subject.inventory import take_inventory

    definitions = letters._notation[0]
    for relation in relations:
        ring = SympyRing(take_inventory((relation.left, relation.right), definitions))
        engine = JetEngine(PointSource(ring, ring.point), definitions)
        for difference in engine.differences(relation.left, relation.right):
            yield ring.normal(ring.lift(difference).top)
