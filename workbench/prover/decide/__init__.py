"""Decides one statement: both engines, families in n, extrema, inequations, branches, zero sets."""
