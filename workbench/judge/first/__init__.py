"""The first engine: terms as matrices of polynomials over ℚ with a derivation, in FLINT."""
