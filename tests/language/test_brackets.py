"""Every form of a term at every place of another: a bracket stands where its parts would come apart, and only there."""

from __future__ import annotations

import pytest

from workbench.core.construct import apply, derivative
from workbench.core.terms import IllFormed, Term
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term

SPECS = {
    r"\lambda": "scalar",
    r"\mu": "scalar",
    r"\nu^*": "scalar",
    "x": "vector",
    "y": "vector",
    "z": "vector",
}
SPECS |= {"A": "tensor", "B": "tensor", r"\underline{s}": "dual scalar"}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in SPECS.items()})

SUM, INFIX, PRODUCT, FACTOR, ATOM = range(5)

#: What is printed, and how tightly it holds.
SCALARS = {
    "2": ATOM,
    r"\frac{1}{2}": FACTOR,
    r"\lambda": ATOM,
    r"\dot{\lambda}": ATOM,
    r"\nu^{*}": FACTOR,
    r"\lambda^{2}": FACTOR,
    r"\lambda^{(5)}": FACTOR,
    r"\lambda^{(n)}": FACTOR,
    "n": ATOM,
    "n!": FACTOR,
    r"\binom{n}{2}": FACTOR,
    r"x \cdot y": INFIX,
    r"\lambda + \mu": SUM,
    r"\lambda - \mu": SUM,
    r"-\lambda": SUM,
    r"\lambda \mu": PRODUCT,
    r"\frac{\lambda}{\mu}": FACTOR,
    r"\left\|x\right\|": ATOM,
    r"\left\langle x, y, z\right\rangle": ATOM,
    r"\sqrt{\lambda}": FACTOR,
    r"\frac{\partial \lambda}{\partial \mu}": FACTOR,
    r"\sin\left(\lambda + \mu\right)": FACTOR,
    r"\operatorname{atan2}\left(\lambda, \mu\right)": FACTOR,
    r"\varepsilon": ATOM,
}
PLACES = {
    r"{} + \mu": INFIX,
    r"\mu + {}": INFIX,
    r"\mu - {}": INFIX,
    r"{} - \mu": INFIX,
    r"\frac{{{}}}{{\mu}}": SUM,
    r"\frac{{\mu}}{{{}}}": SUM,
    r"\sqrt{{{}}}": SUM,
    r"{}^{{2}}": ATOM,
    r"{}^{{(5)}}": ATOM,
    r"{}^{{-1}}": ATOM,
    r"\left\|{}\right\|": SUM,
    r"\frac{{\partial {}}}{{\partial \mu}}": FACTOR,
}


#: A minus sign in a sum is the sign of its addend.
AS_A_DIFFERENCE = {
    (r"-\lambda", r"{} + \mu"): r"-\lambda + \mu",
    (r"-\lambda", r"{} - \mu"): r"-\lambda - \mu",
    (r"-\lambda", r"\mu + {}"): r"\mu - \lambda",
    (r"\frac{\lambda}{\mu}", r"\sqrt{{{}}}"): r"\frac{\sqrt{\lambda}}{\sqrt{\mu}}",
}


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("scalar", SCALARS)
def test_a_scalar_in_a_scalar(scalar: str, place: str) -> None:
    inner = read_term(scalar, TABLE, ("n",))
    assert to_latex(inner) == scalar
    bare, bracketed = place.format(scalar), place.format(rf"\left({scalar}\right)")
    whole = read_term(bracketed, TABLE, ("n",))
    assert inner in whole.walk() or "n" in scalar or "sqrt" in place
    firm = SCALARS[scalar] >= PLACES[place] and (scalar, place) != (r"\dot{\lambda}", r"{}^{{-1}}")
    assert to_latex(whole) == AS_A_DIFFERENCE.get((scalar, place), bare if firm else bracketed)


#: Left factors as they are printed: bare, and whether a round bracket behind them would be their argument.
LEFT = {
    r"\lambda": True,
    "n": False,
    r"\frac{1}{2}": False,
    r"\nu^{*}": True,
    "x": True,
    r"\dot{x}": True,
    r"x^{(5)}": True,
    r"x^{(n)}": True,
    r"\tilde{x}": True,
    "A": True,
    "A^{T}": True,
    "A^{2}": True,
    r"A B": True,
    r"\lambda x": True,
    r"\lambda \tilde{x}": True,
    r"\left\|x\right\|": False,
    r"\widetilde{x + y}": False,
    r"\left(A + B\right)^{T}": False,
    r"\left(A + B\right)^{2}": False,
    r"\operatorname{vect}\left(A + B\right)": False,
    r"\frac{\lambda}{\mu}": False,
}
#: Left factors that a bracket has to hold together.
LOOSE = [
    "-2",
    "n+1",
    r"-\frac{1}{2}",
    "-x",
    "x + y",
    r"x \times y",
    r"\sum_{k=1}^{n} x",
    r"\lambda \sum_{k=1}^{n} x",
    r"\det A",
    r"\operatorname{vect} A",
    r"\lambda \operatorname{vect} A",
    r"\sin \lambda",
]
#: Right factors, and whether a bracket has to hold them together; "sum": of letters and numbers alone.
RIGHT = {
    r"\mu": "",
    r"\mu^{2}": "",
    "y": "",
    r"\dot{y}": "",
    "B": "",
    r"\tilde{y}": "",
    r"\det B": "",
    r"\operatorname{vect} B": "",
    r"\operatorname{vect}\left(A + B\right)": "",
    r"\sum_{k=1}^{n} y": "",
    r"x \cdot y": "bracket",
    r"\mu y": "bracket",
    r"\mu \det B": "bracket",
    r"\mu \sum_{k=1}^{n} y": "bracket",
    r"x \times \sum_{k=1}^{n} y": "bracket",
    "x + y": "sum",
    "-y": "sum",
    "A + B": "sum",
    r"A + B^{T}": "bracket",
    r"-\tilde{y}": "bracket",
    "3": "sum",
    r"3 y": "bracket",
}


