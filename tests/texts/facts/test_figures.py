r"""Axes of a frame, lengths, what stands at right angles, positive numbers: a figure or a sentence shows them, and a
model may leave them out. A formula that holds then is asked about; one that is false then, too, is refuted."""

from pathlib import Path

import pytest

from tests.texts.written import doubts, shown, symbols_of, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome, Verdict
from workbench.papers.load import load_paper

KINDS = {
    **dict.fromkeys((r"\mathbf{i}", r"\mathbf{j}", r"\mathbf{k}", r"\mathbf{e}_1", r"\mathbf{e}_2", r"\mathbf{e}_3"), "vector"),
    **dict.fromkeys((r"\mathbf{u}_r", r"\mathbf{u}_\theta", r"\hat{k}", r"\hat{n}", r"\hat{r}", r"\hat{\theta}", r"\hat{\phi}"), "vector"),
    **dict.fromkeys(("p_1", "p_2", "p_3", "q_k"), "vector"),
    **dict.fromkeys(("h_1", "h_2", "h_3"), "scalar"),
    **dict.fromkeys((r"\mathbf{a}", r"\mathbf{b}", r"\mathbf{r}", r"\mathbf{n}", r"\vec{r}"), "vector"),
    **dict.fromkeys(("x", "y", "r", "a", "b", "l", "c", "s", r"\omega", r"\theta", r"\phi", r"\mu"), "scalar"),
    "R": "tensor", "A": "matrix 2×2", "z": "matrix 2×1",
}  # fmt: skip
VELOCITY = r"\dot{r} \hat{r} + r \dot{\theta} \hat{\theta}"
POLAR = r"\frac{d}{dt}(\dot{r} \mathbf{u}_r + r \dot{\theta} \mathbf{u}_\theta) = (\ddot{r} - r \dot{\theta}^2) \mathbf{u}_r"
ACROSS = r"(r \ddot{\theta} + 2 \dot{r} \dot{\theta}) \mathbf{u}_\theta"
UP = r"(\cos\theta \mathbf{i} + \sin\theta \mathbf{j}) \times (\cos\phi \mathbf{i} + \sin\phi \mathbf{j})"
EXP = r"\exp \tilde{\mathbf{r}} = \mathbf{I} + \frac{\sin r}{r} \tilde{\mathbf{r}}"

