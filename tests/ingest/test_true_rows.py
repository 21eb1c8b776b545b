"""True rows of pages that a misread case, list or frame would make false."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import judged_draft_of
from workbench.core.verdict import Outcome

HELD = r"""The speeds of sun, ring and carrier are $n_s$, $n_r$, $n_c$, the numbers of teeth $z_s$, $z_r$:

$$
\frac{n_s - n_c}{n_r - n_c} = -\frac{z_r}{z_s} .
$$

Solving for the carrier,

$$
n_c = \frac{z_s n_s + z_r n_r}{z_s + z_r} .
$$

If the ring is held ($n_r = 0$), the ratio between sun and carrier is

$$
\frac{n_s}{n_c} = 1 + \frac{z_r}{z_s},
$$

whereas with the sun held ($n_s = 0$)

$$
\frac{n_r}{n_c} = 1 + \frac{z_s}{z_r} .
$$
"""
PRIMES = r"""The unit vectors are

$$
e_1 = (\cos\beta\cos\alpha,\ \cos\beta\sin\alpha,\ \sin\beta)'
$$

$$
e_2 = (-\sin\alpha,\ \cos\alpha,\ 0)'
$$

and they are orthogonal:

$$
e_1 \cdot e_2 = 0 .
$$
"""
TWO_FRAMES = r"""The frame $B$ turns with the angular velocity $\boldsymbol\omega = \Omega \mathbf{e}_3$. For any vector $\mathbf{A}$

$$
\boldsymbol\omega = \Omega\, \mathbf{e}_3 ,
$$

$$
\frac{d\mathbf{A}}{dt} = \left(\frac{d\mathbf{A}}{dt}\right)_{B} + \boldsymbol\omega \times \mathbf{A} .
$$
"""


@pytest.mark.parametrize("page", [HELD, PRIMES, TWO_FRAMES], ids=["cases", "primes", "frames"])
def test_true_row_is_not_refuted(tmp_path: Path, page: str) -> None:
    path = tmp_path / "page.md"
    path.write_text(page, encoding="utf-8")
    outcomes = [each.verdict.outcome for each in judged_draft_of(path)]
    assert Outcome.REFUTED not in outcomes and Outcome.ILL_FORMED not in outcomes


def test_case_in_brackets_counts_for_the_next_display_only(tmp_path: Path) -> None:
    path = tmp_path / "page.md"
    path.write_text(HELD, encoding="utf-8")
    facts = [[each.origin.text for each in result.claim.context.facts] for result in judged_draft_of(path)]
    assert ["n_s = 0" in " ".join(each) for each in facts] == [False, False, False, True]
    assert "n_r = 0" in " ".join(facts[2])
