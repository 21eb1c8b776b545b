"""Printing: terms to LaTeX, in canonical spelling or in that of an author."""
