"""Results as documents: JSON, Markdown, HTML and a LaTeX erratum note.

The rendering libraries load on the first report, not with this package.
"""


class ReportError(ValueError):
    """The report cannot be rendered: what was expected, what was got, and where."""
