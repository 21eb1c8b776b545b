"""From LaTeX text to the bracket structure of a formula, and how each form is written."""
