"""Decides a claim under its facts: declared, stated, hinted, guessed. `explain` is the one entry."""
