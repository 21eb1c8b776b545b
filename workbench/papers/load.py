"""From paper files to a Paper: keys checked, every formula read, each fault a PaperError with its place."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

from workbench.budget import Budget
from workbench.judge.theorems.goals import GoalError, Scope, atoms, bound_integers, read_goal
from workbench.language.errors import IllFormedAt, ReadError
from workbench.language.lines import Line, split_lines
from workbench.language.printer import to_latex
from workbench.language.reader import read_formula
from workbench.language.terms import Conjunction, Statement
from workbench.papers.formulas import WORDS, FormulaReader
from workbench.papers.installed import DEFAULT, installed, installed_names, paper_of
from workbench.papers.mends import MEND_KEYS, fault_of, mend_of
from workbench.papers.model import (
    CITATION_KEYS,
    Claim,
    Formula,
    Notation,
    Paper,
    PaperError,
    Stated,
    Theorem,
    UnreadFormula,
)
from workbench.papers.motion import require_claims
from workbench.papers.notation import NOTATION_KEYS, notation_chain, notation_of
from workbench.papers.orders import Orders
from workbench.papers.sisters import claim_ids, sisters_of
from workbench.papers.text_load import load_model, load_text
from workbench.papers.texts import is_text
from workbench.papers.toml_file import TomlFile
from workbench.papers.toml_places import KeyPath

_PAPER_KEYS = (*NOTATION_KEYS, "citation", "section", "claim")
_FORMULA_KEYS = ("printed", "formula", "goal", "reading", "corrected", "hypothesis", "assume", "orders")
_CLAIM_KEYS = (
    *("id", "equation", "section", *_FORMULA_KEYS, "inherits"),
    *("statement", "theorem", "argued", *MEND_KEYS, "note"),
)
_ID = re.compile(r"[\w.+*'-]{1,80}")
_NO_FILES = "the installed paper has no claim files"
_HYPOTHESIS = re.compile(r"\\hypothesis\s*\\Rightarrow")
_QUOTE = re.compile(r"“[^“”]+”")
_CONTRADICTIONS = (
    ("theorem", "reading"),
    ("theorem", "assume"),
    ("goal", "reading"),
    ("goal", "formula"),
    ("goal", "argued"),
    ("corrected", "hypothesis"),
)


def load_paper(path: Path | str, faults: list[PaperError] | None = None) -> Paper:
    """The paper of one file: a paper file, a text, or the model beside one. Raises PaperError, with line and
    column, if the file cannot be used. faults: where those of single claims are put, if not raised."""
    path = Path(path)
    if is_text(path):
        return load_text(path)
    toml = TomlFile(path)
    return load_model(toml) if "source" in toml.data else merge([path], faults=faults)


def load_notation(path: Path | str) -> Notation:
    """The notation of a paper file or a notation file, which need not have claims. Raises PaperError."""
    toml = TomlFile(Path(path))
    toml.allow_keys((), _PAPER_KEYS)
    return notation_of(notation_chain(toml))


@cache
def installed_notation(name: str = DEFAULT) -> Notation:
    """The notation of an installed paper as `load_installed` gives it, without reading the claims."""
    paper = installed(name)
    chains = (notation_chain(TomlFile(path)) for path in paper.files)
    first = next(chains, None)
    if first is None:
        raise PaperError(name, None, None, _NO_FILES)
    if len(paper.files) == 1 or len(first) > 1:
        return notation_of(first if len(paper.files) == 1 else first[:-1])
    return notation_of(next((chain[:-1] for chain in chains if len(chain) > 1), first))


@cache
def load_installed(name: str) -> Paper:
    """The installed paper of that name, its files merged in order. Raises PaperError if there is none."""
    paper = installed(name)
    if not paper.files:
        raise PaperError(name, None, None, _NO_FILES)
    if len(paper.files) == 1 and "source" in TomlFile(paper.files[0]).data:
        return load_paper(paper.files[0])
    return merge(paper.files, paper.theorems)


def find_paper(name: Path | str | None = None) -> Paper:
    """The paper of the file `name`, or the installed paper of that name. Raises PaperError."""
    if name is None:
        return load_installed(DEFAULT)
    if str(name) in installed_names() and not Path(name).is_file():
        return load_installed(str(name))
    path = Path(name)
    if path.exists() or path.suffix == ".toml" or is_text(path) or path.name != str(name):
        return load_paper(path)
    return load_installed(str(name))


def merge(
    paths: Sequence[Path],
    theorems: Mapping[str, Theorem] | None = None,
    faults: list[PaperError] | None = None,
) -> Paper:
    """One paper of several files, in their order; ids are unique over all. Each file keeps its own notation.

    theorems: name → proof; if None, those of the installed paper that the first file is part of.
    faults: where those of single claims are put, which are left out then; if None, the first is raised.
    """
    shared_notations: dict[tuple[Path, ...], Notation] = {}
    files = [_PaperFile.open(Path(path), shared_notations) for path in paths]
    if theorems is None:
        needed = any("theorem" in claim for file in files for claim in file.claims)
        theorems = paper_of(files[0].toml.path).theorems if needed else {}
    claims: list[Claim] = []
    owners: dict[str, str] = {}
    skipped: list[str] = []
    for file in files:
        for index in range(len(file.claims)):
            try:
                claims += _ClaimReader(file, ("claim", index), owners, theorems).claims()
            except UnreadFormula as error:
                if faults is None:
                    raise
                faults.append(error)
                if isinstance(name := file.claims[index].get("id"), str):
                    skipped.append(name)
        require_claims(file.toml, owners)
    if faults and not claims:
        raise faults[0]
    parts: dict[str, list[str]] = {name: [] for name in skipped}
    for claim in claims:
        parts.setdefault(owners[claim.id], []).append(claim.id)
        parts.setdefault(claim.id, [claim.id])
    named = [name for claim in claims for name in (*claim.inherits, claim.mend.by) if name is not None]
    if any(name not in parts for name in named):
        sisters = list(dict.fromkeys(path for file in files for path in sisters_of(file.toml.path)))
        parts = claim_ids(sisters) | parts
        for file in files:
            file.check_inheritance(parts, sisters)
    claims = [
        replace(claim, inherits=tuple(part for name in claim.inherits for part in parts[name]))
        for claim in claims
    ]
    first = files[0]
    shared = (file.shared_notation for file in files if file.shared_notation is not None)
    notation = first.notation if len(files) == 1 else next(shared, first.notation)
    budget = next((file.budget for file in files if file.budget is not None), None)
    citation = {
        key: text for file in files for key in CITATION_KEYS if (text := file.toml.text(("citation", key)))
    }
    return Paper(
        first.title,
        first.doi,
        tuple(paths),
        notation,
        tuple(claims),
        dict(theorems),
        budget,
        citation,
        faults=tuple(faults or ()),
    )


@dataclass
class _PaperFile:
    """One file with the notation that it stands on."""

    toml: TomlFile
    title: str
    doi: str | None
    section: str | None
    notation: Notation
    shared_notation: Notation | None
    budget: Budget | None
    claims: list[dict[str, Any]] = field(default_factory=list)

    @staticmethod
    def open(path: Path, known: dict[tuple[Path, ...], Notation]) -> _PaperFile:
        """`known`: the notations of the files that others stand on, read once for all of them."""
        toml = TomlFile(path)
        toml.allow_keys((), _PAPER_KEYS)
        claims = toml.value(("claim",), list, [])
        if not claims:
            raise PaperError(path, 1, 1, "no claims; expected at least one [[claim]]")
        for index, claim in enumerate(claims):
            if not isinstance(claim, dict):
                raise toml.error_at_value(("claim", index), "claim: expected tables, written [[claim]]")
        toml.allow_keys(("citation",), CITATION_KEYS)
        chain = notation_chain(toml)
        title = next((found for file in reversed(chain) if (found := file.text(("title",)))), None)
        if title is None:
            raise PaperError(path, 1, 1, "missing key 'title'")
        doi = next((found for file in reversed(chain) if (found := file.text(("doi",)))), None)
        below = tuple(file.path for file in chain[:-1])
        if below and below not in known:
            known[below] = notation_of(chain[:-1])
        budget = next((found for file in reversed(chain) if (found := _budget(file))), None)
        section, notation = toml.text(("section",)), notation_of(chain)
        return _PaperFile(toml, title, doi, section, notation, known.get(below), budget, claims)

    def check_inheritance(self, known: Mapping[str, object], sisters: Sequence[Path]) -> None:
        elsewhere = f", here or in {', '.join(path.name for path in sisters)}" if sisters else ""
        for index, claim in enumerate(self.claims):
            for place, name in enumerate(claim.get("inherits", [])):
                if name not in known:
                    path = ("claim", index, "inherits", place)
                    raise self.toml.error_at_value(path, f"inherits: no claim has the id {name!r}{elsewhere}")
            by = claim.get("mended_by")
            if by is not None and by not in known:
                path = ("claim", index, "mended_by")
                raise self.toml.error_at_value(path, f"mended_by: no claim has the id {by!r}{elsewhere}")


def _budget(file: TomlFile) -> Budget | None:
    """What the file says of time and memory for each judgement."""
    given = file.value(("budget",), dict, None)
    if given is None:
        return None
    file.allow_keys(("budget",), ("seconds", "megabytes"))
    for name, value in given.items():
        try:
            Budget(**{name: value})
        except ValueError as error:
            raise file.error_at_value(("budget", name), f"budget: {error}") from None
    return Budget(**given)


def _parts(statement: Statement) -> Sequence[Statement]:
    return statement.parts if isinstance(statement, Conjunction) else ()


@dataclass
class _ClaimReader:
    """Reads the claim table at `path`. `owners`: id → id of the table it comes from, of all claims so far."""

    file: _PaperFile
    path: KeyPath
    owners: dict[str, str]
    theorems: Mapping[str, Theorem]

    def claims(self) -> list[Claim]:
        toml = self.file.toml
        toml.allow_keys(self.path, _CLAIM_KEYS)
        name = self._required("id")
        if _ID.fullmatch(name) is None:
            message = f"id: expected letters, digits and . _ - + * ' without blanks, got {name!r}"
            raise toml.error_at_value((*self.path, "id"), message)
        self._refuse_contradictions()
        printed, quote = self._printed()
        formula = self._text("formula")
        claim = Claim(
            id=name,
            printed=Formula(printed or formula or ""),
            ours=not printed and formula is not None,
            quote=quote,
            fault=fault_of(toml, self.path),
            mend=mend_of(toml, self.path, printed or quote or formula or ""),
            argued=self._text("argued"),
            notation=self.file.notation,
            equation=self._text("equation"),
            section=self._text("section") or self.file.section,
            orders=self._orders(),
            note=toml.value((*self.path, "note"), str, ""),
            inherits=toml.texts((*self.path, "inherits")),
            statement=self._text("statement"),
            theorem=self._text("theorem"),
            file=toml.path,
            line=toml.places.of_key(self.path)[0],
        )
        special = claim.theorem is not None or self._text("goal") is not None
        claims = [self._theorem(claim)] if special else self._lines(claim)
        for part in claims:
            if part.id in self.owners:
                raise toml.error_at_value((*self.path, "id"), f"id {part.id!r} is used twice")
            self.owners[part.id] = name
        return claims

    def _printed(self) -> tuple[str | None, str | None]:
        """What is printed: a formula, or a sentence, which stands in quotation marks “ ”."""
        text = self._text("printed")
        if text is None or not text.startswith("“"):
            if text is not None and self._text("formula") is not None:
                message = (
                    "formula: ours stands for a printed sentence; beside a printed formula it has no use"
                )
                raise self.file.toml.error_at_key((*self.path, "formula"), message)
            return text, None
        if _QUOTE.fullmatch(text) is None:
            raise self.file.toml.error_at_value(
                (*self.path, "printed"), "printed: expected one sentence, “…”"
            )
        return None, text

    def _theorem(self, claim: Claim) -> Claim:
        self._required("statement")
        if claim.theorem is not None and claim.theorem not in self.theorems:
            known = ", ".join(sorted(self.theorems)) or "none is installed for this file"
            message = f"theorem: no proof called {claim.theorem!r} (known: {known})"
            raise self.file.toml.error_at_value((*self.path, "theorem"), message)
        reader = self._reader(claim)
        goal = self._goal(claim)
        printed = self._said(
            claim, set(claim.orders.variables if claim.orders else ()) | bound_integers(goal and goal.goal)
        )
        if goal is not None:
            self._refuse_other_goal(goal, printed)
        elif claim.theorem is not None and claim.argued is None:
            message = "a theorem needs a goal, or else `argued`: why no rule ties its steps to one"
            raise self.file.toml.error_at_key((*self.path, "theorem"), message)
        return replace(
            claim,
            goal=goal,
            said=() if goal else tuple(printed),
            corrected=reader.intended("corrected"),
            hypothesis=self._condition(reader, goal),
            assume=reader.intended_list("assume"),
        )

    def _said(self, claim: Claim, integers: Collection[str]) -> list[Statement]:
        """What is printed beside a goal or an argument, which must make sense."""
        try:
            lines = split_lines(claim.printed.latex) if claim.printed.latex else ()
            table = self.file.notation.symbols
            return [s for line in lines for s in read_formula(line.latex, table, integers).statements]
        except (ReadError, IllFormedAt) as error:
            raise self.file.toml.error_at_value((*self.path, "printed"), f"printed: {error}") from None

    def _goal(self, claim: Claim) -> Stated | None:
        text = self._text("goal")
        if text is None:
            return None
        scope = Scope(self.file.notation.symbols, self.file.notation.definitions, {})
        hypothesis = self._text("hypothesis")
        if (hypothesis is None) != (_HYPOTHESIS.search(text) is None):
            message = (
                "goal: expected `\\hypothesis \\Rightarrow` in it if there is a hypothesis, and only then"
            )
            raise self.file.toml.error_at_value((*self.path, "goal"), message)
        said = text.replace("\\printed", claim.printed.latex)
        try:
            bare = read_goal(_HYPOTHESIS.sub("", said), scope)
            return Stated(text, read_goal(said.replace("\\hypothesis", hypothesis or ""), scope), bare)
        except (GoalError, ReadError, IllFormedAt) as error:
            raise self.file.toml.error_at_value((*self.path, "goal"), f"goal: {error}") from None

    def _refuse_other_goal(self, goal: Stated, said: Sequence[Statement]) -> None:
        """What is printed must be a part of the goal: else the goal could be another one."""
        parts = [part for statement in atoms(goal.goal) for part in (statement, *_parts(statement))]
        for statement in said:
            if statement not in parts:
                message = f"goal: the printed formula {to_latex(statement)} is no part of it"
                raise self.file.toml.error_at_value((*self.path, "goal"), message)

    def _condition(self, reader: FormulaReader, goal: Stated | None) -> Formula | None:
        """The hypothesis: read within its goal; of an argument, a formula or words, \\text{…}."""
        text = self._text("hypothesis")
        if text is not None and (goal is not None or WORDS.fullmatch(text)):
            return Formula(text)
        return reader.intended("hypothesis")

    def _lines(self, claim: Claim) -> list[Claim]:
        """The claim, or one claim for each line of its printed formula."""
        if not claim.printed.latex:
            self._required("formula" if claim.quote is not None else "printed")
        lines = split_lines(claim.printed.latex)
        readings = self._matching("reading", lines)
        corrections = self._matching("corrected", lines)
        claims = []
        for number, line in enumerate(lines):
            printed, reader = self._reader(claim).printed(line, excused=readings is not None)
            reading = None
            if readings is not None:
                reading, reader = reader.reading(readings[number])
            claims.append(
                replace(
                    claim,
                    id=claim.id if len(lines) == 1 else f"{claim.id}.{number + 1}",
                    printed=printed,
                    reading=reading,
                    corrected=corrections and reader.intended("corrected", corrections[number]),
                    hypothesis=reader.intended("hypothesis"),
                    assume=reader.intended_list("assume"),
                    orders=reader.orders,
                )
            )
        return claims

    def _matching(self, key: str, lines: Sequence[Line]) -> list[Line] | None:
        text = self._text(key)
        if text is None:
            return None
        found = split_lines(text)
        if len(found) != len(lines):
            message = f"{key}: expected {len(lines)} lines, as printed has, got {len(found)}"
            raise self.file.toml.error_at_value((*self.path, key), message)
        return found

    def _reader(self, claim: Claim) -> FormulaReader:
        return FormulaReader(self.file.toml, self.path, self.file.notation, claim.orders)

    def _orders(self) -> Orders | None:
        text = self._text("orders")
        try:
            return None if text is None else Orders.parse(text)
        except ValueError as error:
            raise self.file.toml.error_at_value((*self.path, "orders"), str(error)) from None

    def _refuse_contradictions(self) -> None:
        table = self.file.toml.value(self.path, dict)
        for one, other in _CONTRADICTIONS:
            if one in table and other in table and not ("goal" in table and other == "assume"):
                message = f"{other!r} and {one!r} exclude each other"
                raise self.file.toml.error_at_key((*self.path, other), message)

    def _text(self, key: str) -> str | None:
        return self.file.toml.text((*self.path, key))

    def _required(self, key: str) -> str:
        text = self._text(key)
        if text is None:
            raise self.file.toml.error_at_key(self.path, f"missing key {key!r}")
        return text
