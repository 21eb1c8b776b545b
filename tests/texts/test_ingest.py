"""What `ingest` guesses without its author, and that nothing is called a fault on the ground of a guess."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade
from workbench.papers import load_paper
from workbench.papers.drafting import ingest, model_text

TEXTS = Path(__file__).parents[2] / "proofs" / "texts"

#: What a text writes, and the kinds that its symbols have: by typeface, by words, by what makes formulas fit.
KINDS = [
    (r"$$ \hat{n}_x \times \hat{n}_y = \hat{n}_w $$", {r"\hat{n}_{x}": "vector", r"\hat{n}_{w}": "vector"}),
    (r"$$ a \times b = c $$", dict.fromkeys("abc", "vector")),
    (r"$$ R a \times b = c $$", {"R": "tensor", "a": "vector", "b": "vector"}),
    (r"$$ \dot{\boldsymbol{R}} = \boldsymbol{ω} \boldsymbol{R} $$", {r"\boldsymbol{\omega}": "tensor"}),
    (r"The angle $v$ and the vector $m$: $$ v m = m v $$", {"v": "scalar", "m": "vector"}),
    (r"$$ \ddot{r} - r ω = m $$ $$ m + r = 1 $$", {r"\omega": "scalar", "r": "scalar"}),
    (r"$$ A^{\mathscr R} = A + A^{\mathscr R} $$", {r"A^{\mathscr{R}}": "tensor", "A": "tensor"}),
    (
        r"$$ F_x = m a_{cm_x} $$ $$ \mathbf{T}_m = m \mathbf{u} $$",
        {"m": "scalar", "F_{x}": "scalar", r"\mathbf{T}_{m}": "vector"},
    ),
    (
        r"$$ \mathcal{V}_a = [Ad_{T_{ab}}] \mathcal{V}_b $$ $$ \mathcal{V}_b = \begin{bmatrix} \boldsymbol{\omega} \\ \mathbf{v} \end{bmatrix} $$",
        {r"\operatorname{Ad}_{T_{a b}}": "matrix 6×6", r"\mathcal{V}_{b}": "matrix 6×1"},
    ),
    (r"$a, b \in \mathbb{R}$, $A \in \R^{2 \times 3}$: $$ a A = A b $$", {"a": "scalar", "b": "scalar", "A": "matrix 2×3"}),
    (r"The homogeneous matrix $T$: $$ T = \begin{bmatrix} R & p \\ 0 & 1 \end{bmatrix} \in SE(3), R \in SO(3) $$", {"T": "transform"}),
    (r"The vector $\tau$: $$ \tau = M(\theta) \ddot{\theta} + h(\theta, \dot{\theta}) $$", {"M": "matrix 2×2", "h": "matrix 2×1"}),
    (r"$$ {}^A\bar{v} = {}^B\bar{v} + \bar{u} \times \bar{p} $$", {r"{}^{A}\bar{v}": "vector"}),
]  # fmt: skip

#: What a text writes, and the tables that a model needs to read it.
TABLES = [
    (r"$$ \frac{{}^A d\hat{b}}{dt} = {}^A\bar{\omega}^B \times \hat{b} $$", {"frames"}),
    (r"$$ \frac{{}^A d\bar{r}^{P/O}}{dt} = {}^A\bar{v}^T $$ $$ {}^A\bar{v}^P = {}^A\bar{v}^T $$", {"frames", "points"}),
    (r"$$ \mathbf{a} \wedge \mathbf{b} = \mathbf{c} $$", {"notation"}),
    (r"$$ \mathbf{a}^\wedge \mathbf{b} = \mathbf{c} $$", {"notation"}),
    (r"$$ [\mathbf{a}]_\times \mathbf{b} = \mathbf{c} $$", {"notation"}),
    (r"$$ x' = \mathbb{1} x $$", {"notation"}),
    (r"$$ a * b = b * a $$", {"notation"}),
    (r"$$ \vec{a} . \vec{b} = s . s $$", {"notation"}),
    (r"$$ \dot{R} = R \hat{\omega} $$ $$ R \hat{\omega} R^T = \widehat{R \omega} $$", {"notation"}),
    (r"$$ e = (R^T S - S^T R)^\vee $$ $$ e = e \times e $$", {"notation"}),
    (r"$$ h(q, \dot{q}) = s \dot{q} $$", {"conventions"}),
    (r"$$ \mathbf{f} = \frac{\partial L}{\partial \mathbf{q}} $$", {"conventions"}),
    (r"A homogeneous matrix $T$, $V \in \mathbb{R}^6$: $$ [V] = T^{-1} \dot{T} $$ $$ V = \begin{bmatrix} \boldsymbol{\omega} \\ \mathbf{v} \end{bmatrix} $$", {"notation"}),
    (r"$$ \Gamma(R, S_d) = s \operatorname{tr}(R) $$", {"conventions"}),
    (r"$$ \mathbf{E}(\boldsymbol{\chi}) \mathbf{a} = \mathbf{b}(\boldsymbol{\chi}) $$", {"conventions"}),
    (r"The rotation $R \in SO(3)$: $$ R^T R = 1 $$", {"conventions"}),
    (r"The dyad of $\mathbf{a}$ and $\mathbf{b}$, and a tensor $T$: $$ T = \mathbf{a} \mathbf{b} $$", {"conventions"}),
    (r"$$ x = arccos(s) $$ $$ s = cos \frac{x}{2} $$", {"conventions"}),
    ("A quaternion, two quaternions, more quaternions. $$ q = [s, v] $$ $$ q^* q = [s^2 + v^T v, 0] $$", {"conventions", "notation"}),
]  # fmt: skip


def ingested(tmp_path: Path, text: str):
    path = tmp_path / "p.md"
    path.write_text(text)
    return ingest(path)


@pytest.mark.parametrize(("text", "kinds"), KINDS)
def test_kinds_are_those_with_which_the_formulas_fit(
    tmp_path: Path, text: str, kinds: dict[str, str]
) -> None:
    found = ingested(tmp_path, text)
    assert not found.missing()
    got = {name: guess.kind.replace("rotation", "tensor") for name, guess in found.guesses.items()}
    assert got.items() >= kinds.items()


def test_symbols_of_definitions_in_sentences_are_declared(tmp_path: Path) -> None:
    said = "The angular momentum is $L$, where $L = J \\omega$ and $\\omega$ is a vector; also $E = m c$."
    found = ingested(tmp_path, f"{said}\n\n$$ \\dot{{L}} = \\tau $$")
    assert [(each.name, each.body) for each in found.definitions] == [
        ("L", r"J \omega"),
        (r"\tau", r"\dot{L}"),
    ]
    assert {"J", r"\omega"} <= found.guesses.keys() and "E" not in found.guesses


PAGE = r"""\newcommand{\vect}[1]{\bm{#1}}
Let $\vect{r}$ be a position vector, $\vect{\Omega}$ an angular velocity and $R$ a rotation matrix.
\[ \vect{r} = R \vect{x} \]
\[ \dot{R} = [\vect{\Omega}]_\times R \]
\[ \vect{r} \times (\vect\Omega \times \vect{r}) = r^2 \vect\Omega - (\vect{r} \cdot \vect\Omega) \vect{r} \]
\[ \vect\Omega \cdot \vect\Omega = \Omega^2, \quad y = r \Omega \]
The angular momentum is $\vect{L} = J \vect\Omega$ with an inertia tensor $J$.
\[ \dot{\vect L} = J \dot{\vect\Omega} + \vect\Omega \times \vect{L} \]
"""


def test_kinds_stated_by_a_page_are_proposed(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    path.write_text(PAGE)
    found = ingest(path)
    assert not found.missing()
    assert {name: guess.kind for name, guess in found.guesses.items()} == {
        r"\boldsymbol{r}": "vector",
        r"\boldsymbol{x}": "vector",
        r"\boldsymbol{\Omega}": "vector",
        r"\boldsymbol{L}": "vector",
        "R": "rotation",
        "J": "tensor",
        "r": "scalar",
        "y": "scalar",
        r"\Omega": "scalar",
    }
    assert "position" in found.guesses[r"\boldsymbol{r}"].why
    assert {each.name: each.body for each in found.definitions} == {
        r"\boldsymbol{r}": r"R \boldsymbol{x}",
        r"\boldsymbol{\Omega}": r"\operatorname{vect}(\dot{R} R^T)",
        r"\boldsymbol{L}": r"J \bm{\Omega}",
        "y": r"r \Omega",
        "r": r"\|\boldsymbol{r}\|",
        r"\Omega": r"\|\boldsymbol{\Omega}\|",
    }
    assert {each.name for each in found.definitions if not each.sure} == {"r", r"\Omega"}


@pytest.mark.parametrize(
    ("law", "body"),
    [
        (r"\dot{R} = \tilde{w} R", r"\operatorname{vect}(\dot{R} R^T)"),
        (r"\dot{R} = R \tilde{w}", r"\operatorname{vect}(R^T \dot{R})"),
        (r"\dot{R} = \tilde{w} S", None),
        (r"\ddot{R} = \tilde{w} R", None),
    ],
)
def test_the_rate_of_a_rotation_defines_its_angular_velocity(
    tmp_path: Path, law: str, body: str | None
) -> None:
    found = ingested(
        tmp_path, f"The rotation matrix $R$, the rotation matrix $S$, the vector $w$: $$ {law} $$"
    )
    assert [each.body for each in found.definitions if each.name == "w"] == ([] if body is None else [body])


@pytest.mark.parametrize(("text", "tables"), TABLES)
def test_notation_that_a_text_shows_signs_of_is_tried(tmp_path: Path, text: str, tables: set[str]) -> None:
    found = ingested(tmp_path, text)
    unread = [formula.latex for formula in found.formulas if formula.outcome.statements is None]
    assert all("arccos" in latex for latex in unread)
    assert {proposal.table for proposal in found.proposals} == tables
    assert all(proposal.question in found.questions for proposal in found.proposals)


def test_a_drafted_model_reads_as_drafted_without_false_faults(tmp_path: Path) -> None:
    for place, (text, _) in enumerate([*KINDS, *TABLES]):
        folder = tmp_path / str(place)
        folder.mkdir()
        found = ingested(folder, text)
        (folder / "p.toml").write_text(model_text(found, folder / "p.toml"))
        paper = load_paper(folder / "p.toml")
        unread = [claim for claim in paper.claims if claim.printed.statement is None]
        assert len(unread) == sum(formula.outcome.statements is None for formula in found.formulas)
        results = judge_paper(paper, motions=False)
        assert Grade.ERROR not in {result.shown for result in results}, text


STYLE = r"""\newif\if@size
\newif\ifPedantic
\DeclareOption{Pedantic}{\Pedantictrue}
\ProcessOptions\relax
\DeclareDocumentCommand\around{sm}{\begingroup\@sizetrue\@wrapper{\left\lparen}{\vphantom{#2}}{\right.}{#2}\left.\right\rparen\endgroup}
\newcommand\pa[1]{\around{#1}}
\ifPedantic\renewcommand\pa[1]{\around{#1}_\mathrm{p}}\fi
"""


def test_macros_only_tex_expands_are_guessed_as_brackets(tmp_path: Path) -> None:
    (tmp_path / "own.sty").write_text(STYLE)
    path = tmp_path / "p.tex"
    path.write_text(r"\usepackage{own}\begin{document}\[ a \pa{b + c} = a b - a c \]\end{document}")
    found = ingest(path)
    assert found.fences == {r"\around": r"\left\lparen #1\right\rparen"}
    assert any(r"Does \around print" in question for question in found.questions)
    (tmp_path / "p.toml").write_text(model_text(found, tmp_path / "p.toml"))
    (claim,) = load_paper(tmp_path / "p.toml").claims
    assert claim.printed.latex == r"a \left(b + c\right) = a b - a c"
    assert r"\around" in claim.context.guessed
    (without,) = load_paper(path.rename(tmp_path / "q.tex")).claims
    assert "could not be expanded" in without.printed.unread


def test_undeclared_macros_are_guessed_by_name(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(r"$$ \bv = \bR \bomega + \bfx + \wrong{\bM} $$ $$ \bv = {\bf x} \beta $$")
    found = ingest(path)
    assert found.fences == {
        r"\bv": r"\mathbf{v}",
        r"\bR": r"\mathbf{R}",
        r"\bomega": r"\boldsymbol{\omega}",
        r"\bfx": r"\mathbf{x}",
        r"\bM": r"\mathbf{M}",
    }
    model = tmp_path / "p.toml"
    model.write_text(model_text(found, model))
    assert [claim.printed.statement is None for claim in load_paper(model).claims] == [True, False]


def test_e_with_an_exponent_is_no_symbol(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(r"$$ x = e^{-y} $$ $$ e {y} = x $$")
    assert "e" not in ingest(path).guesses


@pytest.mark.parametrize(("options", "latex"), [("", "x"), ("[Pedantic]", "y"), ("[Other]", "x")])
def test_an_option_of_a_style_is_obeyed_where_it_is_given(tmp_path: Path, options: str, latex: str) -> None:
    style = r"\newif\ifPedantic\DeclareOption{Pedantic}{\Pedantictrue}\ProcessOptions\relax"
    (tmp_path / "own.sty").write_text(style + r"\newcommand\m{x}\ifPedantic\renewcommand\m{y}\fi")
    path = tmp_path / "p.tex"
    path.write_text(rf"\usepackage{options}{{own}}\begin{{document}}\[ \m = 0 \]\end{{document}}")
    (claim,) = load_paper(path).claims
    assert claim.printed.latex == f"{latex}= 0"


def test_words_are_functions_only_where_the_model_says_so(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text(
        "$$ c o s = o c s $$ (one) $$ x = c o s + arccos $$ (two) $$ cos x = cos(x) $$ (three)\n"
    )
    model = 'source = "p.md"\n[symbols]\n' + "".join(f"{c} = {{ kind = 'scalar' }}\n" for c in "acorsx")
    path = tmp_path / "p.toml"
    path.write_text(model)
    assert "write \\operatorname{cos}" in load_paper(path).claims[2].printed.unread
    path.write_text(model + "[conventions]\nfunctions = ['cos']\n")
    claims = load_paper(path).claims
    assert [claim.printed.latex for claim in claims] == [
        "c o s = o c s",
        "x = c o s + arccos",
        r"\cos x = \cos(x)",
    ]
    path.write_text(model + "[conventions]\nfunctions = ['cosine']\n")
    with pytest.raises(ValueError, match=r"p\.toml:\d+:\d+: functions: expected some of cos"):
        load_paper(path)


@pytest.mark.slow
@pytest.mark.parametrize(
    "path",
    sorted(p for p in TEXTS.glob("*/*.*") if p.suffix in (".rst", ".md", ".tex") and p.stem != "macros"),
    ids=lambda p: p.stem,
)
def test_at_least_half_of_each_text_is_read(path: Path) -> None:
    found = ingest(path)
    assert 2 * sum(found.missing().values()) <= len(found.text.displays)
