"""LaTeX forms of the notation: for terms, whose brackets `printer` chooses, and for syntax trees, which keep
their spelling."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from workbench.core.operations import command_of
from workbench.language.grammar.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Extremal,
    Fraction,
    Given,
    Group,
    Infix,
    Integration,
    Joined,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
    core,
)
from workbench.language.grammar.vocabulary import BAR, CLOSING, written

BESIDE = ", \\quad "
AND = " \\text{ and } "
FOR = " \\text{ for } "


def fraction(top: str, bottom: str) -> str:
    return f"\\frac{{{top}}}{{{bottom}}}"


def binomial(top: str, bottom: str) -> str:
    return f"\\binom{{{top}}}{{{bottom}}}"


def scripted(nucleus: str, sub: str | None = None, sup: str | None = None) -> str:
    below = "" if sub is None else f"_{{{sub}}}"
    return nucleus + below + ("" if sup is None else f"^{{{sup}}}")


def extremal(least: bool, over: str | None) -> str:
    return scripted("\\min" if least else "\\max", over)


#: Beginnings of forms higher than one line; brackets around them grow.
_TALL = ("\\frac", "\\sum", "\\begin{bmatrix}")


def matrix(rows: Iterable[Sequence[str]]) -> str:
    inside = " \\\\ ".join(" & ".join(row) for row in rows)
    return f"\\begin{{bmatrix}} {inside} \\end{{bmatrix}}"


def latex_of(node: Node) -> str:
    """Returns the tree as LaTeX in its original spelling."""
    match node:
        case Leaf():
            return _leaf(node)
        case Group() | Bracket():
            return _grouped(node)
        case Styled() | Accented() | Scripted():
            return _decorated(node)
        case Fraction(numerator=top, denominator=bottom):
            return fraction(_inside(top) or "", _inside(bottom) or "")
        case Binomial(top=top, bottom=bottom):
            return binomial(_inside(top) or "", _inside(bottom) or "")
        case Infix(operator=operator):
            return written("INFIX", operator)
        case Product(items=items):
            return " ".join(map(latex_of, items))
        case Sum(addends=addends):
            signed = (f" {sign} {latex_of(a)}" if sign else latex_of(a) for sign, _, a in addends)
            return "".join(signed).strip()
        case Summation(lower=lower, upper=upper):
            sign = node.sign if isinstance(node, Integration) else "sum"
            return scripted(f"\\{sign}", _inside(lower), _inside(upper))
        case Extremal(least=least, over=over):
            return extremal(least, _inside(over))
        case Matrix(rows=rows):
            return matrix([list(map(latex_of, row)) for row in rows])
        case Chain() | Conditional() | Joined() | Given() | Lines():
            return _stated(node)
    raise TypeError(f"no LaTeX for {type(node).__name__}")


def _leaf(node: Leaf) -> str:
    if node.kind == "FUNCTION":
        return command_of(node.text)
    if node.kind == "MARK" and node.text != "T":
        return written("MARK", written("INFIX", node.text))
    return node.text


def _grouped(node: Group | Bracket) -> str:
    """A group in braces, or in brackets that print."""
    match node:
        case Group(parts=(Styled() | Leaf() | Group() as inner,)):
            return latex_of(inner)
        case Group(parts=parts):
            return f"{{{_listed(parts)}}}"
        case Bracket(kind="[", parts=(Matrix() as inner,)):
            return latex_of(inner)
    opening, closing, inside = node.kind, CLOSING[node.kind], _listed(node.parts)
    if any(tall in inside for tall in _TALL) and opening != BAR:
        return f"\\left{opening} {inside} \\right{closing}"
    return f"{opening} {inside} {closing}" if opening[1:] else f"{opening}{inside}{closing}"


def _decorated(node: Styled | Accented | Scripted) -> str:
    """A node in a typeface, under an accent, or with scripts."""
    match node:
        case Styled(style=style, body=body):
            return f"{style}{{{_inside(body)}}}"
        case Accented(accent="~", body=body):
            letter = core(body)
            accent = "\\widetilde" if isinstance(letter, Product | Sum | Bracket) else "\\tilde"
            return f"{accent}{{{_inside(body)}}}"
        case Accented(accent=accent, body=body):
            return f"{written('ACCENT', accent)}{{{_inside(body)}}}"
        case Scripted(nucleus=nucleus, sub=sub, sup=sup, primes=primes, factorial=factorial):
            marked = scripted(latex_of(nucleus), _inside(sub)) + "'" * primes
            return scripted(marked, sup=_inside(sup)) + "!" * factorial


def _stated(node: Chain | Conditional | Joined | Given | Lines) -> str:
    """A statement, a condition, or several lines of them."""
    match node:
        case Chain(relations=relations, sides=sides):
            signed = (
                f" {written('RELATION', sign)} {latex_of(side)}"
                for (sign, _), side in zip(relations, sides[1:], strict=True)
            )
            return "\\forall " * node.universal + latex_of(sides[0]) + "".join(signed)
        case Conditional(statements=statements, signs=signs):
            text = latex_of(statements[0])
            for (sign, _), statement in zip(signs, statements[1:], strict=True):
                joint = "\\text{ if }" if sign == "⇐" else written("IMPLICATION", sign)
                text += f" {joint} {latex_of(statement)}"
            return text
        case Joined(statements=statements):
            return AND.join(map(latex_of, statements))
        case Given(conditions=conditions):
            return FOR.lstrip() + BESIDE.join(map(latex_of, conditions))
        case Lines(lines=lines):
            texts = [BESIDE.join(map(latex_of, line)).replace(BESIDE.rstrip() + FOR, FOR) for line in lines]
            inside = " \\\\ ".join(texts)
            return texts[0] if len(texts) == 1 else f"\\begin{{aligned}} {inside} \\end{{aligned}}"


def _listed(parts: Iterable[Node]) -> str:
    return ", ".join(map(latex_of, parts))


def _inside(node: Node | None) -> str | None:
    """Returns the contents of the braces of an argument; None if there is no argument."""
    node = core(node)
    if node is None:
        return None
    return _listed(node.parts) if isinstance(node, Group) else latex_of(node)
