"""Exact claims as theorems that Coq's kernel checks.

What is this? `emission` writes a claim as Coq text, `goals` joins the steps of a proof, `values` gives
motions on which false claims fail, `reading` reads the text back and compares it with the claim; `coq` holds
the library. When do I come here? To certify a new kind of claim. What may it import? core, language, algebra,
prover. What checks it? tests/certificates, Coq itself, and the tampering campaign.
"""
