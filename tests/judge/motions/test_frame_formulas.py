"""Formulas of moving frames against a numeric model of rigid motions: right ones are proved, wrong ones refuted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from random import Random

import numpy as np
import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers import load_paper

NOTATION = r"""
[frames]
base = "N"
names = ["A", "B", "C"]
dot = "N"
'{}^F\omega^G' = "angular velocity of G in F"
'{}^F\alpha^G' = "angular acceleration of G in F"
[points]
names = ["O", "P", "Q", "S", "T"]
fixed = { O = "N", Q = "B", S = "A", T = "B" }
'r^{P/Q}' = "to P from Q"
'{}^F v^P' = "velocity of P in F"
'{}^F a^P' = "acceleration of P in F"
[symbols]
x = "vector"
y = "vector"
"""
FRAMES = ("N", "A", "B", "C")
POINTS = ("O", "P", "Q", "S", "T")

# --- the model: columns of the base as functions of time, differentiated by differences

Column = Callable[[float], np.ndarray]
_STEP = 2e-2
_STENCIL = ((-2, 1 / 12), (-1, -2 / 3), (1, 2 / 3), (2, -1 / 12))
_CLOSE, _FAR = 1e-4, 1e-2


def rate(of: Callable[[float], np.ndarray]) -> Callable[[float], np.ndarray]:
    return lambda t: sum(weight * of(t + place * _STEP) for place, weight in _STENCIL) / _STEP


def turn(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis / np.linalg.norm(axis)
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


class Motion:
    """Random motions of all frames, points and free vectors."""

    def __init__(self, seed: int) -> None:
        random = np.random.default_rng(seed)
        self.turns: dict[str, Callable[[float], np.ndarray]] = {"N": lambda t: np.eye(3)}
        for frame in FRAMES[1:]:
            self.turns[frame] = self.turning(random)
        self.free = {name: self.wandering(random) for name in (*"xyP", "origin A", "origin B", "origin C")}
        self.offsets = {name: random.uniform(-1, 1, 3) for name in "OST"}

    @staticmethod
    def turning(random: np.random.Generator) -> Callable[[float], np.ndarray]:
        axes, speeds = random.uniform(-1, 1, (2, 3)), random.uniform(0.5, 1, (2, 2))
        return lambda t: turn(axes[0], speeds[0] @ (t, t * t)) @ turn(axes[1], speeds[1] @ (t, t * t))

    @staticmethod
    def wandering(random: np.random.Generator) -> Column:
        terms = random.uniform(-1, 1, (4, 3))
        return lambda t: terms[0] + t * terms[1] + t * t * terms[2] + t**3 * terms[3]

    def origin(self, frame: str) -> Column:
        return (lambda t: np.zeros(3)) if frame == "N" else self.free[f"origin {frame}"]

    def place(self, point: str) -> Column:
        if point == "P":
            return self.free["P"]
        frame, offset = {"O": "N", "Q": "B", "S": "A", "T": "B"}[point], self.offsets.get(point, np.zeros(3))
        return lambda t: self.origin(frame)(t) + self.turns[frame](t) @ offset

    def derivative(self, frame: str, of: Column) -> Column:
        own = self.turns[frame]
        moved = rate(lambda t: own(t).T @ of(t))
        return lambda t: own(t) @ moved(t)

    def spin(self, seen_from: str, of: str) -> Column:
        relative = lambda t: self.turns[seen_from](t).T @ self.turns[of](t)  # noqa: E731
        slope = rate(relative)

        def column(t: float) -> np.ndarray:
            skew = slope(t) @ relative(t).T
            return self.turns[seen_from](t) @ np.array([skew[2, 1], skew[0, 2], skew[1, 0]])

        return column

    def velocity(self, frame: str, point: str) -> Column:
        return self.derivative(frame, lambda t: self.place(point)(t) - self.origin(frame)(t))


@cache
def motions() -> list[Motion]:
    return [Motion(seed) for seed in range(3)]


# --- formulas: a sum of terms on each side, with its LaTeX and its value


@dataclass(frozen=True)
class Vector:
    """head: what it is; letters: of frames and points; inner: what is differentiated or multiplied."""

    head: str
    letters: tuple[str, ...] = ()
    inner: tuple[Vector, ...] = ()

    @property
    def latex(self) -> str:
        match self.head, self.letters:
            case "d", (frame,):
                return rf"\frac{{{{}}^{frame} d}}{{dt}} {_bracketed(self.inner[0])}"
            case "×", _:
                return r" \times ".join(map(_bracketed, self.inner))
            case "r", (point, other):
                return f"r^{{{point}/{other}}}"
            case ((r"\omega" | r"\alpha" | "v" | "a"), (frame, other)):
                return f"{{}}^{frame} {self.head}^{other}"
        return self.head

    def value(self, motion: Motion) -> Column:
        inner = [each.value(motion) for each in self.inner]
        match self.head, self.letters:
            case "d", (frame,):
                return motion.derivative(frame, inner[0])
            case "×", _:
                return lambda t: np.cross(inner[0](t), inner[1](t))
            case "r", (point, other):
                return lambda t: motion.place(point)(t) - motion.place(other)(t)
            case r"\omega", (frame, other):
                return motion.spin(frame, other)
            case r"\alpha", (frame, other):
                return motion.derivative(frame, motion.spin(frame, other))
            case "v", (frame, point):
                return motion.velocity(frame, point)
            case "a", (frame, point):
                return motion.derivative(frame, motion.velocity(frame, point))
        return motion.free[self.head]


def _bracketed(vector: Vector) -> str:
    return vector.latex if not vector.inner and vector.head != "r" else rf"\left( {vector.latex} \right)"


def d(frame: str, of: Vector) -> Vector:
    return Vector("d", (frame,), (of,))


def cross(one: Vector, other: Vector) -> Vector:
    return Vector("×", (), (one, other))


def w(frame: str, of: str) -> Vector:
    return Vector(r"\omega", (frame, of))


def alpha(frame: str, of: str) -> Vector:
    return Vector(r"\alpha", (frame, of))


def r(point: str, other: str) -> Vector:
    return Vector("r", (point, other))


@dataclass(frozen=True)
class FrameFormula:
    left: Vector
    right: tuple[tuple[int, Vector], ...]

    @property
    def latex(self) -> str:
        terms = [(factor, term.latex) for factor, term in self.right]
        signs = ["- " if factor < 0 else "+ " for factor, _ in terms]
        sizes = ["" if abs(factor) == 1 else f"{abs(factor)} " for factor, _ in terms]
        told = " ".join(f"{s}{n}{t}" for s, n, (_, t) in zip(signs, sizes, terms, strict=True))
        return f"{self.left.latex} = {told.removeprefix('+ ')}"

    def is_true(self) -> bool:
        """By its residual on the motions. It must be clear."""
        worst = 0.0
        for motion in motions():
            for t in (0.3, 0.8):
                terms = [factor * term.value(motion)(t) for factor, term in self.right]
                left = self.left.value(motion)(t)
                size = 1 + max(np.abs([left, *terms]).max(), 0)
                worst = max(worst, np.abs(left - sum(terms)).max() / size)
        assert worst < _CLOSE or worst > _FAR, self.latex
        return worst < _CLOSE


def right_formula(random: Random) -> FrameFormula:
    f, g, h = random.sample(FRAMES, 3)
    p, q = random.sample(POINTS, 2)
    v = random.choice([Vector("x"), Vector("y"), r(p, q), w(g, h)])
    spin, arm = w("N", g), r(p, q)
    kinds = [
        (d(f, v), ((1, d(g, v)), (1, cross(w(f, g), v)))),
        (d(f, v), ((1, d(g, v)), (-1, cross(v, w(f, g))))),
        (cross(w(f, g), v), ((1, d(f, v)), (-1, d(g, v)))),
        (w(f, h), ((1, w(f, g)), (1, w(g, h)))),
        (w(f, g), ((-1, w(g, f)),)),
        (alpha(f, g), ((1, d(f, w(f, g))),)),
        (alpha(f, g), ((1, d(g, w(f, g))),)),
        (alpha(f, h), ((1, alpha(f, g)), (1, alpha(g, h)), (1, cross(w(f, g), w(g, h))))),
        (Vector("v", ("N", p)), ((1, Vector("v", ("N", q))), (1, d(g, arm)), (1, cross(spin, arm)))),
        (Vector("v", ("N", "T")), ((1, Vector("v", ("N", "Q"))), (1, cross(w("N", "B"), r("T", "Q"))))),
        (Vector("a", (f, p)), ((1, d(f, Vector("v", (f, p)))),)),
        (
            Vector("a", ("N", "T")),
            (
                (1, Vector("a", ("N", "Q"))),
                (1, cross(alpha("N", "B"), r("T", "Q"))),
                (1, cross(w("N", "B"), cross(w("N", "B"), r("T", "Q")))),
            ),
        ),
        (
            Vector("a", ("N", p)),
            (
                (1, Vector("a", ("N", q))),
                (1, d(g, d(g, arm))),
                (1, cross(alpha("N", g), arm)),
                (2, cross(spin, d(g, arm))),
                (1, cross(spin, cross(spin, arm))),
            ),
        ),
    ]
    return FrameFormula(*random.choice(kinds))


def changed(formula: FrameFormula, random: Random) -> FrameFormula:
    """With a sign, a factor, an order or a letter of a frame changed in one term."""
    terms = list(formula.right)
    place = random.randrange(len(terms))
    factor, term = terms[place]
    match random.choice(["sign", "factor", "order", "letter", "letter"]):
        case "sign":
            terms[place] = -factor, term
        case "factor":
            terms[place] = 3 * factor, term
        case "order":
            terms[place] = factor, _swapped(term)
        case _:
            terms[place] = factor, _with_letter(term, random)
    return FrameFormula(formula.left, tuple(terms))


def _swapped(term: Vector) -> Vector:
    if term.head == "×":
        return Vector("×", (), term.inner[::-1])
    letters = term.letters if term.head in ("v", "a", "d") else term.letters[::-1]
    return Vector(term.head, letters, tuple(map(_swapped, term.inner)))


def _with_letter(term: Vector, random: Random) -> Vector:
    if term.letters and term.head != "r":
        others = [frame for frame in FRAMES if frame not in term.letters]
        return Vector(term.head, (random.choice(others), *term.letters[1:]), term.inner)
    if not term.inner:
        return term
    return Vector(term.head, term.letters, (_with_letter(term.inner[0], random), *term.inner[1:]))


def formulas(seed: int, count: int) -> list[FrameFormula]:
    """As many right formulas as changed ones, all of them different."""
    random, found = Random(seed), {}
    while len(found) < count:
        formula = right_formula(random)
        formula = changed(formula, random) if len(found) % 2 else formula
        found.setdefault(formula.latex, formula)
    return list(found.values())


def verdicts(folder: Path, asked: Sequence[FrameFormula]) -> Iterator[tuple[FrameFormula, Outcome, str]]:
    claims = "".join(f"[[claim]]\nid = '{n}'\nprinted = '{each.latex}'\n" for n, each in enumerate(asked))
    (folder / "p.toml").write_text(f'title = "p"\n{NOTATION}{claims}')
    results = judge_paper(load_paper(folder / "p.toml"), motions=False, jobs=1)
    for formula, result in zip(asked, results, strict=True):
        yield formula, result.verdict.outcome, result.verdict.reason or ""


HOLDING = {Outcome.PROVED, Outcome.DEFINITION}


def require_right_verdicts(folder: Path, asked: Sequence[FrameFormula]) -> None:
    truths = [formula.is_true() for formula in asked]
    assert min(truths.count(True), truths.count(False)) > len(truths) / 4
    for truth, (formula, outcome, reason) in zip(truths, verdicts(folder, asked), strict=True):
        assert r"\mathsf" not in reason, (formula.latex, reason)
        assert outcome in (HOLDING if truth else {Outcome.REFUTED}), (formula.latex, reason)


def test_frame_formulas_are_judged_as_they_move(tmp_path: Path) -> None:
    require_right_verdicts(tmp_path, formulas(1, 240))


@pytest.mark.slow
def test_many_frame_formulas_are_judged_as_they_move(tmp_path: Path) -> None:
    require_right_verdicts(tmp_path, formulas(Random().randrange(2, 10**9), 3000))


@pytest.fixture
def notation(tmp_path: Path) -> Path:
    file = tmp_path / "notation.toml"
    file.write_text(NOTATION + 'f = "scalar"\nF = "vector"\nm = { kind = "scalar", constant = true }\n')
    return file


@pytest.mark.parametrize(
    ("latex", "written"),
    [
        (r"m {}^N a^P = F", "{}^{N}a^{P}"),
        (r"m \frac{{}^N d}{dt} {}^N v^P = F", r"{}^{N}\dot{v}^{P}"),
        (r"\dot{x} = y", r"\dot{x}"),
        (r"\frac{{}^A d x}{dt} = {}^A\omega^B \times x", r"\dot{x}"),
        (r"{}^N v^P = f x", "{}^{N}v^{P}"),
    ],
)
def test_law_is_for_a_symbol_that_is_written(latex: str, written: str, notation: Path) -> None:
    verdict = check(latex, notation=notation).verdict
    assert verdict.outcome is Outcome.UNCHECKED
    assert verdict.reason.startswith(f"states a law for {written},"), verdict.reason
