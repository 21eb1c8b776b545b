"""Reading of a formula that the grammar rejects in pieces: each side, addend, bracket and cell."""

from __future__ import annotations

import re
from collections.abc import Iterator

from workbench.core.formula_errors import Fault
from workbench.language.grammar.parser import parse
from workbench.papers.drafting.inference.kind_operations import Operation
from workbench.papers.drafting.inference.walker import Walker
from workbench.source.rows.display_vocabulary import ORDER

_OPENING, _CLOSING = "([{", ")]}"
_RELATION = re.compile(
    r"\\(?:neq?|approx|simeq|sim|equiv|triangleq|coloneqq?|propto|mapsto|to|rightarrow|iff"
    rf"|Leftrightarrow|Rightarrow|implies)(?![A-Za-z])|:=|[=≈≡]|{ORDER.pattern}"
)
_EQUALS = re.compile(r"\\(?:equiv|triangleq|coloneqq?|approx|simeq)(?![A-Za-z])|:=|[=≈≡]")
_SEPARATOR = re.compile(
    r"\\q?quad(?![A-Za-z])|\\text\s*\{[^{}]*\}|\\mbox\s*\{[^{}]*\}|\\[lc]?dots(?![A-Za-z])|\\\\|,|;|&|…|\.\.\."
)
_SIGN = re.compile(r"(?<!^)[+\-](?![^{}]*\})|\\(?:pm|mp)(?![A-Za-z])")
#: Integral, minimum and similar signs, with their lower and upper limits.
_HEADS = re.compile(
    r"\\(?:i*int|oint|lim|limsup|sup|inf|arg|prod|min|max|sum)(?![A-Za-z])(?:\\limits)?"
    r"(?:\s*[_^]\s*(?:\{[^{}]*\}|\\?[A-Za-z]+|.))*|\\left\s*\.|\\right\s*\.|\\[!,:;>]|\\displaystyle"
)
_MOST_DEEP = 3


def operations_of(latex: str, walker: Walker) -> tuple[Operation, ...]:
    """Returns the operations of a formula, or of its pieces if the grammar rejects it."""
    try:
        return tuple(walker.statement(parse(latex)))
    except (Fault, RecursionError):
        return tuple(_pieces(latex, walker))


def _pieces(latex: str, walker: Walker) -> Iterator[Operation]:
    for clause in _apart(_HEADS.sub(" ", latex), _SEPARATOR):
        sides = list(_apart(clause, _RELATION))
        if len(sides) < 2:
            made = _side(clause, walker, 0)
            if made is not None:
                yield walker.make("said", made)
            continue
        signs = [match[0] for match in _outside(clause, _RELATION)]
        read = [_side(side, walker, 0) for side in sides]
        for sign, left, right in zip(signs, read, read[1:], strict=False):
            if left is not None and right is not None:
                is_order = ORDER.fullmatch(sign)
                relation = "equal" if _EQUALS.fullmatch(sign) else "compare" if is_order else "any"
                yield walker.make(relation, left, right)
            elif (only := left or right) is not None:
                yield walker.make("said", only)


def _side(latex: str, walker: Walker, depth: int) -> Operation | None:
    """Returns the value of a side as far as it is read; None if nothing of it is."""
    if not latex.strip():
        return None
    try:
        (found,) = walker.statement(parse(latex))
        return found.parts[0] if found.op == "said" else walker.forest.anything(found)
    except (Fault, ValueError, RecursionError):
        pass
    if depth > _MOST_DEEP:
        return None
    addends = [each for each in _apart(latex, _SIGN) if each.strip()]
    if len(addends) > 1:
        read = [_side(each, walker, depth + 1) for each in addends]
        return walker.make("add", *(walker.forest.anything() if each is None else each for each in read))
    inside = [_side(each, walker, depth + 1) for each in _brackets(latex)]
    kept = [each for each in inside if each is not None]
    return walker.forest.anything(*kept) if kept else None


def _outside(latex: str, pattern: re.Pattern[str]) -> Iterator[re.Match[str]]:
    """Yields the matches outside of all brackets and environments."""
    depth, done = 0, 0
    for match in pattern.finditer(latex):
        for token in re.findall(r"\\begin|\\end|\\[A-Za-z]+|\\.|[()\[\]{}]", latex[done : match.start()]):
            depth += (token in _OPENING or token == "\\begin") - (token in _CLOSING or token == "\\end")
        done = match.start()
        if depth <= 0:
            yield match


def _apart(latex: str, pattern: re.Pattern[str]) -> Iterator[str]:
    """Yields the text between the matches outside of all brackets."""
    done = 0
    for match in _outside(latex, pattern):
        yield latex[done : match.start()]
        done = match.end()
    yield latex[done:]


def _brackets(latex: str) -> Iterator[str]:
    """Yields the contents of the outermost brackets."""
    depth, start = 0, 0
    for match in re.finditer(r"\\[{}]|[()\[\]{}]", latex):
        if match[0][-1] in _OPENING:
            start = match.end() if not depth else start
            depth += 1
        elif depth:
            depth -= 1
            if not depth:
                yield latex[start : match.start()]
