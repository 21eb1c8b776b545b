"""Loader of texts: with the model next to them, or with the comments in them."""

from __future__ import annotations

import tomllib
from dataclasses import replace
from functools import partial
from pathlib import Path

from workbench.context.claims import CITATION_KEYS
from workbench.papers.notation_files import budget_of, chain_stage, nearest
from workbench.papers.reading_stages import ErrorLog, stage
from workbench.papers.texts.text_model import (
    MODEL_KEYS,
    TextModel,
    read_directives,
    read_entries,
    read_scopes,
)
from workbench.papers.texts.text_paper import TextPaper, text_paper
from workbench.source.documents import Text, read_text
from workbench.source.documents.titles import own_title
from workbench.source.toml.toml_file import TomlFile, present_text


def load_text(path: Path) -> TextPaper:
    """Returns a text with the model next to it, if there is one. Raises PaperError."""
    beside = model_beside(path)
    if beside is not None:
        return load_model(TomlFile(beside))
    text = read_text(path)
    model = TextModel()
    read_directives(text.directives, text.displays, model)
    title = next((toml.text(("title",)) for toml in model.chain if "title" in toml.data), None)
    return text_paper(text, model, title or own_title(text) or text.path.name, None, (path,))


def load_model(toml: TomlFile) -> TextPaper:
    """Returns a model with the text that it names. Raises PaperError."""
    path, faults = _beside(toml, "source"), ErrorLog()
    assert path is not None, "a model names its text"
    text = faults.need(stage(lambda file: _with_macros(file, path), toml))
    model = model_of(toml, text, faults)
    title, doi = (faults.past(stage(partial(TomlFile.text, path=(key,)), toml)) for key in ("title", "doi"))
    faults.past(stage(lambda file: file.allow_keys(("citation",), CITATION_KEYS), toml))
    told = {
        key: faults.past(stage(partial(TomlFile.text, path=("citation", key)), toml)) for key in CITATION_KEYS
    }
    citation = {key: text for key, text in told.items() if text}
    budget = faults.past(stage(lambda *files: nearest(files, budget_of), *model.chain))
    paper = text_paper(
        text, model, title or own_title(text) or text.path.name, doi, (toml.path, text.path), citation
    )
    return replace(paper, budget=budget, model_text=toml.places.text)


def text_of_model(paper: TextPaper) -> Text | None:
    """Returns the text of a paper with a model, read again; None if it has none, or the model has changed.
    Raises PaperError."""
    model = next((path for path in paper.paths if path.suffix == ".toml"), None)
    if model is None or paper.model_text is None:
        return None
    toml = TomlFile(model)
    path = _beside(toml, "source")
    return None if path is None or toml.places.text != paper.model_text else _with_macros(toml, path)


def _with_macros(toml: TomlFile, path: Path) -> Text:
    if not isinstance(toml.data.get("macros"), dict):
        return read_text(path, _beside(toml, "macros"))
    names = [name for name in toml.value(("macros",), dict) if name != "from"]
    bodies = {name: present_text(toml, ("macros", name)) for name in names}
    return read_text(path, _beside(toml, "macros", "from"), bodies=bodies)


def model_of(toml: TomlFile, text: Text, faults: ErrorLog) -> TextModel:
    """Returns the content of the model and of the comments in its text. Raises PaperError if it names no
    notation."""
    faults.past(stage(lambda file: file.allow_keys((), MODEL_KEYS), toml))
    chain = faults.past(chain_stage(toml))
    guessed = faults.past(stage(lambda file: file.texts(("guessed",)), toml))
    if chain is None:
        faults.stop()
    assert chain is not None, "no files, and no fault is told"
    model = TextModel(chain, guessed=guessed or (), faults=faults)
    read_scopes(toml, text, model)
    read_directives(text.directives, text.displays, model)
    model.entries[:0] = read_entries(toml, faults)
    return model


def model_beside(text: Path) -> Path | None:
    """Returns `paper.toml` next to `paper.tex`, if that is its source."""
    path = text.with_suffix(".toml")
    try:
        source = tomllib.loads(path.read_text("utf-8")).get("source")
    except FileNotFoundError:
        return None
    except (OSError, ValueError, RecursionError):
        return path  # the fault is reported when the file is read
    return path if source == text.name else None


def _beside(toml: TomlFile, *key: str) -> Path | None:
    name = toml.text(key)
    if name is None:
        return None
    path = toml.path.parent / name
    if not path.is_file():
        raise toml.error_at_value(key, f"{key[-1]}: no file {name!r} beside this one")
    return path
