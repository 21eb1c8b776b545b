"""What a formula that cannot be read would need, by name: `ingest` counts by it."""

from __future__ import annotations

import re

_BY_MESSAGE = (
    (r"the integer variable", "indices without a range"),
    (r"unexpected character '/'", "slashes"),
    (r"a subscript on an expression", "subscripts on brackets"),
    (r".*words in a formula", "words"),
    (r"& outside", "alignment marks inside of brackets"),
    (r".*got an expression alone", "a formula without a relation"),
    (
        r".*differ in type|expected a (?:vector|tensor|scalar|quaternion)\b|juxtaposition of|the transpose",
        "kinds that do not fit as guessed",
    ),
)
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
    (r"\\log(?![A-Za-z])|\\ln(?![A-Za-z])", "logarithms"),
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
    (r"\\(?:leq?|geq?|ll|gg)(?![A-Za-z])|[<>]", "inequalities"),
    (r"\\(?:text|mbox|textrm)(?![A-Za-z])", "words"),
    (r"'", "primes"),
)


def feature_of(latex: str, message: str) -> str:
    """What the reader says, without the particulars; else the first that the formula shows signs of."""
    if message.startswith("the macro "):
        return "macros that only TeX can follow"
    if match := re.search(r"unknown command (\\\S+)", message):
        return f"the command {match[1]}"
    for pattern, name in _BY_MESSAGE:
        if re.match(pattern, message):
            return name
    for pattern, name in _BY_LATEX:
        if re.search(pattern, latex):
            return name
    if "says nothing" in message or not re.search(r"=", latex):
        return "a formula without a relation"
    return "kinds that do not fit as guessed" if "expected" in message else "another spelling"
