"""First formulas against what words and other formulas say: a misprint is a warning, a right formula none."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import judged_draft_of
from workbench.core.verdict import Grade, Outcome

_POINT = r"The bob is at $$x = l\sin\theta$$ $$y = -l\cos\theta$$"
_LAGRANGIAN = r"The Lagrangian is $$L = \frac12 m l^2 \dot\theta^2 + m g l \cos\theta$$"
_DRIFT = r"$$p = \dot\phi - \dot\psi\sin\theta$$ $$q = {} $$ $$r = -\dot\theta\sin\phi + \dot\psi\cos\phi\cos\theta$$"
_RATES = r"$$\dot\theta = q\cos\phi - r\sin\phi$$ $$\dot\phi = p + (q\sin\phi + r\cos\phi)\tan\theta$$"
_RATES += r"$$\dot\psi\cos\theta = q\sin\phi + r\cos\phi$$"
_ROWS = (
    r"$$\begin{{aligned}} N_1 &= I_1\dot\omega_1 - (I_2 - I_3)\omega_2\omega_3 \\"
    r" N_2 &= I_2\dot\omega_2 - (I_3 - I_1)\omega_3\omega_1 \\"
    r" N_3 &= I_3\dot\omega_3 - ({})\omega_1\omega_2 \end{{aligned}}$$"
)
_PLANE = r"Let $\mathbf{e} = (\cos\theta, \sin\theta)$ and $\mathbf{f} = (-\sin\theta, \cos\theta)$, "
_POLAR = (
    r"$$\hat{{\mathbf{{e}}}}_r = \cos\theta\,\hat{{\mathbf{{x}}}} + \sin\theta\,\hat{{\mathbf{{y}}}}$$"
    r" $$\hat{{\mathbf{{e}}}}_\theta = -\sin\theta\,\hat{{\mathbf{{x}}}} + \cos\theta\,\hat{{\mathbf{{y}}}}$$"
    r" $$\mathbf{{r}} = r\,\hat{{\mathbf{{e}}}}_r$$ The acceleration has the component"
    r" $$a_\theta = r\ddot\theta + {}\dot r\dot\theta$$"
)
_TURNS = (
    r"The elementary rotations are $$\begin{{aligned}} A &= \begin{{bmatrix}} \cos a & -\sin a \\ \sin a & \cos a"
    r" \end{{bmatrix}} \\ B &= \begin{{bmatrix}} \cos b & \sin b \\ {} & \cos b \end{{bmatrix}} \end{{aligned}}$$"
)

_SQUARE = "Let $f(x) = x^T x$ for a vector $x$. Its derivative along a vector $v$ is $${} = {} x^T v$$"
_ALONG = [r"D f(x)[v]", r"\mathrm{d} f(x) v", r"d f(x) v", r"df_x(v)", r"Df(x) \cdot v", r"T_x f(v)"]

#: A text, and the formulas that are warnings, by a part of each; none if all are right.
TEXTS = [
    # a speed, a velocity, an energy by words
    (_POINT + r"and the square of its speed is $$v^2 = l^2\dot\theta^2$$", []),
    (_POINT + r"and the square of its speed is $$v^2 = l^2\dot\theta$$", ["v^2"]),
    (r"$$x = a\cos\phi$$ The velocity is $$u = -a\dot\phi\sin\phi$$", []),
    (r"$$x = a\cos\phi$$ The velocity is $$u = a\dot\phi\sin\phi$$", ["u ="]),
    (r"$$x = a\cos\phi$$ The size is $$u = a\dot\phi\sin\phi$$", []),
    (_POINT + r"The kinetic energy is $$T = \frac12 m l^2\dot\theta^2$$", []),
    (_POINT + r"The kinetic energy is $$T = m l^2\dot\theta^2$$", ["T ="]),
    # Lagrange's equations
    (_LAGRANGIAN + r"so that $$l\ddot\theta + g\sin\theta = 0$$", []),
    (_LAGRANGIAN + r"so that $$l\ddot\theta + g\cos\theta = 0$$", ["l\\ddot"]),
    (_LAGRANGIAN + r"so that $$m l^2\ddot\theta + m g l\sin\theta = M$$", []),
    # the first formula is blamed, if others hold with one change of it
    (_DRIFT.format(r"\dot\theta\cos\phi + \dot\psi\sin\phi\cos\theta") + _RATES, []),
    (_DRIFT.format(r"\dot\theta\cos\phi + \dot\psi\sin\phi\sin\theta") + _RATES, ["q ="]),
    # rows with other letters
    (_ROWS.format("I_1 - I_2"), []),
    (_ROWS.format("I_1 - I_3"), ["N_3"]),
    # a vector of the plane, and the components of an acceleration along fixed and turning axes
    (
        _PLANE
        + r"so that $$\dot{\mathbf{e}} = \dot\theta\mathbf{f}$$ $$\dot{\mathbf{f}} = -\dot\theta\mathbf{e}$$",
        [],
    ),
    (
        _PLANE
        + r"so that $$\dot{\mathbf{e}} = \dot\theta\mathbf{f}$$ $$\dot{\mathbf{f}} = \dot\theta\mathbf{e}$$",
        ["{f}}"],
    ),
    (_POLAR.format("2"), []),
    (_POLAR.format("3"), ["a_\\theta"]),
    # a derivative along a direction
    *((_SQUARE.format(along, "2"), []) for along in _ALONG),
    *((_SQUARE.format(along, "3"), ["x^T v"]) for along in _ALONG),
    # several rotations
    (_TURNS.format(r"-\sin b"), []),
    (_TURNS.format(r"\sin b"), ["B ="]),
]


@pytest.mark.parametrize(("text", "wrong"), TEXTS)
def test_warnings_are_the_misprints(text: str, wrong: list[str], tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(text.replace("$$ ", "$$\n\n").replace(" $$", "\n\n$$").replace("$$$$", "$$\n\n$$"))
    results = judged_draft_of(path)
    false = [r for r in results if r.verdict.outcome in (Outcome.REFUTED, Outcome.ILL_FORMED)]
    warned = [r.claim.printed.latex for r in false if r.verdict.grade in (Grade.WARNING, Grade.ERROR)]
    assert len(warned) == len(wrong)
    assert all(
        part.replace(" ", "") in latex.replace(" ", "") for part, latex in zip(wrong, warned, strict=True)
    )
