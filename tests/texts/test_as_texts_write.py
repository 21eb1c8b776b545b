"""What texts write in their own ways is read as what they print, refused where readers would differ, and no
guess that an author confirms unseen makes a verdict that the text does not deserve."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.texts.written import doubts, told
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
from workbench.source.documents import read_text
from workbench.source.rows.chains import steps_of

#: What a text writes, and its steps as they are read.
SPELLED = [
    (r"\left.\frac{dx}{dt}\right|_B = y", [r"\frac{{}^{B}dx}{dt} = y"]),
    (r"\left.\hat{u}_r\right)_1 = y", [r"\left(\hat{u}_r\right)_1 = y"]),
    (r"x + \left. y \right|_B = y", [r"x + \left( y \right)_B = y"]),
    (r"\left. x \right|_{y = 0} = y", [r"\left. x \right|_{y = 0} = y"]),
    (r"\left. x y \right|_1 = y", [r"\left. x y \right|_1 = y"]),
    (r"\left( \frac{dx}{dt} \right)_{\mathcal{B}} = y", [r"\frac{{}^{\mathcal{B}}dx}{dt} = y"]),
    (r"\frac{d^2x}{(dt^N)^2} = y", [r"\frac{{}^{N}d^2x}{dt^2} = y"]),
    (r"\frac{d^2x}{dt^2} = y", [r"\frac{d^2x}{dt^2} = y"]),
    (r"\left(\frac{dx}{dt}\right)_{t=0} = y", [r"\left(\frac{dx}{dt}\right)_{t=0} = y"]),
    (r"\left(\frac{x}{y}\right)_B = y", [r"\left(\frac{x}{y}\right)_B = y"]),
    (r"\dv[2]{x}{t} = \dv{t}(x)", [r"\frac{d^{2} x}{d t^{2}} = \frac{d }{d t}(x)"]),
    (r"\pdv{x}{y} = y", [r"\frac{\partial x}{\partial y} = y"]),
    (r"x = ^A y + R~^B y", [r"x = {}^A y + R~{}^B y"]),
    (r"x = R\,^T y", [r"x = R\,^T y"]),
    (r"[x]_\times^2 = [y]^\wedge_\otimes", [r"[x]_\times^2 = [y]^\wedge_\otimes"]),
    (r"x_+^2 = y \times ^B z", [r"x_+^2 = y \times {}^B z"]),
    (r"x = a y_1{}^2", [r"x = a y_1^2"]),
    (r"x_1{}^2 = a (y{}^2)", [r"x_1^2 = a (y{}^2)"]),
    (r"x = R{}^2 y + {}^2 a", [r"x = R{}^2 y + {}^2 a"]),
    (r"x = \textrm{Adj}\left(A\right)", [r"x = \operatorname{Adj}\left(A\right)"]),
    (r"x_\text{ref}(t) = y \text{ if}(x)", [r"x_\text{ref}(t) = y"]),
    (r"\theta = \tan^{-1} x", [r"\theta = \arctan x"]),
    (r"x = a \ \ y = b", ["x = a", "y = b"]),
    (r"x = a \hfill y = b", ["x = a", "y = b"]),
    (r"x = a \phantom{abc} y = b", ["x = a", "y = b"]),
    (r"x = \phantom{=} a + b", ["x = a + b"]),
    (r"x = \ \ a = \\ = b", ["x = a", "a = b"]),
    (r"x = \mbox{\boldmath{$\omega$}}", [r"x = \boldsymbol{\omega}"]),
    (r"\therefore x = a \therefore y = b", ["x = a", "y = b"]),
    (r"\leftidx{^A}Y x = a", [r"{}^A Y x = a"]),
    (r"\leftidx{^A}Y \leftidx{^B}Z_C = a", [r"{}^A Y {}^B Z_C = a"]),
    (
        r"x = \begin{bmatrix} 1 \\ 2 \end{bmatrix} \ y = b",
        [r"x = \begin{bmatrix} 1 \\ 2 \end{bmatrix}", "y = b"],
    ),
    (
        r"x = \begin{bmatrix} 1 & 2 \end{bmatrix} \ y = b",
        [r"x=\begin{bmatrix} 1 & 2 \end{bmatrix} \ y", r"\begin{bmatrix} 1 & 2 \end{bmatrix} \ y=b"],
    ),
    (
        r"x = \begin{bmatrix*}[r] -1 \\ 2 \end{bmatrix*} + y",
        [r"x = \begin{bmatrix} -1 \\ 2 \end{bmatrix} + y"],
    ),
    (r"\begin{matrix*}[l] x = a \\ y \triangleq b \end{matrix*}", ["x = a", "y :=b"]),
    (r"R = [a \quad b\ \ c]", [r"R = \begin{bmatrix}a &b&c\end{bmatrix}"]),
    (r"x = [a \quad b]^T", ["x = [a ,b]^T"]),
    (r"x = [a \quad -b \quad +c]^T", ["x = [a ,-b ,+c]^T"]),
    (r"x = [-a \; b \; c]^T", ["x = [-a , b , c]^T"]),
    (r"x = \lVert [a \; b\ c] \rVert", [r"x = \lVert[a , b,c] \rVert"]),
    (r"x = y [a \, b \, c]", [r"x = y [a \, b \, c]"]),
    (r"x = [a \; -b]", [r"x = \begin{bmatrix}a&-b\end{bmatrix}"]),
    (r"x = [a \quad -b]", [r"x = \begin{bmatrix}a&-b\end{bmatrix}"]),
    (r"x = [a \; - b]", [r"x = [a \; - b]"]),
    (r"R = \left[ a \quad b\,\right]", [r"R = \begin{bmatrix} a &b\,\end{bmatrix}"]),
    (r"R = \left[ a \quad b \right)", [r"R = \left[ a \quad b \right)"]),
    (r"x = [a + b \quad c]", [r"x = [a + b \quad c]"]),
    (
        r"x = \begin{bmatrix} a \\ \rule[.5ex]{1em}{1pt} \\ b \end{bmatrix}",
        [r"x = \begin{bmatrix} a \\   b \end{bmatrix}"],
    ),
    (r"\sum \mathbf{F}^W = \sum M", [r"\mathbf{F}_{\Sigma}^W = M_{\Sigma}"]),
    (r"\sum m v = \sum_i F_i", [r"\sum m v = \sum_i F_i"]),
    (r"v_i = w_i = u_i, \, i = 1,2,3", [r"v_i=w_i,i=\overline{1,3}", r"w_i=u_i,i=\overline{1,3}"]),
    (r"v_i = w_i \quad (i = 0, 1)", [r"v_i = w_i,i=\overline{0,1}"]),
    (
        r"v_{ij} = w_i, \quad i = 1, 2, (j = 1, 2)",
        [r"v_{ij} = w_i, i=\overline{1,2}, j=\overline{1,2}"],
    ),
    (r"v_i = w_i \text{ for } i = 1, \ldots, n", [r"v_i = w_i,i\geq1"]),
    (
        r"v_{ij} = w_i, \; i, j = 1,...,6, \quad u = z",
        [r"v_{ij} = w_i,i=\overline{1,6},j=\overline{1,6}", "u = z"],
    ),
    (r"v_i = w_i, \quad i = 1, 3", ["v_i=w_i,i=1,3"]),
    (r"v = w, \quad i = 1, 2", ["v=w,i=1,2"]),
    (r"x_i = y_i, k = 1", ["x_i = y_i", "k = 1"]),
    (
        r"\omega_{\cal{B}/\cal{N}} = {\cal B/N}",
        [r"\omega_{\mathcal{B}/\mathcal{N}} = {\mathcal{B}/\mathcal{N}}"],
    ),
    (r"p_{0_j}^{'T} = x^{''} y^{'2}", [r"p_{0_j}'^{T} = x'' y^{'2}"]),
    (r"{v = w = z}", ["v=w", "w=z"]),
    (r"{v}_1 = w \& w = {z}", ["{v}_1 = w", "w = {z}"]),
    *(
        (rf"x = y {behind}", ["x = y"])
        for behind in (
            r"\qquad (2)",
            r"\quad [2.1]",
            r"\hfill (A.4b)",
            r"\hspace{2cm} (12)",
            r", \quad\text{(2)}",
            r".\qquad (3)",
        )
    ),
    (r"(2) \qquad x = y", ["x = y"]),
    (r"L:\ x = y \\ R: \quad a = b", ["x = y", "a = b"]),
    (r"\begin{aligned} x &= a + \\ & - b + \\ &+ c \end{aligned}", ["x = a - b + c"]),
    (r"\begin{aligned} x &= a - \\ & - b \end{aligned}", ["x = a - b"]),
    (r"f:\ A \to B", [r"f:\ A \to B"]),
    (r"L: x = y", ["L: x = y"]),
    (r"x = y \; (2)", [r"x = y \; (2)"]),
    (r"x = y \quad z (2)", [r"x = y \quad z (2)"]),
    (r"x \in \R^3", [r"x \in\mathbb{R}^3"]),
    (r"\left[\frac{d}{dt}\right]_{S_0} x = y", [r"\frac{{}^{S_0}d}{dt} x = y"]),
    (
        r"\left( \dot{e}_i \right)_S + (\ddot x)_{rot} = y",
        [r"\frac{{}^{S}d e_i}{dt} + \frac{{}^{rot}d^2 x}{dt^2} = y"],
    ),
    (r"(\dot{x})_0 + (\dot{x} + y)_S = y", [r"(\dot{x})_0 + (\dot{x} + y)_S = y"]),
    (
        r"x = \left[ p \; \dot{q}_1 \; \mathbf{r} \right]^T",
        [r"x = \left[ p , \dot{q}_1 , \mathbf{r} \right]^T"],
    ),
    (r"x = [ A \; B ] + [a\;+\;b]^T", [r"x = \begin{bmatrix}A&B\end{bmatrix} + [a\;+\;b]^T"]),
    (r"\leftidx{^A}{\textbf{v}}{_B} = y", [r"{}^A \mathbf{v}_B = y"]),
    (r"x = \textbf{two words}", [r"x = \textbf{two words}"]),
    (r"\require{cancel} x = y", ["x = y"]),
    (r"a = b = \\ = c", ["a = b", "b = c"]),
    (r"\dot{q} \equiv a b", [r"\dot{q} := a b"]),
    (r"q \equiv -q", [r"q \equiv -q"]),
    (r"\dot{q} \equiv R_q", [r"\dot{q} \equiv R_q"]),
    (r"a = b \quad \mathrm{and} \quad c = d", ["a = b", "c = d"]),
    (r"x \not= y", [r"x \neq y"]),
    (r"x_i = y_i \quad \forall \quad i=1,2,3", [r"x_i = y_i,i=\overline{1,3}"]),
    (r"x_i = y_k, \, \forall i, k", ["x_i = y_k"]),
    (r"x_i = y, \forall i \neq 1", ["x_i = y"]),
    (r"S = \{ x \; | \; x = y \}", [r"S = \{ x \; \mid \; x = y \}"]),
    (r"S = \left\{ x \middle| x = y \right\}", [r"S = \left\{ x \mid x = y \right\}"]),
    (r"x = \{ |y| \} + |z|", [r"x = \{ |y| \} + |z|"]),
    (r"x =: y", ["x = y"]),
    (r"x = \left|\right|y\left|\right|", [r"x = \|y\|"]),
    (r"x = \left|y\right|", [r"x = \left|y\right|"]),
    (r"x = w \times \mathbf{-v}", [r"x = w \times (-\mathbf{v})"]),
    (r"x = \mathbf{-v}^2 \mathbf{v-w}", [r"x = \mathbf{-v}^2 \mathbf{v-w}"]),
    (r"(x y)\dot{} = \left[x (y)\right]^{\cdot}", [r"\dot{(x y)} = \dot{\left[x (y)\right]}"]),
    (r"(x y) \dot{z} = (x)^{\circ}", [r"(x y) \dot{z} = (x)^{\circ}"]),
    (r"x = \qty(y z) \qty[w]", [r"x = (y z) [w]"]),
    (
        r"\norm{\abs x}^2 = \norm*{y}_2 + \abs[\big]{z}",
        [r"\left\|\left|x\right|\right\|^2 = \left\|y\right\|_2 + \left|z\right|"],
    ),
    (r"\tr(A) = \Tr A", [r"\operatorname{tr}(A) = \operatorname{Tr} A"]),
    (r"\norm_2 = \norm", [r"\norm_2 = \norm"]),
    (r"\vb*{a} = \va*{b}", [r"\mathbf{a} = \vec{b}"]),
    (r"x = \bbox[10px, gray]{y} + \bbox{z}", ["x = y + z"]),
    (r"\text{\makebox[3em]{}} x = y", ["x = y"]),
    (r"\text{\makebox[3em]{a}} x = y", ["x = y"]),
    (r"x = 90^\circ + 5^{ \circ } y", [r"x = \frac{90}{180}\pi + \frac{5}{180}\pi y"]),
    (r"x = 1.5^\circ + x^\circ", [r"x = 1.5^\circ + x^\circ"]),
    (r"x = y \quad \text{(Using } z = w\text{)} \\ z = y \text{ (since (1) holds)}", ["x = y", "z = y"]),
    (r"x = y \quad \text{(if } z = w\text{)}", ["x = y"]),
    (r"\begin{aligned} x &= y \\ &= z = \end{aligned}", ["x = y", "y = z"]),
    (r"\begin{split} x &= y \\ &= z \end{split} (1.2)", ["x = y", "y = z"]),
    (r"x = \begin{array}{c} y \end{array} (1)", [r"x = \begin{array}{c} y \end{array} (1)"]),
    (r"a = \mathrm{so}(3), b = c", [r"a = \mathrm{so}(3)", "b = c"]),
]


@pytest.mark.parametrize(("written", "steps"), SPELLED)
def test_layout_commands_are_read_as_they_print(tmp_path: Path, written: str, steps: list[str]) -> None:
    path = tmp_path / "p.md"
    path.write_text(f"$$ {written} $$")
    (display,) = read_text(path).displays
    spelled = [step.spelled()[0] for line in steps_of(display) for step in line]
    assert [re.sub(r"\s", "", each) for each in spelled] == [re.sub(r"\s", "", each) for each in steps]


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
    (tmp_path / "p.md").write_text(text)
    (tmp_path / "p.toml").write_text(MODEL)
    last = judge_paper(load_paper(tmp_path / "p.toml"))[-1].verdict
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
    (tmp_path / "p.md").write_text(
        "\n\n".join(
            [
                r"$$\dot{Q} Q^T \in so(3)$$",
                r"$$Q Q \in SO(3)$$",
                r"$$Q a \in \R^3$$",
                r"$$R \in SO(3)$$",
                r"$$a \times R b$$",
            ]
        )
    )
    (tmp_path / "p.toml").write_text(MODEL)
    skew, product, declared, tensor, expression = (
        result.verdict for result in judge_paper(load_paper(tmp_path / "p.toml"))
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
