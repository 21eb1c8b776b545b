"""Statements for all n at once: by symbolic orders, recurrences and unbounded indices."""
