"""What a paper names: its symbols, their spellings, its notation, and what is in scope."""
