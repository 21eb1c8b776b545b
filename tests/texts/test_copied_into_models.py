"""What is copied out of a text into its model is read as it is there, and its faults stand where they are."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, verdicts
from workbench.core.paper_errors import PaperError

#: As texts write it, and as the claim language does.
COPIES = [
    (r"\tfrac{1}{2} a", r"\frac{1}{2} a"),
    (r"\bm{a} \cross b", r"\boldsymbol{a} \times b"),
    (r"\displaystyle s a", "s a"),
    (r"a \cross \mathopen{b}", r"a \times b"),
    (r"\underbrace{s a}_{\text{all}}", "s a"),
]
MODEL = r"""source = "p.md"
[symbols]
'a' = { kind = "vector", aliases = ['\boldsymbol{a}'] }
'b' = "vector"
's' = "scalar"
'x' = "vector"
"""


def outcome(folder: Path, text: str, model: str) -> str:
    return verdicts(folder, shown(text), MODEL + model)[-1].outcome.value


@pytest.mark.parametrize(("copied", "plain"), COPIES)
def test_a_definition(tmp_path: Path, copied: str, plain: str) -> None:
    assert outcome(tmp_path, f"x + b = b + {plain}", f"[definitions]\nx = '{copied}'\n") == "proved"
    assert outcome(tmp_path, f"x + b = b - {plain}", f"[definitions]\nx = '{copied}'\n") == "refuted"


@pytest.mark.parametrize(("copied", "plain"), COPIES)
@pytest.mark.parametrize("key", ["assume", "corrected"])
def test_a_key_of_a_claim(tmp_path: Path, copied: str, plain: str, key: str) -> None:
    value = f"['x = {copied}']" if key == "assume" else f"'{plain} + b = {copied} + b + 0 b'"
    claim = f"[[claim]]\nat = 'line 1'\n{key} = {value}\n"
    printed = f"x \\cdot x = ({plain}) \\cdot ({plain})" if key == "assume" else f"{plain} + b = b - {plain}"
    assert outcome(tmp_path, printed, claim) == ("proved" if key == "assume" else "refuted")


def test_the_place_of_a_fault(tmp_path: Path) -> None:
    with pytest.raises(PaperError, match=r"p.toml:8:19: x: unknown symbol y"):
        outcome(tmp_path, "x = b", "[definitions]\nx = '\\tfrac{1}{2} y'\n")
