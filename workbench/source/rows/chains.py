"""Steps of a statement: a chain a = b = c is a = b and b = c, each with its side conditions."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from workbench.core.brackets import outside
from workbench.source.documents import Display, Token, joined, spelled
from workbench.source.rewriting import argument, respelled
from workbench.source.rewriting.token_groups import FACES, GAPS, MARKS, is_one_symbol
from workbench.source.rows.cutter import cut_display
from workbench.source.rows.display_statements import Beside, Role, Statement
from workbench.source.rows.display_tree import Node, relation_places, trimmed, with_depth
from workbench.source.rows.display_vocabulary import ARROWS, UPRIGHT_FACES, WORD_COMMANDS, Kind
from workbench.source.rows.index_lists import is_index_range, with_listed
from workbench.source.rows.row_rules import inside_of
from workbench.source.rows.side_words import words_of


@dataclass(frozen=True)
class Step:
    """One relation, with the formulas next to it.

    own: the part that it adds to the previous step; for the first step, everything.
    assumed: its conditions.   reasons: the reasons that its author gives.
    ranges: those of its symbols, as i ≥ 1 and x ∈ [0, 1], at the end of the tokens.
    defined: equations that define its symbols, as in "where f = g^2".   explains: whether it is one.
    perhaps: equations next to it, which may be its conditions.
    serves: formulas whose condition it may be.
    otherwise: the formulas in the other reading of the display, which `question` names.
    limits: words next to it that limit it.   denied: the words that deny it.
    number, labels: those of the row that it ends in.
    """

    tokens: tuple[Token, ...]
    own: tuple[Token, ...]
    number: str | None
    labels: tuple[str, ...]
    assumed: tuple[tuple[Token, ...], ...] = ()
    reasons: tuple[tuple[Token, ...], ...] = ()
    ranges: tuple[tuple[Token, ...], ...] = ()
    defined: tuple[tuple[Token, ...], ...] = ()
    explains: bool = False
    perhaps: tuple[tuple[Token, ...], ...] = ()
    serves: tuple[tuple[Token, ...], ...] = ()
    otherwise: tuple[tuple[Token, ...], ...] = ()
    question: str | None = None
    limits: tuple[str, ...] = ()
    denied: str | None = None

    def spelled(self) -> tuple[str, list[Token]]:
        return spelled(self.tokens)

    def without_ranges(self) -> Step:
        count = sum(1 + len(piece) for piece in self.ranges)  # with a comma before each
        return replace(self, tokens=self.tokens[: len(self.tokens) - count], ranges=())


def steps_of(display: Display, words: Collection[str] = ()) -> list[list[Step]]:
    """Returns the statements of the display, each as its steps. words: functions that it writes without
    backslash."""
    statements = cut_display(display).statements
    return [steps for each in statements if (steps := list(_Chain(each, words).steps()))]


@dataclass(frozen=True)
class _Span:
    """The nodes of one step, from `start` to `end`; `own` is the index of the part that it adds."""

    start: int
    own: int
    end: int


class _Chain:
    def __init__(self, statement: Statement, words: Collection[str]) -> None:
        self._statement, self._words = statement, words
        self._nodes = statement.nodes
        self._places = [] if statement.whole else relation_places(statement.nodes)

    def steps(self) -> Iterator[Step]:
        for at, span in enumerate(self._spans()):
            tokens = self._formula(span.start, span.end, span.own)
            if not tokens:
                continue
            number, labels = self._row(span.end)
            ranges = [piece for each in self._beside(Role.RANGE, at) for piece in self._ranges(each, tokens)]
            otherwise, question = self._doubts(span)
            flat = [token for piece in ranges for token in (piece[0].standing_for(","), *piece)]
            yield Step(
                (*tokens, *flat),
                tuple(self._respelled(self._nodes[span.own : span.end])) if at else tuple(tokens),
                number,
                labels,
                ranges=tuple(map(tuple, ranges)),
                assumed=self._sides(Role.CONDITION, at),
                reasons=self._sides(Role.REASON, at),
                defined=self._sides(Role.DEFINITION, at),
                explains=self._statement.explains,
                perhaps=self._sides(Role.PERHAPS, at),
                otherwise=otherwise,
                question=question,
                serves=self._served(),
                limits=self._limits(),
                denied=words_of(self._statement.denied) if self._statement.denied else None,
            )

    def _spans(self) -> list[_Span]:
        if len(self._places) < 2:
            return [_Span(0, 0, len(self._nodes))]
        starts = [0, *(place + 1 for place in self._places)]
        ends = [*self._places[1:], len(self._nodes)]
        return [_Span(*span) for span in zip(starts, self._places, ends, strict=False)]

    def _formula(self, start: int, end: int, own: int = 0) -> list[Token]:
        """Returns the tokens of the nodes from `start` to `end`, rewritten for the reader.

        own: the index of the relation of one step among several.
        """
        sides = [self._nodes[start:end]]
        if start < own < end:
            sides = [self._nodes[start:own], [self._nodes[own]], self._nodes[own + 1 : end]]
        tokens = self._respelled([node for side in sides for node in trimmed(side)])
        if self._statement.whole:
            return _with_implications(tokens)
        return _as_a_definition(tokens)

    def _respelled(self, nodes: Sequence[Node]) -> list[Token]:
        return respelled(tokens_of(nodes), self._words)

    def _row(self, end: int) -> tuple[str | None, tuple[str, ...]]:
        """Returns the number and the labels of the row in which a step ends."""
        statement = self._statement
        rows = [row for row in statement.rows if row.count >= end]
        row = next((row for row in rows if row.number is not None), rows[0] if rows else None)
        return (statement.number, statement.labels) if row is None else (row.number, row.labels)

    def _beside(self, role: Role, at: int) -> list[Beside]:
        return [each for each in self._statement.beside if each.role is role and each.first <= at]

    def _sides(self, role: Role, at: int) -> tuple[tuple[Token, ...], ...]:
        """Returns the formulas of a role beside a step, such as its conditions."""
        return tuple(tuple(self._respelled(bare(each.nodes))) for each in self._beside(role, at))

    def _doubts(self, span: _Span) -> tuple[tuple[tuple[Token, ...], ...], str | None]:
        """Returns the formula of the step in the other reading, which splits the statement at its doubts, and
        the question that names both readings."""
        doubts = [each for each in self._statement.doubts if span.start < each.at < span.end]
        if not doubts or self._statement.whole:
            return (), None
        own = self._places[0] if not span.own and self._places else span.own
        before = max((each.at for each in doubts if each.at <= own), default=span.start)
        behind = min((each.at for each in doubts if each.at > own), default=span.end)
        other = tuple(self._formula(before, behind))
        return (other,), f"{doubts[0].question}: {joined(other)}"

    def _served(self) -> tuple[tuple[Token, ...], ...]:
        """Returns the steps of the statements that this one may be a condition of."""
        chains = [_Chain(each, self._words) for each in self._statement.serves]
        spans = [(chain, span) for chain in chains for span in chain._spans()]
        return tuple(tuple(chain._formula(span.start, span.end, span.own)) for chain, span in spans)

    def _limits(self) -> tuple[str, ...]:
        other = self._statement.is_condition_of
        if other is None:
            return tuple(self._statement.limits)
        formula = " ".join(joined(self._respelled(other.nodes)).split())
        return (*self._statement.limits, f"it may be a condition of {formula}")

    def _ranges(self, beside: Beside, line: list[Token]) -> list[list[Token]]:
        if not relation_places(bare(beside.nodes)):
            return []
        parts: list[list[Node]] = [[]]
        for node, depth in with_depth(bare(beside.nodes)):
            if node.kind in (Kind.COMMA, Kind.WIDE) and not depth:
                parts.append([])
            else:
                parts[-1].append(node)
        pieces = [self._respelled(kept) for part in parts if (kept := trimmed(part))]
        made = [piece for piece in with_listed(pieces, line) if piece]
        return (
            made
            if all(map(is_index_range, made)) or len(pieces) < 2
            else [self._respelled(bare(beside.nodes))]
        )


def bare(nodes: Sequence[Node]) -> list[Node]:
    """Returns the nodes without blanks and without a bracket around them."""
    kept = trimmed(nodes)
    return bare(inner) if (inner := inside_of(kept)) else kept


def tokens_of(nodes: Sequence[Node]) -> list[Token]:
    """Returns the printed tokens of the nodes, without alignment marks, spaces after a sign, and notes."""
    made: list[Token] = []
    before: Kind | None = None
    for at, node in enumerate(nodes):
        if _is_empty_group(node) and not any(each.kind is Kind.SCRIPT for each in nodes[at + 1 : at + 2]):
            continue
        if node.kind in (Kind.CANCEL, Kind.BRACE_NOTE):
            made += tokens_of(node.inside)
        elif node.kind is Kind.RELATION and node.inside and relation_places(node.note):
            made += tokens_of(node.inside)  # the note is a condition
        elif node.kind is Kind.WIDE and before in (Kind.RELATION, Kind.SIGN, Kind.INFIX):
            continue
        elif node.kind is not Kind.MARK:
            made += node.tokens
        before = before if node.is_blank else node.kind
    return made


def _is_empty_group(node: Node) -> bool:
    """True if the node is {}, which prints nothing."""
    return "".join(token.text for token in node.tokens).replace(" ", "") == "{}"


def _with_implications(tokens: list[Token]) -> list[Token]:
    """Returns the tokens with the arrow of a = b → c = d as an implication."""
    made = list(tokens)
    for at in _outside(tokens):
        if tokens[at].text in ARROWS:
            made[at] = tokens[at].standing_for("\\Rightarrow")
    return made


def _as_a_definition(tokens: list[Token]) -> list[Token]:
    """Returns x \\equiv … as a definition x := …, and x = const as the statement that its rate is 0."""
    at = _first_equality(tokens)
    if at is None:
        return tokens
    token, left, right = tokens[at], tokens[:at], tokens[at + 1 :]
    if left and _is_constant(right):
        return _at_rest(left, token)
    if token.text == "\\equiv" and _names(left, right):
        return [*left, token.standing_for(":="), *right]
    return tokens


def _first_equality(tokens: Sequence[Token]) -> int | None:
    """Returns the index of the first = or \\equiv outside brackets, else None."""
    return next((at for at in _outside(tokens) if tokens[at].text in ("=", "\\equiv")), None)


def _outside(tokens: Sequence[Token]) -> Iterator[int]:
    return outside((token.text for token in tokens), "([{", ")]}")


def _is_constant(right: Sequence[Token]) -> bool:
    """True if a side is the word in a = const."""
    right = [token for token in right if token.text != " "]
    if not right or right[0].text not in WORD_COMMANDS | UPRIGHT_FACES:
        return False
    words, end = argument(right, 1)
    return end == len(right) and joined(words).strip(" .,").lower() in ("const", "constant")


def _at_rest(left: Sequence[Token], sign: Token) -> list[Token]:
    """Returns the equation that the rate of the left side is 0."""
    rate = [left[0].standing_for(text) for text in ("\\frac", "{", "d", "}", "{", "d", "t", "}", "(")]
    return [*rate, *left, *(sign.standing_for(text) for text in (")", "=", "0"))]


def _names(left: Sequence[Token], right: Sequence[Token]) -> bool:
    """True if x \\equiv … defines x, and does not identify two terms as q \\equiv -q does."""
    left = [token for token in left if token.text != " "]
    if not is_one_symbol(left):
        return False
    letters = {token.text for token in left} - FACES - MARKS - GAPS - {"_", "^", "{", "}"}
    return letters.isdisjoint(token.text for token in right)
