"""Texts as their authors wrote them: every display, its number, and where each character of it stands."""

from workbench.source.documents.read_text import SUFFIXES, is_text, read_text
from workbench.source.documents.source_view import Source, View
from workbench.source.documents.tex.displays import Display, Row
from workbench.source.documents.tex.tex_document import Text
from workbench.source.documents.tex.tex_files import Directive
from workbench.source.documents.tex.tex_tokens import Token, joined, spelled

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
