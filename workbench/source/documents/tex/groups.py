"""Groups of TeX: at the end of a group, assigned names get their old values back."""

from __future__ import annotations

from collections import Counter
from typing import Any, TypeVar

from workbench.source.documents.tex.tex_tokens import Token

T = TypeVar("T")

#: The kinds of groups; that of an environment is its \\begin{name}.
BRACES, LEFT, BEGINGROUP, FORMULA, CELL = "{", "\\left", "\\begingroup", "$", "&"
OPENING = {"{": BRACES, "\\left": LEFT, "\\begingroup": BEGINGROUP}
CLOSING = {"}": BRACES, "\\right": LEFT, "\\endgroup": BEGINGROUP}

#: Environments whose cells are groups.
ALIGNMENTS = frozenset((
    "align", "alignat", "aligned", "alignedat", "array", "bmatrix", "Bmatrix", "bmatrix*", "Bmatrix*",
    "cases", "cases*", "darray", "dcases", "dcases*", "dgroup", "drcases", "eqnarray", "flalign", "gather",
    "gathered",
    "IEEEeqnarray", "IEEEeqnarraybox", "longtable", "matrix", "matrix*", "multline", "multlined", "NiceArray",
    "NiceMatrix", "NiceTabular", "pmatrix", "pmatrix*", "pNiceMatrix", "bNiceMatrix", "rcases", "smallmatrix",
    "bsmallmatrix", "psmallmatrix", "split", "subarray", "subeqnarray", "supertabular", "tabular", "tabularx",
    "tabulary", "tblr", "vmatrix", "Vmatrix", "vmatrix*", "Vmatrix*", "xalignat",
))  # fmt: skip

_END = "\\end-of-group "
_ABSENT: Any = object()


def environment(name: str) -> str:
    """Returns the kind of group of an environment."""
    return f"\\begin{{{name}}}"


def has_cells(name: str) -> bool:
    """True if the cells of an environment are groups."""
    return name in ALIGNMENTS or name.rstrip("*") in ALIGNMENTS


def end_mark(token: Token, kind: str) -> Token:
    """Returns a token that ends the innermost group of this kind when it is read."""
    return Token(_END + kind, token.source, token.start, token.end, token.call, final=True)


def ended_by(token: Token) -> str | None:
    """Returns the kind of group that an end mark ends; None for other tokens."""
    return token.text[len(_END) :] if token.text.startswith(_END) else None


class Groups:
    """The open groups, and the save stack of their assignments.

    As in TeX, an assignment stores the level of its group: a value of level 0 is global, and the end of a
    group keeps it.
    """

    def __init__(self) -> None:
        self._kinds: list[str] = []
        self._count: Counter[str] = Counter()
        self._saved: list[tuple[int, dict[str, Any], str, Any, int]] = []
        self._levels: dict[tuple[int, str], int] = {}

    def __len__(self) -> int:
        return len(self._kinds)

    @property
    def innermost(self) -> str | None:
        return self._kinds[-1] if self._kinds else None

    def begin(self, kind: str) -> None:
        self._kinds.append(kind)
        self._count[kind] += 1

    def end(self, kind: str) -> set[str]:
        """Ends the innermost group of this kind and those in it; returns the names whose old values are
        restored.

        A brace or \\right closes nothing outside its environment, and nothing in a formula closes a group
        around the formula.
        """
        if self.innermost == kind:
            return self.end_to(len(self._kinds) - 1)
        if not self._count[kind]:
            return set()
        for depth in range(len(self._kinds) - 1, -1, -1):
            found = self._kinds[depth]
            if found == kind:
                return self.end_to(depth)
            if found == FORMULA or (kind in (BRACES, LEFT) and found.startswith("\\begin{")):
                break
        return set()

    def end_to(self, depth: int) -> set[str]:
        """Ends all groups but the first `depth`; returns the names whose old values are restored."""
        while len(self._kinds) > depth:
            self._count[self._kinds.pop()] -= 1
        restored: set[str] = set()
        while self._saved and self._saved[-1][0] > depth:
            _, values, name, before, level = self._saved.pop()
            key = id(values), name
            if self._levels[key] == 0:
                continue
            self._levels[key] = level
            restored.add(name)
            if before is _ABSENT:
                values.pop(name, None)
            else:
                values[name] = before
        return restored

    def assign(self, values: dict[str, T], name: str, value: T, everywhere: bool = False) -> None:
        """Assigns a value to `name` until the end of the innermost group, or in all groups."""
        level = 0 if everywhere else len(self._kinds)
        key = id(values), name
        known = self._levels.get(key, 0)
        if level > 0 and known != level:
            self._saved.append((level, values, name, values.get(name, _ABSENT), known))
        self._levels[key] = level
        values[name] = value
