"""Kinds of symbols, inferred from the formulas that they stand in."""
