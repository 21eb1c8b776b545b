"""Edits of the author's own characters that carry out a proposed correction, in the author's macros.

The printed formula and the proposal are printed by one printer, so that they differ only by the correction.
Each difference is mapped to the author's characters by aligning the printer's tokens with those of the text.
The result is read again: an edit counts only if the edited formula states what was proved, or is proved
itself.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import SequenceMatcher
from itertools import islice, pairwise, product

from workbench.context.claims import Claim
from workbench.context.read_formulas import read_statement
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.terms import Statement, Symbol
from workbench.core.verdict import Outcome
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.decide import Judge
from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.proposed_form import Proposed
from workbench.repair.propose.candidate_judge import judging
from workbench.repair.propose.proposal import Repair
from workbench.repair.terms.subterm_positions import places
from workbench.runtime import OutOfBudget
from workbench.source.documents import Display, Text, Token, spelled
from workbench.source.documents.source_edits import Piece, SourceEdit, edits_in_source, merged
from workbench.source.documents.tex.tex_tokens import PARAGRAPH, tokens_of
from workbench.source.rewriting.formulas_in_models import or_respelled
from workbench.source.rows.chains import Step, steps_of

#: Tokens that only format; the alignment ignores them.
_IDLE = frozenset((r"\left", r"\right", "{", "}", r"\,", r"\;", r"\!", r"\ ", r"\:", r"\quad", "&", r"\cdot"))
_SAME = {
    r"\bm": r"\boldsymbol",
    r"\mathbf": r"\boldsymbol",
    r"\vec": r"\boldsymbol",
    r"\Vert": r"\|",
    r"\lVert": r"\|",
    r"\rVert": r"\|",
    r"\top": "T",
}
#: Returns the answer of the function to the question about a formula of a claim, or that of an earlier run.
Once = Callable[[Claim, str, Callable[[], bool]], bool]


def _always(claim: Claim, latex: str, asked: Callable[[], bool]) -> bool:
    return asked()


#: The most edited formulas that are read, and the most that are judged.
_MOST_READ, _MOST_JUDGED = 200, 6
#: Seconds of processor time for judging one of them.
_MOST_SECONDS = 2.0


def with_author_edits(
    results: Sequence[ClaimResult], text: Text | None, once: Once = _always
) -> list[ClaimResult]:
    """Returns the results, each with the edits of the text that carry out its first proposal, if found."""
    if text is None:
        return list(results)
    found = []
    for each in results:
        if each.proposed:
            edits, edited = author_edits(each.claim, text, each.proposed[0], once)
            each = replace(each, edits=edits, edited=edited)
        found.append(each)
    return found


def author_edits(
    claim: Claim, text: Text, proposed: Proposed, once: Once = _always
) -> tuple[tuple[SourceEdit, ...], str | None]:
    """Returns the edits of the author's characters that change the printed formula to the proposal, and the
    author's formula with them, macros expanded. once: asks whether an edited formula of a claim is proved.

    Returns ((), None) if no such edit was found.
    """
    none: tuple[tuple[SourceEdit, ...], None] = ((), None)
    step = _step_of(claim, text)
    if step is None:
        return none
    latex, owners = spelled(step.tokens)
    try:
        right = _read(claim, proposed.latex)
    except (ReadError, IllFormedAt):
        return none
    editor = _Editor(claim, latex, owners, proposed.latex, right, once)
    try:
        for pieces in editor.candidates():
            if (found := edits_in_source(pieces, owners)) is not None and editor.is_right(pieces):
                return merged(found), editor.edited(pieces)
    finally:
        editor.close()
    return none


def _read(claim: Claim, latex: str) -> Statement:
    return or_respelled(
        latex, claim.notation.words, lambda text: read_statement(text, claim.notation, claim.orders)[0]
    )


def _step_of(claim: Claim, text: Text) -> Step | None:
    """Returns the step of the text that the claim was made of."""
    for display in _displays_of(claim, text):
        for steps in steps_of(display, claim.notation.words):
            for step in steps:
                if step.spelled()[0] == claim.printed.latex:
                    return step
    return None


def _displays_of(claim: Claim, text: Text) -> Iterator[Display]:
    if claim.context.span is None:
        return
    begin, end = claim.context.span.line, claim.context.span.end_line
    for display in text.displays:
        source = display.source
        lines = range(source.place(display.start)[0], source.place(display.end)[0] + 1)
        if source.path == claim.context.span.file and begin in lines and end in lines:
            yield display


class _Editor:
    """Maps the difference between the printed formula and a proposal to the author's formula."""

    def __init__(
        self, claim: Claim, latex: str, owners: Sequence[Token], proposal: str, right: Statement, once: Once
    ) -> None:
        self._claim, self._latex, self._owners, self._right, self._once = claim, latex, owners, right, once
        self._before = _atoms(Repair(claim).printed)
        self._after = _atoms(proposal)
        self._own = _atoms(latex)
        self._at = _aligned(self._before, self._own)
        self._judged = 0
        self._judge = judging(claim, Judge(claim.notation.definitions))
        self._snippets = self._authors_spellings()

    def close(self) -> None:
        self._judge.close()

    def candidates(self) -> Iterator[tuple[Piece, ...]]:
        """Yields edited formulas, the simplest first."""
        changes = _changes(self._before, self._after)
        if not changes or len(changes) > 12:
            return
        without_brackets = [each for each in changes if not self._only_brackets(*each)]
        seen = set()
        for some in (without_brackets, changes):
            if not some:
                continue
            for pieces in islice(product(*map(self._ways, some)), _MOST_READ):
                if pieces not in seen and _are_apart(pieces):
                    seen.add(pieces)
                    yield pieces

    def edited(self, pieces: Sequence[Piece]) -> str:
        return _with(self._latex, [(each.start, each.end, each.expanded) for each in pieces])

    def is_right(self, pieces: Sequence[Piece]) -> bool:
        """True if the edited formula states what was proved, or is proved itself."""
        edited = self.edited(pieces)
        try:
            statement = _read(self._claim, edited)
        except (ReadError, IllFormedAt):
            return False
        return statement == self._right or self._once(self._claim, edited, lambda: self._is_proved(statement))

    def _is_proved(self, statement: Statement) -> bool:
        if self._judged == _MOST_JUDGED:
            return False
        self._judged += 1
        try:
            verdict = self._judge.call(statement, _MOST_SECONDS)
        except OutOfBudget:
            return False
        return verdict is not None and verdict.outcome is Outcome.PROVED

    def _only_brackets(self, start: int, end: int, first: int, last: int) -> bool:
        both = [*self._before[start:end], *self._after[first:last]]
        return all(each.text in ("(", ")", *_IDLE) for each in both)

    def _ways(self, change: tuple[int, int, int, int]) -> list[Piece]:
        """Returns the alternatives for one change: its possible positions, with and without new brackets."""
        start, end, first, last = change
        found = []
        for expanded, written in self._texts(first, last):
            for begin, stop in self._places(start, end):
                found.append(Piece(begin, stop, expanded, written))
        return found

    def _places(self, start: int, end: int) -> list[tuple[int, int]]:
        own, at = self._own, self._at
        before = next((at[k] for k in range(start - 1, -1, -1) if k in at), None)
        behind = next((at[k] for k in range(end, len(self._before)) if k in at), None)
        inside = [at[k] for k in range(start, end) if k in at]
        low = 0 if before is None else own[before].end
        high = len(self._latex) if behind is None else own[behind].start
        if inside:
            begin, stop = min(inside), max(inside)
            found = [(own[begin].start, own[stop].end)]
            while (
                begin > 0
                and own[begin - 1].text in ("{", r"\left")
                and (before is None or begin - 1 > before)
            ):
                begin -= 1
                found.append((own[begin].start, own[stop].end))
            while stop + 1 < len(own) and own[stop + 1].text == "}" and (behind is None or stop + 1 < behind):
                stop += 1
                found += [(own[k].start, own[stop].end) for k in {begin, min(inside)}]
            return found
        if start < end:  # the removed tokens are not aligned: remove all between their neighbours
            return [(low, high)] if low <= high else []
        between = [k for k in range(len(own)) if low <= own[k].start and own[k].end <= high]
        spots = [high, low, *(own[k].end for k in between), *(own[k].start for k in between)]
        return [(spot, spot) for spot in dict.fromkeys(spots) if low <= spot <= high][:6]

    def _texts(self, first: int, last: int) -> list[tuple[str, str]]:
        """Returns the inserted text, expanded and in the author's spelling; also without unbalanced
        brackets."""
        atoms = self._after[first:last]
        found = [self._in_the_authors_spelling(atoms)]
        bare = _balanced(atoms)
        if bare != atoms:
            found.insert(0, self._in_the_authors_spelling(bare))
        return list(dict.fromkeys(found))

    def _in_the_authors_spelling(self, atoms: Sequence[Token]) -> tuple[str, str]:
        expanded, written = [], []
        place = 0
        while place < len(atoms):
            for keys, snippet in self._snippets.items():
                if tuple(each.text for each in atoms[place : place + len(keys)]) == keys:
                    expanded.append(snippet[0])
                    written.append(snippet[1])
                    place += len(keys)
                    break
            else:
                expanded.append(atoms[place].text)
                written.append(atoms[place].text)
                place += 1
        return _joined(expanded), _joined(written)

    def _authors_spellings(self) -> Mapping[tuple[str, ...], tuple[str, str]]:
        """Returns the printer's tokens of a symbol → the author's spelling of it here, expanded and in the
        source."""
        statement = self._claim.printed.statement
        found: dict[tuple[str, ...], tuple[str, str]] = {}
        if statement is None:
            return found
        names = {term for _, term in places(statement) if isinstance(term, Symbol)}
        with printed_for(self._claim.notation.author_notation):
            printed = {tuple(each.text for each in _atoms(to_latex(name))) for name in names}
        texts = [each.text for each in self._before]
        for keys in sorted(printed, key=len, reverse=True):
            for start in range(len(texts) - len(keys) + 1):
                is_here = tuple(texts[start : start + len(keys)]) == keys
                if is_here and (snippet := self._snippet(start, start + len(keys))) is not None:
                    found[keys] = snippet
                    break
        return found

    def _snippet(self, start: int, end: int) -> tuple[str, str] | None:
        aligned = [self._at[k] for k in range(start, end) if k in self._at]
        if not aligned:
            return None
        low, high = _closed(self._latex, self._own[min(aligned)].start, self._own[max(aligned)].end)
        tokens = self._owners[low:high]
        sources = {token.source for token in tokens}
        if len(sources) != 1:
            return None
        begin, stop = min(token.start for token in tokens), max(token.end for token in tokens)
        written = tokens[0].source.text[begin:stop].strip()
        others = [*self._owners[:low], *self._owners[high:]]
        if any(token.start < stop and begin < token.end for token in others):
            return None  # a macro that prints more than the symbol
        return self._latex[low:high], written


