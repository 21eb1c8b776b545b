"""Keys of LaTeX: equal where only marks differ that print nothing or the same."""

from __future__ import annotations

import pytest

from workbench.language.grammar.latex_keys import Ignored, latex_key

ALL = Ignored.BRACES | Ignored.SIZES | Ignored.GAPS | Ignored.ALIGNMENT


@pytest.mark.parametrize(
    ("latex", "ignored", "key"),
    [
        (r"x_{1} + \left( y\, z \right)", Ignored.BRACES, r"x_1+\left(y\,z\right)"),
        (r"x_{1} + \bigl( y\, z \bigr)", Ignored.SIZES, r"x_{1}+(y\,z)"),
        (r"x_{1} &= \left\{ y\,z \right\}", ALL, "x_1=\\yz\\"),
        (r"a \rightarrow b \leftarrow c", ALL, r"a\rightarrowb\leftarrowc"),
    ],
)
def test_key_leaves_out_blanks_and_what_is_ignored(latex: str, ignored: Ignored, key: str) -> None:
    assert latex_key(latex, ignored) == key
