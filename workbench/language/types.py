"""What a symbol or a term is: its type, its weight, and the declaration that a paper file gives for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from workbench.language.integers import Linear

Kind = Literal["scalar", "vector", "covector", "tensor", "operator", "block"]

#: The power of 1/time that a quantity carries; None: exempt from the weight check.
Weight = Linear | None


@dataclass(frozen=True, slots=True)
class Type:
    """A kind, real or dual. A block matrix also has the heights of its rows and the widths of its columns."""

    kind: Kind
    dual: bool = False
    rows: tuple[int, ...] = ()
    columns: tuple[int, ...] = ()

    def __str__(self) -> str:
        name = f"dual {self.kind}" if self.dual else self.kind
        if self.kind == "block":
            name += f" {self.rows}×{self.columns}"
        return name

    def with_dual(self, dual: bool) -> Type:
        return Type(self.kind, dual, self.rows, self.columns)


SCALAR = Type("scalar")
VECTOR = Type("vector")
COVECTOR = Type("covector")
TENSOR = Type("tensor")
OPERATOR = Type("operator")


@dataclass(frozen=True, slots=True)
class Declaration:
    """What a paper file says of a symbol.

    name: canonical LaTeX, unique in a paper, each index place marked `@`: `\\Phi_{@}`, `\\mathbf{K}_{@,@}`.
    type, weight: of one member; the weight of a family is linear in its indices, called `@0`, `@1`, … there.
    constant: its time derivative is 0.   unit: a vector with x·x = 1 (dual: |x| = 1).
    rotation: a tensor with R Rᵀ = I and det R = 1.
    coordinate: the place of a field; div and curl differentiate by it.
    parameters: how many arguments a function symbol such as Φ_k(ω) takes.
    """

    name: str
    type: Type
    weight: Weight = None
    constant: bool = False
    unit: bool = False
    rotation: bool = False
    coordinate: bool = False
    indices: int = 0
    parameters: int = 0
