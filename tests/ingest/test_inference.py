"""The kinds that are inferred of whole texts, and laws of the inference."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import pytest
from ingest.true_kinds import TRUE, UNSEEN, symbols_of

from workbench.papers.drafting.draft_model import ingest
from workbench.papers.drafting.inference.infer import Inference, Source, infer, kind_name
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.words_on_symbols import Prose

#: Texts that take a moment, and the symbols of them that are known to be wrong.
QUICK = [path for path in TRUE if "errata" in path or "multibody" in path or "two_link" in path]


def test_at_least_97_of_100_symbols_have_their_kind() -> None:
    symbols = [symbol for path in QUICK for symbol in symbols_of(path)]
    wrong = [symbol for symbol in symbols if not symbol.is_right]
    assert len(symbols) > 200 and len(wrong) <= 3 * len(symbols) / 100, wrong


@pytest.mark.slow
def test_at_least_97_of_100_symbols_of_all_texts_have_their_kind() -> None:
    symbols = [symbol for path in TRUE for symbol in symbols_of(path)]
    wrong = [symbol for symbol in symbols if not symbol.is_right]
    assert len(symbols) == 371 and len(wrong) <= 3 * len(symbols) / 100, wrong


def test_90_percent_of_unseen_symbols_get_the_right_kind() -> None:
    symbols = [symbol for path in UNSEEN for symbol in symbols_of(path)]
    wrong = [symbol for symbol in symbols if not symbol.is_right]
    assert len(symbols) > 50 and len(wrong) <= len(symbols) / 10, wrong


def kinds(*formulas: str, words: str = "") -> dict[str, str]:
    found = infer([Source(latex) for latex in formulas], Prose(words))
    return {name: kind_name(own.kind) for name, own in found.kinds.items()}


FORMULAS = [
    ((r"a \times b = c",), dict.fromkeys("abc", "vector")),
    ((r"\mathbf{R} \mathbf{R}^T = \mathbf{I}", r"\mathbf{x} = \mathbf{R} \mathbf{y}"), {r"\mathbf{R}": "tensor", r"\mathbf{x}": "vector"}),
    ((r"T = \begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix}",), {"T": "matrix 4×4", "R": "tensor", "p": "vector"}),
    ((r"\det J = l_1 l_2 \sin\theta", r"J = \begin{bmatrix} a & b \\ c & d \end{bmatrix}"), {"J": "matrix 2×2", "a": "scalar"}),
    ((r"S(\omega) v = \omega \times v", r"\dot{R} = S(\omega) R"), {r"\omega": "vector", "v": "vector", "R": "tensor"}),
    ((r"\hat{\omega} v = \omega \times v", r"\widehat{R \omega} = R \hat{\omega} R^T"), {r"\omega": "vector", "R": "tensor"}),
    ((r"M(q) \ddot{q} + C(q, \dot{q}) \dot{q} = \tau",), {"M": "matrix n×n", "q": "matrix n×1", r"\tau": "matrix n×1"}),
    ((r"i^2 = j^2 = k^2 = i j k = -1",), dict.fromkeys("ijk", "hamilton quaternion")),
]  # fmt: skip


@pytest.mark.parametrize(("formulas", "expected"), FORMULAS, ids=[formulas[0] for formulas, _ in FORMULAS])
def test_kinds_are_those_under_which_formulas_fit(
    formulas: tuple[str, ...], expected: dict[str, str]
) -> None:
    assert kinds(*formulas).items() >= expected.items()


def test_kinds_do_not_depend_on_the_order_of_formulas() -> None:
    for formulas, _ in FORMULAS:
        assert kinds(*formulas) == kinds(*reversed(formulas))


RENAMED = {"a": "u", "b": "v", "c": "w", "d": "z"}


@pytest.mark.parametrize(
    "latex", [r"a \times (b \times c) = (a \cdot c) b - (a \cdot b) c", r"d = a \cdot (b \times c)"]
)
def test_renaming_letters_of_one_face_renames_their_kinds(latex: str) -> None:
    renamed = re.sub(r"\\[a-z]+|[a-d]", lambda found: RENAMED.get(found[0], found[0]), latex)
    assert kinds(renamed) == {RENAMED[name]: kind for name, kind in kinds(latex).items()}


def misfits(*formulas: str) -> tuple[str, ...]:
    found: Inference = infer([Source(latex) for latex in formulas], Prose(""))
    return tuple(dict.fromkeys(misfit.latex for misfit in found.misfits))


def test_a_formula_that_fits_no_kinds_is_a_misfit() -> None:
    good = [
        r"\mathbf{a} = \mathbf{B} \mathbf{c}",
        r"\mathbf{d} = \mathbf{a} \times \mathbf{c}",
        r"s = \mathbf{a} \cdot \mathbf{c}",
    ]
    assert misfits(*good) == ()
    assert misfits(*good, r"\sin \mathbf{d} = \mathbf{a} \times s") == (
        r"\sin \mathbf{d} = \mathbf{a} \times s",
    )


def test_a_bold_1_beside_quaternions_is_one_of_them() -> None:
    sources = [Source(r"\mathbf{q}^{-1} \mathbf{q} = \mathbf{1}"), Source(r"\mathbf{q} = s + \mathbf{v}")]
    found = infer(sources, Prose("A quaternion times a quaternion is a quaternion."))
    assert not found.misfits and kind_name(found.kinds[r"\mathbf{q}"].kind) == "hamilton quaternion"


@pytest.mark.parametrize(
    ("latex", "pieces"),
    [
        (r"\int_0^1 a \, dt \leq b + c", ["compare"]),
        (r"x = a \boxast b", ["said"]),
        (r"x = y \text{ if } z > 0", ["equal", "compare"]),
    ],
)
def test_a_refused_formula_is_read_in_pieces(latex: str, pieces: list[str]) -> None:
    assert [tree.op for tree in operations_of(latex, Walker())] == pieces


EULER = tuple(
    rf"I_{{{i}}} \dot\omega_{{{i}}} - (I_{{{j}}} - I_{{{k}}}) \omega_{{{j}}} \omega_{{{k}}} = M_{{{i}}}"
    for i, j, k in ("123", "231", "312")
)


@pytest.mark.parametrize("letter", ["I", "J", r"\mathbf{I}"])
def test_moments_of_inertia_are_scalars_in_any_letter(tmp_path: Path, letter: str) -> None:
    words = "The principal moments of inertia are $I_1$, $I_2$ and $I_3$."
    text = "\n\n".join((words, *(f"$$ {latex} $$" for latex in EULER)))
    path = tmp_path / "p.md"
    path.write_text(text.replace("I_", f"{letter}_"))
    found = ingest(path).inference.kinds
    assert [kind_name(found[f"{letter}_{{{k}}}"].kind) for k in "123"] == ["scalar"] * 3


def test_a_unit_tensor_with_its_size_is_no_symbol() -> None:
    formulas = (r"\mathbf{R} \mathbf{R}^T = I_3", r"\mathbf{A} = I_2 + \mathbf{B}")
    assert not {"I_{2}", "I_{3}"} & kinds(*formulas).keys()
    assert {"I_{2}", "I_{3}"} <= kinds(*formulas, "I_1 = m r^2").keys()


def test_an_inertia_beside_the_spin_is_a_tensor() -> None:
    euler = r"\tau = I_B \dot\omega + \omega \times I_B \omega"
    assert kinds(euler)["I_{B}"] == "tensor"
    assert kinds(r"T = \frac{1}{2} I_B \dot\theta^2")["I_{B}"] == "scalar"


GOOD = (
    r"\mathbf{v} = \dot{\mathbf{r}}",
    r"\mathbf{p} = m \mathbf{v}",
    r"\mathbf{h} = \mathbf{r} \times \mathbf{p}",
    r"E = \frac{1}{2} m \mathbf{v} \cdot \mathbf{v}",
)
WRONG = (
    r"\dot{E} = m \dot{\mathbf{v}} \times \mathbf{v} + E \mathbf{v} \cdot \mathbf{h}",
    r"\mathbf{h} \cdot \mathbf{v} = m \mathbf{r} + \mathbf{p} \cdot \mathbf{v}",
    r"\dot{\mathbf{h}} = \mathbf{r} \cdot \dot{\mathbf{p}}",
    r"E + \mathbf{p} = m \mathbf{r} \cdot \mathbf{v}",
)


def doubts(*formulas: str) -> dict[str, tuple[str, ...]]:
    found = infer([Source(latex, line) for line, latex in enumerate((*GOOD, *formulas))], Prose(""))
    return {each.latex: each.cured_by for each in found.misfits}


@pytest.mark.parametrize(("one", "other"), [*itertools.combinations(WRONG, 2)])
def test_a_type_error_adds_no_doubt_to_another_one(one: str, other: str) -> None:
    alone, together = doubts(one) | doubts(other), doubts(one, other)
    assert together.keys() == alone.keys()
    assert all({*names} <= {*alone[latex]} for latex, names in together.items())


def test_kind_in_another_section_is_doubtful() -> None:
    good = [Source(latex, line, section="One") for line, latex in enumerate(GOOD)]
    wrong = r"s = m \mathbf{r} \cdot \mathbf{r} + E \mathbf{r}"
    here, there = (
        infer([*good, Source(wrong, 9, section=section)], Prose("")).misfits for section in ("One", "Two")
    )
    assert [each.cured_by for each in here] == [()]
    assert ["E" in each.cured_by for each in there] == [True]


def test_unusual_operations_do_not_add_up_to_a_misfit() -> None:
    blocks = r"\begin{bmatrix} \mathbf{A} & \mathbf{B} \\ \mathbf{C} & \mathbf{D} \end{bmatrix}"
    column = r"\begin{bmatrix} \mathbf{a} \\ \mathbf{b} \end{bmatrix}"
    assert misfits(rf"p(\mathbf{{x}}) = N({column}, {blocks})") == ()


@pytest.mark.parametrize("one", ["1", r"\mathbf{1}", r"\mathbf{I}"])
def test_unit_tensor_beside_a_number_is_the_number_1(one: str) -> None:
    known = (r"s = \mathbf{v}^T \mathbf{u}", r"\mathbf{h} = \mathbf{u} \times \mathbf{v}")
    assert misfits(*known, rf"n = {one} + \mathbf{{v}}^T \mathbf{{u}}") == ()
    rotated = rf"\mathbf{{R}} = {one} + s \mathbf{{v}} \mathbf{{v}}^T + s"
    assert misfits(*known, r"\mathbf{R} \mathbf{R}^T = \mathbf{I}", rotated) == (rotated,)


def test_notation_misread_twice_makes_its_symbols_doubtful() -> None:
    misread = (r"\mathbf{p} \times m = \mathbf{r}", r"\mathbf{h} = \mathbf{p} \times m + \mathbf{v}")
    found = doubts(*misread)
    assert found.keys() == {*misread}
    assert all({r"\mathbf{p}", "m"} <= {*names} for names in found.values())


#: The velocities of two wheels, as a public text derives them.
WHEELS = tuple(
    latex.replace("?", side).replace("#", sign)
    for side, sign in (("l", "-"), ("r", "+"))
    for latex in (
        r"\vec{v}_? = v_c \hat{i} + \omega \hat{k} \times r_b \hat{j}",
        r"\vec{v}_? = v_c \hat{i} # \omega r_b \hat{i}",
        r"\vec{v}_? = (v_c # \omega r_b) \hat{i}",
        r"v_? = (v_c # \omega r_b) \hat{i} \cdot \frac{\hat{i}}{\norm{\hat{i}}}",
        r"v_? = (v_c # \omega r_b) \hat{i} \cdot \hat{i}",
        r"v_? = v_c # \omega r_b",
    )
)


def test_marked_letters_are_vectors_despite_words_on_lengths(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    words = (
        "The mapping to the wheel velocities $v_l$ and $v_r$: let $\\vec{v}_l$ be the velocity vector of the"
        " left wheel, $\\vec{v}_r$ be the velocity vector of the right wheel, $r_b$ is the distance to each."
    )
    solved = (r"2 \omega r_b = v_r - v_l", r"v_c = v_r - \omega r_b", r"v_c = \frac{v_r + v_l}{2}")
    path.write_text("\n\n".join((words, *(f"$$ {latex} $$" for latex in (*WHEELS, *solved)))))
    found = {name: kind_name(own.kind) for name, own in ingest(path).inference.kinds.items()}
    marked = (r"\vec{v}_{l}", r"\vec{v}_{r}", r"\hat{i}", r"\hat{j}", r"\hat{k}")
    assert [found[name] for name in marked] == ["vector"] * 5
