"""Syntax nodes to typed terms, one module for each part of the notation. `elaborate` calls the others."""
