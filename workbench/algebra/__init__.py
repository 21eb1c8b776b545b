"""Exact worlds: polynomials with a derivation, matrices, dual numbers, tensors and functions."""
