"""From LaTeX to the brackets of a formula: tokens, vocabulary, LALR grammar, syntax nodes."""
