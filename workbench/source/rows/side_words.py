"""Words in a display: the role of the formulas next to them, and words that are names."""

from __future__ import annotations

import re
from collections.abc import Sequence
from enum import Enum, auto

from workbench.source.documents import Token, joined
from workbench.source.documents.condition_words import (
    CASES,
    EXCEPTIONS,
    EXPLAINS,
    LETS,
    REASONS,
    SUPPOSES,
)
from workbench.source.rows.display_tree import Node, parse, relation_places
from workbench.source.rows.display_vocabulary import INTERTEXTS, Kind


class WordRole(Enum):
    """The role of the formula after words: a denied formula, the other part of one statement, a condition, a
    reason, or another statement. A remark gives it no role."""

    DENIAL = auto()
    CONNECTION = auto()
    CONDITION = auto()
    REASON = auto()
    JOIN = auto()
    REMARK = auto()


_CONDITIONS = (
    rf"{LETS}|{EXPLAINS}|(?:{CASES}|{SUPPOSES}|such)(?: that| all| every| any)?"
    "|s t|subj to|under|on|along|in|near|during|until"
)
_REASONS = f"{REASONS}|using|by|from|due to|see|recall|noting|thanks to|owing to"
_JOINS = (
    "and|so|so that|thus|hence|therefore|and therefore|then|i e|that is|which gives|or equivalently"
    r"|also|but|yields|gives|we have|we get|so we have|&|\\&|"
)
#: A verb and its particle, before what is found, written or left.
_PRESENTS = (
    r"(?:arriv\w+|gets?|getting|got) at|(?:ends?|ended|ending|comes?|came|coming|winds?) up with"
    r"|(?:left|leaves us|concludes?|finish\w*|begins?|starts?|beginning|starting|proceeds?|deals?) with"
    r"|(?:written|rewritten|recast|reformulated|reads?|expressed|stated|restated|known|formulated"
    r"|summari[sz]ed|posed|represented|described|denoted|identified|obtained|presented|such|same|well) as"
    r"|(?:given|described|expressed|governed|represented|determined|ruled|followed|replaced) by"
)
_DENIALS = (
    r"(?:.*\b)?(?:wrong|false|untrue|invalid|incorrect|erroneous|mistaken)(?:ly)?\b"
    r"|(?:.*\b)?(?:not|never|no longer)\b(?: be| generally| in general)? ?(?:true|valid|correct|right|hold)"
    r"|.*n['’]t (?:true|hold)|(?:not|never|contrary|in general not|but not)\b"
)
#: What follows an exception is not supposed: "unless f = 0".
_CONNECTIONS = re.compile(
    rf"(?:or|implies|either|(?:.*\b)?(?:iff|if and only if))$|(?:.*\b)?{EXCEPTIONS}(?: #)?$"
)
#: The first pattern that matches the words decides.
_ROLES = (
    (WordRole.DENIAL, re.compile(_DENIALS)),
    (WordRole.CONNECTION, _CONNECTIONS),
    (WordRole.JOIN, re.compile(rf"(?:.*\b)?(?:{_PRESENTS})$")),
    (WordRole.CONDITION, re.compile(rf"(?:.*\b)?(?:{_CONDITIONS})\b[^a-z]*$")),
    (WordRole.REASON, re.compile(rf"(?:.*\b)?(?:{_REASONS})\b[^a-z]*$")),
    (WordRole.JOIN, re.compile(rf"(?:{_JOINS})$")),
)
#: Words after which a symbol is defined.
_NAMES_WHAT = re.compile(r"\b(?:where|with|here|let|set|put)$")
#: The same roles for a formula within the words: "since $a = 0$".
_LEADS = (
    (WordRole.REASON, re.compile(rf"\b(?:{_REASONS})\b")),
    (WordRole.CONDITION, re.compile(rf"\b(?:{_CONDITIONS})\b")),
)
#: Words without a formula that limit the statement next to them.
_LIMITS = re.compile(
    r"\b(?:(?:orthogonal|perpendicular|parallel|boundar|small|const|stead|equilibri|symmetr|assum|hypothes"
    r"|vanish|neglect|approx|lineari|static)\w*|axis|axes|zero|at rest|fixed|if|when|unless|only|otherwise"
    r"|special|case|almost|up to|order|modulo|mod|locally|formally|roughly|usually"
    r"|on|along|near|under|at|since|because)\b"
)

#: Words that quantify or refer, if the text after them contains no relation.
_NO_LIMITS = re.compile(r"\b(?:all|every|any|for|with|where|by|using|from|see|recall|as|since|because)$")


