"""From paper files to a Paper: keys checked, every formula read, each fault a PaperError with its place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

from workbench.budget import Budget
from workbench.papers.claim_tables import ClaimTable
from workbench.papers.installed import DEFAULT, installed, installed_names, paper_of
from workbench.papers.model import CITATION_KEYS, Claim, Notation, Paper, PaperError, Theorem, UnreadFormula
from workbench.papers.motion import require_claims
from workbench.papers.notation import NOTATION_KEYS, notation_chain, notation_of
from workbench.papers.sisters import claim_ids, sisters_of
from workbench.papers.text_load import load_model, load_text
from workbench.papers.texts import is_text
from workbench.papers.toml_file import TomlFile

_PAPER_KEYS = (*NOTATION_KEYS, "citation", "section", "claim")
_NO_FILES = "the installed paper has no claim files"


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
                claims += ClaimTable(
                    file.toml, ("claim", index), file.notation, file.section, owners, theorems
                ).claims()
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
