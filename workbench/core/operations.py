"""The operations of the claim language: what each takes and gives, how it is written, what it is linear in.

The engines and the certificates do not read this table: each says by itself what an operation does.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from workbench.core import signatures
from workbench.core.signatures import Signature, function, of_square, times, total_weight, weightless
from workbench.core.types import QUATERNION, SCALAR, TENSOR, VECTOR


@dataclass(frozen=True, slots=True)
class Operator:
    """signature: the type and weight of its value.
    words: what it is called as a function, the printed one first.   sign: between its two arguments.
    superscript: of its argument.
    linear: in each argument ("each"); so that d/dt and Σ go through, which scalars, vectors and tensors have
    it component by component ("components"); in all arguments together ("jointly"); or not.
    partner: the operation for which it may be mistaken.
    takes: "tensor": an argument without brackets is all tensors that follow; "angle": it may be followed by
    another factor.   by_place: it differentiates by the coordinate.
    """

    signature: Signature
    words: tuple[str, ...] = ()
    sign: str = ""
    superscript: str = ""
    linear: Literal["", "components", "each", "jointly"] = ""
    partner: str = ""
    takes: Literal["", "tensor", "angle"] = ""
    by_place: bool = False


_SCALARS = function(("scalar",), SCALAR, weightless)
_VECTORS = ("vector", "vector")

#: By the head of the term.
OPERATORS: dict[str, Operator] = {
    "add": Operator(signatures.add, linear="jointly"),
    "neg": Operator(signatures.as_argument, linear="components"),
    "dot": Operator(signatures.dot, sign="·", linear="components"),
    "cross": Operator(function(_VECTORS, VECTOR, total_weight), sign="×", linear="components"),
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
    # the skew of a tensor; the word alone is read as that of a vector
    "antisymmetric": Operator(
        of_square(None, 1), ("skew",), linear="components", partner="symmetric", takes="tensor"
    ),
    "skew": Operator(function(("vector",), TENSOR, times(1)), ("skew",), linear="components", takes="tensor"),
    "vect": Operator(function(("tensor",), VECTOR, times(1)), ("vect",), linear="components", takes="tensor"),
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

#: Functions that are read as quotients of sines and cosines; None: 1.
QUOTIENTS = {"tan": ("sin", "cos"), "cot": ("cos", "sin"), "sec": (None, "cos"), "csc": (None, "sin")}
#: Functions that are read as sums of e^x and e^{-x}, and their quotient.
HYPERBOLIC = ("sinh", "cosh", "tanh")

#: What a function is called in a paper → the head of the term, or of what it is read as.
FUNCTIONS = {word: head for head, operator in OPERATORS.items() for word in operator.words} | {
    name: name for name in (*QUOTIENTS, *HYPERBOLIC)
}
SIGNS = {operator.sign: head for head, operator in OPERATORS.items() if operator.sign}

#: The functions for which TeX has a command of the same name.
TEX_FUNCTIONS = frozenset(("det", "exp", "sin", "cos", "arccos", "arcsin", "arctan", *QUOTIENTS, *HYPERBOLIC))


def _heads(has: Callable[[Operator], bool]) -> frozenset[str]:
    return frozenset(head for head, operator in OPERATORS.items() if has(operator))


LINEAR = _heads(lambda operator: operator.linear in ("each", "components"))
COMPONENTWISE = _heads(lambda operator: operator.linear == "components")
#: The products of two factors.
PRODUCTS = ("dot", "cross", "outer", "mul")
OF_TENSORS = _heads(lambda operator: operator.takes == "tensor")
#: Sine, cosine and their quotients.
CIRCULAR = frozenset({"sin", "cos", *QUOTIENTS})
OF_ANGLES = _heads(lambda operator: operator.takes == "angle") | {*QUOTIENTS, *HYPERBOLIC}
GRADIENTS = _heads(lambda operator: operator.by_place)
#: What differentiates by something else than the time or the place.
PARTIALS = frozenset(("partial", "total"))


def word_of(head: str) -> str:
    """What the operation is called: det, sym."""
    return OPERATORS[head].words[0] if head in OPERATORS and OPERATORS[head].words else head


def command_of(head: str) -> str:
    """The operation as a function in LaTeX: \\det, \\operatorname{sym}."""
    word = word_of(head)
    return f"\\{word}" if word in TEX_FUNCTIONS else f"\\operatorname{{{word}}}"
