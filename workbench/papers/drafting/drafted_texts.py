"""Texts under the models that are drafted for them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from workbench.papers.drafting.draft_model import Ingested, ingested
from workbench.papers.drafting.meanings.borne_out import with_meanings
from workbench.papers.drafting.meanings.contradictions import Contradiction, contradictions_in
from workbench.papers.drafting.meanings.permuted_rows import contradicted_rows
from workbench.papers.drafting.model_file import loaded_model
from workbench.papers.drafting.redefinitions import Scope
from workbench.papers.paper_cache import Kept
from workbench.papers.texts.load_texts import model_beside
from workbench.papers.texts.text_paper import TextPaper, text_paper
from workbench.runtime import Budget
from workbench.runtime.store import Store
from workbench.source.documents import Text, is_text, read_text
from workbench.source.documents.titles import own_title

#: The libraries whose versions a draft depends on, beside the files of its text.
DRAFTS_REST_ON = ("lark", "python-flint", "sympy", "numpy", "drake")

#: The limits of each judgement under a drafted model: what guesses do not decide soon, a model may. A text of
#: many claims gets about as much time as one of ten, but each claim at least the least.
_MOST_SECONDS, _LEAST_SECONDS, _SECONDS_OF_TEXT = 10.0, 2.0, 100.0


@dataclass(frozen=True)
class Draft:
    """A text under a drafted model.

    scopes: those of the draft that the model keeps.
    contradicted: the formulas that contradict others.
    """

    ingested: Ingested
    paper: TextPaper
    scopes: tuple[Scope, ...] = ()
    contradicted: tuple[Contradiction, ...] = ()

    @property
    def summary(self) -> str:
        """One line that says that a model was drafted, and how to keep it."""
        found, path = self.ingested, self.ingested.text.path
        definitions = sum(proposed.sure for proposed in found.definitions)
        counts = [(len(found.guesses), "symbol"), (definitions, "definition")]
        told = ", ".join(f"{count} {word}{'' if count == 1 else 's'}" for count, word in counts)
        return f"drafted a model of {path.name} ({told}); `workbench draft {path}` writes it"


def undeclared_text(path: Path) -> Text | None:
    """Returns the text of a file without a model and without comments that declare anything; None for other
    files. Raises PaperError."""
    text = read_text(path) if is_text(path) and model_beside(path) is None else None
    return None if text is None or text.directives else text


def newest_draft(text: Text, store: Store | None) -> Draft:
    """Returns the draft of a text, from the store if the text has not changed. Raises PaperError."""
    kept = Kept(store)
    files = [(str(source.path), source.text, source.warnings) for source in text.sources]
    key = kept.key_of(("draft", str(text.path), files, list(map(str, text.warnings))), DRAFTS_REST_ON)
    return kept.newest(str(text.path), key, lambda: draft_from(ingested(text)), Draft)


def meant(ingested: Ingested) -> Ingested:
    """Returns a draft with the definitions that words and other formulas give instead of misprints. Raises
    PaperError."""
    return with_meanings(ingested, _loaded(ingested).paper)


def draft_from(ingested: Ingested) -> Draft:
    """Returns a text under the model of a draft. Raises PaperError."""
    draft = _loaded(ingested)
    meant = with_meanings(ingested, draft.paper)
    draft = draft if meant is ingested else _loaded(meant)
    found = (draft.ingested, draft.paper)
    return replace(draft, contradicted=(*contradictions_in(*found), *contradicted_rows(*found)))


def _loaded(ingested: Ingested) -> Draft:
    path = ingested.text.path
    _, model, scopes = loaded_model(ingested, path.with_suffix(".toml"), is_confirmed=True)
    paper = text_paper(ingested.text, model, own_title(ingested.text) or path.name, None, (path,))
    return Draft(ingested, replace(paper, budget=_budget_of(len(paper.claims))), scopes)


def _budget_of(claims: int) -> Budget:
    """Returns the limits of each of so many judgements."""
    share = _SECONDS_OF_TEXT / max(claims, 1)
    return Budget(seconds=min(_MOST_SECONDS, max(_LEAST_SECONDS, share)))
