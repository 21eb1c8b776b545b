"""The job that the benchmark of serial chains sets, and the workbench at work on it.

A chain of m revolute joints T = Π Cᵢ Rz(qᵢ); in, the coordinates' derivatives to order n + 1; out, the
base-frame twist (ω; v) and its time derivatives to order n, readable as numbers.
"""

from dataclasses import dataclass
from math import factorial

import numpy as np

LAYOUTS = {  # of a batch: its axes in memory, o the order, s the states, c the coordinate or component
    "last": "cos",  # the states' numbers side by side: from kernel to kernel, where SIMD goes over states
    "first": "sco",  # all of a state side by side; results "soc"
    "arrays": "osc",  # NumPy's own order of the documented axes (order, states, coordinates)
}


@dataclass(frozen=True)
class Problem:
    """links: (m, 4, 4); q: (m, n + 2) derivatives for the single call; batch: (states, m, n + 2)."""

    links: np.ndarray
    q: np.ndarray
    batch: np.ndarray

    @property
    def joints(self):
        return len(self.links)

    @property
    def order(self):
        return self.q.shape[-1] - 2


def to_taylor(q):
    return q / np.array([float(factorial(k)) for k in range(q.shape[-1])])


def from_taylor(V):
    return V * np.array([float(factorial(k)) for k in range(V.shape[-2])])[:, None]


def carry(C, V):
    """Ad(C) V, number by number, leaving out the zeros."""
    R, p = C[:3, :3], C[:3, 3]
    rows = np.block([[R, np.zeros((3, 3))], [np.cross(p, R, axisb=0, axisc=0), R]])
    return [sum(float(a) * x for a, x in zip(row, V, strict=True) if a != 0) for row in rows]


def twist(links, q, rate, sin, cos):
    """The twist alone, in any arithmetic: to be differentiated by the tool."""
    V = [0.0] * 6
    for C, angle, speed in reversed(list(zip(links, q, rate, strict=True))):
        c, s = cos(angle), sin(angle)
        V = [
            c * V[0] - s * V[1],
            s * V[0] + c * V[1],
            V[2] + speed,
            c * V[3] - s * V[4],
            s * V[3] + c * V[4],
            V[5],
        ]
        V = carry(C, V)
    return V


def twist_series(links, q, sin, cos):
    """The same recursion on Taylor coefficients q[i][k], written out: [k][component]."""
    terms = len(q[0]) - 1
    V = [[0.0] * 6 for _ in range(terms)]
    for i in reversed(range(len(links))):
        c, s = [cos(q[i][0])], [sin(q[i][0])]
        for k in range(1, terms):
            c.append(sum(-j / k * q[i][j] * s[k - j] for j in range(1, k + 1)))
            s.append(sum(j / k * q[i][j] * c[k - j] for j in range(1, k + 1)))
        turned = []
        for k in range(terms):
            row = [None] * 6
            for x, y, z in ((0, 1, 2), (3, 4, 5)):
                row[x] = sum(c[k - j] * V[j][x] - s[k - j] * V[j][y] for j in range(k + 1))
                row[y] = sum(s[k - j] * V[j][x] + c[k - j] * V[j][y] for j in range(k + 1))
                row[z] = V[k][z]
            row[2] = row[2] + (k + 1) * q[i][k + 1]
            turned.append(carry(links[i], row))
        V = turned
    return V


class Peer:
    """A tool at work on one problem, built by its constructor."""

    layout = "first"  # of the batch, from input to output

    def run_single(self):
        raise NotImplementedError

    def run_batch(self):
        raise NotImplementedError

    def results(self):
        """Derivatives of the single state (n + 1, 6) and of the batch (states, n + 1, 6)."""
        raise NotImplementedError


class Workbench(Peer):
    def __init__(self, problem):
        from workbench.kinematics.chain import Joint, SerialChain
        from workbench.kinematics.chain_kernel import chain_kernel

        chain_kernel()
        joints = [joint for C in problem.links for joint in (Joint.fixed(C), Joint.revolute([0, 0, 1]))]
        chain = SerialChain(joints)
        self.single_out = np.empty((problem.order + 1, 6))
        self.single = chain.bind(np.moveaxis(problem.q, -1, 0), np.moveaxis(self.single_out, -2, 0))
        states, terms = len(problem.batch), problem.order + 1
        documented = np.moveaxis(problem.batch, -1, 0)
        self.batches, self.outs = {}, {}
        for name, axes in LAYOUTS.items():
            to, back = ["osc".index(axis) for axis in axes], [axes.index(axis) for axis in "osc"]
            q = documented.transpose(to).copy().transpose(back)
            of_result = "soc" if name == "first" else axes
            shape = [{"o": terms, "s": states, "c": 6}[axis] for axis in of_result]
            self.outs[name] = np.empty(shape).transpose([of_result.index(axis) for axis in "osc"])
            self.batches[name] = chain.bind(q, self.outs[name])

    def run_single(self):
        self.single()
        return self.single_out

    def results(self):
        for run in self.batches.values():
            run()
        for out in self.outs.values():
            np.testing.assert_allclose(out, self.outs["first"], rtol=1e-12, atol=1e-12)
        return self.run_single(), np.moveaxis(self.outs["first"], 0, 1).copy()
