"""Ordinary pages without a model: each wrong line is a warning, and no other line is."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers.drafting.draft_model import ingest
from workbench.papers.drafting.judged_draft import on_drafted_kinds

PAGES = Path(__file__).parent / "pages"
#: The wrong lines of each page, written before the page was first judged.
WRONG = {
    "axis_and_angle.md": {11, 13},
    "bicycle_model.md": {18, 41},
    "cayley_map.tex": set(),
    "dh_parameters.md": set(),
    "differential_drive.md": {11, 25},
    "euler_angles.md": {17, 27},
    "euler_rates_zyx.tex": {18, 48},
    "frenet_frame.tex": {23, 45},
    "inertial_sensors.md": {25, 54},
    "mecanum_wheels.md": {28},
    "moving_frames.tex": {31, 35, 43},
    "pendulum_on_cart.tex": {18},
    "planar_exponentials.tex": {15, 29},
    "planar_jacobian.md": {5},
    "polar.md": {3, 5},
    "quadrotor.tex": {33, 40, 57},
    "quaternion_attitude.md": {18, 48},
    "rigid_motions.md": {5},
    "rodrigues.md": {7, 11},
    "rotating_frame.tex": {10, 14},
    "rotation_exponential.tex": {22, 37},
    "screws_and_adjoint.tex": {29, 34},
    "skew_angular_velocity.tex": set(),
    "slider_crank.tex": {20, 24},
    "spherical_coordinates.tex": {38, 47},
    "spherical_pendulum.md": {25, 37},
    "stewart_platform.tex": {16, 41},
    "turns_about_z.md": {9, 11},
    "two_frames.tex": {22, 44, 55},
    "two_link_dynamics.tex": {18, 27},
    "two_link_transforms.md": {9, 19},
    "unit_quaternion.md": {9, 23},
}
#: Wrong lines that are not found. Most are the first formula for their symbol, which words say to be another
#: quantity: an acceleration, an entry of an inverse. In others the text names a matrix in words only, or a
#: function in brackets is not read.
MISSED = {
    "differential_drive.md": {25},  # θ may rest in a formula without its rate
    "euler_rates_zyx.tex": {48},
    "frenet_frame.tex": {23, 45},
    "inertial_sensors.md": {25, 54},
    "planar_exponentials.tex": {15},
    "quadrotor.tex": {57},
    "quaternion_attitude.md": {18},
    "rotating_frame.tex": {14},  # T is taken for the first time
    "rotation_exponential.tex": {22, 37},
    "screws_and_adjoint.tex": {29},
    "slider_crank.tex": {20, 24},
    "spherical_coordinates.tex": {38},
    "spherical_pendulum.md": {37},
    "stewart_platform.tex": {16, 41},
    "two_frames.tex": {22, 44, 55},
    "two_link_dynamics.tex": {27},
}
#: Pages that take more than 8 s.
SLOW = {
    "bicycle_model.md", "frenet_frame.tex", "quaternion_attitude.md", "rotation_exponential.tex", "slider_crank.tex",
    "stewart_platform.tex", "two_link_dynamics.tex",
}  # fmt: skip
FALSE = (Outcome.REFUTED, Outcome.ILL_FORMED)


@pytest.mark.parametrize(
    "page", [pytest.param(page, marks=pytest.mark.slow) if page in SLOW else page for page in WRONG]
)
def test_warnings_are_the_wrong_lines_of_a_page(page: str, tmp_path: Path) -> None:
    copy = tmp_path / page
    copy.write_text((PAGES / page).read_text())
    draft = draft_of(copy)
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    warned = {
        each.claim.line for each in results if each.verdict.outcome in FALSE and len(each.verdict.unless) < 2
    }
    assert WRONG[page] - MISSED.get(page, set()) <= warned <= WRONG[page]


DEFINITIONS = [
    (r"$$R(\theta) = \theta I$$ $$R(\alpha + \beta) = R(\alpha) + R(\beta)$$", r"R(\theta)"),
    (
        r"$$s_\theta^2 + c_\theta^2 = 1$$ for the angle $\theta$: $$\tan\theta = s_\theta / c_\theta$$",
        r"c_{\theta}",
    ),
    (r"$$c_{12} = c_1 c_2 - s_1 s_2$$ $$\dot\theta_1 + \dot\theta_2 = 0$$", r"c_{12}"),
    (r"$$a = b f(K), \qquad K = b^2$$", "K"),
    (r"$$a = b + K$$ where $$K = b^2$$", "K"),
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
    (r"$$a = b + m$$ In a ring it is alike, with the law $n m = b$, which gives $m = 2 b / n$.", "m"),
]


@pytest.mark.parametrize(("text", "name"), NO_DEFINITIONS)
def test_a_text_does_not_define_a_symbol(text: str, name: str, tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(text.replace("$$ ", "$$\n\n").replace(" $$", "\n\n$$"))
    assert name not in {each.name for each in ingest(path).definitions}
