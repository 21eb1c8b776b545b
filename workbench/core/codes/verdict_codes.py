"""Codes of verdicts: why a claim is not judged, fails, or holds only under a condition."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class VerdictCode(Code):
    """Reasons of a verdict."""

    ANOTHER_VALUE = "the {word} value is another one"
    ARGUED = "{how}"
    AT_ONE_INSTANT = (
        "false if the condition holds at one instant only; if it lasts, state its derivatives too"
    )
    AT_ONE_PLACE = "false if the condition holds at one place only; if everywhere, state its derivatives too"
    BEYOND_THE_VALUE = "there it is {what} than what is said to be the {word} value"
    CONDITION_IS_THE_CLAIM = (
        "{formula} is the condition beside it and states the formula itself, which proves nothing; "
        "without it the formula is not shown"
    )
    CONTRADICTORY_PREMISES = "its premises contradict each other, or no example of them was found"
    CONTRADICTS_DEFINITIONS = "the condition contradicts what defines its symbols"
    DEFECT = "a defect of the workbench: {error}"
    DENOMINATOR_CAN_VANISH = "{denominator} can vanish"
    DENOMINATOR_NOT_EXCLUDED = "{denominator} can vanish, and nothing that the claim assumes excludes it"
    DENOMINATOR_OPEN = "{denominator} is not seen to be non-zero, and no point was found where it vanishes"
    DENOMINATOR_ZERO = "a denominator is identically zero"
    DIFFERENT_TO_FIRST_ORDER = "to first order the sides differ; to order 0 is open"
    EMPTY_SET = "the set is empty: nothing satisfies its conditions"
    EMPTY_SIDE = "nothing satisfies one of its sides"
    ENDLESS_RANGE = "no proof for all of the endless range of {variables} was found"
    ENGINES_DISAGREE = "a defect of the workbench, its engines disagree: {error}"
    EQUAL_IN_PLACES = "the sides are equal in places: are they said to differ always, or in general?"
    EXPECTED_TO_FAIL = "expected {statement} to fail somewhere, got {outcome}"
    FAILS_FOR_SOME_SUMS = (
        "fails for some sums, which it may say something of, or where two indices are the same"
    )
    FALSE_WITHOUT_NEIGHBOUR = (
        "false without {formulas}, which stands beside it; an `assume` of it makes it a condition"
    )
    FITS = "fits by its types; nothing here tells it from other forms that fit"
    FOR = "for {values}"
    FOR_BECAUSE = "for {values}: {reason}"
    FOR_THOUGH_HOLDS = "for {values}, though it holds for {orders}"
    GIVEN_IS = "{reason}; given is {given}"
    GIVEN_IS_FALSE = "{formula} is given, and false by itself"
    GOAL_NOT_SHOWN = "the goal is not shown: {why}"
    HOLDS_FOR = "holds for {orders}"
    HOLDS_WITH_NEIGHBOUR = "holds if {formulas}, which stands beside it"
    LAW_NOT_COMPARED = (
        "states a law for {name}; it took too long to decide whether the law follows from what is known of it"
    )
    LEFT_OUT = "left out: {why}"
    LIMITS = "under the equations something may be 0 at which a sine or an exponential is a limit here"
    MAY_BE_CONDITION = "may be the condition of {formula}, which stands before it and is false without it"
    MOTIONS_CONTRADICT = "proved, but Drake's motions contradict it: a binding or the workbench is wrong"
    NEEDED_ONCE = (
        "{outcome} if {kinds}, which only this formula needs; if {name} is a {other}, this formula is wrong"
    )
    NEGATIVE_NORM = "a norm is not negative"
    NESTS_TOO_DEEP = "what it is made of nests too deep for the engines"
    NOT_AS_DRAFTED = "does not fit the drafted kinds and notation: {reason}"
    NOT_DEFINED_FOR_ALL = "{left} is not seen to be defined for all of these: {reason}"
    KEPT_IN_INTEGRAL = "what stands before the sign is the same throughout the integral"
    NOT_FROM_LINEARITY = "it does not follow from the linearity of the integral"
    NOT_FROM_FUNCTIONS = "neither follows from what is known of its functions, nor fails at a real point"
    NOT_SHOWN = "not shown"
    NO_BOUND = "it has no bound"
    NO_COUNTEREXAMPLE = "the residual is not 0 in the exact ring, but no small counterexample was found"
    NO_POINT_FOUND = "no point was found where the assumptions hold and no denominator vanishes"
    NO_RANGE = "no range is stated for {variables}"
    NO_WITNESS = "no witness against the bare statement was found"
    NO_ZERO_FOUND = "no zero was found and none was excluded"
    PLACES_MAY_BE_ONE = (
        "it fails only where two places of one function are the same, as f(x) and f(y) at x = y"
    )
    OF_FRAMES = (
        "{outcome} for free frames and points; `orientation` in [frames] and `fixed` in [points] say more"
    )
    OF_ONE_SIZE = "{outcome} for n = 2, but {other} for n = {size}; the text does not say how large n is"
    OF_SQUARES = "{reason}; the two sides are given as squares"
    ON_PRINCIPAL_BRANCH = "holds on the principal branch, which the text does not state"
    OPEN_WHERE_POSITIVE = "not decided where {name} is positive"
    OUTSIDE_OF_ARC = "outside of the arc's domain it is undefined"
    OUT_OF_BUDGET = "{limit}"
    SAME_TERM = "both sides are the same term, so nothing is tested"
    SECOND_ENGINE_LEFT_OUT = "second engine left out"
    SECOND_ENGINE_OPEN = "the second engine does not see that the equations imply it"
    SEEN_OF_SOME = "{seen}; {why}"
    SIGN_OF_FORM_OPEN = "the quadratic form is not seen to have one sign"
    SIGN_OF_NORM_OPEN = "a norm is not negative, and the other side is not seen to be ≥ 0"
    SINGULAR_PART = "shown only where what multiplies the unknowns has the rank that it has in general"
    STATES_A_LAW = "states a law for {name}, which nothing here defines; to use it, assume or define {name}"
    STEP_NOT_SHOWN = "the goal is not shown: {rule}: {formula} is {outcome}"
    STEP_NOT_SHOWN_BECAUSE = "the goal is not shown: {rule}: {formula} is {outcome}: {reason}"
    TIED_ON_MOTIONS = "it holds on Drake's motions, where the bound symbols are tied as they are not here"
    TWO_OF_THEM = "both {one} and {other} do"
    TWO_READINGS = "{question}"
    UNDECIDED_MEMBERS = "whether all members of {set} are so is not decided"
    UNDER_HYPOTHESIS = "holds under a hypothesis that the text does not state"
    UNSATISFIABLE = "no values of the symbols satisfy the assumptions"
    UP_TO_BRANCH = "holds up to the branch: where {branch}"


#: Codes of claims that are false if the premise holds at one instant or place, and undecided if it lasts.
UNLESS_IT_LASTS = frozenset({VerdictCode.AT_ONE_INSTANT, VerdictCode.AT_ONE_PLACE})

#: Codes that report no fault: the author can supply the missing information.
WAITS_FOR_ITS_AUTHOR = frozenset(
    {
        VerdictCode.STATES_A_LAW,
    }
)


@unique
class ResultCode(Code):
    """Ways in which a verdict differs from the expected one."""

    SEVERAL = "{first}; {second}"
    UNEXPECTED = "{form}: expected {expected}, got {got}"
    UNEXPECTED_BECAUSE = "{form}: expected {expected}, got {got} ({reason})"
    WITHOUT_EVIDENCE = "{form}: proved without evidence"
