"""Joints of a serial chain, and the frames in which its Taylor recursion is cheapest.

Between the axes of two neighbouring joints lie two frames, `leaving` on the inner axis and
`entering` on the outer one, both with z along their axis and sharing their x axis, which is
perpendicular to both axes. From the one to the other leads a rotation about x by the twist angle
and a shift (a, b, 0); from the entering to the leaving frame of one joint leads a constant dual
angle about z (Denavit and Hartenberg's joint angle and offset). Where two axes are nearly parallel
their common normal may lie far away; there b ≠ 0 replaces it, so that no length gets large.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

IDENTITY = np.eye(3)
KINDS = ("revolute", "prismatic", "cylindrical", "helical", "fixed")
NEARLY_PARALLEL = 0.1  # below this sine the foot of the common normal is not used


@dataclass(frozen=True, eq=False)
class Joint:
    """One joint; make it by `revolute`, `prismatic`, `cylindrical`, `helical` or `fixed`.

    Axis and point are given at q = 0 in the frame that the fixed joints before it have reached
    (the base frame, if there are none): so a list of axes in base coordinates is a chain
    (product of exponentials), and so is an alternation of fixed and moving joints (as in a URDF).
    """

    kind: str
    axis: np.ndarray
    point: np.ndarray
    pitch: float
    transform: np.ndarray

    def __post_init__(self):
        if self.kind not in KINDS:
            raise ValueError(f"joint: expected one of {', '.join(KINDS)}, got {self.kind!r}")
        is_fixed = self.kind == "fixed"
        axis = np.zeros(3) if is_fixed else _direction(self.axis, f"{self.kind} joint: axis")
        pitch = float(self.pitch)
        if not np.isfinite(pitch):
            raise ValueError(f"{self.kind} joint: expected a finite pitch, got {self.pitch}")
        object.__setattr__(self, "axis", axis)
        object.__setattr__(self, "point", _vector3(self.point, f"{self.kind} joint: point"))
        object.__setattr__(self, "pitch", pitch)
        transform = rigid_matrix(self.transform, "fixed joint") if is_fixed else np.eye(4)
        object.__setattr__(self, "transform", transform)

    @staticmethod
    def revolute(axis: ArrayLike, point: ArrayLike = (0, 0, 0)) -> "Joint":
        """Rotation about the line through `point` (m) along `axis` (any length but zero)."""
        return _moving("revolute", axis, point)

    @staticmethod
    def prismatic(axis: ArrayLike) -> "Joint":
        """Translation along `axis`, in metres whatever the length of `axis`."""
        return _moving("prismatic", axis, (0, 0, 0))

    @staticmethod
    def cylindrical(axis: ArrayLike, point: ArrayLike = (0, 0, 0)) -> "Joint":
        """Rotation about and translation along one line: two coordinates, angle then slide."""
        return _moving("cylindrical", axis, point)

    @staticmethod
    def helical(axis: ArrayLike, point: ArrayLike = (0, 0, 0), *, pitch: float) -> "Joint":
        """Rotation about a line with a translation along it of `pitch` metres per radian."""
        return _moving("helical", axis, point, pitch)

    @staticmethod
    def fixed(transform: ArrayLike) -> "Joint":
        """A constant rigid transform (4, 4): what follows is given in the frame it reaches."""
        return Joint("fixed", np.zeros(3), np.zeros(3), 0.0, transform)

    @cached_property
    def skew(self) -> np.ndarray:
        return np.cross(IDENTITY, self.axis)

    @cached_property
    def skew_square(self) -> np.ndarray:
        return self.skew @ self.skew

    @property
    def dof(self) -> int:
        return {"fixed": 0, "cylindrical": 2}.get(self.kind, 1)


def _moving(kind: str, axis: ArrayLike, point: ArrayLike, pitch: float = 0.0) -> Joint:
    return Joint(kind, axis, point, pitch, np.eye(4))


def rigid_matrix(transform: ArrayLike, what: str) -> np.ndarray:
    """The transform as a (4, 4) matrix of doubles; ValueError unless it is rigid within 1e-9."""
    matrix = np.array(transform, dtype=float)
    if matrix.shape != (4, 4):
        raise ValueError(f"{what}: expected a (4, 4) transform, got shape {matrix.shape}")
    R = matrix[:3, :3]
    is_affine = np.isfinite(matrix).all() and (matrix[3] == (0, 0, 0, 1)).all()
    if not (is_affine and np.allclose(R @ R.T, np.eye(3), rtol=0, atol=1e-9) and np.linalg.det(R) > 0):
        raise ValueError(f"{what}: expected a rigid transform, got {matrix.tolist()}")
    return matrix


def _direction(axis: ArrayLike, what: str) -> np.ndarray:
    """axis / ‖axis‖, also where the squares of its components overflow or underflow."""
    vector = _vector3(axis, what)
    largest = np.abs(vector).max()
    if largest == 0:
        raise ValueError(f"{what}: expected non-zero length, got {axis}")
    vector = vector / largest
    return vector / np.linalg.norm(vector)


def _vector3(values: ArrayLike, what: str) -> np.ndarray:
    vector = np.array(values, dtype=float)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{what}: expected three finite numbers, got {values}")
    return vector


def motion(joint: Joint, q: np.ndarray) -> np.ndarray:
    """The joint's rigid motion (..., 4, 4) at its coordinates q (..., joint.dof)."""
    if joint.kind == "fixed":
        return np.broadcast_to(joint.transform, (*q.shape[:-1], 4, 4))
    zero = np.zeros(q.shape[:-1])
    angle = zero if joint.kind == "prismatic" else q[..., 0]
    slide = {
        "revolute": zero,
        "prismatic": q[..., 0],
        "cylindrical": q[..., -1],
        "helical": joint.pitch * q[..., 0],
    }[joint.kind]
    sine, versine = np.sin(angle)[..., None, None], 2 * np.sin(angle / 2)[..., None, None] ** 2
    X = np.zeros((*q.shape[:-1], 4, 4))
    X[..., :3, :3] = IDENTITY + sine * joint.skew + versine * joint.skew_square
    X[..., :3, 3] = slide[..., None] * joint.axis + joint.point - X[..., :3, :3] @ joint.point
    X[..., 3, 3] = 1
    return X


