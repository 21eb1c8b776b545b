"""Edits of syntax trees, for formulas that are ill-typed as printed."""
