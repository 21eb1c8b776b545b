"""The joints of a serial chain."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

KINDS = ("revolute", "prismatic", "cylindrical", "helical", "fixed")


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

    def __post_init__(self) -> None:
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
        """Returns a rotation about the line through `point` (m) along `axis` (any length but zero)."""
        return _moving("revolute", axis, point)

    @staticmethod
    def prismatic(axis: ArrayLike) -> "Joint":
        """Returns a translation along `axis`, in metres, independent of the length of `axis`."""
        return _moving("prismatic", axis, (0, 0, 0))

    @staticmethod
    def cylindrical(axis: ArrayLike, point: ArrayLike = (0, 0, 0)) -> "Joint":
        """Returns a rotation about and translation along one line: two coordinates, angle then slide."""
        return _moving("cylindrical", axis, point)

    @staticmethod
    def helical(axis: ArrayLike, point: ArrayLike = (0, 0, 0), *, pitch: float) -> "Joint":
        """Returns a rotation about a line with a translation along it of `pitch` metres per radian."""
        return _moving("helical", axis, point, pitch)

    @staticmethod
    def fixed(transform: ArrayLike) -> "Joint":
        """Returns a constant rigid transform (4, 4): what follows is given in the frame it reaches."""
        return Joint("fixed", np.zeros(3), np.zeros(3), 0.0, np.asarray(transform))

    @property
    def dof(self) -> int:
        return {"fixed": 0, "cylindrical": 2}.get(self.kind, 1)


def _moving(kind: str, axis: ArrayLike, point: ArrayLike, pitch: float = 0.0) -> Joint:
    return Joint(kind, np.asarray(axis), np.asarray(point), pitch, np.eye(4))


def rigid_matrix(transform: ArrayLike, what: str) -> np.ndarray:
    """Returns the transform as a (4, 4) matrix of doubles; ValueError unless it is rigid within 1e-9."""
    matrix = np.array(transform, dtype=float)
    if matrix.shape != (4, 4):
        raise ValueError(f"{what}: expected a (4, 4) transform, got shape {matrix.shape}")
    R = matrix[:3, :3]
    is_affine = np.isfinite(matrix).all() and (matrix[3] == (0, 0, 0, 1)).all()
    if not (is_affine and np.allclose(R @ R.T, np.eye(3), rtol=0, atol=1e-9) and np.linalg.det(R) > 0):
        raise ValueError(f"{what}: expected a rigid transform, got {matrix.tolist()}")
    return matrix


def _direction(axis: ArrayLike, what: str) -> np.ndarray:
    """Returns axis / ‖axis‖, also where the squares of its components overflow or underflow."""
    vector = _vector3(axis, what)
    largest = np.abs(vector).max()
    if largest == 0:
        raise ValueError(f"{what}: expected non-zero length, got {axis!s}")
    vector = vector / largest
    return vector / np.linalg.norm(vector)


def _vector3(values: ArrayLike, what: str) -> np.ndarray:
    vector = np.array(values, dtype=float)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ValueError(f"{what}: expected three finite numbers, got {values!s}")
    return vector
