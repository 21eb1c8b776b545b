"""Values of symbols as polynomials in time, its sine and its cosine."""
