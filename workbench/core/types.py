"""Types, weights and declarations of symbols."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any, Literal

from workbench.core.integer_expressions import Linear
from workbench.core.names import Name

Kind = Literal["scalar", "vector", "covector", "tensor", "matrix", "operator", "quaternion"]

_KINDS: dict[tuple[int, int], Kind] = {
    (1, 1): "scalar",
    (3, 1): "vector",
    (1, 3): "covector",
    (3, 3): "tensor",
}
_SIZE = re.compile(r"matrix ([1-9][0-9]?)[×x]([1-9][0-9]?)")

#: The power of 1/time that a quantity carries; None: exempt from the weight check.
Weight = Linear | None


@dataclass(frozen=True, slots=True)
class Type:
    """A matrix type: rows and columns of scalars, real or dual. An operator has 3×3 coefficients; a
    quaternion is a column of four with its own product."""

    rows: int
    columns: int
    dual: bool = False
    algebra: Literal["", "operator", "quaternion"] = ""

    @property
    def kind(self) -> Kind:
        return self.algebra or _KINDS.get((self.rows, self.columns), "matrix")

    @property
    def is_column(self) -> bool:
        """True for a vector of any length; a scalar is not a column."""
        return not self.algebra and self.columns == 1 and self.rows > 1

    @property
    def is_square(self) -> bool:
        """True for a scalar, a tensor or a larger square matrix."""
        return not self.algebra and self.rows == self.columns

    def __str__(self) -> str:
        name = f"matrix {self.rows}×{self.columns}" if self.kind == "matrix" else self.kind
        return f"dual {name}" if self.dual else name

    def with_dual(self, dual: bool) -> Type:
        return self if dual == self.dual else replace(self, dual=dual)


SCALAR = Type(1, 1)
VECTOR = Type(3, 1)
TENSOR = Type(3, 3)
OPERATOR = Type(3, 3, algebra="operator")
QUATERNION = Type(4, 1, algebra="quaternion")

#: Kinds of symbols in a paper file, besides n×m matrices. Hamilton's quaternions have i j = k and the scalar
#: part first.
KINDS = {
    "scalar": SCALAR,
    "vector": VECTOR,
    "tensor": TENSOR,
    "rotation": TENSOR,
    "transform": Type(4, 4),
    "hamilton quaternion": QUATERNION,
    "operator": OPERATOR,
}


def type_of_kind(kind: str) -> Type | None:
    """Returns the type of a kind, which may begin with 'dual '; None for an unknown kind."""
    plain = kind.removeprefix("dual ")
    size = _SIZE.fullmatch(plain)
    found = Type(int(size[1]), int(size[2])) if size else KINDS.get(plain)
    return found and found.with_dual(plain != kind)


class _Flag:
    """True if a declaration has the flag of this name."""

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, declaration: Declaration, owner: type) -> bool:
        return self.name in declaration.flags


@dataclass(frozen=True, slots=True)
class Declaration:
    """The declaration of a symbol in a paper file.

    name: unique in a paper.
    type, weight: of one member; the weight of a family is linear in its indices, called `@0`, `@1`, … there.
    flags: its properties, which the table of properties lists, and its roles in a paper.
    of: the symbols that it is a function of. It changes only with them (and with t, if t is among them).
    apart: the indices at which a family has no member, because another declared symbol is printed like it.
    parameters: the number of arguments of a function symbol such as Φ_k(ω).
    """

    name: Name
    type: Type
    weight: Weight = None
    flags: frozenset[str] = frozenset()
    of: tuple[Any, ...] = ()
    indices: int = 0
    apart: tuple[Any, ...] = ()
    parameters: int = 0

    # Properties (`properties.PROPERTIES`)
    constant = _Flag()  # its time derivative is 0
    unit = _Flag()  # a vector or quaternion with x·x = 1 (dual: |x| = 1)
    rotation = _Flag()  # a tensor with R Rᵀ = I and det R = 1
    transform = _Flag()  # a 4×4 matrix [R p; 0 1] with a rotation R
    symmetric = _Flag()
    diagonal = _Flag()
    positive = _Flag()  # greater than 0 at all times, so that it has a root (`definitions.squared_root`)
    small = _Flag()  # statements with ≈ hold to first order in it and its rates
    coordinate = _Flag()  # the position in a field; div and curl differentiate by it
    uniform = _Flag()  # the same at every position, so that div and curl treat it as a constant
    independent = _Flag()  # others are functions `of` it and it is a function of none: ∂/∂q keeps it fixed
    free = _Flag()  # it may have any value, even if the text seems to constrain it

    # Roles in a paper
    clock = _Flag()  # the time t, whose derivative is 1
    tilded = _Flag()  # with a tilde the letter is another symbol: its skew tensor is written without one
    introduced = _Flag()  # only definitions introduce its members; one without a definition is meaningless
    timed = _Flag()  # it is taken at other times than t, as in R(t + h)
    hidden = _Flag()  # in no formula, but frames and points are built from it; it may move arbitrarily

    def with_flags(self, **flags: bool) -> Declaration:
        """Returns the declaration with each of the flags set or cleared."""
        kept = self.flags.difference(flags)
        return replace(self, flags=kept.union(flag for flag, is_set in flags.items() if is_set))


#: The number π; a quarter turn has exact sines and cosines.
PI = Declaration(Name("\\pi"), SCALAR).with_flags(constant=True)

#: The time t.
CLOCK = Declaration(Name("t"), SCALAR).with_flags(independent=True, clock=True)
