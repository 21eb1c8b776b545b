"""The tools that the serial-chain engine is measured against, each doing the same job its best way.

A peer gets its input in its own layout before the clock starts, and so does the workbench when it is
compared with that peer: `chain_problem.LAYOUTS` says which.
"""

import subprocess
import tempfile
from pathlib import Path

import numpy as np
from chain_problem import Peer, from_taylor, to_taylor, twist, twist_series


class HeyokaTaylor(Peer):
    """The Taylor coefficients of an integrator's step: q⁽ᵏ⁾ are states, and y with y' = V is."""

    layout = "last"

    def __init__(self, problem):
        import heyoka as hy

        m, n = problem.joints, problem.order
        q = [[hy.make_vars(f"q_{i}_{k}") for k in range(n + 2)] for i in range(m)]
        y = hy.make_vars(*[f"y_{c}" for c in range(6)])
        V = twist(problem.links, [x[0] for x in q], [x[1] for x in q], hy.sin, hy.cos)
        zero = hy.expression(0.0)
        system = [(x[k], x[k + 1] if k <= n else zero) for x in q for k in range(n + 2)]
        system += list(zip(y, V, strict=True))
        options = {"tol": float(np.exp(-2 * n + 0.01)), "compact_mode": m * n > 40}
        self.width = hy.recommended_simd_size()
        size = len(system)
        self.one = hy.taylor_adaptive(system, np.zeros(size), **options)
        self.many = hy.taylor_adaptive_batch(system, np.zeros((size, self.width)), **options)
        self.terms = n + 1
        self.state = np.concatenate([problem.q.ravel(), np.zeros(6)])
        states = len(problem.batch)
        flat = np.zeros((-(-states // self.width) * self.width, size))
        flat[:states, :-6] = problem.batch.reshape(states, -1)
        self.blocks = np.ascontiguousarray(flat.reshape(-1, self.width, size).transpose(0, 2, 1))
        self.states = states
        self.out = np.empty((len(self.blocks), 6, self.terms, self.width))

    def run_single(self):
        self.one.time = 0.0
        self.one.state[:] = self.state
        self.one.step(write_tc=True)
        return self.one.tc[-6:, 1 : self.terms + 1]

    def run_batch(self):
        for block, out in zip(self.blocks, self.out, strict=True):
            self.many.set_time(0.0)
            self.many.state[:] = block
            self.many.step(write_tc=True)
            out[:] = self.many.tc[-6:, 1 : self.terms + 1]

    def results(self):
        ascending = np.arange(1, self.terms + 1)[:, None]
        single = self.run_single().T * ascending
        self.run_batch()
        batch = self.out.transpose(0, 3, 2, 1).reshape(-1, self.terms, 6)[: self.states]
        return from_taylor(single), from_taylor(batch * ascending)


class HeyokaFunction(Peer):
    """Taylor arithmetic written out by hand, compiled by heyoka, SIMD over the batch."""

    layout = "last"

    def __init__(self, problem):
        import heyoka as hy

        hy.set_nthreads(1)  # as the workbench: a call per core is compared, not a number of cores
        m, n = problem.joints, problem.order
        names = [[f"q_{i:03d}_{k:03d}" for k in range(n + 2)] for i in range(m)]
        q = [[hy.make_vars(name) for name in row] for row in names]
        V = twist_series(problem.links, q, hy.sin, hy.cos)
        self.function = hy.cfunc(
            [x if isinstance(x, hy.expression) else hy.expression(x) for row in V for x in row],
            vars=[x for row in q for x in row],
            compact_mode=m * n > 40,
        )
        self.q = to_taylor(problem.q).ravel()
        batch = to_taylor(problem.batch)
        self.batch = np.ascontiguousarray(batch.reshape(len(batch), -1).T)
        self.terms = n + 1
        self.out = np.empty(6 * self.terms)
        self.batch_out = np.empty((6 * self.terms, len(batch)))

    def run_single(self):
        self.function(self.q, outputs=self.out)

    def run_batch(self):
        self.function(self.batch, outputs=self.batch_out)

    def results(self):
        self.run_single()
        self.run_batch()
        batch = self.batch_out.T.reshape(-1, self.terms, 6)
        return from_taylor(self.out.reshape(self.terms, 6)), from_taylor(batch)


class HeyokaFunctionOnArrays(HeyokaFunction):
    """The same from the documented arrays to the documented arrays: it needs two copies."""

    layout = "arrays"

    def __init__(self, problem):
        super().__init__(problem)
        self.arrays_in = np.moveaxis(to_taylor(problem.batch), -1, 0).copy()
        self.arrays_out = np.empty((self.terms, len(problem.batch), 6))

    def run_batch(self):
        order, states, joints = self.arrays_in.shape
        self.batch.reshape(joints, order, states)[...] = self.arrays_in.transpose(2, 0, 1)
        super().run_batch()
        self.arrays_out[...] = self.batch_out.reshape(self.terms, 6, states).swapaxes(1, 2)


class JaxJet(Peer):
    def __init__(self, problem):
        import jax

        jax.config.update("jax_enable_x64", True)
        import jax.numpy as jnp
        from jax.experimental.jet import jet

        n = problem.order

        def V(q, rate):
            return jnp.stack(twist(problem.links, q, rate, jnp.sin, jnp.cos))

        def derivatives(q):
            if n == 0:
                return V(q[:, 0], q[:, 1])[None]
            series = [[q[:, k + 1] for k in range(n)], [q[:, k + 2] for k in range(n)]]
            first, rest = jet(V, (q[:, 0], q[:, 1]), series)
            return jnp.stack([first, *rest])

        self.q, self.batch = jnp.asarray(problem.q), jnp.asarray(problem.batch)
        self.single = jax.jit(derivatives).lower(self.q).compile()
        self.many = jax.jit(jax.vmap(derivatives)).lower(self.batch).compile()

    def run_single(self):
        return self.single(self.q).block_until_ready()

    def run_batch(self):
        return self.many(self.batch).block_until_ready()

    def results(self):
        return np.asarray(self.run_single()), np.asarray(self.run_batch())


class CasadiTaylor(Peer):
    """Taylor arithmetic written out by hand, run by CasADi's virtual machine."""

    def __init__(self, problem):
        import casadi as ca

        m, n = problem.joints, problem.order
        q = ca.SX.sym("q", n + 2, m)
        rows = [[q[k, i] for k in range(n + 2)] for i in range(m)]
        V = twist_series(problem.links, rows, ca.sin, ca.cos)
        self._set_up(problem, ca.Function("twist", [q], [ca.vcat([x for r in V for x in r])]))

    def _set_up(self, problem, function):
        self.terms, states = problem.order + 1, len(problem.batch)
        self.q = self._layout(problem.q).copy()
        self.batch = self._layout(problem.batch).copy()
        self.out, self.batch_out = np.empty(6 * self.terms), np.empty((states, 6 * self.terms))
        self.single = self._call(function, self.q, self.out)
        self.many = self._call(function.map(states), self.batch, self.batch_out)

    def _layout(self, q):
        return to_taylor(q)

    def _result(self, V):
        return from_taylor(V.reshape(*V.shape[:-1], self.terms, 6))

    @staticmethod
    def _call(function, q, out):
        memory, call = function.buffer()
        memory.set_arg(0, memoryview(q.ravel()))
        memory.set_res(0, memoryview(out.reshape(-1)))
        call.memory = memory  # keeps the buffers alive
        return call

    def run_single(self):
        self.single()

    def run_batch(self):
        self.many()

    def results(self):
        self.run_single()
        self.run_batch()
        return self._result(self.out), self._result(self.batch_out)


class CasadiGeneratedC(CasadiTaylor):
    """The same as generated C. Needs a C compiler."""

    def _set_up(self, problem, function):
        import casadi as ca

        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        generator = ca.CodeGenerator("twist.c")
        generator.add(function)
        generator.generate(f"{folder}/")
        subprocess.run(
            ["cc", "-O3", "-march=native", "-shared", "-fPIC", "twist.c", "-o", "twist.so"],
            cwd=folder,
            check=True,
        )
        super()._set_up(problem, ca.external("twist", f"{folder}/twist.so"))


class CasadiJtimes(CasadiTaylor):
    """CasADi's own differentiation: directional derivatives along the motion, n times."""

    def __init__(self, problem):
        import casadi as ca

        m, n = problem.joints, problem.order
        q = ca.SX.sym("q", n + 2, m)
        rows = [[q[k, i] for k in range(n + 2)] for i in range(m)]
        V = [ca.vcat(twist(problem.links, [r[0] for r in rows], [r[1] for r in rows], ca.sin, ca.cos))]
        motion = ca.vertcat(q[1:, :], ca.SX.zeros(1, m))
        for _ in range(n):
            V.append(ca.jtimes(V[-1], ca.vec(q), ca.vec(motion)))
        self._set_up(problem, ca.Function("twist", [q], [ca.vcat(V)]))

    def _layout(self, q):
        return q

    def _result(self, V):
        return V.reshape(*V.shape[:-1], self.terms, 6)


class SymEngineLlvm(Peer):
    """Symbolic total derivatives, compiled by SymEngine's LLVM back end."""

    def __init__(self, problem):
        import symengine as se

        m, n = problem.joints, problem.order
        q = [[se.Symbol(f"q_{i}_{k}") for k in range(n + 2)] for i in range(m)]
        V = [twist(problem.links, [x[0] for x in q], [x[1] for x in q], se.sin, se.cos)]
        moving = [(x[k], x[k + 1]) for x in q for k in range(n + 1)]
        for _ in range(n):
            V.append([sum(se.diff(c, x) * rate for x, rate in moving) for c in V[-1]])
        symbols = [x for row in q for x in row]
        self.function = se.Lambdify(symbols, [c for row in V for c in row], backend="llvm", cse=True)
        self.problem, self.terms = problem, n + 1
        self.flat = problem.q.ravel()
        self.batch = problem.batch.reshape(len(problem.batch), -1)

    def run_single(self):
        return self.function(self.flat)

    def run_batch(self):
        return self.function(self.batch)

    def results(self):
        shape = (self.terms, 6)
        return self.run_single().reshape(shape), self.run_batch().reshape(-1, *shape)


class DrakeExpression(Peer):
    """Drake's symbolic Expression: total derivatives, evaluated entry by entry."""

    def __init__(self, problem):
        from pydrake.symbolic import Expression, Variable, cos, sin

        m, n = problem.joints, problem.order
        self.q = [[Variable(f"q_{i}_{k}") for k in range(n + 2)] for i in range(m)]
        x = [[Expression(v) for v in row] for row in self.q]
        V = [twist(problem.links, [r[0] for r in x], [r[1] for r in x], sin, cos)]
        moving = [(r[k], r[k + 1]) for r in self.q for k in range(n + 1)]
        for _ in range(n):
            V.append([sum(c.Differentiate(v) * rate for v, rate in moving) for c in V[-1]])
        self.V, self.problem = V, problem

    def _evaluate(self, q):
        values = {
            v: value
            for row, numbers in zip(self.q, q, strict=True)
            for v, value in zip(row, numbers, strict=True)
        }
        return np.array([[c.Evaluate(values) for c in row] for row in self.V])

    def run_single(self):
        return self._evaluate(self.problem.q)

    def run_batch(self):
        return np.array([self._evaluate(q) for q in self.problem.batch])

    def results(self):
        return self.run_single(), self.run_batch()


class Pinocchio(Peer):
    """forwardKinematics and the two vectors read out in the world frame; order ≤ 1."""

    def __init__(self, problem):
        import pinocchio as pin

        if problem.order > 1:
            raise NotImplementedError("no derivative of the twist beyond the first")
        self.pin, self.problem = pin, problem
        self.model, parent = pin.Model(), 0
        for i, C in enumerate(problem.links):
            placement = pin.SE3(np.ascontiguousarray(C[:3, :3]), C[:3, 3].copy())
            parent = self.model.addJoint(parent, pin.JointModelRZ(), placement, f"joint {i}")
        self.data, self.tip = self.model.createData(), parent
        self.q = [np.ascontiguousarray(x) for x in problem.q.T]
        self.batch = [[np.ascontiguousarray(x) for x in q.T] for q in problem.batch]

    def _evaluate(self, q):
        pin, world = self.pin, self.pin.ReferenceFrame.WORLD
        pin.forwardKinematics(self.model, self.data, *q)
        V = [pin.getVelocity(self.model, self.data, self.tip, world).vector]
        if len(q) > 2:
            V.append(pin.getAcceleration(self.model, self.data, self.tip, world).vector)
        return V

    def run_single(self):
        return self._evaluate(self.q)

    def run_batch(self):
        return [self._evaluate(q) for q in self.batch]

    def results(self):
        single, batch = np.array(self.run_single()), np.array(self.run_batch())
        return np.roll(single, 3, axis=-1), np.roll(batch, 3, axis=-1)


PEERS = {
    "heyoka Taylor": HeyokaTaylor,
    "heyoka by hand": HeyokaFunction,
    "heyoka on arrays": HeyokaFunctionOnArrays,
    "JAX jet": JaxJet,
    "CasADi by hand": CasadiTaylor,
    "CasADi C by hand": CasadiGeneratedC,
    "CasADi jtimes": CasadiJtimes,
    "SymEngine": SymEngineLlvm,
    "Drake Expression": DrakeExpression,
    "Pinocchio": Pinocchio,
}
NEEDS_C_COMPILER = {"CasADi C by hand"}
