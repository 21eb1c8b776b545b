"""The syntax tree of a display in TeX: environments of rows and cells, groups, words, spaces, notes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

from workbench.source.documents import Token, joined
from workbench.source.rewriting.plain_tex import with_plain_relations
from workbench.source.rewriting.wrappers import MATH_SHIFTS, OF_WORDS
from workbench.source.rows.display_vocabulary import (
    ANNOTATED,
    BRACES,
    CANCELS,
    GAPS,
    KERNS,
    KINDS,
    LENGTH,
    NOTHING_WITH_ARGUMENT,
    ROWS_IN_BRACES,
    TERMS,
    TYPED,
    UPRIGHT_FACES,
    UPRIGHT_WORDS,
    VISIBLE_GAPS,
    WIDE_WITH_ARGUMENT,
    WITH_ARGUMENT,
    WORD_COMMANDS,
    WRAPPED,
    Kind,
)

#: Limit on nested groups; deeper groups stay rows of single tokens.
_MOST_DEPTH = 60
_LONGEST_LENGTH = 16
_LENGTHS = ("pt", "ex", "em", "mm", "cm", "in")
_BLANK = frozenset({Kind.GAP, Kind.NOTHING, Kind.MARK, Kind.BREAK})


@dataclass(eq=False)
class Node:
    """A part of a display.

    tokens: all of it, in order.   inside: the nodes of a group, or those that a note belongs to.
    note: the nodes above or below it.   name: the command, environment or bracket.
    rows: those of an environment, as cells.   paired: True if its bracket closes in another row.
    """

    kind: Kind
    tokens: list[Token]
    inside: list[Node] = field(default_factory=list)
    note: list[Node] = field(default_factory=list)
    name: str = ""
    rows: list[list[list[Node]]] = field(default_factory=list)
    paired: bool = False

    @property
    def text(self) -> str:
        return joined(self.tokens)

    @property
    def is_blank(self) -> bool:
        """True if the node prints nothing."""
        return self.kind in _BLANK

    @property
    def is_empty(self) -> bool:
        """True for an empty group, which gives a sign the space of an operator."""
        return self.kind is Kind.GROUP and self.name == "{" and all(node.is_blank for node in self.inside)


#: The nodes between two alignment marks.
Cell = list[Node]


def parse(tokens: Sequence[Token]) -> list[Node]:
    """Returns the nodes of the tokens, including marks and breaks; several visible gaps become one wide
    space."""
    made: list[Node] = []
    for node in _Parser(list(with_plain_relations(tokens))).nodes(()):
        before = made[-1] if made else None
        if before is None or before.kind not in (Kind.GAP, Kind.WIDE):
            made.append(node)
        elif node.text == " ":
            before.tokens = before.tokens + node.tokens
        elif node.text in VISIBLE_GAPS and all(t.text in VISIBLE_GAPS | {" "} for t in before.tokens):
            is_one = not any(token.text in VISIBLE_GAPS for token in before.tokens)
            made[-1] = Node(Kind.GAP if is_one else Kind.WIDE, before.tokens + node.tokens)
        else:
            made.append(node)
    return made


def rows_of(nodes: Sequence[Node]) -> list[list[Cell]]:
    """Returns rows of cells; each cell but the first begins with its mark, each row but the first with its
    break."""
    rows: list[list[Cell]] = [[[]]]
    for node in nodes:
        if node.kind is Kind.BREAK:
            rows.append([[node]])
        elif node.kind is Kind.MARK:
            rows[-1].append([node])
        else:
            rows[-1][-1].append(node)
    return rows


class _Parser:
    def __init__(self, tokens: list[Token]) -> None:
        self._tokens, self._at, self._depth = tokens, 0, 0

    def nodes(self, until: Sequence[str]) -> Iterator[Node]:
        while self._at < len(self._tokens) and self._next not in until:
            yield from self._node()

    @property
    def _next(self) -> str:
        return self._tokens[self._at].text if self._at < len(self._tokens) else ""

    def _node(self) -> Iterator[Node]:
        if self._depth >= _MOST_DEPTH:
            yield Node(Kind.PLAIN, self._take())
            return
        self._depth += 1
        yield from self._nested()
        self._depth -= 1

    def _nested(self) -> Iterator[Node]:
        start, text = self._at, self._next
        if text in WRAPPED:
            yield from self._wrapped(text)
        elif text in ANNOTATED:
            yield self._annotated(text)
        elif text in BRACES:
            yield self._braced(text)
        elif text in CANCELS:
            self._take()
            note = self._argument() if text == "\\cancelto" else []
            inside = self._argument()
            yield Node(Kind.CANCEL, self._tokens[start : self._at], inside, note, text)
        elif text in TERMS:
            yield self._term(text)
        elif (made := self._of_arguments(text)) is not None:
            yield made
        else:
            yield self._single()

    def _of_arguments(self, text: str) -> Node | None:
        """Returns a node for a bracket, an environment or a command with its arguments; else None."""
        start, inside = self._at, None
        if text.startswith("\\begin{"):
            return self._environment(text[7:-1])
        if text == "\\left":
            return self._left()
        if text == "{":
            inside = self._argument()
            kind = Kind.WORDS if _is_words(inside) else Kind.GROUP
        elif text in ("_", "^"):
            self._take()
            kind, inside = Kind.SCRIPT, self._argument()
        elif text in WORD_COMMANDS or text in NOTHING_WITH_ARGUMENT:
            self._take()
            self._argument()
            kind = Kind.WORDS if text in WORD_COMMANDS else Kind.NOTHING
        elif text in ROWS_IN_BRACES:
            self._take()
            inside = self._argument()
            whole, cells = self._tokens[start : self._at], 2 if text.endswith("no") else None  # the number
            rows = [row[:cells] for row in rows_of(inside)]
            return Node(Kind.ENVIRONMENT, whole, inside, name=ROWS_IN_BRACES[text], rows=rows)
        elif text in WIDE_WITH_ARGUMENT:
            self._take(1 + (self._peek(1) == "*"))
            self._pass_length() or self._argument()
            kind = Kind.WIDE
        elif text in KERNS:
            self._take()
            self._pass_length()
            kind = Kind.GAP
        else:
            return None
        return Node(kind, self._tokens[start : self._at], inside or [], name=text)

    def _single(self) -> Node:
        start, text, behind = self._at, self._next, self._peek(1)
        self._take()
        if (text, behind) in TYPED or (text == "\\not" and behind):
            self._take()
            text = TYPED.get((text, behind), "\\neq")
        elif text == "\\\\":
            self._length()
        return Node(KINDS.get(text, Kind.PLAIN), self._tokens[start : self._at], name=text)

    def _wrapped(self, text: str) -> Iterator[Node]:
        """Yields a node for \\boxed or the like, then the nodes inside it."""
        start = self._at
        self._take()
        self._take(self._next == "*")
        self._optional()
        for _ in range(WRAPPED[text]):
            self._argument()
            self._optional()
        inside = self._argument()
        shown = next((node.text for node in inside if not node.is_blank), "")
        if text[1:] in OF_WORDS and shown not in MATH_SHIFTS:
            yield Node(Kind.WORDS, self._tokens[start : self._at], name=text)
            return
        held = {id(token) for node in inside for token in node.tokens if node.text not in MATH_SHIFTS}
        yield Node(Kind.NOTHING, [t for t in self._tokens[start : self._at] if id(t) not in held], name=text)
        yield from (node for node in inside if node.text not in MATH_SHIFTS)

    def _term(self, text: str) -> Node:
        start = self._at
        self._take()
        self._optional() if text == "\\sqrt" else None
        inside = [self._argument() for _ in range(TERMS[text])]
        words = "".join(node.text for node in inside[0]).strip()
        kind = Kind.WORDS if text in UPRIGHT_FACES and words in UPRIGHT_WORDS else Kind.PLAIN
        whole = [node for argument in inside for node in argument]
        return Node(kind, self._tokens[start : self._at], whole, name=text)

    def _braced(self, text: str) -> Node:
        """Returns the node of \\underbrace{x}_{note}."""
        start = self._at
        self._take()
        inside, note, end = self._argument(), [], self._at
        self._pass_gaps()
        if self._next in ("_", "^"):
            self._take()
            note, end = self._argument(), self._at
        self._at = end
        return Node(Kind.BRACE_NOTE, self._tokens[start:end], inside, note, text)

    def _annotated(self, text: str) -> Node:
        """Returns a relation with a note above it; other symbols with a note are letters."""
        start = self._at
        self._take()
        self._optional()
        note = self._argument()
        base = [] if text.startswith("\\x") else self._argument()
        kinds = [node.kind for node in base if node.kind is not Kind.GAP]
        if text == "\\xrightarrow":
            kind = Kind.IMPLICATION
        elif text == "\\xlongequal":
            kind = Kind.RELATION
        else:
            is_sign = len(kinds) == 1 and kinds[0] in (Kind.RELATION, Kind.IMPLICATION)
            kind = kinds[0] if is_sign else Kind.PLAIN
        name = next((node.name for node in base if node.kind is kind), text) if base else text
        return Node(kind, self._tokens[start : self._at], base, note if kind is not Kind.PLAIN else [], name)

    def _left(self) -> Node:
        start, fence = self._at, self._peek(1)
        self._take(2)
        inside = list(self.nodes(("\\right", "}")))
        if self._next == "\\right":
            self._take(2)
        return Node(Kind.GROUP, self._tokens[start : self._at], inside, name=f"left{fence}")

    def _environment(self, name: str) -> Node:
        start, closing = self._at, f"\\end{{{name}}}"
        self._take()
        if name in WITH_ARGUMENT:
            self._optional()
            self._argument()
        elif name in ("aligned", "gathered") or name.endswith("matrix*"):
            self._optional()
        inside = list(self.nodes((closing, "}", "\\right")))
        if self._next == closing:
            self._take()
        return Node(Kind.ENVIRONMENT, self._tokens[start : self._at], inside, name=name, rows=rows_of(inside))

    def _take(self, count: int = 1) -> list[Token]:
        start, self._at = self._at, min(self._at + count, len(self._tokens))
        return self._tokens[start : self._at]

    def _peek(self, count: int) -> str:
        place = self._at + count
        return self._tokens[place].text if place < len(self._tokens) else ""

    def _pass_gaps(self) -> None:
        while self._next in GAPS:
            self._at += 1

    def _argument(self) -> list[Node]:
        """Returns the nodes of the next argument, and moves past its braces."""
        self._pass_gaps()
        if self._next == "{":
            self._take()
            inside = list(self.nodes(("}",)))
            self._take()
            return inside
        is_there = self._next not in ("", "}", "&", "\\\\") and not self._next.startswith("\\end{")
        return list(self._node()) if is_there else []

    def _pass_length(self) -> bool:
        """Moves past a length without braces, as in \\hskip 1em; True if there is one."""
        ahead = self._tokens[self._at : self._at + _LONGEST_LENGTH]
        found = LENGTH.match(joined(ahead))
        if found is not None:
            ends = accumulate(len(token.text) for token in ahead)
            self._take(sum(end <= found.end() for end in ends))
        return found is not None

    def _optional(self) -> None:
        if self._next == "[" and "]" in (t.text for t in self._tokens[self._at : self._at + 40]):
            while self._take()[0].text != "]":
                pass

    def _length(self) -> None:
        """Skips the * and the [2pt] of \\\\*[2pt]."""
        if self._next == "*" and self._peek(1) != "*":
            self._take()
        text = joined(self._tokens[self._at : self._at + 14])
        length, closing, _ = text[1:].partition("]")
        if text[:1] == "[" and closing and length.strip()[-2:] in _LENGTHS:
            self._optional()


def _is_words(nodes: Sequence[Node]) -> bool:
    """True if a group contains only words, and more than a name."""
    words = [node for node in nodes if not node.is_blank]
    is_phrase = any(mark in node.text.strip() for node in words for mark in " (")
    return is_phrase and all(node.kind is Kind.WORDS for node in words)


def pairs_of(nodes: Sequence[Node]) -> tuple[list[int], int, int]:
    """Returns the indices of matching brackets, and the numbers of unmatched opening and closing ones."""
    waiting: list[int] = []
    found: list[int] = []
    closes = 0
    for at, node in enumerate(nodes):
        if node.kind is Kind.OPEN:
            waiting.append(at)
        elif node.kind is Kind.CLOSE and waiting:
            found += [waiting.pop(), at]
        elif node.kind is Kind.CLOSE:
            closes += 1
    return found, len(waiting), closes


def with_depth(nodes: Sequence[Node]) -> Iterator[tuple[Node, int]]:
    """Yields each node with the number of matched brackets around it, which may close in another row."""
    places = set(pairs_of(nodes)[0])
    counts = [
        node.kind in (Kind.OPEN, Kind.CLOSE) and (at in places or node.paired)
        for at, node in enumerate(nodes)
    ]
    depth = sum(
        node.kind is Kind.CLOSE and is_counted and at not in places
        for at, (node, is_counted) in enumerate(zip(nodes, counts, strict=True))
    )
    for node, is_counted in zip(nodes, counts, strict=True):
        if node.kind is Kind.CLOSE and is_counted:
            depth -= 1
        yield node, depth
        depth += node.kind is Kind.OPEN and is_counted


def relation_places(nodes: Sequence[Node]) -> list[int]:
    """Returns the indices of the relations outside brackets."""
    return [
        at for at, (node, depth) in enumerate(with_depth(nodes)) if node.kind is Kind.RELATION and not depth
    ]


def trim(nodes: Sequence[Node]) -> tuple[list[Node], list[Node]]:
    """Returns the nodes without surrounding blanks and final punctuation; and the removed nodes."""
    first, last = 0, len(nodes)
    while first < last and (_begins(nodes, first) or nodes[first].kind in (Kind.WIDE, Kind.COMMA)):
        first += 1
    while first < last and _ends(nodes, last):
        last -= 1
    return list(nodes[first:last]), [*nodes[:first], *nodes[last:]]


def _begins(nodes: Sequence[Node], first: int) -> bool:
    """True if the node is a blank, or an empty group that carries no script: {}+ x, but not {}^A x."""
    carries = first + 1 < len(nodes) and nodes[first + 1].kind is Kind.SCRIPT
    return nodes[first].is_blank or (nodes[first].is_empty and not carries)


def _ends(nodes: Sequence[Node], last: int) -> bool:
    """True if the node before `last` is a blank or punctuation, but not the last stop of an ellipsis."""
    node = nodes[last - 1]
    is_ellipsis = node.kind is Kind.STOP and last > 1 and nodes[last - 2].kind is Kind.STOP
    is_mark = node.kind in (Kind.WIDE, Kind.COMMA, Kind.STOP)
    return node.is_blank or node.is_empty or (is_mark and not is_ellipsis)


def trimmed(nodes: Sequence[Node]) -> list[Node]:
    return trim(nodes)[0]


def without(nodes: Sequence[Node], *held: Node) -> list[Token]:
    """Returns the tokens of the nodes that are in none of the nodes `held`."""
    inside = {id(token) for node in held for token in node.tokens}
    return [token for node in nodes for token in node.tokens if id(token) not in inside]
