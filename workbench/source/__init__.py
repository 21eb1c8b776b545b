"""Documents to displays and sentences, with the position of each character.

What is this? `documents` opens TeX (with its macros), Markdown, reStructuredText, HTML and notebooks; `rows`
splits a display into statements and steps; `rewriting` normalizes the habits of authors; `toml` reads models
with positions; `typeset` compares printed formulas. When do I come here? To add a format of texts
(documents/read_text.py) or an environment (rows/display_vocabulary.py). What may it import? core, language.
What checks it? tests/texts.
"""
