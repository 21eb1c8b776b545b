"""Terms back to LaTeX: canonically, or in the author's own spelling."""
