"""The two evaluators of terms, which share no arithmetic.

What is this? `polynomial` evaluates a term as a matrix of polynomials over the rationals with a derivation
(FLINT); `jet` evaluates it as the list of its time derivatives over any ring (SymPy on Python integers,
Drake's polynomials, doubles). `inventory` lists the free quantities of a statement and its side conditions:
the one thing that both use. When do I come here? To add an operation, in both. What may it import? core,
algebra, language, drake. Neither engine imports the other. What checks it? tests/judge/engines,
tests/judge/test_independence.py.
"""
