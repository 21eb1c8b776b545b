"""The standard formulas of the field, and the formulas of a text that are usual misprints of them.

What is this? Each .toml file has formulas of one subject, with the words by which texts speak of them.
When do I come here? To add a formula, or a subject. What may it import? What drafting may.
What checks it? tests/ingest/test_formulary.py proves each formula.
"""
