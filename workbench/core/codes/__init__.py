"""Codes of messages, one module per subject. A code has a template with named arguments."""
