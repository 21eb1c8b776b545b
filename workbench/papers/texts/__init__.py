"""The claims of a text: one for each step of its displays, with its model or its comments."""
