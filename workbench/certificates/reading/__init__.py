"""The text of a theorem, read back and compared with its terms."""
