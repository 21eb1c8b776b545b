"""Codes of ill-formed formulas: types, sizes or weights do not match."""

from __future__ import annotations

from enum import StrEnum, unique

from workbench.core.reasons import Code


@unique
class TypeCode(Code):
    """Mismatches between the parts of a formula."""

    ABBREVIATED_SUMMAND = "{message}; is meant {usual}? a `reading` says it"
    ADDENDS_OF_DIFFERENT_WEIGHTS = "addends of the sum over {variables} differ in weight: {weight}"
    ARGUMENT_COUNT = "expected {expected} arguments, got {count}"
    ARGUMENT_WITH_WEIGHT = "the argument of a transcendental function has weight {weight}, expected 0"
    ATAN2_ARGUMENTS = "atan2 takes two real scalars of one weight"
    COLUMN_BESIDE_QUATERNION = "a column of four beside a quaternion, whose scalar part stands first"
    DEFINITION_OF_ANOTHER_TYPE = "{key} is a {kind}, its definition is a {defined}"
    DERIVATIVE_BY_VECTOR = "the derivative of a {type} by a {by} is not read: it has more than two indices"
    DIFFERENT_SIZES = "{message}; the sizes are {sizes}"
    DIFFERENT_TYPES = "{what} differ in type: {types}"
    DIFFERENT_WEIGHTS = "{what} differ in weight (power of 1/time): {weights}"
    DIVISION_BY_NO_SCALAR = "division by a {type}; expected a scalar"
    DIVISION_BY_QUATERNION = "division by a quaternion: from the left or from the right? write q^{{-1}}"
    DOTTED_OPERATOR = "the time derivative of an operator is written D ∘ P, not with a dot"
    DUAL_DEFINITION_OF_REAL = "{key} is real, its definition is dual"
    ENTRY_OF_NO_MATRIX = "expected matrices as entries of a matrix, got {type}"
    EXPECTED_ARGUMENT = "expected {article} {expected}, {place} a {type}"
    EXPONENTIAL = "the exponential of a {type} is not read"
    EXPONENTIAL_OF_VECTOR = "the exponential of a vector: of its skew tensor, or of a quaternion?"
    EXTREMUM_OF_DIFFERENT_TYPES = "what is least or greatest is a {type}, and the other side a {type_2}"
    EXTREMUM_OF_DIFFERENT_WEIGHTS = "the two sides differ in weight: {weight} and {weight_2}"
    EXTREMUM_OF_NO_SCALAR = "the least or greatest of a {type}; expected a real scalar"
    EXTREMUM_VARIABLE_OUTSIDE = "what a minimum or maximum is taken over stands on the other side too"
    FUNCTION_ARGUMENT_COUNT = "{name} takes {expected} arguments, got {count}"
    FUNCTION_ARGUMENT_TYPE = "{name} takes a {type}, got a {type_2}"
    FUNCTION_ARGUMENT_WEIGHT = "{name} takes an argument of weight {weight}, got {weight_2}"
    INDEX_COUNT = "{name} takes {indices} indices, got {count}"
    INTEGRAL_OF_OPERATOR = "an integral of an operator is not read"
    INVERSE = "the inverse of a {type}"
    LOGARITHM = "the logarithm of a {type}; of rotations, transforms and unit quaternions it is read"
    JUXTAPOSITION = "juxtaposition of a {left} and a {right} has no meaning"
    KRONECKER_OF_UNIT = "how large is the 0 or I beside ⊗? write its size below it"
    MATRIX_PRODUCT = "matrix product of {left} and {right}"
    MEMBER_DECLARED_APART = "{member} is declared apart, as no member of {name}"
    MEMBER_OF_ANOTHER_TYPE = "a member of {name} is a {type}; here it is a {type_2}"
    MULTINOMIAL_PARTS = "multinomial of {top} with the parts {parts}; they must add up to {top}"
    NABLA_OF_OTHER_PLACE = "∇{sign} of a {type}, where the place is a {type_2}"
    NEGATIVE_EXPONENT = "power with negative exponent {exponent}; an inverse is written ^{{-1}}"
    NEGATIVE_INDEX = "{name} with the negative index {value}"
    NEGATIVE_NUMBER = "{name} of the negative number {top}"
    NEGATIVE_ORDER = "derivative of negative order {order}"
    NO_LETTER_LEFT = "no letter is left to rename the summation variable {name}"
    NUMBER_TOO_LARGE = "{name} of {top}; at most {most} is supported"
    ODD_POWER_OF_VECTOR = "an odd power ({exponent}) of a vector; x² means x·x"
    OPEN_ZEROS = "{message}; is meant a row or column of more zeros? a `reading` says it"
    OPERATOR_BESIDE_TENSOR = "an operator applied to a tensor, or their product?"
    OPERATOR_ON_SCALAR = "an operator with tensor coefficients acts on a vector or a tensor, got a scalar"
    PARTIAL_DERIVATIVE_BY = (
        "the partial derivative by a {type} is not read; that by a scalar, a column or a matrix is"
    )
    PARTIAL_DERIVATIVE_OF_OPERATOR = "the partial derivative of an operator"
    POWER = "a power of a {type}"
    PRODUCT_OF_SIZES = "the product of a matrix {sizes} and a matrix {sizes_2}"
    QUATERNION_OF_DIFFERENT_WEIGHTS = "the parts of a quaternion differ in weight: {weights}"
    REACH_OF_OPERATOR = "how far does the operator reach? bracket what it acts on"
    REAL_PART_OF_DUAL_QUATERNION = "Re of a dual quaternion: its real part, or its scalar part?"
    ROOT = "the root of a {type} is not read"
    ROOT_OF_WEIGHT = "the root of a quantity of weight {weight}"
    ROW_OF_ZEROS = "{message}; a row of zeros is written 0_{{1 \\times {size}}}"
    SETS_AS_VALUES = "the values of the map are sets, but its codomain is not a set of sets"
    SIZE_OF_MATRIX = "the size of the matrix is {both}"
    TENSOR_UNDER_TILDE = "expected a vector under the tilde, got a tensor"
    TOO_MANY_ADDENDS = "a sum of {addends} addends; at most {most} are written out"
    TRANSPOSE = "the transpose of a {type}"
    UNDEFINED_MEMBER = "{shown} is not defined; defined: {known}"
    UNEQUAL_BLOCKS = "{what} {number} of the matrix holds blocks of size {size} and {size_2}"
    UNEQUAL_ORDERS = "a derivative of order {above} above and {sum} below"
    UNEQUAL_ROWS = "the rows of a matrix have unequal lengths"
    UNEQUAL_TIME_ORDERS = "d/dt of order {orders} above and {orders_2} below"
    UNIT_MATRIX_NOT_SQUARE = "a unit matrix of the size {sizes}; it is square"
    UNIT_TENSOR_BESIDE_OTHERS = "{what} differ in type: the unit tensor and {shape}"
    UNIT_TENSOR_IN_ONE_ROW = "the unit tensor in a place of one row and one column"
    VEC = "vec of a {type}: it stacks the columns of a matrix"
    ZERO_OF_ANOTHER_SIZE = "a zero printed with the size {size} in a place of the size {place}"


class Compared(StrEnum):
    """The terms that must have one type and weight: the argument `what` of a fault."""

    SIDES = "the two sides"
    ADDENDS = "the addends"


#: Codes of products, operations and equations whose kinds do not match.
UNFIT_KINDS = frozenset(
    {TypeCode.DIFFERENT_TYPES, TypeCode.UNIT_TENSOR_BESIDE_OTHERS, TypeCode.JUXTAPOSITION, TypeCode.TRANSPOSE}
)
