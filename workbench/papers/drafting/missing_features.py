"""Names of the features that unreadable formulas need; `ingest` counts by them."""

from __future__ import annotations

import re

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import UNFIT_KINDS, TypeCode
from workbench.core.reasons import Reason
from workbench.source.rows.display_vocabulary import ORDER

_FEATURES = {
    SyntaxCode.INTEGER_WITHOUT_RANGE: "indices without a range",
    SyntaxCode.SUBSCRIPT_ON_EXPRESSION: "subscripts on brackets",
    SyntaxCode.UNKNOWN_FUNCTION: "words",
    SyntaxCode.WORDS_IN_FORMULA: "words",
    SyntaxCode.ALIGNMENT_MARK: "alignment marks inside of brackets",
    SyntaxCode.ALONE: "a formula without a relation",
    SyntaxCode.OPAQUE_MACROS: "macros that only TeX can follow",
}
_KINDS = "kinds that do not fit as guessed"
#: Faults of the reader that other kinds of the symbols would avoid.
_OF_KINDS = UNFIT_KINDS | {
    *(TypeCode.EXPECTED_ARGUMENT, TypeCode.TENSOR_UNDER_TILDE),
    *(SyntaxCode.CROSS_OF, SyntaxCode.COMPOSITION_OF, SyntaxCode.STAR_OF),
}
_BY_LATEX = (
    (r"\\(?:i*int|oint)(?![A-Za-z])", "integrals"),
    (r"\\lim(?![A-Za-z])|\\limsup|\\sup(?![A-Za-z])", "limits"),
    (r"\\[lcdv]?dots|\.\.\.|…", "ellipsis"),
    (r"\\(?:partial|nabla|pdv)(?![A-Za-z])", "partial derivatives"),
    (
        r"\\arg(?:min|max|(?![A-Za-z]))|\\operatorname\*?\{arg(?:min|max)\}|\\(?:min|max)(?![A-Za-z])",
        "optimization",
    ),
    (r"\\(?:mapsto|to|rightarrow|colon)(?![A-Za-z])", "maps"),
    (r"\\log(?![A-Za-z])|\\ln(?![A-Za-z])|\bLog\b", "logarithms"),
    (r"\\(?:approx|simeq|sim|propto)(?![A-Za-z])|\\mathcal\{?O", "approximation"),
    (r"(?:\{\}|(?<![A-Za-z}\])]))\s*[_^]\s*\{?[A-Za-z\\]|\{\}\s*\^", "frames (scripts on the left)"),
    (r"/", "slashes"),
    (r"\\sqrt", "roots"),
    (
        r"\\(?:arccos|arcsin|arctan|tan|sec|cot|atan\w*)(?![A-Za-z])|arc(?:cos|sin|tan)|atan2",
        "inverse and other angles",
    ),
    (r"\\(?:wedge|vee|land)(?![A-Za-z])|\^\{?\\times", "hat and vee maps"),
    (r"\\hat(?![A-Za-z])|\\widehat", "hats"),
    (r"\\check(?![A-Za-z])", "checks"),
    (r"\\begin\{[bpv]?(?:matrix|array)", "matrices of numbers"),
    (r"\\begin\{d?cases\}", "cases"),
    (r"\\in(?![A-Za-z])", "membership in sets"),
    (ORDER.pattern, "inequalities"),
    (r"\\(?:text|mbox|textrm)(?![A-Za-z])", "words"),
    (r"'", "primes"),
)


def feature_of(latex: str, reason: Reason | None) -> str:
    """Returns the feature that the reader's reason names, else the first one that the formula suggests."""
    for part in reason.parts() if reason is not None else ():
        if part.code is SyntaxCode.UNKNOWN_COMMAND:
            return f"the command {part.arguments['text']}"
        if part.code is SyntaxCode.UNEXPECTED_CHARACTER and part.arguments["text"] == "'/'":
            return "slashes"
        if part.code in _FEATURES:
            return _FEATURES[part.code]
    if reason is not None and not reason.codes.isdisjoint(_OF_KINDS):
        return _KINDS
    for pattern, name in _BY_LATEX:
        if re.search(pattern, latex):
            return name
    says_nothing = reason is not None and SyntaxCode.SAYS_NOTHING in reason.codes
    if says_nothing or not re.search(r"=", latex):
        return "a formula without a relation"
    return _KINDS if reason is not None and isinstance(reason.code, TypeCode) else "another spelling"
