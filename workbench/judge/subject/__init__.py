"""What a statement is about, before any arithmetic: the one thing that the two engines share."""
