"""Partial derivatives of a frame's twist derivatives with respect to the coordinates and their derivatives.

A variation of the coordinates turns the frame by Σ zᵢ δqᵢ and moves its point by Σ jᵢ δqᵢ, (zᵢ; jᵢ) being the
columns of the Jacobian. So δω = d/dt(Σ zᵢ δqᵢ) − ω × Σ zᵢ δqᵢ, δv = d/dt(Σ jᵢ δqᵢ), and δqᵢ = tʲ/j! gives

    ∂ω⁽ᵏ⁾/∂qᵢ⁽ʲ⁾ = C(k,j) Dᵢ⁽ᵏ⁻ʲ⁾ + C(k,j−1) zᵢ⁽ᵏ⁻ʲ⁺¹⁾,     Dᵢ = żᵢ − ω × zᵢ,
    ∂v⁽ᵏ⁾/∂qᵢ⁽ʲ⁾ = C(k+1,j) jᵢ⁽ᵏ⁻ʲ⁺¹⁾,

by Leibniz' rule. ∂V/∂q̇ is the Jacobian; ∂V/∂qᵢ is [Vᵢ − V, Cᵢ] of the screws of Eq. (119).
"""

from __future__ import annotations

from math import comb

import numpy as np


def twist_partial(J: np.ndarray, D: np.ndarray, k: int, j: int) -> np.ndarray:
    """Returns ∂V⁽ᵏ⁾/∂q⁽ʲ⁾, (..., 6, coordinates), of J (k + 2, ..., 6, coordinates) with its derivatives
    and its turning parts D, Ḋ, … (k + 1, ..., 3, coordinates); V = (ω; velocity of the point that J is
    of), in W's axes."""
    partial = np.zeros(J.shape[1:])
    if j > k + 1:
        return partial
    if j >= 1:
        partial[..., :3, :] = comb(k, j - 1) * J[k - j + 1][..., :3, :]
    if j <= k:
        partial[..., :3, :] += comb(k, j) * D[k - j]
    partial[..., 3:, :] = comb(k + 1, j) * J[k + 1 - j][..., 3:, :]
    return partial
