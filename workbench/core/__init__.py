"""Data that all other packages share: reasons and their codes.

What is this? Types without behaviour of their own. When do I come here? To add a message or a code.
What may it import? Nothing of ours. What checks it? tests/core.
"""
