"""Writes the files of a report; equal results give equal bytes."""

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

from workbench.context.claims import Paper
from workbench.prover.results.claim_results import ClaimResult
from workbench.report import ReportError, html_page, markdown_text, wording
from workbench.report.document import Document, document_of
from workbench.report.erratum import erratum_note
from workbench.report.erratum.corrected_text import errata_diff
from workbench.report.erratum.errata_json import errata_json
from workbench.report.erratum.note_pdf import pdf_of
from workbench.report.pictures import all_errors
from workbench.report.shown_kinds import SHOWN
from workbench.report.to_json import report_json

_PDF = "erratum.pdf"


def write_report(
    paper: Paper, results: Sequence[ClaimResult], out: Path, source: Path | None = None, has_pdf: bool = False
) -> list[Path]:
    """Writes the files of `render` to the directory `out`, and returns their paths.

    All files are written before the first is moved into place. Raises ReportError for characters that cannot
    be typeset, or if `out` cannot be a directory or has no space.

    source: the text that was read, if the paper is not a text itself. has_pdf: write erratum.pdf, too.
    """
    texts = render(paper, results, source, has_pdf)
    contents = {name: text.encode("utf-8") for name, text in texts.items()}
    if has_pdf:
        contents[_PDF] = pdf_of(texts["erratum.tex"])
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=out, prefix=".unfinished-") as staging:
            for name, content in contents.items():
                (Path(staging) / name).write_bytes(content)
            for name in contents:
                os.replace(Path(staging) / name, out / name)
            for name in {"errata.diff", _PDF} - contents.keys():
                (out / name).unlink(missing_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise ReportError(f"{out}: expected a directory for the report, got a file") from None
    except OSError as error:
        raise ReportError(f"{out}: the report cannot be written: {error.strerror or error}") from None
    return [out / name for name in contents]


def render(
    paper: Paper, results: Sequence[ClaimResult], source: Path | None = None, has_pdf: bool = False
) -> dict[str, str]:
    """Returns file name → content: report.json, .html and .md, erratum.tex, errata.json, and errata.diff if
    the text is available. has_pdf: the page links to erratum.pdf.

    Raises:
        ReportError: A character cannot be typeset, or a file cannot be read.
    """
    told = json.dumps(report_json(paper, results), ensure_ascii=False, indent=2, allow_nan=False)
    document = document_of(paper, results)
    texts = {"report.json": told + "\n", "errata.json": errata_json(document)}
    read = source or _own_text(paper)
    if read is not None and (patch := errata_diff(_content(read), read.name, results)):
        texts["errata.diff"] = patch
    sent = [*([_PDF] if has_pdf else []), "erratum.tex", *(n for n in texts if n.startswith("errata"))]
    for name, environment in (
        ("report.md", _environment(markdown_text.FILTERS)),
        ("report.html", _environment(html_page.FILTERS, is_html=True)),
        ("erratum.tex", _tex_environment()),
    ):
        texts[name] = _filled(environment, name, document, sent)
    return texts


def page_of(paper: Paper, results: Sequence[ClaimResult]) -> str:
    """The report as one page that needs no other file. Raises ReportError for what cannot be set."""
    return _filled(
        _environment(html_page.FILTERS, is_html=True), "report.html", document_of(paper, results), ()
    )


def _filled(environment: Environment, name: str, document: Document, sent: Sequence[str]) -> str:
    template = environment.get_template(name + ".j2")
    return template.render(document=document, picture=all_errors(document.rows), sent=sent, **_shared())


def _own_text(paper: Paper) -> Path | None:
    """Returns the file of a text, if it consists of one file."""
    files = {result.context.span.file for result in paper.claims if result.context.span is not None}
    return next(iter(files)) if len(files) == 1 else None


def _content(source: Path) -> str:
    try:
        return source.read_bytes().decode("utf-8")
    except OSError as error:
        raise ReportError(f"{source}: the text that was read cannot be opened: {error.strerror}") from None
    except UnicodeDecodeError:
        raise ReportError(f"{source}: expected a text in UTF-8, got other bytes") from None


@cache
def _shared() -> dict[str, Any]:
    """Returns the shared parts of pages: the script with its hash for the content security policy, and the
    font."""
    here = files("workbench.report")
    script = here.joinpath("templates/report.js").read_text("utf-8")
    digest = b64encode(sha256(script.encode()).digest()).decode()
    font = b64encode(here.joinpath("font/workbench-math.woff2").read_bytes()).decode()
    return {"shown": SHOWN, "script": script, "script_hash": f"sha256-{digest}", "font": font}


def _environment(filters: Mapping[str, Any], is_html: bool = False) -> Environment:
    environment = Environment(
        loader=_loader(),
        autoescape=select_autoescape(("html.j2",)) if is_html else False,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters.update(wording.FILTERS)
    environment.filters.update(filters)
    return environment


def _tex_environment() -> Environment:
    """Returns the environment of the TeX template, which uses << >> and <% %> instead of braces."""
    return _environment(erratum_note.FILTERS).overlay(
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
