"""What a paper declares in [notation] is printed as its author writes it, and is read as it was."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from hypothesis import HealthCheck, given, settings

from tests.language.generated import TABLE, VARIABLES, terms
from workbench import check
from workbench.core.construct import zero
from workbench.core.formula_errors import ReadError
from workbench.core.integer_instances import free_integers
from workbench.core.terms import Conjunction, Equivalence, Implication, Relation, Statement, Term
from workbench.language.author_notation import AuthorNotation
from workbench.language.naming.known_frames import KnownFrames
from workbench.language.naming.reading_conventions import Conventions, Gradient
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term
from workbench.papers.installed_papers import installed_names
from workbench.papers.load import load_installed

VECTOR, TENSOR = {"x": "vector"}, {"x": "tensor"}
#: Several hands: what one of them has, the others write otherwise.
HANDS = (
    {
        r"x^\wedge": {"where": VECTOR, "means": r"\operatorname{skew}(x)"},
        "x'": {"where": TENSOR, "means": "x^T"},
        r"x \wedge y": {"where": {"x": "vector", "y": "vector"}, "means": r"x \times y"},
        r"\mathds{1}": {"means": r"\mathbf{I}"},
    },
    {
        r"\hat{x}": {"where": VECTOR, "means": r"\operatorname{skew}(x)"},
        "x'": {"where": VECTOR, "means": r"\dot{x}"},
        r"[x, y]": {"where": {"x": "tensor", "y": "tensor"}, "means": "x y - y x"},
        r"x \vee y": {"where": {"x": "vector", "y": "vector"}, "means": r"x \otimes y"},
        r"x^\dagger": {"where": TENSOR, "means": "x^{-1}"},
        r"\mathbb{I}_{3 \times 3}": {"means": r"\mathbf{I}"},
        r"\mathrm{S}_x": {"where": VECTOR, "means": r"x \otimes x"},
    },
    {
        r"[x]_\times": {"where": VECTOR, "means": r"\operatorname{skew}(x)"},
        r"\check{x}": {"where": {"x": "dual vector"}, "means": r"\operatorname{skew}(x)"},
        r"x^\vee": {"where": TENSOR, "means": r"\operatorname{vect}(x)"},
        r"\langle x, y \rangle": {"where": {"x": "vector", "y": "vector"}, "means": r"x \cdot y"},
        "1": {"means": r"\mathbf{I}"},
    },
)
TABLES = [TABLE.with_notations({k: v for k, v in specs.items() if k != "1"}) for specs in HANDS]
KNOWN = [AuthorNotation(table) for table in TABLES]


def relations(statement: Statement) -> Iterator[Relation]:
    match statement:
        case Relation():
            yield statement
        case Conjunction(parts=parts):
            for part in parts:
                yield from relations(part)
        case Implication(left=left, right=right) | Equivalence(left=left, right=right):
            yield from (*relations(left), *relations(right))


def written(term, hand: AuthorNotation) -> str:
    with printed_for(hand):
        return to_latex(term)


@settings(max_examples=120, suppress_health_check=list(HealthCheck))
@given(terms)
def test_terms_in_the_authors_spelling_read_back(term: Term) -> None:
    for table, hand in zip(TABLES, KNOWN, strict=True):
        assert read_term(written(term, hand), table, VARIABLES) == term


@pytest.mark.slow
@settings(max_examples=10_000, suppress_health_check=list(HealthCheck))
@given(terms)
def test_terms_in_the_authors_spelling_read_back_many_times(term: Term) -> None:
    for table, hand in zip(TABLES, KNOWN, strict=True):
        assert read_term(written(term, hand), table, VARIABLES) == term


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name == "rotational-motion" else pytest.mark.slow)
        for name in installed_names()
    ],
)
def test_all_that_an_installed_paper_says_reads_as_it_was(name: str) -> None:
    hands = {}
    for claim in load_installed(name).claims:
        table = claim.notation.symbols
        hand = hands.setdefault(id(table), AuthorNotation(table))
        if hand.is_plain:
            continue
        forms = [form for form in (claim.printed, claim.reading, claim.corrected) if form is not None]
        for said in (r for f in forms if f.statement is not None for r in relations(f.statement)):
            text = written(said, hand)
            integers = free_integers(said.left) | free_integers(said.right)
            assert read(text, table, integers) == (said,), (claim.id, text)


OWN = SymbolTable.build(
    {
        **{name: {"kind": "vector"} for name in ("a", "v", r"{}_B\omega_{IB}", r"\hat{n}", "n")},
        **{name: {"kind": "tensor"} for name in ("T", r"\mathbf{I}")},
        **{name: {"kind": "hamilton quaternion"} for name in "pq"},
        "f": {"kind": "scalar"},
    }
).with_notations(
    {
        r"\hat{x}": {"where": VECTOR, "means": r"\operatorname{skew}(x)"},
        "x'": {"where": VECTOR, "means": r"\dot{x}"},
        "y'": {"where": {"y": "tensor"}, "means": "y^T"},
        r"z^\vee": {"where": {"z": "tensor"}, "means": r"\operatorname{vect}(z)"},
        r"q^\dagger": {"where": {"q": "quaternion"}, "means": r"\operatorname{conj}(q)"},
        "p * q": {"where": {"p": "quaternion", "q": "quaternion"}, "means": "p q"},
        "[s, v]": {"where": {"s": "scalar", "v": "vector"}, "means": r"\operatorname{quat}(s, v)"},
        r"\mathds{1}": {"means": r"\mathbf{I}_{3\times 3}"},
    }
)


@pytest.mark.parametrize(
    ("formula", "shown"),
    [
        (r"\tilde{v} a = \dot{a}", r"\hat{v} a = a'"),
        (r"\operatorname{skew}({}_B\omega_{IB}) a = v", r"{}_{B}\hat{\omega}_{I B} a = v"),
        (r"\tilde{n} a = \hat{n}", r"\tilde{n} a = \hat{n}"),  # \hat{n} is another symbol
        (r"\frac{d}{dt} \tilde{v} = \widetilde{\dot{v}}", r"\dot{\hat{v}} = \hat{\dot{v}}"),
        (r"T^T = (T \tilde{v})^T T", r"T' = \left(T \hat{v}\right)' T"),
        (
            r"p q = \operatorname{conj}(p q) \operatorname{quat}(f, v)",
            r"p * q = \left(p * q\right)^{\dagger} * [f, v]",
        ),
        (r"\mathbf{I} \dot{v} = \mathbf{I}_{3 \times 3} a", r"\mathbf{I} v' = \mathds{1} a"),
        (r"\ddot{v} = a", r"\ddot{v} = a"),
        (r"\operatorname{vect} T = \operatorname{vect} (T T)", r"T^{\vee} = \left(T T\right)^{\vee}"),
    ],
)
def test_a_term_is_spelt_as_its_author_spells_it(formula: str, shown: str) -> None:
    (said,) = read(formula, OWN)
    assert written(said, AuthorNotation(OWN)) == shown
    assert read(shown, OWN) == (said,)


def test_with_a_bold_i_as_inertia_the_unit_tensor_shows_its_size() -> None:
    table = SymbolTable.build({"a": {"kind": "vector"}, r"\mathbf{I}": {"kind": "tensor"}})
    (said,) = read(r"\mathbf{I}_{3 \times 3} a = \mathbf{I} a", table)
    assert written(said, AuthorNotation(table)) == r"\mathbf{I}_{3 \times 3} a = \mathbf{I} a"
    assert read(written(said, AuthorNotation(table)), table) == (said,)


def test_verdicts_and_proposals_are_in_the_hand_of_the_author(tmp_path) -> None:
    paper = tmp_path / "paper.toml"
    paper.write_text(
        "title = 'p'\n[symbols]\na = 'vector'\nb = 'vector'\n'\\mathbf{I}' = { kind = 'tensor', symmetric = true }\n"
        "[notation]\n\"x'\" = { where = { x = 'vector' }, means = '\\dot{x}' }\n"
        "'x^\\wedge' = { where = { x = 'vector' }, means = '\\operatorname{skew}(x)' }\n",
        encoding="utf-8",
    )
    false = check(r"\frac{d}{dt} (\mathbf{I} a) = \dot{\mathbf{I}} a - \mathbf{I} \dot{a}", notation=paper)
    assert false.verdict.read_back.endswith(r"\dot{\mathbf{I}} a - \mathbf{I} a'")
    assert "a'" in false.verdict.counterexample.values
    (best, *_) = false.repair().proposals
    assert best.latex.endswith(r"\dot{\mathbf{I}} a + \mathbf{I} a'")
    assert "a'" in best.edit
    true = check(r"\tilde{a} b = a \times b", notation=paper)
    assert true.verdict.read_back == r"a^{\wedge} b = a \times b"


def test_the_gradient_of_a_scalar_is_printed_as_a_column() -> None:
    specs = {"w": {"kind": "vector"}, "f": {"kind": "scalar", "of": ["w"]}}
    table = replace(SymbolTable.build(specs), conventions=Conventions(gradient=Gradient.COLUMN))
    (said,) = read(r"\frac{\partial f}{\partial w} \cdot \dot{w} = \dot{f}", table)
    assert read(written(said, AuthorNotation(table)), table) == (said,)


@pytest.mark.parametrize("order", [2, 3])
def test_an_order_in_brackets_differentiates_where_dots_do(order: int) -> None:
    spin = read_term("w", TWO_FRAMES)
    for frames in ({"A": zero(spin.type)}, {"A": spin}):
        table = replace(TWO_FRAMES, frames=KnownFrames(velocities=frames, dot="A"))
        dots = rf"\{'d' * order}ot{{v}}"
        (said,) = read(rf"v^{{({order})}} = {dots}", table)
        assert said.left == said.right


TWO_FRAMES = SymbolTable.build({"v": {"kind": "vector"}, "w": {"kind": "vector"}})


SELECT = r"\begin{bmatrix} 1 & 0 & 0 & 0 \\ 0 & 1 & 0 & 0 \\ 0 & 0 & 1 & 0 \end{bmatrix}"
LAST = r"\begin{bmatrix} 0 \\ 0 \\ 0 \\ 1 \end{bmatrix}"
TURN = f"{SELECT} H {SELECT}^T"
WORDS = SymbolTable.build(
    {
        **{name: {"kind": "vector"} for name in "xy"},
        **{name: {"kind": "matrix 6×1"} for name in "VW"},
        **{name: {"kind": "transform"} for name in "GH"},
        **{name: {"kind": "scalar"} for name in "ad"},
    }
).with_notations(
    {
        r"\operatorname{Exp}(x)": {"where": VECTOR, "means": r"\exp(\operatorname{skew}(x))"},
        r"\mathrm{ad}(x)": {"where": VECTOR, "means": r"\operatorname{skew}(x)"},
        r"\mathrm{Ad}_{H}": {
            "where": {"H": "matrix 4×4"},
            "means": rf"\begin{{bmatrix}} {TURN} & 0 \\ \operatorname{{skew}}({SELECT} H {LAST}) {TURN} & {TURN} \end{{bmatrix}}",
        },
    }
)


@pytest.mark.parametrize(
    ("formula", "shown"),
    [
        (r"\exp(\tilde{x}) y = \mathrm{Exp}(x) y", r"\operatorname{Exp} (x) y = \operatorname{Exp} (x) y"),
        (
            r"\mathrm{Ad}_{GH} V = \mathrm{Ad}_G \operatorname{Ad}_H V",
            r"\operatorname{Ad}_{G H} V = \operatorname{Ad}_{G} \operatorname{Ad}_{H} V",
        ),
        (r"\mathrm{Ad}_H^{-1} V = W", r"\operatorname{Ad}_{H}^{-1} V = W"),
        (r"\operatorname{ad}(x) y = x", r"\operatorname{ad} (x) y = x"),
        ("ad = a^2", "a d = a^{2}"),  # a product
    ],
)
def test_a_word_is_an_operation_of_the_paper(formula: str, shown: str) -> None:
    (said,) = read(formula, WORDS)
    assert written(said, AuthorNotation(WORDS)) == shown
    assert read(shown, WORDS) == (said,)


@pytest.mark.parametrize(
    "formula",
    [
        r"\operatorname{Foo}(x) = y",
        r"\mathrm{Exp}(G) = y",
        r"\mathrm{Exp} x = y",
        r"\operatorname{Log}(G) = x",
        r"\mathrm{Ad}_x V = V",
        r"\mathrm{Ad} V = V",
    ],
)
def test_a_word_that_nothing_explains_is_refused(formula: str) -> None:
    with pytest.raises(ReadError, match=r"words in a formula|logarithms"):
        read(formula, WORDS)
