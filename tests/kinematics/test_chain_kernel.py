"""The two implementations of serial chains, NumPy and the compiled kernel: of any size, memory and processor."""

import gc
import os
import subprocess
import sys
from itertools import permutations
from math import factorial

import llvmlite.binding as llvm
import numpy as np
import pytest
from random_chains import close, random_joint, random_joints

from workbench.kinematics import chain_engine
from workbench.kinematics.chain import Joint, SerialChain

BOTH = pytest.mark.usefixtures("implementation")


@pytest.mark.parametrize("states", [1, 7, 8, 9, 33])
@pytest.mark.parametrize("count", [1, 2, 5])
def test_the_kernel_equals_numpy_for_every_size_of_state_and_block(states, count):
    chain_engine.load_kernel()
    rng = np.random.default_rng(states)
    for n in range(12):
        chain = SerialChain(random_joints(rng, count))
        q = rng.normal(size=(n + 2, states, chain.dof))
        V = chain.twist_derivatives(q)
        for found, plain in zip(V, chain._of_derivatives._in_numpy(q), strict=True):
            close(found, plain, 13)


@BOTH
@pytest.mark.parametrize("states", [2, 8, 9, 21, 70])
@pytest.mark.parametrize("joints", [1, 2, 5])
def test_arrays_may_lie_in_memory_in_any_way(states, joints):
    """The axes in any order, with gaps or backwards, on either side; what is not the result is not touched."""
    rng = np.random.default_rng(states)
    chain = SerialChain(
        [
            random_joint(rng, kind)
            for kind in ("cylindrical", "revolute", "helical", "prismatic", "revolute")[:joints]
        ]
    )
    for n in (0, 1, 2, 3, 6):
        q = rng.normal(size=(n + 2, states, chain.dof))
        expected = chain.twist_derivatives(q)
        for axes in permutations(range(3)):
            back = np.argsort(axes)
            ours = q.transpose(axes).copy().transpose(back)
            close(chain.twist_derivatives(ours), expected, 13)
            for step in (1, 2, -1):
                whole = np.full([abs(step) * size for size in np.array(expected.shape)[list(axes)]], 0.5)
                out = whole[::step, ::step, ::step].transpose(back)
                assert chain.twist_derivatives(ours, out) is out
                close(out, expected, 13)
                assert (whole == 0.5).sum() == whole.size - out.size


@BOTH
def test_any_array_of_numbers_will_do():
    rng = np.random.default_rng(6)
    chain = SerialChain(random_joints(rng, 3))
    q = rng.integers(-3, 4, size=(5, 4, chain.dof))
    V = chain.twist_derivatives(q.astype(float))
    read_only = q.astype(float)
    read_only.flags.writeable = False
    for same in (q, q.tolist(), q.astype(np.float32), read_only, np.asfortranarray(q * 1.0)):
        np.testing.assert_array_equal(chain.twist_derivatives(same), V)
    for state, expected in zip(read_only.swapaxes(0, 1), V.swapaxes(0, 1), strict=True):
        close(chain.twist_derivatives(state), expected, 13)
        close(chain.twist_derivatives(state.tolist()), expected, 13)
        other_end_first = state.astype(
            state.dtype.newbyteorder()
        )  # after a state of that shape in plain doubles
        for same in (other_end_first, state.astype(np.float32), state.astype(int), state[:, ::-1][:, ::-1]):
            close(chain.twist_derivatives(same), expected, 13)
    every_other = np.repeat(q * 1.0, 2, axis=1)[:, ::2]
    np.testing.assert_array_equal(chain.twist_derivatives(every_other), V)
    out = np.empty_like(V)
    assert chain.twist_derivatives(q, out) is out
    np.testing.assert_array_equal(out, V)
    first = np.empty_like(V[:, 0])
    assert chain.twist_derivatives(q[:, 0] * 1.0, first) is first
    close(first, V[:, 0], 13)


def test_a_bound_call_follows_what_is_in_its_arrays():
    rng = np.random.default_rng(8)
    chain = SerialChain(random_joints(rng, 3))
    for states in ((), (11,)):
        q, out = chain.workspace(4, states)
        update = chain.bind(q, out)
        for _ in range(3):
            q[...] = rng.normal(size=q.shape)
            assert update()
            close(out, chain.twist_derivatives(q), 13)
    q[0] = 1e17
    if any(joint.kind != "prismatic" for joint in chain.joints[:-1]):
        assert not update()
    with pytest.raises(ValueError, match="q: expected an array of doubles"):
        chain.bind(q.tolist(), out)
    apart = np.zeros((6, 3, 4, chain.dof)).transpose(0, 2, 1, 3)  # states whose axes are not one in memory
    with pytest.raises(ValueError, match="axes of states are one in memory"):
        chain.bind(apart, np.zeros((5, 4, 3, 6)))
    with pytest.raises(ValueError, match="out: expected a writable array"):
        chain.bind(q, out[:4])


