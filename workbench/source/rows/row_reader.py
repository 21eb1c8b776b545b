"""Reads a row of a display piece by piece: each piece continues a statement, begins one, or stands next to
one."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.language.grammar.vocabulary import NUMBER
from workbench.source.documents import joined
from workbench.source.rows.display_pieces import Piece, Separator
from workbench.source.rows.display_statements import Beside, Leftover, Role, RowEnd, Statement
from workbench.source.rows.display_tree import Node, pairs_of, relation_places, trimmed, without
from workbench.source.rows.display_vocabulary import Kind, Marks
from workbench.source.rows.row_rules import (
    Action,
    behind,
    below,
    end_of_a_name,
    is_range,
    is_symbol,
    leading_side,
    names_what,
)
from workbench.source.rows.row_statements import Row, RowStatements, State
from workbench.source.rows.side_words import (
    WordRole,
    lead_of,
    limits,
    limits_without_a_relation,
    maths_of,
    role_of,
    says_what_is,
    words_of,
)

_ROLES = {WordRole.CONDITION: Role.CONDITION, WordRole.REASON: Role.REASON}


class RowReader(RowStatements):
    """Reads the pieces of one row in order."""

    def __init__(self, state: State, row: Row) -> None:
        super().__init__(state, row)
        self._above = dict(state.columns)
        self._begun: set[int] = set()  # columns that have a statement in this row
        self._pending: Role | None = None  # role of the next formula according to the words before it
        self._pending_words = ""
        self._in_bracket = False  # true if the words before open a bracket: (since a = b)
        self._names_what = False
        self._is_ahead = False  # true if the definition before is of symbols of the next statement
        self._are_unknown = False  # true if the words before have no known meaning
        self._is_quantified = False  # true if the words before bind symbols, as "for all x"
        self._said = False

    def begins(self, piece: Piece) -> bool:
        """True if an environment of lines in this piece is a system, and not a side of a formula."""
        return self._here is None or bool(piece.apart & {Separator.WIDE, Separator.COMMA, Separator.WORDS})

    def stands_behind(self, statements: Sequence[Statement]) -> None:
        """Sets the lines of a system that the following pieces apply to.

        Behind a statement they may be its conditions; behind words such as "with" they are.
        """
        served = self._served()
        for line in statements if served else ():
            for target in served:
                target.beside.append(Beside(self._pending or Role.PERHAPS, list(line.nodes)))
            line.serves = served
        if served and self._pending is not None:
            self._state.cut.statements = self._state.cut.statements[: -len(statements) or None]
            self._pending = None
            return
        self._take_waiting(statements)
        self._shared, self._here = statements, statements[-1] if statements else None
        self._made += statements
        self._said = True

    def read(self, place: int) -> None:
        """Reads the piece at this index."""
        piece, rest = self._row.pieces[place], self._row.pieces[place + 1 :]
        if Separator.PAIR in piece.apart or (
            self._row.layout.marks is Marks.CELLS and Separator.MARK in piece.apart
        ):
            self._column += 1
        if piece.is_words:
            self._words(piece.kept[0], rest)
        elif self._is_number(piece, place):
            self._state.leave(Leftover.LAYOUT, piece.separator)
            self._state.leave(Leftover.NUMBER, piece.kept)
        elif self._passes_colon(piece, place):
            self._formula(piece, rest)

    def end(self) -> None:
        """Records the end of the row in the statements that it adds to.

        Conditions in a separate row apply to the statement above, unless the row ends with a colon.
        """
        statements = self._state.cut.statements
        last = [node for piece in self._row.pieces for node in (*piece.nodes, *piece.separator)][-1:]
        is_heading = any(node.text.rstrip("} ").endswith(":") for node in last)
        if self._here is None and statements and not is_heading:
            self._take_waiting(statements[-1:])
        for statement in self._state.cut.statements:
            if self._counts.get(id(statement), 0) != len(statement.nodes):
                end = RowEnd(len(statement.nodes), self._row.number, self._row.labels)
                statement.rows.append(end)

    # The contents of a piece.

    def _is_number(self, piece: Piece, place: int) -> bool:
        is_number = NUMBER.fullmatch(joined([token for node in piece.kept for token in node.tokens]))
        if is_number is None:
            return False
        pieces = self._row.pieces
        is_first = not any(each.kept for each in pieces[:place]) and len(pieces) > place + 1
        is_last = Separator.WIDE in piece.apart and self._here is not None
        return is_last or (is_first and Separator.WIDE in pieces[place + 1].apart)

    def _passes_colon(self, piece: Piece, place: int) -> bool:
        """Removes the colon of “Identity: a = b”, and the name in “L:\\ a = b”; True if nodes remain."""
        before = self._row.pieces[place - 1].apart if place else set()
        if piece.kept[0].name == ":" and Separator.WORDS in before | piece.apart:
            self._state.leave(Leftover.LAYOUT, piece.kept[:1])
            piece.kept = trimmed(piece.kept[1:])
        elif (end := end_of_a_name(piece, self._row.pieces[place + 1 :])) and self._here is None:
            self._state.cut.remarks += piece.kept[:end]
            piece.kept = trimmed(piece.kept[end:])
        if not piece.kept:
            self._state.leave(Leftover.LAYOUT, piece.separator)
        return bool(piece.kept)

    def _formula(self, piece: Piece, rest: Sequence[Piece]) -> None:
        if Separator.FORALL in piece.apart:
            self._state.cut.remarks += piece.separator
            is_limited = piece.relations and not is_range(piece.kept, rest)
            self._put_beside(Role.CONDITION if is_limited else Role.RANGE, piece.kept)
            return
        if not self._place(piece, rest):
            self._state.leave(Leftover.LAYOUT, piece.separator)
        self._said = self._said or self._here is not None
        if self._here is not None and self._here not in self._above.values():
            self._begun.add(self._column)

    def _place(self, piece: Piece, rest: Sequence[Piece]) -> bool:
        """Adds the piece to its statement; True if its separator was added, too."""
        if self._last is not None and self._goes_on_beside(self._last, piece, rest):
            self._last.nodes += [*piece.separator, *piece.kept]
            return True
        self._last = None
        if Separator.COLON in piece.apart:
            self._pending = None
        goes_on = piece.lead in (Kind.RELATION, Kind.IMPLICATION, Kind.INFIX)  # in spite of the words
        goes_on |= self._ends_a_sentence(piece, rest)
        if goes_on or (self._is_quantified and Separator.WIDE in piece.apart):
            self._pending = None
        self._close_bracket(piece)
        if self._pending is not None and not self._begins_definition(piece):
            self._behind_words(self._pending, piece, rest)
            return False
        if self._pending is not None:  # “where R = …” defines R
            self._pending = None
            self._begun.add(self._column)
            self._begin_definition(piece, rest)
            return False
        is_first = self._here is None and self._column not in self._begun
        above = self._above.get(self._column) if is_first else None
        target = self._here if above is None else above
        if target is None:
            if (role := leading_side(piece, rest)) is not None:
                self._put_beside(role, piece.kept)
            else:
                self._begin(piece)
            return False
        if target.explains and above is None and piece.relations and piece.lead is not Kind.RELATION:
            if names_what(piece.kept) and (not self._is_ahead or any(each.relations for each in rest)):
                self._begin_definition(piece, rest)  # where R = …, S = …
                return False
            if self._is_ahead:
                self._begin(piece)
                return False
        rule = below if above is not None else behind
        action, question = rule(target, piece, self._row.layout, rest)
        if action is Action.NEW and above is None and self._are_unknown and piece.relations:
            action = Action.PERHAPS
        return self._act(action, question, target, piece, above is not None)

    def _goes_on_beside(self, last: Beside, piece: Piece, rest: Sequence[Piece]) -> bool:
        """True if the piece continues the formula added next to a statement: i = 1, 2, 3, or a, b \\in V."""
        if not piece.relations:
            return Separator.COMMA in piece.apart and piece.lead not in (Kind.SIGN, Kind.INFIX)
        is_statement = self._here is None and not any(each.relations for each in rest)
        if relation_places(last.nodes) or Separator.WIDE in piece.apart or is_statement:
            return False
        is_side = is_symbol(piece.kept[: piece.relations[0]]) and is_range(piece.kept, rest)
        return Separator.COMMA in piece.apart and is_side

    def _begins_definition(self, piece: Piece) -> bool:
        """True if “where R := …” defines R: it is a statement, and not a condition."""
        return self._pending is Role.CONDITION and self._names_what and names_what(piece.kept)

    def _begin_definition(self, piece: Piece, rest: Sequence[Piece]) -> None:
        """Begins a statement that defines a symbol of those before it in its row.

        Without such a statement, it belongs to the one behind it in the row, or else to all rows above.
        """
        above = [each for each in self._state.cut.statements if not each.explains]
        if piece.kept[-1].name == ":":  # let f = g, h = k: …
            self._state.leave(Leftover.LAYOUT, piece.kept[-1:])
            piece.kept = trimmed(piece.kept[:-1])
        waiting, self._state.waiting = self._state.waiting, []
        statement = self._begin_beside(piece, Role.DEFINITION)
        statement.explains, served, statement.serves = True, statement.serves, ()
        self._state.waiting = waiting
        definition = Beside(Role.DEFINITION, list(piece.kept))
        is_behind = any(not each.explains for each in served)
        self._is_ahead = not (is_behind or (above and not any(each.relations for each in rest)))
        if self._is_ahead:
            self._state.waiting.append(definition)
        for target in above if not (is_behind or self._is_ahead) else ():
            target.beside.append(definition)

    def _begin_beside(self, piece: Piece, role: Role = Role.PERHAPS) -> Statement:
        """Returns a new statement that may be a condition of those before it in its row.

        Without its own mark it does not end the statement at the mark, which the next row continues.
        """
        served = self._served()
        at_mark = self._state.columns.get(self._column)
        statement = self._begin(piece)
        is_marked = Separator.MARK in piece.apart or _has_mark(piece.nodes)
        if at_mark is not None and at_mark in served and _has_mark(at_mark.nodes) and not is_marked:
            self._state.columns[self._column] = at_mark
        for target in served:
            target.beside.append(Beside(role, list(piece.kept)))
        statement.serves = served
        return statement

    def _served(self) -> tuple[Statement, ...]:
        """Returns the statements of the row so far, whose conditions may follow."""
        return tuple(dict.fromkeys([*self._made, *([self._here] if self._here else [])]))

    def _ends_a_sentence(self, piece: Piece, rest: Sequence[Piece]) -> bool:
        """True if the piece is the statement in “if a = 0, b = c”, which has no other."""
        has_statement = self._here is not None or self._state.cut.statements
        is_last = piece.relations and not any(each.relations for each in rest)
        is_apart = bool(piece.apart & {Separator.COMMA, Separator.WIDE})
        return bool(self._state.waiting and is_last and is_apart and not has_statement)

    def _close_bracket(self, piece: Piece) -> None:
        """Removes the end of a bracket that the words before the piece open."""
        if self._in_bracket and piece.kept[-1].kind is Kind.CLOSE and pairs_of(piece.kept)[2] == 1:
            self._state.leave(Leftover.LAYOUT, piece.kept[-1:])
            piece.kept = trimmed(piece.kept[:-1])
            self._in_bracket = False

    def _behind_words(self, role: Role, piece: Piece, rest: Sequence[Piece]) -> None:
        self._is_quantified = not piece.relations
        if not piece.relations:  # for all a, b
            self._state.leave(Leftover.NO_RELATION, piece.kept)
            if limits_without_a_relation(self._pending_words):
                symbols = joined([token for node in piece.kept for token in node.tokens])
                self._limit(f"{self._pending_words} {symbols}")
            return
        is_side = role is Role.CONDITION and is_range(piece.kept, rest)
        self._put_beside(Role.RANGE if is_side else role, piece.kept)

    def _act(self, action: Action, question: str, target: Statement, piece: Piece, is_below: bool) -> bool:
        match action:
            case Action.JOIN:
                if piece.lead is Kind.IMPLICATION and not is_below:
                    target = self._with_premises(target)
                self._state.columns[self._column] = self._here = target
                with_separator = self._append(target, piece, question, is_below)
                if is_below:
                    self._take_waiting([target])
                return with_separator
            case Action.CONDITION | Action.RANGE:
                role = Role.CONDITION if action is Action.CONDITION else Role.RANGE
                self._put_beside(role, piece.kept, of_the_row=Separator.MARK in piece.apart)
            case Action.PERHAPS | Action.OWN_OR_CONDITION:
                made = self._begin(piece) if is_below else self._begin_beside(piece)
                if action is Action.OWN_OR_CONDITION and not is_below:
                    made.is_condition_of = target
            case Action.NEW:
                self._begin(piece)
        return False

    # Words.

    def _words(self, node: Node, rest: Sequence[Piece]) -> None:
        words, maths = words_of(node), maths_of(node)
        role = role_of(words)
        self._are_unknown = role is WordRole.REMARK
        self._names_what = says_what_is(words) or (self._names_what and words == "and")
        self._last = None
        spoken = joined(node.tokens)
        self._in_bracket = spoken.count("(") > spoken.count(")")
        if self._here is not None and self._is_in_a_formula(self._here, role, rest):
            self._here.nodes.append(node)
            self._pending = None
            return
        relates = role is not WordRole.DENIAL and any(map(relation_places, maths))
        if relates and (lead := lead_of(words)) is not None:
            self._formula_in_words(node, maths, _ROLES[lead])
            return
        if role is WordRole.CONNECTION and self._here is not None:
            self._here.nodes.append(node)
            self._here.nodes.append(Node(Kind.IMPLICATION, [], name="words"))
            self._here.whole = True
            self._pending = None
            return
        self._state.cut.remarks.append(node)
        is_followed = any(piece.kept and not piece.is_words for piece in rest)
        if role is WordRole.DENIAL and (self._here is None or is_followed):
            self._state.denial = node
        elif role is WordRole.DENIAL and self._here is not None:
            self._here.denied = node
        elif role in _ROLES and is_followed:
            self._pending, self._pending_words, self._is_quantified = _ROLES[role], words, False
            return
        elif role is not WordRole.JOIN and limits(words):
            self._limit(words)
        if not (role is WordRole.JOIN and words == "and"):
            self._pending = None

    def _is_in_a_formula(self, here: Statement, role: WordRole, rest: Sequence[Piece]) -> bool:
        """True if the formula cannot be read without these words: x is parallel to y."""
        behind_it = next((piece for piece in rest if piece.kept), None)
        if behind_it is None:  # f is smooth
            return role is WordRole.REMARK and not relation_places(here.nodes)
        if behind_it.is_words or Separator.MARK in behind_it.apart:
            return False
        goes_on = behind_it.lead in (Kind.RELATION, Kind.SIGN, Kind.INFIX, Kind.IMPLICATION)
        is_open = not relation_places(here.nodes)
        if role is WordRole.JOIN:
            return is_open and not goes_on
        return role is WordRole.REMARK and not goes_on and (is_open or not behind_it.relations)

    def _formula_in_words(self, node: Node, maths: Sequence[list[Node]], role: Role) -> None:
        for nodes in maths:
            if relation_places(nodes):
                is_side = role is Role.CONDITION and is_range(trimmed(nodes))
                self._put_beside(Role.RANGE if is_side else role, nodes)
        said = [each for nodes in maths if relation_places(nodes) for each in nodes]
        self._state.cut.remarks.append(Node(Kind.WORDS, without([node], *said)))
        self._pending = None


def _has_mark(nodes: Sequence[Node]) -> bool:
    return any(node.kind is Kind.MARK for node in nodes)
