"""What a robot is made of: bodies on a tree of joints, its coordinates, and how joints that mimic follow."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.chain import SerialChain
from workbench.kinematics.chain_engine import HIGHEST_DERIVATIVE_ORDER
from workbench.kinematics.chain_geometry import Joint
from workbench.kinematics.robot.joints import ANGLES, Limits, TreeJoint
from workbench.kinematics.robot.tree import (
    WORLD,
    Step,
    angular_velocity_of_quaternion,
    angular_velocity_of_rpy,
)

DOUBLE = np.dtype(np.float64)


@dataclass(frozen=True)
class Body:
    """A body's frame: `after` is the step whose motion it follows, X_MB (4, 4) its constant pose there."""

    name: str
    after: int
    X_MB: np.ndarray


class Structure:
    """The bodies, joints, coordinates and velocities of a `Robot`, named, and what follows from them
    alone."""

    def __init__(self, name: str, joints: Sequence[TreeJoint], world: str = "world"):
        """joints: in any order; those whose parent is `world` are the bases. Raises ValueError."""
        self.name = name
        self.joints = tuple(joints)
        self.world = world
        names = Counter(
            name for joint in self.joints for name in {joint.name, *joint.coordinates, *joint.velocities}
        )
        for name, count in names.items():
            if count > 1:
                raise ValueError(f"joint {name!r} is there twice: expected one of each name")
        self._place_bodies()
        self._follow_mimics()

    def _place_bodies(self) -> None:
        waiting: dict[str, list[TreeJoint]] = {}
        for joint in self.joints:
            waiting.setdefault(joint.parent, []).append(joint)
        slices, positions, velocities = {}, [], []
        for joint in self.joints:
            slices[joint.name] = len(positions), len(velocities)
            positions += joint.coordinates
            velocities += joint.velocities
        bodies = {self.world: Body(self.world, WORLD, np.eye(4))}
        steps: list[Step] = []
        queue = [self.world]
        while queue:
            parent = bodies[queue.pop(0)]
            for joint in waiting.get(parent.name, []):
                if joint.child in bodies:
                    raise ValueError(f"body {joint.child!r}: more than one joint leads to it, expected one")
                after, X = parent.after, parent.X_MB @ joint.X_PF
                q, v = slices[joint.name]
                for move in joint.moves():
                    own = (slice(q + move.position, q + move.position + move.sizes[0]),)
                    own += (slice(v + move.velocity, v + move.velocity + move.sizes[1]),)
                    steps.append(Step(after, X, move.joint, *own))
                    after, X = len(steps) - 1, np.eye(4)
                bodies[joint.child] = Body(joint.child, after, X @ joint.X_MC)
                queue.append(joint.child)
        for joint in self.joints:
            if joint.child not in bodies:
                raise ValueError(f"body {joint.child!r}: no joint connects it with {self.world!r}")
        self.steps = tuple(steps)
        self.frames = bodies
        self._chains: dict[str, tuple[SerialChain, Any] | None] = {}
        self._states: set[tuple[int, ...]] = set()  # shapes of q_derivatives that were found right
        self.bodies = tuple(name for name in bodies if name != self.world)
        self._all_positions, self._all_velocities = tuple(positions), tuple(velocities)

    def _follow_mimics(self) -> None:
        by_name = {joint.name: joint for joint in self.joints}
        free = [joint for joint in self.joints if joint.mimic is None]
        self.positions = tuple(name for joint in free for name in joint.coordinates)
        self.velocities = tuple(name for joint in free for name in joint.velocities)
        self._has_mimics = len(free) < len(self.joints)
        self._quaternions = [i for i, name in enumerate(self.positions) if name.endswith("_qw")]
        self._plain = len(self.positions) == len(self.velocities) and not any(
            isinstance(step.joint, str) for step in self.steps
        )  # velocities are the rates of the coordinates
        of_positions = np.zeros((len(self._all_positions), len(self.positions)))
        of_velocities = np.zeros((len(self._all_velocities), len(self.velocities)))
        offset = np.zeros(len(self._all_positions))
        for joint in self.joints:
            factor, constant, source = 1.0, 0.0, joint
            followed = [joint.name]
            while source.mimic is not None:
                mimic = source.mimic
                if mimic.source not in by_name:
                    raise ValueError(f"joint {source.name!r} mimics {mimic.source!r}, which does not exist")
                constant += factor * mimic.offset
                factor *= mimic.multiplier
                source = by_name[mimic.source]
                if source.name in followed:
                    raise ValueError(f"joints {', '.join(followed)} mimic one another in a circle")
                followed.append(source.name)
            if joint.mimic is not None and len(source.coordinates) != 1:
                raise ValueError(
                    f"joint {joint.name!r} mimics {source.name!r}, "
                    f"a {source.kind} joint without one coordinate"
                )
            for ours, theirs in zip(joint.coordinates, source.coordinates, strict=True):
                row = self._all_positions.index(ours)
                of_positions[row, self.positions.index(theirs)], offset[row] = factor, constant
            for ours, theirs in zip(joint.velocities, source.velocities, strict=True):
                row = self._all_velocities.index(ours)
                of_velocities[row, self.velocities.index(theirs)] = factor
        self._of_positions, self._of_velocities, self._offset = of_positions, of_velocities, offset

    @cached_property
    def limits(self) -> Mapping[str, Limits]:
        """The limits of each joint of one coordinate, those that follow another joint among them; NaN where
        there is none."""
        return MappingProxyType(
            {joint.name: joint.limits for joint in self.joints if joint.coordinates == (joint.name,)}
        )

    @cached_property
    def unlimited_angles(self) -> frozenset[str]:
        """The coordinates that are angles without limits, known modulo 2π; a pitch is none of them."""
        names = set()
        for joint in self.joints:
            if joint.kind == "revolute" and not np.isfinite([joint.limits.lower, joint.limits.upper]).any():
                names.add(joint.name)
            names |= {joint.name + suffix for suffix in ANGLES.get(joint.kind, ())}
        return frozenset(names.intersection(self.positions))

    @property
    def default_positions(self) -> np.ndarray:
        """All coordinates 0, quaternions (1, 0, 0, 0)."""
        return np.array([1.0 if name.endswith("_qw") else 0.0 for name in self.positions])

    def body(self, name: str) -> Body:
        """The body of that name; where several models share it, it is to be asked as model::body."""
        if name in self.frames:
            return self.frames[name]
        same = [full for full in self.frames if full.endswith(f"::{name}")]
        if len(same) == 1:
            return self.frames[same[0]]
        if same:
            raise ValueError(f"more than one body {name!r}: expected one of {', '.join(same)}")
        raise ValueError(f"no body {name!r}: expected one of {', '.join(self.frames)}")

    def chain(self, body: str) -> tuple[SerialChain, list[int]] | None:
        """The serial chain from the world to a body and its coordinates among the robot's.

        None where no moving joint, a ball or a mimic joint is on the way.
        """
        found = self._chain(self.body(body))
        return None if found is None else (found[0], np.arange(len(self.positions))[found[1]].tolist())

    def _chain(self, body: Body) -> tuple[SerialChain, Any] | None:
        """As `chain`, the coordinates as a slice where they stand in a row, as `...` where they are all."""
        try:
            return self._chains[body.name]
        except KeyError:
            found = self._chains[body.name] = self._new_chain(body)
            return found

    def _new_chain(self, body: Body) -> tuple[SerialChain, Any] | None:
        joints, names, at = [Joint.fixed(body.X_MB)], [], body.after
        while at != WORLD:
            step = self.steps[at]
            name = self._all_positions[step.positions.start]
            if isinstance(step.joint, str) or name not in self.positions:
                return None
            joints += [step.joint, Joint.fixed(step.before)]
            names.append(name)
            at = step.parent
        indices = [self.positions.index(name) for name in reversed(names)]
        if not indices:
            return None
        if indices == list(range(len(self.positions))):
            return SerialChain(reversed(joints)), ...
        in_a_row = indices == list(range(indices[0], indices[0] + len(indices)))
        return SerialChain(reversed(joints)), slice(indices[0], indices[-1] + 1) if in_a_row else indices

    def derivatives(self, q_derivatives: ArrayLike) -> np.ndarray:
        """q_derivatives (N + 1, ..., positions), checked."""
        q = reals(q_derivatives, "q_derivatives")
        if q.shape in self._states:
            return q
        count = len(self.positions)
        if q.ndim < 2 or q.shape[-1] != count or len(q) < 2:
            raise ValueError(
                f"q_derivatives: expected shape (N + 1, ..., {count}) with N >= 1, the order first and the "
                f"{count} coordinates last, got {q.shape}"
            )
        self.check(q[0], len(q) - 1)
        if q.ndim == 2 and not self._quaternions:
            self._states.add(q.shape)
        return q

    def state(self, q: ArrayLike, v_derivatives: ArrayLike) -> tuple[np.ndarray, np.ndarray | None]:
        """q (..., positions) and v_derivatives (N, ..., velocities), checked; as q_derivatives where that
        is the same."""
        q, v = reals(q, "q"), reals(v_derivatives, "v_derivatives")
        nq, nv = len(self.positions), len(self.velocities)
        if q.ndim < 1 or q.shape[-1] != nq:
            raise ValueError(f"q: expected shape (..., {nq}), the coordinates last, got {q.shape}")
        if v.ndim < 2 or v.shape[-1] != nv or v.shape[1:-1] != q.shape[:-1] or len(v) < 1:
            expected = ", ".join(map(str, ("N", *q.shape[:-1], nv)))
            raise ValueError(f"v_derivatives: expected shape ({expected}), the order first, got {v.shape}")
        self.check(q, len(v))
        return (np.concatenate([q[None], v]), None) if self._plain else (q, v)

    def check(self, q: np.ndarray, order: int) -> None:
        if order > HIGHEST_DERIVATIVE_ORDER:
            raise ValueError(f"expected derivatives to order at most {HIGHEST_DERIVATIVE_ORDER}, got {order}")
        for start in self._quaternions:
            if not ((q[..., start : start + 4] ** 2).sum(axis=-1) > 0).all():
                name = self.positions[start].removesuffix("_qw")
                raise ValueError(f"joint {name!r}: expected a quaternion (w, x, y, z), got one of length 0")

    def velocity_derivatives(self, q_derivatives: np.ndarray) -> np.ndarray:
        """The velocities and their derivatives (N, ..., velocities) of q_derivatives (N + 1, ...,
        positions)."""
        if self._plain:
            return q_derivatives[1:]
        v = np.zeros((len(q_derivatives) - 1, *q_derivatives.shape[1:-1], len(self.velocities)))
        first_position = first_velocity = 0
        for joint in self.joints:
            if joint.mimic is not None:
                continue
            for move in joint.moves():
                own = q_derivatives[..., first_position + move.position :][..., : move.sizes[0]]
                rates = {"quaternion": angular_velocity_of_quaternion, "rpy": angular_velocity_of_rpy}
                rate = rates.get(move.joint, lambda own: own[1:]) if isinstance(move.joint, str) else None
                at = first_velocity + move.velocity
                v[..., at : at + move.sizes[1]] = own[1:] if rate is None else rate(own)
            first_position += len(joint.coordinates)
            first_velocity += len(joint.velocities)
        return v

    def follow(self, names: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
        """M (names, positions) and c (names,) with M q + c the coordinates of those names, mimic joints'
        among them."""
        unknown = [name for name in names if name not in self._all_positions]
        if unknown:
            raise ValueError(
                f"no coordinate {unknown[0]!r}: expected one of {', '.join(self._all_positions)}"
            )
        rows = [self._all_positions.index(name) for name in names]
        return self._of_positions[rows], self._offset[rows]

    def _of_all_joints(self, q: np.ndarray, rates: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Coordinates and velocities with those of the joints that mimic."""
        if not self._has_mimics:
            return q, rates
        return q @ self._of_positions.T + self._offset, rates @ self._of_velocities.T

    def _of_free_joints(self, columns: np.ndarray, moving: list[int]) -> np.ndarray:
        """Of the columns (k, all velocities, S, 6) those that move a body, joints that mimic added to their
        source."""
        return np.einsum("kvsa,vf->kfsa", columns[:, moving], self._of_velocities[moving])

    def __repr__(self) -> str:
        return f"Robot({self.name!r}: {len(self.bodies)} bodies, {len(self.positions)} coordinates)"

    def __dir__(self) -> list[str]:
        return [name for name in super().__dir__() if not name.startswith("_")]


def is_whole(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def whole(value: Any, what: str, lowest: int, highest: int | None = None) -> int:
    """The value, or a ValueError unless it is an integer from `lowest` to `highest`."""
    if not is_whole(value) or not lowest <= value <= (value if highest is None else highest):
        wanted = f">= {lowest}" if highest is None else f"from {lowest} to {highest}"
        raise ValueError(f"{what}: expected an integer {wanted}, got {value!r}")
    return int(value)


def reals(values: ArrayLike, what: str) -> np.ndarray:
    """The values as an array of doubles; ValueError for what is not real, not finite, or masked."""
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{what}: {error}") from None
    if array is not values and np.ma.is_masked(values):
        raise ValueError(f"{what}: expected no masked numbers, got some")
    if array.dtype is not DOUBLE:
        if array.dtype.kind not in "fiu":
            raise ValueError(f"{what}: expected real numbers, got an array of {array.dtype}")
        array = array.astype(float)
    numbers = array.ravel()
    if not (numbers.dot(numbers) < np.inf or np.isfinite(array).all()):
        raise ValueError(f"{what}: expected finite numbers, got a NaN or an infinity")
    return array
