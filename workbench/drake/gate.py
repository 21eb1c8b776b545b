"""The only module that imports Drake, with one table of the names used.

Each name is imported at its first use, since all of Drake's multibody takes a second to load.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

HOMES = {
    "pydrake.autodiffutils": ("AutoDiffXd", "ExtractGradient", "ExtractValue"),
    "pydrake.common.eigen_geometry": ("AngleAxis_",),
    "pydrake.geometry": ("Cylinder", "MeshcatAnimation", "Rgba", "Sphere"),
    "pydrake.math": (
        "RigidTransform",
        "RigidTransform_",
        "RollPitchYaw_",
        "RotationMatrix",
        "RotationMatrix_",
    ),
    "pydrake.multibody.math": ("SpatialAcceleration", "SpatialVelocity", "SpatialVelocity_"),
    "pydrake.multibody.parsing": ("Parser",),
    "pydrake.multibody.plant": ("MultibodyPlant",),
    "pydrake.multibody.tree": (
        "BodyIndex",
        "FixedOffsetFrame",
        "JacobianWrtVariable",
        "Joint",
        "PrismaticJoint",
        "RevoluteJoint",
        "RigidBody",
        "RpyFloatingJoint",
        "SpatialInertia",
        "SpatialInertia_",
        "UnitInertia_",
    ),
    "pydrake.symbolic": ("Expression", "Polynomial", "Variable"),
    "pydrake.systems.framework": ("Context",),
}

_HOME = {name: home for home, names in HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"{name} is not among the names that the workbench uses of Drake")
    value = getattr(import_module(_HOME[name]), name)
    globals()[name] = value
    return value
