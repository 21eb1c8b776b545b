r"""A mass is constant and a point of the body turns with it, also where the model forgets to say so: a formula that
holds then is asked about, and one that is false then, too, is refuted."""

from pathlib import Path

import pytest

from tests.texts.written import doubts, shown, symbols_of, told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome, Verdict
from workbench.papers.load import load_paper

KINDS = {
    **dict.fromkeys((r"\omega", "r", "v", "a", "u"), "vector"), **dict.fromkeys(("m", "l", r"\theta"), "scalar"),
    "J": "tensor", "R": "rotation", "P": "matrix 2×2", "x": "matrix 2×1",
}  # fmt: skip
OF_R = r"\frac{d}{dt}(\omega \times r)"
TURNED = r"\dot{\omega} \times r + \omega \times (\omega \times r)"
SECOND = r"\frac{d^2}{dt^2}(\omega \times r)"
AGAIN = r"\ddot{\omega} \times r + 2 \dot{\omega} \times (\omega \times r)"
MOMENTUM = r"J \dot{\omega} + \omega \times J \omega"

#: The formula, what it holds for, and the same formula where it is false for that, too.
FORGOTTEN = [
    (r"\frac{d}{dt}(m v) = m \dot{v}", "m: constant", r"\frac{d}{dt}(m v) = 2 m \dot{v}"),
    (r"\frac{d}{dt}(m v \cdot v) = 2 m v \cdot \dot{v}", "m: constant", r"\frac{d}{dt}(m v \cdot v) = m v \cdot \dot{v}"),
    (r"\frac{d^2}{dt^2}(l \sin\theta) = l \ddot{\theta} \cos\theta - l \dot{\theta}^2 \sin\theta", "l: constant",
     r"\frac{d^2}{dt^2}(l \sin\theta) = l \ddot{\theta} \cos\theta + l \dot{\theta}^2 \sin\theta"),
    (r"\frac{d}{dt}(m l v) = l (m \dot{v})", "m, l: constant", r"\frac{d}{dt}(m l v) = -l (m \dot{v})"),
    (r"\frac{d}{dt}(\omega^T J \omega) = 2 \omega^T J \dot{\omega}", "J symmetric", r"\frac{d}{dt}(\omega^T J \omega) = \omega^T J \dot{\omega}"),
    (r"\frac{d}{dt}(x^T P x) = 2 x^T P \dot{x}", "P symmetric", r"\frac{d}{dt}(x^T P x) = -2 x^T P \dot{x}"),
    (f"{OF_R} = {TURNED}", r"r: turning with \omega", f"{OF_R} = {TURNED.replace('+', '-')}"),
    (rf"\frac{{d}}{{dt}}(J \omega) = {MOMENTUM}", r"J: turning with \omega", rf"\frac{{d}}{{dt}}(J \omega) = {MOMENTUM.replace('+', '-')}"),
    (rf"{SECOND} = {AGAIN} + \omega \times ({TURNED})", r"r: turning with \omega", rf"{SECOND} = {AGAIN} - \omega \times ({TURNED})"),
    (r"\frac{d}{dt}(R a + R u) = R \dot{a} + R \dot{u} + R (\omega \times (a + u))", r"R: turning with \omega",
     r"\frac{d}{dt}(R a + R u) = R \dot{a} + R \dot{u} - R (\omega \times a + 2 \omega \times u)"),
    (r"\frac{d}{dt}(R a + R u) = R \dot{a} + R \dot{u} + \omega \times R a + \omega \times R u", r"R: turning with \omega",
     r"\frac{d}{dt}(R a + R u) = R \dot{a} + R \dot{u} - \omega \times R a - 2 \omega \times R u"),
]  # fmt: skip


def verdict(folder: Path, formula: str, definitions: str = "", **more: str) -> Verdict:
    own = "".join(f"'{name}' = {value}\n" for name, value in more.items())
    kinds = symbols_of({name: kind for name, kind in KINDS.items() if name not in more})
    (found,) = verdicts(folder, shown(formula), f"{kinds}{own}[definitions]\n{definitions}")
    return found


@pytest.mark.parametrize(("formula", "what", "false"), FORGOTTEN)
def test_constant_or_rotating_symbols_are_proposed(
    tmp_path: Path, formula: str, what: str, false: str
) -> None:
    asked = verdict(tmp_path, formula)
    assert told(asked) == "said" or (told(asked) == "doubtful" and what in doubts(asked))
    assert verdict(tmp_path, false).outcome is Outcome.REFUTED


def test_it_may_stand_in_a_definition(tmp_path: Path) -> None:
    definition = r"v = '\omega \times r'"
    asked = verdict(tmp_path, rf"\dot{{v}} = {TURNED}", definition)
    assert told(asked) == "doubtful" and r"r: turning with \omega" in doubts(asked)
    assert (
        verdict(tmp_path, rf"\dot{{v}} = {TURNED.replace('+', '-')}", definition).outcome is Outcome.REFUTED
    )


def test_free_symbols_are_neither_constant_nor_rotating(tmp_path: Path) -> None:
    formula, _, _ = FORGOTTEN[0]
    assert verdict(tmp_path, formula, m="{ kind = 'scalar', free = true }").outcome is Outcome.REFUTED
    assert verdict(tmp_path, formula, m="{ kind = 'scalar', constant = true }").outcome is Outcome.PROVED


def test_moving_symbols_are_neither_constant_nor_rotating(tmp_path: Path) -> None:
    assert verdict(tmp_path, r"\frac{d}{dt}(m v) = m \dot{v} + 2 \dot{m} v").outcome is Outcome.REFUTED
    assert verdict(tmp_path, rf"{OF_R} = {TURNED} + 2 \dot{{r}}").outcome is Outcome.REFUTED


#: A formula that holds if a symbol of which only definitions speak is constant, and one that is false then, too.
BEHIND = [
    (r"a = 'R u'", r"\dot{a} = \dot{R} R^T a", "u: constant", r"\dot{a} = -\dot{R} R^T a"),
    (r"a = 'm v'", r"\dot{a} = \frac{a \cdot v}{v \cdot v} \frac{\dot{v}}{1}", "m: constant",
     r"\dot{a} = 2 \frac{a \cdot v}{v \cdot v} \dot{v}"),
]  # fmt: skip


@pytest.mark.parametrize(("definition", "formula", "what", "false"), BEHIND)
def test_constant_symbols_may_occur_in_definitions_only(
    tmp_path: Path, definition: str, formula: str, what: str, false: str
) -> None:
    asked = verdict(tmp_path, formula, definition)
    assert told(asked) == "conditional" and what in doubts(asked)
    assert verdict(tmp_path, false, definition).outcome is Outcome.REFUTED


def test_symbols_that_move_elsewhere_are_not_taken_as_constant(tmp_path: Path) -> None:
    across, rate = r"\dot{a} \times \dot{u} = 0", r"\dot{a} = \dot{l} u + l \dot{u}"
    assert "l: constant" in doubts(verdict(tmp_path, across, "a = 'l u'"))
    (tmp_path / "p.md").write_text(f"$$ {across} $$\n\n$$ {rate} $$")
    lost, right = (each.verdict for each in judge_paper(load_paper(tmp_path / "p.toml")))
    assert lost.outcome is Outcome.REFUTED and right.outcome is Outcome.PROVED
