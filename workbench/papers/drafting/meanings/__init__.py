"""What the symbols of a text mean by its words and by its other formulas, beside their first formulas."""
