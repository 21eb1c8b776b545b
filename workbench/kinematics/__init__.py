"""Higher-order kinematics. `Robot` moves a real robot; the other modules know no robot."""

from typing import Any

__all__ = ["Mimic", "Robot", "SingularJacobian", "TreeJoint", "UrdfError"]


def __getattr__(name: str) -> Any:
    if name in __all__:  # loaded when it is asked for: the other modules do without it
        from workbench.kinematics import robot

        return getattr(robot, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
