"""Quaternions of the jet engine: a scalar and a vector, (a, u)(b, v) = (a b − u·v, a v + b u + u × v)."""

from __future__ import annotations

import numpy as np

from workbench.engines.jet.components import cross, dot


def quaternion_product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    (a, u), (b, v) = (p[0], p[1:]), (q[0], q[1:])
    return joined(a * b - dot(u, v)[()], v * a + u * b + cross(u, v))


def conjugated(q: np.ndarray) -> np.ndarray:
    return joined(q[0], -q[1:])


def joined(scalar: np.ndarray, vector: np.ndarray) -> np.ndarray:
    result = np.empty(4, dtype=object)
    result[0] = scalar[()] if isinstance(scalar, np.ndarray) else scalar
    result[1:] = vector
    return result
