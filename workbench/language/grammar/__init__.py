"""Grammar: from LaTeX to the bracket structure of a formula, by tokens, vocabulary, LALR grammar, syntax
nodes."""
