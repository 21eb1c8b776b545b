"""The erratum note as PDF, where LaTeX is installed."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

from workbench.report import ReportError

INSTALL = "apt-get install texlive-latex-recommended texlive-latex-extra texlive-fonts-recommended lmodern"

#: pdfLaTeX runs twice: the second time it knows the targets of the links.
_RUNS = 2
_SECONDS = 120
_OPTIONS = ("-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape")


def pdf_of(tex: str) -> bytes:
    """Returns the PDF of a note.

    Raises:
        ReportError: There is no pdflatex, or it does not typeset the note.
    """
    if shutil.which("pdflatex") is None:
        raise ReportError(f"the PDF needs pdflatex, which is not installed ({INSTALL})")
    with TemporaryDirectory() as place:
        Path(place, "erratum.tex").write_text(tex, encoding="utf-8")
        for _ in range(_RUNS):
            try:
                made = subprocess.run(
                    ["pdflatex", *_OPTIONS, "erratum.tex"],
                    cwd=place,
                    capture_output=True,
                    check=False,
                    timeout=_SECONDS,
                )
            except subprocess.TimeoutExpired:
                raise ReportError(f"the PDF: pdflatex was not finished in {_SECONDS} s") from None
            if made.returncode:
                said = made.stdout.decode(errors="replace").splitlines()
                fault = next((line for line in said if line.startswith("!")), "no message")
                raise ReportError(f"the PDF: pdflatex does not typeset erratum.tex: {fault}")
        return Path(place, "erratum.pdf").read_bytes()
