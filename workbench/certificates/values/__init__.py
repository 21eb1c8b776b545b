"""Values of symbols that are polynomials, sines and cosines of time."""