def _atoms(latex: str) -> list[Token]:
    """Returns the tokens of a formula, each with its position in the LaTeX."""
    return [token for token in tokens_of(latex) if token.text not in (" ", PARAGRAPH)]


def _key(token: Token) -> str:
    """Returns the key by which a token is aligned; commands for one sign have the same key."""
    return _SAME.get(token.text, token.text)


def _aligned(printed: Sequence[Token], own: Sequence[Token]) -> dict[int, int]:
    """Returns a map from the printer's tokens to those of the author's formula."""
    firsts = [k for k, each in enumerate(printed) if each.text not in _IDLE]
    seconds = [k for k, each in enumerate(own) if each.text not in _IDLE]
    keys = [_key(printed[k]) for k in firsts], [_key(own[k]) for k in seconds]
    matcher = SequenceMatcher(None, *keys, autojunk=False)
    return {
        firsts[block.a + step]: seconds[block.b + step]
        for block in matcher.get_matching_blocks()
        for step in range(block.size)
    }


def _changes(before: Sequence[Token], after: Sequence[Token]) -> list[tuple[int, int, int, int]]:
    matcher = SequenceMatcher(
        None, [each.text for each in before], [each.text for each in after], autojunk=False
    )
    return [tuple(change) for tag, *change in matcher.get_opcodes() if tag != "equal"]  # type: ignore[misc]


