"""Remark 7, the Aronhold–Kennedy theorem in space: where it holds, and what replaces it where not.

ω̲₁ = ω₁ + ε v₁ and ω̲₂ = ω₂ + ε v₂ are any twists. Either ω₁ × ω₂ ≠ 0 (`remark_7`), or both are not
zero and parallel, with a sum that is not zero (`remark_7_parallel`, `remark_7_coincident`) or is
(`remark_7_relative_translation`), or one is zero (`remark_7_one_translation`), or both are
(`remark_7_translations`). This is every case. A twist with ω ≠ 0 has pitch p and an axis through a
point x, v = p ω + x × ω; p and x are indeterminates here.

Every identity is proved in dual algebra over FLINT's polynomials in a general frame, and again by
the velocities of points over SymPy's polynomials, written out in components. Every configuration
is then constructed: in rational numbers, and as three bodies of a plant whose velocities Drake gives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any

from proofs.theorems import screw_velocities as by_points
from proofs.theorems.three_bodies import drake_checks, rational_checks
from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import as_vector, cross, dot, scale, triple
from workbench.judge.theorems.arguments import Engine, Step, Way, argue, vanishing
from workbench.judge.verdict import Counterexample, Verdict
from workbench.kinematics.aronhold_kennedy import Configuration

#: Residuals of a step's identities, given 1; given −1, of identities with a sign wrong.
Residuals = Callable[[int], Iterable[Any]]


def remark_7() -> Verdict:
    """The three axes have a common perpendicular, the line of ω̲₁ × ω̲₂: if ω₁ × ω₂ ≠ 0, and only one."""
    return argue(
        [
            _identity(
                "ω̲₁ × ω̲₂ is orthogonal to ω̲₁, ω̲₂ and ω̲₁ + ω̲₂",
                _orthogonal,
                by_points.orthogonal,
            ),
            _identity("the axis of a twist ω̲ is the line of (1 − ε p) ω̲", _axis, by_points.axis),
            _identity(
                "lines that are not parallel meet at right angles iff their dual product is 0",
                _meeting,
                by_points.meeting,
            ),
            _identity(
                "ω₁ × ω₂ ≠ 0: no two axes are parallel, and two of them have one perpendicular",
                _only_one,
                by_points.only_one,
            ),
            _identity(
                "along ω₁ × ω₂, ‖ω₁ + ω₂‖² times the third foot is p₂ − p₁ + Σ ωᵢ · (ω₁ + ω₂) "
                "times the foot of ω̲ᵢ",
                _feet,
                by_points.feet,
            ),
            _example(Configuration.SKEW),
            _example(Configuration.TWO_MEET),
            _example(Configuration.CONCURRENT),
            _example(Configuration.PARALLEL),
        ],
        hypothesis=r"\boldsymbol{\omega}_1 \times \boldsymbol{\omega}_2 \neq 0",
        reason="parallel axes have infinitely many common perpendiculars, and a dual vector with "
        "real part 0 is no line",
        counterexample=Counterexample(
            {
                r"\underline{\omega}_1": ("0", "0", "1", "0", "0", "0"),
                r"\underline{\omega}_2": ("0", "0", "1", "0", "-1", "0"),
                r"\underline{\omega}_1 \times \underline{\omega}_2": ("0", "0", "0", "1", "0", "0"),
            },
            ("0", "0", "0"),
            ("a direction that is not 0",),
        ),
    )


def remark_7_parallel() -> Verdict:
    """ω₂ = μ ω₁, μ ≠ 0, −1, distinct axes: three parallel axes in one plane, whatever the pitches.
    Their common perpendiculars are the lines of that plane along Du(ω̲₁ × ω̲₂); no line has ω̲₁ × ω̲₂."""
    return argue(
        [
            _identity("ω̲₁ × ω̲₂ = ε μ ω₁² times the vector between the axes", _between, by_points.between),
            _identity("the third axis is parallel, in the plane of the two", _third, by_points.third),
            _identity(
                "the lines across that plane meet all three at right angles", _across, by_points.across
            ),
            _identity("there are no others", _no_others, by_points.no_others),
            _example(Configuration.PARALLEL),
        ]
    )


def remark_7_coincident() -> Verdict:
    """ω₂ = μ ω₁, μ ≠ 0, −1, one axis: it is that of ω̲₁ + ω̲₂ too, ω̲₁ × ω̲₂ = 0, and every line that
    meets it at right angles is a common perpendicular."""
    return argue(
        [
            _identity("ω̲₁ × ω̲₂ = 0, and the third axis is the same", _one_line, by_points.one_line),
            _identity("every line that meets it at right angles serves", _pencil, by_points.pencil),
            _example(Configuration.COINCIDENT),
        ]
    )


def remark_7_relative_translation() -> Verdict:
    """ω₁ + ω₂ = 0: there is no third axis. The third motion is the translation by
    (p₁ − p₂) ω₁ + (x₁ − x₂) × ω₁, rest if the axes and pitches agree; the common perpendiculars of
    the two axes are as in the parallel or coincident case, and are at right angles to it."""
    return argue(
        [
            _identity(
                "the third motion is that translation, and the lines across the plane of two "
                "distinct axes meet both at right angles and are normal to it",
                _opposite,
                by_points.opposite,
            ),
            _identity(
                "on one line, ω̲₁ × ω̲₂ = 0 and the translation is (p₁ − p₂) ω₁",
                _opposite_on_one_line,
                by_points.opposite_on_one_line,
            ),
            _example(Configuration.PARALLEL_TRANSLATION),
            _example(Configuration.COINCIDENT_TRANSLATION),
            _example(Configuration.COINCIDENT_REST),
        ]
    )


def remark_7_one_translation() -> Verdict:
    """ω₁ = 0, ω₂ ≠ 0 (or the two exchanged): two axes, parallel, at the distance ω₂ × v₁ / ω₂²; if it
    is not 0, the lines along it across their plane are the common perpendiculars, normal to v₁."""
    return argue(
        [
            _identity(
                "ω̲₁ × ω̲₂ = ε v₁ × ω₂; the third axis is that of ω̲₂ moved by ω₂ × v₁ / ω₂²; the "
                "lines across meet both at right angles and are normal to v₁",
                _translated,
                by_points.translated,
            ),
            _example(Configuration.PARALLEL_TRANSLATION, first_translates=True),
            _example(Configuration.COINCIDENT_TRANSLATION, first_translates=True),
        ]
    )


def remark_7_translations() -> Verdict:
    """ω₁ = ω₂ = 0: no motion has an axis and ω̲₁ × ω̲₂ = 0, so the remark speaks of nothing. What is
    left is a direction, v₁ × v₂, normal to all three translations."""
    return argue(
        [
            _identity(
                "ω̲₁ × ω̲₂ = 0, and v₁ × v₂ is normal to v₁, v₂ and v₁ + v₂",
                _translations,
                by_points.translations,
            ),
            _example(Configuration.TRANSLATIONS),
            _example(Configuration.REST),
        ]
    )


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        remark_7,
        remark_7_parallel,
        remark_7_coincident,
        remark_7_relative_translation,
        remark_7_one_translation,
        remark_7_translations,
    )
}


def _identity(shown: str, in_flint: Residuals, in_sympy: Residuals) -> Step:
    return Step(
        shown,
        *(
            Way(engine, vanishing(partial(f, 1)), but_not=vanishing(partial(f, -1)))
            for engine, f in ((Engine.FLINT, in_flint), (Engine.SYMPY, in_sympy))
        ),
    )


def _example(configuration: Configuration, first_translates: bool = False) -> Step:
    """That the configuration exists, and that its perpendiculars are what `three_axes` says."""
    which = " (the first motion)" if first_translates else ""
    return Step(
        f"constructed: {configuration}{which}",
        *(
            Way(
                engine,
                partial(checks, configuration, first_translates, spoilt=False),
                but_not=partial(checks, configuration, first_translates, spoilt=True),
            )
            for engine, checks in (
                (Engine.FRACTIONS, rational_checks),
                (Engine.DRAKE, drake_checks),
            )
        ),
        by_example=True,
    )


# --- dual algebra over FLINT's polynomials ------------------------------------------------------


def _flint(vectors: str, scalars: str = "") -> Iterator[Any]:
    """Free vectors, then free scalars, one for each letter."""
    from flint import Ordering, fmpq_mpoly_ctx

    names = [f"{v}{i}" for v in vectors for i in range(3)] + list(scalars)
    generators = list(fmpq_mpoly_ctx.get(tuple(names), Ordering.degrevlex).gens())
    for i in range(len(vectors)):
        yield as_vector(generators[3 * i : 3 * i + 3])
    yield from generators[3 * len(vectors) :]


def _screw(omega: Any, pitch: Any, point: Any) -> Dual:
    return Dual(omega, scale(pitch, omega) + cross(point, omega))


def _line(direction: Any, point: Any) -> Dual:
    return Dual(direction, cross(point, direction))


def _orthogonal(sign: int) -> Iterator[Any]:
    a, a0, b, b0 = _flint("apbq")
    first, second = Dual(a, a0), Dual(b, b0)
    for twist in (first, second, first + sign * second, first + second):
        yield dot(cross(first, second), twist) + dot(Dual(a), Dual(b)) * (1 - sign)


def _axis(sign: int) -> Iterator[Any]:
    omega, point, pitch = _flint("ax", "h")
    twist = _screw(omega, pitch, point)
    axis = Dual(1 + 0 * pitch, -sign * pitch)
    yield scale(axis, twist) - _line(omega, point)
    yield dot(omega, twist.du) - pitch * dot(omega, omega)


def _meeting(sign: int) -> Iterator[Any]:
    d, e, p, q = _flint("depq")
    normal, apart = cross(d, e), q - p
    yield dot(_line(d, p), _line(e, q)) - Dual(dot(d, e), -sign * dot(apart, normal))
    yield (
        scale(dot(normal, normal), apart)
        - scale(dot(apart, cross(e, normal)), d)
        - scale(dot(apart, cross(normal, d)), e)
        - scale(dot(apart, normal), normal)
    )


def _only_one(sign: int) -> Iterator[Any]:
    a, b, d = _flint("abd")
    normal = cross(a, b)
    yield cross(a, a + b) - sign * normal
    yield cross(a + b, b) - normal
    yield cross(d, normal) - scale(dot(d, b), a) + scale(dot(d, a), b)
    yield triple(a, b, normal) - dot(normal, normal)


def _feet(sign: int) -> Iterator[Any]:
    a, b, o, y, z, h, k = _flint("abo", "yzhk")
    normal, c = cross(a, b), a + b
    total = _screw(a, h, o + scale(y, normal)) + _screw(b, k, o + scale(z, normal))
    seen = total.du - cross(o, c)  # the velocity at the point o of the perpendicular
    height = k - sign * h + y * dot(a, c) + z * dot(b, c)
    along = scale(dot(c, seen), c)
    yield scale(dot(c, c), seen) - along - scale(height, cross(normal, c))


def _parallel_pair() -> tuple[Any, ...]:
    a, p, q, m, h, k, s = _flint("apq", "mhks")
    apart = scale(dot(a, a), q - p) - scale(dot(a, q - p), a)  # a² times the vector between
    return a, p, q, m, h, k, s, _screw(a, h, p), _screw(scale(m, a), k, q), apart


def _between(sign: int) -> Iterator[Any]:
    _a, _p, _q, m, _h, _k, _s, first, second, apart = _parallel_pair()
    yield cross(first, second) - Dual(0 * apart, sign * scale(m, apart))


def _third(sign: int) -> Iterator[Any]:
    a, p, q, m, h, k, _s, first, second, _apart = _parallel_pair()
    mean_pitch, mean_point = h + sign * m * k, p + scale(m, q)
    yield scale(1 + m, first + second) - Dual(
        scale((1 + m) * (1 + m), a),
        scale((1 + m) * mean_pitch, a) + scale(1 + m, cross(mean_point, a)),
    )


def _across(sign: int) -> Iterator[Any]:
    a, p, _q, _m, _h, _k, s, first, second, apart = _parallel_pair()
    line = _line(apart, p + scale(s, a))
    for twist in (first, second, first + second):
        yield dot(line, twist + (1 - sign) * Dual(apart))


def _no_others(sign: int) -> Iterator[Any]:
    a, p, q, _m, h, _k, s, _first, _second, apart = _parallel_pair()
    between_any_points = q + scale(s, a) - sign * (p + scale(h, a))
    yield (scale(dot(a, a), between_any_points) - scale(dot(a, between_any_points), a) - apart)


def _one_line(sign: int) -> Iterator[Any]:
    a, p, m, h, k, s = _flint("ap", "mhks")
    first, second = _screw(a, h, p), _screw(scale(m, a), k, p + scale(s, a))
    yield cross(first, sign * second + (1 - sign) * Dual(p))
    yield first + second - Dual(scale(1 + m, a), scale(h + m * k, a) + scale(1 + m, cross(p, a)))


def _pencil(sign: int) -> Iterator[Any]:
    a, p, r, h, s = _flint("apr", "hs")
    yield dot(_line(cross(a, r), p + scale(s, a)), _screw(a, sign * h, p) + (1 - sign) * Dual(r))
    yield dot(_line(cross(a, r), sign * p + scale(s, a)), _screw(a, h, p))


def _opposite(sign: int) -> Iterator[Any]:
    a, p, q, h, k, s = _flint("apq", "hks")
    first, second = _screw(a, h, p), _screw(-a, k, q)
    translation = scale(h - sign * k, a) + cross(p - q, a)
    apart = scale(dot(a, a), q - p) - scale(dot(a, q - p), a)
    yield first + second - Dual(0 * a, translation)
    yield cross(first, second) + Dual(0 * a, apart)
    line = _line(apart, p + scale(s, a))
    yield from (dot(line, first), dot(line, second), dot(apart, translation))


def _opposite_on_one_line(sign: int) -> Iterator[Any]:
    a, p, h, k, s = _flint("ap", "hks")
    first, second = _screw(a, h, p), _screw(-a, k, p + scale(s, a))
    yield cross(first, second)
    yield first + second - Dual(0 * a, scale(h - sign * k, a))


def _translated(sign: int) -> Iterator[Any]:
    v, b, q, k, s = _flint("vbq", "ks")
    first, second, square = Dual(0 * v, v), _screw(b, k, q), dot(b, b)
    yield cross(first, second) - Dual(0 * v, sign * cross(v, b))
    moved = scale(square, q) + cross(b, v)
    pitch = square * k + dot(v, b)
    yield scale(square, first + second) - Dual(scale(square, b), scale(pitch, b) + cross(moved, b))
    line = _line(cross(b, v), q + scale(s, b))
    yield from (dot(line, second), dot(line, first + second), dot(line, first))


def _translations(sign: int) -> Iterator[Any]:
    v, w = _flint("vw")
    yield cross(Dual(0 * v, v), Dual(0 * w, w))
    for translation in (v, w, v + sign * w):
        yield dot(cross(v, w), translation + (1 - sign) * cross(v, w))
