"""Exact arithmetic: polynomials with a derivation, matrices, dual numbers, dual tensors and functions.

What is this? Rings built on python-flint. When do I come here? To compute exactly. What may it import? core.
What checks it? tests/algebra, by the axioms of rings.
"""
