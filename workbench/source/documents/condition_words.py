"""The words that say what the formula behind them does: one table for displays, for sentences and for drafts.

Each row holds the alternatives of a regular expression, longer ones first.
"""

from __future__ import annotations

import re

#: The formula defines a symbol.
LETS = "let|set|put"
DEFINES = f"{LETS}|define|denote|introduce|write|writing"
#: The formula explains the statement beside it: it defines a symbol, or is a condition.
EXPLAINS = "where|with|in which"
#: The statement is meant for the case that the formula holds.
CASES = (
    "provided|given|whenever|when|if|for|at|as long as|so long as|in case|in the case|case of|once"
    "|(?:special|limiting|particular|degenerate) case"
    "|(?:case|limit|situation|regime|instant|moment|position)s? (?:where|in which)"
    "|on condition that|on the assumption|under the (?:assumption|condition)|in the event"
    "|case [0-9ivxa-c]{1,4}|subject to|while"
)
#: The formula is supposed for what follows.
SUPPOSES = r"suppos\w+|assum\w+"
#: The words behind a display that begin another case.
CONTRASTS = "whereas|while|but|and|or|instead|conversely|alternatively|however"
#: The display behind these words is for one of several cases.
OF_CASE = r"if|when|in (?:the|this|that|such an?) (?:[\w-]+ )?case"
#: It is for a case, or for a value, or for all.
OF_CASE_OR_VALUE = f"{OF_CASE}|for"
#: It is for some values, as for small angles.
OF_VALUES = r"for (?!(?:the|each|all|every)\b)"
#: It replaces an earlier formula.
REPLACES = r"instead|alternative\w*|other"
#: It holds approximately.
APPROXIMATES = r"approximat\w*|small|negligible|linear\w*"
#: It is false.
DENIES = "not|never|wrong|incorrect"
#: The formula holds, and the statement beside it follows from it.
REASONS = "since|because|as"
#: The statement is meant for the case that the formula does not hold.
EXCEPTIONS = (
    "(?:unless|except|other than|apart from|excluding|with the exception of)"
    "(?: for| that| when| if| where| at| in case)?"
)
_WORDS = r"(?:\s+(?!(?:and|or|but|if|when|where|with|since|because|for)\b)[A-Za-z-]+){0,4}"
_NOT = r"(?:not|never|n['’]t|wrong|false|untrue|impossible|unnecessary|irrelevant)\b"
#: "It is not assumed that f = 0", "whether or not f = 0", "one might think that f = 0".
DENY_WHAT_FOLLOWS = (
    r"(?:\b(?:not|never|nor|neither|without|need not|cannot)(?:\s+(?:be|in general|yet|necessarily|even))?\s+"
    r"(?:assum|suppos|requir|need|use|using|demand|impos|mean|impl|follow|true|hold|necessar|claim|ask"
    r"|restrict|posit|the case|that|having|taking|setting|putting|say|so)[a-z]*"
    r"|\b(?:whether(?: or not)?|regardless of|irrespective of|no matter|contrary to|unlike|instead of"
    r"|rather than)"
    r"|\beven (?:if|for|when|where|though)"
    r"|\b(?:might|may|could|would) (?:think|believe|expect|suspect|suppose|guess|assume|hope)"
    r"|\b(?:wrong|false|incorrect|untrue)(?:ly)?)"
    rf"{_WORDS}\s*$"
)
#: "f = 0 is not needed", "f = 0, but this is wrong".
DENY_WHAT_PRECEDES = (
    rf"\s*(?:(?:is|are|was|does|do|need|must|may|can)\s*{_NOT}|cannot\b|(?:is|are|was)\s+{_NOT}"
    rf"|[,;]?\s*(?:but|which|and)\s+(?:(?:this|that|it|which)\s+)?(?:is|are|was|does|need)\s*{_NOT})"
)
#: What was supposed before does not reach the statement behind these words.
ENDS_CASE = (
    r"otherwise|(?:contrary|opposite|other|another|different|second|general|remaining)"
    r" (?:(?:special|limiting|particular) )?case|in contrast|on the contrary"
    r"|(?:without|dropping|lifting|removing|relaxing) (?:this|that|the|any|these|such)"
    r" (?:further |other )?(?:assumption|condition|restriction|constraint|hypothesis)s?"
)
#: The same for words behind the statement that was meant: "for all f" and "in general" in another sentence.
ENDS_CASE_OF_ANOTHER = r"in general|generally|for (?:all|any|every|arbitrary|general)|in any case|always"
#: What the sentence says counts in its section only.
IN_SECTION = r"(?:throughout|in|within|for) this (?:sub)*section"


def in_last_sentence(*words: str) -> re.Pattern[str]:
    """Returns the pattern of words in the last sentence of a text, such as that before a display."""
    return re.compile(rf"\b(?:{'|'.join(words)})\b[^.;]*$", re.IGNORECASE)
