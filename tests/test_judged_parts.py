"""Memory is transparent: warm, cold, shared or off, and in any order, the results are the same."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import Field, dataclass, fields, replace
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import workbench
from workbench.app.commands.commands import main
from workbench.app.pipeline.judge_claims import ClaimJudge
from workbench.app.pipeline.verdict_keys import Keys
from workbench.context.claim_parts import ClaimSource, Edit, Mend, Sentence
from workbench.context.claims import (
    Ambiguity,
    Claim,
    ClaimContext,
    ClaimProof,
    Correction,
    Formula,
    Notation,
    OnMotions,
    Robot,
    Stated,
)
from workbench.context.facts import Act, Fact, Origin, Provider, Supposition
from workbench.context.index_values import Orders
from workbench.core.construct import number, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.spans import Span
from workbench.core.terms import Definition, Relation, Symbol
from workbench.core.types import SCALAR, VECTOR, Declaration, Type
from workbench.core.verdict import Strength
from workbench.language.definitions import Definitions
from workbench.language.goals.goals import Atom
from workbench.language.naming.defined_names import DefinedNames
from workbench.language.naming.known_frames import KnownFrames
from workbench.language.naming.notations import Notations
from workbench.language.naming.reading_conventions import Conventions, Gradient, Points, Relaxation
from workbench.language.naming.symbols import SymbolTable
from workbench.papers import load_paper
from workbench.prover.explain.canonical_text import by_fields, canonical_text
from workbench.prover.explain.judged_parts import UNSEEN, JudgedParts

HEAD = "%! workbench: symbols.'a' = { kind = \"vector\" }\n"
QUATERNION = HEAD + (
    "%! workbench: symbols.'q' = { kind = \"quaternion\" }\n"
    '%! workbench: conventions.quaternion = "hamilton, scalar first"\n'
)
SQUARE = r"\[ a^2 = -\lVert a \rVert^2 \]"
MATRIX = HEAD + "%! workbench: symbols.'I' = { kind = \"tensor\" }\n"
IMPLIED = r"f = g \Rightarrow f a = g a"
NUMBERS = "".join(f"%! workbench: symbols.'{each}' = {{ kind = \"scalar\" }}\n" for each in "fg")


@dataclass(frozen=True)
class Asked:
    """A file for `workbench check`, or the arguments of `workbench.check`."""

    text: str | None = None
    suffix: str = ".tex"
    formula: str = ""
    arguments: tuple[tuple[str, Any], ...] = ()

    def answer(self, folder: Path) -> Any:
        """All that is told of it."""
        if self.text is None:
            return workbench.check(self.formula, **dict(self.arguments)).verdict.to_dict()
        path = folder / f"p{self.suffix}"
        path.write_text(self.text)
        return json.loads(CliRunner().invoke(main, ["check", str(path), "--json", "--no-proposals"]).stdout)


def by_check(formula: str, **arguments: Any) -> Asked:
    return Asked(formula=formula, arguments=tuple(arguments.items()))


TENSOR = {"a": "vector", "I": "tensor"}
SCALARS = {"a": "vector", "f": "scalar", "g": "scalar"}
DEFINED = NUMBERS + "%! workbench: definitions.'f' = 'g g'\n"

#: Pairs that differ in one thing on which a verdict depends.
PAIRS = [
    (Asked(QUATERNION + SQUARE), Asked(HEAD + SQUARE)),
    (Asked(MATRIX + r"\[ I I a = I a \]"), by_check("I I a = I a", symbols=TENSOR)),
    (
        Asked(HEAD + DEFINED + rf"\[ {IMPLIED} \]"),
        by_check(IMPLIED, symbols=SCALARS, definitions={"f": "g g"}),
    ),
]
MODEL = {
    "symbols.'a'": 'kind = "vector"',
    "symbols.'b'": 'kind = "vector"',
    "symbols.'c'": 'kind = "vector"',
    "symbols.'f'": 'kind = "scalar", of = ["a"]',
    "symbols.'R'": 'kind = "tensor"',
    "symbols.'x'": 'kind = "scalar"',
}
FORMULAS = [
    r"a^2 = -\lVert a \rVert^2",
    r"R R^T = \mathbf{I}",
    r"R a = R^T a",
    r"a \times b \times c = (a \times b) \times c",
    r"\sin(x)^2 + \cos(x)^2 = 1",
    r"\frac{d}{dt} x a = x \dot{a} + \dot{x} a",
    r"\frac{d}{dt} x b = \dot{x} b",
    r"\frac{\partial f}{\partial a} b = x",
    r"a \cdot b = b \cdot a",
    r"a b c = c b a",
    r"x + 1 = 2 x",
    r"\lVert b \rVert = 1",
    r"\lVert x b \rVert = x \lVert b \rVert",
    r"b \cdot a = 0",
]
#: More of a model, each of which changes some verdict.
CHANGES = {
    "unit": {"symbols.'b'": 'kind = "vector", unit = true'},
    "constant": {"symbols.'b'": 'kind = "vector", constant = true'},
    "positive": {"symbols.'x'": 'kind = "scalar", positive = true'},
    "symmetric": {"symbols.'R'": 'kind = "tensor", symmetric = true'},
    "rotation": {"symbols.'R'": 'kind = "rotation"'},
    "quaternion": {
        "symbols.'q'": 'kind = "quaternion"',
        "conventions.quaternion": "hamilton, scalar first",
    },
    "column": {"conventions.gradient": "column"},
    "row": {"conventions.gradient": "row"},
    "dyads": {"conventions.products": "dyads"},
    "powers": {"conventions.powers": "values"},
    "cross": {"conventions.cross": "right"},
    "defined": {"definitions.'b'": r"a \times c"},
    "defined norm": {"definitions.'x'": r"\lVert a \rVert"},
}


def text(change: str | None = None) -> str:
    """A text whose model has the change."""
    said = MODEL | (CHANGES[change] if change else {})
    head = [f"%! workbench: {key} = {_toml(key, value)}" for key, value in said.items()]
    return "\n".join([*head, *(rf"\[ {formula} \]" for formula in FORMULAS)])


def _toml(key: str, value: Any) -> str:
    if key.startswith("symbols"):
        return f"{{ {value} }}"
    return f"'{value}'" if isinstance(value, str) else json.dumps(value)


ASKED = [
    *(each for pair in PAIRS for each in pair),
    *(Asked(text(change)) for change in (None, *CHANGES)),
]


@pytest.fixture(scope="module")
def cold(tmp_path_factory: pytest.TempPathFactory) -> list[Any]:
    """The answer to each with no memory."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("WORKBENCH_CACHE", "/dev/null")
        return [each.answer(tmp_path_factory.mktemp("cold")) for each in ASKED]


