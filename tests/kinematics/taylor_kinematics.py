"""Forward kinematics of series in time, to fifty digits: nothing here is ours, and nothing is differentiated.

A pose is an array (terms, 4, 4) of Taylor coefficients, a joint's coordinate an array (terms,); both hold
mpmath's numbers. A joint's pose is written down from its definition, and a chain is their product.
"""

import numpy as np
from mpmath import mp, mpf

mp.dps = 50


def exact(numbers):
    return np.vectorize(mpf, otypes=[object])(np.asarray(numbers))[()]


def taylor(derivatives):
    """(terms, ...) derivatives as coefficients."""
    return np.array([exact(row) / mp.factorial(k) for k, row in enumerate(derivatives)])


def constant(value, terms):
    value = exact(value)
    return np.array([value, *[value * 0] * (terms - 1)])


def product(a, b, times=np.matmul):
    return np.array([sum(times(a[j], b[k - j]) for j in range(k + 1)) for k in range(len(a))])


def powers(x):
    """The series of xᵏ, k = 0, 1, …, for a series that starts with 0."""
    found = [constant(1, len(x))]
    for _ in x[1:]:
        found.append(product(found[-1], x, np.multiply))
    return found


def cosine_and_sine(q):
    """By e^{i(q₀ + x)} = e^{iq₀} Σ (ix)ᵏ/k!."""
    x = np.array([mpf(0), *q[1:]])
    total = sum(mp.mpc(0, 1) ** k / mp.factorial(k) * power for k, power in enumerate(powers(x)))
    total = mp.expj(q[0]) * total
    return np.array([z.real for z in total]), np.array([z.imag for z in total])


def reciprocal_root(x):
    """By the binomial series of (x₀ + …)^(-1/2)."""
    rest = np.array([mpf(0), *(x[1:] / x[0])])
    return sum(mp.binomial(mpf(-1) / 2, k) * power for k, power in enumerate(powers(rest))) / mp.sqrt(x[0])


def pose(rotation=None, place=None, terms=1):
    X = constant(np.eye(4), terms)
    if rotation is not None:
        X[:, :3, :3] = rotation
    if place is not None:
        X[:, :3, 3] = place
    return X


def turn(axis, q):
    """Rodrigues' formula."""
    x, y, z = exact(axis) / mp.norm(exact(axis).tolist())
    skew = np.array([[mpf(0), -z, y], [z, mpf(0), -x], [-y, x, mpf(0)]])
    c, s = cosine_and_sine(q)
    one = constant(1, len(q))
    R = np.multiply.outer(s, skew) + np.multiply.outer(one - c, skew @ skew) + constant(np.eye(3), len(q))
    return pose(R, terms=len(q))


def shift(axis, q):
    unit = exact(axis) / mp.norm(exact(axis).tolist())
    return pose(place=np.multiply.outer(q, unit), terms=len(q))


def rpy(roll, pitch, yaw):
    return product(product(turn([0, 0, 1], yaw), turn([0, 1, 0], pitch)), turn([1, 0, 0], roll))


def quaternion(*q):
    """1 + 2 w K + 2 K² for the unit quaternion (w, u) along q and K = u ×."""
    root = reciprocal_root(sum(product(x, x, np.multiply) for x in q))
    w, *u = (product(root, part, np.multiply) for part in q)
    K = np.array([np.dot(row, -np.cross(np.eye(3), np.eye(3)[:, None])) for row in np.array(u).T])
    return pose(
        constant(np.eye(3), len(w)) + 2 * product(w, K, np.multiply) + 2 * product(K, K), terms=len(w)
    )


def joint(kind, q, axis=(1, 0, 0), pitch=0):
    """X_FM of a joint whose coordinates q (terms, coordinates) come in Drake's order."""
    q = [q[:, i] for i in range(q.shape[1])]
    x, y, z = np.eye(3)
    if kind.startswith(("ball", "floating")):
        R = (rpy if kind.endswith("rpy") else quaternion)(*(q[:-3] if kind.startswith("floating") else q))
        if kind.startswith("floating"):
            R[:, :3, 3] = np.array(q[-3:]).T
        return R
    factors = {
        "revolute": lambda: [turn(axis, q[0])],
        "prismatic": lambda: [shift(axis, q[0])],
        "helical": lambda: [turn(axis, q[0]), shift(axis, pitch * q[0])],
        "cylindrical": lambda: [turn(axis, q[0]), shift(axis, q[1])],
        "universal": lambda: [turn(x, q[0]), turn(y, q[1])],
        "planar": lambda: [shift(x, q[0]), shift(y, q[1]), turn(z, q[2])],
    }[kind]()
    X = factors[0]
    for factor in factors[1:]:
        X = product(X, factor)
    return X


def twist(X):
    """The series of (ω; v) in Ẋ X⁻¹, v being the velocity at the origin: a term less."""
    rate, inverse = X[1:] * np.arange(1, len(X))[:, None, None], pose(terms=len(X) - 1)
    inverse[:, :3, :3] = X[:-1, :3, :3].swapaxes(1, 2)
    inverse[:, :3, 3] = -product(inverse[:, :3, :3], X[:-1, :3, 3])
    W = product(rate, inverse)
    return np.stack([W[:, 2, 1], W[:, 0, 2], W[:, 1, 0], *W[:, :3, 3].T], axis=-1)


def derivatives(series):
    return np.array([(mp.factorial(k) * row).astype(float) for k, row in enumerate(series)])
