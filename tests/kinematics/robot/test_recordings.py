"""Derivatives of recordings whose truth is known: stated errors cover it, and most peaks are told."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded_motions import Exponentials, decays, moves, random_pieces, recordings, sines

from workbench.kinematics.robot import Mimic, Robot, TreeJoint
from workbench.kinematics.robot.joints import Limits
from workbench.kinematics.robot.recording.recorded_peaks import (
    recorded_bound,
    recorded_deceleration,
    recorded_peak,
)
from workbench.kinematics.robot.recording.recordings import record
from workbench.kinematics.robot.trajectories.paths import JointPath, RecordedPath

COVERED, TOLD = 0.97, 0.85
LARGEST_FEW = 3000  # samples of a recording in the default run


def peak_on(motion, recording, order, span, offset):
    """The true peak on the span, gaps left out."""
    ends = [span[0], span[1]]
    for gap in recording.gaps:
        hole = recording.times[gap - 1], recording.times[gap]
        if span[0] < hole[0] and hole[1] < span[1]:
            ends[-1:-1] = hole
    pieces = zip(ends[::2], ends[1::2], strict=True)
    return max(motion.peak(order, a - offset, b - offset) for a, b in pieces)


def judged(sampled):
    """Of each order: whether the peak is finite, told, covered; and whether a lower bound is wrong."""
    q = np.unwrap(sampled.q) if sampled.wraps else sampled.q
    recording, counts = record(sampled.t, q), Counter()
    for order in range(1, 5):
        peak = recorded_peak(recording, order)
        true = peak_on(sampled.motion, recording, order, peak.span, sampled.offset)
        whole = peak_on(sampled.motion, recording, order, (q := recording.times)[[0, -1]], sampled.offset)
        told = np.isfinite(peak.error)
        counts["finite"] += np.isfinite(true)
        counts["told"] += told
        counts["covered"] += bool(told and abs(peak.value - true) <= peak.error + 1e-9 * true)
        counts["finite and told"] += bool(told and np.isfinite(true))
        counts["bounded"] += np.isfinite(peak.at_most)
        counts["bounded rightly"] += bool(np.isfinite(peak.at_most) and whole <= peak.at_most * (1 + 1e-9))
        counts["at least rightly"] += bool(peak.at_least <= whole * (1 + 1e-9))
        counts["peaks"] += 1
    return counts


def assert_covered_and_told(counts):
    assert counts["covered"] >= COVERED * counts["told"], counts
    assert counts["finite and told"] >= TOLD * counts["finite"], counts
    assert counts["bounded rightly"] >= COVERED * counts["bounded"], counts
    assert counts["at least rightly"] >= COVERED * counts["peaks"], counts


def test_peaks_of_a_few_recordings_are_within_their_errors():
    few = [one for i, one in enumerate(recordings(1, (100,), few=True)) if i % 9 == 0]
    counts = sum((judged(one) for one in few if len(one.t) <= LARGEST_FEW), Counter())
    assert counts["peaks"] >= 60
    assert_covered_and_told(counts)


@pytest.mark.slow
def test_peaks_of_random_recordings_are_within_their_errors():
    seed = int(np.random.SeedSequence().entropy % 2**32)
    counts = sum((judged(one) for one in recordings(seed, (100, 1000), few=True)), Counter())
    print(f"seed {seed}: {counts}")
    assert_covered_and_told(counts)


@pytest.mark.slow
def test_a_million_samples_take_seconds():
    import time

    t = np.arange(1_000_000) / 1000
    q = np.sin(3 * t) + 1e-6 * np.random.default_rng(0).normal(size=len(t))
    record(t[:1000], q[:1000])  # compiles
    start = time.process_time()
    record(t, q)
    assert time.process_time() - start < 40


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1))
def test_a_scaled_or_later_recording_has_scaled_peaks(seed):
    """q → 2 q, t → 4 t + 2ⁿ: the k-th derivative is 2/4ᵏ as large; powers of two are exact."""
    rng = np.random.default_rng(seed)
    motion = [sines(rng, 2, 0.5, 2), decays(rng), moves(rng, 2, 7, 0.3)][seed % 3]
    t = np.arange(300) / 128
    q = motion.at(t, 0)
    one, other = record(t, q), record(4 * t + 1024, 2 * q)
    for order in range(1, 4):
        a, b = recorded_peak(one, order), recorded_peak(other, order)
        if np.isfinite(a.error) and np.isfinite(b.error):
            scale = 2 / 4**order
            assert abs(a.value * scale - b.value) <= a.error * scale + b.error


def test_estimates_between_samples_are_covered():
    motion = Exponentials(np.array([0.5, 0.2j]), np.array([5j, 3j - 0.1]))
    t = np.arange(500) / 100
    recording = record(t, motion.at(t, 0) + 1e-6 * np.random.default_rng(0).normal(size=500))
    at = np.random.default_rng(1).uniform(0.2, 4.7, 200)
    values, errors = recording.between(at, 4)
    for k in range(5):
        assert (np.abs(values[k] - motion.at(at, k)) <= errors[k]).mean() > 0.98, k
        assert np.median(errors[k]) < 0.05 * np.abs(motion.at(at, k)).max(), k


def test_a_jump_of_any_order_is_never_within():
    """Of pieces of a constant derivative m the derivative m + 1 has no bound, and none is stated."""
    for order in (1, 2, 3):
        motion = random_pieces(np.random.default_rng(order), 6, order, 3)
        t = np.arange(0, motion.breaks[-1], 0.002)
        robot = Robot("r", [TreeJoint("j", "revolute", "world", "a")])
        moving = robot.along((t, motion.at(t, 0)[:, None]), order=4)
        names = ("", "velocity", "acceleration", "jerk", "snap")
        found = {p.order: p for p in moving.peaks(limits={"j": dict.fromkeys(names[order + 1 :], 1e9)})}
        for k in range(order + 1, 5):
            assert found[k].within is not True, (order, str(found[k]))
        assert f"{names[order]} jumps at" in str(found[order + 1]), str(found[order + 1])


@pytest.mark.parametrize("samples_a_period", [2.05, 2.2, 2.5, 2.9, 3.3, 4.1, 5.3, 7.7])
def test_motion_between_few_samples_is_never_within(samples_a_period):
    """q = sin 2πt/2: small windows leave it as noise below 4 samples a period; it is none."""
    rng = np.random.default_rng(int(10 * samples_a_period))
    for count in (60, 200, 1000):
        t = np.arange(count) / samples_a_period
        recording = record(t, 0.5 * np.sin(2 * np.pi * (t + rng.uniform())))
        for order in range(1, 5):
            true, peak = 0.5 * (2 * np.pi) ** order, recorded_peak(recording, order)
            assert peak.at_least <= true <= peak.at_most, (count, peak)


@pytest.mark.parametrize("size", [1e-3, 1e-4])
def test_a_fast_ripple_is_told_from_noise(size):
    """A vibration of 45 Hz at 100 samples a second, under slow motion and noise of its own size."""
    t, rng = np.arange(2000) / 100, np.random.default_rng(1)
    slow, noise = 0.5 * np.sin(2 * t), 1e-4 * rng.normal(size=len(t))
    quiet, shaken = record(t, slow + noise), record(t, slow + noise + size * np.sin(2 * np.pi * 45 * t))
    assert not quiet.is_undersampled and shaken.is_undersampled
    assert recorded_peak(quiet, 1).error < 0.03
    assert recorded_peak(shaken, 1).at_most > 1 + 0.9 * size * 2 * np.pi * 45
    robot = Robot("r", [TreeJoint("j", "revolute", "world", "a")])
    notes = robot.path((t, (slow + noise + size * np.sin(2 * np.pi * 45 * t))[:, None])).notes
    assert (
        notes[0].startswith("joint 'j': what counts as noise") and "faster than the samples show" in notes[0]
    )


@pytest.mark.parametrize("seed", range(3))
def test_noise_counts_as_noise(seed):
    """Of a resting joint, the bound on the velocity stays."""
    rng = np.random.default_rng(seed)
    recording = record(np.arange(3000) / 100, 1e-4 * rng.normal(size=3000))
    assert not recording.is_undersampled
    assert recorded_peak(recording, 1).at_most < 1e-3


def test_orders_beyond_the_snap_and_times_outside_are_refused():
    t = np.arange(100) / 50
    path = RecordedPath(t, np.sin(t)[:, None])
    with pytest.raises(ValueError, match=r"order: expected at most 4 \(snap\), all that samples tell, got 5"):
        path.derivatives(1.0, 5)
    with pytest.raises(ValueError, match=r"expected times from 0 to 1\.98 s, got 3"):
        path.derivatives(3.0, 1)
    with pytest.raises(ValueError, match="order: expected at most 4"):
        recorded_peak(path.recordings[0], 5)
    late = RecordedPath(t + 1.7e9, np.sin(t)[:, None])
    with pytest.raises(ValueError, match="expected times from 1700000000"):
        late.derivatives(1.7e9 - 0.01, 1)


def test_a_recording_keeps_a_copy_and_gives_none_away():
    t, q = np.arange(100) / 50, np.sin(np.arange(100) / 50)[:, None]
    path = RecordedPath(t, q)
    before = path.derivatives(t, 2)
    q += 1
    t[:] = 0
    np.testing.assert_array_equal(path.derivatives(path.times, 2), before)
    with pytest.raises(ValueError, match="read-only"):
        path.recordings[0].estimates[0, 0] = 1


def test_a_gap_is_bridged_without_a_bound():
    t = np.concatenate([np.arange(100), np.arange(130, 230)]) / 100
    recording = record(t, np.sin(3 * t))
    values, errors = recording.between(np.array([0.5, 1.1, 1.8]), 2)
    assert np.isfinite(errors[:, [0, 2]]).all() and np.isinf(errors[:, 1]).all()
    np.testing.assert_allclose(values[0], np.sin(3 * np.array([0.5, 1.1, 1.8])), atol=1e-3)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_greatest_and_the_least_coordinate_are_covered(sign):
    t = np.arange(400) / 100
    recording = record(t, np.sin(3 * t) + 1e-4 * np.random.default_rng(0).normal(size=400))
    found = recorded_bound(recording, sign)
    assert abs(found.value - 1) <= found.error + 1e-4 and found.error < 1e-3


def extremes(motion, sign, a, b):
    """The largest sign · q on a … b."""
    t = np.linspace(a, b, 400_001)
    return float((sign * motion.at(t, 0)).max())


@settings(max_examples=40)
@given(st.integers(0, 2**32 - 1), st.sampled_from([1, -1]), st.integers(8, 60))
def test_limits_of_a_coordinate_count_between_samples(seed, sign, a_period):
    """Of sines, of moves and of kinks, the samples of which miss the extremes."""
    rng = np.random.default_rng(seed)
    motion = [
        lambda: sines(rng, 1 + seed % 3, 0.5, 1),
        lambda: moves(rng, 3, 5, 0.3),
        lambda: random_pieces(rng, 5, 1, 2),
    ][seed % 5 % 3]()
    end = motion.breaks[-1] if hasattr(motion, "breaks") else 5.0
    t = np.linspace(0, end, int(5 * a_period) + 1)
    true, found = extremes(motion, sign, 0, end), recorded_bound(record(t, motion.at(t, 0)), sign)
    assert not np.isfinite(found.error) or abs(found.value - true) <= found.error + 1e-8
    assert found.at_least <= true + 1e-8
    assert found.at_most >= true - 1e-8


@settings(max_examples=40)
@given(st.integers(0, 2**32 - 1), st.integers(20, 120))
def test_decelerations_count_between_samples(seed, a_period):
    """They end where the velocity is 0, which is between two samples."""
    rng = np.random.default_rng(seed)
    motion = sines(rng, 1 + seed % 2, 0.5, 1) if seed % 3 else moves(rng, 3, 7, 0.3)
    end = motion.breaks[-1] if hasattr(motion, "breaks") else 5.0
    t, near = np.linspace(0, end, int(5 * a_period) + 1), np.linspace(0, end, 400_001)
    found = recorded_deceleration(record(t, motion.at(t, 0)))
    inside = (near >= found.span[0]) & (near <= found.span[1])
    v, a = motion.at(near, 1), motion.at(near, 2)
    sizes = np.where(v * a < 0, np.abs(a), 0.0)
    true, slack = float(sizes[inside].max()), 1e-4 * np.abs(a).max()
    assert not np.isfinite(found.error) or abs(found.value - true) <= found.error + slack
    assert found.at_most >= sizes.max() - slack and found.at_least <= sizes.max() + slack


def test_limit_exceeded_between_samples_is_not_kept():
    t = np.arange(101) / 25
    robot = Robot("r", [TreeJoint("j", "revolute", "world", "a")])
    q = np.sin(3 * t)[:, None]
    limit = float((q.max() + 1) / 2)
    (found,) = (p for p in robot.along((t, q), order=1).peaks(limits={"j": {"upper": limit}}) if p.order == 0)
    assert found.verdict == "BEYOND" and abs(found.value - 1) < 1e-6


def test_a_joint_at_rest_is_within_its_limits():
    t = np.arange(1000) / 100
    q = 0.3 + 1e-6 * np.random.default_rng(0).normal(size=(1000, 2)) + np.outer(np.sin(t), [0, 1])
    robot = Robot("r", [TreeJoint(n, "revolute", p, n) for n, p in (("a", "world"), ("b", "a"))])
    limits = {"a": {"velocity": 1, "acceleration": 5, "jerk": 100, "upper": 0.4, "lower": 0.2}}
    found = [p for p in robot.along((t, q), order=3).peaks(limits=limits) if p.of == "a"]
    assert [p.verdict for p in found] == ["within"] * 5, list(map(str, found))
    assert "below its noise" in str(found[2])


@pytest.mark.parametrize("of", ["point", "rotation"])
def test_a_body_s_peaks_along_a_recording_are_covered(of):
    """The point and the rotation of two links against the same motion by formula."""
    robot = Robot("r", [TreeJoint("a", "revolute", "world", "a"), TreeJoint("b", "prismatic", "a", "b")])
    path = JointPath([[0.1, 0.2], [1.0, -0.5], [-0.4, 0.3], [0.2, 0.1], [-0.05, 0.02]])
    t = np.linspace(0, 3, 601)
    samples = path.derivatives(t, 0)[0] + 1e-5 * np.random.default_rng(0).normal(size=(601, 2))
    true, found = (
        {p.order: p for p in robot.along(given, t, 4).peaks("b", (0, 0.3, 0)) if p.of == of}
        for given in (path, (t, samples))
    )
    told = [n for n in true if np.isfinite(found[n].error) and found[n].span is None]
    assert told[:2] == [1, 2]
    for n in told:
        assert abs(found[n].value - true[n].value) <= found[n].error, (str(found[n]), str(true[n]))


def test_limits_of_followers_and_of_urdf_1_2_are_checked():
    nan = np.nan
    own = Limits(nan, nan, 1.0, 2.0, 1.5, 20.0)
    joints = [
        TreeJoint("a", "revolute", "world", "a", limits=own),
        TreeJoint("b", "revolute", "a", "b", limits=Limits(-1.0, 0.9, 3.0), mimic=Mimic("a", -2.0, 0.1)),
    ]
    robot = Robot("r", joints)
    path = JointPath([[0.0], [0.5], [-0.9]])  # rises to 0.069 and falls
    found = {(p.of, p.name, p.bound): p for p in robot.along(path, np.linspace(0, 0.5, 3), 3).peaks()}
    assert found["a", "acceleration", "upper"].within and found["a", "jerk", "upper"].within
    slowing = found["a", "deceleration", "deceleration"]
    assert slowing.value == pytest.approx(1.8) and slowing.within is False
    follower = found["b", "velocity", "upper"]
    assert (follower.value, follower.within) == (pytest.approx(1.0), True)
    assert found["b", "position", "upper"].value == pytest.approx(0.1 + 2 * 0.0 - 0, abs=0.2)
    limits = {"b": {"upper": 0.05, "jerk": 1}}
    found = {
        (p.of, p.name, p.bound): p for p in robot.along(path, np.linspace(0, 0.5, 3), 3).peaks(limits=limits)
    }
    assert found["b", "position", "upper"].within is False and found["b", "jerk", "upper"].within
    t = np.linspace(0, 0.5, 101)
    recorded = robot.along((t, path.derivatives(t, 0)[0]), order=3)
    again = {(p.of, p.name, p.bound): p for p in recorded.peaks(limits=limits)}
    for key in found:
        assert again[key].within in (found[key].within, None), (str(again[key]), str(found[key]))
    assert again["a", "deceleration", "deceleration"].within is False
    assert again["b", "position", "upper"].within is False


def test_a_path_s_own_csv_is_read_again(tmp_path):
    from workbench.kinematics.robot.trajectories.paths import read_samples

    robot = Robot("r", [TreeJoint("a", "revolute", "world", "a"), TreeJoint("b c", "prismatic", "a", "b")])
    motion = robot.along(JointPath([[0.1, 0.2], [1.0, -0.5], [0.3, 0.3]]), np.linspace(0, 1, 21), 6)
    motion.to_csv(tmp_path / "out.csv", "b", (0, 0, 0.1))
    t, q = read_samples(tmp_path / "out.csv", robot.positions)
    np.testing.assert_array_equal(t, motion.times)
    np.testing.assert_array_equal(q, motion.q)


def test_jumps_of_trajectories_without_told_breaks_are_found():
    from pydrake.trajectories import PiecewisePolynomial, StackedTrajectory

    hold = PiecewisePolynomial.FirstOrderHold([0.0, 0.3, 1.0], [[0.0, 1.0, 1.5]])
    stacked = StackedTrajectory()
    stacked.Append(hold)
    robot = Robot("r", [TreeJoint("j", "revolute", "world", "a")])
    for trajectory in (hold, stacked):
        found = {p.name: p for p in robot.along(trajectory, order=2).peaks(limits={"j": {"acceleration": 1}})}
        assert found["velocity"].value == pytest.approx(1 / 0.3, rel=1e-9)
        assert found["acceleration"].value == np.inf and found["acceleration"].within is False
        assert "velocity jumps at 1 time (0.3 s)" in str(found["acceleration"])
