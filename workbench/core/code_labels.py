"""The labels of codes, which end each message: [WB-UNKNOWN-SYMBOL]."""

from __future__ import annotations

from workbench.core.reasons import Code, Reason


def label(code: Code) -> str:
    """Returns the label of a code, without brackets."""
    return f"WB-{code.name.replace('_', '-')}"


def telling_code(reason: str | None) -> Code | None:
    """Returns the code of a reason, or that of its only inner reason; None for plain text."""
    if not isinstance(reason, Reason):
        return None
    inner = [each for each in reason.arguments.values() if isinstance(each, Reason)]
    return telling_code(inner[0]) if len(inner) == 1 else reason.code


def label_of(reason: str | None) -> str:
    """Returns the label of the code that a reason tells, or "" for plain text."""
    code = telling_code(reason)
    return "" if code is None else label(code)


def suffix(reason: str | None) -> str:
    """Returns the suffix of a message with this reason: " [WB-…]", or "" for plain text."""
    own = label_of(reason)
    return f" [{own}]" if own else ""


def coded(reason: str | None) -> str | None:
    """Returns the reason's message with its label at the end; None if there is no reason."""
    return None if reason is None else f"{reason}{suffix(reason)}"
