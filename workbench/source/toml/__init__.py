"""TOML files with the position of each key and value, for messages."""
