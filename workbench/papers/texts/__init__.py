"""Texts as their authors wrote them: every display, its number, and where each character of it stands."""

from workbench.papers.texts.read import SUFFIXES, is_text, read_text
from workbench.papers.texts.tex.displays import Display, Row
from workbench.papers.texts.tex.document import Text
from workbench.papers.texts.tex.files import Directive
from workbench.papers.texts.tex.tokens import Token, joined, spelled
from workbench.papers.texts.view import Source, View

__all__ = [
    "SUFFIXES",
    "Directive",
    "Display",
    "Row",
    "Source",
    "Text",
    "Token",
    "View",
    "is_text",
    "joined",
    "read_text",
    "spelled",
]
