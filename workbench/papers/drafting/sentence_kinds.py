"""Facts of symbols in sentences: angular velocities, rates, constants, quaternions, arbitrary vectors."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from workbench.context.introducing_words import is_denied, is_supposed
from workbench.context.sentences import is_case
from workbench.papers.drafting.drafted_definitions import Proposed
from workbench.papers.drafting.formula_shapes import quaternion_parts
from workbench.papers.drafting.inference.kind_operations import SYMBOL, Operation
from workbench.papers.drafting.marked_text import MARK, MarkedText, Sentence

_LABEL = re.compile(r"(?:\\(?:math\w+|boldsymbol)\s*\{?\s*)*\{?[A-Z](?:\s*_\s*\{?\w+\}?)?\s*\}*|\{\w\}|\d")
_LIST = r"(?:⟦\d+⟧(?:,? and |, )?)+"
_ARTICLE = r"(?:the )?(?:frame |body |link |base )?"
_IN = r" (?:in|relative to|with respect to|seen from|measured in|as seen from|observed from|w\.r\.t\.) "
_DERIVATIVE = r"(?:time )?(?:derivative|rate of change|rate)s?"
_IS = r"(?: is| are| be| denotes?| denoting| stands for| represents?|,)(?: simply)? (?:the )?"


@dataclass(frozen=True)
class Spin:
    """A symbol that is the angular velocity (or acceleration) of one frame in another."""

    name: str
    what: str
    frame: str
    base: str


@dataclass(frozen=True)
class Quaternion:
    """A unit quaternion and its parts, in the order of the sentence."""

    name: str
    parts: tuple[str, ...]
    line: int


@dataclass
class Facts:
    """The facts that the sentences of a text state.

    Attributes:
        rates: Name → (symbol, frame or "", line) of which it is the rate.
        constants: Symbols that are constant.
        free: Symbols with arbitrary values.
        units: Symbols that are unit tensors.
        directions: Vectors whose norm a formula states to be 1, before any display with them.
        columns: Name → (definition, line) of the columns of a matrix.
    """

    spins: list[Spin] = field(default_factory=list)
    rates: dict[str, tuple[str, str, int]] = field(default_factory=dict)
    constants: dict[str, None] = field(default_factory=dict)
    free: dict[str, None] = field(default_factory=dict)
    quaternions: list[Quaternion] = field(default_factory=list)
    columns: dict[str, tuple[str, int]] = field(default_factory=dict)
    units: dict[str, None] = field(default_factory=dict)
    directions: set[str] = field(default_factory=set)

    def definitions(self, dot: str) -> Iterator[Proposed]:
        """Yields the definitions of rates.

        dot: the frame in which a dot differentiates; "" if none is known.
        """
        for name, (of, frame, line) in self.rates.items():
            is_plain = frame in ("", dot)
            body = rf"\frac{{d {of}}}{{dt}}" if is_plain else rf"\frac{{{{}}^{{{frame}}} d {of}}}{{dt}}"
            yield Proposed(name, body, line, "a sentence says so", True, in_sentence=True)
        for name, (body, line) in self.columns.items():
            yield Proposed(name, body, line, "a sentence says so", True, in_sentence=True)


def facts_of(text: MarkedText) -> Facts:
    """Returns the facts that the sentences of a text state."""
    facts = Facts()
    for sentence in text.sentences:
        for pattern, take in _RULES:
            for match in pattern.finditer(sentence.words):
                take(facts, text, sentence, match)
    facts.quaternions = [_with_parts(each, text) for each in facts.quaternions]
    facts.directions = set(_directions(text))
    return facts


def _directions(text: MarkedText) -> Iterator[str]:
    """Yields the symbols n of ‖n‖ = 1, n · n = 1 and nᵀ n = 1 in sentences that suppose nothing."""
    for mark, formula in enumerate(text.formulas):
        match text.tree(str(mark)):
            case Operation(op="equal", parts=(side, Operation(op="number", text="1"))):
                pass
            case _:
                continue
        match side:
            case Operation(op="norm", parts=(Operation(op="symbol", text=name),)):
                pass
            case Operation(op="dot" | "mul", parts=(one, Operation(op="symbol", text=name) as other)) if (
                other in (one, *(one.parts if one.op == "transpose" else ()))
            ):
                pass
            case _:
                continue
        if not (is_denied(formula) or is_supposed(formula)) and not text.shows_before(name, formula):
            yield name


def _with_parts(quaternion: Quaternion, text: MarkedText) -> Quaternion:
    """Returns the quaternion with its parts from the first equation of the text that lists them."""
    if quaternion.parts:
        return quaternion
    equations = (tree for tree in text.equations if tree.parts[0].text == quaternion.name)
    listed = (quaternion_parts(tree.parts[1]) for tree in equations)
    return replace(quaternion, parts=next(filter(None, listed), ()))


def _spin(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
    (name, *_), frame, base = text.names(match["name"]) or [""], match["frame"], match["base"]
    labels = [" ".join(text.latex(mark).split()) for mark in (frame, base)]
    if name and all(map(_is_label, labels)):
        what = f"angular {match['what']}"
        facts.spins.append(Spin(name, what, labels[0], labels[1]))


def _is_label(latex: str) -> bool:
    """True if a formula is the label of a frame or a point: a capital, or a digit."""
    return _LABEL.fullmatch(latex) is not None


def _rate(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
    names, of = text.names(match["name"]), text.names(match["of"])
    if len(names) == len(of) == 1 and names[0] != of[0]:
        facts.rates.setdefault(names[0], (of[0], _frame(text, match), sentence.line))


def _frame(text: MarkedText, match: re.Match[str]) -> str:
    mark = match.groupdict().get("frame")
    label = " ".join(text.latex(mark).split()) if mark else ""
    return label if _is_label(label) else ""


def _two_rates(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
    """Records "v and a are the first and second derivative of r in B"; "its" refers to the first symbol of
    the sentence."""
    names = [name for mark in re.findall(MARK, match["names"]) for name in text.names(mark)]
    mark = match["of"]
    if mark is None:
        before = re.findall(MARK, sentence.words[: match.start()])
        mark = next((each for each in before if not _is_label(text.latex(each))), None)
    of = text.names(mark) if mark is not None else []
    if len(names) == 2 and of:
        frame = _frame(text, match)
        facts.rates.setdefault(names[0], (of[0], frame, sentence.line))
        facts.rates.setdefault(names[1], (names[0], frame, sentence.line))


def _motion(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
    """Records "the position r, velocity v and acceleration a" and "r, v and a are position, velocity and
    acceleration", unless the words behind name another frame for a rate."""
    nouns = [_ORDER[each.lower()] for each in re.findall("|".join(_ORDER), match[0], re.IGNORECASE)]
    names = [name for mark in re.findall(MARK, match[0]) for name in text.names(mark)]
    is_chain = nouns == [*range(nouns[0], nouns[0] + len(nouns))]
    if (
        len(names) == len(nouns) == len(set(names))
        and is_chain
        and not _ANOTHER_FRAME.search(sentence.words, match.end())
    ):
        for name, of in zip(names[1:], names, strict=False):
            facts.rates.setdefault(name, (of, "", sentence.line))


