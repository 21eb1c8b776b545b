"""Texts by their files: with the model that lies beside them, or with the comments in them alone."""

from __future__ import annotations

import tomllib
from pathlib import Path

from workbench.papers.model import CITATION_KEYS
from workbench.papers.notation import notation_chain
from workbench.papers.text_model import MODEL_KEYS, TextModel, read_directives, read_entries, read_scopes
from workbench.papers.text_paper import TextPaper, text_paper
from workbench.papers.texts import Text, read_text
from workbench.papers.toml_file import TomlFile


def load_text(path: Path) -> TextPaper:
    """A text with the model beside it, where there is one. Raises PaperError."""
    beside = model_beside(path)
    if beside is not None:
        return load_model(TomlFile(beside))
    text = read_text(path)
    model = TextModel()
    read_directives(text.directives, text.displays, model)
    title = next((toml.text(("title",)) for toml in model.chain if "title" in toml.data), path.name)
    return text_paper(text, model, title, None, (path,))


def load_model(toml: TomlFile) -> TextPaper:
    """A model and the text that it names. Raises PaperError."""
    toml.allow_keys((), MODEL_KEYS)
    path = _beside(toml, "source")
    if isinstance(toml.data.get("macros"), dict):
        bodies = {name: toml.text(("macros", name)) for name in toml.value(("macros",), dict)}
        bodies.pop("from", None)
        text = read_text(path, _beside(toml, "macros", "from"), bodies=bodies)
    else:
        text = read_text(path, _beside(toml, "macros"))
    return paper_of_model(toml, text)


def paper_of_model(toml: TomlFile, text: Text) -> TextPaper:
    """The model and the text that was read for it. Raises PaperError."""
    model = TextModel(notation_chain(toml), guessed=toml.texts(("guessed",)))
    read_scopes(toml, text.displays, model)
    read_directives(text.directives, text.displays, model)
    model.entries[:0] = read_entries(toml)
    title = toml.text(("title",)) or text.path.name
    toml.allow_keys(("citation",), CITATION_KEYS)
    citation = {key: said for key in CITATION_KEYS if (said := toml.text(("citation", key)))}
    return text_paper(text, model, title, toml.text(("doi",)), (toml.path, text.path), citation)


def model_beside(text: Path) -> Path | None:
    """`paper.toml` beside `paper.tex`, if it says that this is its source."""
    path = text.with_suffix(".toml")
    try:
        source = tomllib.loads(path.read_text("utf-8")).get("source")
    except FileNotFoundError:
        return None
    except (OSError, ValueError):
        return path  # its fault is told when it is read
    return path if source == text.name else None


def _beside(toml: TomlFile, *key: str) -> Path | None:
    name = toml.text(key)
    if name is None:
        return None
    path = toml.path.parent / name
    if not path.is_file():
        raise toml.error_at_value(key, f"{key[-1]}: no file {name!r} beside this one")
    return path
