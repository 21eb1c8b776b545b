"""Operations of the claim language: the type of the value, the spelling, and where each is linear.

The engines and the certificates do not read this table; each implements the operations independently.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from workbench.core import signatures
from workbench.core.signatures import Signature, function, of_square, times, total_weight, weightless
from workbench.core.terms import Head
from workbench.core.types import QUATERNION, SCALAR, TENSOR, VECTOR


@dataclass(frozen=True, slots=True)
class Operator:
    """One operation.

    signature: computes the type and weight of the value.
    words: the names of the function, the printed one first.   sign: the infix sign between two arguments.
    superscript: the superscript of the argument.
    linear: in each argument ("each"); in each argument of scalars, vectors and tensors, which d/dt and Σ
    treat component by component ("components"); in all arguments together ("jointly"); or "".
    partner: the operation that readers confuse it with.
    takes: "tensor": an argument without brackets extends over all tensors that follow; "angle": another
    factor may follow it.   by_place: it differentiates by the coordinate.
    """

    signature: Signature
    words: tuple[str, ...] = ()
    sign: str = ""
    superscript: str = ""
    linear: Literal["", "components", "each", "jointly"] = ""
    partner: Head | None = None
    takes: Literal["", "tensor", "angle"] = ""
    by_place: bool = False


_SCALARS = function(("scalar",), SCALAR, weightless)
_VECTORS = ("vector", "vector")

#: Operations by the head of the term.
OPERATORS: dict[Head, Operator] = {
    "add": Operator(signatures.add, linear="jointly"),
    "neg": Operator(signatures.as_argument, linear="components"),
    "dot": Operator(signatures.dot, sign="·", linear="components"),
    "cross": Operator(function(_VECTORS, VECTOR, total_weight), sign="×", linear="components"),
    # The Kronecker product of matrices. ⊗ of vectors is the dyad.
    "kronecker": Operator(signatures.kronecker, sign="⊗", linear="components"),
    "outer": Operator(function(_VECTORS, TENSOR, total_weight), sign="⊗", linear="components"),
    "mul": Operator(signatures.mul, linear="components"),
    "compose": Operator(signatures.compose, sign="∘", linear="each"),
    "triple": Operator(function((*_VECTORS, "vector"), SCALAR, total_weight), linear="components"),
    "div": Operator(signatures.div),
    "det": Operator(of_square(SCALAR, None), ("det",), partner="trace", takes="tensor"),
    "trace": Operator(
        of_square(SCALAR, 1), ("trace", "tr", "Tr"), linear="components", partner="det", takes="tensor"
    ),
    "symmetric": Operator(
        of_square(None, 1), ("sym",), linear="components", partner="antisymmetric", takes="tensor"
    ),
    # The skew part of a tensor. The word alone is read as the skew tensor of a vector.
    "antisymmetric": Operator(
        of_square(None, 1), ("skew",), linear="components", partner="symmetric", takes="tensor"
    ),
    "skew": Operator(function(("vector",), TENSOR, times(1)), ("skew",), linear="components", takes="tensor"),
    "vect": Operator(function(("tensor",), VECTOR, times(1)), ("vect",), linear="components", takes="tensor"),
    # The columns of a matrix below each other.
    "vec": Operator(signatures.columns_below, ("vec",), linear="components", takes="tensor"),
    "transpose": Operator(signatures.transpose, superscript="T", linear="components", takes="tensor"),
    "inverse": Operator(signatures.inverse, superscript="-1"),
    "adjugate": Operator(
        function(("tensor",), TENSOR, times(2)), ("adj",), superscript="*", takes="tensor"
    ),
    "re": Operator(signatures.part, ("Re",), linear="each", partner="du"),
    "du": Operator(signatures.part, ("Du",), linear="each", partner="re"),
    "norm": Operator(signatures.norm),
    "root": Operator(signatures.root, ("sqrt",)),
    "exp": Operator(signatures.exp, ("exp",)),
    "log": Operator(signatures.log, ("log", "ln")),
    # x^y of scalars, where y is no integer
    "pow": Operator(signatures.power_of_scalars),
    "sin": Operator(_SCALARS, ("sin",), partner="cos", takes="angle"),
    "cos": Operator(_SCALARS, ("cos",), partner="sin", takes="angle"),
    "arccos": Operator(_SCALARS, ("arccos", "acos"), takes="angle"),
    "arcsin": Operator(_SCALARS, ("arcsin", "asin"), takes="angle"),
    "arctan": Operator(_SCALARS, ("arctan", "atan"), takes="angle"),
    "atan2": Operator(signatures.arc_of_two, ("atan2", "arctan2")),
    "divergence": Operator(
        function(("vector",), SCALAR, times(1)), ("div",), linear="each", partner="curl", by_place=True
    ),
    "curl": Operator(
        function(("vector",), VECTOR, times(1)), ("curl", "rot"), linear="each",
        partner="divergence", by_place=True
    ),
    "partial": Operator(signatures.partial),
    "total": Operator(signatures.partial),
    "quaternion": Operator(signatures.quaternion, ("quat",)),
    "conjugate": Operator(
        function(("quaternion",), QUATERNION, times(1)), ("conj",), superscript="*", linear="each"
    ),
    "scalar part": Operator(function(("quaternion",), SCALAR, times(1)), ("Sc",), linear="each"),
    "vector part": Operator(function(("quaternion",), VECTOR, times(1)), ("Vec",), linear="each"),
}  # fmt: skip

#: Functions that are read as quotients of sines and cosines; None stands for 1.
QUOTIENTS: dict[str, tuple[Head | None, Head]] = {
    "tan": ("sin", "cos"), "cot": ("cos", "sin"), "sec": (None, "cos"), "csc": (None, "sin")
}  # fmt: skip
#: Functions that are read as sums of e^x and e^{-x}, or as a quotient of such sums.
HYPERBOLIC = ("sinh", "cosh", "tanh")
#: Functions that are read as x/|x|.
SIGNS_OF = ("sgn", "sign")

#: Name of a function in a paper → head of the term, or of the term that it is read as.
FUNCTIONS = {word: head for head, operator in OPERATORS.items() for word in operator.words} | {
    name: name for name in (*QUOTIENTS, *HYPERBOLIC, *SIGNS_OF)
}
SIGNS: dict[str, Head] = {operator.sign: head for head, operator in OPERATORS.items() if operator.sign}

#: Functions that have a TeX command of the same name.
TEX_FUNCTIONS = frozenset(
    ("det", "exp", "log", "ln", "sin", "cos", "arccos", "arcsin", "arctan", *QUOTIENTS, *HYPERBOLIC)
)


def _heads(has: Callable[[Operator], bool]) -> frozenset[Head]:
    return frozenset(head for head, operator in OPERATORS.items() if has(operator))


LINEAR = _heads(lambda operator: operator.linear in ("each", "components"))
COMPONENTWISE = _heads(lambda operator: operator.linear == "components")
#: Products of two factors.
PRODUCTS: tuple[Head, ...] = ("dot", "cross", "outer", "mul")
OF_TENSORS = _heads(lambda operator: operator.takes == "tensor")
#: Sine, cosine and their quotients.
CIRCULAR = frozenset({"sin", "cos", *QUOTIENTS})
OF_ANGLES = _heads(lambda operator: operator.takes == "angle") | {*QUOTIENTS, *HYPERBOLIC}
#: Functions of scalars whose argument may be written without brackets.
OF_SCALARS = OF_ANGLES | {"exp", "log"}
GRADIENTS = _heads(lambda operator: operator.by_place)
#: Operations that differentiate by a variable other than time or place.
PARTIALS = frozenset(("partial", "total"))


def word_of(head: str) -> str:
    """Returns the printed word of the operation: det, sym."""
    return OPERATORS[head].words[0] if head in OPERATORS and OPERATORS[head].words else head


def command_of(head: str) -> str:
    """Returns the operation as a LaTeX function: \\det, \\operatorname{sym}."""
    word = word_of(head)
    return f"\\{word}" if word in TEX_FUNCTIONS else f"\\operatorname{{{word}}}"
