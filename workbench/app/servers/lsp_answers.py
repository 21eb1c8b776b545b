"""Editor actions for a text without a model: answers to its questions, and writing its model to a file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbench.app.commands.judging_options import write_atomically
from workbench.app.commands.options import Unusable

if TYPE_CHECKING:
    from lsprotocol.types import CodeAction, CodeLens, Range

    from workbench.app.pipeline.judged_files import Judged
    from workbench.papers.drafting.questions_to_author import Answer

#: The commands that the editor sends back.
ANSWER, WRITE_MODEL = "workbench.answer", "workbench.writeModel"


def answer_actions(uri: str, judged: Judged, where: Range) -> Iterator[CodeAction]:
    """Yields an action for each answer to a question about a formula in a range."""
    from lsprotocol.types import CodeAction, CodeActionKind, Command

    from workbench.papers.drafting.questions_to_author import questions_about

    if judged.draft is None:
        return
    lines = {result.claim.id: (result.claim.line or 0) - 1 for result in judged.results}
    for question in questions_about(judged.draft, judged.results):
        at = {question.line - 1, *(lines[each] for each in question.settles if each in lines)}
        if not any(where.start.line <= line <= where.end.line for line in at):
            continue
        count = len(question.settles)
        for answer in question.answers:
            title = f"{question.text} {answer.value} (decides {count} formula{'' if count == 1 else 's'})"
            command = Command(title, ANSWER, arguments=[uri, answer.table, answer.key, answer.value])
            yield CodeAction(title, CodeActionKind.QuickFix, command=command)


def lenses(uri: str, judged: Judged) -> Iterator[CodeLens]:
    """Yields the summary of a text for its first line, and how to keep a drafted model."""
    from lsprotocol.types import CodeLens, Command, Position, Range

    from workbench.papers.texts.text_paper import TextPaper
    from workbench.report.listing import listing

    if not isinstance(judged.paper, TextPaper):
        return
    top = Range(Position(0, 0), Position(0, 0))
    yield CodeLens(top, Command(listing(judged.paper, judged.results).summary, ""))
    if judged.draft is not None:
        name = judged.draft.ingested.text.path.with_suffix(".toml").name
        yield CodeLens(top, Command(f"write the drafted model to {name}", WRITE_MODEL, arguments=[uri]))


def answer_of(given: list[Any]) -> Answer | None:
    """Returns the answer in a command's arguments; None if there is none."""
    from workbench.papers.drafting.questions_to_author import Answer

    if len(given) != 4 or not all(isinstance(each, str) for each in given):
        return None
    answer = Answer(*given[1:])
    return answer if answer.is_entry else None


def write_model(judged: Judged) -> str:
    """Writes the drafted model next to its text; returns the message for the user."""
    from workbench.papers.drafting.model_file import model_text

    assert judged.draft is not None
    ingested = judged.draft.ingested
    path: Path = ingested.text.path.with_suffix(".toml")
    if path.exists():
        return f"{path.name} is there already; nothing was written"
    try:
        write_atomically(path, model_text(ingested, path))
    except Unusable as error:
        return error.message
    return f"the model is {path}"
