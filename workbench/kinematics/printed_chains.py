"""The closed forms of the twists of 2C and 3C chains as LaTeX; `cylindrical_chains` evaluates them."""

from __future__ import annotations

import re


def latex_2c(expanded: bool = False) -> tuple[str, ...]:
    """Returns Eqs. (143)–(146) in the chapter's notation, marks restored; ``expanded``: with (147).

    >>> len(latex_2c())
    4
    """
    return tuple(map(_in_the_chapters_letters, _EXPANDED_2C if expanded else _NESTED_2C))


def latex_3c(expanded: bool = False) -> tuple[str, ...]:
    """Returns ω̲, ω̲̇, ω̲̈, ω̲⃛ of the 3C chain in the chapter's notation: in products nested to the
    right, as in (146), or ``expanded`` in the u̲ᵢ and u̲ᵢ × u̲ⱼ alone, as in (147).

    >>> len(latex_3c())
    4
    """
    return tuple(map(_in_the_chapters_letters, _EXPANDED_3C if expanded else _NESTED_3C))


_NESTED_2C = (
    r"W = w_1 u_1 + w_2 u_2",
    r"\dot{W} = \dot{w}_1 u_1 + \dot{w}_2 u_2 + w_1 w_2 u_1 \times u_2",
    r"\ddot{W} = \ddot{w}_1 u_1 + \ddot{w}_2 u_2"
    r" + (2 w_1 \dot{w}_2 + \dot{w}_1 w_2) u_1 \times u_2"
    r" + w_1^2 w_2 u_1 \times (u_1 \times u_2)",
    r"\dddot{W} = \dddot{w}_1 u_1 + \dddot{w}_2 u_2"
    r" + (\ddot{w}_1 w_2 + 3 \dot{w}_1 \dot{w}_2 + 3 w_1 \ddot{w}_2 - w_1^3 w_2) u_1 \times u_2"
    r" + 3 (w_1^2 \dot{w}_2 + w_1 \dot{w}_1 w_2) u_1 \times (u_1 \times u_2)",
)
_EXPANDED_2C = (
    *_NESTED_2C[:2],
    r"\ddot{W} = [\ddot{w}_1 + w_1^2 w_2 (u_1 \cdot u_2)] u_1 + [\ddot{w}_2 - w_1^2 w_2] u_2"
    r" + (2 w_1 \dot{w}_2 + \dot{w}_1 w_2) u_1 \times u_2",
    r"\dddot{W} = [\dddot{w}_1 + 3 (w_1^2 \dot{w}_2 + w_1 \dot{w}_1 w_2) (u_1 \cdot u_2)] u_1"
    r" + [\dddot{w}_2 - 3 (w_1^2 \dot{w}_2 + w_1 \dot{w}_1 w_2)] u_2"
    r" + (\ddot{w}_1 w_2 + 3 \dot{w}_1 \dot{w}_2 + 3 w_1 \ddot{w}_2 - w_1^3 w_2) u_1 \times u_2",
)
_NESTED_3C = (
    r"W = w_1 u_1 + w_2 u_2 + w_3 u_3",
    r"\dot{W} = \dot{w}_1 u_1 + \dot{w}_2 u_2 + \dot{w}_3 u_3"
    r" + w_1 w_2 u_1 \times u_2 + w_1 w_3 u_1 \times u_3 + w_2 w_3 u_2 \times u_3",
    r"\ddot{W} = \ddot{w}_1 u_1 + \ddot{w}_2 u_2 + \ddot{w}_3 u_3"
    r" + (2 w_1 \dot{w}_2 + \dot{w}_1 w_2) u_1 \times u_2"
    r" + (2 w_1 \dot{w}_3 + \dot{w}_1 w_3) u_1 \times u_3"
    r" + (2 w_2 \dot{w}_3 + \dot{w}_2 w_3) u_2 \times u_3"
    r" + w_1^2 w_2 u_1 \times (u_1 \times u_2)"
    r" + w_1^2 w_3 u_1 \times (u_1 \times u_3)"
    r" + w_2^2 w_3 u_2 \times (u_2 \times u_3)"
    r" + 2 w_1 w_2 w_3 u_1 \times (u_2 \times u_3)",
    r"\dddot{W} = \dddot{w}_1 u_1 + \dddot{w}_2 u_2 + \dddot{w}_3 u_3"
    r" + (\ddot{w}_1 w_2 + 3 \dot{w}_1 \dot{w}_2 + 3 w_1 \ddot{w}_2 - w_1^3 w_2) u_1 \times u_2"
    r" + (\ddot{w}_1 w_3 + 3 \dot{w}_1 \dot{w}_3 + 3 w_1 \ddot{w}_3 - w_1^3 w_3) u_1 \times u_3"
    r" + (\ddot{w}_2 w_3 + 3 \dot{w}_2 \dot{w}_3 + 3 w_2 \ddot{w}_3 - w_2^3 w_3) u_2 \times u_3"
    r" + 3 (w_1^2 \dot{w}_2 + w_1 \dot{w}_1 w_2) u_1 \times (u_1 \times u_2)"
    r" + 3 (w_1^2 \dot{w}_3 + w_1 \dot{w}_1 w_3) u_1 \times (u_1 \times u_3)"
    r" + 3 (w_2^2 \dot{w}_3 + w_2 \dot{w}_2 w_3) u_2 \times (u_2 \times u_3)"
    r" + 3 (2 w_1 w_2 \dot{w}_3 + w_1 \dot{w}_2 w_3 + \dot{w}_1 w_2 w_3) u_1 \times (u_2 \times u_3)"
    r" + 3 w_1^2 w_2 w_3 u_1 \times (u_1 \times (u_2 \times u_3))"
    r" + 3 w_1 w_2^2 w_3 u_1 \times (u_2 \times (u_2 \times u_3))",
)
_EXPANDED_3C = (
    *_NESTED_3C[:2],
    r"\ddot{W} = [\ddot{w}_1 + w_1^2 w_2 (u_1 \cdot u_2) + w_1^2 w_3 (u_1 \cdot u_3)] u_1"
    r" + [\ddot{w}_2 - w_1^2 w_2 + w_2^2 w_3 (u_2 \cdot u_3) + 2 w_1 w_2 w_3 (u_1 \cdot u_3)] u_2"
    r" + [\ddot{w}_3 - w_1^2 w_3 - w_2^2 w_3 - 2 w_1 w_2 w_3 (u_1 \cdot u_2)] u_3"
    r" + (2 w_1 \dot{w}_2 + \dot{w}_1 w_2) u_1 \times u_2"
    r" + (2 w_1 \dot{w}_3 + \dot{w}_1 w_3) u_1 \times u_3"
    r" + (2 w_2 \dot{w}_3 + \dot{w}_2 w_3) u_2 \times u_3",
    r"\dddot{W} = [\dddot{w}_1 + 3 (w_1^2 \dot{w}_2 + w_1 \dot{w}_1 w_2) (u_1 \cdot u_2)"
    r" + 3 (w_1^2 \dot{w}_3 + w_1 \dot{w}_1 w_3) (u_1 \cdot u_3)] u_1"
    r" + [\dddot{w}_2 - 3 (w_1^2 \dot{w}_2 + w_1 \dot{w}_1 w_2)"
    r" + 3 (w_2^2 \dot{w}_3 + w_2 \dot{w}_2 w_3) (u_2 \cdot u_3)"
    r" + 3 (2 w_1 w_2 \dot{w}_3 + w_1 \dot{w}_2 w_3 + \dot{w}_1 w_2 w_3) (u_1 \cdot u_3)] u_2"
    r" + [\dddot{w}_3 - 3 (w_1^2 \dot{w}_3 + w_1 \dot{w}_1 w_3)"
    r" - 3 (w_2^2 \dot{w}_3 + w_2 \dot{w}_2 w_3)"
    r" - 3 (2 w_1 w_2 \dot{w}_3 + w_1 \dot{w}_2 w_3 + \dot{w}_1 w_2 w_3) (u_1 \cdot u_2)] u_3"
    r" + [\ddot{w}_1 w_2 + 3 \dot{w}_1 \dot{w}_2 + 3 w_1 \ddot{w}_2 - w_1^3 w_2"
    r" + 3 w_1^2 w_2 w_3 (u_1 \cdot u_3) + 3 w_1 w_2^2 w_3 (u_2 \cdot u_3)] u_1 \times u_2"
    r" + [\ddot{w}_1 w_3 + 3 \dot{w}_1 \dot{w}_3 + 3 w_1 \ddot{w}_3 - w_1^3 w_3"
    r" - 3 w_1^2 w_2 w_3 (u_1 \cdot u_2) - 3 w_1 w_2^2 w_3] u_1 \times u_3"
    r" + (\ddot{w}_2 w_3 + 3 \dot{w}_2 \dot{w}_3 + 3 w_2 \ddot{w}_3 - w_2^3 w_3) u_2 \times u_3",
)


def _in_the_chapters_letters(formula: str) -> str:
    letters = {"W": r"\underline{\boldsymbol{\omega}}", "w": r"\underline{\omega}"}
    letters["u"] = r"\underline{\mathbf{u}}"
    return re.sub(r"(?<![\\a-zA-Z])[Wwu](?![a-zA-Z])", lambda m: letters[m[0]], formula)
