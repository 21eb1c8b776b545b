"""Goals as propositions of Coq, about the motions of real bodies at an instant `now`.

A letter of V₃ is a constant vector, one of V₃^ℝ a function of time. Equations hold for the values at the
instant (`equal_at now`). 1/x, ‖x‖, cos x and sin x of letters are numbers at that instant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.collector import identifier
from workbench.certificates.emission.emitted_families import prepare
from workbench.certificates.emission.emitted_nodes import APPLICATION, ATOM, KINDS, Node, NotCertified
from workbench.certificates.emission.emitted_suppositions import conditions
from workbench.certificates.emission.emitter import Emitter
from workbench.certificates.reading.meaning import is_written_out
from workbench.certificates.theorem import relations
from workbench.core.construct import symbol
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers
from workbench.core.names import Name
from workbench.core.terms import Apply, Number, Relation, Symbol, Term
from workbench.language.definitions import Definitions
from workbench.language.goals.goals import (
    All,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    Iff,
    Implies,
    Scope,
    Variable,
    atoms,
    inside,
)
from workbench.prover.goals.sequents import kind_of, names_of, relations_of

#: The prefix of propositions that hold at all times.
ALWAYS = "forall now : instant, "

#: Levels of a proposition: a whole one, and one that needs no brackets.
_LOOSE, _TIGHT = 1, 0


class Speaker(Emitter):
    """Writes the terms of goals. known: proofs of premises such as `rotation Q`."""

    def __init__(self, definitions: Definitions) -> None:
        super().__init__(definitions)
        self.several = True
        self.known: dict[str, str] = {}
        self.bound: frozenset[Name] = frozenset()  # the letters of the enclosing quantifiers
        self.less: dict[str, tuple[str, int]] = {}  # integer → (excess, least value)

    @contextmanager
    def within(self) -> Iterator[None]:
        """Opens the scope of a quantifier: its letters and their definitions."""
        kept = dict(self._symbols), dict(self.read_back), set(self._names), dict(self.known)
        around = self.bound, self.integers, self.bounds, dict(self.orders), dict(self.less)
        try:
            yield
        finally:
            self._symbols, self.read_back, self._names, self.known = kept
            self.bound, self.integers, self.bounds, self.orders, self.less = around
            self._made = {}

    def integer(self, letter: str, least: int) -> str:
        """Returns a name for an integer with this least value, up to the end of its scope."""
        name = self.fresh(letter)
        self.integers = {**self.integers, letter: name}
        self.bounds = {**self.bounds, letter: (Linear(least), Linear.variable(letter))}
        return name

    def _new(self, symbol: Symbol) -> Node:
        family = self.families.get(symbol.declaration) if symbol.index else None
        if family is not None and all(place.is_number for place in symbol.index):
            if int(symbol.index[0]) < self.firsts.get(family, 0):
                raise NotCertified(f"the index {symbol.index[0]}")
            text = " ".join([family, *(f"{place}%nat" for place in symbol.index)])
            return Node(symbol.type.dual, KINDS[symbol.type.kind], text, APPLICATION, "?")
        body = self.definitions.lookup(symbol)
        if body is not None and is_written_out(symbol, self.definitions, self.bound):
            return emitted_nodes.embedded(self.term(body), symbol.type.dual)
        return super()._new(symbol)

    def letter(self, variable: Variable, suffix: str = "") -> str:
        """Returns a name for a quantified letter, up to the end of its scope."""
        name = self.fresh(identifier(symbol(variable.declaration)) + suffix)
        self.bound |= {variable.name}
        self.call(symbol(variable.declaration), name)
        return name

    def call(self, letter: Symbol, name: str) -> None:
        kind = KINDS.get(letter.type.kind)
        if kind is None:
            raise NotCertified(emitted_nodes.named(letter.type.kind))
        self.put(letter, Node(letter.type.dual, kind, name, ATOM, "?"))
        self.read_back[name] = letter
        self._made = {}

    def _apply(self, term: Apply) -> Node:
        match term.head, term.arguments:
            case "div", (above, below) if not isinstance(below, Number):
                return emitted_nodes.times(self.over(below), self.term(above))
            case "reciprocal", (below,):
                return self.over(below)
            case "norm", (inner,):
                return self._length(self.term(inner))
            case (("cos" | "sin"), (angle,)) if _is_letter(angle) and not angle.type.dual:
                name = {"cos": "cosine_of", "sin": "sine_of"}[term.head]
                return _number(f"{name} now {self.term(angle).at(ATOM)}")
        return super()._apply(term)

    def over(self, below: Term) -> Node:
        value = self.term(below)
        if value.kind != "Scalar":
            raise NotCertified("a quotient by anything but a scalar")
        if not value.dual:
            return _number(f"over now {value.at(ATOM)}")
        real = emitted_nodes.half("real_part", "Re", value)
        text = f"dual_over {value.at(ATOM)} (over now {real.at(ATOM)})"
        return Node(True, "Scalar", text, APPLICATION, "?")

    def _length(self, value: Node) -> Node:
        if value.kind != "Vector":
            raise NotCertified("a norm of anything but a vector")
        if not value.dual:
            return _number(f"length now {value.at(ATOM)}")
        size = self._length(emitted_nodes.half("real_part", "Re", value)).at(ATOM)
        text = f"dual_length {value.at(ATOM)} {size} (over now {size})"
        return Node(True, "Scalar", text, APPLICATION, "?")


def _number(text: str) -> Node:
    return Node(False, "Scalar", text, APPLICATION, "?")


def _is_letter(term: Term) -> bool:
    return isinstance(term, Symbol) and term.declaration.constant


def binder(variable: Variable, name: str) -> str:
    if variable.argument is not None:
        raise NotCertified("a map")
    own = variable.declaration.type
    if own.kind not in KINDS:
        raise NotCertified(emitted_nodes.named(own.kind))
    return f"({name} : {emitted_nodes.type_name(own.dual, KINDS[own.kind])})"


def said(speaker: Speaker, goal: Goal) -> str:
    """Returns the goal as text. Raises NotCertified if the library cannot express it."""
    return _said(speaker, goal)[0]


def _said(speaker: Speaker, goal: Goal) -> tuple[str, int]:
    match goal:
        case Atom(statement):
            return _all_of([(_relation(speaker, r), _TIGHT) for r in relations(statement)])
        case AtLeast(left, right):
            greater, smaller = speaker.term(left), speaker.term(right)
            return f"at_least now {greater.at(ATOM)} {smaller.at(ATOM)}", _TIGHT
        case Both(parts):
            return _all_of([_said(speaker, part) for part in parts])
        case Implies(premise, conclusion, lasting):
            given = _said(speaker, premise)
            if lasting:
                given = f"{ALWAYS}{given[0]}", _LOOSE
            return f"{_enclosed(given)} -> {_said(speaker, conclusion)[0]}", _LOOSE
        case Iff(left, right):
            sides = (_enclosed(_said(speaker, side)) for side in (left, right))
            return " <-> ".join(sides), _LOOSE
        case All(variables, body):
            with _bound(speaker, variables) as (binders, supposed):
                premises = "".join(f"{one} -> " for one in supposed)
                return f"forall {binders}, {premises}{_said(speaker, body)[0]}", _LOOSE
        case Exists(variables, body, unique):
            with _bound(speaker, variables) as (binders, supposed):
                names = [speaker.symbol(symbol(v.declaration)).text for v in variables]
                all_said = [(one, _TIGHT) for one in supposed]
                all_said.append(_said(speaker, body))
                if unique:
                    all_said.append((only(speaker, variables, names, body), _LOOSE))
                return f"exists {binders}, {_all_of(all_said)[0]}", _LOOSE
        case AllFrom(integer, least, body):
            with _closed(speaker):
                name = speaker.integer(integer, least)
                return f"{every(name, least)}{_said(speaker, body)[0]}", _LOOSE
    raise NotCertified(kind_of(goal))


def _bound_names(goal: Goal) -> Iterator[Name]:
    """Yields the letters that the quantifiers of a goal bind."""
    if isinstance(goal, All | Exists):
        yield from (variable.name for variable in goal.variables)
    for part in inside(goal):
        yield from _bound_names(part)


def speak_of_what_is_free(speaker: Speaker, goal: Goal, scope: Scope, by_families: bool = False) -> None:
    """Writes the free symbols of the paper and their definitions before the goal.

    by_families: writes single members as members of their families.
    """
    bound = set(_bound_names(goal))
    for member in families_in(goal):
        if by_families:
            places = (Linear.variable(f"i{index}") for index, _ in enumerate(member.index))
            member = symbol(member.declaration, tuple(places))
        if not names_of(member, scope) & bound:
            prepare(speaker, member)
    terms = _terms(goal)
    while terms:
        for part in terms.pop(0).walk():
            if names_of(part, scope) & bound:
                if isinstance(part, Symbol) and part.declaration.name not in bound:
                    body = scope.definitions.lookup(part)
                    terms += [] if body is None else [body]
            elif free_integers(part):
                continue
            elif isinstance(part, Symbol) and part.type.kind != "operator":
                speaker.symbol(part)
            elif isinstance(part, Apply) and (
                part.head in ("cos", "sin") or part.arguments[0].type.kind == "operator"
            ):
                speaker.term(part)


def families_in(goal: Goal) -> list[Symbol]:
    """Returns the members of families in the goal."""
    return [part for term in _terms(goal) for part in term.symbols() if part.index]


def _terms(goal: Goal) -> list[Term]:
    return [side for one in atoms(goal) for r in relations_of(one) for side in (r.left, r.right)]


def every(name: str, least: int) -> str:
    """Returns the quantifier over natural numbers from a least value on."""
    return f"forall {name} : nat, " + (f"({least} <= {name})%nat -> " if least else "")


def only(speaker: Speaker, variables: Sequence[Variable], names: Sequence[str], body: Goal) -> str:
    """Returns the uniqueness part: any other members that satisfy the body are equal to these names."""
    with _bound(speaker, variables, "'") as (binders, supposed):
        others = [speaker.symbol(symbol(v.declaration)).text for v in variables]
        given = "".join(f"{one} -> " for one in [*supposed, _enclosed(_said(speaker, body))])
        same = [
            (equal(v.declaration.type.dual, a, b), _TIGHT)
            for v, a, b in zip(variables, others, names, strict=True)
        ]
        return f"forall {binders}, {given}{_all_of(same)[0]}"


@contextmanager
def _bound(
    speaker: Speaker, variables: Sequence[Variable], suffix: str = ""
) -> Iterator[tuple[str, list[str]]]:
    """Yields the binders of a quantifier, and the premises on its letters."""
    with _closed(speaker):
        names = [speaker.letter(v, suffix) for v in variables]
        binders = " ".join(binder(v, n) for v, n in zip(variables, names, strict=True))
        pairs = zip(variables, names, strict=True)
        yield binders, [said for v, n in pairs for said in conditions(v.declaration, n)]


@contextmanager
def _closed(speaker: Speaker) -> Iterator[None]:
    """Opens the scope of a quantifier, in which nothing can be defined."""
    lines = len(speaker.statement)
    with speaker.within():
        yield
    if len(speaker.statement) != lines:
        raise NotCertified("a definition within a goal")


def _relation(speaker: Speaker, one: Relation) -> str:
    left, right = sides(speaker, one)
    text = equal(left.dual, left.at(ATOM), right.at(ATOM))
    return text if one.operator == "=" else f"~ {text}"


def sides(speaker: Speaker, one: Relation) -> tuple[Node, ...]:
    for side in (one.left, one.right):
        if side.type.kind not in KINDS:
            raise NotCertified(emitted_nodes.named(side.type.kind))
    return emitted_nodes.together((speaker.term(one.left), speaker.term(one.right)))


def equal(dual: bool, left: str, right: str) -> str:
    return f"equal_at {'(d := true) ' if dual else ''}now {left} {right}"


def _all_of(parts: Sequence[tuple[str, int]]) -> tuple[str, int]:
    if len(parts) == 1:
        return parts[0]
    return " /\\ ".join(_enclosed(p) for p in parts), _LOOSE


def _enclosed(part: tuple[str, int]) -> str:
    text, level = part
    return text if level == _TIGHT else f"({text})"
