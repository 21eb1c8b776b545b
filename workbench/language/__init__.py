"""The claim language: LaTeX text to typed terms, and back to LaTeX."""
