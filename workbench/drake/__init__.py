"""Drake: plants, reference motions, and the symbols that are bound to them.

What is this? The only package that imports pydrake, by gate.py. When do I come here? To add a quantity of
motions (quantities.py, bindings.py). What may it import? core. What checks it? tests/drake.
"""
