"""Higher-order kinematics: fields, screws, lines, and chains and trees of bodies, to any order.

What is this? Numerical kinematics in NumPy, with dual numbers and Taylor polynomials. `Robot` evaluates a
real robot; the other modules know no robot. When do I come here? To compute a motion, and not to judge a
formula. What may it import? algebra, drake. What checks it? tests/kinematics, against Drake.
"""

from importlib import import_module
from typing import Any

#: The public names and where each is defined; it is imported at its first use.
_PLACES = {
    "Dual": "workbench.algebra.dual",
    "P": "workbench.kinematics.operators",
    "acceleration": "workbench.kinematics.fields",
    "acceleration_centre": "workbench.kinematics.centres",
    "acceleration_tensors": "workbench.kinematics.fields",
    "invariant_vectors": "workbench.kinematics.fields",
    "three_axes": "workbench.kinematics.aronhold_kennedy",
}

__all__ = [
    "BallConstraint",
    "ClosedLoops",
    "Dual",
    "Mimic",
    "P",
    "Robot",
    "SingularJacobian",
    "TreeJoint",
    "UrdfError",
    "WeldConstraint",
    "acceleration",
    "acceleration_centre",
    "acceleration_tensors",
    "cylindrical_chains",
    "invariant_vectors",
    "slowed",
    "three_axes",
    "waypoints",
]


def __getattr__(name: str) -> Any:
    if name == "cylindrical_chains":
        return import_module("workbench.kinematics.cylindrical_chains")
    if name in __all__:
        return getattr(import_module(_PLACES.get(name, "workbench.kinematics.robot")), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
