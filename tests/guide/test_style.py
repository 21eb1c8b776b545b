"""The style of README, manual, messages and docstrings: idioms to avoid, sentences of at most 30 words."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import pytest

import workbench
from workbench.app.commands.command_table import COMMANDS
from workbench.core.code_labels import label
from workbench.core.schema import SCHEMA
from workbench.guide.api_page import FUNCTIONS, MEMBERS, PACKAGES, function_of, numerical
from workbench.guide.message_page import all_codes, entries
from workbench.guide.pages import FOLDER

ROOT = FOLDER.parents[1]

#: (pattern, what is wrong with it, what to write)
IDIOMS = (
    (r"\bis as good as\b", "a figure of speech", "say what happens"),
    (r"\bis refuted where\b.*\bof which\b", "a relative clause two clauses away", "two sentences"),
    (r"\bwhat is (?:left|said|printed) of\b", "the old idiom", "name the thing"),
    (r"\bof which (?:the|an?) (?:text|earlier|sentence)\b", "the old idiom", "name the thing first"),
    (r"\bwhatever (?:else )?(?:it|they|these) (?:is|are)\b", "a filler", "leave it out"),
    (r"\bmay be any\b(?! value)", "unclear", "may have any value"),
    (r"\bmade sure of\b", "unclear", "checked"),
    (r"\bdear\b", "not a technical term", "expensive"),
    (r"\bforget|forgotten\b", "a figure of speech", "discard"),
    (r"\bmend(?:s|ed|ing)?\b", "not a technical term", "correct"),
    (r"\b(?:Read|Cited|Judged) was\b", "an inversion", "subject before verb"),
    (r"\bbears? on\b", "unclear", "affects"),
    (r"\bso it (?:does|is)\b", "an inversion", "repeat the statement"),
    (r"\bthat is nothing else\b", "unclear", "that consists of this only"),
)
MOST_WORDS = 30
#: The members with a docstring of their own that are no routines.
DESCRIBED = (property, cached_property, classmethod, staticmethod)
_CODE = re.compile(r"^```(?s:.*?)^```$|^    .*$|^\|.*$|^#.*$|^>.*$", re.MULTILINE)
_INLINE = re.compile(r"`[^`\n]*`|\\\w+")


def prose(markdown: str) -> str:
    """The running text: without fenced blocks, tables and headings; inline code is one word."""
    return _INLINE.sub("X", _CODE.sub("\n\n", markdown))


def sentences(text: str) -> Iterator[str]:
    """Yields the sentences of running text; an entry of a list ends one."""
    for paragraph in re.split(r"\n\s*\n|^- |^\d+\. ", text, flags=re.MULTILINE):
        for sentence in re.split(r"(?<=[.!?:;])\s+", " ".join(paragraph.split())):
            if sentence:
                yield sentence


def texts() -> Iterator[tuple[str, str]]:
    """Yields (where, running text) of all that the style applies to."""
    yield "README.md", prose((ROOT / "README.md").read_text(encoding="utf-8"))
    for path in sorted(FOLDER.glob("*/*.md")):
        yield f"{path.parent.name}/{path.name}", prose(path.read_text(encoding="utf-8"))
    for code in all_codes().values():
        yield label(code), re.sub(r"\{\w*\}", "X", code.template)
    for name, entry in entries().items():
        yield f"messages.toml {name}", prose(" ".join((entry.get("meaning", ""), entry.get("way_out", ""))))
    for command in COMMANDS:
        yield f"summary of {command.name}", command.summary
    for table, keys in SCHEMA.items():
        yield f"schema {table}", "\n\n".join(key.meaning for key in keys)
    for name, noun in nouns():
        yield f"docstring of {name}", prose_of_docstring(inspect.getdoc(noun) or "")


def nouns() -> Iterator[tuple[str, Any]]:
    """Yields the public functions and classes with the members of their own, by name."""
    public = {name: getattr(workbench, name) for name in MEMBERS}
    for package in PACKAGES:
        public |= numerical(package)
    yield from ((name, function_of(name)) for name in FUNCTIONS)
    for name, noun in public.items():
        if callable(noun):
            yield name, noun
        for member, own in vars(noun).items() if inspect.isclass(noun) else ():
            if not member.startswith("_") and (isinstance(own, DESCRIBED) or inspect.isroutine(own)):
                yield f"{name}.{member}", own


def prose_of_docstring(text: str) -> str:
    """Returns the running text: without the session at its end; an argument begins a sentence."""
    return re.sub(r"^ *\w+: ", "\n\n", prose(text.split(">>>")[0]), flags=re.MULTILINE)


def all_docstrings() -> Iterator[tuple[str, str]]:
    """Yields (where, running text) of each docstring of the package."""
    for path in sorted((ROOT / "workbench").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Module) and (
                said := ast.get_docstring(node)
            ):
                yield f"{path.stem}, {getattr(node, 'name', 'the file')}", prose_of_docstring(said)


def long_sentences() -> list[str]:
    """Where sentences have more words than allowed, with how the sentence begins."""
    return [
        f"{where}: {' '.join(sentence.split()[:8])}"
        for where, text in texts()
        for sentence in sentences(text)
        if len(re.findall(r"\w+", sentence)) > MOST_WORDS
    ]


ALL_DOCSTRINGS = tuple(all_docstrings())


@pytest.mark.parametrize(("pattern", "why", "instead"), IDIOMS, ids=[row[0] for row in IDIOMS])
def test_no_text_uses_the_idiom(pattern: str, why: str, instead: str) -> None:
    found = [where for where, text in (*texts(), *ALL_DOCSTRINGS) if re.search(pattern, text)]
    assert found == [], f"{why}; write: {instead}"


def test_no_sentence_is_longer_than_30_words() -> None:
    assert long_sentences() == []


def test_how_to_pages_have_an_example() -> None:
    without = [
        path.stem
        for path in sorted((FOLDER / "howto").glob("*.md"))
        if "```" not in (text := path.read_text(encoding="utf-8"))
        and "Example" not in text
        and "workbench " not in text
    ]
    assert without == []


@pytest.mark.parametrize(
    ("text", "count"),
    [("One two. Three.", 2), ("- a b\n- c d", 2), ("A sentence: with a colon.", 2), ("", 0)],
)
def test_sentences_are_split(text: str, count: int) -> None:
    assert len(list(sentences(text))) == count
