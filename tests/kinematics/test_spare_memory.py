"""Memory of large arrays is used again, and never that of an array which is still held."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

from workbench.kinematics import spare_memory as room
from workbench.kinematics.robot import Robot

ARM = Path(__file__).parents[2] / "notebooks" / "robots" / "panda.urdf"


@pytest.fixture(autouse=True)
def none_kept(monkeypatch):
    monkeypatch.setattr(room, "_kept", [])


def address(array):
    return array.__array_interface__["data"][0]


def test_memory_is_used_again_when_no_array_holds_it():
    first = address(room.spare_memory(room.LEAST))
    assert address(room.spare_memory(room.LEAST)) == first


@pytest.mark.parametrize("held", [lambda a: a, lambda a: a[5:9], lambda a: a.reshape(2, -1).T, memoryview])
def test_held_memory_is_not_used_again(held):
    kept = held(room.spare_memory(room.LEAST))
    other = room.spare_memory(room.LEAST)
    assert not np.shares_memory(np.asarray(kept), other)


def test_no_more_than_the_limit_is_kept():
    arrays = [room.spare_memory(room.MOST // 4) for _ in range(9)]
    assert sum(memory.size for memory in room._kept) <= room.MOST
    assert not any(np.shares_memory(a, b) for i, a in enumerate(arrays) for b in arrays[:i])
    assert room.spare_memory(room.MOST + 1).size == room.MOST + 1 and len(room._kept) == 4


def test_motions_that_are_held_keep_their_values():
    robot, rng = Robot.from_urdf(ARM), np.random.default_rng(1)
    inputs = [rng.normal(size=(3, 40_000, len(robot.positions))) for _ in range(3)]
    frame = list(robot.bodies)[-1]
    held = [robot.motion(q).frame(frame) for q in inputs]
    jacobians = [robot.motion(q).frame(frame).jacobian(1) for q in inputs]
    for q, found, jacobian in zip(inputs, held, jacobians, strict=True):
        np.testing.assert_array_equal(found.twists, robot.motion(q).frame(frame).twists)
        np.testing.assert_array_equal(jacobian, robot.motion(q).frame(frame).jacobian(1))
        np.testing.assert_array_equal(found.twists[0][7], robot.motion(q[:, 7].copy()).frame(frame).twists[0])


def test_threads_get_memory_of_their_own():
    wrong = []

    def fill(value):
        for _ in range(200):
            own = room.spare_memory(room.LEAST)
            own[:] = value
            if own.min() != value or own.max() != value:
                wrong.append(value)

    threads = [threading.Thread(target=fill, args=(float(n),)) for n in range(4)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert not wrong
