"""The splitter of displays: from the tokens of a display to its statements and their steps."""
