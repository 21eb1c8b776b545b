"""Long-lived processes that judge a text as it changes: for editors, assistants, pages, and `--watch`."""
