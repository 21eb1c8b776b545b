"""The kinds and sizes of the symbols of a text, inferred from all of its formulas together."""
