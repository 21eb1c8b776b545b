"""Data types that every other room shares: terms, types, names, spans, reasons, verdicts.

What is this? Small immutable types, and the tables of codes and keys. When do I come here? To add an
operation, a property, a code or a key. What may it import? No other room. What checks it? tests/core,
tests/language.
"""
