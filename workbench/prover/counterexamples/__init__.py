"""Counterexamples: points at which a statement fails and its assumptions hold."""
