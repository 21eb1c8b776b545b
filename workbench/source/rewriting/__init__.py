"""Rewriting of the formulas of texts to the claim language: layout commands, plain TeX, other tools' TeX.

What is this? Rules on tokens that normalize the habits of authors, and keep the position of each character.
When do I come here? To support a spelling of texts (author_habits.py, plain_tex.py). What may it import?
core, language, source/documents. What checks it? tests/texts.
"""

from workbench.source.rewriting.rewrite import argument, respelled

__all__ = ["argument", "respelled"]
