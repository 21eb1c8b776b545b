"""Reading back: the text of a theorem is parsed and compared with its terms."""
