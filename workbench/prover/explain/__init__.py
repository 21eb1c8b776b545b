"""Explanation: decides a claim under its declared, stated, hinted and guessed facts. `explain` is the
entry."""
