"""Edits of typed terms: coefficients, factors, addends, entries of matrices."""
