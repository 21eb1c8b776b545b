"""Codes of verdicts that depend on the text around a formula."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class ContextCode(Code):
    """Reasons that come from the context of a formula."""

    ASSIGNS = "assigns a value: left of := stands the value after the one on its right"
    DEFINES = "defines {symbol}"
    POSTULATES = "postulates a law of {symbol}"
    CONSTRAINS = "says what {symbol} is, which stands in no definition"
    LACKS_PROPERTY = "the text says “{words}” of {symbol}, and for this matrix M, {equation} fails"
    HOLDS_BY = "holds by {facts}"
    GIVEN_OTHERWISE = "{facts} gives {symbol} already"
    BY_DEFINITIONS = "by what the text gives for {symbols}"
    UNUSUAL = "the usual formula for the {name} is {formula} ({source})"
    FOR_KNOWN_MEMBERS = "holds for {orders}, the members that the definitions hold"
    FALSE_IF_KINDS = "false if {kinds}{reason}"
    HOLDS_IF_KINDS = "holds if {kinds}{reason}"
    SCOPE_UNKNOWN = "{outcome} if no [[scope]] stands before it; say where each begins"
    ROUNDED = "the sides differ by no more than its decimals may be rounded by"
    NONE_WITHIN_BOUNDS = "false without {facts}, and no counterexample that meets it was found"
    OF_PI = "false for some values of \\pi; if it is the number, that says nothing"
    REACH = "how far does d/dt reach? bracket what it differentiates"
    OF_QUATERNIONS = "holds for quaternions without a scalar part; declare them so, if the text means them"
    TWO_INDICES = "{symbol}: by its number, or by two indices? a definition or `free = true` of it says so"
