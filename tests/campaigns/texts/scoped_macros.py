"""Macros of a text, with TeX's groups: which letter an alias stands for where, and formulas written by macros."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from formula_trees import ATOM, PRODUCT, Node, Spelling, Writer

#: Macros with arguments: definition, operation, what it prints.
SHORTHANDS = {
    "dot": (
        r"\newcommand{\inner}[2]{\left( #1 \cdot #2 \right)}",
        r"\inner{{{}}}{{{}}}",
        r"\left( {} \cdot {} \right)",
    ),
    "transpose": (r"\newcommand{\tp}[1]{#1^T}", r"\tp{{{}}}", "{}^T"),
    "norm2": (r"\newcommand{\nrm}[2][2]{\|#2\|^{#1}}", r"\nrm{{{}}}", r"\|{}\|^2"),
    "over": (r"\newcommand{\quot}[2]{\frac{#1}{#2}}", r"\quot{{{}}}{{{}}}", r"\frac{{{}}}{{{}}}"),
    "ddt": (r"\newcommand{\rate}[1]{\frac{d}{dt}(#1)}", r"\rate{{{}}}", r"\frac{{d}}{{dt}}({})"),
    "trace": (r"\DeclareMathOperator{\tr}{tr}", r"\tr({})", r"\operatorname{{tr}}({})"),
}
ALIASES = {"scalar": (r"\sa", r"\sb"), "vector": (r"\va", r"\vb"), "matrix": (r"\ma",)}
LETTERS = {"scalar": "fghk", "vector": "abcd", "matrix": "AST"}
#: Letters in a text with frames.
FRAMED = {"vector": "xy"}


@dataclass
class Macros:
    """The aliases in force. used: how often a letter with an alias, or an operation, is written by it."""

    random: Random
    letters: dict[str, str] = field(default_factory=lambda: LETTERS)
    used: float = 0.4
    shorthands: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        self._saved: list[dict[str, str]] = [{}]

    @property
    def in_force(self) -> dict[str, str]:
        return self._saved[-1]

    def preamble(self, tex: bool = True) -> list[str]:
        """The definitions of all macros, which are then in force."""
        lines = []
        for kind, letters in self.letters.items():
            for alias in ALIASES[kind]:
                letter = self.random.choice(letters)
                self.in_force[alias] = letter
                lines.append(rf"\newcommand{{{alias}}}{{{letter}}}")
        self.shorthands = frozenset(
            each for each in SHORTHANDS if self.random.random() < 0.6 and (tex or each != "trace")
        )
        return [*lines, *(SHORTHANDS[each][0] for each in sorted(self.shorthands))]

    def open(self) -> None:
        """A group begins."""
        self._saved.append(dict(self.in_force))

    def close(self) -> None:
        """A group ends, and what was defined in it."""
        self._saved.pop()

    def another(self) -> tuple[str, str]:
        """An alias and a letter of its kind that it does not stand for."""
        alias = self.random.choice(sorted(self.in_force))
        kind = next(kind for kind, names in ALIASES.items() if alias in names)
        return alias, self.random.choice(
            [each for each in self.letters[kind] if each != self.in_force[alias]]
        )

    def redefined(self, everywhere: bool = False) -> str:
        """A declaration that gives an alias another letter."""
        alias, letter = self.another()
        twin = next((name for name, stands in self.in_force.items() if stands == letter), None)
        for names in self._saved if everywhere else [self.in_force]:
            names[alias] = letter
        if everywhere:
            return rf"\gdef{alias}{{{letter}}}"
        ways = [rf"\renewcommand{{{alias}}}{{{letter}}}", rf"\def{alias}{{{letter}}}"]
        if twin is not None:
            ways += [rf"\let{alias}={twin}", rf"\edef{alias}{{{twin}}}", rf"\def{alias}{{{letter}}}"]
        return self.random.choice(ways)

    def custom(self, node: Node, writer: Writer) -> Spelling | None:
        """A node written by a macro, or None."""
        if self.random.random() > self.used:
            return None
        if node.kind == "letter":
            names = [alias for alias, letter in self.in_force.items() if letter == node.name]
            return Spelling(self.random.choice(names) + " ", node.name) if names else None
        if node.op not in self.shorthands:
            return None
        _, source, plain = SHORTHANDS[node.op]
        strength = {"dot": PRODUCT, "transpose": ATOM}.get(node.op)
        args = [
            writer.write(each) if strength is None else writer.within(each, strength) for each in node.args
        ]
        return Spelling(source.format(*(x.source for x in args)), plain.format(*(x.plain for x in args)))
