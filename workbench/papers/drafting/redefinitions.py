"""Scopes of a text: redefined rotations, and the parts of a unit quaternion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from workbench.papers.drafting.drafted_definitions import Formula, Proposed
from workbench.papers.drafting.formula_shapes import SCALAR_PARTS, components_of
from workbench.papers.drafting.inference.kind_operations import SYMBOL
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.sentence_kinds import Quaternion
from workbench.papers.drafting.typefaces import Guess
from workbench.source.documents import Display

#: Each scope reads all definitions again; this is the limit of such readings.
_MOST_READ = 200
_TURNS = ("rotation", "transform")


@dataclass
class Scope:
    """Symbols (with their entries as TOML) and definitions in force from a display on. why: the reason."""

    display: Display
    why: str
    symbols: dict[str, str] = field(default_factory=dict)
    definitions: dict[str, str] = field(default_factory=dict)

    @property
    def start(self) -> str:
        """The value of `from`: the label of the display, or its line."""
        return next(iter(self.display.labels), f"line {self.display.line}")


@dataclass(frozen=True)
class _Given:
    """A display with a letter alone on the left: its index, the letter, the formula, the symbols used."""

    place: int
    name: str
    body: str
    uses: frozenset[str]


def scopes_of(
    displays: Sequence[Display],
    formulas: Sequence[Formula],
    guesses: Mapping[str, Guess],
    defined: Mapping[str, Proposed],
    quaternions: Sequence[Quaternion],
) -> list[Scope]:
    """Returns the scopes of a text, in order."""
    places = {id(display): index for index, display in enumerate(displays)}
    users: dict[str, list[int]] = {}
    for formula in formulas:
        for name in formula.outcome.symbols:
            users.setdefault(name, []).append(places[id(formula.display)])
    given = list(given_in(formulas, places))
    found = [scope for each in quaternions for scope in _parts(each, displays, given, defined, guesses)]
    taken = {(name, scope.display.section) for scope in found for name in scope.definitions}
    for each in given:
        display = displays[each.place]
        guess = guesses.get(each.name)
        is_turn = guess is not None and guess.kind in _TURNS and each.name not in defined
        if not is_turn or (each.name, display.section) in taken or users[each.name][0] >= each.place:
            continue
        free = each.uses - defined.keys()
        if any(
            displays[users[name][0]].section == display.section and users[name][0] > users[each.name][0]
            for name in free
            if name in users
        ):
            found.append(Scope(display, f"gives {each.name}", definitions={each.name: each.body}))
    most = _MOST_READ // max(len(defined), 1) // 2
    found = sorted(found, key=lambda scope: places[id(scope.display)])[:most]
    ends = [end for scope in found for end in _end(scope, displays, places, users, guesses)]
    return sorted([*found, *ends], key=lambda scope: places[id(scope.display)])


def parted_quaternions(quaternions: Sequence[Quaternion], guesses: Mapping[str, Guess]) -> frozenset[str]:
    """Returns the unit quaternions whose parts a scope defines."""
    return frozenset(each.name for each in quaternions if _scalar_and_vector(each, guesses))


def given_in(formulas: Sequence[Formula], places: Mapping[int, int]) -> Iterator[_Given]:
    walker = Walker()
    for formula in formulas:
        trees = operations_of(formula.latex, walker)
        if len(trees) == 1 and trees[0].op == "equal" and trees[0].parts[0].op == SYMBOL:
            left, right = trees[0].parts
            if left.text not in right.names and formula.outcome.statements:
                body = formula.latex.partition("=")[2].strip()
                yield _Given(places[id(formula.display)], left.text, body, frozenset(right.names))


def _parts(
    quaternion: Quaternion,
    displays: Sequence[Display],
    given: Sequence[_Given],
    defined: Mapping[str, Proposed],
    guesses: Mapping[str, Guess],
) -> Iterator[Scope]:
    """Yields the scope of a unit quaternion, from the first display after the sentence about it."""
    behind = [d for d in displays if d.line >= quaternion.line]
    names = _scalar_and_vector(quaternion, guesses)
    if not behind or not names:
        return
    first = behind[0]
    own = {'kind = "hamilton quaternion"', "unit = true"}
    scope = Scope(first, "a sentence says that it is a unit quaternion")
    scope.symbols[quaternion.name] = "{ " + ", ".join(sorted(own)) + " }"
    scope.definitions |= names
    for part in names.keys() & defined.keys():
        if len(components := components_of(defined[part].body)) == 3:
            scope.definitions |= _of_vector_part(components, quaternion.name)
    for each in given:
        guess = guesses.get(each.name)
        is_turn = (
            guess is not None and guess.kind == "rotation" and displays[each.place].section == first.section
        )
        if is_turn and each.uses & names.keys():
            scope.definitions.setdefault(each.name, each.body)
    yield scope


def _scalar_and_vector(quaternion: Quaternion, guesses: Mapping[str, Guess]) -> dict[str, str]:
    """Returns the definitions of the parts of a quaternion; none if their roles are unclear."""
    name, parts = quaternion.name, quaternion.parts
    if name in guesses and guesses[name].kind != "hamilton quaternion":
        return {}
    kinds = [guesses[part].kind if part in guesses else "" for part in parts]
    if sorted(kinds) == ["scalar", "vector"]:
        heads = {"scalar": "Sc", "vector": "Vec"}
        return {
            part: rf"\operatorname{{{heads[kind]}}} {name}" for part, kind in zip(parts, kinds, strict=True)
        }
    scalar = [part for part in parts if part.rstrip("}").endswith(SCALAR_PARTS)]
    if kinds != ["scalar"] * 4 or len(scalar) != 1:
        return {}
    others = [part for part in parts if part not in scalar]
    found = {scalar[0]: rf"\operatorname{{Sc}} {name}"}
    return found | _of_vector_part(others, name)


def _of_vector_part(components: Sequence[str], name: str) -> dict[str, str]:
    """Returns the definitions of the components of a quaternion's vector part."""
    found = {}
    for index, part in enumerate(components):
        row = " & ".join(str(int(index == at)) for at in range(3))
        found[part] = rf"\begin{{bmatrix}} {row} \end{{bmatrix}} \operatorname{{Vec}} {name}"
    return found


def _end(
    scope: Scope,
    displays: Sequence[Display],
    places: Mapping[int, int],
    users: Mapping[str, Sequence[int]],
    guesses: Mapping[str, Guess],
) -> Iterator[Scope]:
    """Yields the scope of the next section, in which a rotation is free again, if it occurs there."""
    start = places[id(scope.display)]
    nxt = next((p for p in range(start, len(displays)) if displays[p].section != scope.display.section), None)
    names = [name for name in scope.definitions if guesses[name].kind in _TURNS] if nxt is not None else []
    kept = {name: f'"{guesses[name].kind}"' for name in names if any(p >= (nxt or 0) for p in users[name])}
    if nxt is not None and kept:
        yield Scope(displays[nxt], "another section", symbols=kept)
