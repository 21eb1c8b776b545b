"""%%check: the verdict on each step of the formulas in a cell of a notebook."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from IPython.core.interactiveshell import InteractiveShell
    from markupsafe import Markup

    from workbench.app.pipeline.judged_files import Judged
    from workbench.papers.drafting.questions_to_author import Answer
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.report.listing import Listing

_IS_TEX = re.compile(r"\\begin\s*\{(?!.?matrix|cases|array)|\\\[")
_COLOURS = {"error": "#b3261e", "warning": "#7a4f00", "ok": "#0f6674"}


class CheckedCell:
    """The verdicts on a cell: a table in a notebook, the lines of `workbench check -v` elsewhere."""

    def __init__(self, judged: Judged) -> None:
        self._judged = judged

    def __repr__(self) -> str:
        from workbench.app.commands.listing_text import listing_lines

        return "\n".join(line.plain for line in listing_lines(self._listing, verbose=True)) or "no display"

    def _repr_html_(self) -> str:
        from markupsafe import Markup

        rows = Markup("").join(_row(result) for row in self._listing.rows for result in row.results)
        summary = Markup("<caption style='text-align:left'>{}</caption>").format(self._listing.summary)
        return str(Markup("<table>{}{}</table>").format(summary, rows))

    @property
    def results(self) -> list[ClaimResult]:
        """The results, one for each step."""
        return self._judged.results

    @property
    def _listing(self) -> Listing:
        from workbench.papers.texts.text_paper import TextPaper
        from workbench.report.listing import listing

        assert isinstance(self._judged.paper, TextPaper)
        return replace(listing(self._judged.paper, self._judged.results), file=Path("%%check"))


def _row(result: ClaimResult) -> Markup:
    """Returns the table row of one step: its mark, the formula, the fault, and the counterexample."""
    from markupsafe import Markup, escape

    from workbench.app.commands.listing_text import MARKS
    from workbench.report.counterexamples import told
    from workbench.report.html_page import math, runs
    from workbench.report.mixed_prose import runs_with_symbols

    grade, example = result.shown, result.counterexample
    words = str(result.proposed[0].edit) if result.proposed else str(result.verdict.reason or "")
    parts = [escape(_word(result)), *([runs(runs_with_symbols(words))] if words else [])]
    if example is not None:
        parts.append(runs(told(example, result.claim.printed.latex).sentence))
    style = f"color:{_COLOURS.get(str(grade), 'inherit')};font-weight:bold"
    cells = (math(result.claim.printed.latex), Markup("; ").join(parts))
    rest = Markup("").join(Markup("<td style='text-align:left'>{}</td>").format(each) for each in cells)
    return Markup("<tr><td style='{}'>{}</td>{}</tr>").format(style, MARKS[grade], rest)


def _word(result: ClaimResult) -> str:
    return {"ok": "holds", "note": str(result.verdict.outcome)}.get(str(result.shown), str(result.shown))


def check_cell(line: str, cell: str) -> CheckedCell:
    """Returns the verdicts on a cell. Raises ValueError for unusable input.

    line: kinds of symbols, as in `-s a=vector`; missing ones are inferred.
    """
    from tempfile import TemporaryDirectory

    from workbench.app.pipeline.judged_files import judged_file, with_corrections

    text, suffix = _as_text(cell)
    with TemporaryDirectory(prefix="workbench-") as name:
        folder = Path(name)
        path = folder / f"cell{suffix}"
        judged = judged_file(path, {path: text}, answers=list(_kinds(line)), folder=folder)
        return CheckedCell(with_corrections(judged))


def _as_text(cell: str) -> tuple[str, str]:
    """Returns the cell as a text with its file suffix: TeX, Markdown, or the lines of one derivation."""
    if _IS_TEX.search(cell):
        return cell, ".tex"
    if "$" in cell:
        return cell, ".md"
    return f"\\begin{{align}}\n{cell.strip()}\n\\end{{align}}\n", ".tex"


def _kinds(line: str) -> Iterator[Answer]:
    from workbench.language.naming.symbols import SymbolTable
    from workbench.papers.drafting.model_file import string
    from workbench.papers.drafting.questions_to_author import Answer

    words = iter(shlex.split(line, posix=False))
    for word in words:
        name, sign, kind = next(words, "").strip("'\"").partition("=")
        if word not in ("-s", "--symbol") or not (name and sign and kind):
            raise ValueError(f"%%check: expected -s NAME=KIND, as in -s a=vector, got {line!r}")
        SymbolTable().with_specs({name: {"kind": kind}})  # raises ValueError for a kind that there is not
        yield Answer("symbols", string(name), string(kind))


def register(shell: InteractiveShell) -> None:
    """Registers %%check in a shell."""
    from IPython.core.error import UsageError

    def check(line: str, cell: str) -> CheckedCell:
        """Judge each step of the formulas of this cell. %%check -s a=vector says what a symbol is."""
        try:
            return check_cell(line, cell)
        except ValueError as error:
            raise UsageError(str(error)) from None

    magic: Any = check
    shell.register_magic_function(magic, "cell", "check")
