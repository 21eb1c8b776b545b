"""Macros of packages that print mathematics, as the declarations in LaTeX that make them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType

_FENCES = {"pqty": ("(", ")"), "bqty": ("[", "]"), "vqty": ("|", "|")}
_MATRICES = {"pmqty": "pmatrix", "bmqty": "bmatrix", "vmqty": "vmatrix", "Pmqty": "pmatrix"}
#: Shapes by the bracket that follows: \mqty(…), \mqty[…], \mqty|…|, \mqty{…}.
_SHAPES = ("pmatrix", "bmatrix", "vmatrix", "matrix")
_WORDS = "if then else otherwise unless given using assume since let for all even odd integer and or as in"
_SIGNS = {"cp": r"\times", "crossproduct": r"\times", "dotproduct": r"\cdot"}
_SIGNS |= dict.fromkeys(("qc", "qcomma"), r",\quad")
#: Operators with ∇, whose argument may stand in braces.
_NABLA = {"grad": "", "gradient": "", "div": r"\cdot", "divergence": r"\cdot", "curl": r"\times"}
_NABLA |= {"laplacian": "^2"}
_TURNS = ("sin", "cos", "tan", "sec", "csc", "cot", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan")


def _if_given(number: int, body: str) -> str:
    return rf"\IfNoValueTF{{#{number}}}{{}}{{{body}}}"


def _physics() -> Iterator[str]:
    """Yields the declarations of the package physics that the rewriting of formulas does not know."""
    for name, (left, right) in _FENCES.items():
        yield rf"\NewDocumentCommand{{\{name}}}{{sm}}{{\left{left}#2\right{right}}}"
    for name, environment in _MATRICES.items():
        yield rf"\newcommand{{\{name}}}[1]{{\begin{{{environment}}}#1\end{{{environment}}}}}"
    shapes = (_if_given(at, rf"\begin{{{shape}}}#{at}\end{{{shape}}}") for at, shape in enumerate(_SHAPES, 2))
    body = "".join(shapes)
    for name in ("mqty", "matrixquantity", "smqty", "smallmatrixquantity"):
        yield rf"\NewDocumentCommand{{\{name}}}{{s d() o d|| g}}{{{body}}}"
    body = r"\mathrm{d}" + _if_given(1, "^{#1}") + _if_given(2, "{#2}") + _if_given(3, "(#3)")
    for name in ("dd", "differential"):
        yield rf"\NewDocumentCommand{{\{name}}}{{o g d()}}{{{body}}}"
    for name, sign in _SIGNS.items():
        yield rf"\newcommand{{\{name}}}{{{sign}}}"
    for name, sign in _NABLA.items():
        yield rf"\DeclareDocumentCommand{{\{name}}}{{g}}{{\nabla{sign}{_if_given(1, ' #1')}}}"
    for name in _TURNS:
        body = rf"\plain{name}{_if_given(1, '^{#1}')}"
        yield rf"\let\plain{name}\{name}\RenewDocumentCommand{{\{name}}}{{o}}{{{body}}}"
    yield r"\NewDocumentCommand{\qq}{sm}{\quad\text{#2}\quad}"
    yield from (rf"\newcommand{{\q{word}}}{{\quad\text{{{word}}}\quad}}" for word in _WORDS.split())
    yield r"\newcommand{\flatfrac}[2]{\frac{#1}{#2}}\newcommand{\order}[1]{\mathcal{O}\left(#1\right)}"
    yield r"\newcommand{\eval}[1]{\left.#1\right|}\newcommand{\rank}{\operatorname{rank}}"


#: The declarations of each package, by its name.
PACKAGES: Mapping[str, str] = MappingProxyType({"physics": "".join(_physics())})
