"""Motions of longer chains in doubles: the plant is the root of each, and each derivative is as good as it says."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from workbench.drake.bindings import alternatives, bound
from workbench.drake.bound_jets import bound_jet
from workbench.drake.general_paths import small_axes, small_path
from workbench.drake.motions import chain_motion, reference_motions
from workbench.drake.plants import PlantError
from workbench.drake.roots import MotionError, disagreements, require_agreement
from workbench.drake.sampled_motions import sampled_motions, six_revolute_motion, urdf_motion
from workbench.drake.special_motions import NAMES, special_motion

THREE, ARM = sampled_motions()
CHAIN = reference_motions()[0]


@pytest.mark.parametrize(
    "motion", (*reference_motions(), *map(special_motion, NAMES), THREE, ARM), ids=lambda motion: motion.name
)
def test_the_plant_is_the_root_of_every_motion(motion):
    require_agreement(motion)
    terms = {what for what, _, _ in disagreements(motion)}
    assert {"velocity", "acceleration", "acceleration by Jacobian and bias"} <= terms
    if motion.plant.IsVelocityEqualToQDot():
        assert "jerk by AutoDiffXd" in terms


@dataclass(frozen=True)
class Planted:
    """A motion with one quantity changed."""

    motion: object
    name: str
    factor: np.ndarray | float

    def __getattr__(self, attribute):
        return getattr(self.motion, attribute)

    def jet(self, binding, order, sample):
        jet = self.motion.jet(binding, order, sample)
        return jet * self.factor if binding == self.name else jet


@pytest.mark.parametrize("name", ["w_WB", "v_WBo", "p_WBo", "R_WB"])
@pytest.mark.parametrize("motion", [CHAIN, ARM], ids=lambda motion: motion.name)
def test_a_sign_in_a_motion_is_caught(motion, name):
    with pytest.raises(MotionError, match="differs from the plant's by"):
        require_agreement(Planted(motion, name, -1.0))


def test_a_swapped_frame_in_a_motion_is_caught():
    @dataclass(frozen=True)
    class Swapped(Planted):
        def jet(self, binding, order, sample):
            return self.motion.jet("w_WB_B" if binding == "w_WB" else binding, order, sample)

    with pytest.raises(MotionError):
        require_agreement(Swapped(ARM, "", 1.0))


def test_sampled_derivatives_agree_with_symbolic_within_errors():
    """The same two cylindrical joints, once as Expressions and once on nodes."""
    from workbench.drake.plants import cylindrical_chain
    from workbench.drake.sampled_motions import SampledMotion, _with_intermediate

    axes, path = small_axes(3), small_path(11, joints=4)
    symbolic = chain_motion("symbolic", axes, path)
    sampled = SampledMotion("sampled", cylindrical_chain(axes, ("A", "B")), path, _with_intermediate)
    for name in ("R_WB", "p_WP", "w_WB", "v_WB0", "dual_w_AB_W"):
        for time in sampled.samples:
            difference = np.abs(sampled.jet(name, 4, time) - symbolic.jet(name, 4, time))
            errors = sampled.errors(name, 4, time) + symbolic.errors(name, 4, time)
            assert np.all(difference.reshape(5, -1).max(axis=1) <= errors), (name, time)


@pytest.mark.parametrize("name", ["w_WB", "v_WB0", "p_WP"])
def test_errors_grow_with_the_order_and_with_bad_windows(name):
    """A window that is too narrow or too wide loses digits; the estimate knows."""
    good, narrow, wide = (
        six_revolute_motion(9, samples=(0.5,), turns=turns)
        for turns in ((4.0, 6.0, 9.0), (0.05, 0.06, 0.07), (40.0, 50.0, 60.0))
    )
    best = good.jet(name, 4, 0.5)
    errors = good.errors(name, 4, 0.5)
    assert np.all(np.diff(np.log10(errors)) > 0.5)
    for bad in (narrow, wide):
        difference = np.abs(bad.jet(name, 4, 0.5) - best).reshape(5, -1).max(axis=1)
        assert np.all(difference <= bad.errors(name, 4, 0.5) + errors)
        assert difference[4] > errors[4] and bad.errors(name, 4, 0.5)[4] > 30 * errors[4]


def test_members_of_families_are_what_their_meaning_says():
    time = ARM.samples[0]
    R, p, w, v = (ARM.jet(name, 4, time) for name in ("R_WB", "p_WBo", "w_WB", "v_WB0"))
    for n in range(1, 4):
        Phi = bound_jet(ARM, bound("Phi_WB[n]"), n, 1, time)
        np.testing.assert_allclose(Phi.values[0], R[n] @ R[0].T, atol=1e-12)
        np.testing.assert_allclose(Phi.values[1], R[n + 1] @ R[0].T + R[n] @ R[1].T, atol=1e-9)
        a = bound_jet(ARM, bound("a_WB0[n]"), n, 0, time).values[0]
        np.testing.assert_allclose(a, p[n] - R[n] @ R[0].T @ p[0], atol=1e-12)
        p_WP = ARM.jet("p_WP", 4, time)
        A = bound_jet(ARM, bound("A_WP[n]"), n, 0, time).values[0]
        np.testing.assert_allclose(A, v[n] + np.cross(w[n], p_WP[0]), atol=1e-9)
    rate = bound_jet(ARM, bound("p_WP^(n+1)"), 1, 1, time).values
    np.testing.assert_array_equal(rate, ARM.jet("p_WP", 3, time)[2:])
    origin = bound_jet(ARM, bound("p_W0"), 0, 2, time).values
    np.testing.assert_allclose(origin[:2], [np.zeros(3), v[0]], atol=1e-12)


def test_a_body_of_a_urdf_is_a_motion():
    motion = urdf_motion(Path(__file__).parent / "two_arms.urdf", "hand")
    require_agreement(motion)
    assert motion.name == "hand of two_arms.urdf"
    with pytest.raises(PlantError, match="no body 'elbow'"):
        urdf_motion(Path(__file__).parent / "two_arms.urdf", "elbow")


@pytest.mark.parametrize("text", ["w_BW", "Phi_WB", "p_WP^(x+y)", "w_WB[n]", "p_WP^()", "", "p_WP^(1.5)"])
def test_unknown_bindings_are_rejected(text):
    with pytest.raises(ValueError, match=r"unknown quantity|expected a number"):
        bound(text)


def test_alternatives_and_orders():
    assert [b.text for b in alternatives("p_WP or p_W0")] == ["p_WP", "p_W0"]
    assert bound("Phi_WB[n]").order(3) == 3 and bound("p_WP^(n+1)").order(2) == 3
    assert bound("A_WP[2]^(1)").order(0) == 3
    assert bound("Phi_WB[n]").weight == (1, 0) and bound("p_WP^(n+1)").weight == (1, 1)
    assert replace(bound("w_WB"), text="x").needs == ("w_WB",)
