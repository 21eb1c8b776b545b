"""Inference of the kinds of symbols from the formulas in which they occur."""
