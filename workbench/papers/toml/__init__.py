"""TOML files: what they say, and where in the author's text each entry stands."""
