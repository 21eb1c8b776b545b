"""LaTeX texts with their precedence."""

from __future__ import annotations

import re
from dataclasses import dataclass

#: Precedence levels.
SUM, INFIX, PRODUCT, FACTOR, ATOM = range(5)
#: A sum of single letters and numbers.
_INDEX = re.compile(r"-?\s*\w+(?:\s*[+-]\s*\w+)*")


@dataclass(frozen=True, slots=True)
class Text:
    """LaTeX with its precedence level and the way in which it is open at its end.

    end: "function" (det A, which would take the next tensor), "sum" (Σ …, which takes everything that
    follows), "symbol" (which may take a bracket as its arguments), or "".
    """

    text: str
    level: int
    end: str = ""

    def at_least(self, level: int) -> str:
        return self.text if self.level >= level else bracket(self.text)


def bracket(text: str) -> str:
    return f"\\left({text}\\right)"


def square(text: str) -> str:
    """Returns the text with its first bracket made square.

    After a symbol a round bracket may be its arguments. So may a square one with an index, which is therefore
    put in braces.
    """
    if not text.startswith("\\left("):
        return text
    depth = 0
    for match in re.finditer(r"\\(left|right)(?![a-z])", text):
        depth += 1 if match[1] == "left" else -1
        if depth == 0:
            inside, after = text[6 : match.start()], text[match.end() + 1 :]
            inside = f"{{{inside}}}" if _INDEX.fullmatch(inside) else inside
            return f"\\left[{inside}\\right]{after}"
    raise ValueError(f"unbalanced brackets in {text}")
