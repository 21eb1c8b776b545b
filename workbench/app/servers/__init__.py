"""Long-lived processes that judge a text whenever it changes: for editors, assistants, and `--watch`."""
