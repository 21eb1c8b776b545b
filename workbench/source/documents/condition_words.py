"""The words that say what the formula behind them does: one table for displays, for sentences and for drafts.

Each row holds the alternatives of a regular expression, longer ones first.
"""

from __future__ import annotations

#: The formula defines a symbol.
LETS = "let|set|put"
DEFINES = f"{LETS}|define|denote|introduce|write|writing"
#: The formula explains the statement beside it: it defines a symbol, or is a condition.
EXPLAINS = "where|with|in which"
#: The statement is meant for the case that the formula holds.
CASES = (
    "provided|given|whenever|when|if|for|at|as long as|so long as|in case|in the case|case of|once"
    "|on condition that|subject to|while"
)
#: The formula is supposed for what follows.
SUPPOSES = r"suppos\w+|assum\w+"
#: The formula holds, and the statement beside it follows from it.
REASONS = "since|because|as"
#: The statement is meant for the case that the formula does not hold.
EXCEPTIONS = (
    "(?:unless|except|other than|apart from|excluding|with the exception of)"
    "(?: for| that| when| if| where| at| in case)?"
)
