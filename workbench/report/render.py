"""The four files of a report: same results, same bytes."""

from __future__ import annotations

import json
import os
import tempfile
from base64 import b64encode
from collections.abc import Mapping, Sequence
from functools import cache
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from markupsafe import Markup, escape

from workbench.papers.model import Paper
from workbench.report import ReportError, markdown, tex
from workbench.report.document import CITED_AS, document_of
from workbench.report.kinds import STATES, VERDICTS
from workbench.report.mathml import mathml
from workbench.report.prose import Run
from workbench.report.to_json import report_json
from workbench.verify.results import ClaimResult

_MATH_FAILED = "This formula could not be typeset for certain; this is its LaTeX source."


def write_report(paper: Paper, results: Sequence[ClaimResult], out: Path) -> list[Path]:
    """Write report.json, report.md, report.html and erratum.tex into the directory `out`.

    Returns their paths. All files are written before the first is put in place. Raises ReportError for what
    cannot be set, and if `out` cannot be a directory or has no room.
    """
    texts = render(paper, results)
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=out, prefix=".unfinished-") as staging:
            for name, content in texts.items():
                (Path(staging) / name).write_bytes(content.encode("utf-8"))
            for name in texts:
                os.replace(Path(staging) / name, out / name)
    except (FileExistsError, NotADirectoryError):
        raise ReportError(f"{out}: expected a directory for the report, got a file") from None
    except OSError as error:
        raise ReportError(f"{out}: the report cannot be written: {error.strerror or error}") from None
    return [out / name for name in texts]


def render(paper: Paper, results: Sequence[ClaimResult]) -> dict[str, str]:
    """The text of each file by name. Raises ReportError for what cannot be set."""
    told = json.dumps(report_json(paper, results), ensure_ascii=False, indent=2, allow_nan=False)
    texts = {"report.json": told + "\n"}
    document = document_of(paper, results)
    for name, environment in (
        ("report.md", _environment(markdown.FILTERS)),
        ("report.html", _environment(_HTML_FILTERS, html=True)),
        ("erratum.tex", _tex_environment()),
    ):
        template = environment.get_template(name + ".j2")
        texts[name] = template.render(document=document, **_shared())
    return texts


@cache
def _shared() -> dict[str, Any]:
    """What templates share: the table of kinds, and the script of the page with the hash that admits it."""
    script = files("workbench.report").joinpath("templates/report.js").read_text("utf-8")
    digest = b64encode(sha256(script.encode()).digest()).decode()
    return {
        "cited_as": CITED_AS,
        "states": STATES,
        "verdicts": VERDICTS,
        "colours": list((VERDICTS | STATES).values()),
        "script": script,
        "script_hash": f"sha256-{digest}",
    }


def _html_math(latex: str, marked: frozenset[int] = frozenset(), display: bool = False) -> Markup:
    """MathML, or the LaTeX source with a sign that it is source."""
    converted = mathml(latex, display, marked)
    if converted is not None:
        return Markup(converted)
    return Markup('<code class="source" title="{}">{}</code><span class="source-sign">{}</span>').format(
        _MATH_FAILED, latex, " (LaTeX source)"
    )


def _html_runs(runs: tuple[Run, ...] | list[Run]) -> Markup:
    return Markup("").join(_html_math(run.content) if run.is_math else escape(run.content) for run in runs)


_HTML_FILTERS = {"math": _html_math, "runs": _html_runs}


def _environment(filters: Mapping[str, Any], html: bool = False) -> Environment:
    environment = Environment(
        loader=_loader(),
        autoescape=select_autoescape(("html.j2",)) if html else False,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters.update(filters)
    return environment


def _tex_environment() -> Environment:
    """TeX is full of braces and per cents: its template uses << >> and <% %>."""
    return _environment(tex.FILTERS).overlay(
        block_start_string="<%",
        block_end_string="%>",
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
    )


@cache
def _loader() -> PackageLoader:
    return PackageLoader("workbench.report", "templates")