class Links(NamedTuple):
    """What the recursion needs, one row a moving joint, from base to tip.

    `angle` and `slide` are the coordinate of the joint's rotation and translation (−1: it has
    none), the translation being `pitch` times its coordinate. `twist_angle` is (cos, sin) and
    `shift` is (a, b) of the step from the leaving frame before to the entering frame of the joint.
    `turn` is (cos, sin) of the constant angle and `offset` the constant length from an entering to
    a leaving frame, one row more than the others: row 0 belongs to the base, whose z axis stands
    for a joint that never moves, row i to the i-th moving joint.
    """

    angle: np.ndarray
    slide: np.ndarray
    pitch: np.ndarray
    twist_angle: np.ndarray
    shift: np.ndarray
    turn: np.ndarray
    offset: np.ndarray
    home: np.ndarray
    dof: int


def links_of(joints: Sequence[Joint]) -> Links:
    """Merge the fixed joints and choose the frames of the moving ones."""
    home = np.eye(4)
    axes, points, angles, slides, pitches = [], [], [], [], []
    dof = 0
    for joint in joints:
        if joint.kind == "fixed":
            home = home @ joint.transform
            continue
        axes.append(home[:3, :3] @ joint.axis)
        points.append(home[:3, :3] @ joint.point + home[:3, 3])
        angles.append(-1 if joint.kind == "prismatic" else dof)
        slides.append({"revolute": -1, "cylindrical": dof + 1}.get(joint.kind, dof))
        pitches.append(joint.pitch if joint.kind == "helical" else 1.0)
        dof += joint.dof
    count = len(axes)
    twist_angle, shift = np.empty((count, 2)), np.empty((count, 2))
    turn, offset = np.tile((1.0, 0.0), (count + 1, 1)), np.zeros(count + 1)
    x, z, origin = np.array([1.0, 0, 0]), np.array([0, 0, 1.0]), np.zeros(3)
    for i, (next_z, point) in enumerate(zip(axes, points, strict=True)):
        next_x, next_origin, foot = _common_normal(z, origin, next_z, point)
        turn[i] = _unit2(next_x @ x, next_x @ np.cross(z, x))
        offset[i] = (foot - origin) @ z
        twist_angle[i] = _unit2(z @ next_z, np.cross(z, next_z) @ next_x)
        shift[i] = (next_origin - foot) @ next_x, (next_origin - foot) @ np.cross(z, next_x)
        x, z, origin = next_x - next_z * (next_x @ next_z), next_z, next_origin
        x = x / np.linalg.norm(x)
    return Links(
        np.array(angles, dtype=np.int64),
        np.array(slides, dtype=np.int64),
        np.array(pitches, dtype=float),
        twist_angle,
        shift,
        turn,
        offset,
        home,
        dof,
    )


def _common_normal(
    z: np.ndarray, origin: np.ndarray, next_z: np.ndarray, next_point: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The shared x axis, the origin of the entering frame on the next axis, and on this axis the
    origin of the leaving frame: the foot of the perpendicular from there."""
    across = np.cross(z, next_z)
    sine = np.linalg.norm(across)
    between = next_point - origin
    if sine > NEARLY_PARALLEL:
        x = across / sine
        next_origin = next_point + next_z * (np.cross(z, x) @ between / sine)
    else:
        next_origin = next_point - next_z * (next_z @ between)
        sideways = next_origin - origin
        sideways = sideways - z * (z @ sideways)
        distance = np.linalg.norm(sideways)
        if sine > 1e-14:
            x = across / sine
        elif distance > 0:
            x = sideways / distance
        else:
            x = _perpendicular(z)
    x = x - z * (z @ x)
    return x / np.linalg.norm(x), next_origin, origin + z * (z @ (next_origin - origin))


def _perpendicular(z: np.ndarray) -> np.ndarray:
    x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
    return x / np.linalg.norm(x)


def _unit2(cosine: float, sine: float) -> tuple[float, float]:
    length = np.hypot(cosine, sine)
    return cosine / length, sine / length
