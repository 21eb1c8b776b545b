"""Definitions that a draft takes from the formulas of a text."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.papers.drafting.draft_model import ingest

DEFINITIONS = [
    (r"$$R(\theta) = \theta I$$ $$R(\alpha + \beta) = R(\alpha) + R(\beta)$$", r"R(\theta)"),
    (
        r"$$s_\theta^2 + c_\theta^2 = 1$$ for the angle $\theta$: $$\tan\theta = s_\theta / c_\theta$$",
        r"c_{\theta}",
    ),
    (r"$$c_{12} = c_1 c_2 - s_1 s_2$$ $$\dot\theta_1 + \dot\theta_2 = 0$$", r"c_{12}"),
    (r"$$a = b f(K), \qquad K = b^2$$", "K"),
    (r"$$a = b + K$$ where $$K = b^2$$", "K"),
    (r"We abbreviate $c_i = \cos\theta_i$: $$x = a_1 c_1 + a_2 c_2$$ $$y_i = a_i \theta_i$$", "c_{i}"),
    (r"$$\dot p = v$$ $$\ddot p = \dot v$$", "v"),
]


@pytest.mark.parametrize(("text", "name"), DEFINITIONS)
def test_a_text_defines_a_symbol(text: str, name: str, tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(text.replace("$$ ", "$$\n\n").replace(" $$", "\n\n$$"))
    assert name in {each.name for each in ingest(path).definitions if each.sure}


NO_DEFINITIONS = [
    (r"$$J(\theta) = \theta^2$$ $$\dot x = J(\theta)$$", r"J(\theta)"),  # it only says what J depends on
    (r"$$c_1 + d_1 = 0$$ $$\dot\theta_1 = c_1$$", r"c_{1}"),
    (r"$$a = b + m$$ with $$m = 1$$", "m"),
    (r"$$A = R_x(\phi)$$ $$\phi = \arctan a$$", r"\phi"),  # a coordinate of an earlier formula
    (r"$$a = b + m$$ In a ring it is alike, with the law $n m = b$, which gives $m = 2 b / n$.", "m"),
]


@pytest.mark.parametrize(("text", "name"), NO_DEFINITIONS)
def test_a_text_does_not_define_a_symbol(text: str, name: str, tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(text.replace("$$ ", "$$\n\n").replace(" $$", "\n\n$$"))
    assert name not in {each.name for each in ingest(path).definitions}


COSINES = r"$$ A = \begin{bmatrix} c\theta & -s\theta \\ s\theta & c\theta \end{bmatrix} $$"


@pytest.mark.parametrize(
    ("more", "is_function"),
    [
        ("", True),
        (r"$$ c\theta\,c\psi - s\theta\,s\psi = \cos(\theta + \psi) $$", True),
        (r"$$ F = c \dot{x} $$", False),  # a coefficient
        (r"$$ x = s / 2 $$", False),
    ],
)
def test_letters_before_angles_are_functions(more: str, is_function: bool, tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(f"{COSINES}\n\n{more}")
    proposals = [each for each in ingest(path).proposals if "'c x'" in each.entries]
    assert bool(proposals) == is_function