#: The formula, what it holds for, and the same formula where it is false for that, too.
SHOWN = [
    (r"(x \mathbf{i} + y \mathbf{j}) \cdot (x \mathbf{i} + y \mathbf{j}) = x^2 + y^2", r"\mathbf{i}, \mathbf{j}: axes of a frame",
     r"(x \mathbf{i} + y \mathbf{j}) \cdot (x \mathbf{i} + y \mathbf{j}) = x^2 - y^2"),
    (r"\mathbf{a} = (\mathbf{a} \cdot \mathbf{e}_1) \mathbf{e}_1 + (\mathbf{a} \cdot \mathbf{e}_2) \mathbf{e}_2 + (\mathbf{a} \cdot \mathbf{e}_3) \mathbf{e}_3",
     r"\mathbf{e}_{1}, \mathbf{e}_{2}, \mathbf{e}_{3}: axes of a frame",
     r"\mathbf{a} = (\mathbf{a} \cdot \mathbf{e}_1) \mathbf{e}_1 + (\mathbf{a} \cdot \mathbf{e}_2) \mathbf{e}_2 - (\mathbf{a} \cdot \mathbf{e}_3) \mathbf{e}_3"),
    (r"p_1 = (p_1 \cdot p_2) p_2 + (p_1 \cdot p_3) p_3 + (p_1 \cdot p_1) p_1", "p_{1}, p_{2}, p_{3}: axes of a frame",
     r"p_1 = (p_1 \cdot p_2) p_2 + (p_1 \cdot p_3) p_3 - (p_1 \cdot p_1) p_1"),
    (r"\mathbf{a} = \sum_{k=1}^{3} (q_k \cdot \mathbf{a}) q_k", "q_{1}, q_{2}, q_{3}: axes of a frame",
     r"\mathbf{a} = 2 \sum_{k=1}^{3} (q_k \cdot \mathbf{a}) q_k"),
    (rf"({UP}) \cdot \mathbf{{k}} = \sin(\phi - \theta) (\mathbf{{k}} \cdot \mathbf{{k}})", r"\mathbf{i}, \mathbf{j}, \mathbf{k}: axes", rf"({UP}) \cdot \mathbf{{k}} = \sin(\theta - \phi) (\mathbf{{k}} \cdot \mathbf{{k}})"),
    (rf"({VELOCITY}) \cdot ({VELOCITY}) = \dot{{r}}^2 + r^2 \dot{{\theta}}^2", "axes of a frame",
     rf"({VELOCITY}) \cdot ({VELOCITY}) = \dot{{r}}^2 - r^2 \dot{{\theta}}^2"),
    (f"{POLAR} + {ACROSS}", r"axes of a frame that turns by \theta", f"{POLAR} - {ACROSS}"),
    (r"\omega \hat{k} \times (\omega \hat{k} \times \vec{r}) = -\omega^2 \vec{r}", r"\hat{k}: at right angles to \vec{r}",
     r"\omega \hat{k} \times (\omega \hat{k} \times \vec{r}) = \omega^2 \vec{r}"),
    (r"\mathbf{n} \times (\mathbf{n} \times \mathbf{a}) = -(\mathbf{n} \cdot \mathbf{n}) \mathbf{a}", r"\mathbf{n}: at right angles to \mathbf{a}",
     r"\mathbf{n} \times (\mathbf{n} \times \mathbf{a}) = (\mathbf{n} \cdot \mathbf{a}) \mathbf{n} + (\mathbf{n} \cdot \mathbf{n}) \mathbf{a}"),
    (rf"{EXP} + \frac{{1 - \cos r}}{{r^2}} \tilde{{\mathbf{{r}}}} \tilde{{\mathbf{{r}}}}", r"r: the length of \mathbf{r}",
     rf"{EXP} - \frac{{1 - \cos r}}{{r^2}} \tilde{{\mathbf{{r}}}} \tilde{{\mathbf{{r}}}}"),
    (r"\hat{n} \cdot \hat{n} = \hat{k} \cdot \hat{k}", r"\hat{n}, \hat{k}: a unit vector", r"\hat{n} \cdot \hat{n} = 2 \hat{k} \cdot \hat{k}"),
    (r"\sqrt{x^2} = x", "x: positive", r"\sqrt{x^2} = 2 x"),
    (r"\begin{bmatrix} c & -s \\ s & c \end{bmatrix}^{-1} = \begin{bmatrix} c & s \\ -s & c \end{bmatrix}", "c, s: the cosine and sine",
     r"\begin{bmatrix} c & -s \\ s & c \end{bmatrix}^{-1} = \begin{bmatrix} c & -s \\ -s & c \end{bmatrix}"),
    (r"\frac{d}{dt}(\frac{1}{2} x^2 - \frac{\mu}{r}) = x \dot{x} + \frac{\mu}{r^2} \dot{r}", r"\mu: constant",
     r"\frac{d}{dt}(\frac{1}{2} x^2 - \frac{\mu}{r}) = x \dot{x} - \frac{\mu}{r^2} \dot{r}"),
    (r"\dot{z} = A z \Rightarrow \ddot{z} = A^2 z", "A: constant", r"\dot{z} = A z \Rightarrow \ddot{z} = -A^2 z"),
    (r"\mathbf{n} \cdot \mathbf{a} = 0 \Rightarrow \mathbf{n} \times (\mathbf{n} \times \mathbf{a}) = -\mathbf{a}", r"\mathbf{n}: unit",
     r"\mathbf{n} \cdot \mathbf{a} = 0 \Rightarrow \mathbf{n} \times (\mathbf{n} \times \mathbf{a}) = 2 \mathbf{a}"),
]  # fmt: skip

