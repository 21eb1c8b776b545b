"""What a text without a model says of its symbols: by earlier sentences, matrices, laws, instants."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Counterexample, Grade
from workbench.papers.drafting.draft_model import ingest
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.report.counterexamples import told

#: A text that defines a symbol, the symbol, and a part of its definition.
DEFINED = [
    # The first formula of a text gives its symbol: a sentence before the display.
    (r"Let $\vec v = \dot{\vec r}$ and $s = b^2$. $$\vec v = s \vec T$$", r"\vec{v}", r"\dot{\vec r}"),
    (
        r"Denote by $\mathbf b_1, \mathbf b_2, \mathbf b_3$ the columns of $R$, $R \in SO(3)$."
        r" $$\dot{\mathbf b}_3 = \mathbf b_1 - \mathbf b_2$$ $$R \mathbf a = \mathbf b_1$$",
        r"\mathbf{b}_{3}",
        r"R \begin{bmatrix} 0 \\ 0 \\ 1",
    ),
    (r"$$\Omega = \dot R R^T$$ There is $\omega$ with $\Omega x = \omega \times x$. $$\Omega a = \omega \times a$$",
     r"\omega", r"vect}(\Omega)"),
    (r"There is a vector $\omega$ with $$\Omega x = \omega \times x .$$", r"\Omega", r"skew}(\omega)"),
    (
        r"$$M_{11} = a + 2 b, \quad M_{12} = b, \quad M_{22} = a$$"
        r" $$\dot M = \begin{pmatrix} \dot a & \dot b \\ \dot b & 0 \end{pmatrix}$$",
        "M",
        r"M_{11} & M_{12} \\ M_{12} & M_{22}",
    ),
    (
        r"$$\dot{\vec u} = \mathring{\vec u} + \vec\omega \times \vec u$$ $$\vec w = \mathring{\vec r}$$",
        r"\vec{\mathring{r}}",
        r"\times \vec{r}",
    ),
    # A supposition that presents a new symbol.
    (r"For $V = x^T P x$ the rate is $$\dot V = 2 \dot x^T P x$$", "V", "x^T P x"),
    (r"Given $R = \exp(\theta\tilde{\mathbf n})$ it is $$R \mathbf n = \mathbf n$$", "R", r"\exp"),
    # Words that name the rates of a position.
    (r"It has position $\mathbf p$ and velocity $\mathbf v$. $$\dot{\mathbf v} = g \mathbf p$$", r"\mathbf{v}", r"\mathbf{p}"),
    (
        r"Here $\mathbf p$, $\mathbf v$ and $\mathbf a$ are position, velocity and acceleration."
        r" $$\dot{\mathbf v} = g \mathbf p + \mathbf a$$",
        r"\mathbf{a}",
        r"\mathbf{v}",
    ),
    # m is a label, and no index.
    (r"With $w_m = G v_m$ it is $$F_m = w_m V - v_m$$", r"w_{m}", "G v_m"),
]  # fmt: skip

#: The like, where the words give nothing to the whole text.
NOT_DEFINED = [
    (r"If $V = x^T P x$, then $$\dot V = 2 \dot x^T P x$$", "V"),
    (r"For $V = W$ it is $$\dot V = \dot W$$", "V"),
    (r"A function $V$ of $x$. For $V = x^T P x$ it is $$\dot V = 2 \dot x^T P x$$", "V"),
    (
        r"It has position $\mathbf p$ and velocity $\mathbf v$ in the body frame."
        r" $$\dot{\mathbf v} = g \mathbf p$$",
        r"\mathbf{v}",
    ),
]


def _definitions(folder: Path, text: str) -> dict[str, str]:
    path = folder / "p.md"
    path.write_text(text)
    return {each.symbol: each.body for each in ingest(path).definitions if each.sure}


@pytest.mark.parametrize(("text", "name", "part"), DEFINED)
def test_draft_defines_what_a_text_says(tmp_path: Path, text: str, name: str, part: str) -> None:
    body = _definitions(tmp_path, text).get(name, "nothing")
    assert part.replace(" ", "") in body.replace(" ", "")


@pytest.mark.parametrize(("text", "name"), NOT_DEFINED)
def test_draft_defines_nothing_by_a_case(tmp_path: Path, text: str, name: str) -> None:
    assert name not in _definitions(tmp_path, text)


@pytest.mark.parametrize("norm", [r"\|n\|", r"n \cdot n", "n^T n"])
def test_vector_of_norm_1_is_a_unit_vector(tmp_path: Path, norm: str) -> None:
    text = rf"Let $\phi = \theta n$ with ${norm} = 1$ and $K = n^\wedge$. $$K^2 = {{}}$$n n^T - I$$"
    text = text.replace("{}$$", "")
    assert _warned(tmp_path, text) == []
    assert len(_warned(tmp_path, text.replace("- I", "+ I"))) == 1


def test_fact_that_names_another_symbol_restricts_nothing(tmp_path: Path) -> None:
    said = r"With $\theta = \|\phi\|$ and $\phi = \theta \mathbf a$ "
    wrong = r"$$(\phi^\wedge)^3 = \theta^2 \phi^\wedge$$"
    assert len(_warned(tmp_path, said + wrong)) == 1
    assert _warned(tmp_path, said + wrong.replace("= ", "= -")) == []


MEANT = r"\frac12 M \dot x^2 + \frac12 m ((\dot x + l \dot\theta \cos\theta)^2 + (l \dot\theta \sin\theta)^2)"
RIGHT = r"\frac12 (M + m) \dot x^2 + m l \dot x \dot\theta \cos\theta + \frac12 m l^2 \dot\theta^2"


def test_equation_in_which_most_symbols_cancel_is_meant_for_all(tmp_path: Path) -> None:
    assert _warned(tmp_path, f"$${MEANT} = {RIGHT}$$") == []
    assert len(_warned(tmp_path, f"$${MEANT} = {RIGHT.replace('(M + m) ', '')}$$")) == 1
    assert _warned(tmp_path, r"$$m g l \sin\theta + m l^2 \ddot\theta = 0$$ $$m a + m b = m c d$$") == []


@pytest.mark.parametrize("value", [r"\pi", r"-\frac{\pi}{2}", "0", "3", r"90^\circ"])
def test_values_at_which_something_happens_define_nothing(tmp_path: Path, value: str) -> None:
    text = rf"The dead centres are $\theta = {value}$ and others. $$\dot\theta = \sin\theta$$"
    assert r"\theta" not in _definitions(tmp_path, text)


def _warned(folder: Path, text: str) -> list[str]:
    """Returns the formulas of a text that are warnings."""
    path = folder / "p.md"
    path.write_text(text)
    draft = draft_of(path)
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    return [each.claim.printed.latex for each in results if each.verdict.grade is Grade.WARNING]


LAWS = r"$$\dot x = v\cos\theta$$ $$\dot y = v\sin\theta$$ "


@pytest.mark.parametrize("factor", ["", "2 "])
@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"\dot x\sin\theta = \dot y\cos\theta", r"\dot x\cos\theta = \dot y\sin\theta"),
        (r"\dot x^2 + \dot y^2 = v^2", r"\dot x^2 - \dot y^2 = v^2"),
        (r"\dot x\cos\theta + \dot y\sin\theta = v", r"\dot x\cos\theta - \dot y\sin\theta = v"),
    ],
)
def test_equation_of_rates_that_laws_give_is_a_claim(
    tmp_path: Path, factor: str, right: str, wrong: str
) -> None:
    laws = LAWS.replace("$$\\", f"$${factor}\\").replace("= v", f"= {factor}v")
    assert _warned(tmp_path, laws + f"$${right}$$") == []
    assert len(_warned(tmp_path, laws + f"$${wrong}$$")) == 1


def test_new_symbol_in_an_equation_of_given_rates_is_no_claim(tmp_path: Path) -> None:
    assert _warned(tmp_path, LAWS + r"$$\dot x\cos\theta - \dot y\sin\theta = u$$") == []


@pytest.mark.parametrize("said", [r"\theta = \text{const}", r"\theta = \mathrm{const.}"])
def test_special_case_does_not_excuse_another_formula(tmp_path: Path, said: str) -> None:
    text = (
        r"$$L = \tfrac12 m (\dot\theta^2 + \dot\phi^2 \sin^2\theta)$$"
        r" $$\frac{\partial L}{\partial\dot\theta} = m \dot\theta, \qquad"
        r" \frac{\partial L}{\partial\dot\phi} = m \dot\phi \sin\theta$$ "
        f"\n\nA different special case is the conical pendulum, ${said}$, with another speed.\n"
    )
    assert len(_warned(tmp_path, text)) == 1


def test_members_that_a_table_gives_are_a_doubt(tmp_path: Path) -> None:
    family = r"$$A_i = \begin{bmatrix} \cos\theta_i & \alpha_i \\ a_i & d_i \end{bmatrix}$$ The table gives"
    product = r" the rest. $$A_2 = \begin{bmatrix} \cos\theta_2 & 0 \\ a_2 & 0 \end{bmatrix}$$"
    assert _warned(tmp_path, family + product) == []


def test_definition_in_a_section_counts_in_its_subsections(tmp_path: Path) -> None:
    text = "# Arm\n\n$$y = l \\sin\\theta$$\n\n## Rate\n\n$$\\dot y = l \\dot\\theta \\sin\\theta$$\n"
    assert len(_warned(tmp_path, text)) == 1
    assert _warned(tmp_path, text.replace("## Rate", "# Another arm")) == []


def test_family_replaces_members_of_an_earlier_section(tmp_path: Path) -> None:
    text = (
        r"$$w_1 = v - u, \quad w_2 = v + u$$ $$w_1 + w_2 = 2 v$$ "
        "\n\n## Others\n\nFor $i = 1, 2$ now\n\n"
        r"$$w_i = v \cos\beta_i$$ $$v = \frac{1}{3} (w_1 + w_2)$$"
    )
    assert _warned(tmp_path, text) == []


def test_bound_of_a_cosine_excuses_only_what_it_excludes(tmp_path: Path) -> None:
    text = r"Here $\cos\phi > 0$. $$x = l \cos\phi$$ "
    wrong = r"$$\dot x = l \dot\phi \cos\phi - \dot l \sin\phi$$"
    assert len(_warned(tmp_path, text + wrong)) == 1


VALUE = st.lists(st.integers(-2, 2).map(str), min_size=3, max_size=3).map(tuple)


@given(VALUE, VALUE, st.sampled_from(["u \\times b = c", "b \\times u = u \\times c", "u = c"]))
def test_sentence_names_each_defined_symbol_but_a_whole_side(
    one: tuple[str, ...], other: tuple[str, ...], said: str
) -> None:
    example = Counterexample(
        {"b": other}, one, other, {"u": one}, ("b",), {"u": "vector", "b": "vector"}, "vector"
    )
    shown = {name for name, _ in told(example, said).defined}
    is_side = said.startswith("u =")
    assert ("u" in shown) == (any(map(Fraction, one)) and not is_side)
