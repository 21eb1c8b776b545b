"""Reader of one [[claim]] of a paper file: checks its keys against each other and reads its formulas."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.context.claim_parts import ClaimSource, Sentence
from workbench.context.claims import Claim, ClaimProof, Correction, Formula, Notation, Stated
from workbench.context.index_values import Orders
from workbench.context.read_formulas import FormulaReader
from workbench.core.codes.model_codes import ModelCode
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.paper_errors import KeyPath
from workbench.core.schema import key_names
from workbench.core.terms import Conjunction, Statement
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import GoalError, Scope, atoms, bound_integers
from workbench.language.goals.proofs import Proven
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula
from workbench.papers.corrections import mend_of
from workbench.source.rows.formula_lines import Line, split_lines
from workbench.source.toml.toml_file import TomlFile

_ID = re.compile(r"[\w.+*'-]{1,80}")
_HYPOTHESIS = re.compile(r"\\hypothesis\s*\\Rightarrow")
_QUOTE = re.compile(r"“[^“”]+”")
_CONTRADICTIONS = (
    ("goal", "reading"),
    ("goal", "formula"),
    ("corrected", "hypothesis"),
    ("every_n", "theorem"),
    ("every_n", "goal"),
)


@dataclass
class ClaimTable:
    """The claim table at `path`.

    Attributes:
        section: The section of claims that name none.
        owners: Claim id → id of its table, for all claims so far.
    """

    toml: TomlFile
    path: KeyPath
    notation: Notation
    section: str | None
    owners: dict[str, str]
    theorems: Mapping[str, Proven]

    def claims(self) -> list[Claim]:
        toml = self.toml
        toml.allow_keys(self.path, key_names("claim of a paper file"))
        name = self._text("id") or ""
        if name and _ID.fullmatch(name) is None:
            message = f"id: expected letters, digits and . _ - + * ' without blanks, got {name!r}"
            raise toml.error_at_value((*self.path, "id"), message)
        self._refuse_used(name)
        self._refuse_contradictions()
        printed, quote = self._printed()
        formula = self._text("formula")
        claim = Claim(
            id=name,
            printed=Formula(printed or formula or ""),
            notation=self.notation,
            orders=self._orders(),
            mend=mend_of(toml, self.path, printed or quote or formula or ""),
            source=ClaimSource(
                equation=self._text("equation"),
                section=self._text("section") or self.section,
                file=toml.path,
                line=toml.places.of_key(self.path)[0],
                statement=self._text("statement"),
                note=toml.value((*self.path, "note"), str, ""),
            ),
            sentence=Sentence(quote, ours=not printed and formula is not None),
            proof=ClaimProof(
                theorem=self._text("theorem"), argued=self._text("argued"), every_n=self._proof("every_n")
            ),
            inherits=toml.texts((*self.path, "inherits")),
        )
        self._refuse_without_goal()
        claims = [self._goal_claim(claim)] if self._text("goal") is not None else self._lines(claim)
        self._required("id")
        for part in claims:
            self._refuse_used(part.id)
            self.owners[part.id] = name
        return claims

    def _refuse_used(self, name: str) -> None:
        if name in self.owners:
            raise self.toml.error_at_value((*self.path, "id"), f"id {name!r} is used twice")

    def _printed(self) -> tuple[str | None, str | None]:
        """Returns the printed formula and the printed sentence, which stands in quotation marks “ ”."""
        text = self._text("printed")
        if text is None or not text.startswith("“"):
            if text is not None and self._text("formula") is not None:
                message = (
                    "formula: ours stands for a printed sentence; beside a printed formula it has no use"
                )
                raise self.toml.error_at_key((*self.path, "formula"), message)
            return text, None
        if _QUOTE.fullmatch(text) is None:
            raise self.toml.error_at_value((*self.path, "printed"), "printed: expected one sentence, “…”")
        return None, text

    def _refuse_without_goal(self) -> None:
        for key in ("theorem", "argued"):
            if self._text(key) is not None and self._text("goal") is None:
                raise self.toml.error_at_key((*self.path, key), f"{key}: expected a goal beside it")

    def _goal_claim(self, claim: Claim) -> Claim:
        self._required("statement")
        self._proof("theorem")
        reader = self._reader(claim)
        goal = self._goal(claim)
        integers = set(claim.orders.variables if claim.orders else ()) | bound_integers(goal.goal)
        self._refuse_other_goal(goal, self._said(claim, integers))
        hypothesis = self._text("hypothesis")
        return replace(
            claim,
            proof=replace(claim.proof, goal=goal),
            correction=Correction(
                corrected=reader.intended("corrected"),
                hypothesis=None if hypothesis is None else Formula(hypothesis),
            ),
            assume=reader.assumed(),
        )

    def _said(self, claim: Claim, integers: Collection[str]) -> list[Statement]:
        """Returns the statements printed next to a goal, which must be well-typed."""
        try:
            lines = split_lines(claim.printed.latex) if claim.printed.latex else ()
            table = self.notation.symbols
            return [s for line in lines for s in read_formula(line.latex, table, integers).statements]
        except (ReadError, IllFormedAt) as error:
            raise self.toml.error_at_value((*self.path, "printed"), f"printed: {error}") from None

    def _goal(self, claim: Claim) -> Stated:
        text = self._required("goal")
        scope = Scope(self.notation.symbols, self.notation.definitions, {})
        hypothesis = self._text("hypothesis")
        if (hypothesis is None) != (_HYPOTHESIS.search(text) is None):
            message = (
                "goal: expected `\\hypothesis \\Rightarrow` in it if there is a hypothesis, and only then"
            )
            raise self.toml.error_at_value((*self.path, "goal"), message)
        said = text.replace("\\printed", claim.printed.latex)
        try:
            goal = read_goal(said.replace("\\hypothesis", hypothesis or ""), scope)
            bare = goal if hypothesis is None else read_goal(_HYPOTHESIS.sub("", said), scope)
            return Stated(text, goal, bare)
        except (GoalError, ReadError, IllFormedAt) as error:
            raise self.toml.error_at_value((*self.path, "goal"), f"goal: {error}") from None

    def _refuse_other_goal(self, goal: Stated, said: Sequence[Statement]) -> None:
        """Raises PaperError if a printed formula is not part of the goal: the goal might be unrelated."""
        parts = [part for statement in atoms(goal.goal) for part in (statement, *_parts(statement))]
        for statement in said:
            if statement not in parts:
                message = f"goal: the printed formula {to_latex(statement)} is no part of it"
                raise self.toml.error_at_value((*self.path, "goal"), message)

    def _lines(self, claim: Claim) -> list[Claim]:
        """Returns the claim, or one claim for each line of its printed formula."""
        if not claim.printed.latex:
            for key in ("reading", "corrected", "hypothesis"):
                self._reader(claim).intended(key)
            self._reader(claim).assumed()
            self._required("id")
            self._required("formula" if claim.sentence.quote is not None else "printed")
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
                    correction=Correction(
                        reading,
                        None if corrections is None else reader.intended("corrected", corrections[number]),
                        reader.hypothesis(printed),
                    ),
                    assume=reader.conditions(printed),
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
            raise self.toml.error_at_value((*self.path, key), message)
        return found

    def _reader(self, claim: Claim) -> FormulaReader:
        return FormulaReader(self.toml, self.path, self.notation, claim.orders)

    def _orders(self) -> Orders | None:
        text = self._text("orders")
        try:
            return None if text is None else Orders.parse(text)
        except ValueError as error:
            raise self.toml.error_at_value((*self.path, "orders"), str(error)) from None

    def _proof(self, key: str) -> str | None:
        name = self._text(key)
        if name is not None and name not in self.theorems:
            known = ", ".join(sorted(self.theorems)) or "none is installed for this file"
            message = f"{key}: no proof called {name!r} (known: {known})"
            raise self.toml.error_at_value((*self.path, key), message)
        return name

    def _refuse_contradictions(self) -> None:
        table = self.toml.value(self.path, dict)
        for one, other in _CONTRADICTIONS:
            if one in table and other in table:
                message = f"{other!r} and {one!r} exclude each other"
                raise self.toml.error_at_key((*self.path, other), message)

    def _text(self, key: str) -> str | None:
        return self.toml.text((*self.path, key))

    def _required(self, key: str) -> str:
        text = self._text(key)
        if text is None:
            raise self.toml.error_at_key(self.path, ModelCode.MISSING_KEY(key=key))
        return text


def _parts(statement: Statement) -> Sequence[Statement]:
    return statement.parts if isinstance(statement, Conjunction) else ()
