"""Higher-order kinematics: fields, screws, lines, and chains and trees of bodies, to any order.

What is this? Numerical kinematics in NumPy, with dual numbers and Taylor polynomials. `Robot` evaluates a
real robot; the other modules know no robot. When do I come here? To compute a motion, and not to judge a
formula. What may it import? algebra, drake. What checks it? tests/kinematics, against Drake.
"""

from typing import Any

__all__ = [
    "BallConstraint",
    "ClosedLoops",
    "Mimic",
    "Robot",
    "SingularJacobian",
    "TreeJoint",
    "UrdfError",
    "WeldConstraint",
    "slowed",
    "waypoints",
]


def __getattr__(name: str) -> Any:
    if name in __all__:  # imported at first use: the other modules do not need it
        from workbench.kinematics import robot

        return getattr(robot, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
