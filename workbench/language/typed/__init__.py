"""Typed terms: integers, names and types, the operations, and the functions that build terms."""
