"""The Taylor recursion of a serial chain in plain NumPy: no compiler, no warm-up.

A vector's part across the joint axis is one complex number x + iy, so that the joint's rotation is
the product with e^{iα(t)} and its slide d(t) adds i d ω to v (the dual angle α + εd at work).
"""

import numpy as np

from workbench.kinematics.chain_geometry import Links


def twist(links: Links, q: np.ndarray) -> np.ndarray:
    """Taylor coefficients (n + 1, 6, states) of the twist from those of the coordinates
    (n + 2, dof, states)."""
    series = q.swapaxes(0, 1)  # (dof, n + 2, states)
    terms = series.shape[1] - 1
    rates = series[:, 1:] * np.arange(1, terms + 1)[:, None]
    across = np.zeros((2, terms, series.shape[-1]), dtype=complex)  # of ω and of v
    along = np.zeros((2, terms, series.shape[-1]))
    for i in reversed(range(len(links.angle))):
        angle, slide, pitch = links.angle[i], links.slide[i], links.pitch[i]
        if angle >= 0:
            across = _product(_exponential(series[angle, :-1]), across)
            along[0] += rates[angle]
        if slide >= 0:
            across[1] += 1j * pitch * _product(series[slide, :-1], across[:1])[0]
            along[1] += pitch * rates[slide]
        across, along = _step(across, along, links.twist_angle[i], links.shift[i])
        across[1] += 1j * links.offset[i] * across[0]
        across *= complex(*links.turn[i])
    omega = [across[0].real, across[0].imag, along[0]]
    v = [across[1].real, across[1].imag, along[1]]
    return np.array([*omega, *v]).swapaxes(0, 1)


def _exponential(angle: np.ndarray) -> np.ndarray:
    """The series of e^{iα(t)}, by E' = i α' E."""
    E = np.empty(angle.shape, dtype=complex)
    E[0] = np.exp(1j * angle[0])
    rate = 1j * angle[1:] * np.arange(1, len(angle))[:, None]
    for k in range(1, len(angle)):
        E[k] = (rate[:k] * E[k - 1 :: -1]).sum(axis=0) / k
    return E


def _product(factor: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """The truncated series of factor(t) · vectors(t)."""
    terms = len(factor)
    total = factor[0] * vectors
    for j in range(1, terms):
        total[:, j:] += factor[j] * vectors[:, : terms - j]
    return total


def _step(
    across: np.ndarray, along: np.ndarray, twist_angle: np.ndarray, shift: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """From the entering frame of a joint to the leaving frame of the one before."""
    (cosine, sine), (a, b) = twist_angle, shift
    turned = across.real + 1j * (cosine * across.imag - sine * along)
    z = sine * across.imag + cosine * along
    turned[1] += complex(b, -a) * z[0]
    z[1] += a * turned[0].imag - b * turned[0].real
    return turned, z
