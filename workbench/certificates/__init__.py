"""Exact claims as theorems that Coq's kernel checks."""
