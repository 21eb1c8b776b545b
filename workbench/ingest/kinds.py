"""What a symbol is likely to be: by its typeface, by words near its first use, by what makes formulas fit."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from workbench.language.errors import IllFormedAt, ReadError, SpecError
from workbench.language.reader import read
from workbench.language.symbols import SymbolTable
from workbench.language.terms import Statement

_UNKNOWN = re.compile(r"unknown symbol (.+?)(?:; known and close: .*)?$", re.DOTALL)
_OPERATION = re.compile(r"(?:\^\{(?:T|-?\d+|\(\d+\)|\*|-T|\\top|-1)\}|'+)$")
_BOLD = re.compile(r"\\(?:mathbf|boldsymbol|mathsf|underline|vec|overline|bar)\{?(\\?[A-Za-z]+)")
_GREEK_CAPITALS = re.compile("Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Upsilon|Phi|Psi|Omega")
_VECTORS = frozenset({"\\omega", "\\alpha"})
_WORDS = (
    (
        re.compile(r"rotation(?:al)? matri|orthogonal (?:matri|tensor)|rotation tensor|direction cosine"),
        "rotation",
    ),
    (re.compile(r"unit vector"), "unit vector"),
    (re.compile(r"\bvectors?\b|velocit|position\b|displacement"), "vector"),
    (re.compile(r"\btensors?\b|\bmatri(?:x|ces)\b"), "tensor"),
    (re.compile(r"\bscalars?\b|\bangles?\b|\bmass\b|\bcoordinates?\b|\blength\b|\bdistance\b"), "scalar"),
)
_NEAR = 40
#: More symbols than these in a text are tried in turn no further.
MOST_TRIED = 150
_ROUNDS = 2
KINDS = ("scalar", "vector", "tensor")


@dataclass(frozen=True)
class Guess:
    """`why`: what it rests on."""

    name: str
    kind: str
    why: str
    unit: bool = False

    @property
    def spec(self) -> dict[str, object]:
        return {"kind": self.kind, "unit": True} if self.unit else {"kind": self.kind}


@dataclass
class Outcome:
    """What came of reading one formula: statements, or a message, and whether its types do not fit."""

    statements: tuple[Statement, ...] | None = None
    message: str = ""
    ill_formed: bool = False
    symbols: set[str] = field(default_factory=set)


class Guesser:
    """Reads formulas with guessed symbols, declaring each when it is met."""

    def __init__(self, prose: str) -> None:
        self.prose = prose
        self.guesses: dict[str, Guess] = {}
        self.refused: dict[str, str] = {}

    def table(self) -> SymbolTable:
        return SymbolTable.build({guess.name: guess.spec for guess in self.guesses.values()})

    def read_all(self, formulas: Sequence[str]) -> list[Outcome]:
        """Declares what the formulas need; each is read with all the symbols of those before it."""
        table = SymbolTable()
        outcomes = []
        for latex in formulas:
            outcome, table = self._read(latex, table)
            outcomes.append(outcome)
        return outcomes

    def improve(self, formulas: Sequence[str], outcomes: Sequence[Outcome]) -> None:
        """Another kind where more formulas then fit: type errors tell what typeface did not."""
        users: dict[str, list[str]] = {}
        for latex, outcome in zip(formulas, outcomes, strict=True):
            for name in outcome.symbols if outcome.statements is not None or outcome.ill_formed else ():
                users.setdefault(name, []).append(latex)
        for _ in range(_ROUNDS):
            changed = False
            for name in list(self.guesses)[:MOST_TRIED]:
                changed |= self._improve(name, users.get(name, ()))
            if not changed:
                return

    def _improve(self, name: str, users: Sequence[str]) -> bool:
        guess = self.guesses[name]
        best, kind = _fitting(self.table(), users), guess.kind
        if best == len(users):
            return False
        for other in KINDS:
            if other == guess.kind:
                continue
            specs = {each.name: each.spec for each in self.guesses.values()} | {name: {"kind": other}}
            try:
                fitting = _fitting(SymbolTable.build(specs), users)
            except SpecError:
                continue
            if fitting > best:
                best, kind = fitting, other
        if kind == guess.kind:
            return False
        why = f"{best} of {len(users)} formulas with it fit then"
        self.guesses[name] = replace(guess, kind=kind, why=why, unit=False)
        return True

    def _read(self, latex: str, table: SymbolTable) -> tuple[Outcome, SymbolTable]:
        symbols: set[str] = set()
        for _ in range(60):
            try:
                return Outcome(read(latex, table), symbols=symbols | _known(latex, table)), table
            except IllFormedAt as error:
                outcome = Outcome(message=error.message, ill_formed=True)
                outcome.symbols = symbols | _known(latex, table)
                return outcome, table
            except ReadError as error:
                unknown = _UNKNOWN.search(error.message)
                if unknown is None:
                    return Outcome(message=error.message), table
                name = bare_name(unknown[1])
                if name in self.refused:
                    return Outcome(message=self.refused[name]), table
                guess = self.guesses.get(name) or self._guess(name)
                try:
                    table = table.with_specs({name: guess.spec})
                    self.guesses[name] = guess
                    symbols.add(name)
                except (
                    SpecError,
                    ReadError,
                ) as refused:  # also of a name that is declared, and unknown still
                    if name not in self.guesses:
                        self.refused[name] = str(refused)
                    return Outcome(message=error.message), table
        return Outcome(message="more symbols than a formula can have"), table

    def _guess(self, name: str) -> Guess:
        for pattern, kind in _WORDS:
            if (where := self._near(name, pattern)) is not None:
                plain = kind.removeprefix("unit ")
                return Guess(name, plain, f'the text says "{where}" near it', unit=plain != kind)
        return _by_typeface(name)

    def _near(self, name: str, pattern: re.Pattern[str]) -> str | None:
        """The words beside the first formula in the text that is the symbol alone."""
        spelled = re.escape(re.sub(r"[\s{}]", "", name))
        for match in re.finditer(r"\$([^$\n]{1,40})\$|:math:`([^`\n]{1,40})`", self.prose):
            if not re.fullmatch(spelled, re.sub(r"[\s{}]", "", match[1] or match[2])):
                continue
            before = self.prose[max(0, match.start() - _NEAR) : match.start()]
            after = self.prose[match.end() : match.end() + _NEAR]
            before, after = re.split(r"[.;$]", before)[-1], re.split(r"[.;,$]", after)[0]
            if found := pattern.search(f"{before} {after}".lower()):
                return " ".join(found[0].split())
        return None


def bare_name(name: str) -> str:
    """Without powers, transposes and primes, which the reader takes for operations."""
    while (shorter := _OPERATION.sub("", name)) != name:
        name = shorter
    return name


def _by_typeface(name: str) -> Guess:
    bold = _BOLD.match(name.removeprefix("{}").lstrip("_^"))
    letter = (bold[1] if bold else re.sub(r"^(?:\{\}[_^]\{[^}]*\})+", "", name)).lstrip("\\")
    letter = re.match(r"[A-Za-z]+", letter)[0] if re.match(r"[A-Za-z]", letter) else ""
    is_capital = bool(_GREEK_CAPITALS.fullmatch(letter)) or (len(letter) == 1 and letter.isupper())
    if bold is not None:
        if is_capital:
            return Guess(name, "rotation" if letter == "R" else "tensor", "a bold capital letter")
        return Guess(name, "vector", "a bold or marked letter")
    if f"\\{letter}" in _VECTORS:
        return Guess(name, "vector", "what mechanics calls so")
    if is_capital:
        return Guess(name, "tensor", "a capital letter")
    return Guess(name, "scalar", "a letter in italics")


def _known(latex: str, table: SymbolTable) -> set[str]:
    """The declared names that the formula may use: by their letters."""
    flat = re.sub(r"[\s{}]", "", latex)
    return {name for name in table.symbols if _core(name) in flat}


def _core(name: str) -> str:
    return re.sub(r"[\s{}@]", "", name)


def _fitting(table: SymbolTable, formulas: Iterable[str]) -> int:
    count = 0
    for latex in formulas:
        try:
            read(latex, table)
            count += 1
        except (IllFormedAt, ReadError):
            continue
    return count


def specs_of(guesses: Mapping[str, Guess]) -> dict[str, dict[str, object]]:
    return {guess.name: guess.spec for guess in guesses.values()}
