"""Codes of unusable entries in [symbols], [definitions] and [notation]."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class DeclarationCode(Code):
    """Faults of an entry of [symbols], [definitions] or [notation]."""

    ALIASES_EXPECTED_LIST_LATEX = "aliases is {found}; expected a list of LaTeX names"
    ARGUMENT_OF = "of: {text} is {value}"
    CAN_MATCH_SAME_TERM = "it can match the same term as {key}"
    DECLARED_DEFINITION_NEED_NOT = "declared as {flag}, which a definition need not keep"
    DECLARED_TWICE = "{alias} is declared twice{why}"
    DECLARE_WHOLE_FAMILY_SYMBOLS = "declare the whole family in [symbols]: kind, and weight in its index"
    DEFINES_SO_DOES_EACH = "defines {both}, and so does {known}; each member needs one definition"
    DEFINITION_USES_SYMBOL_ITSELF = "its definition uses the symbol itself"
    EACH_INDEX_PLACE_NEEDS = "each index place needs a letter of its own"
    EXPECTED_LETTER_GOT = "expected a letter, got {text}"
    EXPECTED_LIST_SYMBOLS_SUCH = "of is {names}; expected a list of symbols such as ['q', 't']"
    EXPECTED_ONE_MEANING = "expected one expression, got {text}"
    EXPECTED_ONE_SYMBOL = "expected one symbol"
    EXPECTED_ONE_SYMBOL_LETTER = "expected one symbol: a letter with its font and scripts"
    EXPECTED_TABLE_SUCH_KIND = 'expected a table such as {{ kind = "vector" }}, got {spec}'
    EXPECTED_TRUE_OR_FALSE = "{flag} is {spec}; expected true or false"
    EXPECTED_WHERE_X_VECTOR = "expected {{ where = {{ x = \"vector\" }}, means = '…' }}, got {spec}"
    FAMILY_MAY_DECLARE_SYMBOLS = "the family may be {kinds}; declare it in [symbols]"
    FAULT_AT_COLUMN = "column {value}: {fault}"
    FAULT_IN_MEANING = "{text}, column {value}: {fault}"
    FAULT_OF_ALIAS = "alias {alias}: {error}"
    FAULT_OF_ARGUMENT = "of: {text}: {message}"
    FLAG_OF_OTHER_KINDS = "{flag} is for a {kinds}, not for a {plain}"
    FORMAL_ARGUMENTS_MUST_DIFFER = "the formal arguments must differ"
    FORMAL_ARGUMENT_MUST_SYMBOL = "a formal argument must be a symbol that is declared, without an index"
    FUNCTION_ITSELF = "of: {name} is a function of itself"
    HAS_INDEX_PLACES_NOT = "{alias} has {places} index places, not {index}"
    INDEX_EXPECTED_NUMBER_OR = "the index {place}; expected a number, or one letter plus a number"
    INDICES_DIFFER_FROM_THOSE = "the indices of {alias} differ from those of {key}"
    LETTER_NOT_IN_MEANING = "where: {letter} does not stand in what it means"
    LETTER_NOT_IN_NOTATION = "where: {letter} does not occur in the spelling"
    NOTATION_WITHOUT_ARGUMENTS = "a notation without arguments is {symbol}"
    NO_DECLARED_SYMBOL = "of: {text} is no declared symbol"
    NO_FORMULA_SEARCHED_THIS = "no formula is searched for this; expected {FORMS}"
    NO_SCALAR_NO_COLUMN = "of: {text} is no scalar and no column of scalars"
    OF_ENTRY = "{key}: {message}"
    POSITIVE_REAL_SCALARS = "positive is for real scalars"
    READ_SKEW_TENSOR_DECLARE = "it is read as a skew tensor; declare it in [symbols]"
    REAL_QUANTITIES_WHOSE_VALUES = "of is for real quantities whose values are free, not for {what}"
    REFUSED = "{message}"
    SCRIPTS_NOT_PART_NAME = "its scripts are not part of a name"
    SKEW_TENSOR_VECTOR_SYMBOL = "it is the skew tensor of a vector; a symbol of the paper needs another name"
    SMALL_REAL_QUANTITIES_WHOSE = "small is for real quantities whose values are free"
    SUPERSCRIPT_WOULD_READ_TRY = "the superscript {sup} would be read as {meaning}; try ^{{[n]}}"
    SYMBOL_KNOWN = "this symbol is known already"
    SYMBOL_KNOWN_AS_MEMBER = "this symbol is known already, as a member of {family}"
    SYMBOL_PAPER_NEEDS_ANOTHER = "{name} is {meaning}; a symbol of the paper needs another name"
    THIS_SYMBOL_DEFINED_ALREADY = "this symbol is defined already"
    TRANSFORM_REAL_DUAL_ROTATION = "a transform is real; a dual rotation stands for the same motions"
    UNKNOWN_KEY_ALLOWED = "unknown key {unknown}; allowed: {ALLOWED}"
    UNKNOWN_KIND = "kind is {kind}; expected {allowed}"
    USED_ABOVE = "this symbol is used above its definition"
    WEIGHT_EXPECTED_INTEGER = "weight is {weight}; expected an integer{of}"
    WHERE_EXPECTED_KINDS_LETTERS = 'where: expected kinds of letters such as {{ x = "vector" }}'
    WHERE_EXPECTED_KIND_SUCH = "where: {letter} is {kind}; expected a kind such as vector"
