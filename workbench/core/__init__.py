"""What all other packages share: reasons and their codes, the keys of files, the search for close names.

What is this? Tables and small types. When do I come here? To add a message, a code or a key.
What may it import? Nothing of ours. What checks it? tests/core.
"""
