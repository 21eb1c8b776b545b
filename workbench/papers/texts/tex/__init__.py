"""TeX itself: tokens with their origin, macros expanded, counters, and the displays of a document."""
