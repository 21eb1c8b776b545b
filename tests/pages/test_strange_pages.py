"""Pages without a model: what is found on each, as expected.json has it; the slow ones with --slow."""

from __future__ import annotations

import pytest
from page_scores import Page, expected, pages, scored

#: Pages that take at most about 3 s.
QUICK = frozenset({
    "dev/preintegration.tex", "dev/rotations.tex", "dev/screws.md", "ordinary/axis_and_angle.md",
    "ordinary/euler_angles.md", "ordinary/inertial_sensors.md", "ordinary/planar_jacobian.md", "ordinary/polar.md",
    "ordinary/rigid_motions.md", "ordinary/rodrigues.md", "ordinary/rotating_frame.tex",
    "ordinary/spherical_pendulum.md", "ordinary/turns_about_z.md", "ordinary/two_link_transforms.md",
    "ordinary/unit_quaternion.md",
})  # fmt: skip
PAGES = pages()


def test_each_page_has_an_expected_score() -> None:
    assert {page.name for page in PAGES} == {*expected()}


@pytest.mark.parametrize(
    "page",
    [page if page.name in QUICK else pytest.param(page, marks=pytest.mark.slow) for page in PAGES],
    ids=lambda page: page.name,
)
def test_score_of_a_page_is_as_expected(page: Page) -> None:
    assert scored(page).to_dict() == expected()[page.name]
