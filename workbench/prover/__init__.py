"""Verdicts: from a statement and its context to an outcome with evidence.

What is this? `decide` judges one statement with both engines; `goals` checks proofs of statements with
quantifiers; `counterexamples` finds points where a statement fails; `motions` evaluates statements on Drake's
motions, which may veto a proof; `explain` decides a claim under its facts, weakest last; `results` holds the
results. When do I come here? To change what counts as a proof. What may it import? core, language, source,
engines, drake, context. What checks it? tests/judge; `workbench help trust` lists the trusted files.
"""
