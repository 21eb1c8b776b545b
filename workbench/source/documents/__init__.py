"""Documents as their authors wrote them: every display, its number, and the position of each character.

What is this? `read_text` opens TeX (with macros, by `tex`), Markdown, reStructuredText, HTML and notebooks.
When do I come here? To add a format of texts (read_text.py), or a construct of TeX. What may it import? core,
language, and the rest of source. What checks it? tests/texts.
"""

from workbench.source.documents.folder_texts import texts_in
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
    "texts_in",
]
