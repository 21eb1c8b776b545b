"""Sphinx extension: judges the displayed formulas of each page, and reports faults as warnings.

`extensions = ["workbench.app.sphinx_ext"]`. A page is left out by `:workbench: off` among its fields, or
`workbench: off` in its front matter.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

from docutils import nodes
from sphinx.util import logging

if TYPE_CHECKING:
    from sphinx.application import Sphinx

    from workbench.app.pipeline.judged_files import Judged
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.source.documents import Display

_LOG = logging.getLogger(__name__)
#: The grades, most serious first.
_ORDER = ("error", "warning", "not judged", "ok", "note")
_MARKS = {"error": "✗", "warning": "!"}
_AROUND = re.compile(
    r"\\(?:begin|end)\{(?:equation|align|aligned|split|gather|gathered)\*?\}|\\label\{[^{}]*\}"
)
_LEFT_OUT = frozenset({"off", "false", "no"})


def setup(app: Sphinx) -> dict[str, Any]:
    """Connects the extension; called by Sphinx."""
    app.add_config_value("workbench_marks", True, "env", bool)
    app.add_config_value("workbench_level", "warning", "env", str)
    app.connect("builder-inited", _add_style)
    app.connect("doctree-read", _check_page)
    return {
        "version": version("kinematics-workbench"),
        "parallel_read_safe": True,
        "parallel_write_safe": True,
    }


def _add_style(app: Sphinx) -> None:
    if app.config.workbench_level not in ("warning", "error"):
        _LOG.warning(
            "workbench_level: expected 'warning' or 'error', got %r", app.config.workbench_level,
            type="workbench", subtype="config",
        )  # fmt: skip
    app.config.html_static_path.append(str(Path(__file__).with_name("workbench.css")))
    app.add_css_file("workbench.css")


def _check_page(app: Sphinx, doctree: nodes.document) -> None:
    """Judges the formulas of a page after it was read, and marks them."""
    from workbench.app.pipeline.judged_files import judged_file
    from workbench.papers import PaperError
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.source.documents import SUFFIXES

    page = app.env.current_document.docname
    path = Path(app.env.doc2path(page))
    said = str(app.env.metadata.get(page, {}).get("workbench", "")).strip().lower()
    found = [node for node in doctree.findall(nodes.math_block) if not _is_of_docstring(node)]
    if said in _LEFT_OUT or not found or path.suffix.lower() not in SUFFIXES:
        return
    try:
        judged = judged_file(path, folder=Path(app.srcdir))
    except PaperError as error:
        for fault in error.faults:
            _LOG.warning(
                fault.message,
                location=f"{fault.file or path}:{fault.line or 1}",
                type="workbench",
                subtype="model",
            )
        return
    if not isinstance(judged.paper, TextPaper):
        return
    levels = ("error", "warning") if app.config.workbench_level == "warning" else ("error",)
    told = _warnings(judged, levels)
    if app.config.workbench_marks:
        _mark(found, judged.paper, judged.results, told)


def _is_of_docstring(node: nodes.math_block) -> bool:
    """True if a formula comes from a docstring, not from the file of the page."""
    return "docstring of" in (node.source or "")


def _warnings(judged: Judged, levels: Sequence[str]) -> dict[str, list[str]]:
    """Reports faults as warnings of Sphinx, and returns the messages by claim."""
    from workbench.report.findings import findings

    told: dict[str, list[str]] = defaultdict(list)
    for finding in findings(judged.paper, judged.results):
        if finding.level in levels:
            place = f"{finding.span.file}:{finding.span.line}"
            _LOG.warning(finding.message, location=place, type="workbench", subtype=finding.code)
            told[finding.claim].append(finding.message)
    return told


def _mark(
    found: Sequence[nodes.math_block],
    paper: TextPaper,
    results: Sequence[ClaimResult],
    told: Mapping[str, Sequence[str]],
) -> None:
    """Gives each formula a class for its grade, and adds its faults below it."""
    by_content: dict[str, list[ClaimResult]] = defaultdict(list)
    for display in paper.text.displays if paper.text else ():
        by_content[_content(display.latex)] += [each for each in results if _lies_in(each, display)]
    for node in found:
        own = by_content.get(_content(node.astext()))
        if not own:
            continue
        grade = min((str(each.shown) for each in own), key=_ORDER.index)
        node["classes"] += ["workbench", f"workbench-{grade.replace(' ', '-')}"]
        messages = dict.fromkeys(message for each in own for message in told.get(each.claim.id, ()))
        if messages and node.parent is not None:
            says = _says(f"{_MARKS[grade]} {'; '.join(messages)}", grade)
            node.parent.insert(node.parent.index(node) + 1, says)


def _lies_in(result: ClaimResult, display: Display) -> bool:
    source, span = display.source, result.claim.context.span
    if span is None or span.file != source.path:
        return False
    return source.place(display.start) <= (span.line, span.column) <= source.place(display.end)


def _content(latex: str) -> str:
    """Returns a formula without blanks, environment and label."""
    return re.sub(r"\s+", "", _AROUND.sub("", latex))


def _says(message: str, grade: str) -> nodes.paragraph:
    from workbench.report.mixed_prose import runs_with_symbols

    made = nodes.paragraph(classes=["workbench-says", f"workbench-{grade}"])
    for run in runs_with_symbols(message):
        made += nodes.math(run.content, run.content) if run.is_math else nodes.Text(run.content)
    return made
