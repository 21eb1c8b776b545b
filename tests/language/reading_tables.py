"""The tables of symbols that the lines of `readings/` are read with, and what a line says of what is read."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import fields, replace
from functools import cache
from typing import Any

from tests.language.field_kinds import TABLE as FIELD
from workbench.core.formula_errors import Fault, IllFormedAt, ReadError, SpecError
from workbench.core.names import Name
from workbench.core.terms import IllFormed, Naming, Statement, Symbol, Term
from workbench.core.types import Declaration
from workbench.language.definition_entries import read_definitions
from workbench.language.grammar.formula_tokens import tokenize
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.naming.known_frames import KnownFrames
from workbench.language.naming.notations import Notation
from workbench.language.naming.reading_conventions import Conventions, Gradient, Points, Relaxation
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula, read_term
from workbench.source.rows.formula_lines import split_lines, whole_line

PLAIN = """
\\lambda scalar;  \\mu scalar;  \\underline{s} dual scalar;  c_{ij} scalar;  x vector;  y vector;  z_n vector
\\underline{x} dual vector;  A tensor;  B tensor;  \\underline{A} dual tensor;  R rotation;  R_1 rotation
g transform;  H matrix 4×4;  u matrix 6×1;  J matrix 6×7;  P operator;  q_1 scalar;  DV vector;  \\Delta x vector
[BN] rotation;  \\vec{AB} vector;  {}^a v_b vector;  x' vector;  a^{[n]} vector;  x_{rel} vector
"""
TRAITS: dict[str, dict[str, Any]] = {
    "e": {"kind": "vector", "unit": True},
    "f": {"kind": "scalar", "of": ["q_1"]},
    r"\omega": {"kind": "vector", "weight": 1},
    r"\Phi_n": {"kind": "tensor", "weight": "n"},
    "r": {"kind": "vector", "coordinate": True},
    r"\rho": {"kind": "scalar", "constant": True},
    "m": {"kind": "scalar", "positive": True},
    r"\epsilon": {"kind": "scalar", "small": True},
}
QUATERNIONS = (
    "q hamilton quaternion;  p hamilton quaternion;  \\underline{q} dual hamilton quaternion;  k_4 matrix 4×1"
)
#: A few symbols, so that each other letter is unknown; and one of each kind.
FEWER = (
    "\\lambda scalar;  \\mu scalar;  x vector;  y vector;  A tensor;  B tensor;  H matrix 4×4;  u matrix 6×1"
)
EACH_KIND = """
\\lambda scalar;  \\underline{s} dual scalar;  x vector;  y vector;  z_n vector;  \\underline{x} dual vector;  A tensor
\\underline{A} dual tensor;  R rotation;  \\underline{R} dual rotation;  g transform;  H matrix 4×4;  u matrix 6×1
J matrix 6×7;  q hamilton quaternion
"""
NOTATION = {
    r"x^\wedge": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
    r"x^\vee": {"where": {"x": "tensor"}, "means": r"\operatorname{vect}(x)"},
    r"[x]_\times": {"where": {"x": "vector"}, "means": r"\tilde{x}"},
    r"\hat{x}": {"where": {"x": "vector"}, "means": r"\tilde{x}"},
    "x'": {"where": {"x": "tensor"}, "means": "x^T"},
    r"x \wedge y": {"where": {"x": "vector", "y": "vector"}, "means": r"x \times y"},
    r"\mathds{1}": {"means": r"\mathbf{I}"},
    "[x, y]": {"where": {"x": "tensor", "y": "tensor"}, "means": "x y - y x"},
    "S(x)": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
    r"\mathrm{c} x": {"where": {"x": "scalar"}, "means": r"\cos x"},
    r"x_\perp": {"where": {"x": "vector"}, "means": "x - e"},
    r"\operatorname{Exp}(x)": {"where": {"x": "tensor"}, "means": r"\exp(x)"},
    r"x \times": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
}
#: The symbols that definitions and notations stand beside.
OWN = "s scalar;  S tensor;  c_n vector;  P_n operator;  \\underline{d} dual vector;  x vector;  y vector"
OWN_TRAITS = {
    "a": {"kind": "vector", "weight": 1},
    "b": {"kind": "vector", "weight": 1},
    "w_n": {"kind": "vector", "weight": "n"},
    "h": {"kind": "vector", "constant": True},
}
#: Names with labels, and what may be an argument.
LABELS = """
x vector;  x_B vector;  x_{1,B} vector;  x_n vector;  C rotation;  C_B rotation;  \\tilde{y}_B vector;  y scalar
\\operatorname{Ad}_T matrix 6×6;  t_0 scalar;  u matrix 6×1;  A tensor;  s scalar;  CoM vector;  x_{\\text{rel}} vector
x_{cm} vector;  \\hat{n} vector;  {}^0 T_1 transform;  k_R scalar;  x^{B/A} vector;  p_{t|t-1} vector;  d scalar
"""
#: Names and words as they are printed in texts on robots.
PRINTED = """
\\nabla_{x,y} f matrix 3×3;  f vector;  \\phi scalar;  \\theta scalar;  l scalar;  w scalar;  u matrix 6×1;  R rotation
{}^A_B R rotation;  {}^A q vector;  {}^B q vector;  {}^B v_{A,B} matrix 6×1;  x vector;  y vector;  g rotation
p_{\\hat{a}} vector;  p_{\\tilde{b}} vector;  p_{\\dot{c}} vector;  A tensor
"""
PRINTED_NOTATION = {
    r"\mathrm{Ad}_g(x)": {"where": {"g": "rotation", "x": "vector"}, "means": "g x"},
    r"\mathrm{ad} x": {"where": {"x": "matrix 6×1"}, "means": r"(x^T x) \mathbf{I}_{6\times 6}"},
    r"V \times": {"where": {"V": "matrix 6×1"}, "means": r"(V^T V) \mathbf{I}_{6\times 6}"},
    r"\lfloor x \times\rfloor": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
    r"\langle b, c\rangle": {"means": r"\phi"},
}
#: Symbols with powers of 1/time.
WEIGHTS = {
    r"\omega": {"kind": "vector", "weight": 1},
    r"\mathbf{v}": {"kind": "vector", "weight": 1},
    r"\mathbf{S}": {"kind": "tensor", "weight": 1},
    r"\Phi_n": {"kind": "tensor", "weight": "n"},
    r"\mathbf{P}_n": {"kind": "operator"},
    r"\alpha": {"kind": "scalar", "weight": 1},
    r"\beta": {"kind": "scalar", "weight": 0},
    r"\underline{\mathbf{a}}": {"kind": "dual vector", "weight": 1},
}
#: The symbols of definitions with powers of 1/time.
DEFINED = {
    r"\omega": {"kind": "vector", "weight": 1},
    r"\mathbf{v}": {"kind": "vector", "weight": 1},
    r"\mathbf{w}": {"kind": "vector", "weight": 2},
    r"\mathbf{R}": {"kind": "rotation", "weight": 0},
    r"\mathbf{c}_n": {"kind": "vector", "weight": "n"},
    r"x": {"kind": "vector", "weight": 1},
    r"\mathbf{P}_n": {"kind": "operator", "weight": "n-1"},
    r"\mathbf{T}": {"kind": "tensor"},
}
#: What texts print without a word of explanation.
AUTHORS = """
x scalar;  y scalar;  z scalar;  \\alpha scalar;  \\beta scalar;  \\Delta t scalar;  \\Delta scalar
\\Delta\\mathbf{x}_k vector;  \\mathbf{p} tensor;  \\mathbf{q} tensor;  \\mathbf{q}_n vector;  q_{t+1} scalar;  v vector
w vector;  R rotation;  R_{\\text{3-2-1}} rotation;  v_\\mathcal{B} vector;  {x_D}_0 scalar;  \\vec{v_a}_b vector
R_{i \\to b} rotation;  R_{b \\to i} rotation;  R_{\\text{3-1-3}} rotation
"""
AUTHORS_NOTATION = {
    sign: {"where": {"a": "vector"}, "means": r"\tilde{a}"}
    for sign in (r"\lfloor a \rfloor_\times", r"[a \times]", "[a]")
}
VARIABLES = ("n", "k_1")


def kinds(text: str) -> dict[str, dict[str, Any]]:
    """x vector;  A tensor → what [symbols] says of them."""
    pairs = [entry.strip() for line in text.split("\n") for entry in line.split(";") if entry.strip()]
    found = {}
    for pair in pairs:
        at = min(pair.find(f" {kind}") for kind in KIND_WORDS if f" {kind}" in pair)
        found[pair[:at].strip()] = {"kind": pair[at:].strip()}
    return found


#: The readings that some paper takes.
LOOSE = (
    Relaxation.DYADS,
    Relaxation.UNIT_TENSOR,
    Relaxation.POWERS_OF_VALUES,
    Relaxation.FACTORS_IN_BRACKETS,
)
KIND_WORDS = ("dual", "scalar", "vector", "tensor", "rotation", "transform", "matrix", "operator", "hamilton")


@cache
def tables() -> dict[str, SymbolTable]:
    plain = SymbolTable.build(kinds(PLAIN) | TRAITS)
    own = {name: spec for name, spec in (kinds(PLAIN) | TRAITS).items() if name != "x'"}
    spins = SymbolTable.build(kinds(PLAIN) | TRAITS | kinds("w vector"))
    frames = replace(
        spins,
        frames=KnownFrames(
            velocities={"A": read_term(r"\mathbf{0}", spins), "B": read_term("w", spins)},
            orientations={"B": read_term("R", spins)},
            dot="A",
        ),
    )
    labels = SymbolTable.build(kinds(LABELS))
    fewer = SymbolTable.build(kinds(FEWER) | kinds(QUATERNIONS))
    points, moved = (
        replace(
            plain,
            conventions=Conventions(points=convention),
            frames=KnownFrames(directions=frozenset({Name("e"), Name("y")})),
        )
        for convention in (Points.HOMOGENEOUS, Points.VECTORS)
    )
    return {
        "plain": plain,
        "quaternions": SymbolTable.build(kinds(PLAIN) | TRAITS | kinds(QUATERNIONS)),
        "notation": SymbolTable.build(own).with_notations(NOTATION),
        "rows": replace(plain, conventions=Conventions(gradient=Gradient.ROW)),
        "columns": replace(plain, conventions=Conventions(gradient=Gradient.COLUMN)),
        "frames": frames,
        "frames without a dot": replace(frames, frames=replace(frames.frames, dot=None)),
        "arguments": replace(plain, arguments=frozenset({Name("q", sub=("1",))})),
        "instants": replace(labels, arguments=frozenset({Name("t", sub=("0",))})),
        "points": points,
        "moved points": moved,
        "labels": labels,
        "printed": SymbolTable.build(kinds(PRINTED)).with_notations(PRINTED_NOTATION),
        "own": SymbolTable.build(kinds(OWN) | OWN_TRAITS),
        "fewer": SymbolTable.build(kinds(FEWER)),
        "fewer with quaternions": fewer,
        "powers of values": replace(fewer, conventions=Conventions().relaxed(Relaxation.POWERS_OF_VALUES)),
        "with a place": SymbolTable.build(kinds(FEWER) | kinds(QUATERNIONS) | {"r": TRAITS["r"]}),
        "defined": SymbolTable.build(DEFINED),
        "weights": SymbolTable.build(WEIGHTS),
        "field": FIELD,
        "authors": SymbolTable.build(kinds(AUTHORS)).with_notations(AUTHORS_NOTATION),
        "each kind": SymbolTable.build(kinds(EACH_KIND) | {"e": TRAITS["e"]}),
    } | {str(each): replace(plain, conventions=Conventions().relaxed(each)) for each in LOOSE}


def outcome(make: Callable[[], str]) -> str:
    try:
        return make()
    except (ReadError, IllFormedAt) as error:
        verdict = "refused" if isinstance(error, ReadError) else "misfit"
        intent = getattr(error, "intent", None)
        hint = f" [{intent}]" if intent else ""
        return f"{verdict} {error.line}:{error.column} {error.message}{hint}"
    except SpecError as error:
        return f"refused {error.key}: {error.message}"
    except IllFormed as error:
        return f"ill-formed {error}"


def _term(latex: str, table: SymbolTable) -> str:
    return _shown(read_term(latex, table, VARIABLES))


def _shown(term: Term) -> str:
    return f"{to_latex(term)} : {term.type}" + (
        f" of weight {term.weight}" if term.weight is not None else ""
    )


def _formula(latex: str, table: SymbolTable, as_condition: bool = False) -> str:
    lines = split_lines(latex) if not as_condition else [whole_line(latex)]
    found = [read_formula(line.latex, table, ("n",), as_condition) for line in lines]
    ranges = (
        f"{r.variable} from {r.lower} to {r.upper}{' as any' if r.generic else ''}"
        for each in found
        for r in each.ranges
    )
    said = (_statement(statement) for each in found for statement in each.statements)
    return " ;; ".join([*said, *dict.fromkeys(ranges)])


def _statement(statement: Statement) -> str:
    """Of a set or a map also what must be true, what is given, and what is not decided."""
    if not isinstance(statement, Naming):
        return to_latex(statement)
    parts = [
        f" | {what} {', '.join(map(to_latex, said))}"
        for what, said in (("must be", statement.parts), ("given", statement.given))
        if said
    ]
    return statement.said + "".join(parts) + (f" | {statement.undecided}" if statement.undecided else "")


def _lines(latex: str, _: SymbolTable) -> str:
    found = (f"{line.latex!r} at {line.place(1, 1)[1]}" for line in split_lines(latex))
    return " ;; ".join(found)


def _symbols(specs: str, _: SymbolTable) -> str:
    table = SymbolTable.build(tomllib.loads(specs.replace(" ;; ", "\n")))
    return " ;; ".join(f"{name}: {declared(d)}" for name, d in sorted(table.symbols.items(), key=str))


def declared(declaration: Declaration) -> str:
    """Whatever a declaration says that is not said where nothing is."""
    said = [str(declaration.name), str(declaration.type)]
    plain = Declaration(declaration.name, declaration.type)
    for field in fields(declaration):
        value = getattr(declaration, field.name)
        if value != getattr(plain, field.name):
            shown = ", ".join(map(_place, value)) if isinstance(value, tuple) else value
            said += sorted(value) if field.name == "flags" else [f"{field.name} {shown}"]
    return " ".join(said)


def _place(value: Any) -> str:
    """A symbol that one is a function of, or the indices of a member that is declared apart."""
    return to_latex(value) if isinstance(value, Symbol) else "".join(map(str, value))


def _tree(latex: str) -> str:
    """The tree as it is written, and again."""
    try:
        written = latex_of(parse(latex))
    except Fault as fault:
        return f"refused {fault.at + 1}: {fault}"
    return written if latex_of(parse(written)) == written else f"{written}, then {latex_of(parse(written))}"


def _tokens(latex: str) -> str:
    """Each with its kind, and the column where it stands."""
    try:
        return "  ".join(f"{token.type} {token} {token.start_pos + 1}" for token in tokenize(latex))
    except Fault as fault:
        return f"refused {fault.at + 1}: {fault}"


#: What is looked up once the definitions are read.
_ASKED = ("K", "K_0", "K_1", "K_2", "K_3", "K_n", "K_{n+1}", "K(a)", "K_2(a)", "c_1", "c_3", "w_2")


def _definitions(specs: str, table: SymbolTable) -> str:
    entries = dict(entry.split(" := ") for entry in specs.split(" ;; "))
    definitions, table = read_definitions(entries, table)
    said = [declared(definition.declaration) for definition in definitions]
    for asked in _ASKED:
        try:
            term = read_term(asked, table, ("n",))
            body = definitions.lookup(term) if isinstance(term, Symbol) else None
        except (ReadError, IllFormedAt, IllFormed):
            continue
        if body is not None:
            said.append(f"{asked} is {_shown(body)}")
    return " ;; ".join(said)


def _notation(spec: str, table: SymbolTable) -> str:
    ((key, entry),) = tomllib.loads(spec).items()
    notation = Notation.read(key, entry)
    table.with_notations({key: entry})
    spelt = notation.spelt({letter: rf"\mathbf{{{letter}}}" for letter in notation.formals})
    places = "".join(f" {letter} {place}" for letter, place in notation.places.items())
    return f"{notation.form}{places}, as in {spelt}"


SORTS: dict[str, Callable[[str, SymbolTable], str]] = {
    "term": _term,
    "formula": _formula,
    "condition": lambda latex, table: _formula(latex, table, True),
    "lines": _lines,
    "tokens": lambda latex, _: _tokens(latex),
    "tree": lambda latex, _: _tree(latex),
    "symbols": _symbols,
    "definitions": _definitions,
    "notation": _notation,
}


def said(sort: str, table: str, text: str) -> str:
    return outcome(lambda: SORTS[sort](text, tables()[table]))