def _balanced(atoms: Sequence[Token]) -> list[Token]:
    """Returns the tokens without unmatched round brackets and without commands that only size brackets."""
    open_at: list[int] = []
    drop: set[int] = set()
    for place, each in enumerate(atoms):
        if each.text == "(":
            open_at.append(place)
        elif each.text == ")":
            drop.add(place) if not open_at else open_at.pop()
    drop.update(open_at)
    sizes = {place - 1 for place in drop if place and atoms[place - 1].text in (r"\left", r"\right")}
    return [each for place, each in enumerate(atoms) if place not in drop | sizes]


def _closed(latex: str, start: int, end: int) -> tuple[int, int]:
    """Returns the range, extended by the closing braces that it needs."""
    depth = latex.count("{", start, end) - latex.count("}", start, end)
    while depth > 0 and end < len(latex) and latex[end] in "} ":
        depth -= latex[end] == "}"
        end += 1
    return start, end


def _are_apart(pieces: Sequence[Piece]) -> bool:
    ordered = sorted(pieces, key=lambda each: (each.start, each.end))
    return all(a.end <= b.start for a, b in pairwise(ordered))


def _with(latex: str, edits: Sequence[tuple[int, int, str]]) -> str:
    for start, end, new in sorted(edits, reverse=True):
        latex = f"{latex[:start]} {new} {latex[end:]}"
    return latex


def _joined(pieces: Sequence[str]) -> str:
    text = ""
    for piece in pieces:
        blank = " " if re.search(r"\\[A-Za-z]+$", text) and piece[:1].isalpha() else ""
        text += blank + piece
    return text
