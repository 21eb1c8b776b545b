"""Declarations from the entries of [symbols]: the name from the LaTeX key, the properties from its table."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.formula_errors import Fault, SpecError
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.properties import EVERY, FLAGGED
from workbench.core.schema import flag_names, key_names
from workbench.core.types import CLOCK, KINDS, Declaration, Type, Weight, type_of_kind
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Accented,
    Chain,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    as_letter,
    both_below,
    core,
    unstyled,
)
from workbench.language.naming.linear_indices import linear
from workbench.language.naming.spelling import (
    INDEX_LETTERS,
    Named,
    Scripts,
    Spelling,
    in_a_word,
    in_bracket,
    prefix_of,
    prefixed,
    spell,
    under_accent,
)

_FLAGS = flag_names()
_ALLOWED = key_names("symbol")

#: Names with a meaning in every formula. A declaration may replace the unit tensor's, and also the dual
#: unit's and that of d/dt if no symbol is dual or an operator.
UNIT, DUAL_UNIT = Name("I", ("\\mathbf",)), Name("\\varepsilon")
TIME_OPERATOR = Name("D", ("\\mathbf",))
BUILTIN = {
    DUAL_UNIT: "the dual unit",
    UNIT: "the unit tensor",
    Name("I", ("\\underline", "\\mathbf")): "the unit tensor",
    TIME_OPERATOR: "the operator d/dt",
    Name("\\partial"): "the sign of a partial derivative",
    Name("\\nabla"): "the sign of a gradient",
}


def refuse_builtin(name: Name, type_: Type, key: str) -> None:
    """Raises SpecError for a name with a built-in meaning."""
    meaning = BUILTIN.get(name)
    if name == CLOCK.name and type_.kind == "scalar":
        meaning = "the time of x(t) and \\frac{d}{dt}"
    if meaning is not None:
        raise SpecError(DeclarationCode.SYMBOL_PAPER_NEEDS_ANOTHER(name=name, meaning=meaning), key)


def read_key(key: str, labels: Collection[str] = ()) -> Named:
    """Returns a declared LaTeX name and the contents of its index slots; letters in `labels` are not indices.

    Raises SpecError.
    """
    return _read_key(key, frozenset(labels))


@lru_cache(maxsize=4096)
def _read_key(key: str, labels: frozenset[str]) -> Named:
    try:
        lines = parse(key).lines
        if len(lines) != 1 or len(lines[0]) != 1 or isinstance(lines[0][0], Chain):
            raise SpecError(DeclarationCode.EXPECTED_ONE_SYMBOL(), key)
        return key_spelling(lines[0][0], key, labels).declared()
    except Fault as fault:
        raise SpecError(DeclarationCode.FAULT_AT_COLUMN(value=fault.at + 1, fault=fault), key) from None


def speaks_of(body: str, letters: Iterable[str]) -> bool:
    """True if one of the letters occurs alone in the LaTeX; p_1 is another symbol than p."""
    return any(re.search(rf"(?<![\\A-Za-z]){letter}(?![A-Za-z]|\s*_)", body) for letter in letters)


def key_spelling(node: Node, key: str, labels: Collection[str] = ()) -> Spelling:
    """Returns the spelling of a declared name, in which index letters count as integers unless they are in
    `labels`.

    Raises SpecError.
    """
    left_sub = left_sup = None
    if (pair := in_bracket(node) or under_accent(node)) is not None:
        return Spelling(pair.name, ())
    match node:
        case Product(items=(Scripted(nucleus=Group(parts=())) as left, right)):
            left_sub, left_sup, node = left.sub, left.sup, core(right)
        case Product(items=(mark, right)) if prefix_of(mark) is not None:
            node = prefixed(mark, right) or node
        case Product(items=items):
            node = in_a_word(items) or node
    scripted = node if isinstance(node, Scripted) else Scripted(node.at, node)
    styles, letter = unstyled(scripted.nucleus)
    if isinstance(letter, Product):
        letter = in_a_word(letter.items) or letter
    if isinstance(letter, Scripted) and not (scripted.sup or scripted.primes):
        scripted = replace(letter, sub=both_below(letter.sub, scripted.sub))  # \vec{a_{cm}}
        inner, letter = unstyled(letter.nucleus)
        styles = (*styles, *inner)
    if isinstance(letter, Accented) and letter.accent == "~":
        below, letter = unstyled(letter.body)
        styles = (*styles, "\\tilde", *below)
    letter = as_letter(letter)
    if not isinstance(letter, Leaf):
        raise SpecError(DeclarationCode.EXPECTED_ONE_SYMBOL_LETTER(), key)
    is_figure = letter.kind == "NUMBER" and letter.text != "0" and styles
    if not (letter.kind == "LETTER" or is_figure) or scripted.factorial:
        raise SpecError(DeclarationCode.EXPECTED_LETTER_GOT(text=letter.text), key)
    scripts = Scripts(left_sub, left_sup, scripted.sub, scripted.sup, scripted.primes)
    spelling = spell(Name.styled(styles, letter.text), scripts, INDEX_LETTERS.difference(labels))
    if spelling is None:
        raise SpecError(DeclarationCode.SCRIPTS_NOT_PART_NAME(), key)
    return spelling


def read_declaration(key: str, name: Name, index: Sequence[Linear], spec: Mapping[str, Any]) -> Declaration:
    if not isinstance(spec, Mapping):
        raise SpecError(DeclarationCode.EXPECTED_TABLE_SUCH_KIND(spec=repr(spec)), key)
    unknown = [entry for entry in spec if entry not in _ALLOWED]
    if unknown:
        raise SpecError(
            DeclarationCode.UNKNOWN_KEY_ALLOWED(unknown=repr(unknown[0]), ALLOWED=", ".join(_ALLOWED)), key
        )
    kind = spec.get("kind")
    plain = kind.removeprefix("dual ") if isinstance(kind, str) else ""
    type_ = type_of_kind(plain)
    if type_ is None:
        allowed = f"{' | '.join(KINDS)} | matrix n×m, each perhaps with 'dual '"
        if plain == "quaternion":
            allowed = (
                "a convention: 'hamilton quaternion', or [conventions] quaternion = 'hamilton, scalar first'"
            )
        raise SpecError(DeclarationCode.UNKNOWN_KIND(kind=repr(kind), allowed=allowed), key)
    dual = plain != kind
    for flag in _FLAGS:
        if not isinstance(spec.get(flag, False), bool):
            raise SpecError(DeclarationCode.EXPECTED_TRUE_OR_FALSE(flag=flag, spec=repr(spec[flag])), key)
    for flag, kinds in ((flag, FLAGGED[flag].keyed) for flag in _FLAGS):
        if spec.get(flag) and kinds != EVERY and plain not in kinds:
            raise SpecError(
                DeclarationCode.FLAG_OF_OTHER_KINDS(flag=flag, kinds=" or a ".join(kinds), plain=plain), key
            )
    if spec.get("small") and (dual or spec.get("unit") or plain in ("rotation", "transform", "operator")):
        raise SpecError(DeclarationCode.SMALL_REAL_QUANTITIES_WHOSE(), key)
    if dual and spec.get("positive"):
        raise SpecError(DeclarationCode.POSITIVE_REAL_SCALARS(), key)
    if dual and plain == "transform":
        raise SpecError(DeclarationCode.TRANSFORM_REAL_DUAL_ROTATION(), key)
    flags = frozenset(flag for flag in FLAGGED if spec.get(flag) or flag == plain)
    is_timed = spec.get("of") == ["t"] and bool(flags) and "constant" not in flags
    weight = _weight(key, index, spec.get("weight"))
    declared = Declaration(name, type_.with_dual(dual), weight, flags, indices=len(index))
    return declared.with_flags(timed=True) if is_timed else declared


def arguments_of(key: str, declaration: Declaration, names: Any) -> Sequence[str]:
    """Returns the names of the symbols that a symbol is declared to be a function of. Raises SpecError."""
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise SpecError(DeclarationCode.EXPECTED_LIST_SYMBOLS_SUCH(names=repr(names)), key)
    bound = [flag for flag in FLAGGED if flag != "free" and flag in declaration.flags]
    if bound or declaration.type.dual or declaration.type.kind == "operator":
        what = bound[0] if bound else f"a {declaration.type}"
        raise SpecError(DeclarationCode.REAL_QUANTITIES_WHOSE_VALUES(what=what), key)
    return names


def aliases(key: str, spec: Mapping[str, Any]) -> Sequence[str]:
    found = spec.get("aliases", ())
    if not isinstance(found, list | tuple) or not all(isinstance(alias, str) for alias in found):
        raise SpecError(DeclarationCode.ALIASES_EXPECTED_LIST_LATEX(found=repr(found)), key)
    return found


def _weight(key: str, index: Sequence[Linear], weight: Any) -> Weight:
    """Returns the weight: an integer, or a string such as "n+1" in the index letters of the key. Raises
    SpecError."""
    if weight is None or (isinstance(weight, int) and not isinstance(weight, bool)):
        return None if weight is None else Linear(weight)
    letters = sorted(set().union(*(place.variables for place in index)))
    value = None
    if isinstance(weight, str):
        try:
            lines = parse(weight).lines
            value = linear(lines[0][0], letters) if len(lines) == 1 and len(lines[0]) == 1 else None
        except Fault:
            value = None
    if value is None:
        of = f" or a string linear in {', '.join(letters)}" if letters else ""
        raise SpecError(DeclarationCode.WEIGHT_EXPECTED_INTEGER(weight=repr(weight), of=of), key)
    places = {}
    for at, place in sorted(enumerate(index), key=lambda entry: abs(entry[1].constant), reverse=True):
        for letter, coefficient in place.coefficients:
            if coefficient == 1 and len(place.coefficients) == 1:
                places[letter] = Linear.variable(f"@{at}") - place.constant
    return value.substitute(places)
