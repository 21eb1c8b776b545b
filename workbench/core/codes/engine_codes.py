"""Codes of formulas that the engines do not evaluate exactly."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class EngineCode(Code):
    """Reasons why an engine has no exact value for a part of a formula."""

    ANGLE_POWER = "a sine or cosine of the power of an angle, which may be meant for its power"
    EXPONENT = (
        "exp of anything but a purely dual argument, a skew tensor or a quaternion without a scalar part, or "
        "[x̃ v; 0 0]"
    )
    INVERSE_ANGLE = "an inverse function of an angle that does not stand alone on its side"
    NESTED_ANGLE = "a sine or cosine of what holds another one"
    NOT_EVALUATED = "{what}"
    NO_ANGLE = "the sine or cosine of anything but a rational combination of angles"
    PARTIAL_MAY_DEPEND = (
        "{name} in the partial derivative may depend on it; `of` says what it depends on, `independent` that "
        "it is a coordinate"
    )
    TWO_INVERSE_ANGLES = "two different inverse functions of angles"
