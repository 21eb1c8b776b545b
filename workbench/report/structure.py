"""The canonical report: which keys it has, in which order, and what each may hold."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from workbench.report.kinds import FAULTS, VERDICTS

_REPORT_KEYS = ("paper", "versions", "claims", "summary", "witnesses")
_PAPER_KEYS = ("title", "doi", "authors", "source", "year", "pages", "commit", "licence", "read", "recheck")
_CLAIM_KEYS = (
    "id", "equation", "section", "printed", "formula", "goal", "statement", "read_back", "verdict", "scope",
    "reason", "fault", "mend", "reading", "corrected", "hypothesis", "assume", "orders", "counterexample",
    "evidence", "motion", "no_motion", "inherits", "note", "expected", "passed", "why_not", "proposed",
    "place", "chain", "certificates",
)  # fmt: skip
_PROPOSAL_KEYS = ("latex", "edit", "difference", "verdict")
_FORM_KEYS = ("latex", "verdict", "read_back", "scope", "reason", "evidence", "no_motion")
_MEND_KEYS = ("edits", "place", "beside", "cause", "add", "example", "mended_by", "is_proved")
_EDIT_KEYS = ("for", "read", "is_math")
_MAY_BE_ABSENT = frozenset({
    "formula", "goal", "fault", "mend", "statement", "reason", "assume", "orders", "expected", "passed",
    "why_not", "read_back", "scope", "evidence", "proposed", "motion", "no_motion", "place", "chain",
    "certificates",
})  # fmt: skip
_TEXT_OR_NULL = (
    "equation", "section", "printed", "formula", "goal", "fault", "statement", "read_back", "scope", "reason",
    "hypothesis", "orders", "note", "expected", "why_not", "no_motion",
)  # fmt: skip


class ReportError(ValueError):
    """The report cannot be rendered: what was expected, what was got, and where."""


def canonical(report: Mapping[str, Any]) -> dict[str, Any]:
    """The report with its keys in canonical order.

    Raises ReportError for a missing or unknown key, a value of the wrong type, an unknown verdict, an
    id used twice, or a summary that does not count the verdicts of the claims.
    """
    _keys(report, _REPORT_KEYS, "report", frozenset({"witnesses"}))
    _keys(report["paper"], _PAPER_KEYS, "paper", frozenset(_PAPER_KEYS[2:]))
    _text(report["paper"]["title"], "paper.title")
    for key in _PAPER_KEYS[1:]:
        _text(report["paper"].get(key), f"paper.{key}", nullable=True)
    _mapping(report["versions"], "versions")
    claims = [
        _claim(claim, f"claims[{index}]") for index, claim in enumerate(_list(report["claims"], "claims"))
    ]
    _unique_ids(claims)
    rest = {"witnesses": report["witnesses"]} if "witnesses" in report else {}
    return {
        "paper": {key: report["paper"][key] for key in _PAPER_KEYS if key in report["paper"]},
        "versions": {name: _text(v, f"versions.{name}") for name, v in report["versions"].items()},
        "claims": claims,
        "summary": _summary(report["summary"], claims),
        **rest,
    }


def canonical_json(report: Mapping[str, Any]) -> str:
    """report.json: keys in canonical order, UTF-8 text as it is, one trailing newline."""
    try:
        return json.dumps(report, ensure_ascii=False, indent=2, allow_nan=False) + "\n"
    except (TypeError, ValueError) as error:
        raise ReportError(f"report: expected JSON values (no NaN, no objects): {error}") from error


def _claim(claim: Any, place: str) -> dict[str, Any]:
    _keys(claim, _CLAIM_KEYS, place, _MAY_BE_ABSENT - {"read_back", "scope", "evidence"})
    _text(claim["id"], f"{place}.id")
    for key in _TEXT_OR_NULL:
        _text(claim.get(key), f"{place}.{key}", nullable=True)
    if not any(claim.get(key) for key in ("printed", "formula", "goal", "statement")):
        raise ReportError(f"{place}: expected a printed formula or a statement, got neither")
    _verdict(claim["verdict"], f"{place}.verdict")
    if claim.get("fault") is not None and claim["fault"] not in FAULTS:
        raise ReportError(f"{place}.fault: expected one of {', '.join(FAULTS)}; got {claim['fault']!r}")
    if claim.get("mend") is not None:
        _mend(claim["mend"], f"{place}.mend")
    for key in ("inherits", "assume"):
        _texts(claim.get(key, ()), f"{place}.{key}")
    for index, proposal in enumerate(_list(claim.get("proposed", []), f"{place}.proposed")):
        _proposal(proposal, f"{place}.proposed[{index}]")
    if claim["counterexample"] is not None:
        _counterexample(claim["counterexample"], f"{place}.counterexample")
    _evidence(claim["evidence"], f"{place}.evidence")
    _mapping(claim.get("motion", {}), f"{place}.motion")
    forms = {key: _form(claim[key], f"{place}.{key}") for key in ("reading", "corrected")}
    return {key: (claim | forms)[key] for key in _CLAIM_KEYS if key in claim}


def _mend(mend: Any, place: str) -> None:
    _keys(mend, _MEND_KEYS, place, frozenset({"add", "example"}))
    for key in ("place", "beside", "cause", "add", "example", "mended_by"):
        _text(mend.get(key), f"{place}.{key}", nullable=True)
    for index, edit in enumerate(_list(mend["edits"], f"{place}.edits")):
        _keys(edit, _EDIT_KEYS, f"{place}.edits[{index}]")
        for key in ("for", "read"):
            _text(edit[key], f"{place}.edits[{index}].{key}")


def _proposal(proposal: Any, place: str) -> None:
    _keys(proposal, _PROPOSAL_KEYS, place, frozenset({"difference"}))
    _text(proposal["latex"], f"{place}.latex")
    _text(proposal["edit"], f"{place}.edit")
    _verdict(proposal["verdict"], f"{place}.verdict")
    for index, part in enumerate(_list(proposal.get("difference", ()), f"{place}.difference")):
        where = f"{place}.difference[{index}]"
        keys = ("same",) if "same" in _mapping(part, where) else ("printed", "proposed")
        _keys(part, keys, where)
        for key in keys:
            _text(part[key], f"{where}.{key}")


def _form(form: Any, place: str) -> dict[str, Any] | None:
    if form is None:
        return None
    _keys(form, _FORM_KEYS, place, _MAY_BE_ABSENT)
    _text(form["latex"], f"{place}.latex")
    _verdict(form["verdict"], f"{place}.verdict")
    for key in ("read_back", "scope", "reason"):
        _text(form.get(key), f"{place}.{key}", nullable=True)
    _evidence(form.get("evidence", ()), f"{place}.evidence")
    return {key: form[key] for key in _FORM_KEYS if key in form}


def _evidence(items: Any, place: str) -> None:
    for index, item in enumerate(_list(items, place)):
        where = f"{place}[{index}]"
        for key in ("method", "outcome"):
            _text(_mapping(item, where).get(key), f"{where}.{key}")


def _counterexample(example: Any, place: str) -> None:
    _keys(example, ("values", "lhs", "rhs", "defined", "behind"), place, frozenset({"defined", "behind"}))
    for symbol, entries in _mapping(example["values"], f"{place}.values").items():
        _texts(entries, f"{place}.values[{symbol!r}]")
    for side in ("lhs", "rhs"):
        if not isinstance(example[side], str):
            _texts(example[side], f"{place}.{side}")


def _summary(summary: Any, claims: Sequence[Mapping[str, Any]]) -> dict[str, int]:
    counted = Counter(claim["verdict"] for claim in claims)
    for verdict, count in _mapping(summary, "summary").items():
        _verdict(verdict, f"summary key {verdict!r}")
        if count != counted[verdict]:
            raise ReportError(f"summary.{verdict}: expected {counted[verdict]}, got {count!r}")
    missing = [verdict for verdict in counted if verdict not in summary]
    if missing:
        raise ReportError(f"summary: expected a count of {', '.join(missing)}, got none")
    return {verdict: summary[verdict] for verdict in VERDICTS if verdict in summary}


def _unique_ids(claims: Sequence[Mapping[str, Any]]) -> None:
    twice = [name for name, n in Counter(claim["id"] for claim in claims).items() if n > 1]
    if twice:
        raise ReportError(f"claims: expected every id once, got {', '.join(twice)} more than once")


def _keys(value: Any, known: Sequence[str], place: str, optional: frozenset[str] = frozenset()) -> None:
    _mapping(value, place)
    missing = [key for key in known if key not in value and key not in optional]
    unknown = [str(key) for key in value if key not in known]
    if missing or unknown:
        got = [f"no {key}" for key in missing] + [f"unknown {key}" for key in unknown]
        raise ReportError(f"{place}: expected {', '.join(known)}; got {', '.join(got)}")


def _mapping(value: Any, place: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise ReportError(f"{place}: expected an object, got {type(value).__name__}")
    return value


def _list(value: Any, place: str) -> Sequence[Any]:
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise ReportError(f"{place}: expected a list, got {type(value).__name__}")
    return value


def _texts(value: Any, place: str) -> None:
    for index, entry in enumerate(_list(value, place)):
        _text(entry, f"{place}[{index}]")


def _text(value: Any, place: str, nullable: bool = False) -> str | None:
    if not isinstance(value, str) and not (nullable and value is None):
        wanted = "a string or null" if nullable else "a string"
        raise ReportError(f"{place}: expected {wanted}, got {type(value).__name__}")
    return value


def _verdict(value: Any, place: str) -> None:
    if value not in VERDICTS:
        raise ReportError(f"{place}: expected one of {', '.join(VERDICTS)}; got {value!r}")
