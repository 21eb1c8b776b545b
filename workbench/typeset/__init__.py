"""LaTeX as its readers see it: what a formula is made of, and what differs between two of them."""