def words_of(node: Node) -> str:
    """Returns the words in lower case, without punctuation; # stands for each formula among them."""
    text = re.sub(r"\\(?:text\w*|mbox|hbox)(?![A-Za-z])", "", joined(node.tokens[1:])).strip()
    text = re.sub(r"\$[^$]*\$|\\\([^)]*\\\)", " # ", text)
    return " ".join(re.sub(r"[{}()\[\].,:;~]|\\[,;! ]", " ", text).lower().split())


def maths_of(node: Node) -> list[list[Node]]:
    """Returns the formulas between dollars in the words."""
    parts: list[list[Token]] = []
    inside = False
    for token in node.tokens:
        if token.text in ("$", "\\(", "\\)"):
            inside = not inside
            parts += [[]] if inside else []
        elif inside:
            parts[-1].append(token)
    return [parse(part) for part in parts if part]


def role_of(words: str) -> WordRole:
    """Returns the role of the formula after the words. Words that end with a formula are a remark."""
    if _CONNECTIONS.match(words):
        return WordRole.CONNECTION
    if words.endswith("#"):
        return WordRole.REMARK
    spoken = words.replace("#", " ").strip()
    return next((role for role, pattern in _ROLES if pattern.match(spoken)), WordRole.REMARK)


def lead_of(words: str) -> WordRole | None:
    """Returns the role of a formula within the words; None if they do not state it."""
    if _CONNECTIONS.match(words):
        return None
    if (role := next((role for role, pattern in _LEADS if pattern.search(words)), None)) is not None:
        return role
    return WordRole.CONDITION if limits(words) else None


def says_what_is(words: str) -> bool:
    """True if the formula after the words can define a symbol."""
    return _NAMES_WHAT.search(words) is not None


def limits(words: str) -> bool:
    """True if the words limit the statement next to them."""
    return _LIMITS.search(words) is not None


def limits_without_a_relation(words: str) -> bool:
    """True if the words limit a statement although only symbols follow them: "if (x)", not "for all x"."""
    return limits(words) and _NO_LIMITS.search(words) is None


def is_name(cell: Sequence[Node], at: int) -> bool:
    """True if the words at `at` are a symbol or a unit: \\text{vec}(A), \\text{proj}_w, = \\text{const}."""
    node = cell[at]
    words, maths = words_of(node), maths_of(node)
    if node.name in INTERTEXTS or node.name == "\\tag":
        return False
    if maths and not re.sub(r"#|\\boldmath", "", words).strip():  # \mbox{\boldmath$\omega$}
        return not any(map(relation_places, maths))
    if at + 1 < len(cell) and cell[at + 1].kind is Kind.SCRIPT:
        return True
    raw = joined(node.tokens[1:]).strip("{} ")
    if not re.search(r"[^\W_]", raw):
        return re.search(r"[^\s.,;:(){}\[\]]", raw) is not None  # x\text{-}y
    is_acronym = raw.isupper() and len(raw) > 1
    if maths:
        return False
    before = next((n for n in reversed(cell[:at]) if n.kind not in (Kind.GAP, Kind.MARK)), None)
    if before is not None and before.kind in (Kind.RELATION, Kind.SIGN, Kind.INFIX):
        return True
    if role_of(words) is not WordRole.REMARK and not is_acronym:
        return False
    return _is_in_a_term(cell, at, raw)


def _opens_arguments(node: Node, next_one: Node) -> bool:
    """Whether the node opens the arguments of a word; next_one: what stands right behind the word."""
    is_close = next_one is node or node.kind is Kind.GROUP
    is_bracket = node.kind in (Kind.OPEN, Kind.GROUP, Kind.SCRIPT)
    return is_close and (is_bracket or node.text.lower().startswith("\\big"))


def _is_in_a_term(cell: Sequence[Node], at: int, raw: str) -> bool:
    """True if single words are a side, an operand, a function or a unit."""
    blank = (Kind.GAP, Kind.MARK)
    before = next((node for node in reversed(cell[:at]) if node.kind not in blank), None)
    behind = next((node for node in cell[at + 1 :] if node.kind not in blank), None)
    if behind is not None and behind.kind is Kind.RELATION and " " not in raw:
        return True
    is_word = re.fullmatch(r"[A-Za-z]\w*", raw) is not None
    opened = (Kind.RELATION, Kind.SIGN, Kind.INFIX, Kind.OPEN)
    if is_word and behind is not None and before is not None and before.kind in opened:
        return True
    is_call = is_word and behind is not None and _opens_arguments(behind, cell[at + 1])
    ends = behind is None or behind.kind in (Kind.STOP, Kind.COMMA)
    is_value = ends and before is not None and before.kind is Kind.RELATION
    is_unit = " " not in raw and at > 0 and before is cell[at - 1] and before.text.strip()[-1:].isdigit()
    return is_call or is_value or is_unit
