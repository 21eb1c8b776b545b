"""The label of a code, with which a message ends: [WB-UNKNOWN-SYMBOL]."""

from __future__ import annotations

from workbench.core.reasons import Code, Reason


def label(code: Code) -> str:
    """Returns the label of a code, without brackets."""
    return f"WB-{code.name.replace('_', '-')}"


def telling_code(reason: str | None) -> Code | None:
    """Returns the code of a reason, or that of the only reason inside of it; None for a plain text."""
    if not isinstance(reason, Reason):
        return None
    inner = [each for each in reason.arguments.values() if isinstance(each, Reason)]
    return telling_code(inner[0]) if len(inner) == 1 else reason.code


def suffix(reason: str | None) -> str:
    """Returns what a message with this reason ends with: " [WB-…]", or "" for a plain text."""
    code = telling_code(reason)
    return "" if code is None else f" [{label(code)}]"


def coded(reason: str | None) -> str | None:
    """Returns the message with its code at the end; None for no reason."""
    return None if reason is None else f"{reason}{suffix(reason)}"
