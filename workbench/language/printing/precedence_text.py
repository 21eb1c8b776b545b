"""LaTeX texts with their precedence."""

from __future__ import annotations

import re
from dataclasses import dataclass

from workbench.core.brackets import end_of_group

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
    sides = list(re.finditer(r"\\(left|right)(?![a-z])", text))
    last = end_of_group((match[1] for match in sides), ("left",), ("right",))
    if last is None:
        raise ValueError(f"unbalanced brackets in {text}")
    closing = sides[last - 1]
    inside, after = text[6 : closing.start()], text[closing.end() + 1 :]
    inside = f"{{{inside}}}" if _INDEX.fullmatch(inside) else inside
    return f"\\left[{inside}\\right]{after}"
