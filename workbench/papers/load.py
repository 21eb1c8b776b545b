"""Loader of papers: checks keys, reads every formula, and reports each fault as a PaperError with its
position.

The readers of formulas and texts are imported on first use, because cached files need none of them.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Container, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, wraps
from pathlib import Path
from typing import Any, TypeVar

from workbench.context.claims import CITATION_KEYS, Claim, Notation, Paper
from workbench.core.codes.model_codes import ModelCode
from workbench.core.paper_errors import PaperError
from workbench.core.schema import key_names
from workbench.language.goals.proofs import Proven
from workbench.papers.installed_papers import DEFAULT, installed, installed_names, name_of, paper_of
from workbench.papers.notation_files import budget_of, chain_stage, nearest, notation_chain
from workbench.papers.paper_cache import Kept
from workbench.papers.reading_stages import ErrorLog, stage
from workbench.papers.sibling_files import claim_ids, sisters_of
from workbench.runtime import Budget, Workers
from workbench.runtime.store import Store
from workbench.source.toml.toml_file import TomlFile

_PAPER_KEYS = key_names("paper file")
_NO_FILES = "the installed paper has no claim files"

#: The number of files from which on they are read in parallel processes.
_MANY = 4

T = TypeVar("T")


def load_paper(path: Path | str, faults: list[PaperError] | None = None, store: Store | None = None) -> Paper:
    """Returns the paper of one file: a paper file, a text, or the model of a text.

    Raises PaperError, with all faults and their positions, if the file cannot be used.

    faults: receives the faults of single claims instead of raising them.
    store: the cache of files that were read before.
    """
    from workbench.papers.texts.load_texts import load_model, load_text
    from workbench.source.documents import is_text

    path = Path(path)
    if is_text(path):
        return load_text(path)
    toml = TomlFile(path)
    return load_model(toml) if "source" in toml.data else merge([path], faults=faults, store=store)


def load_part(path: Path) -> Paper:
    """Returns the paper of one file; for an installed paper, its claims in this file. Raises PaperError."""
    if (name := name_of(path)) is None:
        return load_paper(path)
    paper, place = load_installed(name), path.resolve()
    own = tuple(claim for claim in paper.claims if claim.source.file and claim.source.file.resolve() == place)
    return replace(paper, claims=own) if own else paper  # the claims of a model stand in its text


def load_notation(path: Path | str) -> Notation:
    """Returns the notation of a paper file or a notation file, which need not have claims. Raises
    PaperError."""
    toml, faults = TomlFile(Path(path)), ErrorLog()
    faults.past(stage(lambda file: file.allow_keys((), _PAPER_KEYS), toml))
    notation = faults.need(stage(lambda file: _notation_of(notation_chain(file)), toml))
    faults.stop()
    return notation


def _once(read: Callable[..., T]) -> Callable[..., T]:
    """Returns a reader that caches installed papers per process, independent of the store."""
    found: dict[str, T] = {}

    @wraps(read)
    def known(name: str = DEFAULT, *how: Any, **named: Any) -> T:
        if name not in found:
            found[name] = read(name, *how, **named)
        return found[name]

    return known


@_once
def installed_notation(name: str, store: Store | None = None) -> Notation:
    """Returns the notation of an installed paper as `load_installed` gives it, without reading the claims."""
    paper = installed(name)
    chains = (notation_chain(TomlFile(path)) for path in paper.files)
    first = next(chains, None)
    if first is None:
        raise PaperError(name, None, None, _NO_FILES)
    is_whole = len(paper.files) == 1
    files = first if is_whole else next((c[:-1] for c in (first, *chains) if len(c) > 1), first)
    return Kept(store).once("notation", files, lambda: _notation_of(files))


@_once
def load_installed(
    name: str, store: Store | None = None, meanwhile: Callable[[], None] = lambda: None
) -> Paper:
    """Returns the installed paper of that name, its files merged in order. Raises PaperError if there is
    none.

    meanwhile: as for `merge`.
    """
    paper = installed(name)
    if not paper.files:
        raise PaperError(name, None, None, _NO_FILES)
    if len(paper.files) == 1 and "source" in TomlFile(paper.files[0]).data:
        return load_paper(paper.files[0])
    return merge(paper.files, paper.theorems, store=store, meanwhile=meanwhile)


def find_paper(
    name: Path | str | None = None,
    store: Store | None = None,
    meanwhile: Callable[[], None] = lambda: None,
) -> Paper:
    """Returns the paper of the file `name`, or the installed paper of that name. Raises PaperError.

    meanwhile: as for `merge`.
    """
    if name is None:
        return load_installed(DEFAULT, store, meanwhile)
    if str(name) in installed_names() and not Path(name).is_file():
        return load_installed(str(name), store, meanwhile)
    from workbench.source.documents import is_text

    path = Path(name)
    if path.exists() or path.suffix == ".toml" or is_text(path) or path.name != str(name):
        return load_paper(path, store=store)
    return load_installed(str(name), store, meanwhile)


def merge(
    paths: Sequence[Path],
    theorems: Mapping[str, Proven] | None = None,
    faults: list[PaperError] | None = None,
    store: Store | None = None,
    meanwhile: Callable[[], None] = lambda: None,
) -> Paper:
    """Returns one paper of several files, in their order; ids are unique over all. Each file keeps its
    notation.

    theorems: name → proof; if None, those of the installed paper that contains the first file.
    faults: receives the faults of single claims, which are left out; if None, they are raised.
    meanwhile: called here while many files are read in parallel processes.
    """
    found, kept = ErrorLog(), Kept(store)
    files = [_PaperFile.open(Path(path), found, kept) for path in paths]
    if theorems is None:
        needed = any("theorem" in claim for file in files for claim in file.claims)
        theorems = paper_of(files[0].toml.path).theorems if needed else {}
    if not found:
        _read_ahead([file for file in files if file.before is None], theorems, kept, meanwhile)
    for file in files:
        file.notation = (
            file.before.notation
            if file.before
            else found.past(stage(lambda *files: _notation_of(files), *file.chain))
        )
        if file.notation is None:
            found.stop()
    below = next((file.chain[:-1] for file in files if len(file.chain) > 1 and len(files) > 1), None)
    shared = below and found.past(
        stage(lambda *files: kept.once("notation", below, lambda: _notation_of(files)), *below)
    )
    is_usable = not found
    claims: list[Claim] = []
    owners: dict[str, str] = {}
    skipped: list[str] = []
    for file in files:
        claims += file.read(owners, theorems, skipped, found, kept)
        found.past(stage(partial(_require_claims, ids={*owners, *skipped}), file.toml))
    parts: dict[str, list[str]] = {name: [] for name in skipped}
    for claim in claims:
        parts.setdefault(owners[claim.id], []).append(claim.id)
        parts.setdefault(claim.id, [claim.id])
    named = [name for claim in claims for name in (*claim.inherits, claim.mend.by) if name is not None]
    if any(name not in parts for name in named):
        sisters = list(dict.fromkeys(path for file in files for path in sisters_of(file.toml.path)))
        parts = claim_ids(sisters) | parts
        for file in files:
            file.check_inheritance(parts, sisters, found)
    if faults is None or not is_usable or not claims:
        found.stop()
    if faults is not None:
        faults += found
    claims = [
        replace(claim, inherits=tuple(part for name in claim.inherits for part in parts.get(name, ())))
        for claim in claims
    ]
    first = files[0]
    budget = next((file.budget for file in files if file.budget is not None), None)
    citation = {key: text for file in files for key, text in file.citation.items() if text}
    return Paper(
        first.title,
        first.doi,
        tuple(paths),
        shared or first.known_notation,
        tuple(claims),
        dict(theorems),
        budget,
        citation,
        faults=tuple(found),
        sections={number: name for file in files for number, name in file.sections.items()},
    )


def _section_names(toml: TomlFile) -> dict[str, str]:
    """Returns the headings of sections by their numbers."""
    names = toml.value(("sections",), dict, {})
    return {number: name for number in names if (name := toml.text(("sections", number)))}


@dataclass(frozen=True)
class _Read:
    """The content of a file without faults. owners: claim → the id of its table."""

    notation: Notation
    claims: tuple[Claim, ...]
    owners: Mapping[str, str]


@dataclass
class _PaperFile:
    """One file with its chain of notation files, and its cached content."""

    toml: TomlFile
    title: str
    doi: str | None
    section: str | None
    chain: Sequence[TomlFile]
    budget: Budget | None
    citation: Mapping[str, str | None]
    sections: Mapping[str, str]
    claims: Sequence[Mapping[str, Any]]
    key: str
    before: _Read | None
    notation: Notation | None = None

    @staticmethod
    def open(path: Path, faults: ErrorLog, kept: Kept) -> _PaperFile:
        """Returns the file. Raises PaperError if its claims cannot even be listed."""
        toml = TomlFile(path)

        def past(read: Callable[[TomlFile], T]) -> T | None:
            return faults.past(stage(read, toml))

        past(lambda file: file.allow_keys((), _PAPER_KEYS))
        claims = past(lambda file: file.tables(("claim",)))
        if not claims:
            faults.tell(toml.error_at_key((), ModelCode.NO_CLAIMS(claim="claim")))
        past(lambda file: file.allow_keys(("citation",), CITATION_KEYS))
        citation = {key: past(partial(TomlFile.text, path=("citation", key))) for key in CITATION_KEYS}
        chain = faults.past(chain_stage(toml)) or [toml]
        title, doi, budget = (
            faults.past(stage(lambda *files, read=read: nearest(files, read), *chain))
            for read in (lambda file: file.text(("title",)), lambda file: file.text(("doi",)), budget_of)
        )
        if title is None:
            faults.tell(toml.error_at_key((), ModelCode.MISSING_KEY(key="title")))
        section, key = past(lambda file: file.text(("section",))), kept.key("claims", chain)
        sections = past(_section_names) or {}
        before: _Read | None = kept.get(key)
        return _PaperFile(
            toml, title or "", doi, section, chain, budget, citation, sections, claims or (), key, before
        )

    def read(
        self,
        owners: dict[str, str],
        theorems: Mapping[str, Proven],
        skipped: list[str],
        faults: ErrorLog,
        kept: Kept,
    ) -> Sequence[Claim]:
        """Returns the claims; ids of claims that cannot be read are appended to `skipped`."""
        if self.before is not None and self._is_as_before(self.before, owners, theorems):
            owners |= self.before.owners
            return self.before.claims
        from workbench.papers.claim_tables import ClaimTable

        claims: list[Claim] = []
        notation = self.known_notation
        for index, claim in enumerate(self.claims):

            def read(file: TomlFile, index: int = index) -> list[Claim]:
                path = ("claim", index)
                return ClaimTable(file, path, notation, self.section, owners, theorems).claims()

            made = faults.whole(stage(read, self.toml))
            claims += made or ()
            if made is None and isinstance(name := claim.get("id"), str):
                skipped.append(name)
        if not faults:
            own = {claim.id: owners[claim.id] for claim in claims}
            self.keep(kept, _Read(notation, tuple(claims), own))
        return claims

    @property
    def known_notation(self) -> Notation:
        """The notation of a file that is read."""
        assert self.notation is not None, f"{self.toml.path} is not read"
        return self.notation

    def keep(self, kept: Kept, read: _Read) -> None:
        if read.notation.robot is None:  # the file of a robot may change
            kept.put(self.key, read)

    def read_alone(self, theorems: Mapping[str, Proven]) -> _Read | None:
        """Returns the content of the file; None if it has a fault."""
        faults = ErrorLog()
        owners: dict[str, str] = {}
        try:
            notation = self.notation = _notation_of(self.chain)
            claims = self.read(owners, theorems, [], faults, Kept(None))
        except PaperError:
            return None
        return None if faults else _Read(notation, tuple(claims), owners)

    @staticmethod
    def _is_as_before(before: _Read, owners: Mapping[str, str], theorems: Mapping[str, Proven]) -> bool:
        named = {claim.proof.theorem for claim in before.claims} - {None}
        return not before.owners.keys() & owners.keys() and named <= theorems.keys()

    def check_inheritance(self, known: Collection[str], sisters: Sequence[Path], faults: ErrorLog) -> None:
        elsewhere = f", here or in {', '.join(path.name for path in sisters)}" if sisters else ""
        for index, claim in enumerate(self.claims):
            named = [(("inherits", place), name) for place, name in enumerate(claim.get("inherits", ()))]
            for path, name in [*named, (("mended_by",), claim.get("mended_by"))]:
                if isinstance(name, str) and name not in known:
                    message = f"{path[0]}: no claim has the id {name!r}{elsewhere}"
                    faults.tell(self.toml.error_at_value(("claim", index, *path), message))


def _read_ahead(
    files: Sequence[_PaperFile], theorems: Mapping[str, Proven], kept: Kept, meanwhile: Callable[[], None]
) -> None:
    """Reads many files on all cores and stores them as cached content, except files with a fault."""
    cores = os.cpu_count() or 1
    if cores == 1 or len(files) < _MANY:
        return
    groups = _shared_out(files, cores)

    def read_alone(place: int) -> list[_Read | None]:
        return [file.read_alone(theorems) for file in groups[place]]

    with Workers(read_alone, None, cores, prepare=_load_readers) as readers:
        for group, given in zip(groups, readers.map(range(len(groups)), meanwhile=meanwhile), strict=True):
            for file, read in zip(group, given, strict=True):
                file.before = read
                if read is not None:
                    file.keep(kept, read)


def _shared_out(files: Sequence[_PaperFile], count: int) -> list[list[_PaperFile]]:
    """Returns that many groups of files of about equal size."""
    groups: list[list[_PaperFile]] = [[] for _ in range(min(count, len(files)))]
    for file in sorted(files, key=_size, reverse=True):
        min(groups, key=lambda group: sum(map(_size, group))).append(file)
    return groups


def _size(file: _PaperFile) -> int:
    return len(file.toml.places.text)


def _load_readers() -> None:
    """Imports the readers once, before the processes start."""
    import workbench.papers.claim_tables
    import workbench.papers.notation_tables  # noqa: F401
    from workbench.language.grammar.parser import parse

    parse("x")


def _notation_of(files: Sequence[TomlFile]) -> Notation:
    from workbench.papers.notation_tables import notation_of

    return notation_of(files)


def _require_claims(file: TomlFile, ids: Container[str]) -> None:
    """Raises PaperError for a table [motion.claims] that names no claim."""
    for claim in file.value(("motion", "claims"), dict, {}):
        if claim not in ids:
            message = f"motion: no claim has the id {claim!r}"
            raise file.error_at_key(("motion", "claims", claim), message)
