"""What a syntax tree says: each form of the notation as typed terms, with the symbols of a table."""
