"""Named sets and maps:

S = \\{ pattern \\mid conditions \\} f : A \\to B, f(x) = …   or   f : A \\to B, x \\mapsto …   or   x
\\mapsto …
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeGuard

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import relation
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    Block,
    Conjunction,
    DualUnit,
    IllFormed,
    Implication,
    Naming,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
)
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.elaboration.ranges import set_name
from workbench.language.elaboration.sets import (
    Members,
    bound_letter,
    letter_name,
    letter_spelling,
    members_of,
)
from workbench.language.grammar.syntax import Bracket, Chain, Node, Product, Scripted
from workbench.language.naming.linear_indices import linear
from workbench.language.printing.printer import to_latex

Read = Callable[[Elaborator, Node], Statement]

_ARROWS = frozenset(":→↦")
_OPEN_MAP = "a map is said by f : A \\to B and f(x) = …, or by x \\mapsto …"


def is_map(clause: Node) -> TypeGuard[Chain]:
    return isinstance(clause, Chain) and any(sign in _ARROWS for sign, _ in clause.relations)


def is_set(clause: Node) -> TypeGuard[Chain]:
    """True if the clause is S = {… | …}."""
    match clause:
        case Chain(sides=(_, Bracket(kind="\\{", parts=(_, *conditions))), relations=(("=", _),)):
            return any(isinstance(condition, Chain) for condition in conditions)
    return False


def wants_value(clause: Node) -> bool:
    """True for f : A → B without a value of f(x), which the next clause must give."""
    return is_map(clause) and "↦" not in _signs(clause)


def _signs(clause: Node | None) -> list[str]:
    return [sign for sign, _ in clause.relations] if isinstance(clause, Chain) else []


# Maps.


def named_map(reader: Elaborator, clause: Chain, value: Any) -> Naming:
    """Returns a map: its values must be members of the second set. Raises Fault and TypeMismatch."""
    sides, signs = list(clause.sides), _signs(clause)
    name = sides.pop(0) if signs[0] == ":" else None
    begin = "" if name is None else f"{_shown(name)} : "
    match signs[name is not None :], _signs(value):
        case ["↦"], []:
            return _rule(reader, begin, *sides)
        case ["→"], ["="]:
            argument, body = _argument(value.sides[0], name), value.sides[1]
            middle = f", {_shown(name)}(", ") = "
        case ["→"], ["↦"]:
            argument, body = value.sides
            middle = ", ", " \\mapsto "
        case _:
            raise Fault(_OPEN_MAP, clause.at)
    domain, codomain = map(_known, sides)
    bound = bound_letter(reader.table, argument, domain) if _is_new(reader, argument) else None
    inner = reader if bound is None else Elaborator(bound[0], reader.variables)
    point, image = inner.term(argument), _value(inner, body)
    given = _conditions(domain, point, argument.at, seen=False)
    parts = _implied(given, _conditions(codomain, image, body.at))
    if name is not None and letter_name(name) in reader.table.functions and _signs(value) == ["="]:
        parts.append(reader.build(value.at, relation, "=", inner.term(value.sides[0]), image))
    said = to_latex(point).join(middle) + to_latex(image)
    said = f"{begin}{domain.name} \\to {codomain.name}{said}"
    return Naming(said, (point, image), tuple(parts), tuple(given))


def _rule(reader: Elaborator, begin: str, argument: Node, body: Node) -> Naming:
    """Returns x ↦ …, for a declared symbol x."""
    if _is_new(reader, argument):
        raise Fault(SyntaxCode.SET_WRITE_F_B(), argument.at)
    point, image = reader.term(argument), _value(reader, body)
    return Naming(f"{begin}{to_latex(point)} \\mapsto {to_latex(image)}", (point, image), ())


def _argument(applied: Node, name: Node | None) -> Node:
    """Returns the x of f(x). Raises Fault."""
    match applied:
        case Product(items=(head, Bracket(kind="(", parts=(argument,)))) if _shown(head) == _shown(name):
            return argument
    raise Fault(_OPEN_MAP, applied.at)


def _value(reader: Elaborator, body: Node) -> Term:
    if isinstance(body, Bracket) and body.kind == "\\{" and any(isinstance(p, Chain) for p in body.parts):
        raise TypeMismatch(IllFormed(TypeCode.SETS_AS_VALUES()), body.at)
    return reader.term(body)


def _is_new(reader: Elaborator, node: Node) -> bool:
    spelling = letter_spelling(node)
    return spelling is not None and reader.table.find(spelling) is None


def _shown(name: Node | None) -> str:
    """Returns the name of a map: a letter, or the inverse of one."""
    power, plain = None, name
    if isinstance(name, Scripted) and name.sup is not None:
        power, plain = linear(name.sup, ()), Scripted(name.at, name.nucleus, name.sub, None, name.primes)
    shown = None if plain is None else letter_name(plain)
    if shown is None or power not in (None, Linear(-1)):
        raise Fault(SyntaxCode.EXPECTED_NAME_MAP_SUCH(), 0 if name is None else name.at)
    return str(shown) if power is None else f"{shown}^{{-1}}"


def _known(where: Node) -> Members:
    members = members_of(where)
    if members is None:
        raise Fault(SyntaxCode.SET_NOT_KNOWN_HERE(set_name=set_name(where)), where.at)
    return members


def _conditions(members: Members, term: Term, at: int, seen: bool = True) -> list[Relation]:
    """Returns the conditions for the term to be a member.

    seen: Whether the form of the term must show them; otherwise there may be none. Raises Fault.
    """
    try:
        return members.conditions(term)
    except IllFormed as fault:
        raise TypeMismatch(fault, at) from None
    except NotImplementedError as unseen:
        if seen:
            raise Fault(str(unseen), at) from None
        return []


# Sets.


@dataclass
class _Described:
    """The contents of the braces: the pattern, its letters with their sets, other relations."""

    pattern: Node
    domains: list[tuple[Node, Members]] = field(default_factory=list)
    held: list[Chain] = field(default_factory=list)

    @staticmethod
    def of(bracket: Bracket) -> _Described:
        pattern, *rest = bracket.parts
        described = _Described(pattern)
        if isinstance(pattern, Chain):
            if _signs(pattern) != ["∈"]:
                message = SyntaxCode.EXPECTED_MEMBER_FIRST()
                raise Fault(message, pattern.at)
            described.pattern = pattern.sides[0]
            rest = [pattern, *rest]
        waiting: list[Node] = []
        for part in rest:
            if isinstance(part, Chain) and _signs(part) == ["∈"]:
                members = _known(part.sides[1])
                described.domains += [(node, members) for node in (*waiting, part.sides[0])]
                waiting = []
            elif isinstance(part, Chain):
                described.held.append(part)
            else:
                waiting.append(part)
        if waiting:
            raise Fault(SyntaxCode.EXPECTED_SET_BEHIND_X(), waiting[0].at)
        return described


def named_set(reader: Elaborator, clause: Chain, read: Read) -> Naming:
    """Returns a set by a pattern and the domains of its letters. Raises Fault and TypeMismatch.

    Conditions without a letter must be true; a known set must have exactly these members.
    """
    name, bracket = clause.sides
    assert isinstance(bracket, Bracket), "a set"
    described = _Described.of(bracket)
    table = reader.table
    letters: dict[Symbol, Members] = {}
    sorts: list[str] = []
    others: list[tuple[Node, Members]] = []
    given: list[Statement] = []
    for node, members in described.domains:
        bound = bound_letter(table, node, members)
        if bound is None:
            others.append((node, members))
            continue
        table, letter = bound
        letters[letter] = members
        given += _conditions(members, letter, node.at, seen=False)
        sorts.append(f"{letter.declaration.name} \\in {members.name}")
    of_letters = list(given)
    inner = Elaborator(table, reader.variables)
    member = inner.term(described.pattern)
    said: list[Statement] = [read(inner, part) for part in described.held]
    for node, members in others:
        said += _conditions(members, inner.term(node), node.at)
    names = {letter.declaration.name for letter in letters}
    given += [statement for statement in said if _speaks_of(statement, names)]
    parts: list[Statement] = [statement for statement in said if statement not in given]
    known, undecided = members_of(name), None
    if known is not None:
        wanted = _conditions(known, member, described.pattern.at)
        parts += _implied(given, wanted)
        if member in letters and _is_any(member, known):
            parts += _implied(wanted, given)
        elif given != of_letters or not _is_general(member, letters, known):
            undecided = VerdictCode.UNDECIDED_MEMBERS(set=known.name)
    title = set_name(name) if known is None else known.name
    shown = ", ".join([*sorts, *map(to_latex, said)])
    text = f"{title} = \\{{ {to_latex(member)} \\mid {shown} \\}}"
    return Naming(text, (member,), tuple(parts), tuple(given), undecided)


def _implied(given: Sequence[Statement], wanted: Sequence[Statement]) -> list[Statement]:
    missing = [statement for statement in wanted if statement not in given]
    if not given:
        return missing
    premise = given[0] if len(given) == 1 else Conjunction(tuple(given))
    return [Implication(premise, statement) for statement in missing]


def _is_any(letter: Symbol, of: Members) -> bool:
    """True if the letter stands for all members, or for all of their type."""
    return letter.declaration in (
        each.letter(letter.declaration.name) for each in (of, replace(of, trait=""))
    )


def _is_general(member: Term, letters: Mapping[Symbol, Members], known: Members) -> bool:
    """True for a pattern that each member of the known set fits.

    It is a + ε b with two letters for a dual number or vector, x̃ for a skew tensor, the matrix of a rotation
    and a vector for a displacement.
    """

    def is_any(term: Term, trait: str) -> bool:
        domain = letters.get(term) if isinstance(term, Symbol) else None
        return (
            domain is not None
            and isinstance(term, Symbol)
            and domain.trait == trait
            and _is_any(term, domain)
        )

    match member:
        case Apply(head="add", arguments=(real, Apply(head="mul", arguments=(DualUnit(), dual)))):
            return real != dual and is_any(real, "") and is_any(dual, "")
        case Apply(head="skew", arguments=(vector,)) if known.trait == "skew":
            return is_any(vector, "")
        case Block() if known.trait == "displacement" and [len(row) for row in member.entries] == [2, 2]:
            (turn, shift), (none, one) = member.entries
            is_last = isinstance(none, Zero) and isinstance(one, Number) and one.value == 1
            return is_last and is_any(turn, "rotation") and is_any(shift, "")
    return False


def _speaks_of(statement: Statement, names: set[Name]) -> bool:
    match statement:
        case Relation():
            terms = (statement.left, statement.right)
        case Conjunction(parts=parts):
            return any(_speaks_of(part, names) for part in parts)
        case _:
            return True
    return any(p.declaration.name in names for t in terms for p in t.symbols())
