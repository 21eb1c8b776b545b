"""What a statement is about, before any arithmetic: the one thing that the two engines share."""


class NotExact(ValueError):
    """The term is well-formed but outside the exact world; the message says which part and why."""
