"""Formulas as readers see them: atoms, glyphs, excerpts, and the difference of two formulas."""
