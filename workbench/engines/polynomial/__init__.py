"""The polynomial engine: terms as matrices of polynomials over the rationals with a derivation (FLINT)."""
