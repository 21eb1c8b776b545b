"""Decisions on one statement: both engines, families in n, extrema, disequations, branches, zero sets."""
