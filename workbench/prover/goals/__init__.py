"""Proofs of statements with quantifiers: the rules, and the obligations that they leave for `decide`."""
