"""The sentences of a report, for readers who do not know the workbench."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Any

from workbench.core.verdict import Outcome
from workbench.prover.results.motion_summary import percent
from workbench.report.document import Class, Document
from workbench.report.erratum.equation_entries import Entry
from workbench.report.erratum.error_rows import gist_of

_METHODS = (
    ("exact ring over", "exact ring over ℚ (FLINT)"),
    ("SymPy PolyRing", "SymPy polynomials, Leibniz jets"),
    ("Drake symbolic", "Drake polynomials, Leibniz jets"),
    ("random point", "random point modulo a 61-bit prime"),
    ("Drake reference motions", "simulated motions"),
)
_ARGUED = {
    Outcome.ARGUED: "its steps are checked; what joins them is prose",
    Outcome.PROBABLE: "tested at random points only",
}


def equations(count: int) -> str:
    return f"{count} equation" + "s" * (count != 1)


def lead(document: Document) -> tuple[str, str]:
    """Returns the headline in two parts: what is wrong, in bold type, and the rest."""
    total, wrong = document.counted, document.in_state("error")
    misprinted, hold = document.in_state("misprint"), document.in_state("holds")
    missing = document.in_state("hypothesis")
    unjudged, doubtful = document.in_state("unjudged"), document.in_state("warning")
    if wrong:
        strong = f"{wrong} of {equations(total)} {'is' if wrong == 1 else 'are'} wrong"
    elif document.counted and unjudged == document.counted:
        return f"None of {equations(total)} was judged", "."
    elif document.rows:
        strong = f"{document.rows[0].label} is wrong"
    else:
        strong = f"No error found in {equations(total)}"
    rest = [f"{misprinted} {'is' if misprinted == 1 else 'are'} misprinted"] if misprinted else []
    rest += [f"{doubtful} {'is' if doubtful == 1 else 'are'} doubtful"] if doubtful else []
    rest += [f"{missing} {'needs' if missing == 1 else 'need'} a condition"] if missing else []
    rest += [f"{unjudged} {'is' if unjudged == 1 else 'are'} not judged"] if unjudged else []
    rest += [f"{hold} {'holds' if hold == 1 else 'hold'} as printed"] if hold else []
    return strong, "".join(f", {part}" for part in rest) + "."


def counts_line(classes: Sequence[Class]) -> str:
    """Returns a line such as: 2 errors, 3 not judged, 8 hold as printed."""
    return (
        ", ".join(f"{each.count} {counted(each)}" for each in classes if each.count) or "nothing was judged"
    )


def counted(each: Class) -> str:
    """Returns the words after a number of equations."""
    words = each.kind.counted
    if each.count != 1:
        return words
    singular = {
        "errors": "error",
        "misprints": "misprint",
        "warnings": "warning",
        "definitions": "definition",
    }
    singular |= {"conditions missing": "condition missing", "hold as printed": "holds as printed"}
    singular |= {"hold after a correction": "holds after a correction"}
    return singular.get(words, words)


def with_scope(word: str, scope: str | None) -> str:
    """Returns: holds for every n ≥ 1, holds for n = 1..8."""
    if not scope:
        return word
    return f"{word} for {re.sub(r'^all ', 'every ', scope)}"


def told(entry: Entry) -> tuple[str, str, str]:
    """Returns the style, a word in bold type, and the certainty shown next to a formula."""
    verdict, state = entry.result.verdict, entry.state
    if state.name == "holds":
        if verdict.outcome is Outcome.DEFINITION:
            return "ok", "definition", "agrees with its uses"
        return "ok", with_scope("holds", verdict.scope), "proved by two engines"
    if state.name == "inherits":
        names = [label.removeprefix("Eq. ") for label, _ in entry.rests_on]
        once = f"once {', '.join(names)} {'is' if len(names) == 1 else 'are'} corrected" if names else ""
        return "ok", with_scope("holds", verdict.scope), once or "once the lines before it are corrected"
    if state.name == "open":
        return "open", "not settled", _ARGUED.get(verdict.outcome, "")
    if state.name == "transcription":
        return "lost", "our copy", "probably lost a mark"
    if state.name == "error":
        cause = f"follows from {short(entry.mended_by[0])}" if entry.mended_by else gist_of(entry)
        return "err", "wrong", cause
    if state.name == "warning":
        return "warn", "false, unless", "one of the doubts below is meant"
    return state.look, state.label, ""


def corrected(outcome: str, scope: str | None) -> str:
    """Returns the certainty of a corrected form in words."""
    if outcome == Outcome.PROVED:
        return with_scope("proved by two engines", scope)
    if outcome == Outcome.DEFINITION:
        return "a definition; agrees with the equations that use it"
    if outcome == Outcome.CONDITIONAL:
        return "proved under the condition below"
    return {Outcome.REFUTED: "wrong", Outcome.ILL_FORMED: "sizes do not fit"}.get(outcome, outcome)  # type: ignore[call-overload]


def method(name: str) -> str:
    """Returns the name of a method in a table of evidence."""
    return next((short for beginning, short in _METHODS if name.startswith(beginning)), name)


def short(heading: str) -> str:
    """Returns (70) for Eq. (70)."""
    return heading.removeprefix("Eqs. ").removeprefix("Eq. ")


def cause(name: str) -> str:
    return "Other causes" if name == "Others." else name


def foot_line(document: Document) -> str:
    """Returns the line on what was read, and how many formulas were simulated and certified."""
    said, parts = document.citation.get("read", document.file), []
    digest = re.search(r"SHA-256 \w+", said)
    if said:
        parts.append(f"Read: {said.split(',')[0]}" + (f", {digest[0]}…" if digest else ""))
    if document.motions is not None:
        seen = document.motions
        parts.append(f"{seen.seen} of {seen.claims} formulas simulated on {document.motion_count} motions")
    if document.certified:
        parts.append(f"{document.certified} theorems checked by {document.certified_by}")
    return " · ".join(parts) or f"{len(document.entries)} formulas judged"


def provenance(document: Document) -> str:
    """Returns the description of all inputs and software used."""
    said = document.citation.get("read", document.file)
    parts = [f"Read: {said}"] if said else []
    parts.append(f"{len(document.entries)} formulas in {equations(document.counted)}")
    others = len(document.equations) - document.counted
    parts[-1] += f" and {others} theorems, remarks and sentences" if others else ""
    if document.motions is not None:
        parts += [f"{each.count} formulas not simulated ({each.reason})" for each in document.motions.unseen]
    parts.append(", ".join(f"{name} {version}" for name, version in document.versions))
    if "recheck" in document.citation:
        parts.append(f"recheck: {document.citation['recheck']}")
    return " · ".join(parts)


#: The functions that the templates of all formats call.
FILTERS: dict[str, Callable[..., Any]] = {
    "short": short,
    "cause": cause,
    "lead": lead,
    "foot_line": foot_line,
    "provenance": provenance,
    "percent": percent,
    "equations": equations,
}
