"""The errata for a publisher as JSON: a correction notice in the terms of Crossref and JATS."""

from __future__ import annotations

import json
from typing import Any

from workbench.report.document import Document
from workbench.report.erratum.equation_entries import Entry
from workbench.report.erratum.errata import Correction
from workbench.report.mixed_prose import Run, is_one_formula
from workbench.report.wording import short

#: The terms for a correction notice in Crossref's `update-to` and JATS's `related-article`.
_TYPES = {"crossref": "erratum", "jats": "corrected-article"}


def errata_json(document: Document) -> str:
    """Returns one entry for each correction, in the order of the note; equal input gives equal bytes."""
    entries = {entry.id: entry for entry in document.entries}
    cited, doi = document.citation, document.citation.get("doi")
    data: dict[str, Any] = {
        "article-type": "correction",
        "title": [f"Errata: {document.title}"],
        **({"container-title": [cited["source"]]} if "source" in cited else {}),
        "update-to": [{"DOI": doi, "type": _TYPES["crossref"], "label": "Erratum"}] if doi else [],
        "related-article": (
            [{"related-article-type": _TYPES["jats"], "ext-link-type": "doi", "xlink:href": doi}]
            if doi
            else []
        ),
        "counts": {each.kind.name: each.count for each in document.classes},
        "equations": document.counted,
        "corrections": [_correction(each, entries[each.id]) for each in document.errata.corrections],
    }
    return json.dumps(data, ensure_ascii=False, indent=2) + "\n"


def _correction(each: Correction, entry: Entry) -> dict[str, Any]:
    right = [(form.latex, form.kind.name) for form in entry.forms if form.kind is not None]
    return {
        "label": short(each.heading),
        "claim": each.id,
        "class": each.fault,
        "by": "transcription" if each.fault == "transcription" else "author",
        **({"place": each.place} if each.place else {}),
        "edits": [
            {"for": plain(change.old), "read": plain(change.new or ()), "is_math": is_one_formula(change.old)}
            for change in each.changes
        ],
        **({"source_edits": [e.to_dict() for e in entry.result.edits]} if entry.result.edits else {}),
        **({"add": plain(each.add)} if each.add else {}),
        **({"cause": each.cause} if each.cause else {}),
        "why": plain(each.why),
        "counterexample": plain(each.example) or (str(each.counterexample) if each.counterexample else None),
        "corrected": dict(zip(("latex", "verdict"), right[-1], strict=True)) if right else None,
    }


def plain(sentence: tuple[Run, ...]) -> str:
    """Returns the text with its formulas between dollar signs; a single formula without them."""
    if is_one_formula(sentence):
        return sentence[0].content
    return "".join(f"${run.content}$" if run.is_math else run.content for run in sentence)
