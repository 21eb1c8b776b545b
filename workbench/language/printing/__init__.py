"""Terms to LaTeX: canonically, or in the spelling of an author."""
