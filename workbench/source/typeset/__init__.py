"""Printed formulas: atoms, glyphs, excerpts, and the difference of two formulas."""
