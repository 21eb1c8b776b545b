"""The structure of a robot: bodies on a tree of joints, its coordinates, and the mimic joints."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy import inf, ndarray
from numpy.typing import ArrayLike

from workbench.kinematics.chain import SerialChain
from workbench.kinematics.chain_joints import Joint
from workbench.kinematics.one_state import require_order
from workbench.kinematics.robot.balls import (
    angular_velocity_of_quaternion,
    angular_velocity_of_rpy,
    unit_quaternion,
)
from workbench.kinematics.robot.joints import ANGLES, Limits, Move, TreeJoint
from workbench.kinematics.trees.tree_engine import TreeEngine
from workbench.kinematics.trees.tree_steps import HIGHEST_DERIVATIVE_ORDER, WORLD, Drive, Frame, Step

LARGE = 500_000  # doubles, which are more than a core's caches hold
DOUBLE = np.dtype(np.float64)
MOST_ROWS = 21  # of one state's derivatives: more are a table of states by mistake


@dataclass(frozen=True)
class Body:
    """A body's frame: `after` is the step whose motion it follows, X_MB (4, 4) its constant pose there."""

    name: str
    after: int
    X_MB: np.ndarray


class _Move(NamedTuple):
    """One motion of a joint, and where the coordinate, velocity and input channel that drive it are: its
    value is factor · (that coordinate) + offset."""

    move: Move
    position: int
    velocity: int
    channel: int
    factor: float = 1.0
    offset: float = 0.0

    def step(self, parent: int, before: np.ndarray) -> Step:
        """Returns the step of the kernel, after `parent`."""
        joint = self.move.joint
        turn = Drive(self.channel, self.velocity, self.factor, self.offset)
        if isinstance(joint, str):
            return Step(parent, before, None, turn)
        if joint.kind == "prismatic":
            return Step(parent, before, joint, None, turn)
        slide = None
        if joint.kind == "helical":
            slide = turn._replace(factor=self.factor * joint.pitch, offset=self.offset * joint.pitch)
        return Step(parent, before, joint, turn, slide)


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
        self._name_coordinates()
        self._follow_mimics()
        self._place_bodies()

    def _name_coordinates(self) -> None:
        free = [joint for joint in self.joints if joint.mimic is None]
        self.positions = tuple(name for joint in free for name in joint.coordinates)
        self.velocities = tuple(name for joint in free for name in joint.velocities)
        self._all_positions = tuple(name for joint in self.joints for name in joint.coordinates)
        self._quaternions = [i for i, name in enumerate(self.positions) if name.endswith("_qw")]
        self._states: dict[int | None, set[tuple[int, ...]]] = {}  # by the told order: shapes found right
        self._moves: dict[str, tuple[_Move, ...]] = {}
        position = velocity = channel = 0
        for joint in free:
            own = []
            for move in joint.moves():
                own.append(_Move(move, position + move.position, velocity + move.velocity, channel))
                channel += 4 if isinstance(move.joint, str) else 1
            position, velocity = position + len(joint.coordinates), velocity + len(joint.velocities)
            self._moves[joint.name] = tuple(own)
        self._channels = channel
        self._plain = not any(
            isinstance(m.move.joint, str) for own in self._moves.values() for m in own
        )  # velocities are the rates of the coordinates, and these the kernel's channels

    def _follow_mimics(self) -> None:
        """Sets M and c of `follow`: all coordinates as functions of the free ones."""
        by_name = {joint.name: joint for joint in self.joints}
        self._of_positions = np.zeros((len(self._all_positions), len(self.positions)))
        self._offset = np.zeros(len(self._all_positions))
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
                self._of_positions[row, self.positions.index(theirs)], self._offset[row] = factor, constant
            if joint.mimic is not None:
                (source_move,), (move,) = self._moves[source.name], joint.moves()
                self._moves[joint.name] = (source_move._replace(move=move, factor=factor, offset=constant),)

    def _place_bodies(self) -> None:
        waiting: dict[str, list[TreeJoint]] = {}
        for joint in self.joints:
            waiting.setdefault(joint.parent, []).append(joint)
        bodies = {self.world: Body(self.world, WORLD, np.eye(4))}
        steps: list[Step] = []
        self._own_positions: list[int | None] = []  # of each step; None of a joint that mimics
        queue = deque([self.world])
        while queue:
            parent = bodies[queue.popleft()]
            for joint in waiting.get(parent.name, []):
                if joint.child in bodies:
                    raise ValueError(f"body {joint.child!r}: more than one joint leads to it, expected one")
                after, X = parent.after, parent.X_MB @ joint.X_PF
                for move in self._moves[joint.name]:
                    steps.append(move.step(after, X))
                    self._own_positions.append(None if joint.mimic else move.position)
                    after, X = len(steps) - 1, np.eye(4)
                bodies[joint.child] = Body(joint.child, after, X @ joint.X_MC)
                queue.append(joint.child)
        for joint in self.joints:
            if joint.child not in bodies:
                raise ValueError(f"body {joint.child!r}: no joint connects it with {self.world!r}")
        self.steps = tuple(steps)
        self.frames = bodies
        self.bodies = tuple(name for name in bodies if name != self.world)
        frames = {name: Frame(body.after, body.X_MB) for name, body in bodies.items()}
        self.engine = TreeEngine(steps, frames, self._channels, len(self.velocities))

    @cached_property
    def limits(self) -> Mapping[str, Limits]:
        """The limits of each joint of one coordinate, those that follow another joint among them; NaN where
        there is none."""
        return MappingProxyType(
            {joint.name: joint.limits for joint in self.joints if joint.coordinates == (joint.name,)}
        )

    @cached_property
    def units(self) -> Mapping[str, str]:
        """The unit of each coordinate and of what each velocity is the rate of: rad, m, or 1."""
        return MappingProxyType(
            {name: j.unit(name) for j in self.joints for name in (*j.coordinates, *j.velocities)}
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

    @cached_property
    def near_origin(self) -> Structure:
        """The same tree, moved so that its first joint is at the world's origin: there the relative motion of
        two bodies loses no digits to an offset of both."""
        first = self.steps[0].before[:3, 3] if self.steps else np.zeros(3)
        moved = np.eye(4)
        moved[:3, 3] = -first
        return Structure(
            self.name,
            [replace(j, X_PF=moved @ j.X_PF) if j.parent == self.world else j for j in self.joints],
            self.world,
        )

    @cached_property
    def armatures(self) -> np.ndarray:
        """What the rotors add to the inertia of each velocity, (velocities,) in kg m² or kg; those of joints
        that follow others with the square of their factors."""
        found = np.zeros(len(self.velocities))
        for joint in self.joints:
            for own in self._moves[joint.name]:
                of_move = slice(own.velocity, own.velocity + own.move.sizes[1])
                found[of_move] += joint.armature * own.factor**2
        found.setflags(write=False)
        return found

    @property
    def default_positions(self) -> np.ndarray:
        """All coordinates 0, quaternions (1, 0, 0, 0)."""
        return np.array([1.0 if name.endswith("_qw") else 0.0 for name in self.positions])

    def body(self, name: str) -> Body:
        """Returns the body of that name; where several models share it, it is to be asked as model::body."""
        if name in self.frames:
            return self.frames[name]
        same = [full for full in self.frames if full.endswith(f"::{name}")]
        if len(same) == 1:
            return self.frames[same[0]]
        if same:
            raise ValueError(f"more than one body {name!r}: expected one of {', '.join(same)}")
        raise ValueError(f"no body {name!r}: expected one of {', '.join(self.frames)}")

    def chain(self, body: str) -> tuple[SerialChain, list[int]] | None:
        """Returns the serial chain from the world to a body and its coordinates among the robot's.

        None where no moving joint, a ball or a mimic joint is on the way.
        """
        frame = self.body(body)
        joints, coordinates, at = [Joint.fixed(frame.X_MB)], [], frame.after
        while at != WORLD:
            step, position = self.steps[at], self._own_positions[at]
            if step.joint is None or position is None:
                return None
            joints += [step.joint, Joint.fixed(step.before)]
            coordinates.append(position)
            at = step.parent
        return (SerialChain(reversed(joints)), coordinates[::-1]) if coordinates else None

    def require_rates(self, what: str) -> None:
        """Raise ValueError unless the velocities are the rates of the coordinates."""
        if not self._plain:
            raise ValueError(
                f"{what}: expected a robot without ball or floating joints, whose velocities are the rates "
                f"of its coordinates; {self.name!r} has such joints"
            )

    def derivatives(self, q_derivatives: ArrayLike, order: int | None = None) -> np.ndarray:
        """Returns a copy of q_derivatives (N + 1, ..., positions), checked; order: N, where it is told."""
        if type(q_derivatives) is ndarray and q_derivatives.dtype is DOUBLE:
            numbers = q_derivatives.ravel()
            known = self._states.get(order)
            if known and q_derivatives.shape in known and numbers.dot(numbers) < inf:  # a state as before
                return q_derivatives.copy()
        q = finite_copy_of(q_derivatives)
        if q is None:
            q = reals(q_derivatives, "q_derivatives").copy("K")
        count = len(self.positions)
        if q.ndim < 2 or q.shape[-1] != count or len(q) < 2:
            raise ValueError(
                f"q_derivatives: expected shape (N + 1, ..., {count}) with N >= 1, the order first and the "
                f"{count} coordinates last, got {q.shape}"
            )
        table = "`along((t, q))` or with shape (N + 1, states, positions)"
        require_order(q, order, table, MOST_ROWS, calls=2)
        self.check(q[0], len(q) - 1)
        if q.ndim == 2 and not self._quaternions:
            self._states.setdefault(order, set()).add(q.shape)
        return q

    def state(self, q: ArrayLike, v_derivatives: ArrayLike) -> tuple[np.ndarray, np.ndarray | None]:
        """Copies of q (..., positions) and v_derivatives (N, ..., velocities), checked; as q_derivatives
        where that is the same."""
        q, v = reals(q, "q"), reals(v_derivatives, "v_derivatives")
        nq, nv = len(self.positions), len(self.velocities)
        if q.ndim < 1 or q.shape[-1] != nq:
            raise ValueError(f"q: expected shape (..., {nq}), the coordinates last, got {q.shape}")
        if v.ndim < 2 or v.shape[-1] != nv or v.shape[1:-1] != q.shape[:-1] or len(v) < 1:
            expected = ", ".join(map(str, ("N", *q.shape[:-1], nv)))
            raise ValueError(f"v_derivatives: expected shape ({expected}), the order first, got {v.shape}")
        self.check(q, len(v))
        return (np.concatenate([q[None], v]), None) if self._plain else (q.copy(), v.copy())

    def check(self, q: np.ndarray, order: int) -> None:
        if order > HIGHEST_DERIVATIVE_ORDER:
            raise ValueError(f"expected derivatives to order at most {HIGHEST_DERIVATIVE_ORDER}, got {order}")
        for start in self._quaternions:
            if not ((q[..., start : start + 4] ** 2).sum(axis=-1) > 0).all():
                name = self.positions[start].removesuffix("_qw")
                raise ValueError(f"joint {name!r}: expected a quaternion (w, x, y, z), got one of length 0")

    def velocity_derivatives(self, q_derivatives: np.ndarray) -> np.ndarray:
        """Returns the velocities and their derivatives (N, ..., velocities) of q_derivatives (N + 1, ...,
        positions)."""
        if self._plain:
            return q_derivatives[1:]
        v = np.zeros((len(q_derivatives) - 1, *q_derivatives.shape[1:-1], len(self.velocities)))
        for own in self._free_moves():
            positions, velocities = own.move.sizes
            q = q_derivatives[..., own.position : own.position + positions]
            v[..., own.velocity : own.velocity + velocities] = _RATES.get(own.move.ball, _rate)(q)
        return v

    def channels(self, q: np.ndarray, rates: np.ndarray) -> np.ndarray:
        """Returns the kernel's input (N + 1, ..., channels) of q (..., positions) and rates (N, ...,
        velocities)."""
        inputs = np.zeros((len(rates) + 1, *q.shape[:-1], self._channels))
        for own in self._free_moves():
            positions, velocities = own.move.sizes
            of_q = q[..., own.position : own.position + positions]
            of_v = rates[..., own.velocity : own.velocity + velocities]
            ball = own.move.ball
            inputs[0, ..., own.channel : own.channel + (4 if ball else 1)] = (
                unit_quaternion(ball, of_q) if ball else of_q
            )
            first = own.channel + (1 if ball else 0)
            inputs[1:, ..., first : first + velocities] = of_v
        return inputs

    def _free_moves(self) -> list[_Move]:
        return [move for j in self.joints if j.mimic is None for move in self._moves[j.name]]

    def follow(self, names: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
        """Returns M (names, positions) and c (names,) with M q + c the coordinates of those names, mimic
        joints' among them."""
        unknown = [name for name in names if name not in self._all_positions]
        if unknown:
            raise ValueError(
                f"no coordinate {unknown[0]!r}: expected one of {', '.join(self._all_positions)}"
            )
        rows = [self._all_positions.index(name) for name in names]
        return self._of_positions[rows], self._offset[rows]

    def __repr__(self) -> str:
        return f"Robot({self.name!r}: {len(self.bodies)} bodies, {len(self.positions)} coordinates)"

    def __dir__(self) -> list[str]:
        return [name for name in super().__dir__() if not name.startswith("_")]


def finite_copy_of(values: ArrayLike) -> np.ndarray | None:
    """Returns a copy of a large contiguous array of finite doubles; None of everything else."""
    large = isinstance(values, ndarray) and values.dtype is DOUBLE and values.size >= LARGE
    if not large or type(values) is not ndarray or not values.flags.c_contiguous:
        return None
    from workbench.kinematics.trees.tree_memory import finite_copy

    return finite_copy(values)


def _rate(q: np.ndarray) -> np.ndarray:
    return q[1:]


_RATES = {"quaternion": angular_velocity_of_quaternion, "rpy": angular_velocity_of_rpy}


def is_whole(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def whole(value: Any, what: str, lowest: int, highest: int | None = None) -> int:
    """Returns the value, or a ValueError unless it is an integer from `lowest` to `highest`."""
    if not is_whole(value) or not lowest <= value <= (value if highest is None else highest):
        wanted = f">= {lowest}" if highest is None else f"from {lowest} to {highest}"
        raise ValueError(f"{what}: expected an integer {wanted}, got {value!r}")
    return int(value)


def reals(values: ArrayLike, what: str) -> np.ndarray:
    """Returns the values as an array of doubles; ValueError for what is not real, not finite, or masked."""
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
    if not (np.add.reduce(array, axis=None) < np.inf or np.isfinite(array).all()):
        raise ValueError(f"{what}: expected finite numbers, got a NaN or an infinity")
    return array
