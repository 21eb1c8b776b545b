"""What texts that nobody here had seen write, with a model beside them that says what is meant."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.paper_errors import PaperError
from workbench.papers.load import load_paper


def outcomes(folder: Path, text: str, model: str) -> list[str]:
    return [str(each.outcome) for each in verdicts(folder, text, model)]


CHAIN = {
    "md": "$$ a = b + b $$\n$$ = 2 b $$\n\n$$ = 3 b $$\n",
    "tex": r"\begin{document}\[ a = b + b \] \[ = 2 b \]\begin{equation} = 3 b \end{equation}\end{document}",
    "rst": "Text\n\n.. math:: a = b + b\n\n.. math::\n\n   = 2 b\n\n.. math:: = 3 b\n",
}


@pytest.mark.parametrize("ending", CHAIN)
def test_a_display_beginning_with_a_sign_is_a_continuation(tmp_path: Path, ending: str) -> None:
    model = "[symbols]\na = 'scalar'\nb = 'scalar'\n"

    def judged(text: str) -> list[str]:
        (tmp_path / f"p.{ending}").write_text(text)
        (tmp_path / "p.toml").write_text(f'source = "p.{ending}"\n{model}')
        return [str(result.verdict.outcome) for result in judge_paper(load_paper(tmp_path / "p.toml"))]

    chain = CHAIN[ending]
    assert judged(chain) == ["definition", "proved", "refuted"]
    assert judged(chain.replace("b + b", "b + b.")) == ["definition", "refuted"]


def test_a_notation_may_hold_a_range_and_a_kind_by_its_size(tmp_path: Path) -> None:
    model = """[conventions]
