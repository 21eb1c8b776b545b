"""Elaboration: syntax nodes to typed terms, one module for each part of the notation. `elaborate` is the
entry."""
