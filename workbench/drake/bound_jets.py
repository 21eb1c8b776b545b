"""Jets of bound symbols: of a binding, of its derivatives, of the members of a family.

A member of a family is computed from Drake's jets by Leibniz' rule. Its error estimate uses the same products
of absolute values, with each factor's own error.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import comb
from typing import Protocol

import numpy as np

from workbench.drake.bindings import Bound
from workbench.drake.gate import MultibodyPlant
from workbench.drake.joint_paths import JointPath
from workbench.drake.quantities import cross

Array = np.ndarray


class Motion(Protocol):
    """The common interface of `ReferenceMotion` and `SampledMotion`."""

    name: str
    samples: tuple[float, ...]
    course: tuple[float, ...]
    plant: MultibodyPlant
    path: JointPath
    body: str

    def __hash__(self) -> int: ...

    def available_bindings(self) -> tuple[str, ...]: ...

    def jet(self, binding: str, order: int, sample: float) -> Array: ...

    def errors(self, binding: str, order: int, sample: float) -> Array: ...


@dataclass(frozen=True)
class Estimated:
    """Derivatives 0 … k of a quantity, shape (k + 1, *shape), and the bound on the error of each entry."""

    values: Array
    errors: Array


def bound_jet(motion: Motion, bound: Bound, index: int, order: int, sample: float) -> Estimated:
    """Returns the symbol of this index (0 if it has none) and its derivatives up to ``order``."""
    first = 0 if bound.rate is None else bound.rate.of(index)
    n = 0 if bound.member is None else bound.member.of(index)
    jets = [_of(motion, name, n + first + order, sample) for name in bound.needs]
    if not bound.binding.made_of:
        return _cut(jets[0], first)
    return _cut(_MADE[bound.binding.name](n, first + order, *jets), first)


@lru_cache(maxsize=4096)
def _of(motion: Motion, name: str, order: int, sample: float) -> Estimated:
    values, errors = motion.jet(name, order, sample), motion.errors(name, order, sample)
    return Estimated(values, np.broadcast_to(_spread(errors, values.ndim), values.shape))


def _spread(errors: Array, dimensions: int) -> Array:
    return errors.reshape(-1, *(1,) * (dimensions - 1))


def _cut(jet: Estimated, first: int) -> Estimated:
    return Estimated(jet.values[first:], jet.errors[first:])


Multiply = Callable[[Array, Array], Array]


def _product(multiply: Multiply, absolute: Multiply, a: Estimated, b: Estimated, order: int) -> Estimated:
    """Returns a product by Leibniz' rule. ``absolute``: the product with all signs positive."""
    values, errors = [], []
    for k in range(order + 1):
        terms = [(comb(k, j), j, k - j) for j in range(k + 1)]
        values.append(sum(c * multiply(a.values[i], b.values[j]) for c, i, j in terms))
        moved = (
            c
            * (
                absolute(a.errors[i], np.abs(b.values[j]) + b.errors[j])
                + absolute(np.abs(a.values[i]), b.errors[j])
            )
            for c, i, j in terms
        )
        errors.append(sum(moved))
    return Estimated(np.array(values), np.array(errors))


def _from(jet: Estimated, n: int, order: int) -> Estimated:
    return Estimated(jet.values[n : n + order + 1], jet.errors[n : n + order + 1])


def _mapped(jet: Estimated, function: Callable[[Array], Array]) -> Estimated:
    return Estimated(*(np.array([function(x) for x in part]) for part in (jet.values, jet.errors)))


def _minus(a: Estimated, b: Estimated) -> Estimated:
    return Estimated(a.values - b.values, a.errors + b.errors)


def _plus(a: Estimated, b: Estimated) -> Estimated:
    return Estimated(a.values + b.values, a.errors + b.errors)


def _matrix(a: Estimated, b: Estimated, order: int) -> Estimated:
    return _product(np.matmul, np.matmul, a, b, order)


