"""Eq. (133) on chains with known motions: 4×4 poses in whole numbers, and the two-joint plants of Drake.

No dual number stands here. A twist is six numbers (ω; v), a dual tensor A + ε A₀ the 6×6 matrix
[A 0; A₀ A], and ω̲̃ the matrix [ω̃ 0; ṽ ω̃]. The pose of body i in body i−1 has the derivatives that
Ṫ = V̂ T gives, V̂ being the 4×4 matrix of its twist; the twist of the last body is that of the product.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import product
from math import comb
from typing import Any

import numpy as np

from tests.proofs.chain_words import Coefficient

Array = np.ndarray


def rational_residuals(
    bodies: int, orders: Sequence[int], coefficient: Coefficient, turned: bool = True
) -> Iterator[Array]:
    """(133) minus the derivatives of the twist of the product of poses, for a chain of general motions.

    Not ``turned``: with the relative twists as they are in their own frames, which is wrong.
    """
    chain = _integer_chain(bodies, max(orders))
    twists = _twists_of_product([pose for _, pose in chain], max(orders))
    seen = [relative for relative, _ in chain]
    if turned:
        seen = _seen_from_base(seen, [pose[0] for _, pose in chain])
    for n in orders:
        yield _closed_form(seen, n, coefficient, _skew_integer) - twists[n]


def drake_residuals(orders: Sequence[int], coefficient: Coefficient, turned: bool = True) -> Iterator[Array]:
    """(133) of two bodies, minus Drake's twist of the second one and its derivatives, over their size."""
    from workbench.drake.motions import reference_motions

    for motion in reference_motions():
        if "dual_w_AB_A" in motion.available_bindings():
            yield from _drake_residuals(motion, orders, coefficient, turned)


def _drake_residuals(
    motion: Any, orders: Sequence[int], coefficient: Coefficient, turned: bool
) -> Iterator[Array]:
    highest = max(orders)
    for time in motion.samples[:2]:
        first, relative, last = (
            motion.jet(name, highest, time).reshape(highest + 1, 6)
            for name in ("dual_w_WA", "dual_w_AB_A", "dual_w_WB")
        )
        R, R0 = motion.jet("dual_R_WA", 0, time)[0]
        turn = np.block([[R, np.zeros((3, 3))], [R0, R]]) if turned else np.eye(6)
        for n in orders:
            claimed = _closed_form([first, relative @ turn.T], n, coefficient, _skew_float)
            yield (claimed - last[n]) / max(1.0, np.abs(last[n]).max())


def _closed_form(
    seen: Sequence[Array], n: int, coefficient: Coefficient, skew: Callable[[Array], Array]
) -> Array:
    """(133); ``seen[i][k]`` is ω̲ᵢ^[k]."""
    total = sum(twist[n] for twist in seen)
    Phi = [_Phi([skew(rate) for rate in twist], n) for twist in seen]
    for p in range(1, len(seen)):
        for k in range(1, n + 1):
            for parts in product(range(k + 1), repeat=p):
                if sum(parts) == k:
                    carried = seen[p][n - k]
                    for i in reversed(range(p)):
                        carried = Phi[i][parts[i]] @ carried
                    total = total + comb(n, k) * coefficient(n, parts) * carried
    return total


def _Phi(rates: Sequence[Array], order: int) -> list[Array]:
    """Φ̲₀ … of one body: Φ̲ₖ₊₁ = Σⱼ C(k, j) ω̲̃^[j] Φ̲ₖ₋ⱼ, Leibniz' rule on ω̲̃ R̲."""
    Phi = [np.eye(6, dtype=rates[0].dtype)]
    for k in range(order):
        Phi.append(sum(comb(k, j) * (rates[j] @ Phi[k - j]) for j in range(k + 1)))
    return Phi


def _seen_from_base(relative: Sequence[Array], poses: Sequence[Array]) -> list[Array]:
    """ω̲ₚ^[k] = ⁰R̲₁ … R̲ₚ₋₁ Ω̲ₚ^(k) from the poses at the instant."""
    turn, seen = np.eye(6, dtype=object), []
    for own, pose in zip(relative, poses, strict=True):
        seen.append(own @ turn.T)
        R, p = pose[:3, :3], pose[:3, 3]
        step = np.zeros((6, 6), dtype=object)
        step[:3, :3] = step[3:, 3:] = R
        step[3:, :3] = _cross_matrix(p) @ R
        turn = turn @ step
    return seen


@lru_cache(maxsize=4)
def _integer_chain(bodies: int, order: int) -> list[tuple[Array, list[Array]]]:
    """For each body the derivatives of its relative twist Ω̲ (order + 1, 6) and of its pose."""
    draw = random.Random(133)
    chain = []
    for i in range(bodies):
        relative = np.array([[draw.randint(-2, 2) for _ in range(6)] for _ in range(order + 1)], dtype=object)
        pose = np.zeros((4, 4), dtype=object)
        for row in range(3):  # a quarter turn about one axis after one about another: whole numbers
            pose[row, (row + 1 + i % 2) % 3] = 1
        pose[:3, 3] = [draw.randint(-3, 3) for _ in range(3)]
        pose[3, 3] = 1
        chain.append((relative, _pose_derivatives(relative, pose)))
    return chain


def _pose_derivatives(relative: Array, pose: Array) -> list[Array]:
    poses = [pose]
    for k in range(len(relative)):
        poses.append(sum(comb(k, j) * (_twist_matrix(relative[j]) @ poses[k - j]) for j in range(k + 1)))
    return poses


def _twists_of_product(chain: Sequence[list[Array]], order: int) -> list[Array]:
    """(ω; v) of Ṫ T⁻¹ and its derivatives, T being the product of the poses: V̂⁽ⁿ⁾ from Ṫ = V̂ T."""
    total = chain[0]
    for pose in chain[1:]:
        total = [sum(comb(k, j) * (total[j] @ pose[k - j]) for j in range(k + 1)) for k in range(order + 2)]
    inverse = np.eye(4, dtype=object)
    inverse[:3, :3] = total[0][:3, :3].T
    inverse[:3, 3] = -total[0][:3, :3].T @ total[0][:3, 3]
    matrices: list[Array] = []
    for n in range(order + 1):
        rest = total[n + 1] - sum(comb(n, j) * (matrices[j] @ total[n - j]) for j in range(n))
        matrices.append(rest @ inverse)
    return [np.array([V[2, 1], V[0, 2], V[1, 0], *V[:3, 3]], dtype=object) for V in matrices]


def _twist_matrix(twist: Array) -> Array:
    matrix = np.zeros((4, 4), dtype=object)
    matrix[:3, :3] = _cross_matrix(twist[:3])
    matrix[:3, 3] = twist[3:]
    return matrix


def _cross_matrix(x: Array) -> Array:
    return np.array([[0 * x[0], -x[2], x[1]], [x[2], 0 * x[0], -x[0]], [-x[1], x[0], 0 * x[0]]])


def _skew_integer(twist: Array) -> Array:
    matrix = np.zeros((6, 6), dtype=object)
    matrix[:3, :3] = matrix[3:, 3:] = _cross_matrix(twist[:3])
    matrix[3:, :3] = _cross_matrix(twist[3:])
    return matrix


def _skew_float(twist: Array) -> Array:
    return _skew_integer(twist).astype(float)