def _columns(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
    names = [name for mark in re.findall(MARK, match["names"]) for name in text.names(mark)]
    whole = text.names(match["of"])
    if len(names) != 3 or len(whole) != 1:
        return
    for at, name in enumerate(names):
        unit = r" \\ ".join(str(int(at == row)) for row in range(3))
        body = rf"{whole[0]} \begin{{bmatrix}} {unit} \end{{bmatrix}}"
        facts.columns.setdefault(name, (body, sentence.line))


def _listed(key: str) -> Callable[[Facts, MarkedText, Sentence, re.Match[str]], None]:
    """Returns the action that records the symbols of a list; what a sentence supposes for itself is no
    fact of the text: "for constant m"."""

    def take(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
        if key == "constants" and is_case(sentence.words[: match.start()]):
            return
        for mark in re.findall(MARK, match["names"]):
            for name in text.names(mark):
                getattr(facts, key).setdefault(name)

    return take


def _quaternion(facts: Facts, text: MarkedText, sentence: Sentence, match: re.Match[str]) -> None:
    tree = text.tree(match["name"])
    if tree is None:
        return
    name = tree.parts[0] if tree.parts else tree
    parts = quaternion_parts(tree.parts[1]) if tree.op == "equal" else ()
    known = {each.name for each in facts.quaternions}
    if name.op == SYMBOL and tree.op in ("equal", "said", "member") and name.text not in known:
        facts.quaternions.append(Quaternion(name.text, parts, sentence.line))


Rule = tuple[re.Pattern[str], Callable[[Facts, MarkedText, Sentence, re.Match[str]], None]]


def _mark(group: str) -> str:
    return rf"⟦(?P<{group}>\d+)⟧"


def _rule(pattern: str, take: Callable[[Facts, MarkedText, Sentence, re.Match[str]], None]) -> Rule:
    return re.compile(pattern, re.IGNORECASE), take


_ANGULAR = r"angular (?P<what>velocity|acceleration)(?: vector)?"
_OF_IN = rf" of {_ARTICLE}{_mark('frame')}{_IN}{_ARTICLE}{_mark('base')}"
_UNIT_QUATERNION = (
    r"(?:(?:unit|normali[sz]ed)(?:[- ](?:norm|length))?|(?:unit )?versor|unit rotation) quaternions?"
)
#: The nouns of a motion, and the orders of the rates that they name.
_ORDER = {"position": 0, "velocity": 1, "acceleration": 2, "jerk": 3}
_NOUN = rf"(?:{'|'.join(_ORDER)})(?: vector)?"
_AND = r"(?:,? and |, )(?:the |its |linear )*"
#: Words on a frame that moves, in which a velocity is not the rate of the position.
_ANOTHER_FRAME = re.compile(r"\b(?:body|local|moving|rotating|sensor|vehicle|camera|respective)")
_IN_FRAME = rf"(?:{_IN}{_ARTICLE}{_mark('frame')})?"
_RULES: tuple[Rule, ...] = (
    _rule(rf"{_mark('name')}{_IS}{_ANGULAR}{_OF_IN}", _spin),
    _rule(rf"{_ANGULAR} {_mark('name')}{_OF_IN}", _spin),
    _rule(rf"{_ANGULAR}{_OF_IN}(?: is|,| by| as)*(?: denoted by| written)? {_mark('name')}", _spin),
    _rule(rf"{_mark('name')}{_IS}(?:first )?{_DERIVATIVE} of {_mark('of')}{_IN_FRAME}", _rate),
    _rule(rf"{_DERIVATIVE} {_mark('name')} of {_mark('of')}{_IN_FRAME}", _rate),
    _rule(
        rf"(?P<names>{_LIST})(?: be| are| denote)? (?:its|the|their) first and second {_DERIVATIVE}"
        rf"(?: of {_mark('of')})?{_IN_FRAME}",
        _two_rates,
    ),
    _rule(rf"{_NOUN} ⟦\d+⟧(?:{_AND}{_NOUN} ⟦\d+⟧)+", _motion),
    _rule(
        rf"⟦\d+⟧(?:(?:,? and |, )⟦\d+⟧)+(?: are| be| denote)? (?:the )?(?:linear )?{_NOUN}(?:{_AND}{_NOUN})+",
        _motion,
    ),
    _rule(rf"\b(?:constants?|constant \w+|lengths?|masses|mass) (?P<names>{_LIST})", _listed("constants")),
    _rule(
        rf"(?P<names>{_LIST}) ?(?:is|are|be|being) (?:a |the |all |both )?constants?\b", _listed("constants")
    ),
    _rule(r"(?P<names>⟦\d+⟧),? (?:its|the|an?) constant\b(?! (?:\w+ )?⟦)", _listed("constants")),
    _rule(
        r"\b(?:any|all|arbitrary|every)(?: (?:two|three|other))? (?:vectors?|scalars?|tensors?|points?)"
        rf" (?P<names>{_LIST})",
        _listed("free"),
    ),
    _rule(
        rf"\b{_UNIT_QUATERNION} (?:is |are |denoted |written |given |by |as )*{_mark('name')}", _quaternion
    ),
    _rule(
        rf"{_mark('name')}(?: is| be| denotes?| represents?|,)(?: an?| the| some)? {_UNIT_QUATERNION}\b",
        _quaternion,
    ),
    _rule(
        rf"\bquaternion {_mark('name')} (?:is normali[sz]ed|(?:has|of|with) unit (?:norm|length))",
        _quaternion,
    ),
    _rule(
        rf"(?P<names>{_LIST})(?: be| are| denote| as| for|,)* (?:the )?(?:three )?columns of {_mark('of')}",
        _columns,
    ),
    _rule(rf"columns (?P<names>{_LIST}) of (?:the (?:\w+ )?matrix )?{_mark('of')}", _columns),
    _rule(
        rf"(?P<names>⟦\d+⟧){_IS}(?:\S+ )?(?:identity(?: (?:matrix|tensor))?|unit (?:matrix|tensor))\b",
        _listed("units"),
    ),
)
