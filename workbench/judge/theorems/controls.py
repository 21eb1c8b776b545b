"""Whether two equations differ by signs alone: x × y by y × x, a + b by a − b, S by Sᵀ where S is skew."""

from __future__ import annotations

from collections.abc import Iterator

from workbench.language.printing.printer import to_latex
from workbench.language.typed.construct import apply, rebuild
from workbench.language.typed.terms import Apply, Relation, Term, Zero


def is_another_sign_of(control: Relation, equation: Relation) -> bool:
    """Whether the control says no more than the equation with other signs. The order of addends, and on
    which side they stand, are no matter."""
    return _addends(control) == _addends(equation)


def _addends(equation: Relation) -> list[str]:
    sides = (_unsigned(equation.left), _unsigned(equation.right))
    return sorted(to_latex(term) for side in sides for term in _parts(side) if not isinstance(term, Zero))


def _parts(term: Term) -> Iterator[Term]:
    if isinstance(term, Apply) and term.head == "add":
        for part in term.arguments:
            yield from _parts(part)
    else:
        yield term


def _unsigned(term: Term) -> Term:
    children = [_unsigned(child) for child in term.children]
    match term:
        case Apply(head="neg"):
            return children[0]
        case Apply(head="transpose") if isinstance(children[0], Apply) and children[0].head == "skew":
            return children[0]
        case Apply(head="mul") if isinstance(children[0], Apply) and children[0].head == "skew":
            if children[1].type.kind == "vector":
                return _sorted("cross", [*children[0].arguments, children[1]])
        case Apply(head="add"):
            return _sorted("add", [part for child in children for part in _parts(child)])
        case Apply(head="cross"):
            return _sorted("cross", children)
    unchanged = all(new is old for new, old in zip(children, term.children, strict=True))
    return term if unchanged else rebuild(term, children)


def _sorted(head: str, arguments: list[Term]) -> Term:
    return apply(head, *sorted(arguments, key=to_latex))