@pytest.mark.parametrize("backwards", [False, True])
def test_shared_memory_changes_no_answer(
    backwards: bool, cold: list[Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("WORKBENCH_CACHE", str(tmp_path / "shared"))
    order = list(enumerate(ASKED))[:: -1 if backwards else 1]
    for _ in range(2):
        for place, asked in order:
            folder = tmp_path / str(place)
            folder.mkdir(exist_ok=True)
            assert told_of(asked.answer(folder)) == told_of(cold[place]), asked


def told_of(answer: Any) -> str:
    """The answer without the folder of its file."""
    return re.sub(r'"[^"]*/p\.tex', '"p.tex', json.dumps(answer))


@pytest.mark.parametrize("pair", PAIRS, ids=["quaternion", "text", "implication"])
def test_both_of_a_pair_get_answers_of_their_own(
    pair: tuple[Asked, Asked], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = []
    for place, order in enumerate(permutations(range(2))):
        monkeypatch.setenv("WORKBENCH_CACHE", str(tmp_path / f"memory {place}"))
        answers = {each: pair[each].answer(tmp_path) for each in order}
        seen.append([_verdicts(answers[each]) for each in range(2)])
    assert seen[0] == seen[1] and seen[0][0] != seen[0][1]


def _verdicts(answer: Any) -> Any:
    claims = answer.get("claims", [{"verdict": answer.get("outcome")}])
    return [claim["verdict"] for claim in claims]


X, Y = (Relation("=", *(symbol(Declaration(Name(letter), SCALAR)),) * 2) for letter in "xy")
FORMULAS_OF = [Formula(letter, said) for letter, said in (("x = x", X), ("y = y", Y))]
FACT = Fact(X, frozenset({Name("x")}), Origin(Provider.FORMULA, "x = x", "1"), Strength.STATED)
#: Two values of each kind of field.
VALUES: dict[str, tuple[Any, Any]] = {
    "str": ("one", "two"),
    "bool": (False, True),
    "int": (1, 2),
    "Path": (Path("one"), Path("two")),
    "Formula": tuple(FORMULAS_OF),
    "Orders": (Orders({"n": range(1, 3)}), Orders({"n": range(1, 4)})),
    "Stated": (Stated("x", Atom(X), Atom(X)), Stated("x", Atom(X), Atom(Y))),
    "Mend": (Mend(), Mend(place="there")),
    "tuple[Edit, ...]": ((), (Edit("a", "b", is_math=True),)),
    "Span": (None, Span(Path("p"), 1, 2, 3, 4)),
    "Name": (Name("x"), Name("y")),
    "tuple[str, ...]": (("one",), ("two",)),
    "tuple[tuple[str, str], ...]": ((), (("rotation", "the rotation matrix"),)),
    "tuple[Formula, ...]": ((FORMULAS_OF[0],), (FORMULAS_OF[1],)),
    "tuple[Fact, ...]": ((FACT,), (replace(FACT, earlier=False),)),
    "tuple[Act, Symbol | None]": ((Act.ASSERT, None), (Act.DEFINE, X.left)),
    "frozenset[Name]": (frozenset({Name("x")}), frozenset({Name("y")})),
    "frozenset[str]": (frozenset({"cos"}), frozenset({"sin"})),
    "frozenset[Relaxation]": (frozenset({Relaxation.DYADS}), frozenset({Relaxation.UNIT_TENSOR})),
    "Gradient": tuple(Gradient),
    "Points": tuple(Points),
    "Mapping[str, OnMotions]": ({"1": OnMotions(none="algebra")}, {"1": OnMotions(none="words")}),
    "Definitions": (Definitions(), Definitions([Definition(X.left.declaration, (), (), number(1))])),
    "Mapping[Symbol, str]": ({X.left: "r"}, {X.left: "v"}),
    "SymbolTable": (SymbolTable(), SymbolTable(conventions=Conventions(Gradient.ROW))),
    "Mapping[Name, Declaration]": tuple(
        {Name("x"): Declaration(Name("x"), kind)} for kind in (SCALAR, VECTOR)
    ),
    "Mapping[Name, tuple[Declaration, ...]]": tuple(
        {Name("x"): (Declaration(Name("u"), kind),)} for kind in (SCALAR, VECTOR)
    ),
    "Mapping[Name, tuple[tuple[Linear, ...], ...]]": ({Name("x"): ((),)}, {Name("x"): ((Linear(1),),)}),
    "Mapping[Name, tuple[Type, ...]]": ({Name("x"): (SCALAR,)}, {Name("x"): (VECTOR,)}),
    "Mapping[Name, tuple[Path, int]]": ({}, {Name("x"): (Path("one"), 1)}),
    "frozenset[Named]": (frozenset({Name("x")}), frozenset({Name("y")})),
    "Notations": (
        Notations(),
        Notations.build({"|x|": {"where": {"x": "vector"}, "means": r"\lVert x \rVert"}}),
    ),
    "Mapping[str, Term]": tuple({"A": symbol(Declaration(Name(u), VECTOR), ())} for u in "xy"),
    "Mapping[Name, frozenset[Name]]": ({Name("x"): frozenset()}, {Name("x"): frozenset({Name("y")})}),
    "Mapping[Name, tuple[Term, Term] | None]": (
        {Name("x"): None},
        {Name("x"): (X.left, X.left)},
    ),
}
CLAIM = Claim("1", FORMULAS_OF[0], Notation(SymbolTable(), Definitions(), {}))
#: What only a reader of formulas asks a table for. A part is for judges; the test of a guarded table below
#: shows that they do not ask for it.
FOR_READERS = {
    (SymbolTable, "arguments"),
    *((DefinedNames, name) for name in ("untyped", "primitive", "arguments")),
}


def values_of(each: Field) -> tuple[Any, Any]:
    kind = each.type.removesuffix(" | None")
    return VALUES[kind]


#: The fields of claims and of tables that are dataclasses, by their types.
PARTS_OF_CLAIMS = {
    ClaimSource: "source",
    Mend: "mend",
    Correction: "correction",
    Sentence: "sentence",
    ClaimProof: "proof",
    ClaimContext: "context",
    Ambiguity: "ambiguity",
}
PARTS_OF_TABLES = {DefinedNames: "defined", KnownFrames: "frames", Conventions: "conventions"}


def fields_within(whole: type, parts: Mapping[type, str], *but: str) -> list[tuple[type, Field]]:
    """The fields by which values of the type are compared; those of its parts instead of the parts."""
    own = [(whole, each) for each in fields(whole) if each.name not in (*parts.values(), *but)]
    return [*own, *((part, each) for part in parts for each in fields(part) if each.compare)]


def with_each_value(one: Any, kind: type, field: Field) -> list[Any]:
    """Two values like that one, which differ in that field, or in that field of a part of it."""
    name = {**PARTS_OF_CLAIMS, **PARTS_OF_TABLES}.get(kind)
    part = one if name is None else getattr(one, name)
    made = [replace(part, **{field.name: value}) for value in values_of(field)]
    return made if name is None else [replace(one, **{name: each}) for each in made]


def ids(found: Iterable[tuple[type, Field]]) -> list[str]:
    return [f"{kind.__name__}.{each.name}" for kind, each in found]


FIELDS_OF_CLAIMS = fields_within(Claim, PARTS_OF_CLAIMS, "notation")
FIELDS_OF_TABLES = fields_within(SymbolTable, PARTS_OF_TABLES)


def key_of(claim: Claim) -> str:
    return Keys({}, {}).of(claim, "printed")


@pytest.mark.parametrize(("kind", "field"), FIELDS_OF_CLAIMS, ids=ids(FIELDS_OF_CLAIMS))
def test_judges_see_each_field_in_the_key_and_no_other(kind: type, field: Field) -> None:
    one, other = with_each_value(CLAIM, kind, field)
    parts = [
        canonical_text(
            [getattr(JudgedParts().of(each), f.name) for f in fields(Claim) if f.name != "notation"]
        )
        for each in (one, other)
    ]
    is_unseen = (PARTS_OF_CLAIMS.get(kind) or field.name) in UNSEEN
    assert (parts[0] == parts[1]) == is_unseen
    assert (key_of(one) == key_of(other)) == is_unseen


def whole(notation: Notation) -> Claim:
    """A claim whose proof may use all of the notation."""
    return replace(CLAIM, notation=notation, proof=ClaimProof(VALUES["Stated"][0]))


@pytest.mark.parametrize("field", fields(Notation), ids=lambda each: each.name)
@pytest.mark.parametrize("claim", [whole, lambda notation: replace(CLAIM, notation=notation)])
def test_each_field_of_a_notation_is_in_the_key(
    field: Field, claim: Callable[[Notation], Claim], tmp_path: Path
) -> None:
    files = [tmp_path / name for name in ("one.urdf", "two.urdf")]
    for file in files:
        file.write_text(file.name)
    VALUES["Robot"] = tuple(Robot(file, "body") for file in files)
    one, other = (replace(CLAIM.notation, **{field.name: value}) for value in values_of(field))
    assert key_of(claim(one)) != key_of(claim(other))


@pytest.mark.parametrize(("kind", "field"), FIELDS_OF_TABLES, ids=ids(FIELDS_OF_TABLES))
@pytest.mark.parametrize("is_whole", [True, False])
def test_each_field_of_a_table_is_in_the_key(kind: type, field: Field, is_whole: bool) -> None:
    tables = with_each_value(SymbolTable(), kind, field)
    notations = [Notation(table, Definitions(), {}) for table in tables]
    keys = {key_of(whole(each) if is_whole else replace(CLAIM, notation=each)) for each in notations}
    assert len(keys) == (1 if not is_whole and (kind, field.name) in FOR_READERS else 2)


@pytest.mark.parametrize(
    "kind",
    [
        Declaration,
        Name,
        Type,
        Linear,
        Formula,
        Fact,
        Origin,
        Supposition,
        Orders,
        OnMotions,
        Relation,
        Symbol,
        Definition,
    ],
)
def test_each_field_of_a_part_changes_the_key(kind: type) -> None:
    """Whatever fields are added, two values that differ are told apart."""
    made = [object.__new__(kind) for _ in range(2)]
    for changed in (each for each in fields(kind) if each.compare):
        for place, one in enumerate(made):
            for each in fields(kind):
                object.__setattr__(one, each.name, ("other" if each is changed and place else "same"))
        texts = [by_fields(kind)(one).text for one in made]
        assert texts[0] != texts[1], changed.name


class GuardedClaim(Claim):
    """A claim that only `JudgedParts` may look at while it is guarded."""

    guarded = False

    def __getattribute__(self, name: str) -> Any:
        if GuardedClaim.guarded and name in SEEN_BY_NOBODY:
            raise AssertionError(f"a judge asks for {name}")
        return object.__getattribute__(self, name)


SEEN_BY_NOBODY = frozenset(each.name for each in fields(Claim))


def _get_unless_for_readers(kind: type) -> Callable[[Any, str], Any]:
    def get(self: Any, name: str) -> Any:
        if (kind, name) in FOR_READERS:
            raise AssertionError(f"a judge asks a part for {name}")
        return object.__getattribute__(self, name)

    return get


class GuardedTable(SymbolTable):
    """A part of a table that is asked for nothing that readers need."""

    __getattribute__ = _get_unless_for_readers(SymbolTable)


class GuardedNames(DefinedNames):
    """The same of defined names."""

    __getattribute__ = _get_unless_for_readers(DefinedNames)


def guarded(table: SymbolTable) -> SymbolTable:
    parts = {each.name: getattr(table, each.name) for each in fields(table)}
    names = {each.name: getattr(table.defined, each.name) for each in fields(DefinedNames)}
    return GuardedTable(**parts | {"defined": GuardedNames(**names)})


@pytest.mark.parametrize("change", [None, *CHANGES])
def test_judges_ask_for_nothing_that_the_key_leaves_out(
    change: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "p.tex").write_text(text(change))
    claims = load_paper(tmp_path / "p.tex").claims
    named = [
        GuardedClaim(**{each.name: getattr(claim, each.name) for each in fields(Claim)}) for claim in claims
    ]
    bare = ClaimJudge(claims, motions=False)
    expected = [bare._verdict_on((claim.id, "printed")) for claim in claims]
    part_of, of = SymbolTable.part, JudgedParts.of

    def unguarded(self: JudgedParts, claim: Claim) -> Claim:
        GuardedClaim.guarded = False
        try:
            return of(self, claim)
        finally:
            GuardedClaim.guarded = True

    monkeypatch.setattr(SymbolTable, "part", lambda self, names: guarded(part_of(self, names)))
    monkeypatch.setattr(JudgedParts, "of", unguarded)
    judge = ClaimJudge(named, motions=False)
    try:
        found = [judge._verdict_on((claim.id, "printed")) for claim in claims]
    finally:
        GuardedClaim.guarded = False
    assert found == expected
