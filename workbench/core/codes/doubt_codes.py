"""Doubts: what may be meant so that a falsehood is none. A message names them behind "unless"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import unique
from functools import reduce

from workbench.core.reasons import Code, Reason


@unique
class DoubtCode(Code):
    """The codes of doubts. A doubt is a part of a sentence, so that it is shown without its code."""

    JOINED = "{doubt}; {other}"
    FACTS = "{facts}"
    MORE_IS_SAID = "the text says more: {fact}"
    NOT_DECIDED_WITH = "not decided with {fact}"
    NOT_DECIDED_UNDER = "not decided under {facts}"
    NOT_WITHIN = "decided only where not {fact}"
    NOT_TRIED = "something holds that was not tried: too much is known of it"
    OTHER_CASE = "it is another case than {fact}"
    SAYS_WHAT_IS = "it says what {symbol} is"
    SAYS_WHAT_IS_DESPITE = "it says what {symbol} is, and not {hints}"
    SAYS_WHAT_SYMBOLS_ARE = "it says what its symbols are"
    GUESSED_KINDS = "the guessed kinds are others"
    DRAFTED_KINDS = "the drafted kinds are others"
    SOMETHING_ELSE = "{name} is something else"
    OTHER_QUANTITY = "it is not for the {name}"
    UNIT_STEP = "1 is the unit step"
    NAME_OF_FUNCTION = "{word} is the name of a function"
    LABEL_OF_FRAME = "the superscript 0 is that of a frame"
    SIZES_OF_BLOCKS = "its blocks have other sizes"
    BLOCK_OF_ZEROS = "0 is a block of zeros"
    MAGNITUDES = "its letters are magnitudes of vectors"
    TO_SOLVE = "it is an equation to solve"
    OF_A_SET = "it selects the members of a set"
    OTHER_BRANCH = "its roots and angles are meant on another branch"
    POSITIVE = "its symbols are positive"
    IMAGINARY_UNIT = "{name} is the imaginary unit"
    RATE_AT_PLACE = "its rate is that at the place of {term}"
    VALUE_IN_EXAMPLE = "{symbol} is its value in an example"
    VALUE_AT_ONE = "{symbol} is its value at one {name}"
    NOTATION_MISREAD = "the notation is misread, as {count} formulas do not fit"
    QUATERNIONS_OF_JPL = "quaternions are multiplied as JPL does (i j = -k)"
    TRANSPOSED_ROTATIONS = "rotations take columns the other way (the transpose, active or passive)"
    OTHER_PERTURBATION = "small rotations act from the other side (left or right perturbation)"
    OTHER_JACOBIAN = "angular velocities are seen from the other side (left or right Jacobian)"
    OTHER_TWISTS = "twists have their linear and angular parts in the other order"
    OTHER_GRADIENT = "the gradient is the other one of row and column"
    OTHER_DOTS = "a dot differentiates in another frame"


def as_one_doubt(doubts: Iterable[Reason]) -> tuple[Reason, ...]:
    """Returns the doubts as a single one, which lowers a grade once; () without a doubt."""
    each = dict.fromkeys(doubts)
    return (reduce(lambda one, other: DoubtCode.JOINED(doubt=one, other=other), each),) if each else ()


def single_doubts(doubt: Reason) -> Iterator[Reason]:
    """Yields the doubts of which `as_one_doubt` made one."""
    return (part for part in doubt.parts() if part.code is not DoubtCode.JOINED)
