"""The symbols of a paper: declarations, spellings, notations, and the scope in which a formula is read."""
