"""Patterns of the characters of a formula, from which its tokens are made."""

from __future__ import annotations

import re

#: Relation signs after an alignment mark, which do not begin a condition.
AFTER_ALIGNMENT = re.compile(r"\s*(?:=|:|\\(?:approx|equiv|neq?|triangleq|coloneqq?)(?![A-Za-z]))")

SIDES = re.compile(r"\\(left|right)(?![A-Za-z])\s*(\\?.)")

CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff]")

TOKEN = re.compile(
    r"""(?P<space>[ \t\r\n~]+|\\[a-z]+(?:sep|skip|stretch)\s*=\s*-?[0-9.]+(?:pt|em|ex|mm))
    | \\(?:stackrel|overset)\s*\{\s*(?:\\(?:text|mathrm|rm)\s*\{\s*def\.?\s*\}|def|\\triangle|\\Delta)\s*\}
      \s*(?P<defined>\{\s*=\s*\}|=)
    | (?P<ring>\\overset\s*\{\s*\\circ\s*\})
    | \\(?:text|textrm|mbox)\s*\{(?P<prose>[A-Za-z,'’\s]+:\s*)\}
    | \\(?:text|mathrm|operatorname\*?|textrm|mbox)\s*
      \{(?P<words>(?:arc|a)tan2|[1-3](?:-[1-3])+|\s*\\&\s*|[^\W\d_](?:[^\W\d_]|[.,\s])+|[^\W\d_A-Za-z]|\s+[A-Za-z.,\s]*|[.,;])\}
    | \\(?:text|textrm|mbox)\s*\{(?P<said>[^{}$]*)\}
    | \\(?P<environment>begin|end)\s*\{(?P<name>[A-Za-z]+\*?)\}(?:(?<=begin\{array\})\s*\{[lcr|\s]*\})?
    | (?P<newline>\\\\(?:\s*\[[0-9.]+(?:pt|ex|em|mm)\])?)
    | \\(?P<function>(?:arc|a)tan2)(?=\s*(?:\\left)?\()
    | \\(?P<command>[A-Za-z]+|[^A-Za-z])
    | (?P<number>[0-9]+(?:\.[0-9]+)?)
    | (?P<letters>(?:arc|a)tan2(?![A-Za-z0-9])|[A-Za-z]+)
    | (?P<assign>:=)
    | (?P<character>.)""",
    re.VERBOSE | re.DOTALL,
)
