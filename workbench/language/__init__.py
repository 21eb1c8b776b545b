"""The claim language: LaTeX to typed terms, and terms to LaTeX.

What is this? `grammar` parses LaTeX into brackets, `naming` finds the symbols, `elaboration` builds typed
terms, `printing` writes them, `goals` reads statements with quantifiers and their proofs. When do I come
here? To teach the reader a spelling: a command or an accent in grammar/vocabulary.py, a script in
naming/spelling.py. What may it import? core. What checks it? tests/language, with one line for each reading
in tests/language/readings.
"""
