"""Operators of calculus and algebra as printed: sums, integrals, derivatives, extrema, determinants."""
