"""Goals with quantifiers as one theorem: their statement, and their proof joined from its steps."""
