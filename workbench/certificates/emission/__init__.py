"""Typed terms as expressions of Coq, and what their symbols are."""
