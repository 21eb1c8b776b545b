"""Statements with quantifiers, their proofs, and the reader of both."""
