"""TeX: tokens with their origin, macros, conditionals, counters, and the displays of a document."""
