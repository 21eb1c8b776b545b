"""Facts known of a claim's symbols, each with origin, strength, duration and symbols.

What is this? The types of claims and facts, and the providers of facts: the model, formulas, conditions and
sentences of the text, conventions of the field. When do I come here? To add a convention (conventions.py), a
word (lexicon.py) or a property (core/properties.py). What may it import? core, language, source, engines.
What checks it? tests/context.
"""
