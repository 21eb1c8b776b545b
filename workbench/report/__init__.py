"""Reports: results as JSON, Markdown, HTML and a LaTeX erratum note.

What is this? `document` collects the results by equation and section; `render` writes it in all formats with
the templates; `findings` and `listing` are the results on a text for editors and the terminal. When do I come
here? To change the wording (wording.py, shown_kinds.py) or a format. What may it import? core, source,
context, prover, papers. What checks it? tests/report.

The rendering libraries are imported with the first report, not with this package.
"""

from workbench.core.callable_package import make_callable


class ReportError(ValueError):
    """The report cannot be rendered; the message states what was expected, what was found, and where."""


make_callable(__name__, "workbench.app.api:report")
