"""Sentences of a text with a mark for each formula, and the symbols that a formula lists."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from workbench.core.formula_errors import Fault
from workbench.language.grammar.parser import parse
from workbench.papers.drafting.inference.kind_operations import MARKED, SYMBOL, UNIT, Operation
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.source.documents import Display, Text
from workbench.source.documents.tex.tex_tokens import COMMENT

#: The mark of formula k of a text.
MARK = r"⟦(\d+)⟧"
#: Brackets of a text that would look like marks.
_NO_MARKS = str.maketrans("⟦⟧⟪⟫", "    ")
_OPENING = re.compile(r"(?:\$\$?|\\\(|\\\[|:math:`)\s*$")
_CLOSING = re.compile(r"^\s*(?:\$\$?|\\\)|\\\]|`)")
_NO_WORDS = re.compile(
    r"\\(?:eqref|ref|cite\w*|label|footnote)\s*\{[^{}]*\}|\\(?:emph|textit|textbf|text)\b|[{}*]"
)
_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z⟦⟪])|\\(?:sub)*section|\n\s*\n|\n#+ ")


@dataclass(frozen=True)
class Sentence:
    """A sentence with marks for its formulas. line: the line of its first formula."""

    words: str
    line: int


class MarkedText:
    """The sentences of a text, and the formulas that their marks stand for."""

    def __init__(self, text: Text) -> None:
        self._text, self._walker = text, Walker()
        self.formulas: Sequence[Display] = text.inline

    @cached_property
    def sentences(self) -> list[Sentence]:
        """Returns the sentences that have a formula."""
        found = []
        for source in self._text.sources:
            own = [(k, each) for k, each in enumerate(self.formulas) if each.source is source]
            shown = [(None, each) for each in self._text.displays if each.source is source]
            pieces, done, prose = [], 0, source.prose.translate(_NO_MARKS)
            for k, each in sorted([*own, *shown], key=lambda pair: pair[1].start):
                if each.start < done:
                    continue
                pieces += [prose[done : each.start], f"⟦{k}⟧" if k is not None else " ⟪⟫ "]
                done = each.end
            pieces.append(prose[done:])
            found += [each for each in map(self._sentence, _split(pieces)) if each is not None]
        return found

    def _sentence(self, words: str) -> Sentence | None:
        mark = re.search(MARK, words)
        return Sentence(words, self.formulas[int(mark[1])].line) if mark else None

    def latex(self, mark: str) -> str:
        return self.formulas[int(mark)].latex

    def tree(self, mark: str) -> Operation | None:
        """Returns the operation of the formula; None if it cannot be read."""
        try:
            trees = self._walker.statement(parse(self.latex(mark)))
        except (Fault, RecursionError):
            return None
        return trees[0] if len(trees) == 1 else None

    def shows_before(self, name: str, formula: Display) -> bool:
        """True if a display before a formula of a sentence contains the symbol."""
        before = (d for d in self._text.displays if d.source is formula.source and d.start < formula.start)
        return any(name in tree.names for d in before for tree in operations_of(d.latex, self._walker))

    @cached_property
    def equations(self) -> list[Operation]:
        """Returns the formulas of the text that are an equation with a symbol alone on the left."""
        formulas = sorted([*self.formulas, *self._text.displays], key=lambda each: each.line)
        trees = (tree for each in formulas for tree in operations_of(each.latex, self._walker))
        return [tree for tree in trees if tree.op == "equal" and tree.parts[0].op == SYMBOL]

    def names(self, mark: str) -> list[str]:
        r"""Returns the symbols that a formula lists: \boldsymbol{a}, or l_1, l_2; for x = … and x ∈ …, x."""
        found: list[str] = []
        for piece in re.split(r",(?![^{(]*[})])", self.latex(mark)):
            try:
                (tree,) = self._walker.statement(parse(piece))
            except (Fault, ValueError, RecursionError):
                return found
            tree = tree.parts[0]
            if tree.op not in (SYMBOL, MARKED, UNIT):
                return found
            found.append(tree.text)
        return found


def _split(pieces: Sequence[str]) -> Iterator[str]:
    """Yields the sentences of a text in pieces, without markup."""
    clean: list[str] = []
    for piece in pieces:
        if piece.startswith(("⟦", " ⟪")):
            if clean:
                clean[-1] = _OPENING.sub("", clean[-1])
            clean.append(piece)
        else:
            clean.append(COMMENT.sub("", _CLOSING.sub("", piece) if clean else piece))
    for sentence in _SENTENCE.split("".join(clean)):
        yield " ".join(_NO_WORDS.sub(" ", sentence.replace("~", " ")).split())