def read_here(latex: str) -> Term:
    return read_term(latex, TABLE, ("n",))


@pytest.mark.parametrize("left", [*LEFT, *LOOSE])
def test_a_product(left: str) -> None:
    for right, kind in RIGHT.items():
        try:
            whole = apply("mul", read_here(left), read_here(right))
        except IllFormed:
            continue
        after = rf"\left({right}\right)" if kind else right
        if kind and LEFT.get(left, False):
            inside = f"{{{right}}}" if kind == "sum" else right
            after = rf"\left[{inside}\right]"
        before = rf"\left({left}\right)" if left in LOOSE else left
        assert to_latex(whole) == f"{before} {after}"
        assert read_here(to_latex(whole)) == whole


#: Vectors, and whether beside a sign a bracket has to hold them together.
VECTORS = {
    "x": False,
    r"\dot{x}": False,
    r"A x": False,
    r"\lambda A x": False,
    r"\frac{x}{\lambda}": False,
    r"\operatorname{vect} A": False,
    r"A \operatorname{vect} B": False,
    r"-x": True,
    r"x + y": True,
    r"x \times y": True,
    r"\left(x \times y\right) \times z": True,
    r"\mathbf{0}": False,
}
SUMS = [r"\sum_{k=1}^{n} x", r"\lambda \sum_{k=1}^{n} x", r"A \sum_{k=1}^{n} x", r"x \times \sum_{k=1}^{n} y"]


@pytest.mark.parametrize(("head", "sign"), [("dot", r"\cdot"), ("cross", r"\times"), ("outer", r"\otimes")])
@pytest.mark.parametrize("left", [*VECTORS, *SUMS])
def test_both_sides_of_a_sign(head: str, sign: str, left: str) -> None:
    for right in (*VECTORS, *SUMS):
        if r"\mathbf{0}" in (left, right) and head == "dot":
            continue
        whole = apply(head, read_here(left), read_here(right))
        is_loose = (left in SUMS or VECTORS[left], right == SUMS[-1] or VECTORS.get(right, False))
        before, after = (
            rf"\left({p}\right)" if b else p for p, b in zip((left, right), is_loose, strict=True)
        )
        assert to_latex(whole) == f"{before} {sign} {after}"
        assert read_here(to_latex(whole)) == whole


@pytest.mark.parametrize(
    "head", ["det", "trace", "vect", "symmetric", "antisymmetric", "norm", "re", "exp", "sin", "root"]
)
def test_functions_omit_brackets_around_an_accented_letter(head: str) -> None:
    words = {"trace": "trace", "symmetric": "sym", "antisymmetric": "skew", "re": "Re"}
    is_command = head in ("det", "exp", "sin")
    word = rf"\{head}" if is_command else rf"\operatorname{{{words.get(head, head)}}}"
    letter = {
        "norm": "x",
        "re": r"\underline{s}",
        "exp": r"\lambda",
        "sin": r"\lambda",
        "root": r"\lambda",
    }.get(head, "A")
    for text in (
        letter,
        rf"\dot{{{letter}}}",
        f"{letter}^{{(5)}}",
        f"2 {letter}",
        f"{letter} + {letter}",
        f"-{letter}",
    ):
        whole = apply(head, read_here(text))
        is_bare = text == letter or "dot" in text
        usual = f"{word} {text}" if is_bare else rf"{word}\left({text}\right)"
        special = {"norm": rf"\left\|{text}\right\|", "root": rf"\sqrt{{{text}}}"}
        assert to_latex(whole) == special.get(head, usual)
        assert read_here(to_latex(whole)) == whole


@pytest.mark.parametrize("order", range(1, 7))
@pytest.mark.parametrize(
    "body", ["x", r"\tilde{x}", r"\nu^{*}", "A x", "x + y", r"\sum_{k=1}^{n} x", r"\sin \lambda"]
)
def test_a_derivative_has_up_to_four_dots_over_a_letter(order: int, body: str) -> None:
    whole = derivative(read_here(body), order)
    dots = ["", r"\dot", r"\ddot", r"\dddot", r"\ddddot"]
    letter = {"x": "x", r"\tilde{x}": "x", r"\nu^{*}": r"\nu"}.get(body)
    if letter is not None and order <= 4:
        expected = body.replace(letter, f"{dots[order]}{{{letter}}}")
        expected = rf"{dots[order]}{{{body}}}" if body.startswith(r"\tilde") else expected
    elif letter is not None and body != r"\nu^{*}":
        expected = f"{body}^{{({order})}}"
    else:
        expected = rf"\left({body}\right)^{{({order})}}"
    assert to_latex(whole) == expected
    assert read_here(to_latex(whole)) == whole
