"""Names of symbols: a letter with its styles, and scripts that contain index slots."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from workbench.core.integer_expressions import Linear

#: A script is the tuple of texts around its index slots: ("", ",", "") for two indices, ("rel",) for none, ()
#: for no script.
Script = tuple[str, ...]

#: The fields that are scripts, in the order in which their indices count.
SCRIPTS = ("left_sub", "left_sup", "sub", "sup")

#: Prefixes that form a new symbol with the letter after them, if that is declared: \Delta t.
PREFIXES = ("\\Delta", "\\delta")

#: Prefix with a subscript: \\nabla_{x,y} f is one symbol if it is declared.
NABLA = "\\nabla"

_OUTERMOST_FIRST = (
    *PREFIXES,
    "\\underline",
    "\\overline",
    "\\bar",
    "\\vec",
    "\\hat",
    "\\check",
    "\\breve",
    "\\mathring",
    "\\tilde",
)

#: Marks over a letter, or over two letters that are one name: \\vec{AB}.
ACCENTS = frozenset(_OUTERMOST_FIRST).difference(PREFIXES)


def is_prefix(style: str) -> bool:
    """True if the style is a prefix that forms a new symbol: \\Delta, or \\nabla with a subscript."""
    return style in PREFIXES or style.startswith(f"{NABLA}_")


@dataclass(frozen=True, slots=True, repr=False)
class Name:
    """The identity of a symbol.

    letter: LaTeX, without fonts and accents.   styles: fonts and accents, outermost first (`Name.styled`
    sorts).
    parameters: the number of arguments; f(x) and f are different symbols.
    of: the terms that the symbol is built from, if it stands for such a construction; equal terms give equal
    names.
    """

    letter: str
    styles: tuple[str, ...] = ()
    primes: int = 0
    left_sub: Script = ()
    left_sup: Script = ()
    sub: Script = ()
    sup: Script = ()
    parameters: int = 0
    of: tuple[Any, ...] = ()

    @staticmethod
    def styled(styles: Iterable[str], letter: str) -> Name:
        """Returns a name with sorted styles: \\underline outermost, the font next to the letter."""
        order = {style: place for place, style in enumerate(_OUTERMOST_FIRST)}
        places = {style: -1 if is_prefix(style) else order.get(style, len(order)) for style in styles}
        return Name(letter, tuple(sorted(places, key=lambda style: (places[style], style))))

    @property
    def base(self) -> str:
        """Returns the letter in its styles, as LaTeX."""
        return f"{''.join(f'{style}{{' for style in self.styles)}{self.letter}{'}' * len(self.styles)}"

    @property
    def scripts(self) -> tuple[Script, ...]:
        return tuple(getattr(self, field) for field in SCRIPTS)

    @property
    def indices(self) -> int:
        return sum(len(script) - 1 for script in self.scripts if script)

    def latex(self, index: Sequence[object], accents: Sequence[str] = ()) -> str:
        """Returns the LaTeX of the name with these indices; the accents (outermost first) go over the letter
        only."""
        places = iter(index)
        left_sub, left_sup, sub, sup = (
            "" if not script else sign + "{" + "".join(_filled(script, places)) + "}"
            for sign, script in zip("_^_^", self.scripts, strict=True)
        )
        letter = self.base + "'" * self.primes
        for accent in reversed(accents):
            letter = f"{accent}{{{letter}}}"
        left = "{}" if left_sub or left_sup else ""
        return f"{left}{left_sub}{left_sup}{letter}{sub}{sup}"

    def at(self, index: Sequence[Linear]) -> Name:
        """Returns the name with these integers in its index slots."""
        places = iter(index)
        given = zip(SCRIPTS, self.scripts, strict=True)
        filled: dict[str, Any] = {field: ("".join(_filled(s, places)),) for field, s in given if s}
        return replace(self, **filled)

    def index_of(self, other: Name) -> tuple[Linear, ...] | None:
        """Returns the indices of `other` in this family: 1 for Φ_1 in Φ_n; None if it is not a member."""
        if not self.indices or self.without_scripts() != other.without_scripts():
            return None
        found: list[str] = []
        for own, its in zip(self.scripts, other.scripts, strict=True):
            match = (
                re.fullmatch("(0|[1-9][0-9]*)".join(map(re.escape, own)), its[0])
                if own and len(its) == 1
                else None
            )
            if match is None and (own or its):
                return None
            found += match.groups() if match is not None else ()
        return tuple(Linear(int(number)) for number in found)

    def without_scripts(self) -> Name:
        bare: dict[str, Any] = dict.fromkeys(SCRIPTS, ())
        return replace(self, **bare)

    def without_arguments(self) -> Name:
        return replace(self, parameters=0)

    def shown(self, index: Sequence[object]) -> str:
        """Returns the LaTeX with these indices; a function shows a \\cdot for each of its arguments."""
        arguments = ",".join(["\\cdot"] * self.parameters)
        return self.latex(index) + (f"({arguments})" if arguments else "")

    def __str__(self) -> str:
        return self.shown("n" * self.indices)

    def __repr__(self) -> str:
        return repr(str(self)) if not self.of else repr((str(self), self.of))


def _filled(script: Script, places: Any) -> Iterable[str]:
    yield script[0]
    for text in script[1:]:
        yield f"{next(places)}{text}"
