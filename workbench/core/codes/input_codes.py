"""Codes of bad input: files, their entries, and the command line."""

from workbench.core.reasons import Code


class InputCode(Code):
    """Codes of bad input: files, their entries, and the command line."""

    FILE_NOT_FOUND = "no such file"
    FILE_UNUSABLE = "{message}"
    NOT_TOML = "not TOML: {why}"
    NOT_A_TEXT = "{fault}"
    NO_DISPLAY = "no displayed equation in it"
    UNKNOWN_KEY = "unknown key {key}; {hint}"
    VALUE_TYPE = "{key}: expected {expected}, got {got}"
    ENTRY_UNUSABLE = "{complaint}"
    OF_CLAIM = "{claim}: {message}"
    NO_CLAIM_SELECTED = (
        "{item} selects no claim; expected an equation (58), a range (45-70), an id (58.det), "
        "a section (4.1) or a pattern (58.*).{hint}"
    )
    NO_PAGE = "no page on {topic}. {hint}"
    COMMAND_LINE = "{what}"
