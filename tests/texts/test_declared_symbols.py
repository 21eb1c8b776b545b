"""What a model declares: free symbols and laws, arguments in brackets, scopes, components."""

from __future__ import annotations

from itertools import permutations
from pathlib import Path

import pytest

from tests.texts.written import (
    ALPHABETS,
    FORMATS,
    display,
    heading,
    inline,
    paper_of,
    renamed,
    text_of,
    told,
    verdicts,
)
from workbench.core.paper_errors import PaperError

WRITTEN = list(zip(ALPHABETS, FORMATS, strict=True))
LAWS = [
    r"\frac{\partial}{\partial <a>} L - \frac{d}{dt} \frac{\partial}{\partial \dot{<a>}} L = 0",
    r"\frac{d}{dt} \frac{\partial L}{\partial \dot{<a>}} = \frac{\partial L}{\partial <a>}",
    r"<m> \ddot{<a>} = <m> <b>",
    r"\ddot{<a>} + <m> <a> = 0",
]
FALSE = [
    r"\frac{\partial}{\partial <a>} L = <m> <b>",
    r"<a> \times \dot{<a>} = \dot{<a>} \times <a>",
    r"\frac{d}{dt} \frac{\partial L}{\partial \dot{<a>}} = 2 <m> \ddot{<a>}",
]
LAGRANGE = r"""[conventions]
gradient = "column"
[symbols]
'<m>' = { kind = "scalar", constant = true }
'<b>' = { kind = "vector", constant = true }
'<a>' = { kind = "vector"%s }
[definitions]
'L' = '\frac{1}{2} <m> |\dot{<a>}|^2 - <m> <b>^T <a>'
"""


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
@pytest.mark.parametrize("flag", ["", ", free = true"])
def test_a_law_of_a_free_symbol_is_no_claim(
    tmp_path: Path, letters: dict[str, str], form: str, flag: str
) -> None:
    model = f"source = 'p.{form}'\n" + renamed(LAGRANGE % flag, letters)
    for formula in LAWS + FALSE:
        text = text_of([display(renamed(formula, letters), form)], form)
        (verdict,) = verdicts(tmp_path, text, model, form)
        assert told(verdict) == ("said" if formula in LAWS else "refuted"), formula
        assert ("law" in (verdict.reason or "")) is (formula in LAWS)


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
def test_rates_of_two_free_symbols_are_a_claim(tmp_path: Path, letters: dict[str, str], form: str) -> None:
    symbols = "".join(f"'{letters[each]}' = {{ kind = 'vector', free = true }}\n" for each in "ab")
    text = text_of([display(renamed(r"\dot{<a>} = <b>", letters), form)], form)
    (verdict,) = verdicts(tmp_path, text, f"source = 'p.{form}'\n[symbols]\n{symbols}", form)
    assert verdict.outcome == "refuted"


#: A matrix of f and g with a bracket, and whether that says what it depends on.
BRACKETS = {
    "f, g": True,
    "g, g": False,
    "f, f": False,
    "f, g, f": False,
}
OF = "'R' = {{ kind = 'tensor', of = ['{f}', '{g}'] }}\n"
SAID = "[conventions]\narguments = ['{f}', '{g}']\n"


@pytest.mark.parametrize("bracket", BRACKETS)
@pytest.mark.parametrize("rate", ["R", r"\dot{R}", "R^T"])
def test_each_argument_is_expected_once(tmp_path: Path, bracket: str, rate: str) -> None:
    for letters, form in WRITTEN:
        written = ", ".join(letters[each] for each in bracket.split(", "))
        text = text_of([display(f"{rate}({written}) + R^T = R^T + {rate}({written})", form)], form)
        scalars = "".join(f"'{letters[each]}' = {{ kind = 'scalar' }}\n" for each in "fg")
        model = f"source = 'p.{form}'\n{SAID.format(**letters)}[symbols]\n'R' = 'tensor'\n{scalars}"
        (verdict,) = verdicts(tmp_path, text, model, form)
        is_told = "stands twice among the arguments" in (verdict.reason or "")
        assert is_told is not BRACKETS[bracket], verdict.reason


