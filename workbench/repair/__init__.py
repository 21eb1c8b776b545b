"""Repair: searches the right form of a formula that is false or ill-formed as printed, and proves it.

What is this? `terms` edits typed formulas and `trees` syntax trees, `screening` tests the candidates at
random points, `propose` runs the search; `author_edits` maps a proposal to the author's source. When do I
come here? To add a kind of misprint (terms/variants.py, trees/lost_marks.py). What may it import? core,
runtime, language, source, engines, context, prover. What checks it? tests/repair.
"""

from workbench.core.callable_package import make_callable

make_callable(__name__, "workbench.app.api:repair")