#: What authors hint at by hats, letters and roots, or as they take no rate; the rest is guessed.
HINTS = ("a unit vector", "the length of", "positive", "the cosine and sine", "A: constant")
#: Where vectors at right angles, or of constant length, would leave nothing of what is claimed, or where nothing helps.
FALSE = [
    r"h_1 \mathbf{a} \cdot \mathbf{a} + h_2 h_3 = h_1 \mathbf{a} \cdot \mathbf{a} + 2 h_2 h_3",
    r"(\mathbf{a} \times \mathbf{b}) \cdot (\mathbf{a} \times \mathbf{b}) = (\mathbf{a} \cdot \mathbf{a}) (\mathbf{b} \cdot \mathbf{b}) + (\mathbf{a} \cdot \mathbf{b})^2",
    r"\mathbf{a} \times (\mathbf{b} \times \mathbf{r}) = \mathbf{b} (\mathbf{a} \cdot \mathbf{r}) + \mathbf{r} (\mathbf{a} \cdot \mathbf{b})",
    r"a \mathbf{a} \cdot \mathbf{a} = 2 a^3",
    r"\mathbf{i} \times (\mathbf{i} \times \mathbf{j}) = \mathbf{j}",
    r"\frac{d}{dt}(x \mathbf{a} \cdot \mathbf{a}) = x \mathbf{a} \cdot \dot{\mathbf{a}}",
    r"\|l \dot{\theta}\| = l \dot{\theta}",
    r"\frac{d}{dt}(R \mathbf{a}) = \dot{R} R^T R \mathbf{a}",
]  # fmt: skip


def verdict(folder: Path, formula: str, definitions: str = "") -> Verdict:
    return verdicts(folder, shown(formula), f"{symbols_of(KINDS)}[definitions]\n{definitions}")[-1]


@pytest.mark.parametrize(("formula", "what", "false"), SHOWN)
def test_relations_of_a_figure_are_proposed(tmp_path: Path, formula: str, what: str, false: str) -> None:
    asked = verdict(tmp_path, formula)
    expected = "conditional" if any(hint in what for hint in HINTS) else "doubtful"
    assert told(asked) == expected and what in doubts(asked)
    may_define = what.startswith(
        r"\hat{n}, \hat{k}"
    )  # false of unit vectors, unless it says what one of them is
    assert told(verdict(tmp_path, false)) == ("doubtful" if may_define else "refuted")


@pytest.mark.parametrize("formula", FALSE)
def test_no_figure_excuses_what_is_false_with_it(tmp_path: Path, formula: str) -> None:
    assert verdict(tmp_path, formula).outcome is Outcome.REFUTED


def test_axes_may_occur_in_definitions_only(tmp_path: Path) -> None:
    definitions = r"""
'\mathbf{k}' = '\mathbf{i} \times \mathbf{j}'
'\mathbf{a}' = 'x \mathbf{i} + y \mathbf{j}'
'\mathbf{b}' = '\mathbf{k} \times \mathbf{a}'
"""
    across = r"\mathbf{b} \cdot \mathbf{b} = x^2 + y^2"
    asked = verdict(tmp_path, across, definitions)
    assert told(asked) == "doubtful" and r"\mathbf{i}, \mathbf{j}: axes of a frame" in doubts(asked)
    assert verdict(tmp_path, across.replace("+", "-"), definitions).outcome is Outcome.REFUTED


def test_axes_that_are_declared_constant_stay_so(tmp_path: Path) -> None:
    model = r"""source = 'p.md'
[symbols]
'x' = 'scalar'
'y' = 'scalar'
'\mathbf{r}' = 'vector'
'\mathbf{i}' = { kind = 'vector', unit = true, constant = true }
'\mathbf{j}' = { kind = 'vector', unit = true, constant = true }
[definitions]
'\mathbf{r}' = 'x \mathbf{i} + y \mathbf{j}'
"""
    (tmp_path / "p.toml").write_text(model)
    speeds = r"\dot{\mathbf{r}} \cdot \dot{\mathbf{r}} = \dot{x}^2 + \dot{y}^2"
    (tmp_path / "p.md").write_text(f"$$ {speeds} $$\n\n$$ {speeds.replace(' +', ' -')} $$")
    asked, false = (each.verdict for each in judge_paper(load_paper(tmp_path / "p.toml")))
    assert told(asked) == "doubtful" and r"\mathbf{i}, \mathbf{j}: axes of a frame" in doubts(asked)
    assert false.outcome is Outcome.REFUTED
