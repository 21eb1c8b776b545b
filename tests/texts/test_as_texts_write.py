"""What texts write in their own ways is read as what they print, refused where readers would differ, and no
guess that an author confirms unseen makes a verdict that the text does not deserve."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.texts.written import doubts, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.papers import load_paper
from workbench.papers.drafting import ingest, model_text
from workbench.papers.drafting.inference.infer import infer
from workbench.papers.drafting.model_proposal import ground_of
from workbench.papers.drafting.notation_proposals import proposals_for
from workbench.papers.drafting.trial_reading import Reader
from workbench.papers.drafting.typefaces import Guess, by_typeface
from workbench.papers.drafting.words_on_symbols import Prose

LETTERS = SymbolTable.build({letter: {"kind": "scalar"} for letter in "AELRTdeopxgl"})


@pytest.mark.parametrize(
    "word", ["Ad", "Exp", "Log", r"\mathrm{Ad}", r"\mathrm{rank}", r"\mathrm{Log}", r"\operatorname{Exp}"]
)
def test_a_word_is_no_product_of_its_letters(word: str) -> None:
    with pytest.raises(ReadError, match=r"words in a formula|logarithms"):
        read(f"{word} x = x", LETTERS)


@pytest.mark.parametrize("label", [r"\text{max}", r"\textrm{sensed}", r"B, \text{rel}", r"\text{rel}/N"])
def test_words_in_a_script_are_labels(label: str) -> None:
    table = SymbolTable.build({f"r_{{{label}}}": {"kind": "vector"}})
    (relation,) = read(f"r_{{{label}}} = 2 r_{{{label}}}", table)
    assert relation.left.type.kind == "vector"


def test_script_letters_and_upright_differentials_are_no_words() -> None:
    table = SymbolTable.build({"v_{Ad}": {"kind": "scalar"}, "x": {"kind": "scalar"}})
    assert read(r"v_{Ad} = \frac{\mathrm{d}x}{\mathrm{dt}}", table)


QUATERNIONS = "A quaternion, two quaternions, more quaternions. "


def blindly(tmp_path: Path, text: str) -> dict[str, Outcome]:
    """The verdicts where the author confirms all that is guessed, unseen."""
    path = tmp_path / "p.md"
    path.write_text(text)
    found = ingest(path)
    assert not found.missing()
    model = re.sub(r"(?ms)^guessed = \[.*?^\]$", "", model_text(found, tmp_path / "p.toml"))
    (tmp_path / "p.toml").write_text(model)
    return {
        result.claim.id: result.verdict.outcome for result in judge_paper(load_paper(tmp_path / "p.toml"))
    }


def test_i_j_k_are_the_units_of_quaternions(tmp_path: Path) -> None:
    text = QUATERNIONS + "$$q = q_0 + q_1 i + q_2 j + q_3 k$$\n\n$$ij = k = -ji$$\n\n$$i j k = -1$$"
    assert (
        list(blindly(tmp_path, text).values()) == [Outcome.PROVED] * 4
    )  # q_0 is drafted as a component of q


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        (QUATERNIONS + r"$$\mathbf{q} = [q_w, \mathbf{q}_v]$$", {r"\mathbf{q}": "hamilton quaternion", "q_{w}": "scalar", r"\mathbf{q}_{v}": "vector"}),
        (QUATERNIONS + r"$$\dot{\mathbf{q}} = \mathbf{q} \otimes \begin{bmatrix} 0 \\ \boldsymbol{\omega} \end{bmatrix}$$", {r"\mathbf{q}": "hamilton quaternion"}),
        (r"$$\omega = \begin{bmatrix} \omega_x \\ \omega_y \\ \omega_z \end{bmatrix}$$", {r"\omega": "vector", r"\omega_{x}": "scalar"}),
        (r"$${}^A R_C = {}^A R_B {}^B R_C$$", {"{}^{A}R_{B}": "rotation"}),
        (r"$$\mathbf{v}^B_{P/B} = \mathbf{u}^B$$ $$\mathbf{u} = \mathbf{v}_{P/B}$$", {r"\mathbf{v}_{P / B}^{B}": "vector", r"\mathbf{u}^{B}": "vector"}),
        (r"$$[\mathbf{a}] \mathbf{b} = \mathbf{a} \times \mathbf{b}$$", {r"\mathbf{a}": "vector"}),
        (r"$$a \cdot b$$ $$a \times b = 0$$", {"a": "vector"}),
        (r"$$f^B_{kin} = f_{kin} x$$", {"x": "scalar"}),
        (r"$${}^A\omega^C_D = {}^A\omega^B_D$$", {r"{}^{A}\omega_{D}^{C}": "vector"}),
    ],
)  # fmt: skip
def test_kinds_of_parts_labels_and_brackets(tmp_path: Path, text: str, kinds: dict[str, str]) -> None:
    (tmp_path / "p.md").write_text(text)
    found = ingest(tmp_path / "p.md")
    assert not found.missing()
    assert {name: guess.kind for name, guess in found.guesses.items()}.items() >= kinds.items()


def test_symbols_spelled_by_frames_are_not_guessed() -> None:
    """A symbol may be guessed before the frames that spell it are."""
    formula = r"\frac{{}^A d x}{dt} = {}^A R^B x"
    inference = infer([], Prose(""))
    proposals = proposals_for([formula], "", inference)
    (frames,) = (each for each in proposals if each.table == "frames")
    guesses = {"{}^{A}R^{B}": Guess("{}^{A}R^{B}", "tensor"), "x": Guess("x", "vector")}
    reader = Reader(ground_of([frames]), guesses, False, by_typeface)
    assert list(reader.guesses) == ["x"] and reader.read(formula).statements


MODEL = 'source = "p.md"\n[symbols]\n' + "".join(
    f"'{name}' = \"{kind}\"\n"
    for name, kind in {
        "R": "tensor", "S": "tensor", "Q": "rotation", "a": "vector", "b": "vector", "c": "vector", "p": "vector", "x": "scalar",
    }.items()
)  # fmt: skip
OPEN = [
    (r"$$R (a \times b) = R a \times R b$$", "R: rotation"),
    (r"$$R S (a \times b) = R S a \times R S b$$", "R, S: rotation"),
    (r"$$a \cdot R b = R a \cdot b$$", "R: symmetric"),
    (r"$$\frac{d}{dt} (Q c) = \dot{Q} c$$", "c: constant"),
    (r"$$p = R a$$ $$p \cdot p = a \cdot a$$", "R: rotation"),
    (r"$$a = 2 b \Rightarrow x p = a \times b + b$$", "says what x is"),
    (
        r"$$\begin{bmatrix} a \\ b \end{bmatrix} = \begin{bmatrix} b \\ a \times c \end{bmatrix}$$",
        "says what c is",
    ),
    (r"$$R p = R S a + S a$$", "says what p is"),
    (r"$$\tan x = a \cdot b$$", "says what x is"),
    (r"$$a = 2 c$$ $$x p = x a$$", "says what p is"),
    (r"$$\begin{bmatrix} x & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & 1 \end{bmatrix} \in SO(3)$$", "declared to be"),
    (r"The adjoint map: $$R^* S = S R^*$$", "of which the text does not speak"),
    (r"Here $\dot{a} = \int b$. $$a \times b = b$$", "says what a is"),
]
FALSE = [
    r"The adjugate: $$R^* S = S R^*$$",
    r"$$R (a \times b) = R b \times R a$$",
    r"$$\frac{d}{dt} (Q c) = \dot{Q} c + 2 Q \dot{c}$$",
    r"$$a = 2 b \Rightarrow a \cdot a = 2 b \cdot b$$",
    r"$$2 Q Q \in SO(3)$$",
    r"$$\tan x = 2 \sin x$$",
    r"$$\begin{bmatrix} 1 & 0 & 0 \\ 0 & 1 & 0 \\ 0 & 0 & -1 \end{bmatrix} \in SO(3)$$",
]


@pytest.mark.parametrize(("text", "why"), OPEN)
def test_claims_that_hold_for_a_special_symbol_are_not_refuted(tmp_path: Path, text: str, why: str) -> None:
    last = verdicts(tmp_path, text, MODEL)[-1]
    other = "unchecked" if why == "declared to be" else "doubtful"
    assert told(last) == ("said" if why.startswith("says what") else other) and why in doubts(last)


@pytest.mark.parametrize("text", FALSE)
def test_claims_that_hold_for_no_special_symbol_are_refuted(tmp_path: Path, text: str) -> None:
    (tmp_path / "p.md").write_text(text)
    (tmp_path / "p.toml").write_text(MODEL)
    assert Outcome.REFUTED in {
        result.verdict.outcome for result in judge_paper(load_paper(tmp_path / "p.toml"))
    }


def test_memberships_of_products_are_claims_of_symbols_are_not(tmp_path: Path) -> None:
    skew, product, declared, tensor, expression = verdicts(
        tmp_path,
        "\n\n".join(
            [
                r"$$\dot{Q} Q^T \in so(3)$$",
                r"$$Q Q \in SO(3)$$",
                r"$$Q a \in \R^3$$",
                r"$$R \in SO(3)$$",
                r"$$a \times R b$$",
            ]
        ),
        MODEL,
    )
    assert skew.outcome is product.outcome is Outcome.PROVED
    assert declared.outcome is tensor.outcome is Outcome.UNCHECKED
    assert (
        "an expression" in expression.reason
        and "declared to be" in declared.reason
        and "here it is a tensor" in tensor.reason
    )


def test_spellings_of_the_notation_are_no_symbols() -> None:
    """A model with both would not load."""
    ground = SymbolTable().with_notations({"i": {"means": "2"}, "j": {"means": "3"}})
    guesses = {name: Guess(name, "scalar") for name in "ijm"}
    assert list(Reader(ground, guesses, False, by_typeface).guesses) == ["m"]
