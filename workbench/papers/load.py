"""From paper files to a Paper: keys checked, every formula read, each fault a PaperError with its place."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbench.papers.formulas import FormulaReader
from workbench.papers.installed import DEFAULT, installed, installed_names, paper_of
from workbench.papers.lines import Line, split_lines
from workbench.papers.model import Claim, Formula, Notation, Paper, PaperError
from workbench.papers.notation import notation_of
from workbench.papers.orders import Orders
from workbench.papers.sisters import claim_ids, sisters_of
from workbench.papers.toml_file import TomlFile
from workbench.papers.toml_places import KeyPath

if TYPE_CHECKING:
    from workbench.judge.verdict import Verdict

_NOTATION_KEYS = ("title", "doi", "notation", "symbols", "definitions", "motion")
_PAPER_KEYS = (*_NOTATION_KEYS, "section", "claim")
_FORMULA_KEYS = ("printed", "reading", "corrected", "hypothesis", "assume", "orders")
_CLAIM_KEYS = ("id", "equation", "section", *_FORMULA_KEYS, "inherits", "statement", "theorem", "note")
_ID = re.compile(r"[\w.+*'-]{1,80}")
_WORDS = re.compile(r"\\text\{[^{}\\]+\}")
_CONTRADICTIONS = (
    ("theorem", "reading"),
    ("theorem", "assume"),
    ("corrected", "hypothesis"),
)


def load_paper(path: Path | str) -> Paper:
    """The paper of one file. Raises PaperError, with line and column, if the file cannot be used."""
    return merge([Path(path)])


def load_notation(path: Path | str) -> Notation:
    """The notation of a paper file or a notation file, which need not have claims. Raises PaperError."""
    toml = TomlFile(Path(path))
    toml.allow_keys((), _PAPER_KEYS)
    return notation_of(_notation_chain(toml))


@cache
def load_installed(name: str) -> Paper:
    """The installed paper of that name, its files merged in order. Raises PaperError if there is none."""
    paper = installed(name)
    if not paper.files:
        raise PaperError(name, None, None, "the installed paper has no claim files")
    return merge(paper.files, paper.theorems)


def find_paper(name: Path | str | None = None) -> Paper:
    """The paper of the file `name`, or the installed paper of that name. Raises PaperError."""
    if name is None:
        return load_installed(DEFAULT)
    if str(name) in installed_names() and not Path(name).is_file():
        return load_installed(str(name))
    path = Path(name)
    if path.exists() or path.suffix == ".toml" or path.name != str(name):
        return load_paper(path)
    return load_installed(str(name))


def merge(paths: Sequence[Path], theorems: Mapping[str, Callable[[], Verdict]] | None = None) -> Paper:
    """One paper of several files, in their order; ids are unique over all. Each file keeps its own notation.

    theorems: name → proof; if None, those of the installed paper that the first file is part of.
    """
    files = [_PaperFile.open(Path(path)) for path in paths]
    if theorems is None:
        needed = any("theorem" in claim for file in files for claim in file.claims)
        theorems = paper_of(files[0].toml.path).theorems if needed else {}
    claims: list[Claim] = []
    owners: dict[str, str] = {}
    for file in files:
        for index in range(len(file.claims)):
            claims += _ClaimReader(file, ("claim", index), owners, theorems).claims()
    parts: dict[str, list[str]] = {}
    for claim in claims:
        parts.setdefault(owners[claim.id], []).append(claim.id)
        parts.setdefault(claim.id, [claim.id])
    if any(name not in parts for claim in claims for name in claim.inherits):
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
    return Paper(first.title, first.doi, tuple(paths), notation, tuple(claims), dict(theorems))


@dataclass
class _PaperFile:
    """One file with the notation that it stands on."""

    toml: TomlFile
    title: str
    doi: str | None
    section: str | None
    notation: Notation
    shared_notation: Notation | None
    claims: list[dict[str, Any]] = field(default_factory=list)

    @staticmethod
    def open(path: Path) -> _PaperFile:
        toml = TomlFile(path)
        toml.allow_keys((), _PAPER_KEYS)
        claims = toml.value(("claim",), list, [])
        if not claims:
            raise PaperError(path, 1, 1, "no claims; expected at least one [[claim]]")
        for index, claim in enumerate(claims):
            if not isinstance(claim, dict):
                raise toml.error_at_value(("claim", index), "claim: expected tables, written [[claim]]")
        chain = _notation_chain(toml)
        title = next((found for file in reversed(chain) if (found := file.text(("title",)))), None)
        if title is None:
            raise PaperError(path, 1, 1, "missing key 'title'")
        doi = next((found for file in reversed(chain) if (found := file.text(("doi",)))), None)
        shared = notation_of(chain[:-1]) if len(chain) > 1 else None
        return _PaperFile(toml, title, doi, toml.text(("section",)), notation_of(chain), shared, claims)

    def check_inheritance(self, known: Mapping[str, object], sisters: Sequence[Path]) -> None:
        elsewhere = f", here or in {', '.join(path.name for path in sisters)}" if sisters else ""
        for index, claim in enumerate(self.claims):
            for place, name in enumerate(claim.get("inherits", [])):
                if name not in known:
                    path = ("claim", index, "inherits", place)
                    raise self.toml.error_at_value(path, f"inherits: no claim has the id {name!r}{elsewhere}")


def _notation_chain(file: TomlFile) -> list[TomlFile]:
    """The notation files that `file` stands on, the deepest first, and `file` itself."""
    chain = [file]
    while (name := chain[0].text(("notation",))) is not None:
        user = chain[0]
        path = user.path.parent / name
        if Path(name).name != name:
            raise user.error_at_value(("notation",), f"notation: expected a file beside this, got {name!r}")
        if any(path.resolve() == link.path.resolve() for link in chain):
            raise user.error_at_value(("notation",), f"notation: {name} refers back to itself")
        if not path.is_file():
            raise user.error_at_value(("notation",), f"notation: no file {name!r} beside this one")
        chain.insert(0, TomlFile(path))
        chain[0].allow_keys((), _NOTATION_KEYS)
    return chain


@dataclass
class _ClaimReader:
    """Reads the claim table at `path`. `owners`: id → id of the table it comes from, of all claims so far."""

    file: _PaperFile
    path: KeyPath
    owners: dict[str, str]
    theorems: Mapping[str, Callable[[], Verdict]]

    def claims(self) -> list[Claim]:
        toml = self.file.toml
        toml.allow_keys(self.path, _CLAIM_KEYS)
        name = self._required("id")
        if _ID.fullmatch(name) is None:
            message = f"id: expected letters, digits and . _ - + * ' without blanks, got {name!r}"
            raise toml.error_at_value((*self.path, "id"), message)
        self._refuse_contradictions()
        claim = Claim(
            id=name,
            printed=Formula(self._text("printed") or ""),
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
        claims = [self._theorem(claim)] if claim.theorem else self._lines(claim)
        for part in claims:
            if part.id in self.owners:
                raise toml.error_at_value((*self.path, "id"), f"id {part.id!r} is used twice")
            self.owners[part.id] = name
        return claims

    def _theorem(self, claim: Claim) -> Claim:
        self._required("statement")
        if claim.theorem not in self.theorems:
            known = ", ".join(sorted(self.theorems)) or "none is installed for this file"
            message = f"theorem: no proof called {claim.theorem!r} (known: {known})"
            raise self.file.toml.error_at_value((*self.path, "theorem"), message)
        reader = self._reader(claim)
        return replace(claim, corrected=reader.intended("corrected"), hypothesis=self._condition(reader))

    def _condition(self, reader: FormulaReader) -> Formula | None:
        """The hypothesis of a theorem: a formula, or words as \\text{…}, since only its proof uses it."""
        text = self._text("hypothesis")
        if text is not None and _WORDS.fullmatch(text):
            return Formula(text)
        return reader.intended("hypothesis")

    def _lines(self, claim: Claim) -> list[Claim]:
        """The claim, or one claim for each line of its printed formula."""
        self._required("printed")
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
            if one in table and other in table:
                message = f"{other!r} and {one!r} exclude each other"
                raise self.file.toml.error_at_key((*self.path, other), message)

    def _text(self, key: str) -> str | None:
        return self.file.toml.text((*self.path, key))

    def _required(self, key: str) -> str:
        text = self._text(key)
        if text is None:
            raise self.file.toml.error_at_key(self.path, f"missing key {key!r}")
        return text
