"""The search for the right form of a claim, from its printed form to proved proposals."""