def _absolute_cross(a: Array, b: Array) -> Array:
    return np.array([a[i - 2] * b[i - 1] + a[i - 1] * b[i - 2] for i in range(3)])


def _dual_matmul(a: Array, b: Array) -> Array:
    return np.array([a[0] @ b[0], a[0] @ b[1] + a[1] @ b[0]])


def _tensor(n: int, order: int, R: Estimated) -> Estimated:
    return _matrix(_from(R, n, order), _mapped(R, np.transpose), order)


def _dual_tensor(n: int, order: int, R: Estimated) -> Estimated:
    transposed = _mapped(R, lambda x: np.swapaxes(x, -1, -2))
    return _product(_dual_matmul, _dual_matmul, _from(R, n, order), transposed, order)


def _vector_at_origin(n: int, order: int, R: Estimated, p: Estimated) -> Estimated:
    """Returns the vector at the origin; the body point at Wo has the coordinates Rᵀ(−p) in B."""
    return _minus(_from(p, n, order), _matrix(_tensor(n, order, R), p, order))


def _pose_tensor(n: int, order: int, R: Estimated, p: Estimated) -> Estimated:
    Phi, a = _tensor(n, order, R), _vector_at_origin(n, order, R, p)
    parts = []
    for tensor, vector in ((Phi.values, a.values), (Phi.errors, a.errors)):
        block = np.zeros((order + 1, 4, 4))
        block[:, :3, :3], block[:, :3, 3] = tensor, vector
        parts.append(block)
    return Estimated(*parts)


def _field_rate(n: int, order: int, twist: Estimated, p: Estimated) -> Estimated:
    """Returns ω⁽ⁿ⁾ × p + v⁽ⁿ⁾: the n-th rate of the velocity field at a point fixed in W."""
    rates = _from(twist, n, order)
    w, v = (Estimated(rates.values[:, i], rates.errors[:, i]) for i in range(2))
    return _plus(v, _product(cross, _absolute_cross, w, p, order))


def _field_rate_at_origin(n: int, order: int, twist: Estimated, R: Estimated, p: Estimated) -> Estimated:
    return _field_rate(n, order, twist, _point_at_origin(0, order, R, p))


def _dual_field_rate(n: int, order: int, twist: Estimated, *place: Estimated) -> Estimated:
    field = (_field_rate if len(place) == 1 else _field_rate_at_origin)(n, order, twist, *place)
    rates = _from(twist, n, order)
    return Estimated(
        np.stack([rates.values[:, 0], field.values], axis=1),
        np.stack([rates.errors[:, 0], field.errors], axis=1),
    )


def _carried(n: int, order: int, R: Estimated, twist: Estimated) -> Estimated:
    return _product(_dual_matmul, _dual_matmul, R, _from(twist, n, order), order)


def _point_at_origin(_n: int, order: int, R: Estimated, p: Estimated) -> Estimated:
    members = [_vector_at_origin(k, 0, R, p) for k in range(order + 1)]
    return Estimated(*(np.array([getattr(m, part)[0] for m in members]) for part in ("values", "errors")))


_MADE: dict[str, Callable[..., Estimated]] = {
    "Phi_WB": _tensor,
    "a_WB0": _vector_at_origin,
    "Psi_WB": _pose_tensor,
    "A_WP": _field_rate,
    "A_WQ": _field_rate,
    "A_WBo": _field_rate,
    "A_W0": _field_rate_at_origin,
    "dual_A_WP": _dual_field_rate,
    "dual_A_WQ": _dual_field_rate,
    "dual_A_WBo": _dual_field_rate,
    "dual_A_W0": _dual_field_rate,
    "dual_Phi_WB": _dual_tensor,
    "dual_Phi_WA": _dual_tensor,
    "dual_w_AB": _carried,
    "dual_w_BC": _carried,
    "p_W0": _point_at_origin,
}
