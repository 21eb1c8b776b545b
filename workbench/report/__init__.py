"""Results as documents: JSON, Markdown, HTML and a LaTeX erratum note.

The rendering libraries load on the first report, not with this package.
"""

from workbench.core.callable_package import make_callable


class ReportError(ValueError):
    """The report cannot be rendered: what was expected, what was got, and where."""


make_callable(__name__, "workbench.app.api:report")
