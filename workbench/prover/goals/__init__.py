"""Proofs of statements with quantifiers: each rule, and what it leaves for `decide`."""