@pytest.mark.parametrize(
    ("bracket", "why"), [("f, g", ""), ("g, f", "another place"), ("g", "lacks"), ("g, g", "another place")]
)
def test_a_function_is_written_with_all_its_arguments(tmp_path: Path, bracket: str, why: str) -> None:
    for letters, form in WRITTEN:
        written = ", ".join(letters[each] for each in bracket.split(", "))
        text = text_of(
            [display(rf"\dot{{R}}({written}) - \dot{{R}} = \dot{{R}} - \dot{{R}}({written})", form)], form
        )
        scalars = "".join(f"'{letters[each]}' = {{ kind = 'scalar', independent = true }}\n" for each in "fg")
        model = f"source = 'p.{form}'\n[symbols]\n{OF.format(**letters)}{scalars}"
        (verdict,) = verdicts(tmp_path, text, model, form)
        assert ("cannot be read" in verdict.reason) is (why != "") and why in verdict.reason


#: What a scope defines of which definitions before it speak: each order of these must do.
IN_SCOPE = {"Q": "2 <b>", "<a>": "Q", "P": "2 <a>"}


@pytest.mark.parametrize(("letters", "form"), WRITTEN)
def test_a_scope_defines_what_earlier_definitions_use(
    tmp_path: Path, letters: dict[str, str], form: str
) -> None:
    head = renamed("[symbols]\n'<a>' = 'vector'\n'<b>' = 'vector'\n", letters)
    head += renamed("[definitions]\n'P' = '2 <a>'\n'S' = 'P + <b>'\n", letters)
    formulas = [renamed(each, letters) for each in ("P = 2 <a>", "P = 4 <b>", "S = 5 <b>", "S = 6 <b>")]
    shown = [display(each, form) for each in formulas]
    text = text_of([shown[0], heading("Two", form), *shown[1:]], form)
    for own in (IN_SCOPE, {key: IN_SCOPE[key] for key in ("Q", "<a>")}):
        for order in permutations(own.items()):
            entries = "".join(renamed(f"'{key}' = '{body}'\n", letters) for key, body in order)
            model = f"source = 'p.{form}'\n{head}[[scope]]\nfrom = 'Two'\n[scope.definitions]\n{entries}"
            found = [each.outcome for each in verdicts(tmp_path, text, model, form)]
            assert found == ["definition", "proved", "proved", "refuted"]


def test_a_circle_of_definitions_in_a_scope_is_refused(tmp_path: Path) -> None:
    head = "source = 'p.md'\n[symbols]\na = 'vector'\nb = 'vector'\n[definitions]\nP = '2 a'\n"
    scope = "[[scope]]\nfrom = 'line 5'\n[scope.definitions]\nQ = '2 P'\na = 'Q'\n"
    text = text_of([display("P = 2 a", "md"), display("P = 4 b", "md")], "md")
    with pytest.raises(PaperError, match="used above its definition"):
        paper_of(tmp_path, text, head + scope, "md")


TRACE = r"\operatorname{tr} J + \operatorname{tr}(J K) = 2 \operatorname{tr} K + \operatorname{tr}(K K)"
COMPONENTS = ["J_{xx}", "J_{11}", "J_{zz}"]


@pytest.mark.parametrize("name", ["J", r"\Theta"])
@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("shape", [display, inline])
def test_a_component_that_is_said_leaves_the_whole_open(tmp_path: Path, name: str, form: str, shape) -> None:
    symbols = f"'{name}' = {{ kind = 'tensor', symmetric = true%s }}\n'K' = {{ kind = 'tensor', symmetric = true }}\n"
    for component in [*COMPONENTS, "J"]:
        said = rf"{component} = \int_\Omega \rho (y^2 + z^2) dV".replace("J", name)
        text = text_of(
            ["It is known that", shape(said, form), "Then", display(TRACE.replace("J", name), form)], form
        )
        for flag, expected in (("", "doubtful"), (", free = true", "refuted")):
            model = f"source = 'p.{form}'\n[symbols]\n{symbols % flag}"
            assert told(verdicts(tmp_path, text, model, form)[-1]) == expected, component
    other = text_of(
        [display(r"M_{xx} = \int_\Omega \rho dV", form), display(TRACE.replace("J", name), form)], form
    )
    assert (
        verdicts(tmp_path, other, f"source = 'p.{form}'\n[symbols]\n{symbols % ''}", form)[-1].outcome
        == "refuted"
    )