def test_a_bound_call_outlives_its_chain():
    joints = random_joints(np.random.default_rng(9), 3)
    chain = SerialChain(joints)
    q, out = chain.workspace(38)
    q[...] = 1
    expected = chain.twist_taylor(q / [[1.0 * factorial(k)] for k in range(40)])
    plans = chain._of_derivatives._plans
    update = chain.bind(q, out)
    (plan,) = [entry for shape, entry in plans.items() if shape == q.shape]
    del chain, plans
    assert any(held is plan for held in gc.get_referents(vars(update)))
    assert update()
    close(out, expected * [[1.0 * factorial(k)] for k in range(39)], 11)


@BOTH
@pytest.mark.parametrize("states", [(), (10,)])
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_what_is_not_finite_is_refused_at_every_order(states, bad):
    chain = SerialChain(random_joints(np.random.default_rng(7), 3))
    for k in range(4):
        q = np.ones((4, *states, chain.dof))
        chain.twist_derivatives(q)
        q[k, ..., 0] = bad
        with pytest.raises(ValueError, match="finite"):
            chain.twist_derivatives(q)


def test_small_tasks_are_done_without_numba():
    program = """
import sys
import numpy as np
from workbench.kinematics.chain import Joint, SerialChain
chain = SerialChain([Joint.revolute([0, 0, 1]), Joint.revolute([1, 0, 0])])
chain.twist_derivatives(np.ones((6, 2)))
chain.twist_derivatives(np.ones((3, 32, 2)))
assert "numba" not in sys.modules and "pydrake" not in sys.modules
chain.twist_derivatives(np.ones((7, 2)))
assert "numba" in sys.modules
"""
    subprocess.run([sys.executable, "-c", program], check=True)


@pytest.mark.slow  # compiles a kernel for each processor
@pytest.mark.parametrize(
    "features, width",
    [("", 2), ("+avx,+avx2,+fma", 4), ("+avx,+avx2,+fma,+avx512vl", 4), ("+avx,+avx512f", 8)],
)
def test_the_kernel_is_the_same_for_registers_of_any_size(features, width, tmp_path):
    """LLVM splits registers that this machine does not have, so each runs where the instructions are."""
    there = {feature for feature, has in llvm.get_host_cpu_features().items() if has}
    if not {f[1:] for f in features.split(",") if f} <= there:
        pytest.skip("not on this processor")
    program = f"""
import numpy as np
from workbench.kinematics import chain_engine, lanes
from workbench.kinematics.chain import Joint, SerialChain
assert lanes.WIDTH == {width}
rng = np.random.default_rng(1)
for dof in (1, 2, 7):
    joints = [Joint.helical(rng.normal(size=3), point=rng.normal(size=3), pitch=0.1) for _ in range(dof)]
    for order in (0, 1, 2, 4, 7, 10):
        for states in (1, 3, 8, 17):
            q = rng.normal(size=(order + 2, states, dof))
            chain_engine._twist_kernel = None
            engine = chain_engine.Engine(SerialChain(joints)._of_derivatives.links, taylor=False)
            expected = engine._in_numpy(q)
            chain_engine.load_kernel()
            found = SerialChain(joints).twist_derivatives(q)
            side_by_side = np.moveaxis(np.moveaxis(q, 1, -1).copy(), -1, 1)
            for found in (found, SerialChain(joints).twist_derivatives(side_by_side)):
                assert np.abs(found - expected).max() <= 1e-12 * np.abs(expected).max(), (dof, order, states)
"""
    chosen = {"NUMBA_CPU_NAME": "x86-64", "NUMBA_CPU_FEATURES": features, "NUMBA_CACHE_DIR": str(tmp_path)}
    subprocess.run([sys.executable, "-c", program], check=True, env=os.environ | chosen)


def test_many_small_tasks_load_the_kernel(monkeypatch):
    monkeypatch.setattr(chain_engine, "_twist_kernel", None)
    monkeypatch.setattr(chain_engine, "PLAIN_TASKS", 2)
    chain = SerialChain([Joint.revolute([0, 0, 1])])
    for expected in (True, True, False):
        chain.twist_derivatives(np.ones((4, 1)))
        assert (chain_engine._twist_kernel is None) == expected
