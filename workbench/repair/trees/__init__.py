"""Edits of syntax trees, for formulas that have no type as printed."""