quaternion = "hamilton, scalar first"
[notation]
'[q]_{1:3}' = { where = { q = "quaternion" }, means = '\\operatorname{Vec}(q)' }
'S(x)' = { where = { x = "matrix 3×1" }, means = '\\operatorname{skew}(x)' }
'S(r)' = { where = { r = "matrix 1×3" }, means = '\\operatorname{skew}(r^T)' }
[symbols]
q = "quaternion"
a = "vector"
"""
    formulas = [
        r"[q \circ q]_{1:3} = 2 (\operatorname{Sc} q) [q]_{1:3}",
        r"[q \circ q]_{1:3} = (\operatorname{Sc} q) [q]_{1:3}",
        r"S(a) a = \mathbf{0}",
        r"S([1 \quad 0 \quad 0]) a = \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix} \times a",
        r"S([1 \quad 0 \quad 0]) a = a \times \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix}",
    ]
    found = outcomes(tmp_path, "\n\n".join(f"$$ {each} $$" for each in formulas), model)
    assert found == ["proved", "refuted", "proved", "proved", "refuted"]


@pytest.mark.parametrize(("kind", "expected"), [("scalar", ["proved", "refuted"]), ("dual scalar", None)])
def test_a_declared_epsilon_is_a_symbol_if_nothing_is_dual(
    tmp_path: Path, kind: str, expected: list[str] | None
) -> None:
    text = r"$$ q q^* = \eta^2 + \varepsilon^T \varepsilon $$" "\n\n" r"$$ q + q^* = 2 \eta + \varepsilon $$"
    model = "[conventions]\nquaternion = 'hamilton, scalar first'\n"
    model += f"[symbols]\n'\\varepsilon' = 'vector'\n'\\eta' = '{kind}'\n[definitions]\n"
    model += r"'q' = '\operatorname{quat}(\eta, \varepsilon)'"
    if expected is None:
        with pytest.raises(PaperError, match="is the dual unit"):
            outcomes(tmp_path, text, model)
    else:
        assert outcomes(tmp_path, text, model) == expected


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"\frac{1}{30} = 0.033", "unchecked"),
        (r"2 \cdot 0.707^2 = 1", "unchecked"),
        (
            r"\begin{bmatrix} \frac{2}{3} \\ 0 \end{bmatrix} = \begin{bmatrix} 0.67 \\ 0 \end{bmatrix}",
            "unchecked",
        ),
        (r"\frac{1}{30} = 0.034", "refuted"),
        (
            r"\begin{bmatrix} \frac{2}{3} \\ 0 \end{bmatrix} = \begin{bmatrix} 0.66 \\ 0.10 \end{bmatrix}",
            "refuted",
        ),
        (r"0.5 a = 0.25 a", "refuted"),
        (r"0.5 a = -0.5 a", "refuted"),
        (r"\frac{1}{3} a = \frac{1}{4} a", "refuted"),
    ],
)
def test_rounded_values_are_not_false(tmp_path: Path, formula: str, expected: str) -> None:
    assert outcomes(tmp_path, f"$$ {formula} $$", "[symbols]\na = 'scalar'") == [expected]


@pytest.mark.parametrize(
    "declared", ["", "'\\pi' = 'scalar'\n", "'\\pi' = { kind = 'scalar', free = true }\n"]
)
@pytest.mark.parametrize(
    ("formula", "expected", "of_any"),
    [
        (r"a + \sin\pi = a", "proved", "refuted"),
        (r"\cos(\theta + \frac{\pi}{2}) = -\sin\theta", "proved", "refuted"),
        (r"\cos(\theta + \frac{\pi}{2}) = \sin\theta", "refuted", "refuted"),
        (r"\cos \phi = -\sin \theta", "proved", "refuted"),
        (r"\sin 45^\circ = \cos 45^\circ", "proved", "refuted"),
        (r"\sin(\theta - 270\degree) = \cos \theta", "proved", "refuted"),
        (r"\sin(\theta - 270\degree) = \sin \theta", "refuted", "refuted"),
        (r"\sin 45^{\circ} = -\cos 45^{\circ}", "refuted", "refuted"),
        (r"\sin(a \pi) = 0", "refuted", "refuted"),
        (r"\cos\pi = \pi", "refuted", None),
        (r"\cos(\theta + \pi) = a - \cos\theta - a", "proved", "refuted"),
    ],
)
def test_pi_is_the_number_unless_it_is_declared_free(
    tmp_path: Path, declared: str, formula: str, expected: str, of_any: str | None
) -> None:
    model = f"[symbols]\n'a' = {{ kind = 'scalar', free = true }}\n'\\theta' = {{ kind = 'scalar', free = true }}\n{declared}"
    model += "'\\phi' = 'scalar'\n[definitions]\n'\\phi' = '\\theta + \\frac{\\pi}{2}'\n"
    found = outcomes(tmp_path, f"$$ {formula} $$", model)
    assert ("free = true" in declared and of_any is None) or found == [
        of_any if "free" in declared else expected
    ]


def test_two_instants_are_two_values(tmp_path: Path) -> None:
    model = "[conventions]\narguments = ['t', 't_0']\n[symbols]\nx = 'scalar'\nv = 'scalar'\nt_0 = 'scalar'\n"
    formulas = [r"v = x(t) - x(t_0)", r"2 x(t_0) = x(t_0) + x(t_0)", r"2 \dot{x}(t) = \dot{x}(t) + \dot{x}"]
    found = outcomes(tmp_path, "\n\n".join(f"$$ {each} $$" for each in formulas), model)
    assert found == ["unchecked", "proved", "proved"]


def test_an_invalid_alias_is_reported_at_its_symbol(tmp_path: Path) -> None:
    with pytest.raises(PaperError, match="alias q1: q1: expected one symbol") as caught:
        outcomes(tmp_path, "$$ q_1 = 2 $$", "[symbols]\n'q_1' = { kind = 'scalar', aliases = ['q1'] }")
    assert caught.value.line == 3


def test_a_vector_is_defined_by_no_quaternion(tmp_path: Path) -> None:
    model = "[conventions]\nquaternion = 'hamilton, scalar first'\n"
    model += "[symbols]\nq = 'quaternion'\na = 'vector'\nb = 'vector'\n[definitions]\nb = 'q a q^*'"
    with pytest.raises(PaperError, match="b is a vector, its definition is a quaternion"):
        outcomes(tmp_path, "$$ b = q a q^* $$", model)


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"\dot{a} = \dot{R} a^0", "proved"),
        (r"R^T a = a^0", "proved"),
        (r"\dot{a} = 2 \dot{R} a^0", "refuted"),
        (r"a^2 = a^0 \cdot a^0", "proved"),
        (r"a_1^0 \times a_1^0 = 0", "proved"),
        (r"b^0 = b", "unchecked"),
    ],
)
def test_a_vector_with_0_above_may_be_declared(tmp_path: Path, formula: str, expected: str) -> None:
    model = (
        "[symbols]\nR = 'rotation'\na = 'vector'\n'a^0' = { kind = 'vector', constant = true }\nb = 'vector'\n"
        "'a_1^0' = 'vector'\n[definitions]\na = 'R a^0'\n"
    )
    assert outcomes(tmp_path, f"$$ {formula} $$", model) == [expected]
